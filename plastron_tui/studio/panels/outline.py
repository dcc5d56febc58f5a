"""From an analysis to the entries of the panels. Pure: it runs in the worker."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from functools import lru_cache
from pathlib import Path

from plastron_tui.diagnostics import Diagnostic, LineIndex, Severity
from plastron_tui.model.graph import Graph, Hub
from plastron_tui.model.kinds import EDITABLE, EndpointKind, Message
from plastron_tui.model.values import MessageValue
from plastron_tui.model.workspace import Node, Workspace
from plastron_tui.ros.interfaces import InterfaceName

from .entry import Entries, Entry, Subject

SIGNS: dict[Subject | EndpointKind, tuple[str, str]] = {
    Subject.NODE: ("●", "primary"),
    Subject.TOPIC: ("≈", "success"),
    Subject.SERVICE_NAME: ("◆", "warning"),
    Subject.MESSAGE: ("✉", "accent"),
    **{kind: (kind.facts.sign, kind.facts.tone) for kind in EDITABLE},
}
"""What each subject has before it, and in which tone."""


def node_entries(workspace: Workspace, libraries: dict[str, str | None]) -> Entries:
    """Return the nodes, each with its endpoints.

    `libraries` has the client library of each node by its variable.
    """
    return Entries(_nodes(workspace, libraries), "no nodes yet\ncreate_node 'talker' as talker")


def _nodes(workspace: Workspace, libraries: dict[str, str | None]) -> Iterator[Entry]:
    for variable, node in workspace.nodes.items():
        library = libraries.get(variable)
        from_file = node.source.path.name if node.source is not None else None
        parts = [part for part in (from_file or library,) if part]
        if variable != node.name:
            parts.insert(0, variable)
        yield Entry(
            f"node {variable}",
            node.name,
            " · ".join(parts),
            *SIGNS[Subject.NODE],
            warning="does nothing" if node.is_idle else "",
            span=node.span,
            subject=Subject.NODE,
            node=variable,
            name=variable,
            is_branch=not node.is_idle,
        )
        yield from _endpoints(variable, node)


def _endpoints(variable: str, node: Node) -> Iterator[Entry]:
    for kind, endpoints in node.by_kind.items():
        word, (sign, tone) = kind.word, SIGNS[kind]
        for name, endpoint in endpoints.items():
            # In order and not by name: there may be thousands, and all are made at every key.
            yield Entry(
                f"{word} {variable} {name}",
                name,
                _type(endpoint.type),
                sign,
                tone,
                "",
                1,
                endpoint.span,
                kind,
                variable,
                name,
            )


def topic_entries(graph: Graph) -> Entries:
    """Return the topics, each with who speaks and who listens."""
    found = (entry for hub in graph.topics for entry in _hub(hub, Subject.TOPIC))
    return Entries(found, "no topics yet\ntalker publish … to 'chatter' …")


def service_entries(graph: Graph) -> Entries:
    """Return the services, each with who provides it and who calls it."""
    found = (entry for hub in graph.services for entry in _hub(hub, Subject.SERVICE_NAME))
    return Entries(found, "no services yet\nadder provides_service 'add' …")


def _hub(hub: Hub, subject: Subject) -> Iterator[Entry]:
    yield Entry(
        f"{subject.value} {hub.name}",
        hub.name,
        " or ".join(map(_type, hub.types)),
        *SIGNS[subject],
        warning="" if hub.missing is None else f"nobody {hub.missing.facts.does}",
        span=next((end.span for end in hub.ends if end.span is not None), None),
        subject=subject,
        name=hub.name,
        is_branch=True,
    )
    for end in hub.ends:
        yield Entry(
            f"{end.kind.word} {end.node.variable} {end.written}",
            end.node.name,
            end.kind.word,
            *SIGNS[end.kind],
            depth=1,
            span=end.span,
            subject=end.kind,
            node=end.node.variable,
            name=end.written,
        )


def message_entries(messages: dict[str, Message], used: dict[str, list[str]]) -> Entries:
    """Return the messages, each with its values; `used` has the topics that each goes to."""

    def all_() -> Iterator[Entry]:
        for variable, message in messages.items():
            fields = list(message_fields(message.value))
            yield Entry(
                f"message {variable}",
                variable,
                _type(message.value.type),
                *SIGNS[Subject.MESSAGE],
                warning="" if variable in used else "not sent",
                span=message.span,
                subject=Subject.MESSAGE,
                name=variable,
                is_branch=bool(fields),
            )
            for name, value in fields:
                key = f"field {variable} {name}"
                yield Entry(key, f"{name} = {value}", depth=1, name=variable)

    return Entries(all_(), "no messages yet\ncreate_message hello of message_type String …")


def problem_entries(
    diagnostics: Sequence[Diagnostic], lines: Callable[[Path | None], LineIndex | None]
) -> Entries:
    """Return what is wrong, in the order of the program."""
    in_order = sorted(diagnostics, key=lambda found: (found.file is not None, found.span or (0, 0)))
    return Entries((entry for found in in_order for entry in _problem(found, lines)), "no problems")


def _problem(
    found: Diagnostic, lines: Callable[[Path | None], LineIndex | None]
) -> Iterator[Entry]:
    is_error = found.severity is Severity.ERROR
    index = None if found.span is None else lines(found.file)
    where = found.file.name if found.file is not None else ""
    if index is not None and found.span is not None:
        where += f":{index.position(found.span.start).line}" if where else ""
        where = where or f"line {index.position(found.span.start).line}"
    own = found.file is None
    key = f"problem {found.code} {found.message}"
    yield Entry(
        key,
        found.message,
        " · ".join(part for part in (where, found.code) if part),
        "✖" if is_error else "▲",
        "error" if is_error else "warning",
        span=found.span if own else None,
        subject=Subject.PROBLEM,
        name=None if own else where,
        edits=found.fix.edits if found.fix is not None and own else (),
        warning=found.fix.title if found.fix is not None and own else "",
        is_branch=found.help is not None,
    )
    if found.help is not None:
        span = found.span if own else None
        yield Entry(
            f"help {key}",
            found.help,
            sign="=",
            depth=1,
            span=span,
            subject=Subject.PROBLEM,
            name=None if own else where,
        )


@lru_cache(4096)
def _type(type_: InterfaceName | None) -> str:
    return "type unknown" if type_ is None else str(type_)


def libraries_of(workspace: Workspace, default: str) -> dict[str, str | None]:
    """Return the client library of each node by its variable; None where only its file says it."""
    generated = {made.node.variable: made.library for made in workspace.generations}
    return {
        variable: node.library
        or generated.get(variable)
        or (default if node.source is None else None)
        for variable, node in workspace.nodes.items()
    }


def message_fields(value: MessageValue, before: str = "") -> Iterator[tuple[str, str]]:
    """Yield the fields that have a value, nested ones by their dotted names."""
    for name, inner in value.fields.items():
        if isinstance(inner, MessageValue):
            yield from message_fields(inner, f"{before}{name}.")
        else:
            yield before + name, _shown(inner)


def _shown(value: object) -> str:
    if isinstance(value, tuple):
        return "[" + ", ".join(map(_shown, value)) + "]"
    return f'"{value}"' if isinstance(value, str) else str(value)
