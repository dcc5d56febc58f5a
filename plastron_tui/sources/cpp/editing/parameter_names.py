"""The names of parameters that a function does not use, which compilers warn of."""

from __future__ import annotations

import re
from collections.abc import Iterator

from ..analysis import Analysis
from ..scopes import CppFile, Function, Variable
from .deletions import Deletions
from .plans import Plan
from .uses import hidden_uses, uses_of

_COMMENTED = re.compile(rb"/\*[ \t]*(\w+)[ \t]*\*/")
_IN_COMMENT = re.compile(rb"/\*([ \t]*)\w+[ \t]*\*/[ \t\r\n]*[,)=]")


def unname_unused(analysis: Analysis, gone: Deletions, plan: Plan) -> None:
    """Take the names of the parameters out that only code which goes has used.

    The name becomes a comment, as in `const String & /*msg*/`, unless the files have parameters
    without any.
    """
    for file in list(gone.files):
        if file.is_beside:
            continue
        for parameter in _unused(analysis, file, gone):
            node = parameter.declarator
            if node is None:
                continue
            start, end = node.start_byte, node.end_byte
            style = _IN_COMMENT.search(file.syntax.text)
            if style is None and _has_unnamed(analysis):
                while file.syntax.text[start - 1 : start] == b" ":
                    start -= 1
                plan.replace(file, start, end)
            else:
                blank = "" if style is None else style[1].decode()
                plan.replace(file, start, end, f"/*{blank}{parameter.name}{blank}*/")


def _unused(analysis: Analysis, file: CppFile, gone: Deletions) -> Iterator[Variable]:
    for scope in file.scopes:
        function = scope.function
        if function is None or scope.kind not in ("function", "lambda"):
            continue
        if gone.covers(file, function.node.start_byte):
            continue
        for parameter in function.parameters:
            if not parameter.name or parameter.node.type.startswith("variadic"):
                continue
            uses = [
                gone.covers(each, at.start_byte) for each, at, _ in uses_of(analysis, parameter)
            ]
            if uses and all(uses) and not any(hidden_uses(analysis, parameter.name, gone)):
                yield parameter


def _has_unnamed(analysis: Analysis) -> bool:
    """Tell whether a function of the files is defined with a parameter that has no name."""
    return any(
        not parameter.name and parameter.type not in ("", "void")
        for file in analysis.unit.files
        for scope in file.scopes
        if scope.function is not None and scope.kind in ("function", "lambda")
        for parameter in scope.function.parameters
    )


def commented_name(function: Function, parameter: Variable) -> tuple[str, int, int] | None:
    """Return the name that a comment has in place of a parameter's, and where that comment is."""
    text = function.file.syntax.text
    start = parameter.node.start_byte
    listed = function.declarator.child_by_field_name("parameters")
    end = start if listed is None else listed.end_byte
    found = _COMMENTED.search(text, start, end)
    return None if found is None else (found[1].decode(), *found.span())


def give_name(plan: Plan, function: Function, parameter: Variable, name: str) -> None:
    """Give a name to a parameter that has none, that of a comment in place of the comment."""
    commented = commented_name(function, parameter)
    if commented is not None:
        plan.replace(function.file, commented[1], commented[2], name)
        return
    end = parameter.node.end_byte
    plan.replace(function.file, end, end, f" {name}")
