"""Nodes of C++ whose class another source defines than the one that makes them."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator
from typing import NamedTuple

from plastron_tui.model.code_facts import ParameterAccess, ParameterFacts
from plastron_tui.model.source import SourceNode
from plastron_tui.ros.launch_started import Started

from .executables import executables_of
from .tree import SourceTree, UnitFacts, once_a_tree


class MadeNode(NamedTuple):
    """A node, where its class is defined.

    Attributes:
        unit: the files that define it.
        node: what they say of it.
        is_whole: whether who makes it declares no parameter of it, as far as that is known.
    """

    unit: UnitFacts
    node: SourceNode
    is_whole: bool = True


class MadeNodes:
    """Finds the sources that define the nodes of others."""

    def __init__(self, tree: SourceTree) -> None:
        """Remember the nodes of C++ by the package and the name of their class."""
        self._tree = tree
        self._defined: dict[tuple[object, str], list[MadeNode]] = defaultdict(list)
        for unit in tree.built:
            if unit.is_python or unit.ros_version != 2 or unit.is_test:
                continue
            for node in unit.nodes:
                if node.class_name and not facts_of(unit, node).is_elsewhere:
                    key = self._home(unit), node.class_name
                    self._defined[key].append(MadeNode(unit, node))

    def _home(self, unit: UnitFacts) -> object:
        package = self._tree.package_of(unit)
        return None if package is None else package.folder

    def defined(self, unit: UnitFacts, node: SourceNode) -> MadeNode:
        """Return where the class of a node is defined, or what is given where that is not sure."""
        facts = facts_of(unit, node)
        if node.class_name is None or not facts.is_elsewhere:
            return MadeNode(unit, node)
        found = self._defined.get((self._home(unit), node.class_name), [])
        if len(found) != 1:
            return MadeNode(unit, node)
        declares = any(use.access is ParameterAccess.DECLARE and not use.file for use in facts.uses)
        return found[0]._replace(is_whole=facts.is_rest_whole and not declares)

    def linked(self, started: Started) -> Iterator[MadeNode]:
        """Yield the nodes of a program of several sources, or of a component of such a library."""
        units = executables_of(self._tree).sources(started)
        if any(unit.is_python or unit.ros_version != 2 for unit in units):
            return
        component = started.executable.rpartition("::")[2] if "::" in started.executable else None
        found: dict[tuple[object, str], MadeNode] = {}
        for unit in units:
            for node in unit.nodes:
                if component in (None, node.class_name):
                    made = self.defined(unit, node)
                    key = made.unit.path, made.node.label
                    is_whole = made.is_whole and (key not in found or found[key].is_whole)
                    found[key] = made._replace(is_whole=is_whole)
        yield from found.values()


def facts_of(unit: UnitFacts, node: SourceNode) -> ParameterFacts:
    """Return what is known of the parameters of a node."""
    if len(unit.code.parameters) != len(unit.nodes):
        return ParameterFacts()
    pairs = zip(unit.nodes, unit.code.parameters, strict=True)
    return next((facts for each, facts in pairs if each is node), ParameterFacts())


@once_a_tree
def made_nodes_of(tree: SourceTree) -> MadeNodes:
    """Return what finds where the nodes of a workspace are defined, the same for all who ask."""
    return MadeNodes(tree)
