"""A CMakeLists.txt as bytes, and its commands over exactly these bytes.

Its grammar is an extra, as it comes as source and needs a C compiler; it is imported when the
first file is parsed.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from itertools import count
from pathlib import Path
from typing import TypeAlias

from tree_sitter import Language, Node, Parser

from plastron_tui.diagnostics import Diagnostic, codes
from plastron_tui.sources.build_files import RefusedError, check_text, refusal
from plastron_tui.sources.grammars import first_error

_DEEPEST = 60
_BLOCKS = {
    "if_condition": "if",
    "foreach_loop": "foreach",
    "while_loop": "while",
    "function_def": "function",
    "macro_def": "macro",
    "block_def": "block",
}
# These stand by themselves only where what they belong to is missing.
_PARTS = frozenset(
    {"else", "elseif"} | {word for name in _BLOCKS.values() for word in (name, f"end{name}")}
)
_BLANKS = re.compile(rb"[\r\n][ \t\r\n]{200,}|[ \t][ \t]{200,}")
"""Blanks that no line comment ends in but at the first one; `\\r` ends one for the grammar, too."""


@dataclass(frozen=True, slots=True)
class Argument:
    """An argument of a command, `start` to `end` in bytes.

    Attributes:
        start: where it begins, quotes and brackets included.
        end: where it ends.
        value: what it says without quotes and brackets; references are left in it.
        is_quoted: whether it is one value whatever it holds.
        is_bracket: whether references in it mean nothing.
    """

    start: int
    end: int
    value: str
    is_quoted: bool = False
    is_bracket: bool = False


@dataclass(frozen=True, slots=True)
class Command:
    """A call of a command, whose names CMake takes in any case.

    Attributes:
        name: its name in small letters.
        spelled: its name as it is written.
        start: where it begins, in bytes.
        end: where it ends.
        arguments: what it is given; parentheses within are left out.
        opening: the end of its opening parenthesis.
        closing: where its closing parenthesis is.
    """

    name: str
    spelled: str
    start: int
    end: int
    arguments: tuple[Argument, ...]
    opening: int
    closing: int

    @property
    def span(self) -> tuple[int, int]:
        """Where it is, in bytes."""
        return self.start, self.end

    @property
    def words(self) -> tuple[str, ...]:
        """Its name and the values of its arguments, which is all that it says."""
        return (self.name, *(each.value for each in self.arguments))


@dataclass(frozen=True, slots=True)
class Branch:
    """What stands below `if`, `elseif`, `else`, `foreach` or another opening command."""

    opening: Command
    statements: tuple[Statement, ...]


@dataclass(frozen=True, slots=True)
class Block:
    """An `if`, a loop or a definition, from its first command to its last."""

    kind: str
    branches: tuple[Branch, ...]
    start: int
    end: int


Statement: TypeAlias = "Command | Block"


@dataclass(frozen=True, slots=True)
class Listing:
    """A parsed CMakeLists.txt.

    Attributes:
        text: what is in the file.
        path: the file.
        statements: its commands and blocks.
        comments: where its comments are, in bytes.
    """

    text: bytes
    path: Path
    statements: tuple[Statement, ...]
    comments: tuple[tuple[int, int], ...]

    def commands(self) -> Iterator[Command]:
        """Return every command, those of blocks too, in the order of the file."""
        stack: list[Statement] = list(reversed(self.statements))
        while stack:
            each = stack.pop()
            if isinstance(each, Command):
                yield each
                continue
            for branch in reversed(each.branches):
                stack.extend(reversed(branch.statements))
                stack.append(branch.opening)


@cache
def _parser() -> Parser:
    """Return the parser of CMake.

    Raises:
        ImportError: the extra is not installed.
    """
    import tree_sitter_cmake

    return Parser(Language(tree_sitter_cmake.language()))


def parse_cmake(text: bytes, path: Path) -> Listing:
    """Parse a CMakeLists.txt.

    Raises:
        RefusedError: the grammar is not installed, it is no text, or has a syntax error.
    """
    check_text(text, path)
    try:
        parser = _parser()
    except ImportError:
        message = f"reading `{path.name}` needs the grammar of CMake"
        remedy = "pip install 'plastron-tui[cmake]'"
        raise RefusedError(
            Diagnostic(codes.MISSING_EXTRA, message, file=path, help=remedy)
        ) from None
    root = parser.parse(_with_short_blanks(text)).root_node
    if root.has_error:
        raise _broken(text, path, _first_wrong(root))
    comments = tuple(
        (each.start_byte, each.end_byte)
        for each in _all(root)
        if each.type.endswith("_comment") and text.startswith(b"#", each.start_byte)
    )
    listing = Listing(text, path, _Builder(text, path).statements(root, 0), comments)
    _check_lines(listing)
    return listing


def _with_short_blanks(text: bytes) -> bytes:
    """Return a text of the same length with a comment for blanks that are too many.

    At each blank the grammar looks past all those that follow, which takes the square of them.
    """
    if _BLANKS.search(text) is None:
        return text
    width = next(width for width in count() if b"]%b]" % (b"=" * width) not in text)
    opening, closing = (each % (b"=" * width) for each in (b"#[%b[", b"]%b]"))

    def commented(found: re.Match[bytes]) -> bytes:
        blanks = found[0]
        room = len(blanks) - len(opening) - len(closing) - 1
        if room < 0:
            return blanks
        middle = blanks[1 + len(opening) :][:room]
        return blanks[:1] + opening + middle + closing

    return _BLANKS.sub(commented, text)


def _first_wrong(root: Node) -> tuple[int, int]:
    """Return where the first syntax error is; a command that is not closed begins there."""
    wrong = first_error(root)
    command = wrong.parent
    if wrong.is_missing and wrong.type == ")" and command is not None:
        opening = next((each for each in command.children if each.type == "("), command)
        return command.start_byte, opening.end_byte
    return wrong.start_byte, wrong.end_byte


def _broken(text: bytes, path: Path, span: tuple[int, int]) -> RefusedError:
    return refusal(text, path, span, "has a syntax error", codes.BROKEN_BUILD_FILE)


def _check_lines(listing: Listing) -> None:
    """Refuse two commands in a line, which CMake takes for a syntax error."""
    end = 0
    for each in listing.commands():
        if end and b"\n" not in listing.text[end : each.start]:
            raise _broken(listing.text, listing.path, each.span)
        end = each.end


def _all(root: Node) -> Iterator[Node]:
    stack = [root]
    while stack:
        node = stack.pop()
        yield node
        stack.extend(reversed(node.children))


class _Builder:
    """Makes commands of the nodes of a tree."""

    def __init__(self, text: bytes, path: Path) -> None:
        self._text, self._path = text, path

    def statements(self, node: Node, depth: int) -> tuple[Statement, ...]:
        """Return what stands in a file or a body."""
        if depth > _DEEPEST:
            span = (node.start_byte, node.end_byte)
            why = "is within too many blocks"
            raise refusal(self._text, self._path, span, why, codes.BROKEN_BUILD_FILE)
        found: list[Statement] = []
        for each in node.named_children:
            if each.type == "normal_command":
                command = self._command(each)
                if command.name in _PARTS:
                    raise _broken(self._text, self._path, command.span)
                found.append(command)
            elif each.type in _BLOCKS:
                found.append(self._block(each, depth))
        return tuple(found)

    def _block(self, node: Node, depth: int) -> Block:
        branches: list[Branch] = []
        opening: Command | None = None
        for each in node.named_children:
            if each.type == "body":
                if opening is not None:
                    branches.append(Branch(opening, self.statements(each, depth + 1)))
                    opening = None
            elif each.type.endswith("_command"):
                if opening is not None:
                    branches.append(Branch(opening, ()))
                is_end = each.type.startswith("end")
                opening = None if is_end else self._command(each)
        return Block(_BLOCKS[node.type], tuple(branches), node.start_byte, node.end_byte)

    def _command(self, node: Node) -> Command:
        children = node.children
        name = self._slice(children[0])
        opening = next(each for each in children if each.type == "(")
        given = next((each for each in children if each.type == "argument_list"), None)
        arguments = (
            []
            if given is None
            else [self._argument(each) for each in given.named_children if each.type == "argument"]
        )
        return Command(
            name.lower(),
            name,
            node.start_byte,
            node.end_byte,
            tuple(arguments),
            opening.end_byte,
            children[-1].start_byte,
        )

    def _argument(self, node: Node) -> Argument:
        source = self._slice(node)
        kind = node.named_children[0].type if node.named_child_count else "unquoted_argument"
        start, end = node.start_byte, node.end_byte
        if kind == "quoted_argument":
            return Argument(start, end, source[1:-1].replace("\\\n", ""), True)
        if kind == "bracket_argument":
            width = source.index("[", 1) + 1
            return Argument(start, end, source[width:-width], True, True)
        return Argument(start, end, source)

    def _slice(self, node: Node) -> str:
        return self._text[node.start_byte : node.end_byte].decode()
