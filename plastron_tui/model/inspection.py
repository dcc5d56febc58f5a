"""What `plastron inspect --format json` prints for a file."""

from __future__ import annotations

from typing import Any

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
    if endpoint.is_guess:
        found["guess"] = True
    found["line"] = endpoint.line
    if endpoint.file:
        found["file"] = endpoint.file
    return found


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
    return (
        f"line {endpoint.line}",
        endpoint.kind.word,
        endpoint.name or _unknown(endpoint.expression),
        type_
        + (f" calling {endpoint.callback}" if endpoint.callback else "")
        + (" (a guess)" if endpoint.is_guess else "")
        + (f" in {endpoint.file}" if endpoint.file else ""),
    )


def _unknown(expression: str) -> str:
    return f"({' '.join(expression.split())})" if expression else "(unknown)"
