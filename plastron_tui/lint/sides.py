"""Who sends, and who hears, in all of a workspace."""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Iterable, Mapping
from typing import NamedTuple

from .runs import Place, User, runs_of
from .tree import SourceTree, once_a_tree


class Sides(NamedTuple):
    """The endpoints of all runs together.

    Attributes:
        meetings: who is at each topic, service and action, whichever run it is in.
        strays: the endpoints whose name is not sure.
    """

    meetings: Mapping[Place, list[User]]
    strays: tuple[User, ...]


@once_a_tree
def everywhere(tree: SourceTree) -> Sides:
    """Return the endpoints of all runs of a workspace, each once for each name that it gets."""
    found: dict[Place, dict[object, User]] = defaultdict(dict)
    strays: dict[object, User] = {}
    for run in runs_of(tree):
        for place, users in run.meetings().items():
            for user in users:
                found[place].setdefault((user.node.key, user.endpoint.span), user)
        for user in run.strays():
            strays.setdefault((user.path, user.endpoint.span), user)
    meetings = {place: list(users.values()) for place, users in found.items()}
    return Sides(meetings, tuple(strays.values()))


@once_a_tree
def workspaces(tree: SourceTree) -> tuple[Mapping[Place, list[User]], ...]:
    """Return who is at each name in each workspace, for packages of one name keep several apart.

    What may be of several workspaces is in each of them.
    """
    whole = everywhere(tree).meetings
    number_of = tree.workspaces.number_of
    numbers = {user.path: number_of(user.path) for users in whole.values() for user in users}
    found = []
    for number in tree.workspaces.widest(set(numbers.values())):
        met = {place: _beside(tree, number, users) for place, users in whole.items()}
        found.append({place: users for place, users in met.items() if users})
    return tuple(found)


@once_a_tree
def gatherings(tree: SourceTree) -> tuple[tuple[Place, list[User]], ...]:
    """Return who is together at each name in some workspace; who is in several, is told of once."""
    known, meetings = tree.workspaces, everywhere(tree).meetings
    return tuple(
        (place, _beside(tree, number, users))
        for place, users in meetings.items()
        for number in known.widest({known.number_of(user.path) for user in users})
    )


def _beside(tree: SourceTree, number: int, users: Iterable[User]) -> list[User]:
    """Return the users that may be in a workspace."""
    known = tree.workspaces
    return [user for user in users if not known.are_apart(number, known.number_of(user.path))]


def are_parts(tree: SourceTree, one: User, other: User) -> bool:
    """Tell whether the nodes of two endpoints are of one robot, as far as packages say so.

    Two that launch files start are told of only where one of them starts both.
    """
    is_by_hand = None in (one.node.started, other.node.started)
    return is_by_hand and are_connected(tree, one.node.unit.package, other.node.unit.package)


_LEFT_BEHIND = re.compile(
    r"(^|[_\W\d])(old|older|backup|bak|copy|deprecated|archive|unused|trash)($|[_\W\d])", re.I
)


def is_left_behind(tree: SourceTree, user: User) -> bool:
    """Tell whether a file's path in the workspace says that another one is used in its place."""
    return _LEFT_BEHIND.search(str(user.path).removeprefix(str(tree.root))) is not None


_NEW_WORD = re.compile(r"(?<=[a-z\d])[A-Z]|[A-Z][a-z]")


def is_variant(one: str, other: str) -> bool:
    """Tell whether one type carries what the other does, and more: `Twist`, `TwistStamped`.

    Its name has whole words more at the end: what is written before makes another type, such as
    `UInt32` of `Int32`.
    """
    short, long = sorted((one, other), key=len)
    return long.startswith(short) and _NEW_WORD.match(long, len(short)) is not None


def are_connected(tree: SourceTree, one: str, other: str) -> bool:
    """Tell whether packages are parts of one robot: by what they, or others, depend on."""
    if one == other:
        return True
    needs = _needs(tree)
    first, second = needs.get(one, frozenset()), needs.get(other, frozenset())
    return (
        other in first
        or one in second
        or bool(first & second)
        or any({one, other} <= each for each in needs.values())
    )


@once_a_tree
def _needs(tree: SourceTree) -> Mapping[str, frozenset[str]]:
    """Return the packages of the workspace that each of them depends on."""
    builds = {name: package.build for name, package in tree.packages.items()}
    return {
        name: frozenset(
            each.name
            for each in (() if build is None else build.dependencies)
            if each.name in builds
        )
        for name, build in builds.items()
    }
