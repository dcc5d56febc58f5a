"""Where the names of variables are used."""

from __future__ import annotations

import re
from collections.abc import Iterator

from tree_sitter import Node

from ..analysis import Analysis
from ..scopes import CppFile, Function, Scope, Variable, scope_at
from .deletions import Deletions

_NAMES = frozenset({"identifier", "field_identifier"})


def uses_of(analysis: Analysis, variable: Variable) -> Iterator[tuple[CppFile, Node, Scope]]:
    """Yield the places that name a variable, but for its declaration.

    So does what may name it: a member of that name of an object whose type is not known.
    """
    own = variable.declarator.start_byte if variable.declarator is not None else -1
    for file in analysis.unit.all_files:
        for found in word(variable.name).finditer(file.syntax.code):
            if file is variable.file and found.start() == own:
                continue
            node = file.syntax.root.named_descendant_for_byte_range(found.start(), found.end())
            if node is None or not _is_name(node):
                continue
            scope = scope_at(file, found.start())
            if _may_be(analysis, variable, node, scope):
                yield file, node, scope


def _is_name(node: Node) -> bool:
    """Whether a node may name a variable; `T it(name);` is parsed as one with a type in it."""
    outer = node.parent
    is_argument = outer is not None and outer.type == "parameter_declaration"
    return node.type in _NAMES or (node.type == "type_identifier" and is_argument)


def _may_be(analysis: Analysis, variable: Variable, node: Node, scope: Scope) -> bool:
    outer = node.parent
    if node.type == "field_identifier" and outer is not None and outer.type == "field_expression":
        if variable.kind != "member":
            return False
        holder = outer.child_by_field_name("argument")
        found = analysis.receivers.member(outer, scope)
        if found is not None or holder is None or holder.type == "this":
            return found is variable
        return analysis.receivers.type_of(holder, scope) == ""
    if outer is not None and outer.type == "qualified_identifier":
        while outer.parent is not None and outer.parent.type == "qualified_identifier":
            outer = outer.parent
        text = "".join(scope.file.syntax.word(outer).split())
        return variable in analysis.unit.qualified(text, scope)
    return analysis.unit.lookup(variable.name, scope, node.start_byte) is variable


def hidden_uses(analysis: Analysis, name: str, gone: Deletions) -> Iterator[tuple[CppFile, int]]:
    """Yield where a name stands in what was not parsed, each with its file and offset.

    That are macros, and branches of the preprocessor that stand for another one.
    """
    for file in analysis.unit.all_files:
        for found in word(name).finditer(gone.written(file)):
            start, end = found.span()
            if not file.syntax.code[start:end].strip() and not gone.covers(file, start):
                yield file, start


def word(name: str) -> re.Pattern[bytes]:
    """Return what matches a name as a word of its own."""
    return re.compile(rb"(?<![A-Za-z0-9_])" + re.escape(name.encode()) + rb"(?!\w)")


def is_static(analysis: Analysis, function: Function) -> bool:
    """Tell whether a function is a method without an object, which its declaration may say."""
    owner = analysis.unit.class_of_function(function)
    if owner is None:
        return False
    return any(
        part.type == "storage_class_specifier" and each.file.syntax.word(part) == "static"
        for each in analysis.unit.functions.get(function.name, ())
        if analysis.unit.class_of_function(each) is owner
        and len(each.parameters) == len(function.parameters)
        for part in each.node.children
    )
