"""The command line by which a node gets its names and parameters.

Sources: the ROS wiki page "Remapping Arguments"; the ROS 2 design article "ROS Command Line
Arguments".
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from plastron_tui.ros.names import name_as_written
from plastron_tui.ros.parameter_values import yaml_text
from plastron_tui.ros.parameters import Setting
from plastron_tui.ros.run_names import RunNames


def ros_arguments(
    ros_version: int, names: RunNames, parameters: Mapping[str, Setting]
) -> tuple[str, ...]:
    """Return the arguments of a node; none where nothing is said.

    They hold for all nodes of the process: neither ROS 1 nor the parameters of a ROS 2 node in a
    namespace can be told by the node's name there.
    """
    found = tuple((_ros1 if ros_version == 1 else _ros2)(names, parameters))
    return ("--ros-args", *found) if found and ros_version == 2 else found


def _ros1(names: RunNames, parameters: Mapping[str, Setting]) -> Iterator[str]:
    for remap in names.remaps:
        yield f"{name_as_written(remap.old, 1)}:={name_as_written(remap.new, 1)}"
    if names.namespace is not None:
        yield f"__ns:={names.namespace or '/'}"
    for name, value in parameters.items():
        yield f"_{name.replace('.', '/')}:={yaml_text(value)}"


def _ros2(names: RunNames, parameters: Mapping[str, Setting]) -> Iterator[str]:
    for remap in names.remaps:
        yield from ("-r", f"{remap.old}:={remap.new}")
    if names.namespace is not None:
        yield from ("-r", f"__ns:={names.namespace or '/'}")
    for name, value in parameters.items():
        yield from ("-p", f"{name}:={yaml_text(value)}")
