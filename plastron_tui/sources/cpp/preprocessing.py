"""What the preprocessor takes out of a C++ text before it is parsed, without moving an offset.

Comments and directives become blanks. Of a conditional both branches stay, as far as the two
make statements one after the other; where they are parts of one statement the first one stays,
and what `#if 0` switches off goes.

Source: ISO C++20, [lex.phases], [lex.pptoken], [cpp.cond].
"""

from __future__ import annotations

import re
from typing import NamedTuple

_COMMENT = rb"//(?:[^\n\\]|\\.)*|/\*.*?(?:\*/|\Z)"
_STRING = rb'"(?:[^"\\\n]|\\.)*"'
_CHARACTER = rb"'(?:[^'\\\n]|\\.)+'"
_TOKEN = re.compile(b"|".join((_COMMENT, _STRING, _CHARACTER)), re.DOTALL)
# The `'` between the digits of a number begins no character. Few texts have any, or raw strings.
_RARE = re.compile(rb'\d\'[\dA-Fa-f]|R"')
_RARE_TOKEN = re.compile(
    _COMMENT
    + rb'|\b(?:u8|[uUL])?R"(?P<end>[^()\\\s]{0,16})\(.*?(?:\)(?P=end)"|\Z)|'
    + _STRING
    + rb"|(?<![\dA-F])"
    + _CHARACTER,
    re.DOTALL,
)
_NOT_NEWLINE = re.compile(rb"[^\n]")
_DIRECTIVE = re.compile(rb"^[ \t]*#[ \t]*(\w*)((?:[^\n\\]|\\.)*)", re.MULTILINE | re.DOTALL)
_INCLUDE = re.compile(rb"""[ \t]*(?:<([^<>\n]+)>|"([^"\n]+)")""")
_DEFINE = re.compile(rb"[ \t]+(\w+)(\()?[ \t]*((?:[^\n\\]|\\.)*)", re.DOTALL)
_NEVER = re.compile(rb"[ \t]*(?:0|false)[ \t]*\Z")
_END_OF_LINE = re.compile(rb"\r(?!\n)")
# What g++ takes for the splice of two lines: blanks behind the backslash do not count.
_SPLICE = re.compile(rb"\\([ \t\r\f\v]+)\n")
_SLASH = ord("/")
# Deeper conditionals were made to break readers: each is counted in those around it.
_DEEPEST = 32
_ENDS = frozenset(b";}:")


class Include(NamedTuple):
    """An `#include`.

    Attributes:
        path: what it names.
        is_angled: whether it is in `<>`.
        start: where its line starts.
        end: where its line ends, without the newline.
    """

    path: str
    is_angled: bool
    start: int
    end: int


class Define(NamedTuple):
    """A macro without arguments: its name, and where its replacement is in the text."""

    name: str
    start: int
    end: int


class Preprocessed(NamedTuple):
    """A text that can be parsed.

    Attributes:
        code: the text with blanks for comments, directives, and what is never compiled.
        includes: its includes, in order; not those of branches that are never compiled.
        defines: its macros without arguments.
        conditionals: where each conditional starts and ends, with its directives; inner ones first.
    """

    code: bytearray
    includes: tuple[Include, ...]
    defines: tuple[Define, ...]
    conditionals: tuple[tuple[int, int], ...]


class _Branch(NamedTuple):
    start: int
    end: int
    is_never: bool


def blank(text: bytearray, start: int, end: int) -> None:
    """Put blanks over a part of a text; line ends stay."""
    text[start:end] = _NOT_NEWLINE.sub(b" ", text[start:end])


def preprocess(text: bytes) -> Preprocessed:
    """Return a text as it can be parsed, with its includes and macros."""
    return _preprocessed(*_without_comments(text))[0]


def written_code(text: bytes) -> bytes:
    """Return all that a text says in any branch, of the same length: macros and conditions as well.

    There are blanks for comments, includes, and what is never compiled.
    """
    code, bare = _without_comments(text)
    said = bytearray(code)
    _, dead = _preprocessed(code, bare)
    for branch in dead:
        blank(said, branch.start, branch.end)
    for directive in list(_DIRECTIVE.finditer(bytes(said))):
        if directive[1] == b"include":
            blank(said, *directive.span())
    return bytes(said)


def _without_comments(text: bytes) -> tuple[bytearray, bytearray]:
    """Return a text with blanks for comments, and one with blanks for strings as well."""
    code = bytearray(_SPLICE.sub(rb"\1\\\n", _END_OF_LINE.sub(b"\n", text)))
    bare = bytearray(code)
    tokens = _TOKEN if _RARE.search(code) is None else _RARE_TOKEN
    for token in tokens.finditer(bytes(code)):
        start, end = token.span()
        said = token[0]
        gap = b" " * len(said) if b"\n" not in said else _NOT_NEWLINE.sub(b" ", said)
        bare[start:end] = gap
        if code[start] == _SLASH:
            code[start:end] = gap
    if text.startswith(b"\xef\xbb\xbf"):
        blank(code, 0, 3)
        blank(bare, 0, 3)
    return code, bare


def _preprocessed(code: bytearray, bare: bytearray) -> tuple[Preprocessed, list[_Branch]]:
    """Put blanks over the directives of a text, and the branches that cannot stay.

    Returns it with the branches that are never compiled.
    """
    # A directive that names a file does so in quotes, which are blank in `bare`.
    includes: list[Include] = []
    defines: list[Define] = []
    opened: list[list[tuple[int, int, bool]]] = []
    dead: list[_Branch] = []
    conditionals: list[tuple[int, int]] = []
    for directive in list(_DIRECTIVE.finditer(bytes(bare))):
        start, end = directive.span()
        word, rest = directive[1], bytes(code[directive.start(2) : end])
        if word == b"include" and (path := _INCLUDE.match(rest)):
            name = (path[1] or path[2]).decode("utf-8", "replace").strip()
            includes.append(Include(name, path[1] is not None, start, end))
        elif word == b"define" and (macro := _DEFINE.match(rest)) and not macro[2]:
            at = directive.start(2)
            name = macro[1].decode("utf-8", "replace")
            defines.append(Define(name, at + macro.start(3), at + macro.end(3)))
        elif word in (b"if", b"ifdef", b"ifndef"):
            opened.append([(start, end, word == b"if" and _NEVER.match(rest) is not None)])
        elif word in (b"else", b"elif") and opened:
            opened[-1].append((start, end, word == b"elif" and _NEVER.match(rest) is not None))
        elif word == b"endif" and opened:
            conditionals.append((opened[-1][0][0], end))
            dead += _choose(opened.pop(), start, code, bare, len(opened))
        blank(code, start, end)
        blank(bare, start, end)
    # What is never compiled names nothing.
    never = bytearray(len(code) + 1)
    for gone in dead:
        never[gone.start : gone.end] = b"x" * (gone.end - gone.start)
    found = Preprocessed(
        code,
        tuple(each for each in includes if not never[each.start]),
        tuple(each for each in defines if not never[each.start]),
        tuple(conditionals),
    )
    return found, dead


def _choose(
    heads: list[tuple[int, int, bool]], stop: int, code: bytearray, bare: bytearray, depth: int
) -> list[_Branch]:
    """Put blanks over the branches of a conditional that cannot stay beside the others.

    Returns those that are never compiled.
    """
    ends = [*(head[0] for head in heads[1:]), stop]
    branches = [_Branch(head[1], end, head[2]) for head, end in zip(heads, ends, strict=True)]
    live, dead = [], []
    for branch in branches:
        if branch.is_never:
            blank(code, branch.start, branch.end)
            blank(bare, branch.start, branch.end)
            dead.append(branch)
        else:
            live.append(branch)
    if len(live) < 2 or depth > _DEEPEST:
        return dead
    said = [each for each in live if bare[each.start : each.end].strip()]
    if all(_is_whole(bare, each) for each in said):
        return dead
    for branch in said[1:]:
        blank(code, branch.start, branch.end)
        blank(bare, branch.start, branch.end)
    return dead


def _is_whole(bare: bytearray, branch: _Branch) -> bool:
    """Whether a branch holds whole statements or declarations."""
    start, end = branch.start, branch.end
    for opening, closing in ((b"{", b"}"), (b"(", b")")):
        if bare.count(opening, start, end) != bare.count(closing, start, end):
            return False
    return bare[start:end].rstrip()[-1] in _ENDS
