"""The client libraries that Plastron writes, reads and edits.

A target is loaded when it is first asked for. Those of other distributions register under the
entry point group `plastron.targets`, which is looked at only for names that are not Plastron's
own, since listing entry points is slow.
"""

from __future__ import annotations

from collections.abc import Mapping
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from .base import ReadResult, Target

LIBRARIES: Mapping[str, int] = {"rospy": 1, "rclpy": 2, "roscpp": 1, "rclcpp": 2, "nodelet": 1}
"""The client libraries that a program may name, each with its generation of ROS."""

GROUP = "plastron.targets"
"""The entry point group of targets: a name, and a `Target` class that takes a template folder."""

_OWN = {
    "rospy": ("plastron_tui.targets.rospy", "RospyTarget"),
    "rclpy": ("plastron_tui.targets.rclpy", "RclpyTarget"),
}


def find_target(name: str, template_folder: Path | None = None) -> Target | None:
    """Return the target of a client library, None when there is none of that name.

    Args:
        name: the client library, such as `rospy`.
        template_folder: a folder of the user's own templates, with a folder for each library.
    """
    if name in _OWN:
        module, attribute = _OWN[name]
        factory = getattr(import_module(module), attribute)
    else:
        from importlib.metadata import entry_points

        found = list(entry_points(group=GROUP, name=name))
        if not found:
            return None
        factory = found[0].load()
    target: Target = factory(template_folder)
    return target


def has_target(name: str) -> bool:
    """Tell whether there is a target of a client library, without loading it."""
    if name in _OWN:
        return True
    from importlib.metadata import entry_points

    return bool(entry_points(group=GROUP, name=name))


def target_names() -> tuple[str, ...]:
    """Return the names of all targets, Plastron's own first."""
    from importlib.metadata import entry_points

    others = {entry.name for entry in entry_points(group=GROUP)} - set(_OWN)
    return (*_OWN, *sorted(others))


def read_source(path: Path, text: bytes) -> ReadResult:
    """Read a node's source file, whichever client library it uses."""
    from plastron_tui.diagnostics import Diagnostic

    from .base import ReadResult

    if path.suffix in (".cpp", ".cc", ".hpp"):
        message = f"plastron cannot read C++ files yet, such as `{path.name}`"
        return ReadResult(None, (Diagnostic("unsupported-target", message),))
    from .python import read_python

    return read_python(path, text, None)
