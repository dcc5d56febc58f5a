"""Splices of Python: statements with their comments, and items between commas."""

from __future__ import annotations

import re
from collections.abc import Container, Sequence

from tree_sitter import Node

from plastron_tui.sources.splices import Splice, apply, line_end, line_start

from .syntax import parts_of

_RULER = re.compile(rb"([^\w\s.])\1{2,}")
# What linters, formatters and type checkers read.
_FOR_TOOLS = re.compile(
    rb"^#!|^#\s*(coding|fmt|flake8|isort|mypy|noqa|pragma|pylint|ruff|type|yapf)\b"
)
_BLANK_LINE = re.compile(rb"^[ \t]*\r?$", re.M)
_CLAUSE = re.compile(rb"[ \t]*(elif|else|except|finally)\b")
# What calls and comments have in common that are about one kind of endpoint.
_KINDS = (b"publish", b"subscri", b"servi", b"client")
# What the comments of many nodes say for them.
_TRANSLATED = {"发布": b"publish", "订阅": b"subscri", "服务": b"servi", "客户端": b"client"}
_WORD = re.compile(rb"[a-z]{3,}")
_CAPITAL = re.compile(rb"(?<=[a-z])([A-Z])")
_STEM = 5
# A variable is hardly ever called so in full.
_SHORT = {b"msg": b"messa", b"msgs": b"messa"}
_BLANKS = re.compile(rb"[ \t]*")
_HEADER = re.compile(rb"(?:\xef\xbb\xbf)?(?:[ \t]*(?:#[^\n]*)?\r?\n)*")
_TARGET = rb"[\w.\[\]'\"]+"
_CALL_OR_VALUE = rb"\w\(|^%s(, ?%s)*\s*[-+*/]?=|==" % (_TARGET, _TARGET)
_CODE = re.compile(rb"%s|^(from|import|if|for|while|return|del|pass)\b" % _CALL_OR_VALUE)
_SURE_CODE = re.compile(_CALL_OR_VALUE)


__all__ = [
    "Splice",
    "apply",
    "around",
    "before_comments",
    "delete_item",
    "delete_statements",
    "is_commented_code",
    "line_end",
    "line_start",
]


def before_comments(text: bytes, at: int) -> int:
    """Step back over the comments in the lines before the start of a line."""
    while at > 0:
        previous = line_start(text, at - 1)
        line = text[previous:at].strip()
        if not line.startswith(b"#") or line.startswith(b"#!") or previous >= at:
            break
        at = previous
    return at


def delete_statements(text: bytes, statements: Sequence[Node]) -> list[Splice]:
    """Delete statements with their trailing comments; a block that they empty gets a `pass`."""
    splices: list[Splice] = []
    blocks: dict[int, tuple[Node, list[Node]]] = {}
    end = 0
    for statement in sorted(statements, key=lambda node: (node.start_byte, -node.end_byte)):
        parent, is_within = statement.parent, statement.end_byte <= end
        end = max(end, statement.end_byte)
        if parent is not None and not is_within:
            blocks.setdefault(parent.id, (parent, []))[1].append(statement)
    for block, gone in blocks.values():
        gone.sort(key=lambda node: node.start_byte)
        kept = [child for child in parts_of(block) if all(child.id != node.id for node in gone)]
        if not kept and block.type != "module":
            first = gone.pop(0)
            splices.append(Splice(first.start_byte, first.end_byte, b"pass"))
        ids = {node.id for node in gone}
        splices += [_delete(text, node, ids) for node in gone]
    return _close_gaps(text, splices)


def around(statement: Node, part: Node) -> list[Splice]:
    """Delete all of a statement but one part."""
    before = Splice(statement.start_byte, part.start_byte)
    after = Splice(part.end_byte, statement.end_byte)
    return [each for each in (before, after) if each.start < each.end]


def _delete(text: bytes, statement: Node, gone: Container[int]) -> Splice:
    start, end = statement.start_byte, statement.end_byte
    mates = _line_mates(statement, gone)
    if not text[line_start(text, start) : mates[0].start_byte].strip():
        start, end, statement = mates[0].start_byte, mates[-1].end_byte, mates[-1]
    first, last = line_start(text, start), line_end(text, end)
    before, after = text[first:start], text[end:last].strip()
    if after.startswith(b";") and after[1:].strip()[:1] in (b"", b"#"):
        end = text.index(b";", end) + 1
        after = b""
    if not before.strip() and (not after or after.startswith(b"#")):
        return Splice(first, last)
    following = statement.next_named_sibling
    if after.startswith(b";") and following is not None:
        return Splice(start, following.start_byte)
    semicolon = text.rfind(b";", first, start)
    if semicolon >= 0:
        return Splice(semicolon, end)
    return Splice(start, end, b"pass")


def _line_mates(statement: Node, gone: Container[int]) -> list[Node]:
    """Return the statements that go with one, in its line."""
    mates = [statement]
    while (mate := mates[0].prev_named_sibling) is not None and mate.id in gone:
        if mate.end_point.row != mates[0].start_point.row:
            break
        mates.insert(0, mate)
    while (following := mates[-1].next_named_sibling) is not None and following.id in gone:
        if following.start_point.row != mates[-1].end_point.row:
            break
        mates.append(following)
    return mates


def _close_gaps(text: bytes, splices: Sequence[Splice]) -> list[Splice]:
    """Let deleted lines take the blank lines and the comment with them that only they needed."""
    gaps = [
        Splice(_over_comment(text, each), each.end) if _is_lines(text, each) else each
        for each in _merged(text, splices)
    ]
    # Without the comments some have nothing between them any more.
    gaps = _merged(text, gaps)
    return [_close_gap(text, each) if _is_lines(text, each) else each for each in gaps]


def _merged(text: bytes, splices: Sequence[Splice]) -> list[Splice]:
    """Join deleted lines that have nothing between them."""
    found: list[Splice] = []
    for splice in sorted(splices):
        last = found[-1] if found else None
        if last is not None and _are_one_gap(text, last, splice):
            found[-1] = Splice(last.start, max(last.end, splice.end))
        else:
            found.append(splice)
    return found


def _are_one_gap(text: bytes, first: Splice, second: Splice) -> bool:
    """Whether deleted lines have nothing between them, nor the end of a block."""
    if not (_is_lines(text, first) and _is_lines(text, second)):
        return False
    is_end = len(_indent(text, second.start)) < len(_indent(text, first.start))
    return not is_end and not text[first.end : second.start].strip()


def _is_lines(text: bytes, splice: Splice) -> bool:
    """Whether a splice deletes whole lines."""
    is_end = splice.end == len(text) or text[splice.end - 1 : splice.end] == b"\n"
    return not splice.text and is_end and line_start(text, splice.start) == splice.start


def _close_gap(text: bytes, lines: Splice) -> Splice:
    """Keep the larger one of the gaps before and behind deleted lines; none at a block's ends."""
    start, end = lines.start, lines.end
    before, after = _blank_before(text, start), _blank_after(text, end)
    first = before[-1] if before else start
    if (after[-1] if after else end) == len(text) or _CLAUSE.match(text, end):
        return Splice(first, end)
    if line_start(text, first) == line_start(text, 0) or (
        not before and text[:start][-200:].rstrip().endswith(b":")
    ):
        return Splice(start, after[-1] if after else end)
    shorter = min(len(before), len(after))
    return Splice(before[shorter - 1] if shorter else start, end)


def _blank_before(text: bytes, start: int) -> list[int]:
    """Return where the blank lines before a line begin, the last line first."""
    found: list[int] = []
    while start > 0:
        previous = line_start(text, start - 1)
        if text[previous:start].strip() or previous >= start:
            break
        found.append(previous)
        start = previous
    return found


def _blank_after(text: bytes, end: int) -> list[int]:
    """Return where the blank lines from an offset on end."""
    found: list[int] = []
    while end < len(text) and not text[end : line_end(text, end)].strip():
        end = line_end(text, end)
        found.append(end)
    return found


def _over_comment(text: bytes, lines: Splice) -> int:
    """Return where deleted lines begin, with the comment above them that speaks of them alone.

    What heads the file, draws a line, tells a tool something, or is code, stays.
    """
    if (heading := _over_heading(text, lines)) is not None:
        return heading
    indent = _indent(text, lines.start)
    following = text[lines.end : line_end(text, lines.end)]
    is_end = not following.strip() or len(_indent(text, lines.end)) < len(indent)
    start = lines.start
    while start > 0:
        previous = line_start(text, start - 1)
        line = text[previous:start].strip()
        if previous >= start or _indent(text, previous) != indent or not line.startswith(b"#"):
            break
        # What stands below a line of code that somebody took out is a comment of its own.
        if is_commented_code(line) or _ends_box(text, previous, start):
            break
        if not _is_prose(line):
            return lines.start
        start = previous
    comment = text[start : lines.start]
    if is_end:
        said = _translated(comment)
        speaks = _is_about(said, text, lines) and _names_no_other(said, text, lines)
    elif following.lstrip().startswith(b"#"):
        speaks = _is_about(comment, text, lines)
    else:
        speaks = _speaks_of(comment, text, lines)
    if not speaks:
        return lines.start
    header = _HEADER.match(text)
    return lines.start if header is not None and header.end() >= start else start


def _ends_box(text: bytes, start: int, end: int) -> bool:
    """Whether a line is the ruler below a heading between two."""
    above = text[line_start(text, max(start - 1, 0)) : start].strip()
    is_ruler = _RULER.search(text[start:end]) is not None
    return is_ruler and above.startswith(b"#") and _RULER.search(above) is None


def _over_heading(text: bytes, lines: Splice) -> int | None:
    """Return where the heading begins of a section that deleted lines were alone in.

    That is a comment with rulers, or with a blank line below; None where there is none.
    """
    blanks, indent = _blank_before(text, lines.start), _indent(text, lines.start)
    at = start = blanks[-1] if blanks else lines.start
    words: list[bytes] = []
    while start > 0:
        previous = line_start(text, start - 1)
        line = text[previous:start].strip()
        if previous >= start or _indent(text, previous) != indent or not line.startswith(b"#"):
            break
        words.append(b"# " + _RULER.sub(b"", line).strip(b"# "))
        start = previous
    header = _HEADER.match(text)
    said = [line for line in words if line != b"# "]
    is_heading = len(blanks) == 1 or _RULER.search(text[start:at]) is not None
    is_first = header is not None and header.end() >= start
    if not is_heading or len(blanks) > 1 or is_first or not said or not all(map(_is_prose, said)):
        return None
    after = _blank_after(text, lines.end)
    following = after[-1] if after else lines.end
    paragraph = text[following : line_end(text, following)].strip()
    is_over = following == len(text) or len(_indent(text, following)) < len(indent)
    is_over = is_over or (paragraph.startswith(b"#") and _RULER.search(paragraph) is not None)
    comment = b"\n".join(said)
    if is_over:
        is_alone = _WORD.search(comment.lower()) is not None and _is_about(comment, text, lines)
    else:
        is_alone = bool(after) and _speaks_of(comment, text, Splice(lines.start, following))
    return start if is_alone else None


def _speaks_of(comment: bytes, text: bytes, lines: Splice) -> bool:
    """Whether a comment names what is deleted, and nothing of what follows it is called so."""
    blank = _BLANK_LINE.search(text, lines.end)
    following = text[lines.end : blank.start() if blank is not None else len(text)].lower()
    gone, said = text[lines.start : lines.end].lower(), _translated(comment)
    return any(word in said and word in gone and word not in following for word in _KINDS)


def _names_no_other(comment: bytes, text: bytes, lines: Splice) -> bool:
    """Whether a comment names no kind of endpoint that is not among what is deleted."""
    gone, said = text[lines.start : lines.end].lower(), comment.lower()
    return all(word in gone for word in _KINDS if word in said)


def _translated(comment: bytes) -> bytes:
    said = comment.lower()
    for word, kind in _TRANSLATED.items():
        said = said.replace(word.encode(), kind)
    return said


def _is_about(comment: bytes, text: bytes, lines: Splice) -> bool:
    """Whether a comment has a word of what is deleted, or is in no language that code is in.

    Words count as the same that begin alike: `publishing`, and `create_publisher`.
    """
    said, gone = _stems(comment), _stems(_split_words(text[lines.start : lines.end]))
    return not said or not said.isdisjoint(gone)


def _stems(words: bytes) -> set[bytes]:
    return {_SHORT.get(word, word[:_STEM]) for word in _WORD.findall(words.lower())}


def _split_words(code: bytes) -> bytes:
    """Return code in small letters, the words of its names apart: `TrafficSign` is two."""
    return _CAPITAL.sub(rb" \1", code).lower()


def _indent(text: bytes, start: int) -> bytes:
    found = _BLANKS.match(text, start)
    return found[0] if found is not None else b""


def _is_prose(comment: bytes) -> bool:
    """Whether a comment is made of words: no code, no ruler, and nothing that tools read."""
    said = comment.lstrip(b"#").strip()
    is_code = _CODE.search(said) is not None or said.endswith((b":", b",", b"]", b"}"))
    is_plain = _RULER.search(comment) is None and _FOR_TOOLS.search(comment) is None
    return bool(said) and is_plain and not is_code


def is_commented_code(comment: bytes) -> bool:
    """Whether a comment has a line in it that can be nothing but code."""
    return _SURE_CODE.search(comment.lstrip(b"#").strip()) is not None


def delete_item(text: bytes, items: Sequence[Node], item: Node) -> Splice:
    """Delete one of several items between commas, with its comma, and its line if it has one."""
    index = next(i for i, other in enumerate(items) if other.id == item.id)
    if index + 1 < len(items):
        end = items[index + 1].start_byte
        # An item on a line of its own takes the line, and the next keeps its indent.
        first = line_start(text, item.start_byte)
        next_first = line_start(text, end)
        if next_first > item.end_byte and not text[first : item.start_byte].strip():
            return Splice(first, next_first)
        if next_first > item.end_byte:
            # The next item begins a line: keep the break that stands before it.
            comma = text.find(b",", item.end_byte, end)
            before = items[index - 1].end_byte if index else item.start_byte
            if index:
                return Splice(before, item.end_byte)
            return Splice(item.start_byte, comma + 1)
        return Splice(item.start_byte, end)
    if index:
        return Splice(items[index - 1].end_byte, item.end_byte)
    return Splice(item.start_byte, item.end_byte)
