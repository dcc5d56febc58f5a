"""Add dependencies to a package.xml and take them away, in the place and style that it has."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from itertools import pairwise
from typing import NamedTuple

from plastron_tui.diagnostics import Diagnostic, Span, codes

from .conditions import holds, mentions
from .document import Element
from .edits import XmlEdit, insert_after, insert_before, insert_last, remove_element
from .new_element import NewElement
from .package_data import COVERS, DEPENDENCY_TAGS, Dependency, PackageXml, parse_package
from .package_rules import check

NEEDS = frozenset({"build", "build_export", "buildtool", "buildtool_export", "exec", "test", "doc"})
"""What a dependency can be there for (REP 149)."""

_ORDER = (
    "name",
    "version",
    "description",
    "maintainer",
    "license",
    "url",
    "author",
    "buildtool_depend",
    "buildtool_export_depend",
    "build_depend",
    "build_export_depend",
    "depend",
    "exec_depend",
    "run_depend",
    "test_depend",
    "doc_depend",
    "conflict",
    "replace",
    "group_depend",
    "member_of_group",
    "export",
)
"""The usual order of a package.xml; REP 149 leaves it open."""


class PackageEdit(NamedTuple):
    """A package.xml after an edit, or why it is not made.

    Attributes:
        package: None where the edit is refused; the same as before where nothing was to do.
        tags: those of the elements that were written or taken away.
    """

    package: PackageXml | None
    tags: tuple[str, ...] = ()
    diagnostics: tuple[Diagnostic, ...] = ()


_BESIDES_TESTS = ("build_depend", "run_depend")
"""What catkin_pkg refuses in format 1 beside a `<test_depend>` of the same name."""


def add_dependency(
    package: PackageXml, name: str, needs: Iterable[str], ros_version: int
) -> PackageEdit:
    """Declare a dependency for what it is not declared for yet.

    A file for both versions of ROS gets it under the condition that its others have.

    Args:
        package: the package.xml.
        name: of a package, or a key of rosdep.
        needs: what it is there for, some of `NEEDS`.
        ros_version: 1 or 2; a dependency whose condition holds for the other alone does not count.
    """
    variables = {"ROS_VERSION": str(ros_version)}
    covered = package.covered(name, variables)
    missing = set(needs) - covered
    if covered & {"build", "exec"}:
        # What is there to build or to run is there to test; to say it twice is an error in 1.
        missing.discard("test")
    tags = _tags(package, missing, is_new=not covered & COVERS["depend"])
    for tag in tags:
        if package.is_metapackage and tag not in ("exec_depend", "run_depend"):
            message = f"a metapackage has no `<{tag}>`, as on `{name}`"
            span = package.document.root.name_span
            return PackageEdit(None, (), (_refused(package, message, span),))
    for one in package.dependencies if package.format == 1 else ():
        if one.tag == "test_depend" and one.name == name and set(tags) & {*_BESIDES_TESTS}:
            message = f"format 1 takes no `<{tags[0]}>` on `{name}` beside the `<test_depend>`"
            help_ = f"write `<{tags[0]}>` in its place: tests have it then, too"
            span = one.element.name_span
            return PackageEdit(None, (), (_refused(package, message, span)._replace(help=help_),))
    condition = _condition(package, ros_version)
    attributes = (("condition", condition),) if condition is not None else ()
    after = package
    for tag in tags:
        edit = _write(after, NewElement(tag, attributes, name))
        if edit.package is None:
            return edit
        after = edit.package
    return _checked(package, PackageEdit(after, tags))


def remove_dependency(
    package: PackageXml, name: str, ros_version: int, tags: Iterable[str] = tuple(COVERS)
) -> PackageEdit:
    """Take a dependency away.

    Args:
        package: the package.xml.
        name: of the dependency; it need not be declared.
        ros_version: 1 or 2; a dependency whose condition does not hold there stays.
        tags: those of the elements that may go.
    """
    gone: list[str] = []
    while found := [one for one in _declared(package, name, ros_version) if one.tag in set(tags)]:
        edit = applied(package, remove_element(package.document, found[-1].element))
        if edit.package is None:
            return edit
        package = edit.package
        gone.append(found[-1].tag)
    return PackageEdit(package, tuple(reversed(gone)))


def add_group(package: PackageXml, name: str) -> PackageEdit:
    """Declare that the package is a member of a group, such as `rosidl_interface_packages`."""
    if any((one.tag, one.name) == ("member_of_group", name) for one in package.groups):
        return PackageEdit(package)
    if package.format < 3:
        message = f"a package.xml of format {package.format} has no `<member_of_group>`"
        found = package.document.root.attribute("format")
        span = found.value_span if found is not None else package.document.root.name_span
        return PackageEdit(None, (), (_refused(package, message, span),))
    return _write(package, NewElement("member_of_group", (), name))


def applied(package: PackageXml, edit: XmlEdit, tag: str | None = None) -> PackageEdit:
    """Return what a package.xml says after an edit of its XML."""
    if edit.document is None:
        return PackageEdit(None, (), edit.diagnostics)
    found = parse_package(edit.document)
    if isinstance(found, Diagnostic):
        return PackageEdit(None, (), (found,))
    return PackageEdit(found, (tag,) if tag is not None else ())


def _checked(before: PackageXml, edit: PackageEdit) -> PackageEdit:
    """Refuse an edit that breaks a rule which the file kept before."""
    if edit.package is None:
        return edit
    known = Counter(one.message for one in check(before))
    for one in check(edit.package):
        known[one.message] -= 1
        if known[one.message] < 0:
            span = before.document.root.name_span
            return PackageEdit(None, (), (_refused(before, one.message, span),))
    return edit


def _refused(package: PackageXml, message: str, span: Span) -> Diagnostic:
    return Diagnostic(codes.EDIT_REFUSED, message, span, package.document.file)


def _declared(package: PackageXml, name: str, ros_version: int) -> list[Dependency]:
    variables = {"ROS_VERSION": str(ros_version)}
    return [
        one
        for one in package.dependencies
        if one.name == name and holds(one.condition, variables) is True
    ]


def _tags(package: PackageXml, missing: set[str], *, is_new: bool) -> tuple[str, ...]:
    """Return the tags that say what is missing, as few as the file's style has."""
    used = Counter(one.tag for one in package.dependencies)
    tags: list[str] = []
    left = set(missing)
    if package.format == 1:
        if left & {"exec", "build_export"}:
            tags.append("run_depend")
            left -= {"exec", "build_export"}
    elif is_new and _takes_broad(package, left, used):
        tags.append("depend")
        left -= COVERS["depend"]
    if tags or left & {"build", "exec"}:
        left.discard("test")
    narrow = (tag for tag in DEPENDENCY_TAGS[package.format] if len(COVERS[tag]) == 1)
    tags.extend(tag for tag in narrow if COVERS[tag] <= left)
    return tuple(sorted(tags, key=_ORDER.index))


def _takes_broad(package: PackageXml, missing: set[str], used: Counter[str]) -> bool:
    """Tell whether `<depend>` is what the file would say."""
    wanted = missing & COVERS["depend"]
    if package.is_metapackage or not wanted:
        return False
    if wanted == COVERS["depend"]:
        return True
    if wanted >= {"build", "exec"}:
        is_split = used["build_depend"] and used["exec_depend"] and not used["depend"]
        return not is_split
    return wanted == {"exec"} and bool(used["depend"]) and not used["exec_depend"]


def _condition(package: PackageXml, ros_version: int) -> str | None:
    """Return the condition under which a file for both versions names what is for one alone."""
    ours, others = {"ROS_VERSION": str(ros_version)}, {"ROS_VERSION": str(3 - ros_version)}
    found: Counter[str] = Counter()
    is_for_other = False
    for one in package.dependencies:
        if one.condition is None or not mentions(one.condition, "ROS_VERSION"):
            continue
        here, there = holds(one.condition, ours), holds(one.condition, others)
        if (here, there) == (True, False):
            found[one.condition] += 1
        is_for_other |= (here, there) == (False, True)
    if not found and is_for_other and package.format == 3:
        return f"$ROS_VERSION == {ros_version}"
    return found.most_common(1)[0][0] if found and is_for_other else None


def _write(package: PackageXml, new: NewElement) -> PackageEdit:
    """Write an element where it belongs in the file."""
    document, root = package.document, package.document.root
    condition = dict(new.attributes).get("condition")
    like = root.named(new.name)
    alike = [one for one in like if one.get("condition") == condition]
    if block := alike or like:
        anchor, is_behind = _in_order(document.text, root, block, new.text)
    else:
        rank = _ORDER.index(new.name)
        lower = [one for one in root.children if one.name in _ORDER[:rank]]
        if not lower:
            return applied(package, insert_last(document, root, new), new.name)
        anchor, is_behind = lower[-1], True
    edit = insert_after if is_behind else insert_before
    return applied(package, edit(document, anchor, new), new.name)


def _in_order(
    text: bytes, root: Element, like: Iterable[Element], name: str
) -> tuple[Element, bool]:
    """Return which element a new one stands beside, and whether behind it."""
    elements = list(like)
    if not _is_sorted(elements):
        elements = _last_block(text, root, elements)
    if not _is_sorted(elements):
        return elements[-1], True
    smaller = [one for one in elements if one.value <= name]
    return (smaller[-1], True) if smaller else (elements[0], False)


def _is_sorted(elements: list[Element]) -> bool:
    values = [one.value for one in elements]
    return len(values) > 1 and all(one <= other for one, other in pairwise(values))


def _last_block(text: bytes, root: Element, elements: list[Element]) -> list[Element]:
    """Return those at the end that stand in lines that follow each other."""
    at = len(elements) - 1
    places = {one: number for number, one in enumerate(root.children)}
    while at and places[elements[at - 1]] + 1 == places[elements[at]]:
        between = text[elements[at - 1].span.end : elements[at].span.start]
        if between.count(b"\n") != 1:
            break
        at -= 1
    return elements[at:]
