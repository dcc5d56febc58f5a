"""The arguments of a call, by position and by keyword."""

from __future__ import annotations

from dataclasses import dataclass

from tree_sitter import Node

from .calls import Argument
from .syntax import Syntax, parts_of


@dataclass(frozen=True, slots=True)
class Arguments:
    """The arguments of a call; `is_open` when a splat, the first one kept, may hide more."""

    positional: tuple[Node, ...]
    keywords: dict[str, Node]
    is_open: bool
    splat: Node | None = None

    @classmethod
    def of(cls, call: Node, syntax: Syntax) -> Arguments:
        """Collect the arguments of a call."""
        positional: list[Node] = []
        keywords: dict[str, Node] = {}
        is_open = False
        splat: Node | None = None
        listed = call.child_by_field_name("arguments")
        children = parts_of(listed)
        if listed is not None and listed.type != "argument_list":
            children = []
            is_open = True
        for child in children:
            if child.type == "keyword_argument":
                name = child.child_by_field_name("name")
                value = child.child_by_field_name("value")
                if name is not None and value is not None:
                    keywords[syntax.slice(name)] = value
            elif child.type in ("list_splat", "dictionary_splat"):
                is_open = True
                splat = splat or child
                if child.type == "list_splat":
                    # What follows a splat has no position that could be known.
                    break
            elif child.type != "ERROR":
                positional.append(child)
        return cls(tuple(positional), keywords, is_open, splat)

    def get(self, argument: Argument) -> Node | None:
        """Return an argument, None where the call does not give it."""
        if argument.keyword in self.keywords:
            return self.keywords[argument.keyword]
        if 0 <= argument.position < len(self.positional):
            return self.positional[argument.position]
        return None
