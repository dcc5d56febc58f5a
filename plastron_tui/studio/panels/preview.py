"""The files that nodes become, with what writing them would change."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from plastron_tui.diagnostics import Diagnostic
from plastron_tui.model.workspace import Generation
from plastron_tui.output.plan import FileState

from .source_lines import coloured, diff_lines, difference
from .styles import Lines

if TYPE_CHECKING:
    from ..analysis import Analysis


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
        size: how large it will be, in bytes.
    """

    name: str
    path: Path | None
    state: FileState | None
    lines: Lines
    diff: Lines | None
    problems: tuple[Diagnostic, ...]
    size: int = 0


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
        size = len(file.text)
        yield Preview(file.name, file.path, state, lines, diff, made.diagnostics, size)
