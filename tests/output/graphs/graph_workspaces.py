"""Workspaces to draw: small ones by hand, and any at all."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import count
from pathlib import Path

from file_sets import one
from hypothesis import strategies as st

from plastron_tui.diagnostics import Span
from plastron_tui.model.kinds import (
    Client,
    Message,
    Publication,
    Publisher,
    Request,
    Service,
    Subscription,
)
from plastron_tui.model.source import SourceUnit
from plastron_tui.model.values import MessageValue
from plastron_tui.model.workspace import Node, Workspace
from plastron_tui.ros.interfaces import InterfaceName

STRING = InterfaceName("std_msgs", "String")
TRIGGER = InterfaceName("std_srvs", "Trigger")


class Maker:
    """Builds a workspace, and gives every statement a span of its own."""

    def __init__(self) -> None:
        self.workspace = Workspace()
        self._starts: Iterator[int] = count(0, 10)

    def span(self) -> Span:
        start = next(self._starts)
        return Span(start, start + 9)

    def node(self, name: str, variable: str | None = None, **more: object) -> Node:
        made = Node(name, variable or name, self.span(), **more)  # type: ignore[arg-type]
        self.workspace.nodes[made.variable] = made
        return made

    def loaded(self, name: str, variable: str, path: str) -> Node:
        return self.node(
            name, variable, library="rospy", source=SourceUnit(Path(path), one(b""), "rospy", ())
        )

    def publish(
        self,
        node: Node,
        topic: str,
        *sent: tuple[str, float],
        type_: InterfaceName | None = STRING,
    ) -> None:
        publications = tuple(
            Publication(Message(name, MessageValue(STRING, {}), Span(0, 1)), rate, self.span())
            for name, rate in sent
        )
        span = publications[0].span if publications else None
        node.put(Publisher(topic, type_, publications, span))

    def subscribe(
        self, node: Node, topic: str, callback: str | None = None, type_: InterfaceName = STRING
    ) -> None:
        node.put(Subscription(topic, type_, callback, self.span()))

    def provide(self, node: Node, name: str, handler: str | None = None) -> None:
        node.put(Service(name, TRIGGER, handler, self.span()))

    def call(self, node: Node, name: str, *fields: dict[str, object]) -> None:
        values = (MessageValue(TRIGGER, each) for each in fields)  # type: ignore[arg-type]
        requests = tuple(map(Request, values))
        node.put(Client(name, TRIGGER, requests, self.span()))


def tour() -> Workspace:
    make = Maker()
    camera, planner = make.node("camera", "cam", library="rospy"), make.node("planner")
    driver = make.loaded("driver", "drv", "nodes/driver_node.py")
    make.publish(camera, "image", ("frame", 30.0))
    make.publish(camera, "~debug", ("frame", 1.0), ("note", 0.5))
    make.subscribe(planner, "/image", "on_image")
    make.publish(planner, "cmd_vel", ("go", 20.0))
    make.publish(driver, "odom")
    make.subscribe(driver, "cmd_vel")
    make.subscribe(planner, "odom")
    make.provide(driver, "/enable", "handle_enable")
    make.call(planner, "enable", {"data": True}, {})
    make.call(planner, "save_map", {})
    make.provide(camera, "calibrate")
    make.subscribe(camera, "light")
    make.node("lonely")
    return make.workspace


_MOST = 12
TOPICS = [f"/topic_{number}" for number in range(6)]
_TEXTS = st.one_of(
    st.text(st.characters(), min_size=1, max_size=60),
    st.text("ab/_~.'\"\\<>&#;%{}`|[]()\n\u202e-é日 ", min_size=1, max_size=300),
    st.sampled_from(['"]; n0 -> n1; x["', "end", "%%{init: {}}%%", "</text><script/>", "]]>"]),
)


@st.composite
def workspaces(draw: st.DrawFn, names: st.SearchStrategy[str] = _TEXTS) -> Workspace:
    """Any workspace, cycles and odd names included."""
    make = Maker()
    places = [*TOPICS, *draw(st.lists(names, max_size=3))]
    for number in range(draw(st.integers(0, _MOST))):
        node = make.node(draw(st.one_of(st.just(f"node_{number}"), names)), f"n{number}")
        for act in (
            lambda node, name: make.publish(node, name, ("m", 10.0)),
            make.subscribe,
            make.provide,
            lambda node, name: make.call(node, name, {}),
        ):
            for name in draw(st.lists(st.sampled_from(places), max_size=3, unique=True)):
                act(node, name)
    return make.workspace
