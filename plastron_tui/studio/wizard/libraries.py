"""The client library: which ROS a node is for, and what of it is installed."""

from __future__ import annotations

import sys
from functools import cache
from pathlib import Path

from plastron_tui.ros.installations import Installation, present
from plastron_tui.runtime.build_needs import missing_for_build
from plastron_tui.runtime.environment import Environment
from plastron_tui.targets import LIBRARIES, ros_version

from .ask import Ask, Choice
from .context import Scene
from .kind import OF_THE_LIST, Kind


class LibraryKind(Kind):
    """The client library of a node."""

    def suggest(self, ask: Ask) -> str:
        """Return the library of the other nodes, "" where it is the program's own."""
        session = ask.scene.session
        nodes = [node for node in ask.scene.workspace.nodes.values() if node.source is None]
        last = nodes[-1].library if nodes and not ask.node else None
        is_own = session.ros.is_chosen and last == session.library
        return "" if last is None or is_own else last

    def choices(self, ask: Ask, query: str) -> list[Choice]:
        """Return the libraries: what each is for, and what is installed of it."""
        default = ask.scene.library_of(ask.node) if ask.node else ask.scene.session.library
        found = [Choice("", f"{default}, {_why(ask, default)}", label="the usual")]
        for name, library in LIBRARIES.items():
            purpose = f"{library.purpose}; " if library.purpose else ""
            note = f"{library.language}, ROS {library.ros_version}"
            found.append(Choice(name, note, purpose + _standing(name)))
        return found

    def problem(self, ask: Ask, text: str) -> str | None:
        """Tell why there is no such library."""
        if text not in LIBRARIES:
            return f"there is no client library `{text}`: {OF_THE_LIST}"
        return None


def _why(ask: Ask, default: str) -> str:
    if ask.node and ask.scene.library_of(ask.node) == default:
        return "which the node is for"
    if ask.scene.session.ros.is_chosen:
        return "which is chosen for this program"
    return "which is found on this machine"


def _installation(library: str) -> Installation | None:
    """Return the ROS on this machine that a library is for, None where there is none."""
    version = ros_version(library)
    return next((found for found in present() if found.ros_version == version), None)


@cache
def _missing(library: str, installation: Installation) -> tuple[str, ...]:
    """Return what a ROS lacks that nodes of a client library are built with."""
    environment = Environment(*installation, Path(sys.executable))
    return tuple(missing_for_build(environment, LIBRARIES[library].built_with, ()))


def _standing(library: str) -> str:
    """Return whether nodes of a client library can be run here, and with which ROS."""
    there = _installation(library)
    missing = () if there is None else _missing(library, there)
    if there is None:
        return "not installed here: it can be written, not run"
    if missing:
        return f"{there.words} has no `{missing[0]}`: it can be written, not run"
    return there.words


def ros_of(scene: Scene, library: str) -> str:
    """Return the ROS whose types a library has; of the program's own where it is left out."""
    ros = scene.session.ros
    if library in ("", ros.library):
        return ros.name
    if library not in LIBRARIES:
        return ""
    version = ros_version(library)
    return f"ROS {version} {scene.catalog(version).distribution}"


def explained(ask: Ask) -> str:
    """Return why a library is suggested."""
    scene = ask.scene
    nodes = [node for node in scene.workspace.nodes.values() if node.source is None]
    ros = scene.session.ros
    if nodes and not ask.node:
        library = LibraryKind().suggest(ask) or ros.library
        return f"the other nodes are for {library}: nodes of ROS 1 and ROS 2 do not hear each other"
    said = f"{ros.words}: {ros.why.value}"
    there = _installation(ros.library)
    if there is not None and not _missing(ros.library, there):
        return said
    return f"{said}; it can be written on this machine, but not run"
