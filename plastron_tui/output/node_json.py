"""What the manifest remembers of a created node: its endpoints, as JSON, and back.

    {"node": "talker", "library": "rospy", "program": "robot.plastron",
     "publishers": {"chatter": {"type": "std_msgs/String",
                                "sends": [[10.0, {"std_msgs/String": {"data": "hello"}}]]}},
     "subscriptions": {"x": {"type": "std_msgs/Int32", "calling": "on_x", "qos": {"depth": 1}}},
     "services": {"reset": {"type": "std_srvs/Empty"}},
     "clients": {"stop": {"type": "std_srvs/SetBool", "requests": [{"std_srvs/SetBool": {}}]}},
     "timers": {"blink": {"type": null, "rate": 2.0}},
     "parameters": {"rate": {"type": null, "holds": "float", "default": 10.0}}}

Of a file that holds several nodes the first that a program loaded is remembered like this, and the
others in the list `others`; `label` is what each is called in the file. `managed` is there, and
true, for a lifecycle node.

What is sent at another time than at a fixed rate has an object behind its message that says when;
a rate that a parameter says is a list of its default and its name. Values are as `value_json` has
them.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from typing import Any, NamedTuple

from plastron_tui.diagnostics import Span
from plastron_tui.model.inspection import qos_json
from plastron_tui.model.kinds import (
    EDITABLE,
    Condition,
    Endpoint,
    EndpointKind,
    Message,
    Publication,
    Rate,
    Reaction,
    Request,
)
from plastron_tui.model.values import OfReceived
from plastron_tui.model.workspace import Node
from plastron_tui.ros.names import spelled
from plastron_tui.ros.parameters import ParameterType, Setting, as_setting
from plastron_tui.ros.qos import Qos

from .manifest import Base
from .value_json import (
    message_from_json,
    scalar_from_json,
    source_from_json,
    source_to_json,
    type_from_json,
    value_to_json,
)

_NOWHERE = Span(0, 0)


def remember(node: Node, library: str, program: str) -> Base:
    """Return what the manifest shall remember of a node.

    Timers that were in a loaded file before are not remembered: no sentence asks for them, and one
    goes with what it sends.

    Args:
        node: the node, as the program has it.
        library: the client library that its file is for.
        program: the name of the program's file, "" where it has none.
    """
    used = {
        kind.value: {
            name: _remembered(each, is_read=_is_read(node, each))
            for name, each in found.items()
            if not (kind is EndpointKind.TIMER and _is_read(node, each))
        }
        for kind, found in node.by_kind.items()
    }
    label = None if node.source is None else node.source.label
    named = {} if label is None else {"label": label}
    managed = {"managed": True} if node.is_managed else {}
    known = {"node": node.name, **named, "library": library, "program": program, **managed}
    return {**known, **{kind: found for kind, found in used.items() if found}}


def _is_read(node: Node, endpoint: Endpoint) -> bool:
    """Tell whether a loaded file alone says that a node has an endpoint."""
    return node.source is not None and endpoint.span is None


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
        node.is_managed = base.get("managed") is True
        for kind in EDITABLE:
            for written, data in base.get(kind.value, {}).items():
                name = written if kind.facts.interface is None else spelled(written)
                node.put(
                    kind.editing.endpoint(
                        name, type_from_json(data["type"]), **_recalled(kind, data)
                    )
                )
    except (KeyError, TypeError, ValueError, AttributeError, RecursionError, OverflowError):
        return None
    return node


class _Detail(NamedTuple):
    """How a field of an endpoint is written, and read."""

    key: str
    write: Callable[[Any], Any]
    read: Callable[[Any], Any]


def _remembered(endpoint: Endpoint, *, is_read: bool) -> dict[str, Any]:
    given: dict[str, Any] = {"type": None if endpoint.type is None else str(endpoint.type)}
    for field, detail in _DETAILS.items():
        value = getattr(endpoint, field, None)
        # The quality of service that a file alone says is the file's own affair.
        if value is not None and not (is_read and field == "qos"):
            given[detail.key] = detail.write(value)
    return given


def _recalled(kind: EndpointKind, data: Mapping[str, Any]) -> dict[str, Any]:
    """Return the other fields of an endpoint of a kind."""
    fields = [field for field in kind.editing.endpoint._fields if field in _DETAILS]
    found = {field: _DETAILS[field].read(data.get(_DETAILS[field].key)) for field in fields}
    if kind is EndpointKind.PARAMETER:
        _check_parameter(**found)
    return found


def _sending(publication: Publication) -> list[Any]:
    value = value_to_json(publication.message.value)
    more: dict[str, Any] = {}
    if publication.parameter is not None:
        more["parameter"] = publication.parameter
    if publication.is_rate_open:
        more["open"] = True
    if publication.is_once:
        more["once"] = True
    if publication.reaction is not None:
        more["for_each"] = publication.reaction.topic
        condition = publication.reaction.condition
        if condition is not None:
            source = source_to_json(condition.source)
            more["when"] = [condition.quantifier, source, condition.operator, condition.value]
    return [publication.rate, value, more] if more else [publication.rate, value]


def _publication(rate: Any, value: Any, more: Any = None) -> Publication:
    given = more or {}
    reaction = _reaction_from(given) if "for_each" in given else None
    is_once = bool(given.get("once"))
    is_paced = reaction is None and not is_once
    hertz = _number(rate)
    if hertz < 0 or (is_paced and hertz == 0):
        raise ValueError
    parameter = given.get("parameter")
    return Publication(
        Message("", message_from_json(value), _NOWHERE),
        float(hertz),
        is_rate_open=bool(given.get("open")),
        parameter=None if parameter is None else _text(parameter),
        is_once=is_once,
        reaction=reaction,
    )


def _reaction_from(given: Mapping[str, Any]) -> Reaction:
    topic = _text(given["for_each"])
    if "when" not in given:
        return Reaction(topic)
    quantifier, source, operator, compared = given["when"]
    found = source_from_json(source)
    if not isinstance(found, OfReceived):
        raise TypeError
    if quantifier not in (None, "any", "all") or operator not in ("<", ">", "="):
        raise ValueError
    return Reaction(topic, Condition(quantifier, found, operator, scalar_from_json(compared)))


def _rate(rate: Rate) -> Any:
    return rate.hertz if rate.parameter is None else list(rate)


def _rate_from(value: Any) -> Rate | None:
    if value is None:
        return None
    given, parameter = value if isinstance(value, list) else (value, None)
    hertz = _number(given)
    if hertz <= 0:
        raise ValueError
    return Rate(float(hertz), None if parameter is None else _text(parameter))


def _request(request: Request) -> Any:
    value = value_to_json(request.value)
    return value if request.rate is None else [_rate(request.rate), value]


def _request_from(value: Any) -> Request:
    if not isinstance(value, list):
        return Request(message_from_json(value))
    rate, message = value
    return Request(message_from_json(message), _rate_from(rate))


def _setting_from(value: Any) -> Setting | None:
    if isinstance(value, list):
        return tuple(map(scalar_from_json, value))
    return None if value is None else scalar_from_json(value)


def _check_parameter(
    holds: ParameterType | None,
    default: Setting | None,
    minimum: int | float | None,
    maximum: int | float | None,
    **_: object,
) -> None:
    """Check that a parameter holds what its type does; of one that was read less is known.

    Raises:
        ValueError: it does not.
    """
    given = [each for each in (default, minimum, maximum) if each is not None]
    if holds is not None and any(as_setting(holds, each) != each for each in given):
        raise ValueError


def _qos_from(value: Any) -> Qos | None:
    if value is None:
        return None
    policies: dict[str, Any] = {
        policy: math.inf if each == "infinite" else each for policy, each in value.items()
    }
    qos = Qos(**policies)
    if any(
        isinstance(each, bool) or not isinstance(each, _POLICIES.get(policy, str))
        for policy, each in qos.known.items()
    ):
        raise TypeError
    return qos


_POLICIES: dict[str, Any] = {
    "depth": int,
    **dict.fromkeys(("deadline", "lifespan", "lease"), (int, float)),
}
"""What the policies are that are no words."""


def _number(value: Any) -> int | float:
    if not isinstance(value, (int, float)) or isinstance(value, bool):
        raise TypeError
    return value


def _number_or_none(value: Any) -> int | float | None:
    return None if value is None else _number(value)


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
        lambda sent: [_request(each) for each in sent],
        lambda sent: tuple(_request_from(each) for each in sent),
    ),
    "goals": _Detail(
        "goals",
        lambda sent: [value_to_json(each) for each in sent],
        lambda sent: tuple(message_from_json(each) for each in sent),
    ),
    "answer": _Detail(
        "answer",
        value_to_json,
        lambda value: None if value is None else message_from_json(value),
    ),
    "rate": _Detail("rate", _rate, _rate_from),
    "holds": _Detail(
        "holds",
        lambda type_: type_.value,
        lambda text: None if text is None else ParameterType(text),
    ),
    "default": _Detail("default", lambda value: value, _setting_from),
    "minimum": _Detail("minimum", _number, _number_or_none),
    "maximum": _Detail("maximum", _number, _number_or_none),
    "description": _Detail("description", str, lambda text: _text(text or "")),
    "qos": _Detail("qos", qos_json, _qos_from),
}
"""The fields of endpoints beside name, type and place."""
