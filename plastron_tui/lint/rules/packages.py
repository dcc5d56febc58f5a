"""What is wrong between a package's code and its package.xml."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cache

from plastron_tui.diagnostics import Code, Diagnostic, Edit, Fix, Label, Severity, Span
from plastron_tui.lint.dependencies import (
    LIBRARIES,
    TYPE_ENDINGS,
    TYPES_ALONE,
    brought,
    depends_on,
    has_types,
    is_package,
    is_umbrella,
    misnamed,
    remedy_for,
)
from plastron_tui.lint.further_places import first_labels
from plastron_tui.lint.rule import rule
from plastron_tui.lint.tree import PackageFacts, SourceTree
from plastron_tui.model.package_facts import BuildFacts, Declared, Used
from plastron_tui.ros.interfaces import InterfaceKind
from plastron_tui.ros.name_slips import is_slip
from plastron_tui.ros.package_keys import (
    key_of_header,
    key_of_module,
    package_of_header,
    package_of_module,
)

from .package_examples import NODE_PACKAGE, package_xml

_BROUGHT = frozenset(
    {"action_msgs", "actionlib_msgs", "builtin_interfaces", "service_msgs",
     "unique_identifier_msgs"}
)  # fmt: skip
"""What the build of types needs, or brings, without anybody naming it."""
_HANDED_ON = _BROUGHT | {"lifecycle_msgs", "rcl_interfaces", "rosgraph_msgs"}
"""What the client libraries themselves hand to whoever uses them."""
_FURTHER = frozenset(
    {"actionlib", "cv_bridge", "image_transport", "message_filters", "tf", "tf2_ros"}
)
"""Packages without types of their own that code uses by their name."""
_TYPES_OF = {
    1: re.compile(r"(\w+)(?:\.(?:msg|srv)\b|/[A-Z]\w*\.h\Z)"),
    2: re.compile(r"(\w+)(?:\.(?:msg|srv|action)\b|/(?:msg|srv|action)/)"),
}
"""Modules and headers that types are in, in the generations of ROS."""


def packages_of_types(tree: SourceTree, version: int) -> frozenset[str]:
    """Return the packages that have types, in a generation of ROS."""
    catalog = tree.catalogs.get(version)
    if catalog is None:
        return TYPES_ALONE
    return TYPES_ALONE.union(*(catalog.packages(kind) for kind in InterfaceKind))


@rule(
    "RK501",
    "undeclared-dependency",
    "Code uses a package of ROS that its package.xml does not depend on.",
    severity=Severity.WARNING,
    why="It works where somebody else has installed or built that package before, and breaks on "
    "the next machine, or when the packages are built in another order. What another package "
    "depends on does not count, but for the types that the client libraries themselves bring: they "
    "are told where CMake looks for them. A name that is of no package, and one slip from one that "
    "is depended on, is told, too. Of packages that are not known, those count that have only "
    "types by what is imported of them. Code that is not installed, tests, and what is imported "
    "in `try` are left alone, as are most packages without types that are not of the workspace.",
    bad=NODE_PACKAGE | {"demo/package.xml": package_xml("demo", exec_depend=["rclpy"])},
    good=NODE_PACKAGE,
)
def undeclared_dependency(tree: SourceTree, code: Code) -> Iterator[Diagnostic]:
    """Find packages that code uses and package.xml does not name."""
    known = cache(lambda version: packages_of_types(tree, version))
    with_headers, with_modules = _own(tree)
    for package, build in _built(tree):
        if build.has_groups:
            continue
        types = known(package.ros_versions[0])
        yield from _misspelt(tree, code, package, build, types)
        types = types.union(_types_by_form(tree, package, build, types))
        seen = {package.name, *brought(tree, package)}
        for used in build.used:
            own = with_modules if used.need == "exec" else with_headers
            name = _package_of(used, package, types, own)
            if name is None or name in seen or _is_of_another(used, build, tree):
                continue
            if depends_on(tree, name, package.name):
                # The two cannot depend on each other.
                continue
            if not _counts(name, build, types, tree):
                continue
            declared = [each for each in build.dependencies if each.name == name]
            version = package.ros_versions[0]
            if any(used.need in each.covers and version in each.versions for each in declared):
                continue
            declared = declared or misnamed(tree, package, name)
            seen.add(name)
            own_uses = ((x, with_modules if x.need == "exec" else with_headers) for x in build.used)
            uses = [x for x, own in own_uses if _package_of(x, package, types, own) == name]
            needs = frozenset(each.need for each in uses)
            yield Diagnostic(
                code,
                _undeclared(name, used, declared, version),
                used.place.span,
                package.folder / used.place.file,
                help=remedy_for(tree, package, used, name, needs) + _or_out(tree, name, uses),
                labels=(
                    Label(
                        declared[0].span if declared else build.name_span,
                        "this is all that it says" if declared else "this package.xml",
                        package.folder / "package.xml",
                    ),
                    *_elsewhere(package, uses),
                ),
            )


def _types_by_form(
    tree: SourceTree, package: PackageFacts, build: BuildFacts, known: frozenset[str]
) -> Iterator[str]:
    """Yield what can only be packages of types, by the form of what is imported of them."""
    form = _TYPES_OF[package.ros_versions[0]]
    for name in {
        found[1] for found in map(form.match, (each.what for each in build.used)) if found
    }:
        is_meant = any(is_slip(name, each) for each in known | tree.packages.keys())
        if name.endswith(TYPE_ENDINGS) and not is_meant and not _is_own_module(tree, name):
            yield name


def _misspelt(
    tree: SourceTree, code: Code, package: PackageFacts, build: BuildFacts, types: frozenset[str]
) -> Iterator[Diagnostic]:
    """Yield the types that are used of no package, one slip from one that is depended on."""
    wanted = {each.name for each in build.dependencies} & types
    uses: dict[str, list[Used]] = {}
    for used in build.used:
        found = _TYPES_OF[package.ros_versions[0]].match(used.what)
        if found is not None:
            uses.setdefault(found[1], []).append(used)
    for name, places in uses.items():
        meant = sorted(each for each in wanted if is_slip(name, each))
        if len(meant) != 1 or _is_known(tree, package, name):
            continue
        first = places[0].place
        yield Diagnostic(
            code,
            f"no package `{name}` is known",
            Span(first.span.start, first.span.start + len(name)),
            package.folder / first.file,
            help=f"did you mean `{meant[0]}`?",
            labels=tuple(_elsewhere(package, places)),
        )


def _is_known(tree: SourceTree, package: PackageFacts, name: str) -> bool:
    """Tell whether a package, or a module or a folder of headers of one, is called so."""
    version = package.ros_versions[0]
    return (
        is_package(tree, package, name)
        or key_of_module(name, version, ()) is not None
        or key_of_header(name, version, ()) is not None
        or _is_own_module(tree, name)
    )


def _is_own_module(tree: SourceTree, name: str) -> bool:
    """Tell whether a module, or a folder of headers, of the workspace is called so."""
    return any(name in build.modules | build.folders for _, build in _built(tree))


def _or_out(tree: SourceTree, name: str, uses: list[Used]) -> str:
    """Return what to do instead where nothing uses what is imported or included."""
    if not all(each.is_idle for each in uses) or not _has_only_types(name, tree):
        return ""
    lines = sum(1 + len(each.others) for each in uses)
    word = "import" if uses[0].need == "exec" else "include"
    return f", or take the {word}{'s' * (lines > 1)} out: nothing uses what comes with it"


def _elsewhere(package: PackageFacts, uses: list[Used]) -> Iterator[Label]:
    """Return the first use of a package in each further file, a few of them."""
    places = [place for each in uses for place in (each.place, *each.others)]
    first = {each.file: each for each in reversed(places)}
    first.pop(places[0].file)
    others = [(package.folder / each.file, each.span) for each in reversed(first.values())]
    return first_labels(others, "used here too")


def _built(tree: SourceTree) -> Iterator[tuple[PackageFacts, BuildFacts]]:
    for package in tree.packages.values():
        if package.build is not None:
            yield package, package.build


def _package_of(
    used: Used, package: PackageFacts, known: frozenset[str], own: frozenset[str]
) -> str | None:
    """Return the package of ROS that something is of, None where that is not known."""
    if used.package:
        return used.package if used.package in known else None
    version = package.ros_versions[0]
    find = package_of_module if used.need == "exec" else package_of_header
    return find(used.what, version, known | own)


def _own(tree: SourceTree) -> tuple[frozenset[str], frozenset[str]]:
    """Return the packages of a workspace that have headers, and those that have modules."""
    built = list(_built(tree))
    return (
        frozenset(package.name for package, build in built if build.has_headers),
        frozenset(package.name for package, build in built if package.name in build.modules),
    )


def _counts(name: str, build: BuildFacts, types: frozenset[str], tree: SourceTree) -> bool:
    """Tell whether a package is one that everybody is to declare, and that nobody hands on."""
    if name in tree.packages or name in LIBRARIES:
        return True
    if name in _FURTHER:
        start = name.partition("_")[0].rstrip("2")
        return not any(each.name.startswith(start) for each in build.dependencies)
    # Who has CMake look for one that is handed on means to name it.
    return name in types and (name not in _HANDED_ON or name in build.found)


def _is_of_another(used: Used, build: BuildFacts, tree: SourceTree) -> bool:
    """Tell whether a header may be of a package that is depended on, in a folder of this name."""
    folder = used.what.partition("/")[0]
    others = (
        tree.packages.get(each.name)
        for each in build.dependencies
        if "build" in each.covers and each.name != folder
    )
    return used.need == "build" and any(
        each is not None and each.build is not None and folder in each.build.folders
        for each in others
    )


def _undeclared(name: str, used: Used, declared: list[Declared], version: int) -> str:
    if not declared:
        return f"`{name}` is used here, and package.xml does not depend on it"
    first = declared[0]
    if first.name != name:
        how = "names it in a tag of several" if " " in first.name else f"says `{first.name}`"
        return f"`{name}` is used here, and package.xml {how}"
    if not any(version in each.versions for each in declared):
        return f"`{name}` is used here, and package.xml has it for ROS {first.versions[0]} alone"
    when = "when it runs" if used.need == "exec" else "to be built"
    return f"`{name}` is used here {when}, and package.xml has it as `<{first.tag}>` alone"


@rule(
    "RK502",
    "unused-dependency",
    "A package.xml depends on a package of types that nothing in the package names.",
    severity=Severity.WARNING,
    why="Whoever installs or builds the package gets the other one for nothing. It is told of "
    "packages that have types and nothing else, where no file of the package has the name: no "
    "code, launch file, configuration or definition, nor a slip of it; what CMake hands on to "
    "others counts as used. Of a package without code it is told where it has definitions of "
    "types.",
    bad=NODE_PACKAGE
    | {"demo/package.xml": package_xml("demo", exec_depend=["rclpy", "std_msgs", "sensor_msgs"])},
    good=NODE_PACKAGE,
)
def unused_dependency(tree: SourceTree, code: Code) -> Iterator[Diagnostic]:
    """Find packages of types that package.xml names and nothing else."""
    known = cache(lambda version: packages_of_types(tree, version))
    for package, build in _built(tree):
        # What `ament_auto_package` hands on matters to those who include a header alone.
        has_headers = build.has_headers or has_types(package)
        if not (build.has_code or has_types(package)) or ("*" in build.exported and has_headers):
            continue
        told: set[str] = set()
        is_empty = is_umbrella(tree, package)
        left_out = {"doc_depend", *(() if build.has_code else ("test_depend",))}
        used = build.mentioned | build.exported | build.linked
        if has_types(package):
            used |= _BROUGHT
        for each in build.dependencies:
            name = each.name
            is_used = name in used or (is_empty and name in tree.packages)
            if is_used or name in told or not each.is_plain or each.tag in left_out:
                continue
            if name not in known(package.ros_versions[0]) or not _has_only_types(name, tree):
                continue
            near = (x for x in build.near if is_slip(x, name))
            if _belongs_with(name, package.name) or not all(
                _is_known(tree, package, x) for x in near
            ):
                continue
            told.add(name)
            yield Diagnostic(
                code,
                f"nothing in this package uses `{name}`",
                each.span,
                package.folder / "package.xml",
                help=_to_take_out(name, build),
                labels=_looked_for(name, build, package),
                fix=_without(each, build) if name not in build.found else None,
            )


def _to_take_out(name: str, build: BuildFacts) -> str:
    tags = [each.tag for each in build.dependencies if each.name == name]
    lines = f"all {len(tags)} lines of it" if len(tags) > 1 else "the dependency"
    if name not in build.found:
        return f"take {lines} out"
    return f"take {lines} out of package.xml, and `{name}` out of CMakeLists.txt"


def _looked_for(name: str, build: BuildFacts, package: PackageFacts) -> tuple[Label, ...]:
    place = build.found.get(name)
    if place is None:
        return ()
    return (
        Label(
            place.span,
            "CMake looks for it here, and nothing uses what it finds",
            package.folder / place.file,
        ),
    )


def _belongs_with(name: str, package: str) -> bool:
    """Tell whether a package may be there to bring others along, this one among them."""
    is_one_of_them = name.partition("_")[0] == package.partition("_")[0]
    return name.startswith(f"{package}_") or (is_one_of_them and package.endswith("_bringup"))


def _has_only_types(name: str, tree: SourceTree) -> bool:
    """Tell whether a package has types, and nothing else that one may depend on it for."""
    own = tree.packages.get(name)
    if own is not None:
        return not own.executables and own.build is not None and not own.build.has_code
    return name.endswith(TYPE_ENDINGS)


def _without(declared: Declared, build: BuildFacts) -> Fix | None:
    """Return the fix that takes a dependency out, None where another tag names it, too."""
    others = [each for each in build.dependencies if each.name == declared.name]
    if len(others) > 1 or declared.line is None:
        return None
    return Fix("take the dependency out", (Edit(Span(*declared.line), ""),))
