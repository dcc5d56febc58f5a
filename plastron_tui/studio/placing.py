"""Where a statement goes that is written for somebody: where it takes effect."""

from __future__ import annotations

from typing import TYPE_CHECKING

from plastron_tui.diagnostics import Edit, Span

if TYPE_CHECKING:
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


def is_generated_last(workspace: Workspace, variable: str, text: bytes) -> Span | None:
    """Return the `generate_node` of a node after which nothing is done with it, if there is one."""
    spans = [made.span for made in workspace.generations if made.node.variable == variable]
    if not spans:
        return None
    words = text[spans[-1].end :].replace(b"\n", b" ").split(b" ")
    return None if variable.encode() in words else spans[-1]
