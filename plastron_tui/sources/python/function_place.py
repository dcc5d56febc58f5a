"""Where in a file a new function goes: behind its like, or before what uses it."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from itertools import pairwise

from tree_sitter import Node

from .analysis import Analysis
from .conventions import leading_space
from .functions import definition
from .place import Place
from .scopes import Scope
from .splices import before_comments, line_end, line_start
from .syntax import parts_of

_RULER = re.compile(r"#+ ?([-=*~_#+])\1{7,}#?")
_WITH_BLOCK = ("block", "_clause")
_TELLS_END = re.compile(rb"#+ *end\b", re.I)


@dataclass(frozen=True, slots=True)
class FunctionPlace:
    """Where a new function goes: its offset, its indent, and the blank lines around it.

    Attributes:
        ruler: the line that the file has above its methods, "" for none.
    """

    offset: int
    indent: str
    before: int
    after: int
    ruler: str = ""


def method_place(analysis: Analysis, place: Place, near: Iterable[Scope]) -> FunctionPlace:
    """Return where a method goes: behind one of its like, or behind the one that uses it."""
    owner = place.owner
    assert owner is not None
    alike = [scope for scope in near if scope.parent is owner and scope.node.type != "lambda"]
    behind = alike[-1] if alike else place.scope
    text = analysis.syntax.text
    node = definition(behind)
    indent = leading_space(analysis, node)
    offset = _end_with_comments(text, line_end(text, _end_of_code(node)), indent)
    gap = _method_gap(node)
    after = _missing_after(text, offset, min(gap, 1))
    return FunctionPlace(offset, indent, gap, after, _ruler(analysis, node))


def _ruler(analysis: Analysis, node: Node) -> str:
    """Return the line of dashes or the like that stands above most methods of a class."""
    methods = [each for each in parts_of(node.parent) if each.type.endswith("_definition")]
    above = (each.prev_named_sibling for each in methods)
    lines = Counter(
        analysis.syntax.slice(each) if each is not None and each.type == "comment" else ""
        for each in above
    )
    line, count = lines.most_common(1)[0]
    is_usual = count > 1 and count * 2 > len(methods)
    return line if is_usual and _RULER.fullmatch(line) else ""


def rulers_above(analysis: Analysis, functions: Iterable[Node]) -> list[Node]:
    """Return the lines of dashes or the like above functions, in classes that have such."""
    found = []
    for each in functions:
        above = each.prev_named_sibling if each.type.endswith("_definition") else None
        if above is not None and above.type == "comment":
            ruler = _ruler(analysis, each)
            if ruler and analysis.syntax.slice(above) == ruler:
                found.append(above)
    return found


def _method_gap(node: Node) -> int:
    """Return how many blank lines stand between the methods of a class, most often."""
    methods = [each for each in parts_of(node.parent) if each.type.endswith("_definition")]
    gaps = Counter(
        min(int(below.start_point.row) - int(above.end_point.row) - 1, 2)
        for above, below in pairwise(methods)
        if above.next_named_sibling is not None and above.next_named_sibling.id == below.id
    )
    return max(max(gaps, key=lambda gap: (gaps[gap], gap)), 0) if gaps else 1


def _end_of_code(node: Node) -> int:
    """Return where the last statement of a definition ends, comments below it left out."""
    inner = parts_of(node)
    while node.type in ("block", "decorated_definition") or inner[-1].type.endswith(_WITH_BLOCK):
        node, inner = inner[-1], parts_of(inner[-1])
        if not inner:
            break
    return node.end_byte


def _end_with_comments(text: bytes, offset: int, indent: str) -> int:
    """Step over comments that are of a definition: they stand deeper, or tell its end."""
    at = found = offset
    while at < len(text):
        end = line_end(text, at)
        line = text[at:end].rstrip()
        stripped = line.lstrip()
        if at == offset and _TELLS_END.match(stripped):
            at = found = end
            continue
        if stripped and not (stripped.startswith(b"#") and len(line) - len(stripped) > len(indent)):
            break
        at = end
        # A comment right above the next definition is of this one.
        is_of_next = text[found:at].startswith((b"\n", b"\r")) and text[at : at + 1] not in b"\r\n"
        if stripped and not is_of_next:
            found = end
    return found


def function_place(
    analysis: Analysis, place: Place, near: Iterable[Scope], gap: int
) -> FunctionPlace:
    """Return where a function goes: at the top of the file, before what uses it."""
    text = analysis.syntax.text
    top = place.statement
    module = analysis.scopes.module
    top = _top_level(top)
    alike = [
        definition(scope)
        for scope in near
        if scope.parent is module and scope.node.type == "function_definition"
    ]
    alike = [node for node in alike if node.end_byte <= top.start_byte]
    if not alike and place.scope is module and top.type != "if_statement":
        # A script may have its functions among what runs.
        alike = [each for each in _definitions(top) if each.type != "class_definition"][:1]
    if not alike and place.scope is module:
        # In a script, functions stand before everything that runs.
        running = [site.call for site in analysis.sites if site.scope is module]
        running += [node.call for node in analysis.nodes if node.scope is module and node.call]
        running += _running(analysis.syntax.root)
        top = min([top, *map(_top_level, running)], key=lambda node: node.start_byte)
    behind = alike[-1] if alike else next(_definitions(top), None)
    if behind is None:
        at = before_comments(text, line_start(text, top.start_byte))
        is_first = not text[:at].strip()
        return FunctionPlace(at, "", 0 if is_first else _missing_before(text, at, gap), gap)
    at = _end_with_comments(text, line_end(text, _end_of_code(behind)), "")
    return FunctionPlace(at, "", gap, _missing_after(text, at, gap))


def _running(module: Node) -> list[Node]:
    """Return the calls of a script, those among its imports left out."""
    found: list[Node] = []
    for each in module.named_children:
        if each.type in ("import_statement", "import_from_statement"):
            found.clear()
        elif _calls(each):
            found.append(each)
    return found


def _calls(statement: Node) -> bool:
    """Whether a statement is a call and no more, as that of what starts ROS."""
    inner = statement.named_children[0] if statement.named_child_count else None
    return statement.type == "expression_statement" and inner is not None and inner.type == "call"


def _top_level(node: Node) -> Node:
    while node.parent is not None and node.parent.type != "module":
        node = node.parent
    return node


def _definitions(top: Node) -> Iterator[Node]:
    """Yield the definitions at the top of the file before a statement, the last one first."""
    node = top.prev_named_sibling
    while node is not None:
        if node.type.endswith("_definition"):
            yield node
        node = node.prev_named_sibling


def _missing_before(text: bytes, at: int, gap: int) -> int:
    """Return how many blank lines a definition still needs before it."""
    before = text[:at].replace(b"\r", b"")
    blank = len(before) - len(before.rstrip(b"\n")) - 1
    return max(gap - max(blank, 0), 0)


def _missing_after(text: bytes, at: int, gap: int) -> int:
    """Return how many blank lines a definition still needs after it."""
    following = text[at:].lstrip(b" \t\r\n")
    blank = text[at : len(text) - len(following)].count(b"\n")
    return max(gap - blank, 0) if following else 0
