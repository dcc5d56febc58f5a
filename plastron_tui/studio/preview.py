"""The files that nodes become, with what writing them would change."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from difflib import unified_diff
from pathlib import Path
from typing import TYPE_CHECKING

from plastron_tui.diagnostics import Diagnostic
from plastron_tui.model.workspace import Generation
from plastron_tui.output.plan import FileState
from plastron_tui.targets import language_of

from .panels.tones import Line, Lines, Piece

if TYPE_CHECKING:
    from .analysis import Analysis

LONGEST = 4000
"""The most lines of a file that are coloured; a generated one has some sixty."""

_TONES = (
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
)


@dataclass(frozen=True)
class Preview:
    """A file that a node becomes.

    Attributes:
        name: the file's name.
        path: where it would be written.
        state: what writing would do to it; None for a node that is not generated yet.
        lines: its text, coloured.
        diff: what would change in it, None where there is nothing to compare with.
        problems: why there is no text.
    """

    name: str
    path: Path | None
    state: FileState | None
    lines: Lines
    diff: Lines | None
    problems: tuple[Diagnostic, ...]


def previews_of(analysis: Analysis, variable: str) -> tuple[Preview, ...]:
    """Return the files of a node: those that it is generated as, or else would be."""
    node = analysis.workspace.nodes.get(variable)
    if node is None:
        return ()
    asked = {
        generation.library: generation
        for generation in analysis.workspace.generations
        if generation.node.variable == variable
    }
    if asked:
        return tuple(
            preview
            for generation in asked.values()
            for preview in _previews(analysis, generation, True)
        )
    library = node.source.library if node.source is not None else node.library
    generation = Generation(node, library or analysis.session.library, node.span)
    return tuple(_previews(analysis, generation, False))


def _previews(analysis: Analysis, generation: Generation, is_asked: bool) -> Iterator[Preview]:
    from plastron_tui.output.diff import file_diff, visible_patch

    session = analysis.session
    made = session.generate(generation)
    if made.files is None:
        yield Preview(generation.node.name, None, None, (), None, made.diagnostics)
        return
    plan, problems = session.plan_of([made], is_preview=True)
    if not plan.files:
        yield Preview(made.files.name, None, None, (), None, problems)
    source = generation.node.source
    is_own = source is not None and source.library == generation.library
    loaded = {} if source is None or not is_own else dict(source.files.texts)
    for file, name in zip(plan.files, made.files.files.names, strict=False):
        diff = None
        if file.before is not None and file.state is not FileState.IDENTICAL:
            diff = diff_lines(visible_patch(file_diff(file)))
        elif name in loaded:
            diff = difference(loaded[name], file.text)
        state = file.state if is_asked else None
        lines = coloured(file.text.decode("utf-8", "replace"), file.path)
        yield Preview(file.name, file.path, state, lines, diff, made.diagnostics)


def coloured(text: str, path: Path) -> Lines:
    """Return the lines of a source file, coloured as its name says."""
    rows = text.split("\n")
    if rows and not rows[-1]:
        rows.pop()
    language = language_of(path) if len(rows) <= LONGEST else None
    if language is None:
        return tuple((Piece(row.expandtabs(4)),) for row in rows)
    return tuple(_lexed(text, language.name))[: len(rows)]


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
    lines = []
    for row in patch.split("\n"):
        if row.startswith(("diff --git", "index ", "--- ", "+++ ")):
            continue
        if row.startswith("@@"):
            lines.append((Piece(row, "quiet"),))
        elif row.startswith("+"):
            lines.append((Piece(row, "added"),))
        elif row.startswith("-"):
            lines.append((Piece(row, "removed"),))
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
