"""Functions that an edit leaves with nobody to call them."""

from __future__ import annotations

import re
from collections.abc import Sequence

from tree_sitter import Node

from plastron_tui.diagnostics import Diagnostic, Span, codes, listed
from plastron_tui.model.source import Change, Remove, Update

from .analysis import Analysis
from .callers import count_words
from .creation import line_of
from .functions import definition, function_uses
from .generated import is_own_helper
from .nodes import part_of
from .removal import find_sites
from .scopes import Scope


def uncalled_functions(before: Analysis, after: Analysis) -> list[Scope]:
    """Return the functions of a file as it is which nothing in it refers to any more.

    Args:
        before: the file as it was.
        after: the file as it is.
    """
    # Few names are fewer than before; only for these is it asked where they are used.
    rarer = count_words(before.syntax.text) - count_words(after.syntax.text)
    words = {word.decode(before.syntax.encoding, "replace") for word in rarer}
    called = {path_of(each) for each in _functions(before, words) if _has_uses(before, each)}
    return [
        each
        for each in _functions(after, words)
        if path_of(each) in called and not _has_uses(after, each) and not is_own_helper(each)
    ]


def tell_uncalled(
    before: Analysis, changes: Sequence[Change], found: Sequence[Scope]
) -> Diagnostic | None:
    """Return a warning that names the functions which nothing in a file refers to any more.

    Args:
        before: the file as it was.
        changes: what was asked for.
        found: the functions.
    """
    if not found:
        return None
    names = listed(f"`{each.name}` (line {line_of(each.node)})" for each in found)
    message = f"nothing in the file calls {names} any more"
    it = "it if it is" if len(found) == 1 else "them if they are"
    span = span_of(before, changes, {each.name for each in found})
    return Diagnostic(codes.UNCALLED_FUNCTION, message, span, help=f"remove {it} of no other use")


def _functions(analysis: Analysis, names: set[str]) -> list[Scope]:
    """Return the functions of some names, without those that a decorator may give to others."""
    return [
        scope
        for scope in analysis.scopes.all
        if scope.name in names and definition(scope).type == "function_definition"
    ]


def path_of(function: Scope) -> tuple[str, ...]:
    """Return the names of a function and of what it is in, from the inside."""
    path: list[str] = []
    scope: Scope | None = function
    while scope is not None:
        path.append(scope.name)
        scope = scope.parent
    return tuple(path)


def _has_uses(analysis: Analysis, function: Scope) -> bool:
    """Whether a file mentions a function, as a name or as a text, but for within itself."""
    text = re.escape(analysis.syntax.encode(function.name))
    names = [node.call for node in analysis.nodes] + [site.call for site in analysis.sites]
    if any(
        not any(_is_argument(call, found.start()) for call in names)
        for found in re.finditer(rb"""(["'])%b\1""" % text, analysis.syntax.text)
    ):
        return True
    whole = function.node
    return any(
        not whole.start_byte <= node.start_byte < whole.end_byte
        for node in function_uses(analysis, function)
    )


def _is_argument(call: Node | None, offset: int) -> bool:
    """Whether a text is given to what creates a node or an endpoint: it names that."""
    return call is not None and call.start_byte <= offset < call.end_byte


def span_of(before: Analysis, changes: Sequence[Change], names: set[str]) -> Span | None:
    """Return the statement that took the call of one of some functions away."""
    taking = [change for change in changes if isinstance(change, Remove | Update)]
    for change in taking:
        sites = find_sites(part_of(before, change.node), change)
        if len(taking) == 1 or any(site.endpoint.callback in names for site in sites):
            return change.span
    return None
