"""What names stand for behind an `if` of a launch file in Python."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

from plastron_tui.ros.launch import Group, Item, Place, Unread
from plastron_tui.ros.launch_text import Text

from .python_actions import Computed
from .python_deferred import maybe

_MISSING = object()


class Outcome(NamedTuple):
    """How one branch ends.

    Attributes:
        names: what names stand for then.
        what: when it is taken, for a person.
        is_over: whether it does not go on behind the `if`.
    """

    names: dict[str, Any]
    what: str
    is_over: bool


def merged(before: dict[str, Any], outcomes: Sequence[Outcome], place: Place) -> dict[str, Any]:
    """Return what names stand for where one of some branches was taken, and nobody knows which."""
    going = [each for each in outcomes if not each.is_over]
    if not going:
        # Nobody comes there.
        return dict(before)
    found: dict[str, Any] = {}
    # Two names for one list stay so.
    known: dict[tuple[int, ...], Any] = {}
    for name in dict.fromkeys(key for each in going for key in each.names):
        values = [each.names.get(name, _MISSING) for each in going]
        if all(each is values[0] for each in values):
            found[name] = values[0]
        else:
            same = (id(before.get(name)), *map(id, values))
            if same not in known:
                known[same] = _merged(name, before.get(name), going, place)
            found[name] = known[same]
    return found


def _merged(name: str, before: Any, going: Sequence[Outcome], place: Place) -> Any:
    base = before if isinstance(before, list) else []
    values = [each.names.get(name) for each in going]
    if type(values[0]) in (bool, int, float, str, Text) and len({type(x) for x in values}) == 1:
        return values[0] if len(set(values)) == 1 else Computed(name)
    if all(each is None or isinstance(each, Item) for each in values):
        pairs = zip(going, values, strict=True)
        found = tuple(maybe((x,), each.what, place) for each, x in pairs if x is not None)
        return Group(found, is_scoped=False, place=place)
    more: list[Any] = []
    for each, value in zip(going, values, strict=True):
        if not isinstance(value, list) or not _begins(value, base):
            return _of_items(name, going, place)
        more += _doubtful(value[len(base) :], each.what, place)
    return [*base, *more] if base or _all_items(more) else Computed(name)


def _of_items(name: str, going: Sequence[Outcome], place: Place) -> Any:
    """Return the list of what lists of actions hold that begin in different ways."""
    lists = [each.names.get(name) for each in going]
    if not all(isinstance(each, list) and _all_items(each) for each in lists):
        return Computed(name)
    return [
        x
        for each, value in zip(going, lists, strict=True)
        for x in _doubtful(value or [], each.what, place)
    ]


def _doubtful(added: list[Any], what: str, place: Place) -> list[Any]:
    if not added:
        return []
    if _all_items(added):
        return [maybe(added, what, place)]
    return [Unread(f"what `{what}` adds", place=place)]


def _all_items(found: list[Any]) -> bool:
    return all(isinstance(each, Item) for each in found)


def _begins(whole: list[Any], first: list[Any]) -> bool:
    return len(whole) >= len(first) and all(a is b for a, b in zip(first, whole, strict=False))
