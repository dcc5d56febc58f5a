"""Calls and what they are given, whichever way C++ writes them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from tree_sitter import Node

if TYPE_CHECKING:
    from .scopes import Scope
    from .syntax import Syntax

_LISTS = ("argument_list", "initializer_list", "parameter_list")


@dataclass(slots=True, eq=False)
class Call:
    """A call, or what makes an object.

    Attributes:
        node: the call, the declaration or initializer of an object, or the `new`.
        name: the last name of what is called: `f` of `a->b::f<T>()`.
        qualifier: what stands before it with `::`, without template arguments.
        receiver: the object whose method it is, None for none.
        template: the template arguments, None for none.
        given: what it is given, None where `listed` says it.
        scope: the scope that it is in.
        name_node: the node of the name.
        types: the template arguments of a class that is made, as they are written.
        listed: the list of the arguments of a call.
    """

    node: Node
    name: str
    qualifier: str
    receiver: Node | None
    template: Node | None
    given: list[Node] | None
    scope: Scope
    name_node: Node | None
    types: tuple[str, ...] = ()
    listed: Node | None = None

    @property
    def arguments(self) -> list[Node]:
        """What it is given."""
        if self.given is None:
            self.given = arguments_of(self.listed)
        return self.given

    def argument(self, position: int) -> Node | None:
        """Return an argument, None where there is none."""
        return self.arguments[position] if 0 <= position < len(self.arguments) else None

    @property
    def type_nodes(self) -> list[Node]:
        """The template arguments, one by one."""
        return [] if self.template is None else self.template.named_children

    @property
    def qualified(self) -> str:
        """The name with what stands before it."""
        return f"{self.qualifier}::{self.name}" if self.qualifier else self.name


def arguments_of(listed: Node | None) -> list[Node]:
    """Return the arguments of a list of any sort.

    What is parsed as the declaration of a function, `T it(nh, name);`, has arguments that look
    like the types of parameters.
    """
    if listed is None or listed.type not in _LISTS:
        return []
    found = []
    for each in listed.named_children:
        if each.type == "parameter_declaration":
            inner = each.child_by_field_name("type")
            declarator = each.child_by_field_name("declarator")
            if declarator is not None and declarator.type == "abstract_function_declarator":
                # `T it(getHandle());`: a call.
                inner = None
            found.append(each if inner is None else inner)
        else:
            found.append(each)
    return found


def call_of(node: Node, scope: Scope, syntax: Syntax) -> Call | None:
    """Return what a call expression calls, None for what is no name."""
    callee = node.child_by_field_name("function")
    if callee is None:
        return None
    receiver: Node | None = None
    qualifier: list[str] = []
    template: Node | None = None
    for _ in range(16):
        kind = callee.type
        if kind in ("identifier", "field_identifier", "type_identifier"):
            return Call(
                node,
                syntax.word(callee),
                "::".join(qualifier),
                receiver,
                template,
                None,
                scope,
                callee,
                listed=node.child_by_field_name("arguments"),
            )
        inner: Node | None
        if kind == "field_expression":
            receiver = callee.child_by_field_name("argument")
            inner = callee.child_by_field_name("field")
        elif kind in ("template_function", "template_method", "template_type"):
            template = callee.child_by_field_name("arguments")
            inner = callee.child_by_field_name("name")
        elif kind == "qualified_identifier":
            outer = callee.child_by_field_name("scope")
            if outer is not None:
                qualifier.append(_plain(outer, syntax))
            inner = callee.child_by_field_name("name")
        elif kind in ("dependent_name", "parenthesized_expression"):
            inner = callee.named_children[0] if callee.named_child_count else None
        else:
            return None
        if inner is None:
            return None
        callee = inner
    return None


def _plain(node: Node, syntax: Syntax) -> str:
    """Return the name of a scope without template arguments."""
    return "".join(syntax.word(node).partition("<")[0].split())
