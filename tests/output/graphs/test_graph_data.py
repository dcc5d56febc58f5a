from __future__ import annotations

import pytest
from graph_workspaces import STRING, Maker, tour, workspaces
from hypothesis import given

from plastron_tui.diagnostics import Span
from plastron_tui.model.graph import graph_of
from plastron_tui.model.kinds import EndpointKind, Subscription
from plastron_tui.model.workspace import Generation, Workspace
from plastron_tui.ros.interfaces import InterfaceName
from plastron_tui.ros.names import resolved_name


@pytest.mark.parametrize(
    ("name", "full"),
    [
        ("chatter", "/chatter"),
        ("/chatter", "/chatter"),
        ("a/b", "/a/b"),
        ("~x", "/talker/x"),
        ("~/x", "/talker/x"),
        ("chatter/", "/chatter"),
        ("/a//b", "/a/b"),
        ("{node}/x", "/talker/x"),
        ("{ns}/x", "/x"),
        ("{namespace}x", "/x"),
    ],
)
def test_full_names(name: str, full: str) -> None:
    assert resolved_name("talker", name) == full


def test_ends_meet_under_the_full_name() -> None:
    graph = graph_of(tour())
    image = graph.topics[0]
    assert (image.name, image.type, image.missing) == ("/image", STRING, None)
    assert [(end.node.name, end.written) for end in image.tails] == [("camera", "image")]
    (end,) = image.of(EndpointKind.SUBSCRIPTION)
    assert (end.node.name, end.written) == ("planner", "/image")
    assert isinstance(end.endpoint, Subscription) and end.endpoint.callback == "on_image"
    debug = graph.topics[1]
    assert debug.name == "/camera/debug"
    assert [(sent.message, sent.rate) for sent in debug.tails[0].sendings] == [
        ("frame", 1.0),
        ("note", 0.5),
    ]


def test_what_is_missing() -> None:
    graph = graph_of(tour())
    assert {place.name: place.missing for place in graph.hubs} == {
        "/image": None,
        "/camera/debug": EndpointKind.SUBSCRIPTION,
        "/light": EndpointKind.PUBLISHER,
        "/cmd_vel": None,
        "/odom": None,
        "/enable": None,
        "/save_map": EndpointKind.SERVICE,
        "/calibrate": EndpointKind.CLIENT,
    }


def test_nodes_say_where_they_come_from() -> None:
    workspace = tour()
    planner = workspace.nodes["planner"]
    workspace.generations.append(Generation(planner.snapshot(), "rclpy", Span(0, 1)))
    found = [
        (node.variable, node.library, node.is_loaded, node.is_generated)
        for node in graph_of(workspace).nodes
    ]
    assert found == [
        ("cam", "rospy", False, False),
        ("planner", "rclpy", False, True),
        ("drv", "rospy", True, False),
        ("lonely", None, False, False),
    ]


def test_two_nodes_of_one_name_stay_two() -> None:
    make = Maker()
    make.publish(make.node("same", "first"), "a", ("m", 1.0))
    make.publish(make.loaded("same", "second", "same.py"), "a")
    (topic,) = graph_of(make.workspace).topics
    assert [end.node.variable for end in topic.tails] == ["first", "second"]


def test_types_that_disagree_are_all_there() -> None:
    make = Maker()
    other = InterfaceName("std_msgs", "Int32")
    make.publish(make.loaded("a", "a", "a.py"), "t", type_=None)
    make.subscribe(make.node("b"), "t", type_=other)
    make.subscribe(make.node("c"), "t")
    (topic,) = graph_of(make.workspace).topics
    assert topic.types == (other, STRING)


@given(workspaces())
def test_every_endpoint_is_there_once_with_its_span(workspace: Workspace) -> None:
    graph = graph_of(workspace)
    found = [
        (end.node.variable, end.kind, end.written, end.span)
        for hub in graph.hubs
        for end in (*hub.tails, *hub.heads)
    ]
    wanted = [
        (node.variable, kind, name, endpoint.span)
        for node in workspace.nodes.values()
        for (kind, name), endpoint in node.endpoints.items()
    ]
    assert sorted(found, key=repr) == sorted(wanted, key=repr)
    assert [node.variable for node in graph.nodes] == list(workspace.nodes)
    for places in (graph.topics, graph.services):
        assert len({place.name for place in places}) == len(places)
