"""Targets of other distributions, by the entry points that they register.

Listing entry points reads the metadata of every installed distribution, so that it is done once,
and only where a name is not Plastron's own, or where names are listed.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cache
from importlib.metadata import EntryPoint, entry_points
from pathlib import Path
from typing import ClassVar

from plastron_tui.diagnostics import Diagnostic

from .base import Target

GROUP = "plastron.targets"
"""The entry point group of targets: a name, and a `Target` class that takes a template folder."""

Factory = Callable[[Path | None], Target]


@cache
def registered() -> Mapping[str, EntryPoint]:
    """Return the entry points by name; of two with one name the first that is installed counts."""
    found: dict[str, EntryPoint] = {}
    for entry in entry_points(group=GROUP):
        found.setdefault(entry.name, entry)
    return dict(sorted(found.items()))


@cache
def factory_of(name: str) -> Factory | None:
    """Load what makes the target of a name, None where nobody registered one."""
    entry = registered().get(name)
    if entry is None:
        return None
    try:
        factory = entry.load()
    # Code of another distribution may fail in any way as it is imported.
    except Exception as error:
        return _unusable(name, f"{type(error).__name__}: {error}")
    if not isinstance(factory, type) or not issubclass(factory, Target):
        return _unusable(name, f"`{entry.value}` is no class of a target")
    if getattr(factory, "name", None) != name:
        return _unusable(name, f"the `name` of `{entry.value}` is another")
    if getattr(factory, "ros_version", None) not in (1, 2):
        return _unusable(name, f"the `ros_version` of `{entry.value}` is neither 1 nor 2")
    return factory


def ros_version_of(name: str) -> int | None:
    """Return the generation of ROS that a registered target is for, None where there is none."""
    factory = factory_of(name)
    return None if factory is None else getattr(factory, "ros_version", 1)


class _Unusable(Target):
    """Stands for a target that cannot be loaded: all that is asked of it is a diagnostic."""

    ros_version: ClassVar[int] = 1
    reason: ClassVar[str]

    def __init__(self, template_folder: Path | None = None) -> None:
        del template_folder

    def _cannot(self, what: str) -> Diagnostic:
        return Diagnostic(
            "unsupported-target", f"the target `{self.name}` cannot be used: {self.reason}"
        )


def _unusable(name: str, reason: str) -> Factory:
    return type("_Unusable", (_Unusable,), {"name": name, "reason": reason})
