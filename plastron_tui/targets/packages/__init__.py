"""Packages that are written new: catkin's, and those of ROS 2."""

from __future__ import annotations

from .rendering import interfaces_of, node_path, render_interfaces, render_package
from .spec import (
    BuildType,
    PackagedDefinition,
    PackagedFile,
    PackagedLaunch,
    PackagedNode,
    PackageFile,
    PackageSpec,
    RenderedPackage,
    interfaces_name,
)

__all__ = [
    "BuildType",
    "PackageFile",
    "PackageSpec",
    "PackagedDefinition",
    "PackagedFile",
    "PackagedLaunch",
    "PackagedNode",
    "RenderedPackage",
    "interfaces_name",
    "interfaces_of",
    "node_path",
    "render_interfaces",
    "render_package",
]
