"""What `plastron inspect --format json` prints for a file."""

from __future__ import annotations

import math
from typing import Any

from plastron_tui.ros.qos import Qos
from plastron_tui.ros.qos_words import text_of

from .source import EndpointKind, SourceEndpoint, SourceNode, SourceUnit


def inspect_json(source: SourceUnit) -> dict[str, Any]:
    """Describe a file as JSON: one entry for each call site, in the order of the file."""
    return {
        "file": str(source.path),
        "client_library": source.library,
        "nodes": [_node(node) for node in source.nodes],
    }


def _node(node: SourceNode) -> dict[str, Any]:
    return {
        "name": node.name,
        **{kind.value: [_endpoint(found) for found in node.of_kind(kind)] for kind in EndpointKind},
    }


def _endpoint(endpoint: SourceEndpoint) -> dict[str, Any]:
    found: dict[str, Any] = {}
    facts = endpoint.kind.facts
    if facts.named is not None:
        found[facts.named] = endpoint.name
    found["expression"] = endpoint.expression
    if endpoint.default is not None:
        found["default"] = endpoint.default
    if facts.interface is not None:
        found["type"] = str(endpoint.type) if endpoint.type is not None else None
    if facts.calls_back:
        found["callback"] = endpoint.callback
    if endpoint.qos is not None:
        found["qos"] = qos_json(endpoint.qos)
    if endpoint.is_guess:
        found["guess"] = True
    found["line"] = endpoint.line
    if endpoint.file:
        found["file"] = endpoint.file
    return found


def qos_json(qos: Qos) -> dict[str, Any]:
    """Return the policies that are known; a duration without an end is `infinite`."""
    return {
        policy: "infinite" if value == math.inf else value for policy, value in qos.known.items()
    }


def inspect_text(source: SourceUnit) -> str:
    """Describe a file for people: a line for each call site, under its node."""
    lines = [f"{source.path} ({source.library})"]
    for node in source.nodes:
        lines.append(f"  node {node.name or _unknown(node.expression)}")
        rows = [_row(endpoint) for kind in EndpointKind for endpoint in node.of_kind(kind)]
        widths = [max(map(len, column), default=0) for column in zip(*rows, strict=True)]
        lines += ["    " + "  ".join(map(str.ljust, row, widths)).rstrip() for row in rows]
    return "\n".join(lines)


def _row(endpoint: SourceEndpoint) -> tuple[str, str, str, str]:
    type_ = str(endpoint.type) if endpoint.type is not None else endpoint.type_expression
    qos = "" if endpoint.qos is None else text_of(endpoint.qos)
    return (
        f"line {endpoint.line}",
        endpoint.kind.word,
        endpoint.name or _unknown(endpoint.expression),
        type_
        + (f" with qos {qos}" if qos else "")
        + (f" calling {endpoint.callback}" if endpoint.callback else "")
        + (" (a guess)" if endpoint.is_guess else "")
        + (f" in {endpoint.file}" if endpoint.file else ""),
    )


def _unknown(expression: str) -> str:
    return f"({' '.join(expression.split())})" if expression else "(unknown)"
