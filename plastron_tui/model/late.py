"""Statements that come too late to reach a file."""

from __future__ import annotations

from collections.abc import Iterator

from plastron_tui.diagnostics import Diagnostic, Edit, Fix, Label, Severity, Span
from plastron_tui.language import statements as st
from plastron_tui.language.declaration import Statement
from plastron_tui.language.lowering import Program

from .workspace import Generation, Workspace

_CHANGES = frozenset(
    {
        st.Subscribe,
        st.Unsubscribe,
        st.Publish,
        st.StopPublishing,
        st.ClientRequests,
        st.StopRequest,
        st.ProvidesService,
        st.StopService,
    }
)


def late_changes(program: Program, workspace: Workspace) -> Iterator[Diagnostic]:
    """Yield a warning for each statement that changes a node after it was last generated."""
    last: dict[str, Generation] = {
        generation.node.variable: generation for generation in workspace.generations
    }
    if not last:
        return
    for statement in program.statements:
        if type(statement) not in _CHANGES:
            continue
        variable: str = statement.node  # type: ignore[attr-defined]
        generation = last.get(variable)
        if generation is None or statement.span.start < generation.span.start:
            continue
        fix = None
        if not isinstance(statement, st.Publish) or (
            workspace.messages[statement.message].span.start < generation.span.start
        ):
            fix = _moved(statement, generation)
        yield Diagnostic(
            "changed-after-generating",
            f"this comes after `{variable}` was generated, and is not in its file",
            statement.span,
            help=f"write it before `generate_node {variable}`",
            fix=fix,
            labels=(Label(generation.span, "generated here"),),
            severity=Severity.WARNING,
        )


def _moved(statement: Statement, generation: Generation) -> Fix | None:
    """Return the remedy that writes a statement before its node is generated."""
    text = statement.syntax.text
    if text is None:
        return None
    start = generation.span.start
    before = Edit(Span(start, start), text.decode("utf-8", "replace").strip() + "\n")
    return Fix("write it before that", (before, Edit(statement.span, "")))
