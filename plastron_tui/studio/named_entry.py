"""What a name in the text is about, as an entry of a panel: the same can be done with it."""

from __future__ import annotations

from bisect import bisect_right

from plastron_tui.language import Document, Program
from plastron_tui.language.declaration import Statement
from plastron_tui.language.statements import CreateMessage, Publish, Rename
from plastron_tui.model.kinds import EndpointKind

from .editor.name_uses import function_at, name_at
from .panels.entry import Entry, Subject

_SUBJECTS: dict[str, Subject | EndpointKind] = {
    "topic": Subject.TOPIC,
    "service": Subject.SERVICE_NAME,
    "action": Subject.ACTION_NAME,
    "parameter": EndpointKind.PARAMETER,
}
"""What an entry is about, by the words of the language for what has a name."""


def named_entry(document: Document, program: Program, offset: int) -> Entry | str | None:
    """Return what the name at an offset is about.

    Returns:
        An entry, why the name cannot be another one, or None where no name is.
    """
    statement = _statement_at(program, offset)
    function = function_at(document, offset)
    if function is not None:
        node = getattr(statement, "node", None)
        return Entry("", function, subject=Subject.FUNCTION, node=node, name=function)
    name = name_at(document, offset)
    if name is None:
        return None
    if isinstance(statement, Rename) and offset <= statement.span_of("old").end:
        return f"`{name.text}` is the name in the file of `{statement.node}`"
    owner = name.owner
    if name.what == "parameter" and isinstance(statement, CreateMessage):
        owner = _sender(program, statement.variable)
        if not owner:
            return f"no node sends `{statement.variable}` yet, so the parameter is nobody's"
    return Entry("", name.text, subject=_SUBJECTS[name.what], node=owner or None, name=name.text)


def _statement_at(program: Program, offset: int) -> Statement | None:
    at = bisect_right(program.statements, offset, key=lambda each: each.span.start) - 1
    found = program.statements[at] if at >= 0 else None
    return found if found is not None and offset <= found.span.end else None


def _sender(program: Program, message: str) -> str:
    """Return the variable of a node that sends a message, "" where none does."""
    sending = (each for each in program.statements if isinstance(each, Publish))
    return next((each.node for each in sending if each.message == message), "")
