"""What launch files do to names: remaps that meet none, namespaces that move one away."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator
from pathlib import Path

from plastron_tui.diagnostics import Code, Diagnostic, Label, Severity
from plastron_tui.diagnostics.suggest import nearest
from plastron_tui.lint.rule import rule
from plastron_tui.lint.runs import Place, Run, RunningNode, User, runs_of, span_of
from plastron_tui.lint.tree import SourceTree
from plastron_tui.lint.well_known import IS_EVERYWHERE, OWN_SERVICES, may_use
from plastron_tui.model.kinds import EndpointKind
from plastron_tui.model.source import SourceEndpoint
from plastron_tui.ros.launch_started import Site, Started
from plastron_tui.ros.name_slips import is_slip
from plastron_tui.ros.run_names import RunNames

from .graph_examples import MOVED, REMAPPED


@rule(
    "RG105",
    "remap-meets-nothing",
    "A launch file remaps a name that the node does not use.",
    severity=Severity.WARNING,
    why="ROS takes any remap, and says nothing where no name of the node is what it is for: the "
    "node goes on with its own names. It is told where the node's files are read as a whole, and "
    "each of its names is known, and where the name is one slip from one of the node's that is not "
    "remapped. A remap that holds for several nodes is told where none of them "
    "has the name.",
    bad=REMAPPED["bad"],
    good=REMAPPED["good"],
)
def remap_meets_nothing(tree: SourceTree, code: Code) -> Iterator[Diagnostic]:
    """Find remaps for which no node that gets them has a name."""
    found: dict[tuple[Site, str], list[tuple[Started, list[RunningNode]]]] = defaultdict(list)
    for run in runs_of(tree):
        nodes: dict[int, list[RunningNode]] = defaultdict(list)
        for node in run.nodes:
            nodes[id(node.started)].append(node)
        for started in () if run.launch is None else run.launch.resolved.started:
            for (old, _), site in zip(started.remaps, started.remap_places, strict=False):
                found[site, old].append((started, nodes[id(started)]))
    for ((file, place), old), users in found.items():
        meant = _meant(old, users)
        is_sure = meant is not None or not any(_may_meet(old, nodes) for _, nodes in users)
        if file is None or place is None or not is_sure:
            continue
        node = users[0][1][0]
        near, span, path = "the node", node.node.span, node.unit.path
        close = nearest(old, _names(node))
        if meant is not None:
            node, close = meant.node, meant.endpoint.name
            near, span, path = "the name that is near", meant.endpoint.span, meant.path
        yield Diagnostic(
            code,
            f"`{node.shown}` has no name `{old}` that could be remapped",
            span_of(place),
            Path(file),
            help=f"did you mean `{close}`?" if close else None,
            labels=() if span is None else (Label(span, near, path),),
        )


def _meant(old: str, users: list[tuple[Started, list[RunningNode]]]) -> User | None:
    """Return whose name one slip makes a remap's, where no node has the remap's own.

    What else a node may use counts for nothing then: the name that is meant is there, and goes
    without a remap.
    """
    if not all(nodes for _, nodes in users):
        return None
    meant: list[User] = []
    for started, nodes in users:
        for node in nodes:
            named = [(node.names.joined(node.name, name), each) for name, each in _named(node)]
            full = node.names.joined(node.name, old)
            if any(name == full for name, _ in named):
                return None
            remapped = {node.names.joined(node.name, each) for each, _ in started.remaps}
            slips = {name: User(node, each) for name, each in named if is_slip(full, name)}
            if remapped.isdisjoint(slips):
                meant += slips.values()
    return next(iter(meant), None)


def _may_meet(old: str, nodes: list[RunningNode]) -> bool:
    """Tell whether a remap is for a name of one of the nodes of a process, or may be."""
    return not nodes or any(_has_name(old, node) for node in nodes)


def _has_name(old: str, node: RunningNode) -> bool:
    if not node.is_read or old.startswith("__") or not node.name:
        return True
    full = node.names.joined(node.name, old)
    bare = f"/{old.lstrip('/')}"
    if bare in IS_EVERYWHERE or full.rpartition("/")[2] in OWN_SERVICES:
        return True
    is_ros1 = node.unit.ros_version == 1
    for endpoint in node.endpoints:
        is_parameter = endpoint.kind is EndpointKind.PARAMETER
        if endpoint.kind.facts.interface is None and not (is_ros1 and is_parameter):
            continue
        if endpoint.name is None or (endpoint.is_guess and not is_parameter):
            return True
        name = node.names.joined(node.name, endpoint.name)
        # An action, or an image that is sent in several ways, has names below its own.
        if name == full or full.startswith(f"{name}/"):
            return True
    return False


def _names(node: RunningNode) -> list[str]:
    return [name for name, _ in _named(node)]


def _named(node: RunningNode) -> Iterator[tuple[str, SourceEndpoint]]:
    """Yield the names of a node's topics, services and actions, as far as they are known."""
    for endpoint in node.endpoints:
        if endpoint.name is not None and endpoint.kind.facts.interface is not None:
            yield endpoint.name, endpoint


@rule(
    "RG106",
    "namespace-moves-name",
    "A namespace moves the name of one side away from that of the other side.",
    severity=Severity.WARNING,
    why="A name without a `/` before it is in the namespace of its node, one with a `/` is not. So "
    "a node that a launch file puts into a namespace no longer meets those that stay outside. It "
    "is told where the launch file starts both sides, nobody that was read is at either name to "
    "meet the one that is there, and nothing that was not read is in the namespace with it.",
    bad=MOVED["bad"],
    good=MOVED["good"],
)
def namespace_moves_name(tree: SourceTree, code: Code) -> Iterator[Diagnostic]:
    """Find names that would meet if it was not for a namespace."""
    for run in runs_of(tree):
        if run.launch is None:
            continue
        for moved, other in _moved(run):
            started = moved.node.started
            if started is None or started.pushed is None:
                continue
            file, place = started.pushed
            if file is None or place is None:
                continue
            name = _resolved(moved, moved.node.names)
            far = _resolved(other, other.node.names)
            yield Diagnostic(
                code,
                f"the namespace makes `{moved.endpoint.name}` of `{moved.node.shown}` "
                f"`{name}`, and `{other.node.shown}` {other.endpoint.kind.facts.verb} `{far}`",
                span_of(place),
                Path(file),
                help="put both into the namespace, or give one of them the other's name",
                labels=(
                    Label(moved.endpoint.span, "the name that is moved", moved.path),
                    Label(other.endpoint.span, "the other side", other.path),
                ),
            )


def _moved(run: Run) -> Iterator[tuple[User, User]]:
    """Yield endpoints that a namespace has moved, each with the one that it would meet."""
    meetings = run.meetings()
    lone: dict[Place, list[User]] = {
        place: users
        for place, users in meetings.items()
        if len({user.sends for user in users}) == 1 and place[2] not in IS_EVERYWHERE
    }
    bare: dict[tuple[object, str, bool], list[User]] = defaultdict(list)
    for place, users in lone.items():
        for user in users:
            bare[place[:2], _unmoved(user), user.sends].append(user)
    strays = {user.endpoint.type for user in run.strays()}
    for place, users in lone.items():
        moved = users[0]
        type_ = moved.endpoint.type
        if not _is_moved(moved) or type_ is None or type_ in strays:
            continue
        others = [
            other
            for other in bare[place[:2], _unmoved(moved), not moved.sends]
            if other.endpoint.type == type_ and other.node.key != moved.node.key
        ]
        beside = [each for each in run.others if each.namespace == moved.node.names.namespace]
        if others and not may_use(beside, type_):
            yield moved, others[0]


def _is_moved(user: User) -> bool:
    """Tell whether a namespace that a launch file gives makes a name another one."""
    names = user.node.names
    moved = f"{names.namespace or ''}{_unmoved(user)}"
    return bool(names.namespace) and _resolved(user, names) == moved


def _unmoved(user: User) -> str:
    """Return the full name that an endpoint would have in no namespace."""
    return _resolved(user, user.node.names._replace(namespace=""))


def _resolved(user: User, names: RunNames) -> str:
    return names.resolved(user.node.name, user.endpoint.name or "")
