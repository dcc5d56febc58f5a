"""The target `nodelet`: C++ nodes for ROS 1 that are loaded into a manager."""

from __future__ import annotations

from dataclasses import replace
from typing import ClassVar

from .dialect import Dialect
from .roscpp import DIALECT as ROSCPP
from .target import CppTarget

# What `nodelet::Nodelet` has (Noetic): a method of the same name would hide it.
_NODELET_METHODS = """
    getMTCallbackQueue getMTNodeHandle getMTPrivateNodeHandle getMyArgv getName getNodeHandle
    getPrivateNodeHandle getRemappingArgs getSTCallbackQueue getSuffixedName init onInit
"""

DIALECT = replace(
    ROSCPP,
    library="nodelet",
    like="roscpp",
    is_plugin=True,
    method_names=frozenset(_NODELET_METHODS.split()),
)


class NodeletTarget(CppTarget):
    """Writes, reads and edits nodelet nodes."""

    name: ClassVar[str] = "nodelet"
    ros_version: ClassVar[int] = 1
    dialect: ClassVar[Dialect] = DIALECT
