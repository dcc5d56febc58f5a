"""What a package depends on, and in which way; the tags are those of REP 149."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import NamedTuple

from plastron_tui.diagnostics import Diagnostic, codes
from plastron_tui.ros.interfaces import InterfaceKind
from plastron_tui.ros.package_keys import key_of_module

from .spec import BuildType, PackageSpec, interfaces_name


class Dependency(NamedTuple):
    """A tag of `package.xml` and the package or rosdep key in it."""

    tag: str
    key: str


def dependencies_of(spec: PackageSpec) -> tuple[tuple[Dependency, ...], tuple[Diagnostic, ...]]:
    """Return what a package depends on, in the order of its `package.xml`, and what is not known.

    Nodes in Python need nothing while they are built: what they import is an `exec_depend`.
    """
    run, diagnostics = _imported(spec)
    for launch in spec.launches:
        run |= launch.needs
    if spec.launches:
        # ROS 2 documentation, "Integrating launch files into ROS 2 packages".
        run.add("roslaunch" if spec.ros_version == 1 else "ros2launch")
    found = [Dependency("buildtool_depend", tool) for tool in _BUILD_TOOLS[spec.builds]]
    if spec.builds_types:
        found.append(Dependency("buildtool_depend", "rosidl_default_generators"))
        needed = needs_of_definitions(spec)
        found += [Dependency("depend", package) for package in sorted(needed)]
        run = (run - needed) | {"rosidl_default_runtime"}
    if spec.ros_version == 1 and spec.definitions:
        # The wiki page "catkin/package.xml", and the package message_generation.
        found.append(Dependency("build_depend", "message_generation"))
        needed = needs_of_definitions(spec)
        found += [Dependency("depend", package) for package in sorted(needed)]
        run = (run - needed) | {"message_runtime"}
    found += [Dependency("exec_depend", key) for key in sorted(run - {spec.name})]
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


def _imported(spec: PackageSpec) -> tuple[set[str], tuple[Diagnostic, ...]]:
    """Return what the nodes import, as packages and rosdep keys, and what nobody knows."""
    own = {spec.name, *(each.module for each in spec.nodes)}
    known = spec.packages | {interfaces_name(spec.name)}
    keys: set[str] = set()
    diagnostics = []
    for node in spec.nodes:
        keys |= node.node.packages
        for module in sorted(node.language.imports(node.text)):
            if module.partition(".")[0] in own:
                continue
            key = key_of_module(module, spec.ros_version, known)
            if key is not None:
                keys.add(key)
                continue
            message = f"`{node.file}` imports `{module}`, and no package is known that has it"
            help_ = "add what brings it to package.xml, as `<exec_depend>KEY</exec_depend>`"
            diagnostics.append(Diagnostic(codes.UNKNOWN_IMPORT, message, node.span, help=help_))
    return keys, tuple(diagnostics)


def _for_tests(spec: PackageSpec) -> set[str]:
    """Return what the tests import, and what their build files find."""
    if spec.ros_version == 1:
        nodes = {"python3-pytest", "rosgraph", "rosmaster"} if spec.nodes else set()
        return nodes | ({"roslaunch"} if spec.launches else set())
    needed = set(_LINTERS[spec.builds])
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
