"""What one side alone uses: topics that nobody sends or hears, services that nobody provides."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterator, Mapping
from functools import cache, partial
from typing import NamedTuple

from plastron_tui.diagnostics import Code, Diagnostic, Label, Severity
from plastron_tui.lint.given_names import may_be_started_otherwise
from plastron_tui.lint.rule import RULES, rule
from plastron_tui.lint.runs import Place, RunningNode, User
from plastron_tui.lint.sides import Sides, everywhere
from plastron_tui.lint.tree import SourceTree
from plastron_tui.lint.well_known import IS_EVERYWHERE, OWN_PACKAGES, OWN_SERVICES
from plastron_tui.model.kinds import EndpointKind
from plastron_tui.ros.interfaces import InterfaceName
from plastron_tui.ros.name_slips import is_slip

from .one_sided_examples import CALLED, HEARD, PROVIDED, PUBLISHED

_OUTSIDE = (
    "Any other name may have its other side beyond the workspace: a driver, a person at a command "
    "line. It is told of too where the rule is selected by its own code or name."
)
_WHERE_SURE = (
    "It is told where the workspace itself defines the type, each name of that type is known, no "
    "file is in a language that is not read, and there is another name of that type of which the "
    "other side alone is there. The code of both nodes has to be read as a whole. "
    f"{_OUTSIDE}"
)


@rule(
    "RG107",
    "never-published",
    "A topic is subscribed to, and nobody publishes it.",
    severity=Severity.WARNING,
    why=f"The callback is never called, and nothing says so. {_WHERE_SURE}",
    bad=PUBLISHED["bad"],
    good=PUBLISHED["good"],
)
def never_published(tree: SourceTree, code: Code) -> Iterator[Diagnostic]:
    """Find subscriptions to which nobody publishes."""
    return _told(tree, code, (EndpointKind.SUBSCRIPTION,), "publishes")


@rule(
    "RG108",
    "never-subscribed",
    "A topic is published, and nobody subscribes to it.",
    severity=Severity.WARNING,
    why="What is sent is lost. Many topics are there for people and their tools alone, so the rule "
    "is followed only where it is selected.",
    bad=HEARD["bad"],
    good=HEARD["good"],
    is_opt_in=True,
)
def never_subscribed(tree: SourceTree, code: Code) -> Iterator[Diagnostic]:
    """Find publishers that nobody hears."""
    return _told(tree, code, (EndpointKind.PUBLISHER,), "subscribes to")


@rule(
    "RG109",
    "service-not-provided",
    "A service or an action is called, and nobody provides it.",
    severity=Severity.WARNING,
    why=f"Who waits for it waits for ever. {_WHERE_SURE}",
    bad=PROVIDED["bad"],
    good=PROVIDED["good"],
)
def service_not_provided(tree: SourceTree, code: Code) -> Iterator[Diagnostic]:
    """Find clients of services and actions that nobody provides."""
    kinds = (EndpointKind.CLIENT, EndpointKind.ACTION_CLIENT)
    return _told(tree, code, kinds, "provides")


@rule(
    "RG110",
    "service-not-called",
    "A service or an action is provided, and nobody calls it.",
    severity=Severity.WARNING,
    why="Many services are there for people at a command line, so the rule is followed only where "
    "it is selected.",
    bad=CALLED["bad"],
    good=CALLED["good"],
    is_opt_in=True,
)
def service_not_called(tree: SourceTree, code: Code) -> Iterator[Diagnostic]:
    """Find services and actions that nobody calls."""
    kinds = (EndpointKind.SERVICE, EndpointKind.ACTION_SERVER)
    return _told(tree, code, kinds, "calls")


_OTHER_LANGUAGES = (".ino", ".js", ".ts", ".html", ".java", ".rs", ".m", ".cs", ".lua")
"""Files that may be at topics and services without being read."""


class _Lone(NamedTuple):
    """An endpoint that meets nobody, under whichever name it gets."""

    place: Place
    user: User


def _told(
    tree: SourceTree, code: Code, kinds: tuple[EndpointKind, ...], verb: str
) -> Iterator[Diagnostic]:
    is_asked = code in tree.asked or RULES[code].is_opt_in
    is_read = cache(partial(_is_read, tree))
    lone = _lone(tree)
    of_type: dict[InterfaceName | None, list[_Lone]] = defaultdict(list)
    for each in lone:
        of_type[each.user.endpoint.type].append(each)
    for one in lone:
        user = one.user
        if user.endpoint.kind not in kinds:
            continue
        message = f"nobody {verb} the {user.endpoint.kind.facts.named} `{one.place[2]}`"
        other = _counterpart(one, _beside(tree, one, of_type[user.endpoint.type]), is_read)
        if other is not None and not _may_be_renamed(tree, user.node, other.user.node):
            verb_ = other.user.endpoint.kind.facts.verb
            yield Diagnostic(
                code,
                f"{message}, and only `{other.user.node.shown}` {verb_} `{other.place[2]}`",
                user.endpoint.span,
                user.path,
                help=f"did you mean `{other.place[2]}`?",
                labels=(Label(other.user.endpoint.span, "the other name", other.user.path),),
            )
        elif is_asked and not _may_meet_a_nameless(tree, user):
            yield Diagnostic(code, message, user.endpoint.span, user.path)


def _beside(tree: SourceTree, one: _Lone, lone: list[_Lone]) -> list[_Lone]:
    """Return the endpoints that may run together with one."""
    return [each for each in lone if not tree.are_apart(one.user.path, each.user.path)]


def _lone(tree: SourceTree) -> list[_Lone]:
    """Return the endpoints that meet nobody in any run, each once."""
    sides = everywhere(tree)
    guessed = _guessed(sides)
    found: dict[object, _Lone] = {}
    met: set[object] = set()
    for place, users in sides.meetings.items():
        directions = {user.sends for user in users} | guessed.get(place, set())
        for user in users:
            key = user.path, user.endpoint.span
            if len(directions) > 1 or _is_own_affair(place, user):
                met.add(key)
            found.setdefault(key, _Lone(place, user))
    return [each for key, each in found.items() if key not in met]


def _guessed(sides: Sides) -> Mapping[Place, set[bool]]:
    """Return the sides at names that endpoints have unless somebody gives them others."""
    found: dict[Place, set[bool]] = defaultdict(set)
    for user in sides.strays:
        interface, name = user.endpoint.kind.facts.interface, user.endpoint.name
        if interface is not None and name is not None:
            full = user.node.names.resolved(user.node.name, name)
            found[interface, user.node.unit.ros_version, full].add(user.sends)
    return found


def _is_own_affair(place: Place, user: User) -> bool:
    """Tell whether ROS itself, or its tools, may be at a name."""
    type_ = user.endpoint.type
    return (
        place[2] in IS_EVERYWHERE
        or place[2].rpartition("/")[2] in OWN_SERVICES
        or type_ is None
        or type_.package in OWN_PACKAGES
    )


def _counterpart(
    one: _Lone, lone: list[_Lone], is_read: Callable[[InterfaceName], bool]
) -> _Lone | None:
    """Return the only endpoint that can have been meant, of those of its type.

    None where there is none for sure.
    """
    type_ = one.user.endpoint.type
    if type_ is None or not is_read(type_):
        return None
    others = [
        each
        for each in lone
        if each.place[:2] == one.place[:2]
        and each.user.sends is not one.user.sends
        and each.user.node.key != one.user.node.key
    ]
    # What a node of either side is handed to may be at the name as well.
    if not all(each.user.node.unit.code.is_closed for each in (one, *others)):
        return None
    places = {each.place for each in others}
    if len(places) != 1 or any(
        each.user.sends is one.user.sends and each.place != one.place for each in lone
    ):
        return None
    names = one.place[2], others[0].place[2]
    # A slip is another rule's to tell, and a node that nobody launches may get any namespace.
    is_moved = names[0].endswith(names[1]) or names[1].endswith(names[0])
    written = [(each.user.endpoint.name or "").lstrip("/") for each in (one, others[0])]
    return None if is_slip(*names) or is_slip(*written) or is_moved else others[0]


def _is_read(tree: SourceTree, type_: InterfaceName) -> bool:
    """Tell whether a type is the workspace's own, and whoever uses it is read."""
    if type_.package not in tree.packages or not tree.is_whole:
        return False
    strays = everywhere(tree).strays
    if any(user.endpoint.type == type_ for user in strays):
        return False
    return not any(file.endswith(_OTHER_LANGUAGES) for file in tree.files)


def _may_be_renamed(tree: SourceTree, *nodes: RunningNode) -> bool:
    """Tell whether what is not known of a launch file may start a node under other names."""
    packages = {each.unit.package for each in nodes if each.started is None}
    return any(may_be_started_otherwise(tree, each) for each in packages)


def _may_meet_a_nameless(tree: SourceTree, user: User) -> bool:
    """Tell whether an endpoint of its package, whose name is not known, may be the other side."""
    return any(
        stray.endpoint.name is None
        and stray.sends is not user.sends
        and stray.endpoint.kind.facts.interface is user.endpoint.kind.facts.interface
        and stray.endpoint.type == user.endpoint.type
        and stray.node.unit.package == user.node.unit.package
        for stray in everywhere(tree).strays
    )
