"""A file's nodes, written as a program that generates equivalent ones."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator

from plastron_tui.language.declaration import DECLARATIONS, SlotKind
from plastron_tui.language.keywords import KEYWORDS
from plastron_tui.language.sentence import sentence
from plastron_tui.language.statements import CreateMessage
from plastron_tui.ros.interfaces import InterfaceName
from plastron_tui.ros.names import (
    check_node_name,
    mended_node_name,
)

from .source import EndpointKind, SourceEndpoint, SourceNode, SourceUnit
from .unique_names import numbered


class Variables:
    """Hands out variables for the things of a program, each only once."""

    def __init__(self) -> None:
        self._taken: set[str] = set(KEYWORDS)

    def new(self, name: str) -> str:
        """Return a variable that is made from a name and not in use."""
        base = re.sub(r"[^A-Za-z0-9_]+", "_", name).strip("_")
        if not base[:1].isalpha() or not base.isascii():
            base = f"node_{base}".rstrip("_")
        variable = next(name for name in numbered(base) if name not in self._taken)
        self._taken.add(variable)
        return variable


def program_of(source: SourceUnit, ros_version: int) -> str:
    """Return a program of the nodes of a file.

    Every endpoint whose name and type are known is a statement; what has no statement is a
    comment.
    """
    variables = Variables()
    nodes = source.nodes or ()
    blocks = [_node(source, node, variables, ros_version) for node in nodes]
    return "\n".join("\n".join(block) + "\n" for block in blocks)


def _node(
    source: SourceUnit, node: SourceNode, variables: Variables, ros_version: int
) -> Iterator[str]:
    name = node.name
    if name is None or check_node_name(name, ros_version) is not None:
        told = f": {_shown(node.expression)}" if node.expression else ""
        yield f"// the file does not say the node's name{told}"
        stem = source.path.stem
        name = stem if check_node_name(stem, ros_version) is None else mended_node_name(stem, 1)
        name = name or "node"
    variable = variables.new(name)
    managed = " managed" if node.is_managed else ""
    yield f"create_node '{name}' as {variable}{managed} using {source.library}"
    seen: set[tuple[EndpointKind, str]] = set()
    for endpoint in node.endpoints:
        statement = _statement(endpoint, variable, variables, ros_version)
        key = (endpoint.kind, endpoint.name or "")
        if statement is None:
            yield _comment(endpoint)
        elif key in seen:
            yield f"{_comment(endpoint)}, once more"
        else:
            seen.add(key)
            yield from statement
    if seen:
        yield f"generate_node {variable}"


def _statement(
    endpoint: SourceEndpoint, node: str, variables: Variables, ros_version: int
) -> tuple[str, ...] | None:
    """Return the statements that make an endpoint, None when the language has none for it."""
    name, type_ = endpoint.name, endpoint.type
    if name is None or type_ is None:
        return None
    if endpoint.kind.facts.check_name(name, ros_version) is not None:
        return None
    stem = f"{name.strip('/~').replace('/', '_')}_message"
    call = _calling(endpoint)
    return endpoint_statements(endpoint.kind, node, name, type_, lambda: variables.new(stem), call)


def endpoint_statements(
    kind: EndpointKind,
    node: str,
    name: str,
    type_: InterfaceName,
    new_message: Callable[[], str],
    calling: str = "",
) -> tuple[str, ...] | None:
    """Return the statements that give a node an endpoint, None when the language has none.

    Args:
        kind: what it is.
        node: the node's variable.
        name: its topic or service.
        type_: its type.
        new_message: makes a variable for a message, where one is needed.
        calling: the function that is called, "" for one that is made.
    """
    editing = kind.facts.editing
    if editing is None:
        return None
    texts = {"node": node, editing.name_slot: name, "type": str(type_), "input": "none"}
    if calling:
        texts["function"] = calling
    if any(slot.kind is SlotKind.MESSAGE for slot in editing.making.slots):
        texts["message"] = new_message()
        message = {"variable": texts["message"], "type": str(type_), "input": "none"}
        made = sentence(DECLARATIONS[CreateMessage], message)
        return (made, sentence(editing.making, texts))
    return (sentence(editing.making, texts),)


def _calling(endpoint: SourceEndpoint) -> str:
    callback = endpoint.callback
    if callback is None or not callback.isidentifier() or not callback.isascii():
        return ""
    if callback in KEYWORDS:
        return ""
    return callback


def _comment(endpoint: SourceEndpoint) -> str:
    what = f"// line {endpoint.line}: {endpoint.kind.facts.verb} {_shown(endpoint.expression)}"
    if endpoint.type is not None:
        what += f" of type {endpoint.type}"
    elif endpoint.type_expression:
        what += f" of type {_shown(endpoint.type_expression)}"
    return what


def _shown(expression: str) -> str:
    text = " ".join(expression.split())
    return text if len(text) <= 80 else f"{text[:77]}..."
