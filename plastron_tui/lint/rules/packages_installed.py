"""Nodes that nobody can start, since they are not installed, or nobody may run them."""

from __future__ import annotations

import re
import shlex
from collections.abc import Iterator
from functools import cache
from itertools import chain

from plastron_tui.diagnostics import Code, Diagnostic, Label, Severity
from plastron_tui.lint.rule import rule
from plastron_tui.lint.tree import PackageFacts, SourceTree, UnitFacts
from plastron_tui.model.package_facts import BuildFacts, How, Place, Script, Shebang, Target
from plastron_tui.ros.launch_started import Started
from plastron_tui.ros.packages import LEFT_BEHIND

from .package_examples import NODE_PACKAGE, SCRIPT_PACKAGE, cmake_lists, setup_py
from .packages_started import is_old_or_test

_LEFT_ALONE = LEFT_BEHIND | {
    "demo", "demos", "doc", "docs", "example", "examples", "launch", "sample", "samples", "tools",
    "tutorial", "tutorials", "utils", "util",
}  # fmt: skip
"""Folders of what people start by its path, or not any more."""


_VARIANT = re.compile(
    r"(?:^|_)(?:old|original|orig|backup|bak|copy|working|wip|draft|template|deprecated|unused|"
    r"test|tmp|v?\d+|\d+\w\w)(?:_|$)"
)
"""What is in the names of files that somebody keeps beside the one that counts."""


@rule(
    "RK503",
    "node-not-installed",
    "A node is in a package, and `ros2 run` does not find it.",
    severity=Severity.WARNING,
    why="`ros2 run` and launch files look for programs in `lib/PACKAGE`, where an entry point of "
    "`setup.py`, or `install` in `CMakeLists.txt`, puts them. `setup.cfg` names that folder for "
    "entry points: below `[install]`, and below `[develop]` for `colcon build --symlink-install`. "
    "ROS 1 starts scripts and programs from the workspace as well: there it is told where other "
    "nodes of the package are installed. What another file imports or starts by its path, a "
    "script that only `python3 PATH` can run, tests and examples are left alone. A package whose "
    "name ends in `_tests` has tests alone in the folders from which it installs no program.",
    bad=NODE_PACKAGE | {"demo/setup.py": setup_py()},
    good=NODE_PACKAGE,
)
def node_not_installed(tree: SourceTree, code: Code) -> Iterator[Diagnostic]:
    """Find nodes that are nowhere where nodes are looked for."""
    started_of = {1: _started_in_use(tree), 2: _started(tree)}
    for package in tree.packages.values():
        build = package.build
        if build is None:
            continue
        started = started_of[1 if 1 in package.ros_versions else 2]
        if build.script_folder is not None:
            message, place, help_ = build.script_folder
            yield Diagnostic(code, message, place.span, package.folder / place.file, help=help_)
        for script in _missing(tree, package, build, started):
            yield from _script(code, package, build, script)
        for target in build.targets:
            yield from _target(tree, code, package, build, target, started)


def _started(tree: SourceTree) -> frozenset[tuple[str, str]]:
    """Return what launch files may start: packages, and what starts the nodes of them."""
    return frozenset((each.package, each.executable) for each in _starts(tree))


def _starts(tree: SourceTree) -> Iterator[Started]:
    at_once = (each for launch in tree.launches for each in launch.resolved.started)
    return chain(at_once, tree.unstarted, tree.unstarted_ros1)


def _started_in_use(tree: SourceTree) -> frozenset[tuple[str, str]]:
    """Return what other launch files than those of tests may start.

    In ROS 1 tests are run in the workspace, where nothing has to be installed.
    """
    packages = {each.folder for each in tree.every_package}
    files = {each.file for each in _starts(tree) if each.file is not None}
    left = {file for file in files if is_old_or_test(tree, packages, file)}
    return frozenset(
        (each.package, each.executable) for each in _starts(tree) if each.file not in left
    )


def _is_node(unit: UnitFacts | None) -> bool:
    return unit is not None and bool(unit.nodes) and not unit.is_test and not unit.is_unbuilt


def _is_left_alone(package: PackageFacts, build: BuildFacts, file: str) -> bool:
    is_for_tests = package.name.endswith(("_test", "_tests", "_testing"))
    *folders, _ = file.split("/")
    return (
        is_for_tests or any(each.lower() in _LEFT_ALONE for each in folders if each != package.name)
    ) and file.rpartition("/")[0] not in build.folders_installed()


def _missing(
    tree: SourceTree, package: PackageFacts, build: BuildFacts, started: frozenset[tuple[str, str]]
) -> Iterator[Script]:
    """Yield the scripts of nodes that are not installed where nodes are looked for."""
    is_python = build.build_type == "ament_python"
    nodes = [
        each
        for each in build.scripts
        if _is_node(tree.by_path.get(package.folder / each.file))
        and not _is_left_alone(package, build, each.file)
    ]
    left = [each for each in nodes if each.how is How.NOT and each.is_program]
    installed = [each for each in nodes if each.how in (How.PROGRAM, How.PYTHON)]
    has_installed = installed or any(each.installed and each.how is How.UNKNOWN for each in nodes)
    # ROS 1 starts what lies in the workspace: one that was left out is one among many.
    is_one_left = len(left) == 1 and len(installed) > 1
    # What is started by its path may be in any folder, and so may what lies beside it.
    by_path = {
        each.file.rpartition("/")[0]
        for each in nodes
        if each.how is How.ELSEWHERE and each.is_mentioned
    }
    for each in nodes:
        folder, _, name = each.file.rpartition("/")
        is_started = (package.name, name) in started
        if folder in by_path and not is_started:
            continue
        if each.how is How.ELSEWHERE:
            yield each
        if each.how is not How.NOT or not (each.is_program or is_python):
            continue
        if not is_started and (each.is_mentioned or (not is_python and _is_for_python(each))):
            continue
        if 1 in package.ros_versions and not (is_started and has_installed) and not is_one_left:
            continue
        if is_started or not _VARIANT.search(name.removesuffix(".py").lower()):
            yield each


def _is_for_python(script: Script) -> bool:
    """Tell whether a script is run as `python3 PATH` alone: neither mode nor first line help."""
    return script.shebang is Shebang.MISSING and not script.is_executable


def _script(
    code: Code, package: PackageFacts, build: BuildFacts, script: Script
) -> Iterator[Diagnostic]:
    path = package.folder / script.file
    name = script.file.rpartition("/")[2]
    if script.how is How.ELSEWHERE and script.installed is not None:
        yield Diagnostic(
            code,
            f"`{name}` is not installed where nodes are looked for",
            script.installed.span,
            package.folder / script.installed.file,
            help=_remedy(build, script),
            labels=(Label(script.main, "the node", path),),
        )
        return
    is_python = build.build_type == "ament_python"
    told = "no entry point starts it" if is_python else "nothing installs it"
    message = f"`ros2 run` does not find the node of `{name}`: {told}"
    if 2 not in package.ros_versions:
        message = f"nothing installs the node of `{name}`: it is found in the workspace alone"
    yield Diagnostic(
        code,
        message,
        script.main,
        path,
        help=_remedy(build, script),
        labels=_labels(package, script.installed),
    )


def _labels(package: PackageFacts, place: Place | None) -> tuple[Label, ...]:
    if place is None:
        return ()
    return (Label(place.span, "the last entry point", package.folder / place.file),)


def _remedy(build: BuildFacts, script: Script) -> str:
    file = script.file
    if build.build_type == "ament_python":
        stem = file.rpartition("/")[2].removesuffix(".py")
        folder = file.partition("/")[0]
        if folder not in build.modules and "/" in file:
            return "move it into the Python package, and add it to `console_scripts`"
        module = file.removesuffix(".py").replace("/", ".")
        entry = f"add `{stem} = {module}:main` to `console_scripts`"
        return entry if script.has_main else f"start it in a function `main`, and {entry}"
    if build.build_type == "catkin":
        return (
            f"write `catkin_install_python(PROGRAMS {file} DESTINATION "
            "${CATKIN_PACKAGE_BIN_DESTINATION})`"
        )
    return f"write `install(PROGRAMS {file} DESTINATION lib/${{PROJECT_NAME}})`"


def _target(
    tree: SourceTree,
    code: Code,
    package: PackageFacts,
    build: BuildFacts,
    target: Target,
    started: frozenset[tuple[str, str]],
) -> Iterator[Diagnostic]:
    if target.is_installed is not False:
        return
    units = [tree.by_path.get(package.folder / each) for each in target.sources]
    is_started = (package.name, target.name) in started
    if not (is_started or any(map(_is_node, units))) or any(
        _is_left_alone(package, build, each) for each in target.sources
    ):
        return
    is_first = 1 in package.ros_versions
    others = [each for each in build.targets if each.is_installed is False]
    if is_first and not (build.installs_nodes and (is_started or len(others) == 1)):
        return
    where = "lib/${PROJECT_NAME}" if not is_first else "${CATKIN_PACKAGE_BIN_DESTINATION}"
    message = f"the program `{target.name}` is built, and not installed"
    labels: tuple[Label, ...] = ()
    if target.where is not None:
        message = f"the program `{target.name}` is not installed where nodes are looked for"
        labels = (
            Label(target.where.span, "it goes elsewhere", package.folder / target.where.file),
        )
    yield Diagnostic(
        code,
        message,
        target.place.span,
        package.folder / target.place.file,
        help=f"write `install(TARGETS {target.name} DESTINATION {where})`",
        labels=labels,
    )


@rule(
    "RK504",
    "node-not-executable",
    "A script is where nodes are looked for, and the system cannot run it.",
    why="A script runs if its mode says that it may be run and its first line says by what. "
    "`install(FILES …)` and `install(DIRECTORY …)` take the permission away, and a first line that "
    "ends with the carriage return of Windows names a program that is not there. What "
    "`catkin_install_python` installs without such a line fails where it is installed. Modes are "
    "not looked at where no file of the workspace has the permission: it came without modes then.",
    bad=SCRIPT_PACKAGE
    | {
        "demo/CMakeLists.txt": cmake_lists(
            "install(FILES scripts/talker.py DESTINATION lib/${PROJECT_NAME})"
        )
    },
    good=SCRIPT_PACKAGE,
)
def node_not_executable(tree: SourceTree, code: Code) -> Iterator[Diagnostic]:
    """Find scripts that are found, and cannot be run."""
    started = _started(tree)
    has_modes = cache(
        lambda: any(
            script.is_executable
            for package in tree.packages.values()
            if package.build is not None
            for script in package.build.scripts
        )
    )
    for package in tree.packages.values():
        build = package.build
        if build is None:
            continue
        for script in build.scripts:
            path = package.folder / script.file
            is_started = (package.name, script.file.rpartition("/")[2]) in started
            if not is_started and (
                not _is_node(tree.by_path.get(path)) or _is_left_alone(package, build, script.file)
            ):
                continue
            found = _not_run(package, script, is_started, has_modes())
            if found is not None:
                message, place, help_ = found
                span = script.first if place is None else place.span
                file = path if place is None else package.folder / place.file
                # ROS 1 starts it from the workspace all the same, and not where it is installed:
                # what `catkin_install_python` installs has a script before it in the workspace.
                is_half = 1 in package.ros_versions and (
                    place is not None or script.how is How.PYTHON
                )
                severity = Severity.WARNING if is_half else None
                yield Diagnostic(code, message, span, file, help=help_, severity=severity)


_Fault = tuple[str, Place | None, str]


def _not_run(
    package: PackageFacts, script: Script, is_started: bool, has_modes: bool
) -> _Fault | None:
    """Return why a script cannot be run, where it is installed or started from the workspace."""
    name = script.file.rpartition("/")[2]
    is_first = 1 in package.ros_versions
    if is_first and _has_twin(package, script):
        return None
    if script.how is How.PLAIN and script.is_program:
        help_ = "install it with `install(PROGRAMS …)`"
        return f"`{name}` is installed as a file that nobody may run", script.installed, help_
    has_mode = script.is_executable or not has_modes
    how = f"run `chmod +x {shlex.quote(script.file)}`"
    if script.how is How.KEPT and not has_mode and (script.is_program or is_started):
        return f"`{name}` is not executable, and so nothing starts it", None, how
    if is_first and not has_mode and script.how in (How.NOT, How.PLAIN, How.PROGRAM):
        is_meant = script.is_program and script.shebang is Shebang.GOOD and script.how is How.NOT
        if is_started or (is_meant and not script.is_mentioned and _has_runnable(package, script)):
            return f"`{name}` is not executable, and so nothing starts it", None, how
    is_found = script.how in (How.PROGRAM, How.PYTHON, How.KEPT) and script.is_program
    if not is_found and not (is_first and is_started):
        return None
    if script.shebang is Shebang.MISSING:
        help_ = "begin it with `#!/usr/bin/env python3`"
        return f"the first line of `{name}` does not say what runs it", None, help_
    if script.shebang is Shebang.CARRIAGE_RETURN:
        message = f"the first line of `{name}` ends with a carriage return, so nothing runs it"
        if script.how is How.PYTHON:
            message += " where it is installed"
        return message, None, "write the file with the line ends of Linux"
    return None


def _has_twin(package: PackageFacts, script: Script) -> bool:
    """Tell whether another script of the name can be run, which `rosrun` takes then."""
    name = script.file.rpartition("/")[2]
    return any(
        each.is_executable and each is not script and each.file.rpartition("/")[2] == name
        for each in (() if package.build is None else package.build.scripts)
    )


def _has_runnable(package: PackageFacts, script: Script) -> bool:
    """Tell whether another script of the folder can be run, and so this one was forgotten."""
    folder = script.file.rpartition("/")[0]
    scripts = () if package.build is None else package.build.scripts
    if _VARIANT.search(script.file.rpartition("/")[2].removesuffix(".py").lower()):
        return False
    return any(each.is_executable and each.file.rpartition("/")[0] == folder for each in scripts)
