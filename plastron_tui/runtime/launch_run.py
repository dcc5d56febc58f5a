"""What a launch file starts, as processes: `plastron run` of one, without its command line."""

from __future__ import annotations

import os
import shlex
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import NamedTuple

from plastron_tui.diagnostics import Diagnostic, Severity, Span, codes, did_you_mean
from plastron_tui.import_path import command
from plastron_tui.ros.installations import Origin
from plastron_tui.ros.launch import LaunchFile, Place, loaded_nodelet
from plastron_tui.ros.launch_resolution import resolve
from plastron_tui.ros.launch_started import SHOWN, Opened, Resolved, Started
from plastron_tui.ros.launch_text import Scope
from plastron_tui.ros.parameter_values import yaml_text
from plastron_tui.sources.launch.reader import file_content, open_included
from plastron_tui.sources.launch.unresolved import wrong_arguments

from .build_output import Progress
from .environment import Environment, missing_package, missing_packages
from .installing import of_distribution
from .launch import Loaded, NodeFile
from .launch_packages import Packages, find_packages
from .robot_commands import XACRO, RobotCommands
from .source_interfaces import with_built

_ARGUMENTS = ("args", "ros_args")

_TIMES = ("--sigint-timeout=1.0", "--sigterm-timeout=0.5")
"""How long roslaunch waits for nodes: it has ended them before it is ended itself."""


class Prepared(NamedTuple):
    """The processes of a launch file; none where something keeps it from being started."""

    nodes: tuple[NodeFile, ...]
    diagnostics: tuple[Diagnostic, ...] = ()


def prepare(
    launch: LaunchFile,
    file: Path,
    arguments: Mapping[str, str],
    environment: Environment,
    environ: Mapping[str, str] = os.environ,
    tell: Callable[[Progress], object] = lambda _: None,
) -> Prepared:
    """Return what a launch file starts, or why it is not started: with the line that says it.

    Args:
        launch: what the file says.
        file: the file.
        arguments: the values that its arguments get.
        environment: the ROS that it runs with.
        environ: the environment variables.
        tell: is told how far a build of interface packages is.
    """
    file = Path.cwd() / file
    packages = find_packages(file, environment, environ)
    robots = None if environment.ros_version == 1 else RobotCommands(packages.has, environ)
    resolved = _resolved(
        launch, file, arguments, environment.ros_version, packages, environ, robots
    )
    if environment.ros_version == 1:
        # roslaunch tells the rest itself, but follows files that include each other without end.
        wrong = [each for each in resolved.unresolved if each.is_wrong]
        if wrong:
            return Prepared((), tuple(_told(each.message, each.file, each.place) for each in wrong))
        prepared = _roslaunch(file, arguments, environment, packages, resolved)
        if not prepared.nodes:
            return prepared
        return _built(prepared.nodes[0], packages, resolved, environment, tell, environ)
    found = [*wrong_arguments(launch, file, arguments)]
    for each in resolved.unresolved:
        help_ = None if robots is None or XACRO not in each.message else robots.problem or None
        found.append(_told(each.message, each.file, each.place)._replace(help=help_))
    if not resolved.started and not found:
        found.append(_told("the launch file starts no node", str(file), None))
    nodes, problems = _nodes(resolved.started, environment, packages)
    found += problems
    if any(each.severity is Severity.ERROR for each in found):
        return Prepared((), tuple(found))
    started = [each.package for each in resolved.started]
    built, problems = with_built(environment, packages.sources, started, tell, environ)
    if not problems:
        # What is built is known by its name alone before.
        nodes, problems = _nodes(resolved.started, built, packages.with_overlays(built.overlays))
    return Prepared(() if problems else tuple(nodes), (*found, *problems))


def _nodes(
    started: Sequence[Started], environment: Environment, packages: Packages
) -> tuple[list[NodeFile], list[Diagnostic]]:
    """Return the processes of nodes, components with their containers, and why others are none."""
    found: list[Diagnostic] = []
    nodes: dict[str | None, NodeFile] = {}
    for at, each in enumerate(started):
        if each.container is None:
            made = _node(each, environment, packages)
            if isinstance(made, Diagnostic):
                found.append(made)
            else:
                nodes[each.full_name or f"{at}"] = made
    containers = {each.full_name for each in started if each.container is None}
    for each in started:
        if each.container is None:
            continue
        container = nodes.get(each.container)
        if each.container not in containers:
            message = f"`{each.executable}` is a component, and the file does not start "
            message += f"its container `{each.container}`"
            help_ = "a component is C++ code that its container loads: start both in one file, "
            help_ += "or this one with `ros2 launch`"
            found.append(_told(message, each.file, each.place)._replace(help=help_))
        elif each.files or each.others:
            what = "a parameter file" if each.files else f"`{each.others[0][0]}`"
            message = f"`run` loads no component with {what}: start the file with `ros2 launch`"
            found.append(_told(message, each.file, each.place))
        elif container is not None:
            name = each.name or each.executable.rpartition("::")[2]
            arguments = ros_arguments_of(each)
            load = Loaded(name, each.package, each.executable, arguments)
            nodes[each.container] = replace(container, loads=(*container.loads, load))
    # A container finds the libraries of components by the index of their packages.
    index = tuple(("AMENT_PREFIX_PATH", each) for each in environment.overlays)
    for full_name, node in nodes.items():
        if node.loads:
            nodes[full_name] = replace(node, folders=(*index, *node.folders))
    return list(nodes.values()), found


def _built(
    node: NodeFile,
    packages: Packages,
    resolved: Resolved,
    environment: Environment,
    tell: Callable[[Progress], object],
    environ: Mapping[str, str],
) -> Prepared:
    """Return the process of roslaunch that finds the packages which its nodes need built."""
    started = [each.package for each in resolved.started]
    started += (name for each in resolved.started for name in _loaded_by(each))
    built, problems = with_built(environment, packages.sources, started, tell, environ)
    folders = tuple(("CMAKE_PREFIX_PATH", each) for each in built.overlays)
    node = replace(node, environment=built, folders=(*node.folders, *folders))
    return Prepared(() if problems else (node,), tuple(problems))


def _loaded_by(started: Started) -> Iterator[str]:
    """Yield the package of the nodelet that a node loads."""
    for key, value in started.others:
        loaded = loaded_nodelet(started.package, value) if key == "args" else None
        if loaded is not None:
            yield loaded.partition("/")[0]


def _resolved(
    launch: LaunchFile,
    file: Path,
    arguments: Mapping[str, str],
    ros_version: int,
    packages: Packages,
    environ: Mapping[str, str],
    robots: RobotCommands | None,
) -> Resolved:
    def beyond(file: Path) -> str:
        return "" if packages.has(file) else "it is neither in the project nor installed"

    def content(path: str) -> str | None:
        return file_content(path, beyond)

    scope = Scope(arguments, environ, str(file.parent), packages.share, content)
    if robots is not None:
        scope = replace(scope, run_command=robots)

    def opened(path: str) -> Opened:
        return open_included(Path(path), beyond)

    return resolve(launch, ros_version, scope, str(file), opened)


def _installed_by(package: str, environment: Environment) -> str | None:
    """Say how a package that a launch file starts nodes of gets there, if it is one of ROS."""
    if environment.origin is Origin.EXTRA:
        return f"{environment.words} has no such nodes: source a whole ROS 2"
    command = of_distribution(package, environment.distribution)
    return None if command is None else f"if it is one of ROS, `{command}` installs it"


def _node(started: Started, environment: Environment, packages: Packages) -> NodeFile | Diagnostic:
    """Return the process of a node, or why it cannot be started."""

    def wrong(message: str, help_: str | None = None) -> Diagnostic:
        return _told(message, started.file, started.place)._replace(help=help_)

    label = f"{started.package}/{started.executable}"
    executable = packages.executable(started.package, started.executable, environment.python)
    if executable is None:
        if packages.share(started.package) is None:
            near = did_you_mean(started.package, packages.sources)
            remedy = near or _installed_by(started.package, environment)
            return wrong(f"the package `{started.package}` is not found", remedy)
        known = packages.names(started.package, environment.python)
        message = f"the package `{started.package}` has no executable `{started.executable}`"
        return wrong(message, did_you_mean(started.executable, known))
    words: list[str] = []
    folders = executable.folders
    for key, value in started.others:
        if key in _ARGUMENTS:
            try:
                words += shlex.split(value)
            except ValueError:
                return wrong(f"`{key}` has a quote that is not closed")
        elif key not in SHOWN and not (key == "respawn" and value.lower() in ("false", "0")):
            return wrong(f"`run` does not do what `{key}` asks for")
    missing = next((each for each in started.files if not Path(each).is_file()), None)
    if missing is not None:
        return wrong(f"the parameter file `{missing}` is not found")
    return NodeFile(
        started.name or started.executable,
        executable.command,
        environment,
        arguments=(*words, *ros_arguments_of(started)),
        namespace=started.namespace,
        folders=folders,
        label=label if started.full_name is None else started.full_name.removeprefix("/"),
    )


def ros_arguments_of(started: Started) -> tuple[str, ...]:
    """Return the arguments that give a node of ROS 2 its names and parameters.

    Of two values for a parameter the later one holds: `launch_ros` passes values and files in the
    order in which they are written, too.
    """
    found: list[str] = []
    if started.name is not None:
        found += ("-r", f"__node:={started.name}")
    if started.namespace:
        found += ("-r", f"__ns:={started.namespace}")
    for old, new in started.remaps:
        found += ("-r", f"{old}:={new}")
    for each in started.settings:
        if isinstance(each, str):
            found += ("--params-file", each)
        else:
            found += ("-p", f"{each[0]}:={yaml_text(each[1])}")
    return ("--ros-args", *found) if found else ()


def _roslaunch(
    file: Path,
    arguments: Mapping[str, str],
    environment: Environment,
    packages: Packages,
    resolved: Resolved,
) -> Prepared:
    """Return the process of roslaunch, which reads the file itself."""
    if missing_packages(environment, ["roslaunch"]):
        return Prepared((), (missing_package(environment, "roslaunch"),))
    start = command("roslaunch:main", str(environment.python))
    given = (f"{name}:={value}" for name, value in arguments.items())
    # Nodes begin with `#!/usr/bin/env python3` as a rule, which has to be the one with rospy.
    folders = [("ROS_PACKAGE_PATH", packages.root), ("PATH", environment.python.parent)]
    folders += (("PYTHONPATH", each / "src") for each in packages.sources.values()
                if (each / "setup.py").is_file() and (each / "src").is_dir())  # fmt: skip
    node = NodeFile(
        "roslaunch",
        (*start, *_TIMES, "--disable-title", str(file), *given),
        environment,
        folders=tuple(folders),
        starts=tuple(each.full_name for each in resolved.started if each.full_name is not None),
    )
    return Prepared((node,))


def _told(message: str, file: str | None, place: Place | None) -> Diagnostic:
    span = None if place is None else Span(place.start, place.end)
    path = None if file is None else Path(file)
    return Diagnostic(codes.UNRESOLVED_LAUNCH, message, span, path)
