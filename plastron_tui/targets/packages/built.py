"""What a package's CMakeLists.txt says of the nodes that it builds.

Sources: the wiki page "catkin/CMakeLists.txt" and catkin's how-to pages on executables and
libraries; for ROS 2 the "ament_cmake user documentation", the guide "Composing multiple nodes in a
single process", and the documentation of rclcpp_components; the wiki page "nodelet".
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

from plastron_tui.ros.package_keys import is_ros_package

from .needs import needs_of
from .spec import PackagedNode, PackageSpec

PLUGINS_FILE = "nodelet_plugins.xml"
"""The file that tells a nodelet manager which classes a package has."""

NODELET_BASE = "nodelet::Nodelet"

_HEADERS = "../include/"
"""The folder of a package's headers, from that of its sources."""

# What a package of ROS 2 is linked to by; others say what their targets are in `NAME_TARGETS`.
_LINKED = {
    "rclcpp": "rclcpp::rclcpp",
    "rclcpp_action": "rclcpp_action::rclcpp_action",
    "rclcpp_components": "rclcpp_components::component",
    "rclcpp_lifecycle": "rclcpp_lifecycle::rclcpp_lifecycle",
}

# Targets that a build has besides (CMake's policy CMP0037, catkin, ament and their generators).
_TAKEN = frozenset(
    {
        "all", "clean", "clean_test_results", "depend", "docs", "doxygen", "edit_cache", "help",
        "install", "list_install_components", "package", "package_source", "preinstall",
        "rebuild_cache", "run_tests", "test", "tests", "uninstall",
    }
)  # fmt: skip


@dataclass(frozen=True)
class BuiltNode:
    """A node that a package builds, as its CMakeLists.txt says it."""

    spec: PackageSpec
    node: PackagedNode

    @property
    def executable(self) -> str:
        """What one starts it by."""
        return self.node.executable

    @property
    def source(self) -> str:
        """The file that is compiled."""
        return f"src/{self.node.file}"

    @property
    def plugin(self) -> str | None:
        """The class that it is loaded as, None for a program."""
        return self.node.plugin

    @property
    def target(self) -> str:
        """The target of CMake; those of catkin are of one build, whichever package they are in.

        Libraries of all packages of ROS 2 may be in one folder.
        """
        name = self.node.module
        if self.spec.ros_version == 1 or self.plugin is not None:
            return f"${{PROJECT_NAME}}_{name}"
        is_taken = name in _TAKEN or (self.spec.builds_types and name == self.spec.name)
        return f"${{PROJECT_NAME}}_{name}" if is_taken else name

    @property
    def library(self) -> str:
        """The name of its library, without what the system puts around it."""
        return f"{self.spec.name}_{self.node.module}"

    @property
    def has_header(self) -> bool:
        """Whether headers in the package's folder for them belong to it."""
        return any(name.startswith(_HEADERS) for name, _ in self.node.others)

    @property
    def installs_header(self) -> bool:
        """Whether one of them is where others look for headers of the package.

        catkin installs what is in a folder of the package's name. A loaded node may bring headers
        along in a folder of the name of the package that it came from.
        """
        folder = f"{_HEADERS}{self.spec.name}/" if self.spec.ros_version == 1 else _HEADERS
        return any(name.startswith(folder) for name, _ in self.node.others)

    @cached_property
    def packages(self) -> tuple[str, ...]:
        """The packages of ROS that it is built with, sorted."""
        keys, _ = needs_of(self.spec, self.node)
        return tuple(sorted(each for each in keys if _is_found(self.spec, each)))

    @property
    def linked(self) -> tuple[str, ...]:
        """What it is linked to in ROS 2."""
        own = ("${cpp_typesupport_target}",) if self.spec.builds_types else ()
        return (*linked_of(self.packages), *own)


def linked_of(packages: tuple[str, ...]) -> tuple[str, ...]:
    """Return the targets of packages of ROS 2; those with a name of their own come first."""
    named = (_LINKED[each] for each in packages if each in _LINKED)
    return (*named, *(f"${{{each}_TARGETS}}" for each in packages if each not in _LINKED))


def built_nodes(spec: PackageSpec) -> tuple[BuiltNode, ...]:
    """Return the nodes that a package builds."""
    return tuple(BuiltNode(spec, each) for each in spec.built)


def found_packages(spec: PackageSpec) -> list[str]:
    """Return the packages of ROS that a package's build has to find for its nodes, sorted."""
    return sorted({package for each in built_nodes(spec) for package in each.packages})


def _is_found(spec: PackageSpec, key: str) -> bool:
    return key != spec.name and is_ros_package(key, spec.ros_version, spec.packages)
