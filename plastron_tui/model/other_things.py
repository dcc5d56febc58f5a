"""A variable that stands for another thing than the one that a statement is about."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

from plastron_tui.diagnostics import Fix, Span, write
from plastron_tui.language import DECLARATIONS, Statement

if TYPE_CHECKING:
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
