"""What holds at a place of a launch file, while it is found out what the file starts."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import NamedTuple

from .launch_inclusion import Including
from .launch_started import Settings, Site
from .launch_text import Scope


class Renaming(NamedTuple):
    """A remap, and where it stands."""

    names: tuple[str, str]
    site: Site


@dataclass(frozen=True, slots=True)
class State:
    """What holds at a place of a launch file."""

    scope: Scope
    file: str | None
    ros_version: int
    around: tuple[Including, ...] = ()
    namespace: str = ""
    remaps: tuple[Renaming, ...] = ()
    settings: Settings = ()
    given: frozenset[str] = field(default_factory=frozenset)
    included: tuple[Site, ...] = ()
    pushed: Site | None = None
    is_named: bool = True
