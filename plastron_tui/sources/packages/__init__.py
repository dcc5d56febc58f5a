"""Packages that exist: what their package.xml, setup.py and CMakeLists.txt say together."""

from __future__ import annotations

from .changing import Changed, add_launch, add_node, remove_executable
from .reading import PackageFiles, read_package_files

__all__ = [
    "Changed",
    "PackageFiles",
    "add_launch",
    "add_node",
    "read_package_files",
    "remove_executable",
]
