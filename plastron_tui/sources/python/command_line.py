"""What `argparse` and `optparse` give for an option that the command line leaves out."""

from __future__ import annotations

from typing import Protocol

from tree_sitter import Node

from .arguments import Arguments
from .calls import Argument
from .constants import Folded, Known, as_default
from .containers import Containers, Given
from .scopes import Scope, ScopeTree
from .syntax import Syntax

_PARSERS = frozenset({"parse_args", "parse_known_args", "parse_intermixed_args"})
_ADDERS = ("add_argument", "add_option")


class Options(Protocol):
    """What the options ask of names."""

    def fold(self, node: Node | None, scope: Scope, depth: int = 0) -> Folded:
        """Return the constant that an expression is."""

    def calls_of(self, name: str) -> list[Node]:
        """Return the calls of a function or method of a name."""

    def result(self, call: Node, scope: Scope) -> Given | None:
        """Return the expression that a call of a function of the file gives."""

    @property
    def containers(self) -> Containers:
        """The containers of the file."""


def option_default(
    node: Node, scope: Scope, names: Options, scopes: ScopeTree, syntax: Syntax, depth: int
) -> Folded:
    """Return the default of `args.topic`, where `args` is what a parser of the file gives."""
    holder, name = node.child_by_field_name("object"), node.child_by_field_name("attribute")
    adders = [call for adder in _ADDERS for call in names.calls_of(adder)]
    if holder is None or name is None or not adders:
        return None
    if not _is_parsed(holder, scope, names, syntax, depth):
        return None
    wanted = syntax.slice(name)
    found: set[Folded] = set()
    for call in adders:
        arguments = Arguments.of(call, syntax)
        within = scopes.at(call.start_byte)
        if _destination(arguments, within, names, depth) == wanted:
            found.add(names.fold(arguments.get(Argument(-1, "default")), within, depth))
    return as_default(found.pop()) if len(found) == 1 else None


def _is_parsed(holder: Node, scope: Scope, names: Options, syntax: Syntax, depth: int) -> bool:
    """Whether an expression is what a parser gives, or the first of it."""
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


def _destination(arguments: Arguments, scope: Scope, names: Options, depth: int) -> str | None:
    """Return the attribute that an option becomes."""
    given = arguments.get(Argument(-1, "dest"))
    flags = [given] if given is not None else list(arguments.positional)
    texts = [names.fold(flag, scope, depth) for flag in flags]
    known = [str(text.value) for text in texts if isinstance(text, Known)]
    long = [text for text in known if text.startswith("--")] or known
    return long[0].lstrip("-").replace("-", "_") if long else None
