"""Names of programs that lead nowhere: of entry points, and of launch files."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator
from itertools import takewhile
from pathlib import Path
from typing import NamedTuple

from plastron_tui.diagnostics import Code, Diagnostic, Label, Span, write
from plastron_tui.diagnostics.suggest import nearest
from plastron_tui.lint.further_places import first_labels
from plastron_tui.lint.rule import rule
from plastron_tui.lint.runs import span_of
from plastron_tui.lint.tree import PackageFacts, SourceTree, StartedPlace
from plastron_tui.model.package_facts import BuildFacts
from plastron_tui.ros.launch_started import Started
from plastron_tui.ros.name_slips import is_slip
from plastron_tui.ros.packages import LEFT_BEHIND, is_test_folder

from .package_examples import NODE_PACKAGE, setup_py

_LAUNCH = '<launch>\n  <node pkg="demo" exec="{}"/>\n</launch>\n'


@rule(
    "RK505",
    "entry-point-to-nothing",
    "A console script names a module or a function that is not there.",
    why="The package installs, and `ros2 run` ends with an ImportError. A module that is in no "
    "package of `packages` is not installed either. Where names are computed, or a module takes "
    "all of another one, nothing is told.",
    bad=NODE_PACKAGE | {"demo/setup.py": setup_py("talker = demo.talker:mian")},
    good=NODE_PACKAGE,
)
def entry_point_to_nothing(tree: SourceTree, code: Code) -> Iterator[Diagnostic]:
    """Find console scripts without a function."""
    for package in tree.packages.values():
        for each in () if package.build is None else package.build.entries:
            yield Diagnostic(
                code,
                f"`{each.name}` starts nothing: {each.message}",
                each.place.span,
                package.folder / each.place.file,
                help=f"did you mean `{each.remedy}`?" if each.remedy else each.help or None,
                fix=write(each.remedy, each.place.span) if each.is_sure else None,
            )


@rule(
    "RK506",
    "launch-of-nothing",
    "A launch file starts a program that its package does not have.",
    why="The launch ends with an error, or goes on without that node. It is told whatever the "
    "conditions around the node say, of packages of the workspace whose programs are all known, "
    "and of components in a container; what `CMakeLists.txt` makes in a way that is not "
    "followed, packages that are not in the workspace, and the workspace of another "
    "`machine`, may have any program. What tests start, and what lies in folders such as "
    "`old`, is left alone.",
    bad=NODE_PACKAGE | {"demo/launch/demo.launch.xml": _LAUNCH.format("taker")},
    good=NODE_PACKAGE | {"demo/launch/demo.launch.xml": _LAUNCH.format("talker")},
)
def launch_of_nothing(tree: SourceTree, code: Code) -> Iterator[Diagnostic]:
    """Find nodes of launch files that no package has."""
    found: dict[tuple[str, _Fault], dict[str, tuple[Span, Span | None]]] = {}
    packages = {each.folder for each in tree.every_package}
    for started, version in _starts(tree):
        place = started.place
        if place is None or started.file is None:
            continue
        fault = _fault(tree, started, version)
        if fault is None or is_old_or_test(tree, packages, started.file):
            continue
        # A name that was mistyped is mended in each file, a program that is not made once.
        places = found.setdefault((started.file if fault.near else "", fault), {})
        known = tree.started_places.get(StartedPlace(started.file, place.start, fault.word))
        places.setdefault(started.file, (known or span_of(place), known))
    for (_, fault), places in found.items():
        (file, (span, known)), *others = places.items()
        is_sure = known is not None and is_slip(fault.word, fault.near)
        yield Diagnostic(
            code,
            fault.message,
            span,
            Path(file),
            help=f"did you mean `{fault.near}`?" if fault.near else fault.help or None,
            labels=(
                *fault.labels,
                *first_labels(
                    [(Path(each), at) for each, (at, _) in others], "it is started here too"
                ),
            ),
            fix=write(fault.near, known) if known is not None and is_sure else None,
        )


def _starts(tree: SourceTree) -> Iterator[tuple[Started, int]]:
    """Yield what launch files start, also where their arguments are others, for which ROS."""
    for launch in tree.launches:
        yield from ((each, launch.ros_version) for each in launch.resolved.started)
    yield from ((each, 2) for each in tree.unstarted)
    # Values that hang on other conditions may never come together.
    whole = (each for each in tree.unstarted_ros1 if each.package_span and each.executable_span)
    yield from ((each, 1) for each in whole)


def is_old_or_test(tree: SourceTree, packages: Collection[Path], file: str) -> bool:
    """Tell whether a launch file is left behind, or for tests: they may start what they build."""
    folders = [each for each in Path(file).parents if tree.root in each.parents]
    if any(
        each.name == "deprecated" or is_test_folder(each.name, is_package=each in packages)
        for each in folders
    ):
        return True
    inner = takewhile(lambda each: each not in packages, folders)
    return any(each.name.lower() in LEFT_BEHIND for each in inner)


class _Fault(NamedTuple):
    """What a launch file asks for in vain.

    Attributes:
        message: what is wrong.
        word: the name that nothing has.
        near: the name that may be meant, "" for none.
        help: what to do about it, where no other name is meant.
        labels: what explains it.
    """

    message: str
    word: str
    near: str
    help: str = ""
    labels: tuple[Label, ...] = ()


def _fault(tree: SourceTree, started: Started, version: int) -> _Fault | None:
    package = tree.package(started.package, started.file)
    name = started.executable
    if "machine" in dict(started.others):
        # Another computer looks for it in a workspace of its own.
        return None
    if package is None:
        if started.package in tree.packages:
            return None
        meant = [
            each.name
            for each in tree.packages.values()
            if is_slip(each.name, started.package) and name in each.executables
        ]
        if len(meant) != 1:
            return None
        message = (
            f"no package `{started.package}` is in this workspace, and `{meant[0]}` has `{name}`"
        )
        return _Fault(message, started.package, meant[0])
    build = package.build
    if started.container is not None:
        return None if build is None else _component_fault(build, package, name)
    # A launch file of ROS 1 beside a package of ROS 2 was left there when it was ported.
    if version not in package.ros_versions or build is None or _may_have(package, build, name):
        return None
    broken = {each.name for each in build.entries}
    whole = [each for each in package.executables if each not in broken]
    near = _slip(name, whole) or _longer(name, whole)
    if version == 1 and f"{name}.py" in build.files:
        near = f"{name}.py"
    message = f"`{package.name}` has no program `{name}`"
    if included := _launch_file(tree, package, name):
        return _Fault(message, name, "", included)
    return _Fault(message, name, near, _left(build, name))


def _launch_file(tree: SourceTree, package: PackageFacts, name: str) -> str:
    """Return what to do with a launch file of a package that is started as if it were a program."""
    for launch in tree.launches:
        if launch.path.name == name and launch.path.is_relative_to(package.folder):
            return f"`{name}` is a launch file: include it, in place of starting it"
    return ""


def _longer(name: str, names: Iterable[str]) -> str:
    """Return the one name that has all the words of another one, in a row: `teleop_node`."""
    own = f"_{name.removesuffix('.py')}_"
    found = [each for each in names if own in f"_{each.removesuffix('.py')}_"]
    return found[0] if len(found) == 1 else ""


def _slip(name: str, names: Iterable[str]) -> str:
    """Return the name that a slip of the finger tells from another one, "" for none."""
    found = nearest(name, names) or ""
    if found.removesuffix(".py") == name.removesuffix(".py") or is_slip(name, found):
        return found
    return ""


def _left(build: BuildFacts, name: str) -> str:
    """Return what to do with a source of the name of a program that nothing makes of it."""
    stem = name.removesuffix(".py")
    found = next((x for x in (f"{stem}.cpp", f"{stem}.py") if x in build.files), None)
    if found is None:
        return ""
    file = "`setup.py`" if build.build_type == "ament_python" else "`CMakeLists.txt`"
    return f"`{found}` is there, and {file} makes no program of it"


def _component_fault(build: BuildFacts, package: PackageFacts, name: str) -> _Fault | None:
    """Return what is wrong with a component: no class of the package is registered as that."""
    if not build.components or name in build.components or "::" not in name:
        return None
    message = f"`{package.name}` registers no component `{name}`"
    labels = tuple(
        Label(each.span, f"`{twice}` is registered again here", package.folder / each.file)
        for twice, each in build.registered_again
    )
    help_ = f"register it in CMakeLists.txt{', in place of what is there twice' if labels else ''}"
    return _Fault(message, name, _slip(name, build.components), help_, labels)


def _may_have(package: PackageFacts, build: BuildFacts, name: str) -> bool:
    """Tell whether a package may have a program, as far as it is known."""
    known = {*package.executables, *build.placed, *(each.name for each in build.targets)}
    if name in known:
        return True
    if any(not each.isprintable() or each in "$ /" for each in name) or not name:
        return True
    if 1 in package.ros_versions and name in build.files:
        return True
    if build.is_settled:
        return False
    if build.words is None:
        return True
    return any(name == word or (word and word in name) for word in build.words)
