"""The rules of package.xml, as catkin_pkg checks them for catkin and colcon.

From REP 127 (format 1), REP 140 (format 2) and REP 149 (format 3), and where these leave it open
from what catkin_pkg 1 refuses.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from string import ascii_letters, ascii_lowercase, digits

from plastron_tui.diagnostics import Diagnostic, Span, codes
from plastron_tui.diagnostics.severity import Severity
from plastron_tui.ros.packages import check_mail, check_version, is_version

from .conditions import holds
from .document import Element
from .package_data import DEPENDENCY_TAGS, VERSIONS, PackageXml, Person

_NAME = frozenset(f"{ascii_letters}{digits}_-")


def _is_package_name(name: str) -> bool:
    """Tell whether a package can have a name, usual or not."""
    return name[:1] not in ("", "_", "-") and not set(name) - _NAME


def check(package: PackageXml) -> Iterator[Diagnostic]:
    """Check a package.xml; what the build tools refuse is an error."""
    for rule in _RULES:
        for message, span, severity in rule(package):
            yield Diagnostic(
                codes.BROKEN_PACKAGE, message, span, package.document.file, severity=severity
            )


_Found = Iterator[tuple[str, Span, Severity]]


def _head(package: PackageXml) -> _Found:
    root, text = package.document.root, package.document.text
    (name,), (version,) = root.named("name"), root.named("version")
    if not _is_package_name(package.name):
        message = f"no package can be called `{package.name}`"
        yield message, name.value_span(text), Severity.ERROR
    elif package.name[0] not in ascii_lowercase or package.name != package.name.lower():
        message = f"the name `{package.name}` does not start with a small letter, or has capitals"
        yield message, name.value_span(text), Severity.WARNING
    if not is_version(package.version):
        message = f"`{package.version}` is no version: it is three numbers, as in 0.1.0"
        yield message, version.value_span(text), Severity.ERROR
    elif check_version(package.version) is not None:
        message = f"a number of the version `{package.version}` starts with 0"
        yield message, version.value_span(text), Severity.WARNING
    older = version.attribute("compatibility")
    if older is not None and older.value and not is_version(older.value):
        message = f"`{older.value}` is no version: it is three numbers, as in 0.1.0"
        yield message, older.value_span, Severity.ERROR
    description = root.named("description")[0]
    if not package.description and not description.children:
        yield "the description is empty", description.name_span, Severity.ERROR


def _people(package: PackageXml) -> _Found:
    root = package.document.root
    if not package.maintainers:
        yield "there is no `<maintainer>`", root.name_span, Severity.ERROR
    for person in package.maintainers:
        if not person.email:
            message = f"the maintainer `{person.name}` has no mail address"
            yield message, _place(package, person, "email"), Severity.ERROR
    for person in (*package.maintainers, *package.authors):
        # An author's may be missing, and not be empty; a maintainer's was told.
        is_told = not person.email and person in package.maintainers
        if person.email is not None and check_mail(person.email) is not None and not is_told:
            message = f"`{person.email}` is no mail address"
            yield message, _place(package, person, "email"), Severity.ERROR


def _licenses(package: PackageXml) -> _Found:
    root = package.document.root
    if not package.licenses:
        yield "there is no `<license>`", root.name_span, Severity.ERROR
    for element in root.named("license"):
        if not element.value:
            yield "the license is empty", element.name_span, Severity.ERROR


def _dependencies(package: PackageXml) -> _Found:
    text = package.document.text
    for one in package.dependencies:
        if one.name == package.name:
            message = "a package cannot depend on itself"
            yield message, one.element.value_span(text), Severity.ERROR
        if not one.name:
            message = f"`<{one.tag}>` names nothing"
            yield message, one.element.name_span, Severity.WARNING
    members = {one.name for one in package.groups if one.tag == "member_of_group"}
    for group in package.groups:
        if group.tag == "group_depend" and group.name in members:
            message = f"the package is in the group `{group.name}`, and cannot depend on it"
            yield message, group.element.value_span(text), Severity.ERROR


def _redundant(package: PackageXml) -> _Found:
    """A dependency that a broader one says as well is an error, unlike one that is there twice."""
    broad = "test_depend" if package.format == 1 else "depend"
    narrow: tuple[str, ...] = ("build_depend", "run_depend")
    if package.format != 1:
        narrow = ("build_depend", "build_export_depend", "exec_depend")
    seen = {one.same: one.tag for one in package.dependencies if one.tag in narrow}
    for one in package.dependencies:
        if one.tag != broad:
            continue
        if one.same in seen:
            message = f"`<{seen[one.same]}>` and `<{broad}>` both name `{one.name}`"
            if seen[one.same] == broad:
                message = f"`<{broad}>` names `{one.name}` twice"
            yield message, one.element.value_span(package.document.text), Severity.ERROR
        if broad == "depend":
            seen.setdefault(one.same, broad)


def _conditions(package: PackageXml) -> _Found:
    if package.format < 3:
        held = [one.element for one in package.exports]
    else:
        held = [
            *(one.element for one in package.dependencies),
            *(one.element for one in package.groups),
            *(one.element for one in package.exports),
        ]
    for element in held:
        found = element.attribute("condition")
        if found is not None and holds(found.value, {}) is None:
            message = f"`{found.value}` is no condition"
            yield message, found.value_span, Severity.ERROR


def _exports(package: PackageXml) -> _Found:
    exports = package.document.root.named("export")
    for element in exports[1:]:
        yield "there are several `<export>`", element.name_span, Severity.ERROR
    always = [
        one for one in package.exports if one.tag == "build_type" and not one.get("condition")
    ]
    for export in always[1:]:
        yield "there are several `<build_type>`", export.element.name_span, Severity.ERROR


def _metapackage(package: PackageXml) -> _Found:
    if not package.is_metapackage:
        return
    tools = [one for one in package.dependencies if one.tag == "buildtool_depend"]
    if "catkin" not in [one.name for one in tools]:
        message = "a metapackage has `catkin` as its `<buildtool_depend>`"
        yield message, package.document.root.name_span, Severity.WARNING
    for one in package.dependencies:
        is_other_tool = one.tag == "buildtool_depend" and one.name != "catkin"
        if is_other_tool or one.tag in ("build_depend", "depend", "test_depend"):
            message = f"a metapackage has no `<{one.tag}>` on `{one.name}`"
            yield message, one.element.name_span, Severity.WARNING


def _known(package: PackageXml) -> _Found:
    """Tags and attributes that the format does not have."""
    root = package.document.root
    known = _attributes(package.format)
    yield from _unknown_attributes(root, ("format",))
    for child in root.children:
        if child.name not in known:
            message = f"there is no `<{child.name}>` in a package.xml of format {package.format}"
            yield message, child.name_span, Severity.ERROR
            continue
        yield from _unknown_attributes(child, known[child.name])
        if child.children and child.name not in ("description", "export"):
            message = f"there can be no element in `<{child.name}>`"
            yield message, child.children[0].name_span, Severity.ERROR


def _unknown_attributes(element: Element, known: tuple[str, ...]) -> _Found:
    for one in element.attributes:
        if one.name not in known and one.name != "xmlns" and ":" not in one.name:
            message = f"`<{element.name}>` has no attribute `{one.name}` in this format"
            span = Span(one.span.start, one.span.start + len(one.name.encode()))
            yield message, span, Severity.ERROR


def _attributes(number: int) -> dict[str, tuple[str, ...]]:
    """Return the attributes that the tags of a format can have."""
    condition = ("condition",) if number > 2 else ()
    found = {
        "name": (),
        "version": ("compatibility",),
        "description": (),
        "maintainer": ("email",),
        "license": ("file",) if number > 2 else (),
        "url": ("type",),
        "author": ("email",),
        "export": (),
    }
    depends = (*DEPENDENCY_TAGS[number], "conflict", "replace")
    found |= dict.fromkeys(depends, (*VERSIONS, *condition))
    if number > 2:
        found |= {"group_depend": condition, "member_of_group": condition}
    return found


def _place(package: PackageXml, person: Person, attribute: str) -> Span:
    found = person.element.attribute(attribute)
    if found is not None and found.value:
        return found.value_span
    return person.element.name_span


_RULES: tuple[Callable[[PackageXml], _Found], ...] = (
    _head,
    _people,
    _licenses,
    _known,
    _dependencies,
    _redundant,
    _conditions,
    _exports,
    _metapackage,
)
