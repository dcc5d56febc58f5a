"""Interface packages that nothing installs: built from their definitions."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace
from pathlib import Path

from plastron_tui.diagnostics import Diagnostic
from plastron_tui.ros.installations import Origin
from plastron_tui.ros.interfaces import InterfaceName

from .build_output import Progress
from .builds import BuiltPackage, overlay
from .environment import Environment, missing_package, missing_packages

Definitions = Mapping[str, Mapping[str, str]]
"""The definitions of a package: by kind (`msg`, `srv`, `action`), then by name."""

_CMAKE = """\
cmake_minimum_required(VERSION 3.20)
project({package})
find_package(ament_cmake REQUIRED)
find_package(action_msgs REQUIRED)
find_package(rosidl_default_generators REQUIRED)
rosidl_generate_interfaces(${{PROJECT_NAME}} {files})
ament_package()
"""

_MANIFEST = """\
<?xml version="1.0"?>
<package format="3">
  <name>{package}</name>
  <version>0.0.0</version>
  <description>Types that Plastron knows by name</description>
  <maintainer email="nobody@example.com">nobody</maintainer>
  <license>Apache-2.0</license>
  <buildtool_depend>ament_cmake</buildtool_depend>
  <depend>action_msgs</depend>
  <exec_depend>rosidl_default_runtime</exec_depend>
  <member_of_group>rosidl_interface_packages</member_of_group>
</package>
"""


def complete(
    environment: Environment,
    types: Iterable[InterfaceName],
    definitions: Callable[[str], Definitions | None],
    tell: Callable[[Progress], object],
    environ: Mapping[str, str] = os.environ,
) -> tuple[Environment, list[Diagnostic]]:
    """Return an environment with the packages of the types that nodes use, and what it lacks.

    A package that is not installed is made where its definitions are known: in ROS 2's Python
    packages and in Debian's ROS 1. A sourced ROS installs it.

    Args:
        environment: what is to run the nodes.
        types: the types that the nodes use.
        definitions: returns those of a package that may be made here, None for others.
        tell: is told how far a build is.
        environ: the environment variables.
    """
    used: dict[str, set[str]] = {}
    for type_ in types:
        used.setdefault(type_.package, set()).add(type_.name)
    diagnostics: list[Diagnostic] = []
    overlays: list[Path] = []
    for package in missing_packages(environment, sorted(used), environ):
        known = definitions(package) if environment.origin is not Origin.SOURCED else None
        if known is None or not used[package] <= {name for each in known.values() for name in each}:
            diagnostics.append(missing_package(environment, package))
            continue
        # Each is built as if it were alone, so that it is built once for all programs.
        made, problems = overlay(
            environment, [table_package(environment, package, known)], tell, environ
        )
        overlays += made.overlays[len(environment.overlays) :]
        diagnostics += problems
    return replace(environment, overlays=(*environment.overlays, *overlays)), diagnostics


def table_package(environment: Environment, package: str, definitions: Definitions) -> BuiltPackage:
    """Return the files of a package that has nothing but definitions."""
    files = {
        f"{kind}/{name}.{kind}": text.encode()
        for kind, texts in definitions.items()
        for name, text in texts.items()
    }
    if environment.ros_version == 2:
        build = _CMAKE.format(package=package, files=" ".join(files))
        files |= {
            "CMakeLists.txt": build.encode(),
            "package.xml": _MANIFEST.format(package=package).encode(),
        }
    return BuiltPackage(package, files)
