"""What is wrong with the names by which nodes that run together meet."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Mapping
from itertools import permutations

from plastron_tui.diagnostics import Code, Diagnostic, Label, Severity
from plastron_tui.lint.rule import rule
from plastron_tui.lint.runs import Place, User, runs_of
from plastron_tui.lint.sides import everywhere, workspaces
from plastron_tui.lint.tree import SourceTree, once_a_tree
from plastron_tui.model.kinds import EndpointKind
from plastron_tui.ros.interfaces import InterfaceName
from plastron_tui.ros.name_slips import LONGEST, is_slip, shortened

from .graph_examples import LISTENER, TALKER, listener

_Met = Mapping[Place, list[User]]


@rule(
    "RG104",
    "misspelt-name",
    "A name that one side alone uses is one slip from a name that the other side uses.",
    severity=Severity.WARNING,
    why="The two were to meet, and neither says that nobody is there. Names that differ by a "
    "digit, or by letters that tell things of a kind apart (`x`, `y`, `z`), are not told, nor are "
    "those of different types, those of a node that hears by the one what it sends by the other, "
    "nor a publisher beside a topic that has one.",
    bad={"talker.py": TALKER, "listener.py": listener(topic="chater")},
    good={"talker.py": TALKER, "listener.py": LISTENER},
)
def misspelt_name(tree: SourceTree, code: Code) -> Iterator[Diagnostic]:
    """Find names that are one slip apart."""
    near = _near_names(tree)
    for meetings in (*(run.meetings() for run in runs_of(tree)), *workspaces(tree)):
        for wrong, right in _slips(meetings, near):
            user = meetings[wrong][0]
            other = next(each for each in meetings[right] if each.sends is not user.sends)
            help_ = f"did you mean `{right[2]}`?"
            if len({each.sends for each in meetings[right]}) == 1:
                help_ = f"write `{right[2]}` here, or `{wrong[2]}` there: one of them is a slip"
            yield Diagnostic(
                code,
                f"`{user.node.shown}` {user.endpoint.kind.facts.verb} `{wrong[2]}`, and "
                f"`{other.node.shown}` {other.endpoint.kind.facts.verb} `{right[2]}`",
                user.endpoint.span,
                user.path,
                help=help_,
                labels=(Label(other.endpoint.span, "the other name", other.path),),
            )


def _slips(meetings: _Met, near: Mapping[Place, list[Place]]) -> Iterator[tuple[Place, Place]]:
    """Yield pairs of a name that has one side alone, and one that it was to be.

    Where both have one side alone, the one that hears is taken for the wrong one.
    """
    for one in sorted(near.keys() & meetings.keys()):
        types = _types(meetings[one])
        if len(types) != 1 or len({user.sends for user in meetings[one]}) != 1:
            continue
        for other in near[one]:
            users = meetings.get(other, [])
            if types <= _types(users) and _is_meant(meetings[one], users):
                yield one, other


def _types(users: list[User]) -> set[InterfaceName]:
    return {user.endpoint.type for user in users if user.endpoint.type is not None}


@once_a_tree
def _near_names(tree: SourceTree) -> Mapping[Place, list[Place]]:
    """Return the names that are one slip from each, whoever runs together."""
    alike: dict[tuple[object, str], list[Place]] = defaultdict(list)
    for place in everywhere(tree).meetings:
        for name in shortened(place[2]) if len(place[2]) <= LONGEST else ():
            alike[place[:2], name].append(place)
    pairs = {pair for places in alike.values() for pair in permutations(places, 2)}
    found: dict[Place, list[Place]] = defaultdict(list)
    for one, other in sorted(pairs):
        if is_slip(one[2], other[2]):
            found[one].append(other)
    return found


def _is_meant(wrong: list[User], right: list[User]) -> bool:
    """Tell whether users of a name may have been to use another one."""
    sides = {user.sends for user in right}
    is_topic = wrong[0].endpoint.kind is EndpointKind.PUBLISHER
    if wrong[0].sends is True and (sides == {False} or is_topic):
        # Who hears a topic that has a publisher of its own waits for no other one.
        return False
    # A node that hears by one name and sends by the other may pass on what it hears.
    across = {user.node.key for user in right if user.sends is not wrong[0].sends}
    return not across <= {user.node.key for user in wrong}
