"""What the manifest remembers of a created node: its endpoints, as JSON, and back.

    {"node": "talker", "library": "rospy", "program": "robot.plastron",
     "publishers": {"chatter": {"type": "std_msgs/String",
                                "sends": [[10.0, {"std_msgs/String": {"data": "hello"}}]]}},
     "subscriptions": {"x": {"type": "std_msgs/Int32", "calling": "on_x"}},
     "services": {"reset": {"type": "std_srvs/Empty"}},
     "clients": {"stop": {"type": "std_srvs/SetBool", "requests": [{"std_srvs/SetBool": {}}]}}}

Of a file that holds several nodes the first that a program loaded is remembered like this, and the
others in the list `others`; `label` is what each is called in the file.

A message is an object of one key, its type; all other values are JSON's own.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from plastron_tui.diagnostics import Span
from plastron_tui.model.values import MessageValue, Value
from plastron_tui.model.workspace import (
    Client,
    Message,
    Node,
    Publication,
    Publisher,
    Service,
    Subscription,
)
from plastron_tui.ros.interfaces import InterfaceName

from .manifest import Base

_NOWHERE = Span(0, 0)


def remember(node: Node, library: str, program: str) -> Base:
    """Return what the manifest shall remember of a node.

    Args:
        node: the node, as the program has it.
        library: the client library that its file is for.
        program: the name of the program's file, "" where it has none.
    """
    kinds: dict[str, dict[str, Any]] = {
        "publishers": {
            each.topic: _endpoint(each.type, sends=[_sending(sent) for sent in each.publications])
            for each in node.publishers.values()
        },
        "subscriptions": {
            each.topic: _endpoint(each.type, calling=each.callback)
            for each in node.subscriptions.values()
        },
        "services": {
            each.name: _endpoint(each.type, calling=each.handler) for each in node.services.values()
        },
        "clients": {
            each.name: _endpoint(each.type, requests=[_json(sent) for sent in each.requests])
            for each in node.clients.values()
        },
    }
    used = {kind: endpoints for kind, endpoints in kinds.items() if endpoints}
    label = None if node.source is None else node.source.label
    named = {} if label is None else {"label": label}
    return {"node": node.name, **named, "library": library, "program": program, **used}


def remember_all(nodes: Sequence[Node], library: str, program: str) -> Base:
    """Return what the manifest shall remember of the nodes of one file."""
    first, *others = (remember(node, library, program) for node in nodes)
    return {**first, "others": others} if others else first


def recall(base: Base, label: str | None = None) -> Node | None:
    """Return the node that a base tells of, None when someone has broken it.

    Args:
        base: what the manifest has.
        label: what the node is called in a file that holds several.
    """
    if label is not None and base.get("label") != label:
        others = base.get("others")
        found = others if isinstance(others, list) else ()
        named = (each for each in found if isinstance(each, dict) and each.get("label") == label)
        other = next(named, None)
        return None if other is None else recall(other, label)
    try:
        node = Node(_text(base["node"]), "", _NOWHERE, _text(base["library"]))
        for name, data in base.get("publishers", {}).items():
            sends = tuple(_publication(*sent) for sent in data["sends"])
            node.publishers[name] = Publisher(name, _type(data["type"]), sends)
        for name, data in base.get("subscriptions", {}).items():
            node.subscriptions[name] = Subscription(name, _type(data["type"]), _calling(data))
        for name, data in base.get("services", {}).items():
            node.services[name] = Service(name, _type(data["type"]), _calling(data))
        for name, data in base.get("clients", {}).items():
            requests = tuple(_message(sent) for sent in data["requests"])
            node.clients[name] = Client(name, _type(data["type"]), requests)
    except (KeyError, TypeError, ValueError, AttributeError, RecursionError, OverflowError):
        return None
    return node


def _endpoint(type_: InterfaceName | None, **details: Any) -> dict[str, Any]:
    given = {name: value for name, value in details.items() if value is not None}
    return {"type": None if type_ is None else str(type_), **given}


def _sending(publication: Publication) -> list[Any]:
    return [publication.rate, _json(publication.message.value)]


def _json(value: Value) -> Any:
    if isinstance(value, MessageValue):
        return {str(value.type): {name: _json(each) for name, each in value.fields.items()}}
    if isinstance(value, tuple):
        return [_json(each) for each in value]
    return value


def _publication(rate: Any, value: Any) -> Publication:
    if not isinstance(rate, (int, float)) or rate <= 0:
        raise ValueError
    return Publication(Message("", _message(value), _NOWHERE), float(rate))


def _message(value: Any) -> MessageValue:
    found = _value(value)
    if not isinstance(found, MessageValue):
        raise TypeError
    return found


def _value(value: Any) -> Value:
    if isinstance(value, dict):
        ((type_, fields),) = value.items()
        name = _type(type_)
        if name is None:
            raise ValueError
        return MessageValue(name, {field: _value(each) for field, each in fields.items()})
    if isinstance(value, list):
        return tuple(_value(each) for each in value)
    if not isinstance(value, (bool, int, float, str)):
        raise TypeError
    return value


def _type(text: Any) -> InterfaceName | None:
    if text is None:
        return None
    package, name = _text(text).split("/")
    return InterfaceName(package, name)


def _calling(data: Mapping[str, Any]) -> str | None:
    name = data.get("calling")
    return None if name is None else _text(name)


def _text(value: Any) -> str:
    if not isinstance(value, str):
        raise TypeError
    return value
