"""A call that creates an endpoint, with the shape that it matches."""

from __future__ import annotations

from typing import NamedTuple

from tree_sitter import Node

from .arguments import Call
from .scopes import Scope
from .shapes import Shape


class Found(NamedTuple):
    """A call with the shape that it matches.

    Attributes:
        call: the call.
        shape: the shape.
        arguments: the arguments without the node.
        handle: the node, handle or transport that it is made on, None for the object itself.
        scope: the scope that the handle stands in.
        owner: the class of the files that the node is of.
        template: what says the type instead of the call itself.
        type: the type of what it is called on.
    """

    call: Call
    shape: Shape
    arguments: list[Node]
    handle: Node | None
    scope: Scope
    owner: Scope | None
    template: str = ""
    options: Call | None = None


def template_of(type_: str) -> str:
    """Return the template arguments of a type."""
    return type_.partition("<")[2].rpartition(">")[0]
