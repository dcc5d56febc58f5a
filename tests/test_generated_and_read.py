"""What a program says of a node is what is read in the file that is generated of it."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from machine import examples
from random_programs import SENTENCES, random_programs

from plastron_tui.diagnostics import codes
from plastron_tui.model.endpoint_details import TimerDetails
from plastron_tui.model.kinds import (
    EDITABLE,
    Endpoint,
    EndpointKey,
    EndpointKind,
    Parameter,
    Publisher,
    Subscription,
    Timer,
)
from plastron_tui.model.source import SourceNode
from plastron_tui.model.workspace import Node
from plastron_tui.ros.qos import DEFAULT, Qos
from plastron_tui.session import Options, Session
from plastron_tui.targets import find_target

HERE = Path("robot.plastron")
LANGUAGES = {"roscpp": "rospy", "nodelet": "rospy"}
"""The library of the same generation of ROS by which random programs are made."""
LEFT_OUT = {
    "rospy": {codes.NOT_IN_ROS_1},
    "rclpy": set(),
    "roscpp": {codes.NOT_IN_ROS_1},
    "nodelet": {codes.NOT_IN_ROS_1},
}


def test_every_kind_is_tried() -> None:
    missing = {
        kind
        for kind in EDITABLE
        if not any(f" {kind.editing.making.keyword} " in f" {each}" for each in SENTENCES)
    }
    assert missing == set()


def facts(endpoint: Endpoint, library: str) -> dict[str, Any]:
    """Return what a file says of an endpoint, as far as the program asks for it."""
    found: dict[str, Any] = {"type": endpoint.type}
    match endpoint:
        case Publisher(qos=qos) | Subscription(qos=qos) if qos is not None:
            found["qos"] = qos.over(DEFAULT) if library == "rclpy" else in_ros_1(endpoint, qos)
        case Timer(rate=rate) if rate is not None and rate.parameter is None:
            found["period"] = pytest.approx(1 / rate.hertz)
        case Parameter() if endpoint.holds is not None:
            found |= {"holds": endpoint.holds.value, "default": endpoint.default}
            if endpoint.minimum is not None and library == "rclpy":
                found["range"] = (endpoint.minimum, endpoint.maximum)
    callback = getattr(endpoint, "callback", None)
    return found if callback is None else {**found, "callback": callback}


def in_ros_1(endpoint: Publisher | Subscription, qos: Qos) -> Qos | None:
    """Return what ROS 1 has of a quality of service: a depth, and whether a publisher latches."""
    if isinstance(endpoint, Subscription):
        return Qos(depth=qos.depth).over(DEFAULT) if qos.depth else None
    is_latched = qos.durability == "transient_local"
    kept = Qos(durability="transient_local" if is_latched else None, depth=qos.depth or None)
    return kept.over(DEFAULT)


def facts_read(node: SourceNode) -> dict[EndpointKey, dict[str, Any]]:
    """Return what a file says of each endpoint; timers go by their callbacks."""
    found: dict[EndpointKey, dict[str, Any]] = {}
    for each in node.endpoints:
        is_timer = isinstance(each.details, TimerDetails)
        name = each.callback if is_timer else each.name
        if name is None or each.kind is EndpointKind.PARAMETER:
            continue
        assert is_timer or (each.kind, name) not in found, name
        found[each.kind, name] = {"type": each.type, "callback": each.callback, "period": None}
        if each.qos is not None:
            found[each.kind, name]["qos"] = each.qos.over(DEFAULT)
        if isinstance(each.details, TimerDetails):
            found[each.kind, name]["period"] = each.details.period
    for name, details in node.parameters.items():
        limits = None if details.range is None else details.range[:2]
        read = {"type": None, "holds": details.type, "default": details.default, "range": limits}
        found[EndpointKind.PARAMETER, name] = read
    return found


def check_read(node: Node, read: SourceNode, library: str) -> None:
    """Check that a file has what a node has, and nothing else that others see."""
    found = facts_read(read)
    assert (read.name, read.is_managed) == (node.name, node.is_managed)
    for key, endpoint in node.endpoints.items():
        said = facts(endpoint, library)
        assert {each: found[key].get(each) for each in said} == said
    # The timers that send messages are no statement's.
    kinds = [kind for kind in EDITABLE if kind is not EndpointKind.TIMER]
    assert {key for key in found if key[0] in kinds} <= node.endpoints.keys()


@pytest.mark.parametrize("library", LEFT_OUT)
@settings(max_examples=examples(200), deadline=None)
@given(data=st.data())
def test_generated_is_read_again(library: str, data: st.DataObject) -> None:
    language = LANGUAGES.get(library, library)
    text = data.draw(random_programs(language))
    session = Session(text.encode(), HERE, Options(library), environ={})
    assert {found.code for found in session.diagnostics} <= LEFT_OUT[library], text
    (generation,) = session.workspace.generations
    target = find_target(library)
    assert target is not None
    rendered = target.render(generation.node, session.catalog(target.ros_version))
    assert rendered.files is not None, text
    if library == language:
        compile(rendered.files.main, "node.py", "exec")
    source = target.read(Path(f"node{target.language.suffix}"), rendered.files).source
    assert source is not None
    (read,) = source.nodes
    # What a nodelet is called, who loads it says.
    named = read if library != "nodelet" else read._replace(name=generation.node.name)
    check_read(generation.node, named, language)
