"""Packages that exist: what their package.xml, setup.py and CMakeLists.txt say together."""

from __future__ import annotations

from .built import Came, add_built_node, add_needs, came_with, remove_needs
from .changing import Changed, Needs, add_launch, add_node, remove_executable, remove_launch
from .definitions import add_definition
from .reading import PACKAGE_XML, PackageFiles, finds_scripts, named_elsewhere, read_package_files
from .unbuilt import remove_built_node, staying

__all__ = [
    "PACKAGE_XML",
    "Came",
    "Changed",
    "Needs",
    "PackageFiles",
    "add_built_node",
    "add_definition",
    "add_launch",
    "add_needs",
    "add_node",
    "came_with",
    "finds_scripts",
    "named_elsewhere",
    "read_package_files",
    "remove_built_node",
    "remove_executable",
    "remove_launch",
    "remove_needs",
    "staying",
]
