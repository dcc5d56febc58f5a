"""Nodes of ROS 1 in C++, as programs of their own and in a manager."""

from __future__ import annotations

import json
import re
from collections.abc import Collection
from dataclasses import dataclass
from pathlib import Path

from graph import Graph
from machine import wait_until
from processes import Process

MANAGER = Path("/usr/lib/nodelet/nodelet")
PACKAGE = """\
<?xml version="1.0"?>
<package format="2">
  <name>made_nodelets</name>
  <version>0.0.0</version>
  <description>Nodelets that a test made</description>
  <maintainer email="nobody@example.com">nobody</maintainer>
  <license>Apache-2.0</license>
  <exec_depend>nodelet</exec_depend>
  <export>
    <nodelet plugin="${prefix}/nodelets.xml"/>
  </export>
</package>
"""
PLUGINS = """\
<library path="{library}">
  <class name="{name}" type="{name}" base_class_type="nodelet::Nodelet"/>
</library>
"""


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
    """

    wanted: Collection[str] = ()

    def run(self, node: Path) -> CppProcess:
        """Start a program."""
        log = self.folder / f"{next(self._numbers)}-{node.name}.log"
        process = CppProcess([node], self.env, log)
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


def plugin_path(folder: Path, library: Path, class_name: str) -> str:
    """Write a package that exports a nodelet, and return where packages are found."""
    package = folder / "made_nodelets"
    package.mkdir(parents=True)
    (package / "package.xml").write_text(PACKAGE)
    path = library.with_suffix("")
    (package / "nodelets.xml").write_text(PLUGINS.format(library=path, name=class_name))
    return f"{folder}:/usr/share"
