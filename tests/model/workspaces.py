"""Running programs without a disk."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from pathlib import Path

from file_sets import one

from plastron_tui.diagnostics import Diagnostic, Span
from plastron_tui.diagnostics.codes import FILE_NOT_FOUND
from plastron_tui.language import Document, lower
from plastron_tui.model.context import Loaded, LoadRequest, Setting
from plastron_tui.model.interpreter import Interpretation, interpret
from plastron_tui.model.source import EndpointKind, SourceEndpoint, SourceNode, SourceUnit
from plastron_tui.model.workspace import Workspace
from plastron_tui.ros.catalog import Catalog
from plastron_tui.ros.interfaces import InterfaceName
from plastron_tui.targets import LIBRARIES as LIBRARIES

NODE = "create_node 'talker' as n\n"
MESSAGE = 'create_message m of message_type String and input "hi"\n'
TALKER = NODE + MESSAGE + "n publish m to 'chatter' of message_type String\n"


@cache
def catalog(ros_version: int) -> Catalog:
    return Catalog({1: "noetic", 2: "jazzy"}[ros_version])


class FakeReader:
    """Reads files from a dictionary, and remembers what was asked for."""

    def __init__(self, files: Mapping[str, SourceUnit] | None = None) -> None:
        self.files = files or {}
        self.requests: list[LoadRequest] = []

    def __call__(self, request: LoadRequest) -> Loaded:
        self.requests.append(request)
        found = self.files.get(request.source)
        if found is not None:
            return Loaded(found)
        return Loaded(None, (Diagnostic(FILE_NOT_FOUND, f"no file `{request.source}`"),))


def endpoint(
    kind: EndpointKind, name: str | None, type_: str | None = None, callback: str | None = None
) -> SourceEndpoint:
    interface = None if type_ is None else InterfaceName(*type_.split("/"))
    return SourceEndpoint(kind, name, repr(name), Span(0, 1), 1, interface, callback=callback)


def source(
    *endpoints: SourceEndpoint, name: str | None = "driver", library: str = "rospy"
) -> SourceUnit:
    nodes = (SourceNode(name, repr(name), endpoints),)
    return SourceUnit(Path("driver.py"), one(b""), library, nodes)


def run(
    text: str, library: str = "rospy", reader: FakeReader | None = None, program: str = ""
) -> Interpretation:
    setting = Setting(library, LIBRARIES, catalog, reader or FakeReader(), program=program)
    return interpret(lower(Document(text.encode())), setting)


def workspace(text: str, library: str = "rospy", reader: FakeReader | None = None) -> Workspace:
    """Run a program that has no mistakes."""
    found = run(text, library, reader)
    assert found.diagnostics == ()
    return found.workspace


def codes(text: str, library: str = "rospy", reader: FakeReader | None = None) -> list[str]:
    return [found.code for found in run(text, library, reader).diagnostics]


def marked(text: str, found: Diagnostic) -> str:
    """Return the text that a diagnostic is about."""
    assert found.span is not None
    return text.encode()[found.span.start : found.span.end].decode()
