"""Calls of the functions that a launch file in Python has itself."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from typing import Any, NamedTuple

from tree_sitter import Node

from plastron_tui.ros.launch import Group, Item, Place, Unread

from .python_actions import SEQUENCES, Computed
from .python_deferred import Opaque, items_in, maybe
from .python_functions import Function
from .python_values import MOST_WORK, Values

_DEEPEST = 10
_MOST_CODE = 200_000
"""How many bytes of functions are followed at most, each as often as it is called."""


class Returned(NamedTuple):
    """What a function returns, and where."""

    value: Any
    place: Place
    what: str


class Calls:
    """Follows calls, with an end to them."""

    def __init__(self, reader: Any) -> None:
        self.values = Values(self.run)
        self._reader = reader
        self._running: list[Function] = []
        self._code = 0

    def run(self, function: Function, positional: list[Any], named: dict[str, Any]) -> Any:
        """Return what a function returns, `Computed` where that is not known."""
        unknown = Computed(function.name)
        bound = function.bound(positional, named)
        body = function.body
        self._code += len(function.node.text or b"")
        self.values.work += len(function.names)
        for name in function.outer_names() & self.values.names.keys():
            self.values.names[name] = Computed(name)
        if bound is None or body is None or not function.is_followed:
            return unknown
        is_much = self._code > _MOST_CODE or self.values.work > MOST_WORK
        if is_much or function in self._running or len(self._running) >= _DEEPEST:
            return unknown
        outer, values = self.values.names, self.values
        self._running.append(function)
        try:
            values.names = function.names
            for name, value in bound.items():
                if isinstance(value, Node):
                    bound[name] = values.value(value)
            values.names = {**function.names, **bound}
            if function.node.type == "lambda":
                return values.value(body)
            return self._result(function, body)
        finally:
            values.names = outer
            self._running.pop()

    def _result(self, function: Function, body: Node) -> Any:
        reader = self._reader(self, is_function=True)
        own = function.locals()
        names = self.values.names
        reader.block(body)
        if any(each.what for each in reader.returned):
            # What was done before the return of a branch is not among the names behind it.
            for name in function.named() & function.names.keys() - own:
                self._doubt(function, name)
            return _whole(reader.items, reader.returned, function.name)
        for name in function.names.keys() & names.keys() - own:
            # A list of the function around it has more elements now.
            function.names[name] = names[name]
        return _whole(reader.items, reader.returned, function.name)

    def _doubt(self, function: Function, name: str) -> None:
        """Let a list of the function around one have what nobody knows besides."""
        known = function.names[name]
        if isinstance(known, list):
            what = Unread(f"what `{function.name}` adds")
            function.names[name] = [*known, what]

    def expanded(self, items: Iterable[Item], depth: int = 0) -> tuple[Item, ...]:
        """Return items with what functions return that are called when the file runs."""
        return tuple(self._expanded(item, depth) for item in items)

    def _expanded(self, item: Item, depth: int) -> Item:
        if isinstance(item, Opaque) and depth >= _DEEPEST:
            return Unread(f"`{item.function.name}`", place=item.place)
        if isinstance(item, Opaque):
            value = self.run(item.function, list(item.positional), dict(item.named))
            found = self.expanded(items_in(value, item.place), depth + 1)
            return Group(found, is_scoped=False, condition=item.condition, place=item.place)
        if isinstance(item, Group):
            return replace(item, items=self.expanded(item.items, depth))
        return item


def _whole(items: Sequence[Item], returned: Sequence[Returned], name: str) -> Any:
    """Return what a function comes to.

    Args:
        items: what it does besides, or what of it is not understood.
        returned: what it returns; where that is not sure, each with its condition.
        name: what it is called.
    """
    if len(returned) == 1 and not returned[0].what:
        value = returned[0].value
    elif all(isinstance(x.value, Item) or x.value is None or type(x.value) in SEQUENCES
             for x in returned):  # fmt: skip
        value = [
            maybe(items_in(each.value, each.place), each.what or name, each.place)
            for each in returned
        ] or None
    else:
        return Computed(name)
    if not items:
        return value
    if isinstance(value, Item) or value is None or type(value) in SEQUENCES:
        return [*items, *items_in(value, items[0].place)]
    return Computed(name)
