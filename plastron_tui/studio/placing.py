"""Where a statement goes that is written for somebody: where it takes effect."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from plastron_tui.diagnostics import Edit, Span
from plastron_tui.language.declaration import DECLARATIONS, SlotKind, Statement

if TYPE_CHECKING:
    from plastron_tui.language import Program
    from plastron_tui.model.workspace import Workspace


def placed(
    text: bytes,
    workspace: Workspace,
    variable: str | None,
    statement: str,
    after: Span | None = None,
) -> Edit:
    """Return the edit that writes a statement.

    Args:
        text: the program.
        workspace: what the program builds.
        variable: the node that the statement changes: it goes before that node is generated
            last; None puts it at the end.
        statement: the statement, or several lines of them.
        after: what the statement has to follow.
    """
    spans = [made.span for made in workspace.generations if made.node.variable == variable]
    if spans and (after is None or after.end <= spans[-1].start):
        line = text.rfind(b"\n", 0, spans[-1].start) + 1
        return Edit(Span(line, line), f"{statement}\n")
    end = len(text.rstrip())
    before = "\n" if end else ""
    behind = "" if b"\n" in text[end:] else "\n"
    return Edit(Span(end, end), f"{before}{statement}{behind}")


def is_generated_last(program: Program, workspace: Workspace, variable: str) -> Span | None:
    """Return the `generate_node` of a node after which nothing is done with it, if there is one."""
    spans = [made.span for made in workspace.generations if made.node.variable == variable]
    if not spans:
        return None
    end = spans[-1].end
    later = (statement for statement in program.statements if statement.span.start >= end)
    return None if any(names_node(each, variable) for each in later) else spans[-1]


def names_node(statement: Statement, variable: str) -> bool:
    """Tell whether a slot of a statement names a node."""
    type_: Any = type(statement)  # which mypy takes for not hashable
    return any(
        slot.kind is SlotKind.NODE and getattr(statement, slot.name) == variable
        for slot in DECLARATIONS[type_].slots
    )
