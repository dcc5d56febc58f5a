"""What `argparse` and `optparse` give for an option that the command line leaves out."""

from __future__ import annotations

from typing import Protocol

from tree_sitter import Node

from .arguments import Arguments
from .calls import Argument
from .containers import Containers, Given
from .scopes import Scope, ScopeTree
from .syntax import Syntax

_PARSERS = frozenset({"parse_args", "parse_known_args", "parse_intermixed_args"})
_ADDERS = ("add_argument", "add_option")


Defaults = dict[str, list[Given]]


class Options(Protocol):
    """What the options ask of names."""

    def calls_of(self, name: str) -> list[Node]:
        """Return the calls of a function or method of a name."""

    def result(self, call: Node, scope: Scope) -> Given | None:
        """Return the expression that a call of a function of the file gives."""

    @property
    def containers(self) -> Containers:
        """The containers of the file."""


def option_defaults(names: Options, scopes: ScopeTree, syntax: Syntax) -> Defaults:
    """Return the defaults that options are given, by the attributes that the options become."""
    found: Defaults = {}
    for call in (call for adder in _ADDERS for call in names.calls_of(adder)):
        arguments = Arguments.of(call, syntax)
        scope = scopes.at(call.start_byte)
        default = arguments.get(Argument(-1, "default"))
        name = _destination(arguments, syntax)
        if name is not None and default is not None:
            found.setdefault(name, []).append(Given(default, scope))
    return found


def is_parsed(node: Node, scope: Scope, names: Options, syntax: Syntax, depth: int) -> bool:
    """Whether an attribute is one of what a parser gives, or of the first of it."""
    holder = node.child_by_field_name("object")
    held = names.containers.literal(holder, scope, depth)
    if held is not None and held.node.type == "call":
        held = names.result(held.node, held.scope) or held
        held = names.containers.literal(held.node, held.scope, depth)
    value = held.node if held is not None else None
    if value is not None and value.type == "subscript":
        value = value.child_by_field_name("value")
    callee = value.child_by_field_name("function") if value and value.type == "call" else None
    method = callee.child_by_field_name("attribute") if callee is not None else None
    return method is not None and syntax.slice(method) in _PARSERS


def _destination(arguments: Arguments, syntax: Syntax) -> str | None:
    """Return the attribute that an option becomes."""
    given = arguments.get(Argument(-1, "dest"))
    flags = [given] if given is not None else list(arguments.positional)
    known = [syntax.slice(flag).strip("\"'") for flag in flags if flag.type == "string"]
    long = [text for text in known if text.startswith("--")] or known
    return long[0].lstrip("-").replace("-", "_") if long else None
