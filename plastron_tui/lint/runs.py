"""Which nodes run together, and under which names: as launch files start them, else once each."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence, Set
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import NamedTuple

from plastron_tui.diagnostics import Span
from plastron_tui.model.source import SourceEndpoint, SourceNode
from plastron_tui.ros.interfaces import InterfaceKind
from plastron_tui.ros.launch import Place as LaunchPlace
from plastron_tui.ros.launch_started import Started
from plastron_tui.ros.names import spelled
from plastron_tui.ros.run_names import Remap, RunNames

from .executables import Executables, executables_of
from .given_names import UNKNOWN, GivenNames, Values, asked_of, given_names_of, named
from .tree import LaunchFacts, SourceTree, UnitFacts, once_a_tree


class RunningNode(NamedTuple):
    """A node of a run.

    Attributes:
        unit: the files that it is in.
        node: what they say of it.
        name: its name, without a namespace.
        names: the namespace and the remaps that it gets.
        started: where a launch file starts it, None where none does.
        is_read: whether all that creates its endpoints was read.
        values: what the parameters have that name endpoints of it.
    """

    unit: UnitFacts
    node: SourceNode
    name: str
    names: RunNames
    started: Started | None = None
    is_read: bool = False
    values: Values = ()

    @property
    def endpoints(self) -> tuple[SourceEndpoint, ...]:
        """Its endpoints, with the names that parameters give them where these are known."""
        values, version = dict(self.values), self.unit.ros_version
        return tuple(
            each if each.given_by is None else each._replace(name=named(each, values, version))
            for each in self.node.endpoints
        )

    @property
    def is_named(self) -> bool:
        """Whether its namespace and all of its remaps are known."""
        return self.started is None or self.started.is_named

    def names_all(self, name: str) -> bool:
        """Tell whether all that a name is made of is known: `~/x` has that of the node in it."""
        is_own = self.node.name is not None or (self.started is not None and self.started.name)
        return self.is_named and (bool(is_own) or not name.startswith("~"))

    @property
    def full_name(self) -> str:
        """Its name with its namespace."""
        return self.names.full_node(self.name)

    @property
    def shown(self) -> str:
        """What people are told it is: its full name, or the file of a node that has no name."""
        return self.full_name if self.name else self.unit.path.name

    @property
    def key(self) -> tuple[Path, str, str]:
        """What tells it from other nodes, which may have its name."""
        return self.unit.path, self.node.label, self.full_name


class User(NamedTuple):
    """An endpoint of a running node."""

    node: RunningNode
    endpoint: SourceEndpoint

    @property
    def path(self) -> Path:
        """The file that has its call."""
        return self.node.unit.path_of(self.endpoint)

    @property
    def sends(self) -> bool:
        """Whether it begins: it publishes, or it calls."""
        return self.endpoint.kind.facts.sends


Place = tuple[InterfaceKind, int, str]
"""A topic, a service or an action, in a generation of ROS, by its full name."""


@dataclass(frozen=True, eq=False)
class Run:
    """Nodes that run at the same time.

    Attributes:
        launch: the launch file that starts them, None where they are started by hand.
        nodes: the nodes.
        others: what the launch file starts besides, of which no file was read.
    """

    launch: LaunchFacts | None
    nodes: tuple[RunningNode, ...]
    others: tuple[Started, ...] = ()

    def meetings(self) -> Mapping[Place, list[User]]:
        """Return who is at each topic, service and action whose name is known."""
        return self._met[0]

    def strays(self) -> list[User]:
        """Return the endpoints whose name, type or being there is not sure."""
        return self._met[1]

    @cached_property
    def _met(self) -> tuple[Mapping[Place, list[User]], list[User]]:
        found: dict[Place, list[User]] = defaultdict(list)
        strays: list[User] = []
        for node in self.nodes:
            for endpoint in node.endpoints:
                interface = endpoint.kind.facts.interface
                if interface is None:
                    continue
                if endpoint.name is None or endpoint.is_guess or not node.names_all(endpoint.name):
                    strays.append(User(node, endpoint))
                    continue
                name = node.names.resolved(node.name, endpoint.name)
                found[interface, node.unit.ros_version, name].append(User(node, endpoint))
        return found, strays


@once_a_tree
def runs_of(tree: SourceTree) -> tuple[Run, ...]:
    """Return the runs of a workspace.

    Each launch file is one that no other one includes. The nodes that none starts are taken as
    started once each, in one run a package, with those that launch files start of that package:
    what lies in two packages need never run together. One that a launch file starts only with
    other arguments has the names that it gets there.
    """
    executables, given = executables_of(tree), given_names_of(tree)
    launched: dict[object, dict[object, RunningNode]] = defaultdict(dict)
    ran: set[tuple[Path, str]] = set()
    found: list[Run] = []
    for launch in tree.launches:
        run = _launch_run(launch, executables, given)
        found.append(run)
        for each in run.nodes:
            ran.add((each.unit.path, each.node.label))
            launched[_home(tree, each.unit)][each.key, each.names, each.values] = each
    alone: dict[object, list[RunningNode]] = defaultdict(list)
    unstarted: dict[Path, list[Started]] = defaultdict(list)
    for started in tree.unstarted:
        made_of = executables.started(started)
        if made_of is not None:
            unstarted[made_of.path].append(started)
    for unit in tree.built:
        if unit.path not in executables.parts and not unit.is_test:
            whole = executables.programs.get(unit.path, unit)
            left = [node for node in whole.nodes if (unit.path, node.label) not in ran]
            if left or not whole.nodes:
                alone[_home(tree, unit)] += _by_hand(whole, left, unstarted[unit.path], given)
    for key, nodes in alone.items():
        found.append(Run(None, (*nodes, *launched[key].values())))
    return _settled(found)


def _settled(runs: Sequence[Run]) -> tuple[Run, ...]:
    """Return runs without the values of parameters that are not known wherever a node is started.

    A launch file that has such a value may be the one that people use.
    """
    unknown = {
        (node.key[:2], parameter)
        for run in runs
        for node in run.nodes
        for parameter, value in node.values
        if value == UNKNOWN
    }
    return tuple(_without(run, unknown) for run in runs) if unknown else tuple(runs)


def _without(run: Run, unknown: Set[tuple[object, str]]) -> Run:
    nodes = (
        node._replace(
            values=tuple(
                (parameter, UNKNOWN if (node.key[:2], parameter) in unknown else value)
                for parameter, value in node.values
            )
        )
        for node in run.nodes
    )
    return Run(run.launch, tuple(nodes), run.others)


def _home(tree: SourceTree, unit: UnitFacts) -> object:
    """Return the package that files are in, and the generation of ROS that they are for."""
    package = tree.package_of(unit)
    folder = None if package is None else package.folder
    return unit.package, folder, unit.ros_version


def _launch_run(launch: LaunchFacts, executables: Executables, given: GivenNames) -> Run:
    nodes: list[RunningNode] = []
    others: list[Started] = []
    for started in launch.resolved.started:
        unit = executables.started(started)
        if unit is None:
            others.append(started)
        else:
            is_read = unit.code.is_closed and executables.is_alone(started, unit)
            for node in _running(unit, started, is_read=is_read):
                values = given.launched(launch, started, unit, node.node)
                nodes.append(node._replace(values=values))
    return Run(launch, tuple(nodes), tuple(others))


def _running(unit: UnitFacts, started: Started, *, is_read: bool) -> Iterator[RunningNode]:
    remaps = (*_argument_remaps(started, unit.ros_version), *started.remaps)
    names = RunNames(started.namespace, tuple(Remap(*each) for each in remaps))
    for node in unit.nodes:
        # A file of several nodes gives each its own name; `name` renames them all in ROS 2.
        yield RunningNode(unit, node, started.name or node.label, names, started, is_read)


def _by_hand(
    unit: UnitFacts,
    nodes: Sequence[SourceNode],
    unstarted: Sequence[Started],
    given: GivenNames,
) -> Iterator[RunningNode]:
    """Yield nodes of files that no launch file starts unless it is given other arguments."""
    for started in unstarted:
        for each in _running(unit, started, is_read=False):
            if each.node in nodes:
                yield each._replace(values=tuple((name, UNKNOWN) for name in asked_of(each.node)))
    if not unstarted:
        for node in nodes:
            values = given.by_hand(unit, node)
            yield RunningNode(unit, node, node.label, RunNames(), values=values)


def _argument_remaps(started: Started, ros_version: int) -> Iterator[tuple[str, str]]:
    """Yield the remaps among the arguments of a node's command line."""
    for word in dict(started.others).get("args", "").split():
        old, sign, new = word.partition(":=")
        is_remap = sign and old and new and not old.startswith("_")
        if is_remap and ":" not in old and (ros_version == 1 or "." not in old):
            yield spelled(old), spelled(new)


def span_of(place: LaunchPlace) -> Span:
    """Return the bytes of a place of a launch file."""
    return Span(place.start, place.end)
