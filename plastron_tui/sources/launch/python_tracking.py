"""What the names of a launch file in Python stand for, as its statements change that."""

from __future__ import annotations

from typing import Any

from tree_sitter import Node

from plastron_tui.ros.launch import Item, Unread, Variable

from .python_actions import SEQUENCES, Computed, as_text, placed, unknown_text
from .python_nodes import names_in, short
from .python_values import HEAVIEST, MOST_WORK, Values, weight_of


class Tracking:
    """Names, and what is done besides.

    Attributes:
        items: what the launch description has so far.
        values: reads expressions.
        names: what each name stands for.
        descriptions: the names that stand for the launch description.
    """

    def __init__(self, values: Values) -> None:
        self.items: list[Item] = []
        self.values = values
        self.names = values.names
        self.descriptions: set[str] = set()

    def set_names(self, names: dict[str, Any]) -> None:
        """Have other names in place of all."""
        self.names.clear()
        self.names.update(names)

    def set_argument(self, key: Any, value: Any, left: Node) -> None:
        """Follow `context.launch_configurations[key] = value`."""
        known = as_text(value) or unknown_text(value)
        if isinstance(key, str):
            self.items.append(Variable(key, known, place=placed(left)))
        else:
            self.items.append(Unread(f"`{short(left)}`", place=placed(left)))

    def elements(self, value: Any, node: Node) -> list[Any]:
        """Return what a list gets that is extended by a value."""
        if type(value) in SEQUENCES:
            return list(value)
        what = value.what if isinstance(value, Computed) else short(node)
        return [Unread(f"`{what}`", place=placed(node))]

    def doubt(self, name: str, what: str, node: Node) -> None:
        """Take note that a list may get more elements, or that a value is not known any more."""
        found = self.names.get(name)
        if isinstance(found, list):
            self.change(name, [*found, Unread(f"what {what} adds", place=placed(node))])
        elif isinstance(found, dict) or (found is not None and node.type != "call"):
            self.forget(name)

    def change(self, name: str, new: Any) -> None:
        """Give a name another value, and all names that stand for the same list."""
        old, weight = self.names[name], weight_of(new)
        is_shared = isinstance(old, (list, dict))
        self.values.work += weight
        if weight > HEAVIEST or self.values.work > MOST_WORK:
            new = Computed(name)
        same = [key for key, value in self.names.items() if is_shared and value is old]
        self.names |= dict.fromkeys((name, *same), new)

    def forget(self, name: str) -> None:
        """Take note that nobody knows what a name stands for."""
        self.descriptions.discard(name)
        if name in self.names:
            self.change(name, Computed(name))

    def forget_all(self, target: Node | None) -> None:
        """Forget what is assigned to: a name, some, or a part of what a name stands for."""
        for name in set() if target is None else names_in(target):
            if target is not None and name in self.descriptions:
                self.items.append(Unread(f"`{short(target)}`", place=placed(target)))
            self.forget(name)
