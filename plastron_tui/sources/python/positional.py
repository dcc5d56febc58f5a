"""What a function of a file can be called with, as `inspect.signature` says it of a function."""

from __future__ import annotations

import math
from inspect import Parameter, Signature

from tree_sitter import Node

from .functions import definition
from .scopes import Scope
from .syntax import Syntax, parts_of

_PLAIN_DECORATORS = frozenset({"@staticmethod", "@classmethod"})
_SPLATS = {
    "list_splat_pattern": Parameter.VAR_POSITIONAL,
    "dictionary_splat_pattern": Parameter.VAR_KEYWORD,
}
_NEVER = Signature([Parameter("self", Parameter.KEYWORD_ONLY)])
"""The signature of a method that has no parameter for the object it is called on."""


def signature_of(function: Scope, syntax: Syntax, *, is_written: bool = False) -> Signature | None:
    """Return the signature of a function or a lambda, what it gets as a method left out.

    None where a decorator makes something of it that nobody knows.

    Args:
        function: the function.
        syntax: its file.
        is_written: whether to leave nothing out.
    """
    decorators = {
        syntax.slice(each) for each in definition(function).children if each.type == "decorator"
    }
    if decorators - _PLAIN_DECORATORS:
        return None
    found = _parameters(function.node.child_by_field_name("parameters"), syntax)
    is_method = function.kind == "function" and function.parent is not None
    is_bound = is_method and function.parent is not None and function.parent.kind == "class"
    if is_bound and not is_written and "@staticmethod" not in decorators:
        if not found:
            return _NEVER
        if found[0].kind not in _SPLATS.values():
            del found[0]
    try:
        return Signature(found)
    except ValueError:
        return None


def _parameters(listed: Node | None, syntax: Syntax) -> list[Parameter]:
    found: list[Parameter] = []
    is_keyword_only = False
    for each in parts_of(listed):
        if each.type == "keyword_separator":
            is_keyword_only = True
            continue
        if each.type == "positional_separator":
            found = [known.replace(kind=Parameter.POSITIONAL_ONLY) for known in found]
            continue
        inner = each.named_children[0] if each.type == "typed_parameter" else each
        name = inner.child_by_field_name("name")
        if inner.type in _SPLATS:
            name = next(iter(parts_of(inner)), None)
        elif inner.type == "identifier":
            name = inner
        text = f"p{len(found)}" if name is None else syntax.slice(name)
        kind = Parameter.KEYWORD_ONLY if is_keyword_only else Parameter.POSITIONAL_OR_KEYWORD
        has_default = each.child_by_field_name("value") is not None
        found.append(
            Parameter(
                text if text.isidentifier() else f"p{len(found)}",
                _SPLATS.get(inner.type, kind),
                default=None if has_default else Parameter.empty,
            )
        )
        is_keyword_only = is_keyword_only or inner.type == "list_splat_pattern"
    return found


def takes(signature: Signature, count: int, keywords: frozenset[str] = frozenset()) -> bool:
    """Tell whether what has a signature can be called with so many arguments, and keywords."""
    try:
        signature.bind(*(None,) * count, **dict.fromkeys(keywords))
    except TypeError:
        return False
    return True


def bounds(signature: Signature) -> tuple[int, float]:
    """Return how few and how many arguments can be given by position."""
    listed = signature.parameters.values()
    by_position = [
        each
        for each in listed
        if each.kind in (Parameter.POSITIONAL_ONLY, Parameter.POSITIONAL_OR_KEYWORD)
    ]
    least = sum(each.default is Parameter.empty for each in by_position)
    is_open = any(each.kind is Parameter.VAR_POSITIONAL for each in listed)
    return least, math.inf if is_open else len(by_position)
