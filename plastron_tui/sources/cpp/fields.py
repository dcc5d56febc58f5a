"""The assignments of a unit to the fields of its variables, `descriptor.read_only = true`."""

from __future__ import annotations

import re

from tree_sitter import Node

from .scopes import Scope
from .unit import Unit

Field = tuple[Node, str, Node, Scope]
"""An assignment, the path of the field behind the variable, the value, and the scope."""

_PATH = re.compile(r"(?:this->)?(\w+)(?:\.|->)([\w.\[\]>-]+)")


class Fields:
    """The assignments to fields, by the name of the variable."""

    def __init__(self, unit: Unit) -> None:
        self._unit = unit
        self._found: dict[str, list[Field]] | None = None

    def of(self, name: str) -> list[Field]:
        """Return the assignments to the fields of variables of a name, in the order of the text."""
        if self._found is None:
            self._found = {}
            for file in self._unit.files:
                for node, scope in file.assignments:
                    left = node.child_by_field_name("left")
                    right = node.child_by_field_name("right")
                    if left is None or right is None or left.type != "field_expression":
                        continue
                    path = _PATH.fullmatch("".join(file.syntax.word(left).split()))
                    if path is not None:
                        self._found.setdefault(path[1], []).append((node, path[2], right, scope))
        return self._found.get(name, [])
