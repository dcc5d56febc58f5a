"""What `plastron inspect --format json` prints for a file."""

from __future__ import annotations

import json
import math
from collections.abc import Iterator
from pathlib import PurePosixPath
from typing import Any

from plastron_tui.ros.qos import Qos
from plastron_tui.ros.qos_words import text_of

from .endpoint_details import ActionDetails, EndpointDetails, ParameterDetails, TimerDetails, Value
from .source import EndpointKind, SourceEndpoint, SourceNode, SourceUnit, place_of


def inspect_json(source: SourceUnit) -> dict[str, Any]:
    """Describe a file as JSON: one entry for each call site, in the order of the file."""
    return {
        "file": str(source.path),
        "client_library": source.library,
        "nodes": [_node(node, source) for node in source.nodes],
    }


def _node(node: SourceNode, source: SourceUnit) -> dict[str, Any]:
    return {
        "name": node.name,
        **({"managed": True} if node.is_managed else {}),
        **{
            kind.value: [_endpoint(found, source) for found in node.of_kind(kind)]
            for kind in EndpointKind
        },
    }


def _endpoint(endpoint: SourceEndpoint, source: SourceUnit) -> dict[str, Any]:
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
    match endpoint.details:
        case ParameterDetails() as parameter:
            found |= _parameter(parameter)
        case TimerDetails(period, is_oneshot, is_guess):
            found["period"] = period
            found |= {"oneshot": True} if is_oneshot else {}
            found |= {"period_guess": True} if is_guess else {}
        case ActionDetails() as callbacks:
            found |= {f"{key}_callback": name for key, name in _given(callbacks)}
    if endpoint.transition is not None:
        found["transition"] = endpoint.transition
    if endpoint.is_guess:
        found["guess"] = True
    found["line"] = endpoint.line
    if endpoint.file:
        found["file"] = _file(endpoint, source)
    return found


def qos_json(qos: Qos) -> dict[str, Any]:
    """Return the policies that are known; a duration without an end is `infinite`."""
    return {
        policy: "infinite" if value == math.inf else value for policy, value in qos.known.items()
    }


def _parameter(details: ParameterDetails) -> dict[str, Any]:
    found: dict[str, Any] = {}
    if details.type is not None:
        found["parameter_type"] = details.type
    if details.default_expression:
        found["default_expression"] = details.default_expression
    if details.default is not None:
        found["default_value"] = _plain(details.default)
    if details.is_guess:
        found["default_guess"] = True
    if details.range is not None:
        low, high, step = details.range
        found["range"] = {"from": low, "to": high, **({"step": step} if step else {})}
    if details.description is not None:
        found["description"] = details.description
    if details.is_read_only:
        found["read_only"] = True
    return found


def _plain(value: Value) -> Any:
    """Return a value as JSON has it, where a list is no tuple."""
    return [_plain(each) for each in value] if isinstance(value, tuple) else value


def _given(callbacks: ActionDetails) -> list[tuple[str, str]]:
    return [(key, name) for key, name in callbacks._asdict().items() if name is not None]


def inspect_text(source: SourceUnit) -> str:
    """Describe a file for people: a line for each call site, under its node."""
    lines = [f"{source.path} ({source.library})"]
    for node in source.nodes:
        managed = " (managed)" if node.is_managed else ""
        lines.append(f"  node {node.name or _unknown(node.expression)}{managed}")
        rows = [_row(endpoint, source) for kind in EndpointKind for endpoint in node.of_kind(kind)]
        widths = [max(map(len, column), default=0) for column in zip(*rows, strict=True)]
        lines += ["    " + "  ".join(map(str.ljust, row, widths)).rstrip() for row in rows]
    return "\n".join(lines)


def _file(endpoint: SourceEndpoint, source: SourceUnit) -> str:
    """Return the file that has a call site, from the folder of the main file."""
    return place_of(PurePosixPath(source.path.name), endpoint.file).as_posix()


def _row(endpoint: SourceEndpoint, source: SourceUnit) -> tuple[str, str, str, str]:
    type_ = str(endpoint.type) if endpoint.type is not None else endpoint.type_expression
    qos = "" if endpoint.qos is None else text_of(endpoint.qos)
    told = [
        type_,
        f"with qos {qos}" if qos else "",
        f"calling {endpoint.callback}" if endpoint.callback else "",
        *_told(endpoint.details),
        f"made in {endpoint.transition}" if endpoint.transition else "",
        "(a guess)" if endpoint.is_guess else "",
        f"in {_file(endpoint, source)}" if endpoint.file else "",
    ]
    return (
        f"line {endpoint.line}",
        endpoint.kind.word,
        endpoint.name or _unknown(endpoint.expression),
        " ".join(filter(None, told)),
    )


def _told(details: EndpointDetails | None) -> Iterator[str]:
    """Yield what is said of an endpoint of one kind, for people."""
    match details:
        case ParameterDetails(type_, default, expression, range_):
            yield type_ or ""
            if expression:
                value = " ".join(expression.split()) if default is None else json.dumps(default)
                yield f"= {value}"
            yield "(a guess)" if details.is_guess else ""
            if range_ is not None:
                yield f"from {range_.low} to {range_.high}"
                yield f"by {range_.step}" if range_.step else ""
            yield "(read only)" if details.is_read_only else ""
            yield f"({details.description})" if details.description else ""
        case TimerDetails(period, is_oneshot, is_guess):
            if period is not None:
                yield f"{'after' if is_oneshot else 'every'} {period:g} s"
            yield "(a guess)" if is_guess else ""
        case ActionDetails():
            for key, name in _given(details):
                yield f"{key} {name}"


def _unknown(expression: str) -> str:
    return f"({' '.join(expression.split())})" if expression else "(unknown)"
