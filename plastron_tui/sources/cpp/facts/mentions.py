"""Where the code of a unit names a variable, whatever it does with it."""

from __future__ import annotations

import re
from collections.abc import Iterator

from tree_sitter import Node

from plastron_tui.sources.cpp.scopes import CppFile, Variable
from plastron_tui.sources.cpp.unit import Unit

_MOST = 400
_OF_OTHERS = re.compile(rb"(?:\.|->|::)\s*\Z")
_OWN = re.compile(rb"\bthis\s*->\s*\Z")


def mentions(unit: Unit, variable: Variable) -> list[tuple[CppFile, Node]] | None:
    """Return where a variable is named, its declaration left out; None where that is not sure.

    Other variables of the name count too: of one that may be meant it is not known what it is.
    """
    found: list[tuple[CppFile, Node]] = []
    around = variable.scope.enclosing("function", "lambda")
    is_local = variable.kind in ("local", "parameter", "loop") and around is not None
    files = [variable.file] if is_local else unit.all_files
    for file in files:
        start, end = 0, len(file.syntax.code)
        if is_local and around is not None:
            start, end = around.start, around.end
        for node in _named(file, variable.name, start, end):
            if variable.declarator is not None and node.id == variable.declarator.id:
                continue
            found.append((file, node))
            if len(found) > _MOST:
                return None
    return found


def _named(file: CppFile, name: str, start: int, end: int) -> Iterator[Node]:
    code = file.syntax.code
    for each in re.compile(rb"\b" + re.escape(name.encode()) + rb"\b").finditer(code, start, end):
        before = code[max(0, each.start() - 24) : each.start()]
        if _OF_OTHERS.search(before) is not None and _OWN.search(before) is None:
            continue
        node = file.syntax.root.descendant_for_byte_range(each.start(), each.end())
        if node is not None and node.type in ("string_content", "string_literal", "char_literal"):
            continue
        if node is not None:
            yield node
