"""Whether the nodes of a finished program meet.

They do not where names are one slip apart, files disagree on a type, or a subscription asks for
more than a publisher offers.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterator, Mapping
from itertools import islice, pairwise, product
from typing import NamedTuple

from plastron_tui.diagnostics import Diagnostic, Edit, Fix, Label, Severity, Span, codes
from plastron_tui.language.declaration import Statement
from plastron_tui.language.lowering import Program
from plastron_tui.ros.interfaces import InterfaceKind, InterfaceName
from plastron_tui.ros.name_slips import LONGEST, is_slip, shortened
from plastron_tui.ros.names import resolved_name, spelled
from plastron_tui.ros.qos import Mismatch, Qos, mismatches, value_text

from .kinds import Endpoint, EndpointKind, Publisher, Subscription
from .qos_remedies import meant_qos, qos_remedy
from .type_agreement import CONFLICTS
from .workspace import Node, Workspace

_MOST = 200
"""How many names that one side alone uses are compared at most, and pairs told of."""
_Place = tuple[InterfaceKind, int, str]
"""A topic (or a service), in a generation of ROS, by its full name."""


class _User(NamedTuple):
    """A node's endpoint where others may meet it."""

    node: Node
    kind: EndpointKind
    endpoint: Endpoint
    is_guess: bool

    @property
    def place(self) -> str:
        """The file and the line that have it, "" where a statement made it."""
        return self.node.place_of(self.endpoint)

    @property
    def span(self) -> Span:
        """The statement that made it, or that loaded its file."""
        return self.endpoint.span or self.node.span


_Meetings = dict[_Place, list[_User]]


def check_meetings(
    program: Program, workspace: Workspace, version_of: Callable[[Node], int]
) -> Iterator[Diagnostic]:
    """Yield a warning for each pair of files of other types, and for names one slip apart.

    A publisher and a subscription that never match are an error.

    Args:
        program: the statements, none of which has a mistake.
        workspace: what they built.
        version_of: tells the generation of ROS that a node is for.
    """
    meetings = _meetings(workspace, version_of)
    yield from _disagreements(meetings)
    yield from islice(_unmatched(meetings, program), _MOST)
    for one, other in _slips(meetings):
        yield _misspelt(one, other, program)


def _meetings(workspace: Workspace, version_of: Callable[[Node], int]) -> _Meetings:
    found: _Meetings = defaultdict(list)
    for node in workspace.nodes.values():
        version, guesses = version_of(node), node.guesses
        for kind, endpoints in node.by_kind.items():
            interface = kind.facts.interface
            if interface is None or not endpoints:
                continue
            for written, endpoint in endpoints.items():
                place = interface, version, resolved_name(node.name, written)
                is_guess = (kind, written) in guesses
                found[place].append(_User(node, kind, endpoint, is_guess))
    return found


def _disagreements(meetings: _Meetings) -> Iterator[Diagnostic]:
    """Yield a warning for what files mean differently; of two statements that is an error."""
    for (interface, _, name), users in meetings.items():
        if len(users) < 2:
            continue
        first: dict[InterfaceName, _User] = {}
        for user in users:
            if user.endpoint.type is not None and not user.is_guess:
                first.setdefault(user.endpoint.type, user)
        for one, other in pairwise(sorted(first.values(), key=lambda user: user.span)):
            if one.node.name != other.node.name:
                what = f"{one.kind.facts.named} `{name}`"
                yield Diagnostic(
                    CONFLICTS[interface],
                    f"{what} is of type {_typed(one)}, and {_typed(other)}",
                    other.span,
                    help="nodes of two types do not meet: change one of the files",
                    labels=(Label(one.span, f"`{one.endpoint.type}` here"),),
                    severity=Severity.WARNING,
                )


def _typed(user: _User) -> str:
    place = user.place
    return f"`{user.endpoint.type}`" + (f" in {place}" if place else "")


def _unmatched(meetings: _Meetings, program: Program) -> Iterator[Diagnostic]:
    """Yield an error for each publisher and subscription of ROS 2 that never match."""
    statements: dict[Span, Statement] = {}
    for (interface, version, name), users in meetings.items():
        if interface is not InterfaceKind.MESSAGE or version != 2 or len(users) < 2:
            continue
        offers, requests = (
            _by_qos(users, EndpointKind.PUBLISHER),
            _by_qos(users, EndpointKind.SUBSCRIPTION),
        )
        for offered, requested in product(offers, requests):
            if found := mismatches(offered, requested):
                for publisher, subscription in product(offers[offered], requests[requested]):
                    types = {publisher.endpoint.type, subscription.endpoint.type}
                    # Of two types, it is said already that they do not meet.
                    if len(types) == 1 or None in types:
                        statements = statements or {each.span: each for each in program.statements}
                        yield _incompatible(name, publisher, subscription, found, statements)


def _by_qos(users: list[_User], kind: EndpointKind) -> dict[Qos, list[_User]]:
    """Return the users of a kind that are no guesses, by their quality of service."""
    found: dict[Qos, list[_User]] = defaultdict(list)
    for user in users:
        is_meant = user.kind is kind and not user.is_guess
        if is_meant and isinstance(user.endpoint, Publisher | Subscription):
            found[meant_qos(user.node, user.endpoint)].append(user)
    return found


def _incompatible(
    name: str,
    publisher: _User,
    subscription: _User,
    found: tuple[Mismatch, ...],
    statements: Mapping[Span, Statement],
) -> Diagnostic:
    policies = " and ".join(each.policy for each in found)
    offered = " and ".join(f"`{value_text(each.offered)}`" for each in found)
    requested = " and ".join(f"`{value_text(each.requested)}`" for each in found)
    verb = "does" if len(found) == 1 else "do"
    first, last = sorted((publisher, subscription), key=lambda user: user.span)
    whose = "publisher" if first is publisher else "subscription"
    sends, hears = publisher.endpoint, subscription.endpoint
    assert isinstance(sends, Publisher) and isinstance(hears, Subscription)
    remedy = qos_remedy((publisher.node, sends), (subscription.node, hears), statements)
    return Diagnostic(
        codes.QOS_INCOMPATIBLE,
        f"{policies} of topic `{name}` {verb} not match: {_says(publisher, 'offers')} {offered}, "
        f"and {_says(subscription, 'asks for')} {requested}",
        last.span,
        help=remedy.help,
        fix=remedy.fix,
        labels=(Label(first.span, f"the {whose}"),),
    )


def _says(user: _User, verb: str) -> str:
    return f"`{user.node.variable}`" + (f", in {user.place}," if user.place else "") + f" {verb}"


def _slips(meetings: _Meetings) -> Iterator[tuple[list[_User], list[_User]]]:
    """Yield who uses a name that one side alone uses, and who one that only the other side does."""
    one_sided = [
        (place, users)
        for place, users in meetings.items()
        if len(place[2]) <= LONGEST
        and (len(users) == 1 or len({user.kind.facts.sends for user in users}) == 1)
    ]
    if len({users[0].kind.facts.sends for _, users in one_sided}) < 2:
        return
    sent: dict[tuple[object, ...], list[_Place]] = defaultdict(list)
    heard: dict[tuple[object, ...], list[_Place]] = defaultdict(list)
    for place, users in one_sided[:_MOST]:
        types = {user.endpoint.type for user in users}
        if len(types) == 1 and None not in types and not any(user.is_guess for user in users):
            side = sent if users[0].kind.facts.sends else heard
            for name in shortened(place[2]):
                side[place[:2], name, users[0].endpoint.type].append(place)
    pairs = (
        (one, other) for key in sent.keys() & heard for one in sent[key] for other in heard[key]
    )
    for one, other in sorted(set(pairs)):
        senders, receivers = meetings[one], meetings[other]
        # A node that uses both names means both.
        nodes = {user.node.name for user in senders} & {user.node.name for user in receivers}
        if not nodes and is_slip(one[2], other[2]):
            yield senders, receivers


def _misspelt(one: list[_User], other: list[_User], program: Program) -> Diagnostic:
    """Return the warning, at what the program says last of the two; its fix mends all of it."""
    stated = [users for users in (one, other) if all(user.endpoint.span for user in users)]
    wrong = max(stated or (one, other), key=lambda users: users[0].span)
    first, right = wrong[0], (other if wrong is one else one)[0]
    name, full = right.endpoint.name, resolved_name(right.node.name, right.endpoint.name)
    if any(resolved_name(user.node.name, name) != full for user in wrong):
        name = full
    slot = first.kind.editing.name_slot
    names = {user.node.variable: user.endpoint.name for user in wrong}
    places = [
        each.span_of(slot)
        for each in program.statements
        if names.get(getattr(each, "node", "")) == spelled(getattr(each, slot, ""))
    ]
    edits = tuple(Edit(place, f"'{name}'") for place in places)
    is_stated = bool(stated and places)
    fix = Fix(f"write `'{name}'`", edits) if is_stated else None
    if not is_stated and all(user.place for user in wrong):
        of_each_node = {user.node.variable: user for user in wrong}.values()
        renamings = tuple(_renaming(user, name) for user in of_each_node)
        fix = Fix(f"rename it to `'{name}'`", renamings + edits)
    return Diagnostic(
        codes.MISSPELT_NAME,
        f"{_use(first)}, and {_use(right)}",
        places[0] if is_stated else first.span,
        help=f"did you mean `{name}`?",
        fix=fix,
        labels=(Label(right.span, "the other name"),),
    )


def _renaming(user: _User, name: str) -> Edit:
    """Return the edit that renames what a node has of a file, in a line behind its `load`."""
    what, old, end = user.kind.facts.named, user.endpoint.name, user.node.span.end
    return Edit(Span(end, end), f"\n{user.node.variable} renames {what} '{old}' to '{name}'")


def _use(user: _User) -> str:
    place = f" in {user.place}" if user.place else ""
    return f"`{user.node.variable}` {user.kind.facts.verb} `{user.endpoint.name}`{place}"
