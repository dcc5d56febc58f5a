"""What a package depends on, and in which way; the tags are those of REP 149."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import NamedTuple

from plastron_tui.diagnostics import Diagnostic
from plastron_tui.ros.interfaces import InterfaceKind

from .needs import needs_of
from .spec import BuildType, PackageSpec


class Dependency(NamedTuple):
    """A tag of `package.xml` and the package or rosdep key in it."""

    tag: str
    key: str


def dependencies_of(spec: PackageSpec) -> tuple[tuple[Dependency, ...], tuple[Diagnostic, ...]]:
    """Return what a package depends on, in the order of its `package.xml`, and what is not known.

    What only runs is an `exec_depend`; what is built with others is that of who uses them too.
    """
    run, built, diagnostics = _named(spec)
    for launch in spec.launches:
        run |= launch.needs
    if spec.launches:
        # ROS 2 documentation, "Integrating launch files into ROS 2 packages".
        run.add("roslaunch" if spec.ros_version == 1 else "ros2launch")
    found = [Dependency("buildtool_depend", tool) for tool in _BUILD_TOOLS[spec.builds]]
    if spec.builds_types:
        found.append(Dependency("buildtool_depend", "rosidl_default_generators"))
        built |= needs_of_definitions(spec)
        run.add("rosidl_default_runtime")
    if spec.ros_version == 1 and spec.definitions:
        # The wiki page "catkin/package.xml", and the package message_generation.
        found.append(Dependency("build_depend", "message_generation"))
        built |= needs_of_definitions(spec)
        run.add("message_runtime")
    found += [Dependency("depend", key) for key in sorted(built - {spec.name})]
    found += [Dependency("exec_depend", key) for key in sorted(run - built - {spec.name})]
    found += [Dependency("test_depend", key) for key in sorted(_for_tests(spec) - {spec.name})]
    return tuple(found), diagnostics


def needs_of_definitions(spec: PackageSpec) -> frozenset[str]:
    """Return the packages that the types of a package are made of."""
    needed = {package for each in spec.definitions for package in each.needs}
    if any(each.kind is InterfaceKind.ACTION for each in spec.definitions):
        needed.add("actionlib_msgs" if spec.ros_version == 1 else "action_msgs")
    return frozenset(needed - {spec.name})


_BUILD_TOOLS = {
    BuildType.CATKIN: ("catkin",),
    BuildType.AMENT_PYTHON: (),
    BuildType.AMENT_CMAKE: ("ament_cmake",),
    BuildType.AMENT_CMAKE_PYTHON: ("ament_cmake", "ament_cmake_python"),
}


def _named(spec: PackageSpec) -> tuple[set[str], set[str], tuple[Diagnostic, ...]]:
    """Return what nodes need to run, what others are built with, and what nobody knows."""
    run: set[str] = set()
    built: set[str] = set()
    diagnostics: list[Diagnostic] = []
    for node in spec.nodes:
        keys, unknown = needs_of(spec, node)
        (built if node.is_built else run).update(keys)
        diagnostics += unknown
    return run, built, tuple(diagnostics)


def _for_tests(spec: PackageSpec) -> set[str]:
    """Return what the tests import, and what their build files find."""
    if spec.is_bare:
        return set()
    if spec.ros_version == 1:
        needed = {"python3-pytest", "rosgraph", "rosmaster"} if spec.nodes else set()
        needed |= {"roslib"} if spec.built else set()
        return needed | ({"roslaunch"} if spec.launches else set())
    needed = set(_LINTERS[spec.builds])
    if spec.built:
        needed |= {f"ament_cmake_{each}" for each in ("cpplint", "flake8", "pep257", "uncrustify")}
        needed |= {"ament_index_python", "rclpy"}
    if spec.nodes:
        needed |= {"domain_coordinator"}
        if spec.builds is BuildType.AMENT_PYTHON:
            needed.add("python3-pytest")
        else:
            needed.add("ament_cmake_pytest")
        if any(each.node.is_managed for each in spec.nodes):
            needed.add("lifecycle_msgs")
    return needed


_LINTERS: Mapping[BuildType, Iterable[str]] = {
    BuildType.AMENT_PYTHON: ("ament_flake8", "ament_pep257", "python3-pytest"),
    BuildType.AMENT_CMAKE: ("ament_cmake_lint_cmake", "ament_cmake_xmllint", "ament_lint_auto"),
    BuildType.AMENT_CMAKE_PYTHON: (
        "ament_cmake_flake8",
        "ament_cmake_lint_cmake",
        "ament_cmake_pep257",
        "ament_cmake_xmllint",
        "ament_lint_auto",
    ),
}
