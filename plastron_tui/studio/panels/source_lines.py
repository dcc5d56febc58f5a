"""Source files and what changes in them, as coloured lines."""

from __future__ import annotations

from collections.abc import Iterator
from difflib import unified_diff
from pathlib import Path

from .styles import Line, Lines, Piece

LONGEST = 4000
"""The most lines of a file that are coloured; a generated one has some sixty."""

_TONES = (
    # Lines for a preprocessor count as comments for Pygments, and are none for who reads them.
    ("Token.Comment.PreprocFile", "string"),
    ("Token.Comment.Preproc", "keyword"),
    ("Token.Comment", "quiet"),
    ("Token.Literal.String", "string"),
    ("Token.Literal.Number", "number"),
    ("Token.Keyword.Constant", "number"),
    ("Token.Keyword", "keyword"),
    ("Token.Operator.Word", "keyword"),
    ("Token.Name.Function", "name"),
    ("Token.Name.Class", "name"),
    ("Token.Name.Decorator", "name"),
    ("Token.Name.Builtin", "builtin"),
    ("Token.Name.Tag", "keyword"),
    ("Token.Name.Attribute", "name"),
)


_OTHERS = {
    **dict.fromkeys((".urdf", ".xacro", ".xml", ".launch"), "xml"),
    **dict.fromkeys((".yaml", ".yml", ".rviz"), "yaml"),
    **dict.fromkeys((".cmake", "CMakeLists.txt"), "cmake"),
}
"""What Pygments calls the languages of files that hold no node, by their suffixes or names."""


def coloured(text: str, path: Path) -> Lines:
    """Return the lines of a source file, coloured as its name says."""
    rows = text.split("\n")
    if rows and not rows[-1]:
        rows.pop()
    name = lexer_of(path) if len(rows) <= LONGEST else None
    if name is None:
        return tuple((Piece(row.expandtabs(4)),) for row in rows)
    return tuple(_lexed(text, name))[: len(rows)]


def lexer_of(path: Path) -> str | None:
    """Return what Pygments calls the language of a file, None for one that is not coloured."""
    from plastron_tui.targets import language_of

    language = language_of(path)
    return _OTHERS.get(path.suffix, _OTHERS.get(path.name)) if language is None else language.name


def _lexed(text: str, language: str) -> Iterator[Line]:
    from pygments.lexers import get_lexer_by_name
    from pygments.lexers.special import TextLexer
    from pygments.util import ClassNotFound

    try:
        lexer = get_lexer_by_name(language, stripnl=False, ensurenl=False)
    except ClassNotFound:
        lexer = TextLexer(stripnl=False, ensurenl=False)
    line: list[Piece] = []
    for kind, value in lexer.get_tokens(text):
        tone = _tone(kind)
        first, *others = value.split("\n")
        if first:
            line.append(Piece(first.expandtabs(4), tone))
        for other in others:
            yield tuple(line)
            line = [Piece(other.expandtabs(4), tone)] if other else []
    yield tuple(line)


_seen: dict[object, str] = {}


def _tone(kind: object) -> str:
    tone = _seen.get(kind)
    if tone is None:
        written = str(kind)
        tone = next((tone for start, tone in _TONES if written.startswith(start)), "")
        _seen[kind] = tone
    return tone


def diff_lines(patch: str) -> Lines:
    """Return a patch, coloured; its header is left out."""
    lines: list[Line] = []
    for row in patch.split("\n"):
        if row.startswith(("diff --git", "index ", "--- ", "+++ ")):
            continue
        if row.startswith("@@"):
            lines.append((Piece(row, "quiet"),))
        elif row.startswith("+"):
            lines.append((Piece(row, "added"), Piece("", "added")))
        elif row.startswith("-"):
            lines.append((Piece(row, "removed"), Piece("", "removed")))
        else:
            lines.append((Piece(row),))
    while lines and not "".join(piece.text for piece in lines[-1]):
        lines.pop()
    return tuple(lines)


def difference(before: bytes, after: bytes) -> Lines:
    """Return how two texts differ, coloured."""
    rows = unified_diff(
        before.decode("utf-8", "replace").splitlines(),
        after.decode("utf-8", "replace").splitlines(),
        lineterm="",
    )
    return diff_lines("\n".join(rows))
