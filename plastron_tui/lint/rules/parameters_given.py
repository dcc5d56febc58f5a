"""Which nodes get which parameters, and what of them each node declares."""

from __future__ import annotations

import os
from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping
from functools import cached_property
from pathlib import Path
from typing import NamedTuple

from plastron_tui.diagnostics import Label, Span
from plastron_tui.lint.executables import executables_of
from plastron_tui.lint.made_nodes import MadeNode, facts_of, made_nodes_of
from plastron_tui.lint.runs import RunningNode, runs_of
from plastron_tui.lint.tree import LaunchFacts, SettingPlace, SourceTree, UnitFacts, once_a_tree
from plastron_tui.model.code_facts import ParameterAccess, ParameterFacts, ParameterUse
from plastron_tui.model.source import SourceNode
from plastron_tui.ros.launch_started import Started
from plastron_tui.ros.parameter_blocks import ParameterBlock
from plastron_tui.ros.parameter_values import is_for
from plastron_tui.ros.parameters import OF_EVERY_NODE
from plastron_tui.ros.run_names import RunNames

_ENOUGH = 3
"""So many parameters of two nodes of one name are the same only where one is meant."""


def is_of_every_node(name: str) -> bool:
    """Tell whether nodes of ROS 2 have a parameter by themselves, or by a library's."""
    return name.partition(".")[0] in (*OF_EVERY_NODE, "diagnostic_updater")


class Declared(NamedTuple):
    """What a node declares.

    Attributes:
        node: the node.
        uses: the declarations by the names of the parameters.
        is_whole: whether it has no other parameter for sure.
    """

    node: RunningNode
    uses: Mapping[str, list[ParameterUse]]
    is_whole: bool

    def has(self, name: str) -> bool:
        """Tell whether the node has a parameter, by itself or as it says."""
        return name in self.uses or is_of_every_node(name)

    def type_of(self, name: str) -> str | None:
        """Return the one type that a parameter has for sure, None where that is not known."""
        types = {use.type for use in self.uses.get(name, ())}
        return types.pop() if len(types) == 1 else None

    def label(self, name: str) -> tuple[Label, ...]:
        """Return the place where a parameter is declared, none where it is not."""
        return tuple(
            Label(use.span, "declared here", self.node.unit.file(use.file))
            for use in self.uses.get(name, ())[:1]
        )


class Receiver(NamedTuple):
    """A process that a launch file starts, or does with other arguments.

    Attributes:
        started: how it is started.
        nodes: its nodes, none where they are not read.
        launch: the launch file, None where that starts it only with other arguments.
    """

    started: Started
    nodes: tuple[Declared, ...]
    launch: LaunchFacts | None = None

    @property
    def is_one_of_all(self) -> bool:
        """Whether all others are known that its launch file starts."""
        unresolved = () if self.launch is None else self.launch.resolved.unresolved
        return all(each.parameter for each in unresolved)

    @property
    def settings(self) -> tuple[str, ...]:
        """The names of the parameters that the launch file itself sets, known values or not."""
        unresolved = () if self.launch is None else self.launch.resolved.unresolved
        place = self.started.file, self.started.place
        unknown = (each.parameter for each in unresolved if (each.file, each.place) == place)
        names = (*(name for name, _ in self.started.parameters), *unknown)
        return tuple(dict.fromkeys(filter(None, names)))

    @property
    def names(self) -> tuple[str, ...] | None:
        """The full names of its nodes, None where one is not known."""
        if not self.nodes:
            name = self.started.full_name if self.started.is_named else None
            return None if name is None else (name,)
        found = tuple(map(full_name, self.nodes))
        return tuple(each for each in found if each) if all(found) else None


def full_name(declared: Declared) -> str | None:
    """Return the full name of a node, None where it is not known."""
    node = declared.node
    is_known = node.node.name is not None or (node.started is not None and node.started.name)
    return node.full_name if is_known and node.is_named else None


class Given(NamedTuple):
    """The parameters of a block, and who gets them.

    Attributes:
        file: the parameter file.
        block: the block.
        nodes: the nodes that are known to get them.
        is_whole: whether no other node gets them.
    """

    file: Path
    block: ParameterBlock
    nodes: tuple[Declared, ...]
    is_whole: bool


class Receivers:
    """The processes of a workspace that get parameters, and what gives them some."""

    def __init__(self, tree: SourceTree) -> None:
        """Look at each launch file once."""
        self._tree = tree
        self._made = made_nodes_of(tree)
        self._open = {
            (unit.package, name)
            for unit in tree.units
            if unit.code.allows_undeclared
            for name in [node.class_name for node in unit.nodes] or [None]
        }
        self._folders = {each.folder: each.name for each in tree.every_package}
        self.all = tuple(self._receivers())
        self.of_file: dict[Path, list[Receiver]] = defaultdict(list)
        for receiver in self.all:
            for file in dict.fromkeys(receiver.started.files):
                self.of_file[Path(os.path.normpath(file))].append(receiver)

    def _receivers(self) -> Iterator[Receiver]:
        for run in runs_of(self._tree):
            if run.launch is None:
                continue
            nodes: dict[int, list[Declared]] = defaultdict(list)
            for node in run.nodes:
                if node.started is not None:
                    made = self._made.defined(node.unit, node.node)
                    nodes[id(node.started)].append(self._declared(made, node.names, node.started))
            for started in run.launch.resolved.started:
                found = nodes[id(started)] or self._linked(started)
                yield Receiver(started, tuple(found), run.launch)
        for started in self._tree.unstarted:
            yield Receiver(started, tuple(map(self.declared, self._unstarted(started))))

    def _linked(self, started: Started) -> list[Declared]:
        names = RunNames(started.namespace)
        return [self._declared(made, names, started) for made in self._made.linked(started)]

    def _declared(self, made: MadeNode, names: RunNames, started: Started) -> Declared:
        name = started.name or made.node.label
        declared = self.declared(RunningNode(made.unit, made.node, name, names, started))
        return declared._replace(is_whole=declared.is_whole and made.is_whole)

    def _unstarted(self, started: Started) -> Iterator[RunningNode]:
        unit = executables_of(self._tree).started(started)
        names = RunNames(started.namespace)
        if unit is not None:
            for node in unit.nodes:
                yield RunningNode(unit, node, started.name or node.label, names, started)

    def declared(self, node: RunningNode) -> Declared:
        """Return what a running node declares."""
        facts = facts_of(node.unit, node.node)
        has_more = self.may_have_more(node.unit, node.node, facts)
        uses: dict[str, list[ParameterUse]] = defaultdict(list)
        for use in facts.uses:
            if use.access is ParameterAccess.DECLARE and use.name is not None:
                uses[use.name].append(use)
        return Declared(node, uses, facts.is_whole and not has_more)

    def may_have_more(self, unit: UnitFacts, node: SourceNode, facts: ParameterFacts) -> bool:
        """Tell whether a node may have parameters that it does not declare."""
        if unit.code.allows_undeclared or not facts.takes_options:
            return unit.code.allows_undeclared
        # A program without a node of its own makes those of other files.
        makers = ((unit.package, node.class_name), (unit.package, None))
        return not self._open.isdisjoint(makers)

    @cached_property
    def given(self) -> tuple[Given, ...]:
        """The blocks of parameter files with the nodes that get them."""
        return tuple(self._given())

    def _given(self) -> Iterator[Given]:
        for file, blocks in self._tree.parameter_files.items():
            for block in blocks:
                found = self._launched(file, block, self.of_file.get(file, ()))
                if found.is_whole and not found.nodes and not block.is_for_any:
                    yield self._by_hand(file, block)
                else:
                    yield found

    def _launched(self, file: Path, block: ParameterBlock, receivers: Iterable[Receiver]) -> Given:
        found: list[Declared] = []
        is_whole = True
        for receiver in receivers:
            if block.is_for_any and not receiver.is_one_of_all:
                # What is left out may get the file, too.
                is_whole = False
            names = receiver.names
            if not receiver.nodes or names is None:
                is_whole = is_whole and names is not None and not _is_for_one(block, names)
            for each in receiver.nodes:
                name = full_name(each)
                if name is not None and is_for(block.pattern, name):
                    found.append(each)
        return Given(file, block, tuple(found), is_whole)

    def _by_hand(self, file: Path, block: ParameterBlock) -> Given:
        """Return who is meant where no launch file is known that says so: who has the name."""
        found = self.named(block.last, file)
        package = self.package_of(file)
        if not found:
            alike = self._alike(file, block, package)
            return Given(file, block, alike, is_whole=bool(alike))
        is_own = any(each.node.unit.package == package for each in found)
        is_meant = is_own or any(_is_meant(each, block) for each in found)
        return Given(file, block, tuple(found if is_meant else ()), is_whole=is_meant)

    def _alike(
        self, file: Path, block: ParameterBlock, package: str | None
    ) -> tuple[Declared, ...]:
        """Return the one node of a package that declares what a block sets, whatever its name.

        It may get its name from a launch file that is not understood; more than it declares may
        be meant for others.
        """
        keys = [key.name for key in block.keys if not is_of_every_node(key.name)]
        found = [
            each._replace(is_whole=False)
            for each in self._near(self._of_package.get(package, ()), file)
            if _ENOUGH <= len(keys) - 1 <= sum(name in each.uses for name in keys)
        ]
        return tuple(found) if len(found) == 1 else ()

    def named(self, name: str, file: Path) -> list[Declared]:
        """Return the nodes of a name that are in the workspace of a file."""
        return self._near(self.by_name.get(name, ()), file)

    def _near(self, nodes: Iterable[Declared], file: Path) -> list[Declared]:
        apart = self._tree.are_apart
        return [each for each in nodes if not apart(each.node.unit.path, file)]

    @cached_property
    def _of_package(self) -> Mapping[str | None, list[Declared]]:
        found: dict[str | None, list[Declared]] = defaultdict(list)
        for unit in self._tree.units:
            for node in unit.nodes if unit.ros_version == 2 and not unit.is_test else ():
                running = RunningNode(unit, node, node.label, RunNames())
                found[unit.package or None].append(self.declared(running))
        return found

    @cached_property
    def by_name(self) -> Mapping[str, list[Declared]]:
        """The nodes of ROS 2 by the names that they have, or get from launch files."""
        found: dict[str, list[Declared]] = defaultdict(list)
        for unit in self._tree.units:
            for node in unit.nodes if unit.ros_version == 2 and not unit.is_test else ():
                if node.name is not None:
                    running = RunningNode(unit, node, node.name, RunNames())
                    found[node.name].append(self.declared(running))
        for receiver in self.all:
            for each in receiver.nodes:
                if each.node.name != each.node.node.name and receiver.started.name:
                    found[each.node.name].append(each)
        return found

    def package_of(self, file: Path) -> str | None:
        """Return the package that a file is in, None for none."""
        return next((self._folders[each] for each in file.parents if each in self._folders), None)


@once_a_tree
def receivers_of(tree: SourceTree) -> Receivers:
    """Return what gets parameters in a workspace, the same for all rules that ask."""
    return Receivers(tree)


def _is_meant(node: Declared, block: ParameterBlock) -> bool:
    """Tell whether a node of another package that has the name of a block has its keys, too."""
    keys = [key.name for key in block.keys if key.name in node.uses]
    # Those below others are mostly of plugins.
    flat = [key for key in block.keys if len(key.parts) == 1]
    return len(keys) >= _ENOUGH or 2 * sum(key.name in keys for key in flat) >= len(flat) > 0


def _is_for_one(block: ParameterBlock, names: tuple[str, ...]) -> bool:
    return any(is_for(block.pattern, name) for name in names)


def settings(tree: SourceTree, receiver: Receiver) -> Iterator[tuple[str, SettingPlace, Span]]:
    """Yield the parameters that a launch file sets of a node, with their places."""
    started = receiver.started
    if started.file is None or started.place is None:
        return
    for name in receiver.settings:
        place = SettingPlace(started.file, started.place.start, name)
        if place in tree.setting_places:
            yield name, place, tree.setting_places[place]
