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

from collections.abc import Callable, Mapping, Sequence
from typing import Any, NamedTuple

from plastron_tui.diagnostics import Span
from plastron_tui.model.kinds import EDITABLE, Endpoint, EndpointKind, Message, Publication
from plastron_tui.model.values import MessageValue, Value
from plastron_tui.model.workspace import Node
from plastron_tui.ros.interfaces import InterfaceName
from plastron_tui.ros.names import spelled

from .manifest import Base

_NOWHERE = Span(0, 0)


def remember(node: Node, library: str, program: str) -> Base:
    """Return what the manifest shall remember of a node.

    Args:
        node: the node, as the program has it.
        library: the client library that its file is for.
        program: the name of the program's file, "" where it has none.
    """
    used = {
        kind.value: {name: _remembered(each) for name, each in found.items()}
        for kind, found in node.by_kind.items()
        if found
    }
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
        for kind in EDITABLE:
            for written, data in base.get(kind.value, {}).items():
                name = spelled(written)
                node.put(kind.editing.endpoint(name, _type(data["type"]), **_recalled(kind, data)))
    except (KeyError, TypeError, ValueError, AttributeError, RecursionError, OverflowError):
        return None
    return node


class _Detail(NamedTuple):
    """How a field of an endpoint is written, and read."""

    key: str
    write: Callable[[Any], Any]
    read: Callable[[Any], Any]


def _remembered(endpoint: Endpoint) -> dict[str, Any]:
    given: dict[str, Any] = {"type": None if endpoint.type is None else str(endpoint.type)}
    for field, detail in _DETAILS.items():
        value = getattr(endpoint, field, None)
        if value is not None:
            given[detail.key] = detail.write(value)
    return given


def _recalled(kind: EndpointKind, data: Mapping[str, Any]) -> dict[str, Any]:
    """Return the other fields of an endpoint of a kind."""
    fields = (field for field in kind.editing.endpoint._fields if field in _DETAILS)
    return {field: _DETAILS[field].read(data.get(_DETAILS[field].key)) for field in fields}


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


def _text(value: Any) -> str:
    if not isinstance(value, str):
        raise TypeError
    return value


_DETAILS = {
    "publications": _Detail(
        "sends",
        lambda sent: [_sending(each) for each in sent],
        lambda sent: tuple(_publication(*each) for each in sent),
    ),
    "callback": _Detail("calling", str, lambda name: None if name is None else _text(name)),
    "requests": _Detail(
        "requests",
        lambda sent: [_json(each) for each in sent],
        lambda sent: tuple(_message(each) for each in sent),
    ),
}
"""The fields of endpoints beside name, type and place."""
