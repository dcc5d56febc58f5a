"""Links, joints and materials that come into a robot's file, or go."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from typing import Any, NamedTuple

from plastron_tui.ros.robots.description import Description
from plastron_tui.ros.robots.tree import branches
from plastron_tui.sources.splices import Splice, indent_of, line_end, line_start
from plastron_tui.sources.xml.document import Element, XmlDocument
from plastron_tui.sources.xml.layout import (
    behind_comments,
    line_break,
    skip_blanks,
    starts_line,
)
from plastron_tui.sources.xml.new_element import NewElement, render
from plastron_tui.sources.xml.places import after, before, removal

from .comments import above_comments, headings
from .habits import Habits, Order
from .new_elements import joint_element, link_element, material_element
from .reader import PartPlaces
from .values import first


class Part(NamedTuple):
    """A link, a joint or a material, by what it is and its name."""

    kind: str
    name: str


KINDS = ("material", "link", "joint")
_ELEMENTS: Mapping[str, Callable[[Any], NewElement]] = {
    "material": material_element,
    "link": link_element,
    "joint": joint_element,
}


def parts_of(robot: Description, kind: str) -> Mapping[str, Any]:
    """Return the parts of a kind by their names."""
    parts: Mapping[str, Any] = getattr(robot, f"{kind}s")
    return parts


def place_of(places: PartPlaces, part: Part) -> Element | None:
    """Return where a part stands."""
    elements: Mapping[str, Element] = getattr(places, f"{part.kind}s")
    return elements.get(part.name)


def element_of(robot: Description, part: Part) -> NewElement:
    """Return a part as it is written."""
    return _ELEMENTS[part.kind](parts_of(robot, part.kind)[part.name])


def additions(
    document: XmlDocument,
    places: PartPlaces,
    robot: Description,
    new: Iterable[Part],
    habits: Habits,
) -> list[Splice]:
    """Return what writes new parts, each near those that it belongs to.

    Args:
        document: the file; something is in its `<robot>`.
        places: where its parts stand.
        robot: the robot as it is to be.
        new: what of it is not there.
        habits: of the file.
    """
    missing = set(new)
    found: list[Splice] = []
    for order in _sequences(robot, habits.order):
        run: list[Part] = []
        anchor: Part | None = None
        for part in order:
            if part in missing:
                run.append(part)
            elif place_of(places, part) is not None:
                if run:
                    found += _run(document, places, robot, run, (anchor, part), habits)
                    run = []
                anchor = part
        if run:
            found += _run(document, places, robot, run, (anchor, None), habits)
    return found


def _sequences(robot: Description, order: Order) -> list[list[Part]]:
    """Return the parts in the orders in which new ones get their places."""
    materials = [Part("material", name) for name in robot.materials]
    links = [Part("link", name) for name in robot.links]
    joints = [Part("joint", name) for name in robot.joints]
    if order is Order.APART:
        return [materials, links, joints]
    both = list(_pairs(robot, order))
    seen = set(both)
    both += (part for part in (*links, *joints) if part not in seen)
    return [[*materials, *both]] if materials else [both]


def _pairs(robot: Description, order: Order) -> Iterator[Part]:
    for branch in branches(robot):
        link = Part("link", branch.link)
        if branch.joint is None:
            yield link
            continue
        joint = Part("joint", branch.joint.name)
        yield from (link, joint) if order is Order.LINK_FIRST else (joint, link)


def _run(
    document: XmlDocument,
    places: PartPlaces,
    robot: Description,
    run: Sequence[Part],
    around: tuple[Part | None, Part | None],
    habits: Habits,
) -> Iterator[Splice]:
    """Yield what writes some parts behind one, before another one, or at the end."""
    behind, ahead = around
    anchor = None if behind is None else place_of(places, behind)
    follower = None if ahead is None else place_of(places, ahead)
    elements = [habits.styled(element_of(robot, part)) for part in run]
    if anchor is not None:
        yield from _behind(document, _end_of_pair(document, anchor), elements, habits)
    elif follower is not None:
        yield from _ahead(document, follower, elements, habits)
    else:
        like = [each for each in document.root.children if each.name in ("link", "joint")]
        last = (like or document.root.children)[-1]
        if run[0].kind == "material":
            yield from _ahead(document, document.root.children[0], elements, habits)
        else:
            yield from _behind(document, last, elements, habits)


def _end_of_pair(document: XmlDocument, link: Element) -> Element:
    """Return the joint that holds a link and stands right behind it, else the link."""
    siblings = document.root.children
    at = siblings.index(link) + 1
    joint = siblings[at] if at < len(siblings) else link
    child = first(joint, "child") if link.name == "link" and joint.name == "joint" else None
    holds = child is not None and child.get("link") == link.get("name")
    return joint if holds else link


def _behind(
    document: XmlDocument, anchor: Element, new: Sequence[NewElement], habits: Habits
) -> Iterator[Splice]:
    text, style = document.text, habits.style
    end = behind_comments(document, anchor.span.end)
    rest = skip_blanks(text, end)
    if not starts_line(text, anchor.span.start) or line_break(text, rest) is None:
        for each in new:
            yield after(document, anchor.span, each, style)
        return
    indent = indent_of(text, anchor.span.start)
    written, previous = b"", anchor.name
    for each in new:
        lines = 1 + habits.lines_between(previous, each.name)
        written += style.newline * lines + indent + render(each, style, indent)
        previous = each.name
    yield Splice(rest, rest, written)


def _ahead(
    document: XmlDocument, follower: Element, new: Sequence[NewElement], habits: Habits
) -> Iterator[Splice]:
    text, style = document.text, habits.style
    start = follower.span.start
    if not starts_line(text, start):
        for each in new:
            yield before(document, follower.span, each, style)
        return
    indent = indent_of(text, start)
    written = b""
    following = [each.name for each in new[1:]] + [follower.name]
    for each, name in zip(new, following, strict=True):
        lines = 1 + habits.lines_between(each.name, name)
        written += indent + render(each, style, indent) + style.newline * lines
    at = above_comments(document, start)
    yield Splice(at, at, written)


def removals(document: XmlDocument, gone: Iterable[Element], habits: Habits) -> Iterator[Splice]:
    """Yield what takes parts away, each with the empty lines that keep it apart."""
    taken = set(gone)
    tops = {each.part: each.start for each in headings(document, taken) if each.goes}
    # Whether the empty lines below go: those above do not belong to a part that stays.
    takes_below = True
    for at, element in enumerate(document.root.children):
        if element not in taken:
            takes_below = False
            continue
        first = line_start(document.text, tops.get(element, element.span.start))
        above = _empty_lines_above(document.text, first)
        behind = None if at == 0 or takes_below else document.root.children[at - 1]
        if behind is not None and not _is_end(document, above, behind):
            takes_below, behind = above < first, None
        yield _removal(document, at, first if behind is None else above, habits, takes_below)


def _removal(
    document: XmlDocument, at: int, first: int, habits: Habits, takes_below: bool
) -> Splice:
    """Return what takes a part away, from the start of a line above it on."""
    siblings = document.root.children
    text, (start, end) = document.text, siblings[at].span
    broken = line_break(text, skip_blanks(text, behind_comments(document, end)))
    if not starts_line(text, start) or broken is None:
        return removal(document, siblings[at], habits.style, closes=False)
    last = broken.end
    if takes_below and at + 1 < len(siblings):
        while not text[last : line_end(text, last)].strip() and last < siblings[at + 1].span.start:
            last = line_end(text, last)
    return Splice(first, last)


def _empty_lines_above(text: bytes, start: int) -> int:
    """Return the start of the first of the empty lines above a line."""
    while (higher := _empty_line_above(text, start)) is not None:
        start = higher
    return start


def _empty_line_above(text: bytes, start: int) -> int | None:
    if not start:
        return None
    above = line_start(text, start - 1)
    return above if above < start and not text[above:start].strip() else None


def _is_end(document: XmlDocument, offset: int, element: Element) -> bool:
    """Tell whether the line before an offset is one that an element ends, or its comment."""
    end = behind_comments(document, element.span.end)
    broken = line_break(document.text, skip_blanks(document.text, end))
    return broken is not None and broken.end == offset
