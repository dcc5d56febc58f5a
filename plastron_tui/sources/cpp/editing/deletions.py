"""What an edit takes out of the files of a unit, in whole lines where it can."""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Iterator
from itertools import takewhile

from tree_sitter import Node

from plastron_tui.sources.splices import Splice, line_end, line_number, line_start

from ..preprocessing import written_code
from ..scopes import CppFile

_COMMENT = re.compile(rb"[ \t]*(?://[^\n]*|/\*[^\n]*\*/[ \t]*)?\r?\n?")
_COMMENT_LINE = re.compile(rb"[ \t]*(?://|/\*[^\n]*\*/[ \t]*\r?\n?$)")
_OPENING = re.compile(
    rb"(?:.*\{|[ \t]*(?:public|private|protected)[^\n]*:)[ \t]*\r?\n?\Z", re.DOTALL
)
_CONDITION = re.compile(rb"^[ \t]*#[ \t]*(if|ifdef|ifndef|elif|else|endif)\b", re.MULTILINE)
_ENDING = re.compile(rb"[ \t]*[})]")

_MACRO = re.compile(rb"(?<!\w)(?P<name>[A-Z][A-Z0-9_]*)(?P<gap>[ \t]+|[ \t]*\r?\n[ \t]*)\Z")
_VISIBILITY = re.compile(rb"_(?:PUBLIC|LOCAL|EXPORT|API)\Z")
_RULING = frozenset(
    {"if_statement", "else_clause", "for_statement", "for_range_loop", "while_statement"}
    | {"do_statement"}
)
_DOING = frozenset(
    {"call_expression", "assignment_expression", "update_expression", "declaration"}
    | {"init_declarator", "co_await_expression"}
)


class Deletions:
    """Parts of files that go."""

    def __init__(self) -> None:
        self._parts: defaultdict[CppFile, list[tuple[int, int]]] = defaultdict(list)
        self._lines: defaultdict[CppFile, list[tuple[int, int]]] = defaultdict(list)
        self._emptied: defaultdict[CppFile, list[tuple[int, int]]] = defaultdict(list)
        self._nodes: list[tuple[CppFile, Node]] = []
        self._bare: defaultdict[CppFile, list[tuple[int, int]]] = defaultdict(list)
        self._replaced: defaultdict[CppFile, list[Splice]] = defaultdict(list)
        self._written: dict[CppFile, bytes] = {}
        self._declarators: defaultdict[CppFile, dict[int, tuple[Node, set[int]]]]
        self._declarators = defaultdict(dict)

    def written(self, file: CppFile) -> bytes:
        """Return all that a file says in any branch or macro, see `written_code`."""
        if file not in self._written:
            self._written[file] = written_code(file.syntax.text)
        return self._written[file]

    def line(self, file: CppFile, start: int, end: int) -> None:
        """Take out whole lines as they are; the comment above them stays."""
        self._bare[file].append((start, end))

    def statement(self, file: CppFile, node: Node) -> None:
        """Take out a statement or declaration, with its lines where it has them alone.

        What is alone under an `if` or in a loop goes with that where its condition does nothing,
        and leaves empty braces elsewhere: it would be the next statement that is under it.
        """
        outer = node.parent
        if outer is not None and outer.type in _RULING and _is_body(node, outer):
            if outer.type == "if_statement" and _is_idle_if(outer):
                self.statement(file, outer)
            else:
                self._emptied[file].append((node.start_byte, node.end_byte))
            return
        if outer is not None and self._is_last_of_label(file, outer, node):
            # A label stands before a statement, until C++23.
            self._emptied[file].append((node.start_byte, node.end_byte))
            return
        self._nodes.append((file, node))
        end = node.end_byte
        behind = node.next_sibling
        if node.type == "function_definition" and behind is not None and behind.text == b";":
            # `void f() {};`
            end = behind.end_byte
        self._lines[file].append((node.start_byte, end))

    def _is_last_of_label(self, file: CppFile, outer: Node, node: Node) -> bool:
        """Tell whether a label is left without a statement where one goes."""
        if outer.type == "labeled_statement":
            return True
        if outer.type != "case_statement" or outer.next_named_sibling is not None:
            return False
        value = outer.child_by_field_name("value")
        others = [each for each in outer.named_children if each not in (node, value)]
        return all(self.covers(file, each.start_byte) for each in others)

    def declarator(self, file: CppFile, node: Node, index: int) -> None:
        """Take out one of several names that a declaration declares, or it with the last one."""
        declarators = node.children_by_field_name("declarator")
        _, taken = self._declarators[file].setdefault(node.id, (node, set()))
        taken.add(index)
        own = declarators[index]
        self.part(file, own.start_byte, own.end_byte)
        if len(taken) == len(declarators):
            self.statement(file, node)

    def _commas(self, file: CppFile) -> Iterator[tuple[int, int]]:
        """Yield names that go with the comma that stood between them and one that stays."""
        for node, taken in self._declarators[file].values():
            declarators = node.children_by_field_name("declarator")
            first = min((at for at in range(len(declarators)) if at not in taken), default=None)
            for at in sorted(taken if first is not None else ()):
                if first is not None and at < first:
                    yield declarators[at].start_byte, declarators[at + 1].start_byte
                else:
                    yield declarators[at - 1].end_byte, declarators[at].end_byte

    def take_empty(self) -> None:
        """Take out each block that nothing is left in, with its `if` where that does nothing."""
        for file, node in self._nodes:
            block = node.parent
            outer = None if block is None else block.parent
            if block is None or block.type != "compound_statement" or outer is None:
                continue
            is_bare = outer.type == "compound_statement"
            if not is_bare and (outer.type != "if_statement" or not _is_idle_if(outer)):
                continue
            whole = block if is_bare else outer
            if (
                self.covers(file, whole.start_byte)
                or b"//" in file.syntax.text[block.start_byte : node.start_byte]
            ):
                continue
            if all(self.covers(file, each.start_byte) for each in block.named_children):
                self.statement(file, whole)

    def take_sections(self) -> None:
        """Take out each `private:` that nothing is left of."""
        for file, node in list(self._nodes):
            listed = node.parent
            if listed is None or listed.type != "field_declaration_list":
                continue
            parts = [*listed.named_children]
            at = next((i for i, each in enumerate(parts) if each.id == node.id), 0)
            while at and parts[at].type != "access_specifier":
                at -= 1
            own = parts[at]
            section = list(takewhile(lambda x: x.type != "access_specifier", parts[at + 1 :]))
            if own.type != "access_specifier" or self.covers(file, own.start_byte):
                continue
            if not all(self.covers(file, each.start_byte) for each in section):
                continue
            text, start = file.syntax.text, own.end_byte
            left = b""
            for each in section:
                left += text[start : each.start_byte]
                start = each.end_byte
            if not left.strip(b" \t\r\n:;"):
                end = text.find(b":", own.start_byte) + 1
                self._lines[file].append((own.start_byte, end))

    def part(self, file: CppFile, start: int, end: int) -> None:
        """Take out a part of a line."""
        self._parts[file].append((start, end))

    def replace(self, file: CppFile, node: Node, text: str) -> None:
        """Write something else in the place of a part that goes."""
        encoded = text.encode(file.syntax.encoding)
        self._replaced[file].append(Splice(node.start_byte, node.end_byte, encoded))

    def covers(self, file: CppFile, offset: int) -> bool:
        """Tell whether what stands at an offset goes."""
        parts = (
            *(*self._parts[file], *self._lines[file]),
            *(*self._emptied[file], *self._bare[file]),
        )
        is_replaced = any(each.start <= offset < each.end for each in self._replaced[file])
        return is_replaced or any(start <= offset < end for start, end in parts)

    @property
    def files(self) -> Iterator[CppFile]:
        """The files that lose something."""
        found = (self._parts, self._lines, self._emptied, self._bare, self._replaced)
        yield from dict.fromkeys(file for each in found for file, parts in each.items() if parts)

    def splices(self, file: CppFile) -> list[Splice]:
        """Return the splices for a file."""
        text = file.syntax.text
        lines = [(_with_macros(file, start), end) for start, end in self._lines[file]]
        found = _merged(text, [_lines_of(text, start, end) for start, end in lines])
        tidy = [_tidy(text, *_with_comment(text, start, end)) for start, end in found]
        # What was apart by a comment that goes too is tidied as one.
        whole = [each if each in tidy else _tidy(text, *each) for each in _joined(tidy)]
        whole += [_tidy(text, *each) for each in _merged(text, self._bare[file])]
        gone = _joined([*whole, *self._parts[file], *self._commas(file)])
        gone = _joined([*gone, *self._emptied_bodies(file, gone)])
        gone = _joined([_whole_lines(text, each, gone) for each in gone])
        written = [Splice(start, end, b"{}") for start, end in self._emptied[file]]
        written += self._replaced[file]
        left = [
            each for each in written if not any(first <= each.start < last for first, last in gone)
        ]
        return [*(Splice(start, end) for start, end in gone), *left]

    def torn(self, file: CppFile) -> Iterator[tuple[CppFile, int]]:
        """Yield where what goes has a part of a conditional of the preprocessor, as in `in_use`."""
        written = self.written(file)
        parts = [*self._parts[file], *self._lines[file], *self._emptied[file]]
        parts += [(each.start, each.end) for each in self._replaced[file]]
        for start, end in parts:
            depth = 0
            for found in _CONDITION.finditer(written, start, end):
                word = found[1]
                if word.startswith(b"e") and not depth:
                    yield file, line_number(written, found.start())
                    break
                depth += word.startswith(b"if") - (word == b"endif")
            else:
                if depth:
                    yield file, line_number(written, start)

    def _emptied_bodies(
        self, file: CppFile, gone: list[tuple[int, int]]
    ) -> Iterator[tuple[int, int]]:
        """Yield what is in bodies of functions that are left without anything, as in `f() {}`.

        Those whose brace has a line of its own keep their lines.
        """
        text = file.syntax.text
        for node in (each for known, each in self._nodes if known is file):
            block = node.parent
            outer = None if block is None else block.parent
            if block is None or outer is None or block.type != "compound_statement":
                continue
            start, end = block.start_byte + 1, block.end_byte - 1
            is_apart = not text[line_start(text, start) : start - 1].strip()
            if outer.type != "function_definition" or is_apart:
                continue
            left, at = b"", start
            for first, last in gone:
                if first < end and at < last:
                    left += text[at:first]
                    at = last
            if not (left + text[at:end]).strip():
                yield start, end


def _is_body(node: Node, outer: Node) -> bool:
    """Tell whether a statement is what a condition or a loop rules, without braces."""
    fields = ("consequence", "body")
    named = (outer.child_by_field_name(each) for each in fields)
    is_else = outer.type == "else_clause"
    return is_else or any(each is not None and each.id == node.id for each in named)


def _is_idle_if(node: Node) -> bool:
    """Tell whether an `if` has no `else`, and a condition that does nothing."""
    condition = node.child_by_field_name("condition")
    if condition is None or node.child_by_field_name("alternative") is not None:
        return False
    stack = [condition]
    while stack:
        each = stack.pop()
        if each.type in _DOING:
            return False
        stack += each.named_children
    return True


def _with_macros(file: CppFile, start: int) -> int:
    """Return where the macros begin that stand before a declaration, as for its visibility."""
    text, code = file.syntax.text, file.syntax.code
    while found := _MACRO.search(text, max(0, start - 120), start):
        is_code = code[found.start() : found.end()].strip()
        if is_code or (b"\n" in found["gap"] and not _VISIBILITY.search(found["name"])):
            break
        start = found.start()
    return start


def _lines_of(text: bytes, start: int, end: int) -> tuple[int, int]:
    """Return the whole lines of a statement that has them alone."""
    first, last = line_start(text, start), line_end(text, max(start, end - 1))
    behind = _COMMENT.match(text, end, last)
    if text[first:start].strip() or behind is None or behind.end() != last:
        return _with_blanks(text, start, end)
    return first, last


def _with_blanks(text: bytes, start: int, end: int) -> tuple[int, int]:
    """Take the blanks beside a statement that shares its line with others."""
    before, behind = start, end
    while text[before - 1 : before] in (b" ", b"\t"):
        before -= 1
    while text[behind : behind + 1] in (b" ", b"\t"):
        behind += 1
    if before == line_start(text, start):
        return start, behind
    if text[before - 1 : before] == b"{" and text[behind : behind + 1] == b"}":
        return before, behind
    return before, end


def _with_comment(text: bytes, first: int, last: int) -> tuple[int, int]:
    """Return whole lines with the comment above them that speaks of them alone."""
    if first != line_start(text, first) or last != line_end(text, last - 1):
        return first, last
    top = _doc_block(text, first)
    while top > 0:
        above = line_start(text, top - 1)
        if not _COMMENT_LINE.match(text[above:top]):
            break
        top = above
    below = text[last : line_end(text, last)]
    is_apart = not below.strip() or _ENDING.match(below) or _COMMENT_LINE.match(below)
    is_doc = text[top:first].lstrip().startswith((b"///", b"/**", b"//!"))
    return (top if is_doc or is_apart else first), last


def _doc_block(text: bytes, first: int) -> int:
    """Return where `/** ... */` begins that ends in the line above, or else the line itself."""
    if not text[:first].rstrip(b"\r\n").rstrip(b" \t").endswith(b"*/"):
        return first
    start = text.rfind(b"/*", 0, first)
    top = line_start(text, start)
    is_doc = text.startswith((b"/**", b"/*!"), start) and not text[top:start].strip()
    is_above = text[start:first].count(b"*/") == 1 and not text[:first].endswith(
        (b"\n\n", b"\n\r\n")
    )
    return top if is_doc and is_above else first


def _is_edge(line: bytes) -> bool:
    return not line.strip() or _OPENING.match(line) is not None


def _merged(text: bytes, parts: list[tuple[int, int]]) -> list[tuple[int, int]]:
    """Join parts that overlap, or have nothing but empty lines between them."""
    found: list[tuple[int, int]] = []
    for start, end in sorted(parts):
        if found and (start <= found[-1][1] or not text[found[-1][1] : start].strip()):
            is_lines = found[-1][1] == line_start(text, found[-1][1])
            if start <= found[-1][1] or is_lines:
                found[-1] = found[-1][0], max(end, found[-1][1])
                continue
        found.append((start, end))
    return found


def _whole_lines(
    text: bytes, part: tuple[int, int], gone: list[tuple[int, int]]
) -> tuple[int, int]:
    """Return a part that goes with its line, where nothing of that is left."""
    first, last = line_start(text, part[0]), line_end(text, part[1] - 1)
    left, at = b"", first
    for start, end in gone:
        if start < last and at < end:
            left += text[at:start]
            at = end
    return part if (left + text[at:last]).strip() else (first, max(last, part[1]))


def _joined(parts: list[tuple[int, int]]) -> list[tuple[int, int]]:
    """Join parts that overlap, or touch."""
    found: list[tuple[int, int]] = []
    for start, end in sorted(parts):
        if found and start <= found[-1][1]:
            found[-1] = found[-1][0], max(end, found[-1][1])
        else:
            found.append((start, end))
    return found


def _tidy(text: bytes, start: int, end: int) -> tuple[int, int]:
    """Take an empty line with lines that go where two would be left, or one at an edge."""
    if start != line_start(text, start) or end != line_end(text, end - 1):
        return start, end
    above = text[line_start(text, start - 1) : start] if start else b"{"
    below = text[end : line_end(text, end)]
    if not below.strip() and below and _is_edge(above):
        return start, line_end(text, end)
    if not above.strip() and start and _ENDING.match(below):
        return line_start(text, start - 1), end
    return start, end
