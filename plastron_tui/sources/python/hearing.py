"""The function of a file that gets each message of a topic, and where it can send something."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import NamedTuple

from tree_sitter import Node

from .analysis import Analysis, Site
from .conventions import leading_space
from .functions import callback_scope, definition, function_uses
from .generated import is_docstring
from .handed_on import handed_by_call
from .references import function_of, is_member
from .scopes import BindingKind, Scope
from .splices import before_comments, line_end, line_start
from .syntax import parts_of

# What may leave a function before its end, or not come to it.
_LEAVING = frozenset({"return_statement", "raise_statement", "while_statement"})
_ASSIGNING = frozenset({"assignment", "augmented_assignment", "delete_statement"})
_INNER = frozenset({"function_definition", "class_definition", "lambda"})
_CALLBACKS = ("identifier", "attribute")


class NotHeardError(Exception):
    """Why nothing is sent from the function that hears a topic."""


class Heard(NamedTuple):
    """Where a function can send something for each message that it gets.

    Attributes:
        function: the function.
        message: what it calls the message.
        statement: the statement that the new ones follow, or come before.
        offset: the start of a line.
        indent: the white space before the statements there.
        is_empty: whether the line above is a `pass`, which is all that the function does.
    """

    function: Scope
    message: str
    statement: Node
    offset: int
    indent: str
    is_empty: bool = False


def find_heard(analysis: Analysis, sites: list[Site]) -> Heard:
    """Return where the function that gets each message of some subscriptions can send.

    That is at its end; at its start where it may not come to its end, or changes the message.

    Raises:
        NotHeardError: there is no such function, or it is called for something else too.
    """
    if not sites:
        raise NotHeardError("nothing in the file subscribes to it")
    functions = {id(each): each for each in (_function(analysis, site) for site in sites)}
    if len(functions) != 1:
        raise NotHeardError("several functions hear it")
    (function,) = functions.values()
    message = _message(analysis, function)
    _check_uses(analysis, function, sites)
    body = function.node.child_by_field_name("body")
    statements = parts_of(body)
    if body is None or body.start_point.row == function.node.start_point.row or body.has_error:
        raise NotHeardError(f"the body of `{function.name}` is not one of lines")
    text, last = analysis.syntax.text, statements[-1]
    indent = leading_space(analysis, statements[0])
    if _comes_to_end(body, last) and not _is_changed(analysis, function, body, message):
        returns = last.type == "return_statement"
        offset = line_start(text, last.start_byte) if returns else line_end(text, last.end_byte)
        line = text[line_start(text, last.start_byte) : offset].strip()
        is_empty = len(statements) == 1 and line == b"pass"
        return Heard(function, message, last, offset, indent, is_empty)
    first = next((each for each in statements if not is_docstring(each)), last)
    offset = before_comments(text, line_start(text, first.start_byte))
    return Heard(function, message, first, offset, indent)


def _function(analysis: Analysis, site: Site) -> Scope:
    """Return the function that a subscription calls with the message and nothing else."""
    given = site.arguments.get(site.shape.callback) if site.shape.callback else None
    if given is None:
        raise NotHeardError(f"line {site.endpoint.line} names no function for it")
    if given.type == "lambda":
        raise NotHeardError(f"a lambda hears it in line {given.start_point.row + 1}")
    function = callback_scope(analysis, site)
    name = analysis.syntax.slice(given)
    if function is None or given.type not in _CALLBACKS:
        raise NotHeardError(f"`{' '.join(name.split())}` is no function of this file")
    if function_of(given, analysis) is not function or len(handed_by_call(analysis, site)):
        raise NotHeardError(f"`{function.name}` gets more than the message")
    return function


def _message(analysis: Analysis, function: Scope) -> str:
    """Return what a function calls the one argument that it takes."""
    if definition(function) is not function.node:
        raise NotHeardError(f"`{function.name}` is decorated")
    parameters = parts_of(function.node.child_by_field_name("parameters"))
    taken = parameters[1:] if function.self_name else parameters
    inner = [each.named_children[0] if each.type == "typed_parameter" else each for each in taken]
    if len(inner) != 1 or inner[0].type != "identifier":
        raise NotHeardError(f"`{function.name}` takes other arguments than the message")
    return analysis.syntax.slice(inner[0])


def _check_uses(analysis: Analysis, function: Scope, sites: list[Site]) -> None:
    """Refuse a function that something else calls too, or hands on."""
    own = [site.arguments.get(site.shape.callback) for site in sites if site.shape.callback]
    for node in function_uses(analysis, function):
        whole = node.parent if is_member(node) and node.parent is not None else node
        if any(each is not None and each.id == whole.id for each in own):
            continue
        defined = node.parent is not None and node.parent.type in _INNER
        named = function_of(whole, analysis)
        if not defined and (named is None or named is function):
            line = node.start_point.row + 1
            raise NotHeardError(f"`{function.name}` is used in line {line} as well")


def _comes_to_end(body: Node, last: Node) -> bool:
    """Whether a function surely comes to its last statement, or raises what somebody else does."""
    return all(each.id == last.id for each in _inside(body) if each.type in _LEAVING) and (
        last.type not in ("raise_statement", "while_statement")
    )


def _is_changed(analysis: Analysis, function: Scope, body: Node, message: str) -> bool:
    """Whether a function changes the message that it gets, or what it calls so."""
    bindings = function.bindings.get(message, [])
    if any(each.kind is not BindingKind.PARAMETER for each in bindings):
        return True
    target = re.compile(rb"(del\s+)?" + re.escape(analysis.syntax.encode(message)) + rb"\b")
    assigned = (each.child_by_field_name("left") or each for each in _inside(body, _ASSIGNING))
    return any(target.match(each.text or b"") for each in assigned)


def _inside(body: Node, types: frozenset[str] = _LEAVING) -> Iterator[Node]:
    """Yield the statements of some types in a function, those of functions in it left out."""
    pending = [body]
    while pending:
        node = pending.pop()
        if node.type in types:
            yield node
        if node.type not in _INNER:
            pending += node.named_children
