"""What the manifest remembers of a node, and what is made of it again."""

from __future__ import annotations

import json
from dataclasses import replace
from typing import Any

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from made_nodes import SPAN, nodes

from plastron_tui.model.kinds import Message, Publisher
from plastron_tui.model.workspace import Node
from plastron_tui.output.node_json import recall, remember


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
    ],
)
def test_broken_base_tells_nothing(broken: dict[str, Any]) -> None:
    assert recall(GOOD) is not None
    assert recall({**GOOD, **broken}) is None


@given(st.recursive(st.text() | st.integers(), lambda inner: st.dictionaries(st.text(), inner)))
def test_no_base_raises(base: Any) -> None:
    recall({**GOOD, "publishers": base, "clients": {"a": base}})
