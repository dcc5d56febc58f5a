"""The graph as JSON, for other programs."""

from __future__ import annotations

import json
from collections.abc import Mapping
from typing import Any

from plastron_tui.diagnostics import Span
from plastron_tui.model.graph import KINDS_AT, NOUNS, End, Graph, GraphNode, GraphRobot, Hub
from plastron_tui.model.inspection import qos_json
from plastron_tui.model.kinds import (
    ActionClient,
    ActionServer,
    Client,
    Publisher,
    Service,
    callback_of,
)
from plastron_tui.model.robot_inspection import parts_json
from plastron_tui.model.values import Computed, MessageValue, Value
from plastron_tui.ros.interfaces import InterfaceName


def render(graph: Graph) -> str:
    """Return one object, to which keys are only ever added.

    Its shape::

        {"nodes": [{"name", "variable", "library", "file", "generated", "span"}],
         "topics": [{"name", "type", "types", "missing",
           "publishers": [{"node", "variable", "written", "type", "span",
             "messages": [{"message", "rate", "pace", "span"}]}],
           "subscribers": [{"node", "variable", "written", "type", "span", "callback"}]}],
         "services": [{"name", "type", "types", "missing",
           "providers": [{"node", "variable", "written", "type", "span", "handler"}],
           "clients": [{"node", "variable", "written", "type", "span", "requests", "rates"}]}],
         "actions": [{"name", "type", "types", "missing",
           "action_servers": [{"node", "variable", "written", "type", "span", "handler"}],
           "action_clients": [{"node", "variable", "written", "type", "span", "goals"}]}],
         "robots": [{"name", "variable", "file", "generated", "span", "root", "links", "joints",
           "materials"}]}

    A `name` of a topic, service or action is its full name, `written` what the program says;
    `node` is a node's name, in a namespace its full one, and `variable` tells two of one name
    apart. `type` is `package/Name` or null, `types` all that are in use. `missing` is the side
    that nobody takes (`publisher`, `subscriber`, `provider`, `client`, …), or null. `managed`
    is there, and true, for a lifecycle node. `rate` is in hertz, 0 for a message without a rate
    of its own; `pace` says in words when it is sent. `rates` has the rate of each request in
    hertz, null for one that is made once. A `span` is `[start, end]` in
    bytes of the program, null for what was read from a file. `guess` is there, and true, where
    the name or the type that a file has is no more than likely. `qos` is there where something
    is known of the quality of service: its policies by name, those that are known; durations in
    seconds, or `infinite`. A request is an object of its fields; what is not there keeps its
    default. `library`, `file`, `callback` and `handler` are null where the program does not
    say. The parts of robots are as `plastron inspect` has them, in metres, kilograms and radians;
    `macros` is there, and true, where its file has macros that are not expanded.
    """
    document = {
        "nodes": [_node(node) for node in graph.nodes],
        **{f"{NOUNS[at]}s": [_hub(hub) for hub in hubs] for at, hubs in graph.at.items()},
        "robots": [_robot(robot) for robot in graph.robots],
    }
    return json.dumps(document, indent=2) + "\n"


def _node(node: GraphNode) -> dict[str, Any]:
    return {
        "name": node.name,
        "variable": node.variable,
        "library": node.library,
        "file": None if node.file is None else str(node.file),
        "generated": node.is_generated,
        "span": _span(node.span),
        **({"managed": True} if node.is_managed else {}),
    }


def _robot(robot: GraphRobot) -> dict[str, Any]:
    return {
        "name": robot.name,
        "variable": robot.variable,
        "file": None if robot.file is None else str(robot.file),
        "generated": robot.is_generated,
        "span": _span(robot.span),
        **({"macros": True} if robot.has_macros else {}),
        **parts_json(robot.description),
    }


def _hub(hub: Hub) -> dict[str, Any]:
    return {
        "name": hub.name,
        "type": _type(hub.type),
        "types": [str(type_) for type_ in hub.types],
        "missing": None if hub.missing is None else hub.missing.facts.role,
        **{
            f"{kind.facts.role}s".replace(" ", "_"): [_end(end) for end in hub.of(kind)]
            for kind in KINDS_AT[hub.interface]
        },
    }


def _end(end: End) -> dict[str, Any]:
    return {
        "node": end.node.name,
        "variable": end.node.variable,
        "written": end.written,
        "type": _type(end.type),
        "span": _span(end.span),
        **({"guess": True} if end.is_guess else {}),
        **({} if end.qos is None else {"qos": qos_json(end.qos)}),
        **_details(end),
    }


def _details(end: End) -> dict[str, Any]:
    match end.endpoint:
        case Publisher():
            return {
                "messages": [
                    {
                        "message": sent.message,
                        "rate": sent.rate,
                        "pace": sent.pace,
                        "span": _span(sent.span),
                    }
                    for sent in end.sendings
                ]
            }
        case Client(requests=requests):
            return {
                "requests": [_value(request.value) for request in requests],
                "rates": [None if each.rate is None else each.rate.hertz for each in requests],
            }
        case ActionClient(goals=goals):
            return {"goals": [_value(goal) for goal in goals]}
        case Service(callback=callback) | ActionServer(callback=callback):
            return {"handler": callback}
        case calling:
            return {"callback": callback_of(calling)}


def _type(type_: InterfaceName | None) -> str | None:
    return None if type_ is None else str(type_)


def _span(span: Span | None) -> list[int] | None:
    return None if span is None else [span.start, span.end]


def _value(value: Value) -> Any:
    match value:
        case MessageValue(fields=fields):
            return _fields(fields)
        case Computed():
            return str(value)
        case tuple():
            return [_value(each) for each in value]
        case float() if value != value or value in (float("inf"), float("-inf")):
            # JSON has no word for these.
            return str(value)
        case _:
            return value


def _fields(fields: Mapping[str, Value]) -> dict[str, Any]:
    return {name: _value(value) for name, value in fields.items()}
