"""What a package.xml says, in the formats 1, 2 and 3 (REP 127, 140, 149)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import NamedTuple

from plastron_tui.diagnostics import Diagnostic, Span, codes

from .conditions import holds
from .document import Element, XmlDocument

COVERS: dict[str, frozenset[str]] = {
    "buildtool_depend": frozenset({"buildtool"}),
    "buildtool_export_depend": frozenset({"buildtool_export"}),
    "build_depend": frozenset({"build"}),
    "build_export_depend": frozenset({"build_export"}),
    "depend": frozenset({"build", "build_export", "exec"}),
    "exec_depend": frozenset({"exec"}),
    "run_depend": frozenset({"build_export", "exec"}),
    "test_depend": frozenset({"test"}),
    "doc_depend": frozenset({"doc"}),
}
"""What a dependency of each tag is there for."""

VERSIONS = ("version_lt", "version_lte", "version_eq", "version_gte", "version_gt")

_FORMAT_1 = ("buildtool_depend", "build_depend", "run_depend", "test_depend")
_FORMAT_2 = tuple(tag for tag in COVERS if tag != "run_depend")

DEPENDENCY_TAGS: dict[int, tuple[str, ...]] = {1: _FORMAT_1, 2: _FORMAT_2, 3: _FORMAT_2}
"""The tags of dependencies that a format has, those that come first in a file first."""


class Person(NamedTuple):
    """A maintainer or an author."""

    name: str
    email: str | None
    element: Element


class Dependency(NamedTuple):
    """What a package needs.

    Attributes:
        tag: `depend`, `exec_depend`, ….
        name: of a package, or a key of rosdep.
        condition: when it is needed; None for always.
        versions: the attributes such as `version_gte`, with their values.
        element: where it stands.
    """

    tag: str
    name: str
    condition: str | None
    versions: tuple[tuple[str, str], ...]
    element: Element

    @property
    def same(self) -> tuple[object, ...]:
        """What two dependencies share that differ in their tags alone."""
        return self.name, self.condition, self.versions


class Group(NamedTuple):
    """A `group_depend`, a `member_of_group`, a `conflict` or a `replace`."""

    tag: str
    name: str
    condition: str | None
    element: Element


class Export(NamedTuple):
    """An element of `<export>`."""

    tag: str
    attributes: tuple[tuple[str, str], ...]
    value: str
    element: Element

    def get(self, name: str) -> str | None:
        """Return the value of an attribute."""
        return dict(self.attributes).get(name)


@dataclass(frozen=True, slots=True)
class PackageXml:
    """A package.xml.

    Attributes:
        document: the file.
        format: 1, 2 or 3.
        description: its words, with one blank between.
    """

    document: XmlDocument
    format: int
    name: str
    version: str
    description: str
    maintainers: tuple[Person, ...]
    authors: tuple[Person, ...]
    licenses: tuple[str, ...]
    urls: tuple[str, ...]
    dependencies: tuple[Dependency, ...]
    groups: tuple[Group, ...]
    exports: tuple[Export, ...]

    @property
    def is_metapackage(self) -> bool:
        """Whether it holds nothing, and depends on what belongs together (REP 127)."""
        return any(export.tag == "metapackage" for export in self.exports)

    def build_type(self, variables: Mapping[str, str]) -> str:
        """Return what builds it: `catkin` where it does not say (REP 149).

        Args:
            variables: those of conditions, such as `ROS_VERSION`.
        """
        found = [
            one.value
            for one in self.exports
            if one.tag == "build_type" and holds(one.get("condition"), variables) is True
        ]
        return found[0] if found else "catkin"

    def covered(self, name: str, variables: Mapping[str, str]) -> frozenset[str]:
        """Return what a dependency is declared for: `build`, `exec`, `test`, ….

        Args:
            name: of the dependency.
            variables: those of conditions; what is not known to hold does not count.
        """
        found: set[str] = set()
        for one in self.dependencies:
            if one.name == name and holds(one.condition, variables) is True:
                found |= COVERS[one.tag]
        return frozenset(found)


def parse_package(document: XmlDocument) -> PackageXml | Diagnostic:
    """Return what a package.xml says, or why it is none."""
    root = document.root
    if root.name != "package":
        message = f"the outermost element is `<{root.name}>`, not `<package>`"
        return _broken(document, message, root.name_span)
    written = root.attribute("format")
    number = 1 if written is None else {"1": 1, "2": 2, "3": 3}.get(written.value.strip())
    if number is None and written is not None:
        message = f"there is no format `{written.value}` of package.xml: there are 1, 2 and 3"
        return _broken(document, message, written.value_span)
    for tag in ("name", "version", "description"):
        found = root.named(tag)
        if len(found) != 1:
            message = f"there is no `<{tag}>`" if not found else f"there are several `<{tag}>`"
            span = found[1].name_span if found else root.name_span
            return _broken(document, message, span)
    tags = DEPENDENCY_TAGS[number or 1]
    exports = [child for export in root.named("export") for child in export.children]
    return PackageXml(
        document,
        number or 1,
        root.named("name")[0].value,
        root.named("version")[0].value,
        " ".join(_full_text(root.named("description")[0]).split()),
        _people(root, "maintainer"),
        _people(root, "author"),
        tuple(one.value for one in root.named("license")),
        tuple(one.value for one in root.named("url")),
        tuple(map(_dependency, root.named(*tags))),
        tuple(map(_group, root.named("group_depend", "member_of_group", "conflict", "replace"))),
        tuple(map(_export, exports)),
    )


def _people(root: Element, tag: str) -> tuple[Person, ...]:
    return tuple(Person(one.value, one.get("email"), one) for one in root.named(tag))


def _dependency(element: Element) -> Dependency:
    versions = tuple((one.name, one.value) for one in element.attributes if one.name in VERSIONS)
    name, condition = element.value, element.get("condition")
    return Dependency(element.name, name, condition, tuple(sorted(versions)), element)


def _group(element: Element) -> Group:
    return Group(element.name, element.value, element.get("condition"), element)


def _export(element: Element) -> Export:
    pairs = tuple((one.name, one.value) for one in element.attributes)
    return Export(element.name, pairs, element.value, element)


def _full_text(element: Element) -> str:
    """Return the text of an element and of all in it, in the order of the text."""
    text = element.pieces[0]
    for child, piece in zip(element.children, element.pieces[1:], strict=True):
        # The one element of HTML that parts words.
        text += ("\n" if child.name == "br" else _full_text(child)) + piece
    return text


def _broken(document: XmlDocument, message: str, span: Span) -> Diagnostic:
    return Diagnostic(codes.BROKEN_PACKAGE, message, span, document.file)
