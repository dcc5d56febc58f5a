"""Source files as coloured lines."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from ..files import SUFFIX
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
    if path.suffix == SUFFIX and len(rows) <= LONGEST:
        from .statement_lines import coloured_statements

        return coloured_statements(rows)
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
