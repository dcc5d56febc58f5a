"""Which type a described node of ROS 1 has for a topic: its own, whatever the master remembers."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from threading import Thread
from typing import Any
from xmlrpc.server import SimpleXMLRPCServer

import pytest
from machine import free_port

from plastron_tui.model.kinds import EndpointKind
from plastron_tui.runtime.describe import describe_ros1

TOPIC = "/level"
SUBSCRIBERS = ["/any", "/gone", "/small", "/strange", "/wide"]


@contextmanager
def answering(**answers: Any) -> Iterator[str]:
    """Serve an API of ROS 1 that gives these answers; yield its address."""
    with SimpleXMLRPCServer(("127.0.0.1", 0), logRequests=False) as server:
        for method, answer in answers.items():
            given = answer if callable(answer) else lambda *_, answer=answer: answer
            server.register_function(lambda *asked, given=given: [1, "", given(*asked)], method)
        thread = Thread(target=server.serve_forever, kwargs={"poll_interval": 0.01})
        thread.start()
        try:
            yield f"http://127.0.0.1:{server.server_address[1]}/"
        finally:
            server.shutdown()
            thread.join()


@pytest.fixture
def master() -> Iterator[str]:
    """The address of a master that remembers the type of a node that is long gone."""
    heard = {"small": [[TOPIC, "std_msgs/UInt8"]], "wide": [[TOPIC, "std_msgs/Int32"]]}
    heard |= {"any": [[TOPIC, "*"]], "strange": [[TOPIC]]}
    with ExitStack() as stack:
        nodes = {
            f"/{name}": stack.enter_context(
                answering(getPublications=[], getSubscriptions=subscriptions)
            )
            for name, subscriptions in heard.items()
        }
        nodes["/gone"] = f"http://127.0.0.1:{free_port()}/"
        yield stack.enter_context(
            answering(
                getSystemState=[[], [[TOPIC, SUBSCRIBERS]], []],
                getTopicTypes=[[TOPIC, "std_msgs/UInt8"]],
                lookupNode=lambda _, name: nodes[name],
                getParam={},
            )
        )


def test_a_node_has_the_type_that_it_tells_itself(master: str) -> None:
    found = describe_ros1(master)
    assert found.nodes is not None
    types = {
        node.name: str(type_)
        for node in found.nodes
        for _, type_ in node.by_kind[EndpointKind.SUBSCRIPTION]
    }
    # Of one that takes any type, the master says what is sent.
    assert types == {
        "/any": "std_msgs/UInt8",
        "/small": "std_msgs/UInt8",
        "/wide": "std_msgs/Int32",
    }
    told = [each.message for each in found.diagnostics]
    assert [name for name in SUBSCRIBERS if any(name in each for each in told)] == [
        "/gone",
        "/strange",
    ]
