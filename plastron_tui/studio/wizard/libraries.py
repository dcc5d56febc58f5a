"""The client library: which ROS a node is for, from what is installed."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

from plastron_tui.model.libraries import written_libraries
from plastron_tui.session import DEFAULT_LIBRARY
from plastron_tui.targets import LIBRARIES, has_target, ros_version

from .ask import Ask, Choice
from .kind import Kind
from .scene import Scene

if TYPE_CHECKING:
    from plastron_tui.runtime.environment import Environment


def installed(environ: Mapping[str, str]) -> tuple[Environment, ...]:
    """Return the ROS that are installed, the preferred one first; it starts other programs."""
    from plastron_tui.runtime.environment import find_environments

    return find_environments(environ).environments


class LibraryKind(Kind):
    """The client library of a node."""

    def suggest(self, ask: Ask) -> str:
        """Return the library of the other nodes, or where nobody chose one of what is installed."""
        scene = ask.scene
        if ask.node:
            return ""
        default = scene.session.library
        nodes = [node for node in scene.workspace.nodes.values() if node.source is None]
        if nodes:
            last = nodes[-1].library
            is_default = scene.session.is_library_chosen and last == default
            return "" if last is None or is_default else last
        if scene.session.is_library_chosen or not scene.environments:
            return ""
        installed = [each.library for each in scene.environments]
        # The shell generates for the default, whatever the studio falls back to.
        return "" if DEFAULT_LIBRARY in installed[:1] else installed[0]

    def choices(self, ask: Ask, query: str) -> list[Choice]:
        """Return the libraries, each with what is installed of it."""
        scene = ask.scene
        installed = {each.library: each.words for each in reversed(scene.environments)}
        default = scene.session.library
        if ask.node:
            default = scene.library_of(ask.node)
        found = [Choice("", f"{default}, {_why(ask, default)}", label="leave it out")]
        for name in LIBRARIES:
            about = installed.get(name, "not installed here: it can be written, not run")
            closed = "" if has_target(name) else "plastron does not write it yet"
            found.append(Choice(name, f"ROS {ros_version(name)}", about, closed))
        return found

    def problem(self, ask: Ask, text: str) -> str | None:
        """Tell why there is no such library."""
        if text not in LIBRARIES:
            return f"there is no client library `{text}`: choose one of the list"
        if not has_target(text):
            return f"plastron does not write {text} yet: choose {_written()}"
        return None


def _written() -> str:
    """Name the libraries that are written, each with its ROS."""
    return " or ".join(f"{n} (ROS {ros_version(n)})" for n in written_libraries(LIBRARIES))


def _why(ask: Ask, default: str) -> str:
    if ask.node and ask.scene.library_of(ask.node) == default:
        return "which the node is for"
    if ask.scene.session.is_library_chosen:
        return "which is chosen for this program"
    return "what there is here; another machine may take another one"


def installed_as(scene: Scene, library: str) -> str:
    """Return what is installed of a library; of the program's own where it is left out."""
    wanted = library or scene.session.library
    for each in scene.environments:
        if each.library == wanted:
            return f"ROS {each.ros_version} {each.distribution}".rstrip()
    return ""


def explained(ask: Ask) -> str:
    """Return why a library is suggested."""
    scene = ask.scene
    nodes = [node for node in scene.workspace.nodes.values() if node.source is None]
    library = LibraryKind().suggest(ask) or scene.session.library
    if nodes and not ask.node:
        return f"the other nodes are for {library}: nodes of ROS 1 and ROS 2 do not hear each other"
    words = next((each.words for each in scene.environments if each.library == library), None)
    if words is not None:
        return f"{library}, because {words} is on this machine"
    return f"{library}; no ROS for it is on this machine, so it can be written but not run"
