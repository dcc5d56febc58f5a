"""Functions of a launch file: what their arguments are, and which names are their own."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from tree_sitter import Node

from .python_actions import Computed
from .python_nodes import field, source_of

_NOT_FOLLOWED = re.compile(rb"\b(?:yield|await|global|nonlocal)\b")
_OUTER = re.compile(rb"\b(?:global|nonlocal)\b([\w, \t]*)")
_WORD = re.compile(rb"[A-Za-z_]\w*")
_BINDING = {
    "assignment": "left",
    "augmented_assignment": "left",
    "for_statement": "left",
    "named_expression": "name",
    "as_pattern": "alias",
}


@dataclass(frozen=True, eq=False)
class Function:
    """A function or a lambda.

    Attributes:
        node: its definition.
        names: the names of where it is defined, as they are when it is called.
    """

    node: Node
    names: dict[str, Any]

    @property
    def name(self) -> str:
        """What it is called, for a person."""
        return field(self.node, "name") or "lambda"

    @property
    def body(self) -> Node | None:
        """Its statements, or the expression of a lambda."""
        return self.node.child_by_field_name("body")

    @property
    def is_followed(self) -> bool:
        """Whether it is a plain function, that ends with a value and has names of its own."""
        is_plain = not any(child.type == "async" for child in self.node.children)
        return is_plain and not _NOT_FOLLOWED.search(self.node.text or b"")

    def parameters(self) -> Iterator[tuple[str, Node | None, str]]:
        """Yield its parameters: the name, the default value, and the stars before it."""
        found = self.node.child_by_field_name("parameters")
        for each in () if found is None else found.named_children:
            if each.type == "identifier":
                yield source_of(each), None, ""
            elif each.type in ("default_parameter", "typed_default_parameter"):
                yield field(each, "name"), each.child_by_field_name("value"), ""
            elif each.type in ("list_splat_pattern", "dictionary_splat_pattern"):
                yield source_of(each).lstrip("*"), None, "*"
            elif each.type == "typed_parameter" and each.named_children:
                inner = source_of(each.named_children[0])
                yield inner.lstrip("*"), None, "*" if inner.startswith("*") else ""

    def bound(self, positional: list[Any], named: Mapping[str, Any]) -> dict[str, Any] | None:
        """Return the values of its parameters, defaults as nodes, None where they do not fit."""
        found: dict[str, Any] = {}
        values = list(positional)
        others = dict(named)
        has_more = False
        for name, default, stars in self.parameters():
            if stars:
                found[name], has_more = Computed(name), True
            elif values and not has_more:
                found[name] = values.pop(0)
            elif name in others:
                found[name] = others.pop(name)
            elif default is not None:
                found[name] = default
            else:
                return None
        return None if (values or others) and not has_more else found

    def named(self) -> set[str]:
        """Return the names, and other words, that stand in it."""
        text = b"" if self.body is None else self.body.text or b""
        return {each.decode() for each in _WORD.findall(text)}

    def outer_names(self) -> set[str]:
        """Return the names around it that it may give values to."""
        found = _OUTER.findall(self.node.text or b"")
        return {each.decode() for names in found for each in _WORD.findall(names)}

    def locals(self) -> set[str]:
        """Return the names that are assigned to in it, and are no other function's."""
        found = {name for name, _, _ in self.parameters()}
        stack = [] if self.body is None else [self.body]
        while stack:
            each = stack.pop()
            if each.type in ("function_definition", "class_definition"):
                found.add(field(each, "name"))
                continue
            stack += each.named_children
            target = each.child_by_field_name(_BINDING.get(each.type, "")) if (
                each.type in _BINDING) else None  # fmt: skip
            parts = [] if target is None else [target]
            while parts:
                part = parts.pop()
                if part.type == "identifier":
                    found.add(source_of(part))
                elif part.type not in ("attribute", "subscript", "call"):
                    parts += part.named_children
        return found
