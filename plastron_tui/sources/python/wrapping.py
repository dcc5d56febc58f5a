"""Breaking the lines that an edit made too long, as the file breaks its others."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from dataclasses import replace
from difflib import SequenceMatcher

from tree_sitter import Node

from .conventions import block_indent
from .layout import Brackets, fit
from .line_limit import LineLimit
from .references import statement_of
from .splices import Splice, apply, line_start
from .syntax import Syntax, parts_of

Broken = dict[str, list[Node]]

# Statements with a body below them.
_HEADS = frozenset(
    {"function_definition", "if_statement", "for_statement", "while_statement", "with_statement"}
)

# So many broken calls tell how a file breaks them.
_MOST_CALLS = 200
_MOST_LINES = 200
_MOST_LETTERS = 200
_ALIKE = 0.8


def wrap_new_lines(before: bytes, syntax: Syntax, limit: LineLimit) -> bytes:
    """Break the lines of a text that are too long, and were not before an edit.

    Args:
        before: the text before it was edited.
        syntax: the text now.
        limit: how long a line may be.
    """
    known, after = Counter(line.rstrip() for line in before.splitlines()), syntax.text
    splices: list[Splice] = []
    gone: list[str] | None = None
    broken: Broken | None = None
    at = 0
    for line in after.splitlines(keepends=True):
        start, at = at, at + len(line)
        written = line.rstrip()
        text = syntax.between(start, start + len(written))
        if len(text) <= limit.length or written in known or limit.allows(text):
            continue
        if gone is None:
            gone = _long_lines(known - Counter(map(bytes.rstrip, after.splitlines())), limit)
        if not any(limit.allows_instead(text, each) and _is_like(text, each) for each in gone):
            broken = broken or _broken(syntax)
            splices += _wrap(syntax, start, start + len(written), broken, limit.length)
    return apply(after, splices) if splices else after


def _long_lines(lines: Iterable[bytes], limit: LineLimit) -> list[str]:
    decoded = (line.decode("utf-8", "replace") for line in lines)
    return [line for line in decoded if len(line) > limit.length - limit.slack][:_MOST_LINES]


def _is_like(line: str, other: str) -> bool:
    """Whether two lines are the same but for a word or two."""
    match = SequenceMatcher(None, line[:_MOST_LETTERS], other[:_MOST_LETTERS], autojunk=False)
    return match.quick_ratio() > _ALIKE and match.ratio() > _ALIKE


def _wrap(syntax: Syntax, start: int, end: int, broken: Broken, limit: int) -> list[Splice]:
    text = syntax.between(start, end)
    first = start + len(text) - len(text.lstrip())
    newline = "\r\n" if syntax.text[end : end + 2] == b"\r\n" else "\n"
    node = syntax.root.descendant_for_byte_range(first, first + 1)
    if node is None or node.type == "comment" or _is_in_string(node, first):
        return []
    statement = statement_of(node)
    if statement.type == "import_from_statement" and "(" not in text and "\\" not in text:
        head, _, names = text.partition(" import ")
        text = f"{head} import ({names})"
    if statement.start_byte == first:
        style = _brackets(syntax, statement, broken, limit)
        if first > start and "\t" not in text:
            style = replace(style, indent=style.indent.replace("\t", " " * 4))
        fitted = fit(text, style)
        if fitted != text:
            return [Splice(start, end, syntax.encode(fitted.replace("\n", newline)))]
    return _break_before_last(syntax, start, end, newline)


def _is_in_string(node: Node, start: int) -> bool:
    """Whether a line begins within a text of several lines."""
    return (
        node.type.startswith("string")
        and node.type != "string_start"
        and node.start_byte < (start + 1)
    )


def _break_before_last(syntax: Syntax, start: int, end: int, newline: str) -> list[Splice]:
    """Put the last argument of a line on the next one, below those that stand above it."""
    node = syntax.root.descendant_for_byte_range(end - 1, end)
    while node is not None and node.type not in ("argument_list", "import_from_statement"):
        node = node.parent
    is_import = node is not None and node.type == "import_from_statement"
    items = (
        node.children_by_field_name("name") if node is not None and is_import else parts_of(node)
    )
    own = [item for item in items if start <= item.start_byte < end]
    if node is None or len(own) < 2:
        return []
    begin = line_start(syntax.text, items[0].start_byte)
    before = syntax.between(begin, items[0].start_byte)
    margin = before[: len(before) - len(before.lstrip())]
    margin += " " * (len(before) - len(margin))
    written = syntax.encode(newline + margin)
    return [Splice(own[-2].end_byte + 1, own[-1].start_byte, written)]


def _brackets(syntax: Syntax, statement: Node, broken: Broken, limit: int) -> Brackets:
    """Find out how a file breaks what is like a statement, or else its calls."""
    is_head = statement.type == "function_definition"
    calls = broken["arguments"]
    name = syntax.called_name(_call_of(statement))
    alike = [each for each in calls if name and syntax.called_name(each.parent) == name]
    own = broken["parameters"] if is_head else alike
    models = own or calls
    indent = block_indent(syntax.text)
    found = Counter(_manner(syntax, each, limit, indent) for each in models[-_MOST_CALLS:])
    usual = Brackets(limit, indent, splits_strings=False)
    style = found.most_common(1)[0][0] if found else usual
    if is_head and not own:
        style = replace(style, is_each_apart=False)
    if statement.type in _HEADS and not style.is_closed_apart:
        # What stands as deep as the body below it is not told from it: pycodestyle's E125.
        style = replace(style, indent=indent * 2)
    return style


def _call_of(statement: Node) -> Node | None:
    """Return the call that a statement is, or assigns."""
    node: Node | None = statement
    while node is not None and node.type != "call":
        if node.type not in ("expression_statement", "assignment", "return_statement", "await"):
            return None
        node = node.child_by_field_name("right") or next(iter(node.named_children), None)
    return node


def _manner(syntax: Syntax, arguments: Node, limit: int, indent: str) -> Brackets:
    """Return how a call is broken."""
    items = parts_of(arguments)
    rows = [item.start_point.row for item in items]
    last = items[-1]
    line = syntax.text[line_start(syntax.text, arguments.start_byte) :]
    margin = line[: len(line) - len(line.lstrip())]
    deeper = items[0].start_point.column - len(margin)
    if rows[0] > arguments.start_point.row and b"\t" not in margin and deeper in (2, 4, 8):
        indent = " " * deeper
    return Brackets(
        limit,
        indent,
        is_visual=rows[0] == arguments.start_point.row and "\t" not in indent,
        is_closed_apart=last.end_point.row < arguments.end_point.row,
        is_each_apart=len(items) > 2 and len(set(rows)) == len(rows),
        has_comma=syntax.text[last.end_byte : last.end_byte + 1] == b",",
        splits_strings=False,
    )


def _broken(syntax: Syntax) -> Broken:
    """Return the calls and the heads of functions that a file breaks."""
    captured = syntax.captures("arguments")
    return {
        name: [each for each in captured.get(name, []) if _is_broken(each)]
        for name in ("arguments", "parameters")
    }


def _is_broken(arguments: Node) -> bool:
    """Whether a call has arguments on several lines, or on the line behind its bracket."""
    items = parts_of(arguments)
    rows = {arguments.start_point.row, *(item.start_point.row for item in items)}
    return bool(items) and len(rows) > 1
