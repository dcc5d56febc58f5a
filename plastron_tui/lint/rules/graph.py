"""What is wrong between nodes that run together."""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path

from plastron_tui.diagnostics import Code, Diagnostic, Label, Span
from plastron_tui.lint.misspelt_types import misspelt_types
from plastron_tui.lint.rule import rule
from plastron_tui.lint.runs import Place, RunningNode, User, runs_of, span_of
from plastron_tui.lint.sides import are_parts, everywhere, gatherings, is_left_behind, is_variant
from plastron_tui.lint.tree import SourceTree
from plastron_tui.lint.well_known import IS_EVERYWHERE
from plastron_tui.model.kinds import EndpointKind
from plastron_tui.ros.interfaces import InterfaceKind, InterfaceName
from plastron_tui.ros.launch_started import Site, Started
from plastron_tui.ros.qos import Mismatch, mismatches, value_text
from plastron_tui.ros.run_names import RunNames

from .graph_examples import LISTENER, NAMED_TWICE, TALKER, listener, talker

_Typed = tuple[InterfaceName, User]


@rule(
    "RG101",
    "type-conflict",
    "Two nodes that run together use one topic, service or action with different types.",
    why="They never hear each other: ROS 1 refuses the connection with a line in its log, ROS 2 "
    "without a word. It is told of nodes that one launch file starts. Of nodes that none starts "
    "together it is told where the one sends what the other one is to hear, and nobody there is at "
    "the other side with the first one's type: two drivers of which a user starts one are no "
    "mistake. Where nothing says that their packages belong together, the type has to be that of "
    "one file alone, and no variant of the other one (`Twist`, `TwistStamped`). A node that itself "
    "sends or hears two types by a name has a choice, and is left alone. A type that its package "
    "does not have, and that is one slip away from one that it has, is told by itself.",
    bad={"talker.py": TALKER, "listener.py": listener(type="Int32")},
    good={"talker.py": TALKER, "listener.py": LISTENER},
)
def type_conflict(tree: SourceTree, code: Code) -> Iterator[Diagnostic]:
    """Find topics, services and actions of two types."""
    yield from _misspelt(tree, code)
    told: set[tuple[Path, Span]] = set()
    for run in runs_of(tree):
        for place, users in run.meetings().items():
            for user, other in _conflicts(tree, place, users, is_run=run.launch is not None):
                told.add((user.path, user.endpoint.span))
                yield _conflict(code, place, user, other)
    for place, users in gatherings(tree):
        for user, other in _conflicts(tree, place, users, is_run=False):
            if (other.path, other.endpoint.span) in told or _is_moved(user, other):
                continue
            if any(is_left_behind(tree, each) for each in (user, other)):
                continue
            far = other.endpoint.type, other.sends
            across = [each for each in users if (each.endpoint.type, each.sends) == far]
            part = next((each for each in across if are_parts(tree, user, each)), None)
            if part is not None or _is_odd(users, user, other):
                yield _conflict(code, place, user, part or other)


def _misspelt(tree: SourceTree, code: Code) -> Iterator[Diagnostic]:
    for (file, span), (type_, meant) in misspelt_types(tree).items():
        message = f"`{type_.package}` has no type `{type_.name}`"
        yield Diagnostic(code, message, span, file, f"did you mean `{meant}`?")


def _as_meant(tree: SourceTree, user: User) -> User:
    """Return an endpoint with the type that is meant where it has one that there is not."""
    found = misspelt_types(tree).get((user.path, user.endpoint.span))
    if found is None:
        return user
    type_ = InterfaceName(found[0].package, found[1])
    return user._replace(endpoint=user.endpoint._replace(type=type_))


def _is_odd(users: Iterable[User], user: User, other: User) -> bool:
    """Tell whether a file alone uses its type for a name, and it is no variant of the other one.

    Variants of a type are what two robots of a workspace differ by.
    """
    one, far = user.endpoint.type, other.endpoint.type
    if one is None or far is None or is_variant(one.name, far.name):
        return False
    return not any(each.endpoint.type == one and each.path != user.path for each in users)


def _is_moved(one: User, other: User) -> bool:
    """Tell whether two types may be one that has moved to another package."""
    names = {
        None if each.endpoint.type is None else each.endpoint.type.name for each in (one, other)
    }
    return len(names) == 1


def _conflicts(
    tree: SourceTree, place: Place, users: Sequence[User], *, is_run: bool
) -> Iterator[tuple[User, User]]:
    misspelt = misspelt_types(tree)
    meant = (_as_meant(tree, user) for user in users)
    settled = [] if place[2] in IS_EVERYWHERE else _settled(meant)
    types = Counter(type_ for type_, _ in settled)
    if len(types) < 2:
        return
    usual = types.most_common(1)[0][0]
    for type_, user in settled:
        other = _conflicting(usual, (type_, user), settled, is_run=is_run)
        if other is None or (not is_run and _may_meet_a_stray(tree, place, user)):
            continue
        if any((each.path, each.endpoint.span) in misspelt for each in (user, other[1])):
            continue
        if _are_two(tree, place[:2], type_, other[0]):
            yield user, other[1]


def _may_meet_a_stray(tree: SourceTree, place: Place, user: User) -> bool:
    """Tell whether somebody at the other side of a name may have an endpoint's type: a guess."""
    return any(
        each.sends is not user.sends
        and each.endpoint.type in (None, user.endpoint.type)
        and each.endpoint.name is not None
        and each.endpoint.kind.facts.interface is place[0]
        and each.node.names.resolved(each.node.name, each.endpoint.name) == place[2]
        for each in everywhere(tree).strays
    )


def _conflict(code: Code, place: Place, user: User, other: User) -> Diagnostic:
    type_, far = user.endpoint.type, other.endpoint.type
    return Diagnostic(
        code,
        f"{user.endpoint.kind.facts.named} `{place[2]}` is of type `{type_}` here, and of type "
        f"`{far}` in `{other.node.shown}`",
        user.endpoint.span,
        user.path,
        labels=(
            Label(other.endpoint.span, f"`{far}` here", other.path),
            *_joined(place[2], user, other),
        ),
    )


def _joined(name: str, *users: User) -> Iterator[Label]:
    """Yield the remaps of launch files that give endpoints their name."""
    for user in users:
        started, own = user.node.started, user.endpoint.name
        if started is None or own is None:
            continue
        names = RunNames(started.namespace)
        before = names.resolved(user.node.name, own)
        for (old, _), (file, place) in zip(started.remaps, started.remap_places, strict=False):
            is_it = before != name and names.resolved(user.node.name, old) == before
            if is_it and file is not None and place is not None:
                yield Label(span_of(place), f"this makes `{name}` of `{own}`", Path(file))
                break


def _settled(users: Iterable[User]) -> list[_Typed]:
    """Return the users whose node has one type alone for the name and side, one of each."""
    found: dict[object, dict[InterfaceName, User]] = defaultdict(dict)
    for user in users:
        if user.endpoint.type is not None:
            found[user.node.key, user.sends].setdefault(user.endpoint.type, user)
    return [pair for types in found.values() if len(types) == 1 for pair in types.items()]


def _conflicting(
    usual: InterfaceName, typed: _Typed, settled: Iterable[_Typed], *, is_run: bool
) -> _Typed | None:
    """Return whom an endpoint cannot hear, or be heard by; None where it is right, or may be."""
    type_, user = typed
    across = [each for each in settled if each[1].sends is not user.sends]
    others = [each for each in across if each[0] != type_]
    has_partner = any(type_ == each[0] for each in across)
    if is_run:
        beside = [each for each in settled if each[0] == usual]
        return None if type_ == usual else next(iter((*others, *beside)), None)
    if has_partner or not others:
        return None
    # Of two that cannot hear each other, the one that is more alone is told of.
    first = others[0]
    is_other_alone = not any(
        each[0] == first[0] and each[1].sends is not first[1].sends for each in settled
    )
    return None if is_other_alone and type_ == usual else first


def _are_two(
    tree: SourceTree, of: tuple[InterfaceKind, int], one: InterfaceName, other: InterfaceName
) -> bool:
    """Tell whether two types differ; a package that has moved may have left a name behind."""
    catalog = tree.catalogs.get(of[1])
    if one.name != other.name or catalog is None:
        return True
    return all(catalog.find(each, of[0]) is not None for each in (one, other))


@rule(
    "RG102",
    "qos-mismatch",
    "A publisher and a subscription that run together never match, by their quality of service.",
    why="In ROS 2 a publisher has to offer no less than a subscription asks for; else no message "
    "arrives, and the only sign is a warning in the log of either. Policies that are not known, or "
    "that the middleware chooses, are no reason. Of nodes that no launch file starts together, one "
    "has to be without anybody else whom it matches.",
    bad={"talker.py": talker(qos="qos_profile_sensor_data"), "listener.py": LISTENER},
    good={"talker.py": TALKER, "listener.py": LISTENER},
)
def qos_mismatch(tree: SourceTree, code: Code) -> Iterator[Diagnostic]:
    """Find publishers and subscriptions of ROS 2 that never match."""
    runs = ((each, True) for run in runs_of(tree) for each in run.meetings().items())
    for ((_, version, name), users), is_run in (*runs, *((x, False) for x in gatherings(tree))):
        if version == 2:
            yield from _never_matching(code, name, users, is_run=is_run)


def _never_matching(
    code: Code, name: str, users: Sequence[User], *, is_run: bool
) -> Iterator[Diagnostic]:
    """Yield what is wrong between the users of a topic, once for each that hears.

    Of two that no launch file starts together, one has to be without anybody whom it may match.
    """
    senders = [user for user in users if user.endpoint.kind is EndpointKind.PUBLISHER]
    receivers = [user for user in users if user.endpoint.kind is EndpointKind.SUBSCRIPTION]
    for receiver in _alone(receivers):
        for sender in _alone(senders):
            found = _never_match(code, name, sender, receiver)
            if found is None:
                continue
            if is_run or not (
                any(_may_match(each, receiver) for each in senders)
                and any(_may_match(sender, each) for each in receivers)
            ):
                yield found
                break


def _alone(users: Iterable[User]) -> list[User]:
    """Return the users of which their node has no other: one of several may be a choice."""
    found: dict[object, list[User]] = defaultdict(list)
    for user in users:
        found[user.node.key].append(user)
    return [each[0] for each in found.values() if len(each) == 1]


def _may_match(sender: User, receiver: User) -> bool:
    """Tell whether messages may go from one to the other, as far as their types and QoS say."""
    return _are_of_one_type(sender, receiver) and not _mismatches(sender, receiver)


def _are_of_one_type(sender: User, receiver: User) -> bool:
    """Tell whether two have one type, or may have: another rule tells of those that have two."""
    return len({sender.endpoint.type, receiver.endpoint.type} - {None}) < 2


def _mismatches(sender: User, receiver: User) -> Sequence[Mismatch]:
    """Return the policies that keep two apart, as far as they are known."""
    offered, requested = sender.endpoint.qos, receiver.endpoint.qos
    return () if offered is None or requested is None else mismatches(offered, requested)


def _never_match(code: Code, name: str, sender: User, receiver: User) -> Diagnostic | None:
    found = _mismatches(sender, receiver) if _are_of_one_type(sender, receiver) else ()
    if not found:
        return None
    policies = " and ".join(each.policy for each in found)
    offers = " and ".join(f"`{value_text(each.offered)}`" for each in found)
    asks = " and ".join(f"`{value_text(each.requested)}`" for each in found)
    verb = "does" if len(found) == 1 else "do"
    return Diagnostic(
        code,
        f"{policies} of topic `{name}` {verb} not match: `{sender.node.shown}` offers {offers}"
        f", and `{receiver.node.shown}` asks for {asks}",
        receiver.endpoint.span,
        receiver.path,
        labels=(Label(sender.endpoint.span, "the publisher", sender.path),),
    )


@rule(
    "RG103",
    "duplicate-node-name",
    "A launch file starts two nodes of one name.",
    why="ROS 1 ends the first of them when the second one starts. ROS 2 keeps both, and "
    "parameters, logs and `ros2 node` mix them up. A node that gets no name in the launch file has "
    "the one that its code says.",
    bad=NAMED_TWICE["bad"],
    good=NAMED_TWICE["good"],
)
def duplicate_node_name(tree: SourceTree, code: Code) -> Iterator[Diagnostic]:
    """Find nodes that get the full name of another one of their launch file."""
    for run in runs_of(tree):
        if run.launch is None:
            continue
        own = {id(node.started): node for node in run.nodes}
        counts = Counter(id(node.started) for node in run.nodes)
        first: dict[str, Started] = {}
        looped: set[str] = set()
        for started in run.launch.resolved.started:
            node = own.get(id(started)) if counts[id(started)] == 1 else None
            name = _name_of(started, node)
            if name is None:
                continue
            other = first.setdefault(name, started)
            places = None if other is started else _places(other, started)
            if places is None or name in looped:
                continue
            if places[0] == places[1]:
                looped.add(name)
            yield from _named_twice(code, name, run.launch.path, *places)


def _name_of(started: Started, node: RunningNode | None) -> str | None:
    """Return the full name of a node that is started, None where it is not known."""
    if not started.is_named or any("__n" in value for _, value in started.others):
        return None
    if started.name is not None:
        return started.full_name
    if node is None or node.node.name is None or node.unit.ros_version != 2:
        return None
    return node.full_name


def _places(first: Started, second: Started) -> tuple[Site, Site] | None:
    """Return what makes two nodes of two: where each is started, or its file is included.

    It is one place twice where a loop starts both.
    """
    one, other = (first.file, first.place), (second.file, second.place)
    if one != other:
        return one, other
    pairs = zip(first.included, second.included, strict=False)
    return next(((a, b) for a, b in pairs if a != b), (one, other))


def _named_twice(
    code: Code, name: str, launch: Path, first: Site, second: Site
) -> Iterator[Diagnostic]:
    (file, place), (other_file, other_place) = second, first
    if file is None or place is None:
        return
    labels: tuple[Label, ...] = ()
    if first == second:
        message = f"a loop starts more than one node called `{name}`"
        yield Diagnostic(code, message, span_of(place), Path(file))
        return
    if other_file is not None and other_place is not None:
        labels = (Label(span_of(other_place), "the other one", Path(other_file)),)
    starter = "the file" if Path(file) == launch == Path(other_file or file) else f"`{launch.name}`"
    message = f"{starter} starts another node that is called `{name}`, too"
    yield Diagnostic(code, message, span_of(place), Path(file), labels=labels)
