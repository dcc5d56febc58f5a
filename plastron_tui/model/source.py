"""What a reader found in a node's source file, and the changes that an editor is asked for."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

from plastron_tui.diagnostics import Span
from plastron_tui.ros.interfaces import InterfaceName

from .endpoints import Client, Publisher, Service, Subscription
from .endpoints import EndpointKind as EndpointKind

LARGEST_FILE = 4 * 1024 * 1024
"""The largest node file that is read, in bytes; a node is a few kilobytes."""


class SourceEndpoint(NamedTuple):
    """One call site.

    Attributes:
        kind: what the call creates.
        name: the topic, service, action or parameter where the source says it literally, else
            None. A timer has none.
        expression: the source text that decides the name (a timer's: its period or rate); where
            a literal default decides it, the text of the whole expression.
        type: the interface, None where the source does not say it.
        type_expression: the source text of the type, "" where there is none.
        callback: the callback's name as the source has it (`on_chatter` for `self.on_chatter`),
            None where there is none or it has no name.
        default: the literal default of a name that is read from a parameter.
        span: the call.
    """

    kind: EndpointKind
    name: str | None
    expression: str
    span: Span
    line: int
    type: InterfaceName | None = None
    type_expression: str = ""
    callback: str | None = None
    default: str | None = None


class SourceNode(NamedTuple):
    """A node of a file: its name, None where the file does not say it, and its call sites."""

    name: str | None
    expression: str
    endpoints: tuple[SourceEndpoint, ...]
    span: Span | None = None

    def of_kind(self, kind: EndpointKind) -> Iterator[SourceEndpoint]:
        """Yield the endpoints of one kind, in the order of the file."""
        return (endpoint for endpoint in self.endpoints if endpoint.kind is kind)


class Origin(NamedTuple):
    """What a program started from, where `SourceFile.text` is not simply a file of the disk.

    Attributes:
        path: the file that the program loaded at first.
        text: what that file holds, or held, without what was changed in the output by hand.
        output: the file that the program wrote; the source has what was changed there by hand.
        start: for a source that the program itself generates: the text that it makes it from.
        is_torn: the file at `path` was changed, and the output has handwork that the program
            has changed since.
        turns: how often the program generated it and loaded that again.
    """

    path: Path
    text: bytes
    output: Path | None = None
    start: bytes | None = None
    is_torn: bool = False
    turns: int = 0


class SourceFile(NamedTuple):
    """A source file, as bytes, with the nodes that it holds.

    `origin` is there where the program itself wrote the file on an earlier run: the text is then
    what it started from, with what was changed by hand since.
    """

    path: Path
    text: bytes
    library: str
    nodes: tuple[SourceNode, ...]
    origin: Origin | None = None

    @property
    def endpoints(self) -> Iterator[SourceEndpoint]:
        """The endpoints of all its nodes, in the order of the file."""
        return (endpoint for node in self.nodes for endpoint in node.endpoints)


class Add(NamedTuple):
    """Ask an editor for an endpoint that is not in the file yet."""

    endpoint: Publisher | Subscription | Service | Client


class Remove(NamedTuple):
    """Ask an editor to take every call site of an endpoint out of the file."""

    kind: EndpointKind
    name: str
    span: Span | None = None
    """The statement that asked, for a refusal to point at."""


Change = Add | Remove
