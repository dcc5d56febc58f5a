"""What the manifest remembers of a node, and what is made of it again."""

from __future__ import annotations

import json
import math
from dataclasses import replace
from typing import Any

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from made_nodes import SPAN, nodes
from random_programs import random_programs

from plastron_tui.model.kinds import (
    ActionClient,
    Client,
    Message,
    Parameter,
    Publication,
    Publisher,
    Rate,
    Request,
    Subscription,
    Timer,
)
from plastron_tui.model.values import Computed, MessageValue, OfParameter
from plastron_tui.model.workspace import Node
from plastron_tui.output.node_json import recall, remember
from plastron_tui.ros.interfaces import FieldType, InterfaceName
from plastron_tui.ros.parameters import ParameterType
from plastron_tui.ros.qos import Qos
from plastron_tui.session import Options, Session


def without_places(node: Node) -> Node:
    """Return a node without what only its program has: spans, and the names of variables."""

    def without(endpoint: Any) -> Any:
        if isinstance(endpoint, Publisher):
            sent = (
                each._replace(message=Message("", each.message.value, SPAN), span=None)
                for each in endpoint.publications
            )
            endpoint = endpoint._replace(publications=tuple(sent))
        return endpoint._replace(span=None)

    return replace(
        node,
        variable="",
        span=SPAN,
        library="rospy",
        by_kind={
            kind: {name: without(each) for name, each in found.items()}
            for kind, found in node.by_kind.items()
        },
    )


@settings(deadline=None, suppress_health_check=[HealthCheck.too_slow, HealthCheck.data_too_large])
@given(nodes("rospy"))
def test_there_and_back(node: Node) -> None:
    base = json.loads(json.dumps(remember(node, "rospy", "a.plastron")))
    assert recall(base) == without_places(node)


@pytest.mark.parametrize("library", ["rospy", "rclpy"])
@settings(deadline=None, suppress_health_check=[HealthCheck.too_slow])
@given(data=st.data())
def test_programs_there_and_back(library: str, data: st.DataObject) -> None:
    text = data.draw(random_programs(library))
    session = Session(text.encode(), None, Options(library), environ={})
    (generation,) = session.workspace.generations
    base = json.loads(json.dumps(remember(generation.node, "rospy", "a.plastron"), allow_nan=False))
    assert recall(base) == without_places(generation.node)


STRING = InterfaceName("std_msgs", "String")
VALUE = MessageValue(
    STRING, {"data": Computed(OfParameter("x"), (("/", 2),), FieldType("string"), is_float=True)}
)
SENT = Publication(Message("", VALUE, SPAN), 10.0, parameter="~/rate")


@pytest.mark.parametrize(
    "endpoint",
    [
        Publisher("a", STRING, (SENT,), None, Qos("reliable", deadline=0.5, lease=math.inf)),
        Publisher("a", STRING, (SENT._replace(is_rate_open=True),)),
        Publisher("a", STRING, (SENT._replace(rate=0, parameter=None, is_once=True),)),
        Subscription("a", STRING, "f", None, Qos(history="keep_last", depth=3)),
        Client("a", STRING, (Request(VALUE), Request(VALUE, Rate(2.0, "rate")))),
        ActionClient("a", STRING, (VALUE,)),
        Timer("f", None, Rate(0.5)),
        Parameter("~rate", None, ParameterType.FLOAT, 1.0, 0.0, 2.0, "how fast"),
        Parameter("~/rates", None, ParameterType.INT_LIST, (1, 2)),
        Parameter("rate"),
    ],
)
def test_each_detail_there_and_back(endpoint: Any) -> None:
    node = Node("n", "", SPAN, "rospy")
    node.put(endpoint)
    base = json.loads(json.dumps(remember(node, "rospy", "a.plastron"), allow_nan=False))
    assert recall(base) == node


GOOD = {"node": "n", "library": "rospy", "program": "a.plastron"}
SENDS = [[10.0, {"std_msgs/String": {"data": "x"}}]]


@pytest.mark.parametrize(
    "broken",
    [
        {"node": 5},
        {"library": None},
        {"publishers": []},
        {"publishers": {"a": {"type": "String", "sends": SENDS}}},
        {"publishers": {"a": {"type": "std_msgs/String"}}},
        {"publishers": {"a": {"type": "std_msgs/String", "sends": [[0, SENDS[0][1]]]}}},
        {"publishers": {"a": {"type": "std_msgs/String", "sends": [[1, {"data": "x"}]]}}},
        {"publishers": {"a": {"type": "std_msgs/String", "sends": [[1, {}]]}}},
        {"publishers": {"a": {"type": "std_msgs/String", "sends": [[1, 5]]}}},
        {"subscriptions": {"a": {"calling": "f"}}},
        {"subscriptions": {"a": {"type": "std_msgs/String", "calling": 5}}},
        {"clients": {"a": {"type": "std_srvs/Empty", "requests": [None]}}},
        {"clients": {"a": {"type": "std_srvs/Empty", "requests": [[0, {"std_srvs/Empty": {}}]]}}},
        {"subscriptions": {"a": {"type": "std_msgs/String", "qos": 5}}},
        {"subscriptions": {"a": {"type": "std_msgs/String", "qos": {"deep": 5}}}},
        {"subscriptions": {"a": {"type": "std_msgs/String", "qos": {"depth": "5"}}}},
        {"subscriptions": {"a": {"type": "std_msgs/String", "qos": {"reliability": 1}}}},
        {"timers": {"f": {"type": None, "rate": "fast"}}},
        {"timers": {"f": {"type": None, "rate": [2, 5]}}},
        {"timers": {"f": {"type": None, "rate": -2}}},
        {"timers": {"f": None}},
        {"parameters": {"a": {"type": None, "holds": "double"}}},
        {"parameters": {"a": {"type": None, "holds": "int", "default": "x"}}},
        {"parameters": {"a": {"type": None, "holds": "int", "default": 1, "minimum": 0.5}}},
        {"parameters": {"a": {"type": None, "holds": "int_list", "default": [[1]]}}},
        {"publishers": {"a": {"type": "std_msgs/String", "sends": [[*SENDS[0], {"for_each": 1}]]}}},
        {
            "publishers": {
                "a": {
                    "type": "std_msgs/String",
                    "sends": [
                        [*SENDS[0], {"for_each": "b", "when": ["some", [["x"], None], "<", 1]}]
                    ],
                }
            }
        },
        {
            "publishers": {
                "a": {
                    "type": "std_msgs/String",
                    "sends": [
                        [10.0, {"std_msgs/String": {"data": {"=": ["x", [["%", 2]], ["s"]]}}}]
                    ],
                }
            }
        },
    ],
)
def test_broken_base_tells_nothing(broken: dict[str, Any]) -> None:
    assert recall(GOOD) is not None
    assert recall({**GOOD, **broken}) is None


@given(st.recursive(st.text() | st.integers(), lambda inner: st.dictionaries(st.text(), inner)))
def test_no_base_raises(base: Any) -> None:
    recall({**GOOD, "publishers": base, "clients": {"a": base}})
    for key in ("qos", "rate", "default", "answer", "goals", "sends"):
        kinds = ("publishers", "subscriptions", "services", "timers", "parameters")
        for kind in (*kinds, "action_clients"):
            recall({**GOOD, kind: {"a": {"type": None, "sends": [], key: base}}})
