"""The assignments of a unit to the fields of its variables, `descriptor.read_only = true`."""

from __future__ import annotations

import re

from tree_sitter import Node

from .arguments import arguments_of
from .scopes import Scope, Variable, last_name
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

    def set_before(
        self, node: Node, name: str, holder: Node, scope: Scope
    ) -> tuple[Node, Scope] | None:
        """Return what a field of a message is set to before, `descriptor.name = "x"`."""
        before = [
            (value, place)
            for assignment, path, value, place in self.of(last_name(holder, scope))
            if path == name
            and place.file is scope.file
            and place.enclosing("function") is scope.enclosing("function")
            and assignment.start_byte < node.start_byte
        ]
        return before[-1] if before and before[-1][1] in scope.chain else None

    def given(self, variable: Variable, owner: Scope, name: str) -> tuple[Node, Scope] | None:
        """Return what braces give a member of an object, `Limits limits{1.0, 2.0}`.

        None where it is made in another manner, or the member is set again.
        """
        writes = self._unit.writes(variable)
        has_constructor = owner.bases or owner.name in owner.functions
        if (
            len(writes) != 1
            or has_constructor
            or any(path == name for _, path, _, _ in self.of(variable.name))
        ):
            return None
        (write,) = writes
        is_listed = write.value is not None and write.value.type == "initializer_list"
        listed = arguments_of(write.value) if is_listed else write.arguments
        if not listed:
            return None
        members = [each for found in owner.variables.values() for each in found]
        names = [each.name for each in sorted(members, key=lambda each: each.start)]
        for at, each in enumerate(listed):
            named = each.child_by_field_name("designator")
            if named is not None and write.scope.file.syntax.word(named).strip(". ") == name:
                value = each.child_by_field_name("value")
                return (value, write.scope) if value is not None else None
            if named is None and at < len(names) and names[at] == name:
                return each, write.scope
        member = owner.variables.get(name)
        return (member[0].value, owner) if member and member[0].value is not None else None
