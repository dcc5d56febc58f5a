"""What is wrong with the names by which nodes that run together meet."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Mapping

from plastron_tui.diagnostics import Code, Diagnostic, Label, Severity
from plastron_tui.lint.rule import rule
from plastron_tui.lint.runs import Place, User, runs_of
from plastron_tui.lint.sides import workspaces
from plastron_tui.lint.tree import SourceTree
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
    for meetings in (*(run.meetings() for run in runs_of(tree)), *workspaces(tree)):
        for wrong, right in _slips(meetings):
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


def _slips(meetings: _Met) -> Iterator[tuple[Place, Place]]:
    """Yield pairs of a name that has one side alone, and one that it was to be.

    Where both have one side alone, the one that hears is taken for the wrong one.
    """
    lone: dict[tuple[object, str, InterfaceName], list[Place]] = defaultdict(list)
    known: dict[tuple[object, str, InterfaceName], list[Place]] = defaultdict(list)
    for place, users in list(meetings.items()):
        types = {user.endpoint.type for user in users if user.endpoint.type is not None}
        if len(place[2]) > LONGEST:
            continue
        is_lone = len({user.sends for user in users}) == 1
        for name in shortened(place[2]):
            for type_ in types:
                known[place[:2], name, type_].append(place)
                if is_lone and len(types) == 1:
                    lone[place[:2], name, type_].append(place)
    pairs = {
        (one, other)
        for key in lone
        for one in lone[key]
        for other in known[key]
        if one != other and _is_meant(meetings[one], meetings[other])
    }
    yield from (pair for pair in sorted(pairs) if is_slip(pair[0][2], pair[1][2]))


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
