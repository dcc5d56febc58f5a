"""Endpoints that are added in tests, one of each kind."""

from __future__ import annotations

from plastron_tui.diagnostics import Span
from plastron_tui.model.kinds import (
    ActionClient,
    ActionServer,
    Client,
    Message,
    Parameter,
    Publication,
    Publisher,
    Rate,
    Reaction,
    Request,
    Service,
    Subscription,
    Timer,
)
from plastron_tui.model.source import Add
from plastron_tui.model.values import MessageValue
from plastron_tui.ros.interfaces import InterfaceName
from plastron_tui.ros.parameters import ParameterType

AT = Span(0, 0)
ACTIONS = {
    1: ("tf2_msgs/LookupTransform", {"target_frame": "map"}),
    2: ("example_interfaces/Fibonacci", {"order": 3}),
}


def interface(text: str) -> InterfaceName:
    return InterfaceName(*text.split("/"))


def publish(topic, type_="std_msgs/String", rate=None, once=False, heard=None, **fields):
    value = MessageValue(interface(type_), fields)
    is_open = rate is None and not once and heard is None
    reaction = None if heard is None else Reaction(heard)
    sent = Publication(Message("m", value, AT), rate or 10.0, AT, is_open, None, once, reaction)
    return Add(Publisher(topic, interface(type_), (sent,) if fields else (), AT))


def subscribe(topic, type_="sensor_msgs/Imu", callback=None):
    return Add(Subscription(topic, interface(type_), callback, AT))


def provide(service, type_="std_srvs/SetBool", callback=None, **answer):
    value = MessageValue(interface(type_), answer) if answer else None
    return Add(Service(service, interface(type_), callback, span=AT, answer=value))


def request(service, type_="std_srvs/SetBool", rate=None, **fields):
    value = MessageValue(interface(type_), fields)
    made = (Request(value, None if rate is None else Rate(rate)),) if fields else ()
    return Add(Client(service, interface(type_), made, AT))


def repeat(function, rate):
    return Add(Timer(function, None, Rate(rate), AT))


def parameter(name, holds, default, **more):
    return Add(Parameter(name, None, ParameterType(holds), default, span=AT, **more))


def serve(action, version, callback=None):
    return Add(ActionServer(action, interface(ACTIONS[version][0]), callback, AT))


def send_goal(action, version):
    type_, fields = ACTIONS[version]
    goal = MessageValue(interface(type_), fields)
    return Add(ActionClient(action, interface(type_), (goal,), AT))


def each_kind(version: int) -> dict[str, Add]:
    """Return an addition of each kind, by what it is."""
    own = "~/gain" if version == 1 else "gain_2"
    return {
        "publisher": publish("state/raw"),
        "private publisher": publish("~/raw"),
        "message in the file's loop": publish("greeting", data="hi"),
        "message at a rate": publish("stamped", "geometry_msgs/PointStamped", rate=7.0, point=_X),
        "message once": publish("first", once=True, data="y"),
        "subscription": subscribe("imu/data"),
        "service": provide("go"),
        "service with an answer": provide("stop", "std_srvs/Trigger", success=True, message="?"),
        "client": request("ask"),
        "request": request("ask_once", data=True),
        "request at a rate": request("ask_often", rate=2.0, data=True),
        "timer": repeat("tick_often", 4.0),
        "parameter": parameter(own, "float", 2.5),
        "list of texts": parameter(f"{own}s", "string_list", ("a", "b")),
        "action server": serve("look", version),
        "goal": send_goal("seek", version),
    }


_X = MessageValue(interface("geometry_msgs/Point"), {"x": 1.5})
