"""Changes of a robot's file: what is different in two descriptions, as splices of its text."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from functools import partial
from pathlib import Path
from typing import NamedTuple, TypeVar

from plastron_tui.diagnostics import Diagnostic, Span, codes
from plastron_tui.ros.robots.description import Description
from plastron_tui.ros.robots.materials import kept_apart, said_as_before
from plastron_tui.sources.splices import Splice, apply, line_number
from plastron_tui.sources.xml.document import Element, XmlDocument
from plastron_tui.sources.xml.edits import insert_last, set_attribute

from .comments import headings
from .equality import same, same_robot
from .habits import Habits
from .joint_edits import change_joint
from .link_edits import change_link, change_material
from .part_edits import PartEdits, RefusedError
from .reader import UrdfRead, read_urdf
from .robot_edits import KINDS, Part, additions, element_of, parts_of, place_of, removals
from .three_way import ConflictError, merged
from .values import is_computed, is_xacro

T = TypeVar("T")


class UrdfEdit(NamedTuple):
    """A robot's file after an edit, None where it is not made; diagnostics say why."""

    text: bytes | None
    diagnostics: tuple[Diagnostic, ...] = ()


def edited(
    text: bytes, before: Description, after: Description, path: Path | None = None
) -> UrdfEdit:
    """Change a robot's file by what is different in two descriptions.

    What is the same in both stays as it is written, byte by byte. The text that comes out is read
    again, and has to say exactly what was asked for.

    Args:
        text: what the file holds.
        before: what the difference starts from. Where the file says something else by now, only
            what is different in the two descriptions is changed in it.
        after: what it ends with. Numbers have as many digits as are written (`number`). Where a
            colour would change parts that are not changed, it gets a name of its own.
        path: the file, for diagnostics.
    """
    read = read_urdf(text, path)
    if read.document is None or read.description is None:
        return UrdfEdit(None, read.diagnostics)
    present = read.description
    try:
        wanted = after if same_robot(before, present) else merged(before, after, present)
        wanted = said_as_before(present, kept_apart(present, wanted))
        if same_robot(present, wanted):
            return UrdfEdit(text)
        told: list[Diagnostic] = []
        changed = _with_changes(text, read, wanted, path, told)
        again = read_urdf(changed, path)
        gone = _gone(again, wanted)
        if gone and again.document is not None:
            told += _left_above(read.document, _gone(read, wanted))
            changed = apply(changed, removals(again.document, gone, Habits(again.document)))
            again = read_urdf(changed, path)
    except ConflictError as conflict:
        message = f"the file says something else of {conflict.what} by now, and it is to change"
        return UrdfEdit(None, (_refused(message, read.document.root.name_span, path),))
    except RefusedError as refused:
        return UrdfEdit(None, (refused.diagnostic,))
    if again.description is None or not same_robot(again.description, wanted):
        return UrdfEdit(None, (_not_as_asked(read, again.description, wanted, path),))
    return UrdfEdit(changed, (*told, *_still_named(read, wanted)))


def _with_changes(
    text: bytes, read: UrdfRead, wanted: Description, path: Path | None, told: list[Diagnostic]
) -> bytes:
    """Return the text with what is new and what is changed, and with what is to go.

    What somebody is to know of it is added to `told`.
    """
    document, places, present = read.document, read.places, read.description
    assert document is not None and present is not None
    habits = Habits(document)
    new = list(_parts(wanted, lambda part: place_of(places, part) is None))
    if new and not document.root.children:
        return _begun(document, wanted, new[0], habits, path, told)
    _check_made_here(read, wanted, new)
    macros = is_xacro(document)
    splices = additions(document, places, wanted, new, habits)

    def change(part_: Part, make: Callable[[PartEdits], None]) -> None:
        _check_once(read, part_)
        element = place_of(places, part_)
        assert element is not None, "what is changed was read"
        part = PartEdits(document, element, habits, macros)
        make(part)
        told.extend(part.told)
        start, end = part.span
        if part.text != text[start:end]:
            splices.append(Splice(start, end, part.text))

    for name, link, was in _changed(present.links, wanted.links):
        change(Part("link", name), partial(change_link, before=was, after=link))
    for name, joint, old in _changed(present.joints, wanted.joints):
        change(Part("joint", name), partial(change_joint, before=old, after=joint))
    for name, material, one in _changed(present.materials, wanted.materials):
        changed = partial(change_material, path=(), before=one, after=material)
        change(Part("material", name), changed)
    text = apply(text, splices)
    return _named(text, wanted.name, path) if present.name != wanted.name else text


def _begun(
    document: XmlDocument,
    wanted: Description,
    first: Part,
    habits: Habits,
    path: Path | None,
    told: list[Diagnostic],
) -> bytes:
    """Return the text of a robot that had nothing, with all that it is to have."""
    element = habits.styled(element_of(wanted, first))
    begun = insert_last(document, document.root, element, habits.style)
    if begun.document is None:
        raise RefusedError(begun.diagnostics[0])
    text = begun.document.text
    return _with_changes(text, read_urdf(text, path), wanted, path, told)


def _gone(read: UrdfRead, wanted: Description) -> list[Element]:
    """Return the parts that are to go."""
    document, present = read.document, read.description
    if document is None or present is None:
        return []
    parts = _parts(present, lambda part: not _has(wanted, part))
    found = [
        element
        for part in parts
        if _check_once(read, part) and (element := place_of(read.places, part)) is not None
    ]
    for element in found if is_xacro(document) else ():
        _check_plain(document, element)
    return found


def _named(text: bytes, name: str, path: Path | None) -> bytes:
    document = read_urdf(text, path).document
    if document is None:
        return text
    edit = set_attribute(document, document.root, "name", name)
    if edit.document is None:
        raise RefusedError(edit.diagnostics[0])
    return edit.document.text


def _parts(robot: Description, wanted: Callable[[Part], bool]) -> Iterator[Part]:
    for kind in KINDS:
        yield from filter(wanted, (Part(kind, name) for name in parts_of(robot, kind)))


def _has(robot: Description, part: Part) -> bool:
    return part.name in parts_of(robot, part.kind)


def _changed(before: Mapping[str, T], after: Mapping[str, T]) -> Iterator[tuple[str, T, T]]:
    """Yield the name of each part that is there and changed, what it becomes, and what it was."""
    for name, part in after.items():
        if name in before and not same(before[name], part):
            yield name, part, before[name]


def _check_made_here(read: UrdfRead, wanted: Description, new: list[Part]) -> None:
    """Refuse to write a part of a name that an element has which could not be read."""
    present = read.description
    added = set(new)
    for part in _parts(wanted, lambda part: part not in added):
        element = place_of(read.places, part)
        if present is not None and element is not None and not _has(present, part):
            document = read.document
            file = None if document is None else document.file
            message = f"a {part.kind} `{part.name}` stands here that cannot be read; correct it"
            raise RefusedError(_refused(message, element.name_span, file))


def _check_once(read: UrdfRead, part: Part) -> bool:
    """Refuse to change what stands there twice, as no reader of URDF takes such a file."""
    again = read.places.again.get(part)
    if again is not None and read.document is not None:
        message = (
            f"a {part.kind} `{part.name}` stands here a second time, and urdfdom reads no such "
            "file; rename one, or take it away"
        )
        raise RefusedError(_refused(message, again.name_span, read.document.file))
    return True


def _check_plain(document: XmlDocument, element: Element) -> None:
    """Refuse to take away what macros have a hand in."""
    for each in element.walk():
        for one in each.attributes:
            if is_computed(one.value):
                message = f"`{one.name}` of `<{each.name}>` is computed by a macro: `{one.value}`"
                raise RefusedError(_refused(message, one.value_span, document.file))


def _left_above(document: XmlDocument, gone: list[Element]) -> Iterator[Diagnostic]:
    """Yield the comments that stay, though nothing is left of what they stand above."""
    for each in headings(document, gone):
        if not each.goes:
            line = line_number(document.text, each.span.start)
            message = (
                f"a comment stays that stood above `{each.part.get('name')}`, which is taken away: "
                f"line {line}"
            )
            yield Diagnostic(codes.SIDE_EFFECT, message, each.span, document.file)


def _still_named(read: UrdfRead, wanted: Description) -> Iterator[Diagnostic]:
    """Yield where other elements of the file name what was taken away."""
    document, present = read.document, read.description
    if document is None or present is None:
        return
    gone = set(_parts(present, lambda part: not _has(wanted, part)))
    links = {part.name for part in gone if part.kind == "link"}
    joints = {part.name for part in gone if part.kind == "joint"}
    for outer in document.root.children if gone else ():
        if outer.name == "gazebo" and (outer.get("reference") or "") in links | joints:
            yield _dangling(document, outer, outer.get("reference") or "")
        for each in outer.walk() if outer.name in ("transmission", "ros2_control") else ():
            if each.name == "joint" and (each.get("name") or "") in joints:
                yield _dangling(document, each, each.get("name") or "")


def _dangling(document: XmlDocument, element: Element, name: str) -> Diagnostic:
    line = element.line
    message = f"`<{element.name}>` in line {line} still names `{name}`, which is taken away"
    return Diagnostic(codes.SIDE_EFFECT, message, element.name_span, document.file)


def _not_as_asked(
    read: UrdfRead, got: Description | None, wanted: Description, path: Path | None
) -> Diagnostic:
    """Say which part would not be as it is to be, and where it stands."""
    if got is None:
        return _refused("the robot could not be read again", _span(read, None), path)
    for kind in KINDS:
        has, shall = parts_of(got, kind), parts_of(wanted, kind)
        for name in (*shall, *has):
            if same(has.get(name), shall.get(name)):
                continue
            place = place_of(read.places, Part(kind, name))
            message = (
                f"the {kind} `{name}` would not be what was asked for: something else stands in "
                "the file that is in the way; correct it first"
            )
            return _refused(message, _span(read, place), path)
    return _refused("the robot would not be what was asked for", _span(read, None), path)


def _span(read: UrdfRead, element: Element | None) -> Span:
    if element is not None:
        return element.name_span
    return Span(0, 0) if read.document is None else read.document.root.name_span


def _refused(message: str, span: Span, path: Path | None) -> Diagnostic:
    return Diagnostic(codes.EDIT_REFUSED, message, span, path)
