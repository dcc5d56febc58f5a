"""The client libraries that Plastron writes, reads and edits.

A target is loaded when it is first asked for. Those of other distributions register under the
entry point group `plastron.targets`, which is looked at only for names that are not Plastron's
own, since listing entry points is slow.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from .base import ReadResult, Target

_KNOWN = {"rospy": 1, "rclpy": 2, "roscpp": 1, "rclcpp": 2, "nodelet": 1}

_OWN = {
    "rospy": ("plastron_tui.targets.rospy", "RospyTarget"),
    "rclpy": ("plastron_tui.targets.rclpy", "RclpyTarget"),
}


class _Libraries(Mapping[str, int]):
    """The names that are known to Plastron, then those of other distributions."""

    def __getitem__(self, name: str) -> int:
        if name in _KNOWN:
            return _KNOWN[name]
        from .plugins import ros_version_of

        version = ros_version_of(name)
        if version is None:
            raise KeyError(name)
        return version

    def __contains__(self, name: object) -> bool:
        return name in _KNOWN or (isinstance(name, str) and has_target(name))

    def __iter__(self) -> Iterator[str]:
        from .plugins import registered

        return iter(dict.fromkeys((*_KNOWN, *registered())))

    def __len__(self) -> int:
        return sum(1 for _ in self)


LIBRARIES: Mapping[str, int] = _Libraries()
"""The client libraries that a program may name, each with its generation of ROS.

To ask for one of Plastron's own costs nothing. To list them, or to ask whether there is another,
looks at what is installed; to ask for another's generation of ROS loads it.
"""


def find_target(name: str, template_folder: Path | None = None) -> Target | None:
    """Return the target of a client library, None when there is none of that name.

    A target of another distribution that cannot be loaded, or that fails, says so.

    Args:
        name: the client library, such as `rospy`.
        template_folder: a folder of the user's own templates, with a folder for each library.
    """
    if name in _OWN:
        module, attribute = _OWN[name]
        factory = getattr(import_module(module), attribute)
    else:
        from .plugins import make_target

        return make_target(name, template_folder)
    target: Target = factory(template_folder)
    return target


def has_target(name: str) -> bool:
    """Tell whether there is a target of a client library, without loading it."""
    if name in _OWN:
        return True
    from .plugins import registered

    return name in registered()


def read_source(path: Path, text: bytes) -> ReadResult:
    """Read a node's source file, whichever client library it uses."""
    result = _read_own(path, text)
    if result.source is not None:
        return result
    from .plugins import registered

    for name in registered():
        target = find_target(name) if name not in _OWN else None
        if target is not None and target.suffix == path.suffix:
            read = target.read(path, text)
            if read.source is not None:
                return read
    return result


def _read_own(path: Path, text: bytes) -> ReadResult:
    if path.suffix in (".cpp", ".cc", ".hpp"):
        from plastron_tui.diagnostics import Diagnostic

        from .base import ReadResult

        message = f"plastron cannot read C++ files yet, such as `{path.name}`"
        return ReadResult(None, (Diagnostic("unsupported-target", message),))
    from .python import read_python

    return read_python(path, text, None)
