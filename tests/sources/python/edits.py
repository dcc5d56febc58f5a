"""Changes that are asked for, and what an editor makes of a text."""

from __future__ import annotations

from pathlib import Path

from file_sets import one

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
from plastron_tui.model.source import Add, EndpointKind
from plastron_tui.model.values import MessageValue
from plastron_tui.ros.catalog import Catalog
from plastron_tui.ros.interfaces import InterfaceName
from plastron_tui.sources.python import edit_python, read_python
from plastron_tui.targets.python.rclpy import DIALECT as RCLPY
from plastron_tui.targets.python.rospy import DIALECT as ROSPY

AT = Span(0, 0)
CATALOGS = {"rospy": Catalog("noetic"), "rclpy": Catalog("jazzy")}
DIALECTS = {"rospy": ROSPY, "rclpy": RCLPY}
NODES = sorted(
    path for path in (Path(__file__).parents[2] / "nodes").glob("r*py/*") if path.suffix != ".json"
)
PUB, SUB = EndpointKind.PUBLISHER, EndpointKind.SUBSCRIPTION
SRV, CLI = EndpointKind.SERVICE, EndpointKind.CLIENT


def edit(text: str | bytes, *changes):
    data = text.encode() if isinstance(text, str) else text
    source = read_python(Path("node.py"), one(data)).source
    assert source is not None
    return edit_python(source, changes, CATALOGS[source.library], DIALECTS[source.library])


def edited(text: str, *changes) -> str:
    rendered = edit(text, *changes)
    assert rendered.files is not None, [found.message for found in rendered.diagnostics]
    return rendered.files.main.decode()


def interface(text: str) -> InterfaceName:
    return InterfaceName(*text.split("/"))


def publish(topic, type_="std_msgs/String", rate=None, **fields):
    value = MessageValue(interface(type_), fields)
    sent = Publication(Message("m", value, AT), rate or 10.0, is_rate_open=rate is None)
    return Add(Publisher(topic, interface(type_), [sent] if fields else [], AT))


def subscribe(topic, type_="std_msgs/String", callback=None):
    return Add(Subscription(topic, interface(type_), callback, AT))


def provide(name, type_="std_srvs/Trigger", handler=None):
    return Add(Service(name, interface(type_), handler, AT))


def request(name, type_, **fields):
    value = MessageValue(interface(type_), fields)
    return Add(Client(name, interface(type_), [Request(value)], AT))
