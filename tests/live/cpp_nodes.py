"""Nodes in C++, as programs of their own and in a manager."""

from __future__ import annotations

import json
import re
from collections.abc import Collection, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from xml.etree import ElementTree

from graph import Graph
from machine import wait_until
from processes import Process

MANAGER = Path("/usr/lib/nodelet/nodelet")


class CppProcess(Process):
    """A node of which the graph tells what it has; its own output does not."""

    told = ""

    @property
    def output(self) -> str:
        """What the node has printed, and what it has."""
        return PAINTED.sub("", super().output).replace("[ ", "[") + self.told


@dataclass
class CppGraph(Graph):
    """A graph in which nodes are programs, and not files of Python.

    Attributes:
        wanted: the topics and services by which a node has set up all that it is to have.
        program_env: the variables that the programs have besides.
    """

    wanted: Collection[str] = ()
    program_env: Mapping[str, str] = field(default_factory=dict)

    def run(self, node: Path) -> CppProcess:
        """Start a program."""
        log = self.folder / f"{next(self._numbers)}-{node.name}.log"
        process = CppProcess([node], {**self.env, **self.program_env}, log)
        self.started.append(process)
        return process

    def run_and_wait(self, node: Path) -> CppProcess:
        """Start a program that is called as its node is, and wait until it has what is wanted."""
        process = self.run(node)
        process.told = self.described(node.name)
        return process

    def described(self, node: str) -> str:
        """Wait until a node has what is wanted, and return what it has."""

        def look() -> dict[str, dict[str, dict[str, object]]] | None:
            found: dict[str, dict[str, dict[str, object]]] = self._ask("describe", node)
            names = {name for kind in KINDS for name in found[kind]}
            if not names >= set(self.wanted):
                return None
            own = {
                kind: {name: each for name, each in found[kind].items() if name in self.wanted}
                for kind in KINDS
            }
            return {**found, **own}

        found = wait_until(look, f"{self.wanted} of {node}", 60)
        return f"\nendpoints: {json.dumps(found)}\n"


PAINTED = re.compile("\x1b\\[[0-9]*m")
KINDS = ("publishers", "subscriptions", "services")


def nodelet_of(package: Path) -> tuple[str, str]:
    """Return the library and the name of the one nodelet that a package exports."""
    library = ElementTree.parse(package / "nodelet_plugins.xml").getroot().find("library")
    assert library is not None
    class_ = library.find("class")
    assert class_ is not None
    return Path(library.attrib["path"]).name, class_.attrib["name"]


def plugin_environ(package: Path, prefix: Path) -> dict[str, str]:
    """Return by what a manager finds the nodelets of a package; its libraries are in `lib`."""
    return {"ROS_PACKAGE_PATH": f"{package}:/usr/share", "CMAKE_PREFIX_PATH": str(prefix)}
