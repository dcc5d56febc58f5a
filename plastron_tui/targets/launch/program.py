"""From what a program says of a launch file to what the file is to say."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

from plastron_tui.model.kinds import Parameter as NodeParameter
from plastron_tui.model.launches import Launch, Start
from plastron_tui.model.workspace import Node
from plastron_tui.ros.launch import (
    Argument,
    Container,
    Include,
    Item,
    LaunchFile,
    Parameter,
    ParameterFile,
    ParameterValue,
    Remapping,
    StartedNode,
)
from plastron_tui.ros.launch_text import Substitution, Text, package_file, text, with_arguments
from plastron_tui.ros.names import name_as_written, parameter_name
from plastron_tui.ros.parameter_values import yaml_text
from plastron_tui.ros.parameters import ParameterType, Setting, as_setting


class ExecutableName(NamedTuple):
    """What a node of the program is started by: its package, and its name there.

    Attributes:
        package: the package.
        name: the executable; "" for a node that has none.
        plugin: what another process loads it by, "" for a node that none loads.
    """

    package: str
    name: str
    plugin: str = ""


_NODELET = "nodelet"

FindExecutable = Callable[[Node], ExecutableName]


class Request(NamedTuple):
    """What a program says of a launch file.

    Attributes:
        added: what it is to say besides, by the names that programs have for it.
        removed: names of arguments, of nodes and of included files that are to go.
    """

    added: LaunchFile
    removed: tuple[tuple[type[Item], str], ...] = ()


def request_of(launch: Launch, ros_version: int, find: FindExecutable) -> Request:
    """Return what a program says of a launch file.

    Args:
        launch: the launch file of the program.
        ros_version: the generation of ROS that it is for.
        find: tells which package a node of the program is in.
    """
    arguments: list[Item] = [
        Argument(each.name, None if each.default is None else text(_plain(each.default)))
        for each in launch.arguments.values()
    ]
    includes: list[Item] = [
        Include(package_file(each.package, each.path)) for each in launch.includes.values()
    ]
    items = (*arguments, *includes, *_started(launch, ros_version, find))
    removed = (
        *((Argument, name) for name in launch.removed_arguments),
        *((StartedNode, name) for name in launch.removed_starts),
        *((Include, name) for name in launch.removed_includes),
    )
    return Request(LaunchFile(items), removed)


def _started(launch: Launch, ros_version: int, find: FindExecutable) -> list[Item]:
    """Return what is started; nodes of a container stand in it, where the first of them does."""
    found: list[Item] = []
    containers: dict[str, int] = {}
    for start in launch.starts.values():
        node = _node(start, ros_version, find)
        if start.container is None:
            found.append(node)
        elif ros_version == 1:
            if start.container not in containers:
                found.append(_manager(start.container))
            containers.setdefault(start.container, len(found))
            found.append(node)
        elif start.container in containers:
            at = containers[start.container]
            held = found[at]
            assert isinstance(held, Container)
            found[at] = Container(held.node, held.target, (*held.components, node))
        else:
            containers[start.container] = len(found)
            found.append(Container(_container(start.container), None, (node,)))
    return found


def _manager(name: str) -> StartedNode:
    """Return what loads nodelets into its process (the wiki page "nodelet")."""
    namespace, _, base = name.strip("/").rpartition("/")
    return StartedNode(
        text(_NODELET),
        text(_NODELET),
        text(base),
        text(namespace) if namespace else None,
        others=(("args", text("manager")), ("output", text("screen"))),
    )


def _container(name: str) -> StartedNode:
    namespace, _, base = name.rpartition("/")
    return StartedNode(
        text("rclcpp_components"),
        text("component_container"),
        text(base),
        text(namespace) if namespace else None,
    )


def _node(start: Start, ros_version: int, find: FindExecutable) -> StartedNode:
    own = (
        ExecutableName(start.package, start.executable) if start.node is None else find(start.node)
    )
    # roslaunch wants a name, and a component has one of its own only in code.
    name = start.name
    if name is None and (ros_version == 1 or start.node is not None or start.container):
        name = start.run_name
    parameters: list[Parameter] = []
    if start.parameters is not None:
        file = start.parameters
        parameters.append(ParameterFile(package_file(file.package, file.inner)))
    parameters += [_parameter(start, key, value, ros_version) for key, value in start.settings]
    package, executable = own.package, own.name
    screen = ("output", text("screen"))
    others: tuple[tuple[str, Text], ...] = () if start.container is not None else (screen,)
    if own.plugin and ros_version == 1:
        package = executable = _NODELET
        words = f"standalone {own.plugin}"
        if start.container is not None:
            words = f"load {own.plugin} /{start.container.strip('/')}"
        others = (("args", text(words)), screen)
    elif own.plugin and start.container is not None:
        executable = own.plugin
    return StartedNode(
        text(package),
        text(executable),
        with_arguments(name) if name is not None else None,
        with_arguments(start.namespace) if start.namespace is not None else None,
        tuple(
            Remapping(
                text(name_as_written(old, ros_version)),
                with_arguments(name_as_written(new, ros_version)),
            )
            for old, new in start.remaps
        ),
        tuple(parameters),
        others,
    )


def _parameter(start: Start, name: str, value: Setting, ros_version: int) -> ParameterValue:
    """Return a parameter, of the type that the node declares for it."""
    holds = None
    if start.node is not None:
        known = start.node.of(NodeParameter).get(parameter_name(name, ros_version))
        holds = None if known is None else known.holds
    found = with_arguments(value) if isinstance(value, str) else text()
    if any(isinstance(part, Substitution) for part in found.parts):
        # rclpy refuses an integer for a float, and YAML reads 1 as one.
        is_float = holds is ParameterType.FLOAT
        return ParameterValue(text(name), found, holds is ParameterType.STRING, is_float)
    fitting = None if holds is None else as_setting(holds, value)
    return ParameterValue(text(name), value if fitting is None else fitting)


def _plain(value: Setting) -> str:
    return value if isinstance(value, str) else yaml_text(value)
