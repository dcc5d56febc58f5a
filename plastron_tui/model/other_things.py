"""A variable that stands for another thing than the one that a statement is about."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

from plastron_tui.diagnostics import Diagnostic, Fix, Span, write
from plastron_tui.language import DECLARATIONS, Statement

if TYPE_CHECKING:
    from plastron_tui.language.lowering import Program

    from .workspace import Workspace

_GENERATED_BY: Mapping[str, str] = {
    "node": "generate_node",
    "type": "generate_type",
    "package": "generate_package",
    "launch file": "generate_launch",
    "robot": "generate_robot",
}
"""The words that begin the sentences that write things."""


def another(
    workspace: Workspace, statement: Statement, variable: str
) -> tuple[str, Fix | None] | None:
    """Return what a variable stands for, and what is to be written; None for a free one."""
    found = workspace.what(variable)
    if found is None:
        return None
    thing, _ = found
    told, keyword = f"`{variable}` is a {thing}", DECLARATIONS[type(statement)].keyword
    right = _GENERATED_BY.get(thing)
    if right is None or keyword not in _GENERATED_BY.values():
        return told, None
    start = statement.span.start
    fix = write(right, Span(start, start + len(keyword)))
    return f"{told}: {fix.title}", fix


def decided(workspace: Workspace, program: Program) -> tuple[Diagnostic, ...]:
    """Return the mistakes in the lines of a program, knowing what its variables stand for.

    With a node `pilot`, `generate pilot` can be nothing else than `generate_node pilot`.
    """
    right: dict[Span | None, str] = {}
    for span, words, variable in program.broken.undecided:
        found = workspace.what(variable)
        word = None if found is None else _GENERATED_BY.get(found[0])
        if word in words:
            right[span] = word
    return tuple(
        [
            _meant(each, right[each.span]) if each.span in right else each
            for each in program.diagnostics
        ]
    )


def _meant(found: Diagnostic, word: str) -> Diagnostic:
    assert found.span is not None, "a mistake of a line stands in it"
    return found._replace(help=f"did you mean `{word}`?", fix=write(word, found.span))
