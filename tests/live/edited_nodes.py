"""Nodes that a person wrote, what a program changes in them, and what is played to them."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass, field
from pathlib import Path

from traffic import Fields, Step, call, send, wait

NODES = Path(__file__).parents[1] / "nodes" / "live"


@dataclass(frozen=True)
class Case:
    """An edit of a node in `tests/nodes/live`.

    `steps` are played to the original and to the edited node, there with `renames` and in both
    without what is `gone`; `new` only to the edited one, for what the statements add. The node
    may call what the player `serves`: type and response by name.
    """

    file: str
    statements: str
    steps: tuple[Step, ...]
    renames: Mapping[str, str] = field(default_factory=dict)
    gone: Collection[str] = ()
    new: tuple[Step, ...] = ()
    serves: Mapping[str, tuple[str, Fields]] = field(default_factory=dict)


def vector(x: float, y: float = 0.0, z: float = 0.0) -> Fields:
    return {"x": x, "y": y, "z": z}


CASES = [
    Case(
        "rospy/gate.py",
        "node renames topic 'in' to 'numbers'\n",
        (
            wait("/gate/state", {"data": "open"}),
            send("/in", {"data": 3}, "/out"),
            send("/open", {"data": False}, "/gate/state"),
            send("/in", {"data": 4}, "/gate/state"),
            send("/open", {"data": True}, "/gate/state"),
            send("/in", {"data": 5}, "/out"),
        ),
        renames={"/in": "/numbers"},
    ),
    Case(
        "rospy/averager.py",
        "node stop_service 'clear'\n"
        "node provides_service 'forget' of service_type Trigger calling handle_clear\n",
        (
            send("/samples", {"data": 1.0}, "/mean"),
            send("/samples", {"data": 2.0}, "/mean"),
            call("/clear", {}),
            send("/samples", {"data": 7.0}, "/mean"),
            send("/samples", {"data": 8.0}, "/mean"),
        ),
        renames={"/clear": "/forget"},
    ),
    Case(
        "rospy/mux.py",
        "unsubscribe node from 'left'\n"
        "subscribe node to 'port' of message_type String calling callback\n",
        (
            send("/left", {"data": "one"}, "/mux/chosen"),
            send("/right", {"data": "two"}, "/mux/ignored"),
            send("/select", {"data": "right"}, "/mux/ignored"),
            send("/left", {"data": "three"}, "/mux/ignored"),
            send("/right", {"data": "four"}, "/mux/chosen"),
        ),
        renames={"/left": "/port"},
    ),
    Case(
        "rospy/thermostat.py",
        'create_message m of message_type String and input "auto"\n'
        "node publish m to 'control_mode' of message_type String\n",
        (
            wait("/error", {"data": 5.0}),
            send("/target", {"data": 10.0}),
            wait("/error", {"data": -5.0}),
            send("/measured", {"data": 8.0}),
            wait("/heating", {"data": True}),
        ),
        new=(wait("/control_mode", {"data": "auto"}),),
    ),
    Case(
        "rospy/scaler.py",
        "node renames topic 'cmd_vel' to '/base/cmd_vel'\n"
        "node renames service 'enable' to 'motors/enable'\n",
        (
            send("/cmd_vel_in", {"linear": vector(1.0), "angular": vector(0, 0, -3.0)}, "/cmd_vel"),
            call("/enable", {"data": False}),
            send("/cmd_vel_in", {"linear": vector(2.0)}, "/cmd_vel"),
        ),
        renames={"/cmd_vel": "/base/cmd_vel", "/enable": "/motors/enable"},
    ),
    Case(
        "rclpy/doubler.py",
        "subscribe node to 'halves' of message_type Float32\n",
        (send("/numbers", {"data": 4}, "/doubled"), send("/numbers", {"data": -1}, "/doubled")),
        new=(send("/halves", {"data": 0.5}),),
    ),
    Case(
        "rclpy/mode_keeper.py",
        "node renames topic 'mode' to 'robot/mode'\n"
        "node provides_service 'relax' of service_type SetBool calling on_arm\n",
        (
            wait("/mode", {"data": "idle"}),
            send("/wanted_mode", {"data": "patrol"}, "/mode"),
            call("/mode_keeper/arm", {"data": True}, "/mode"),
            call("/mode_keeper/mode", {}),
        ),
        renames={"/mode": "/robot/mode"},
        new=(
            call(
                "/relax",
                {"data": False},
                "/robot/mode",
                answer={"success": True, "message": "idle"},
            ),
        ),
    ),
    Case(
        "rclpy/cruise.py",
        "node stop_publishing to '/cruise/limited'\n",
        (
            wait("/cruise/cmd_vel", {"linear": vector(0.0)}),
            send("/speed", {"data": 1.5}, "/cruise/limited"),
            wait("/cruise/cmd_vel", {"linear": vector(1.5)}),
            send("/speed", {"data": 9.0}, "/cruise/limited"),
            wait("/cruise/cmd_vel", {"linear": vector(2.0)}),
        ),
        gone=("/cruise/limited",),
    ),
    Case(
        "rclpy/collector.py",
        "node renames topic 'temperature' to 'outside/temperature'\n"
        "unsubscribe node from 'humidity'\n",
        (
            send("/temperature", {"data": 20.5}, "/report"),
            send("/humidity", {"data": 40.0}, "/report"),
            send("/pressure", {"data": 1013.0}, "/report"),
            send("/temperature", {"data": 21.5}, "/report"),
        ),
        renames={"/temperature": "/outside/temperature"},
        gone=("/humidity",),
    ),
    Case(
        "rclpy/two_groups.py",
        "node stop_service 'how_many'\n"
        "node provides_service 'total' of service_type Trigger calling on_how_many\n",
        (
            send("/step", {}, "/count"),
            send("/step", {}, "/count"),
            send("/back", {}, "/count"),
            call("/how_many", {}),
        ),
        renames={"/how_many": "/total"},
    ),
]
QUICK = {"rospy/mux.py", "rclpy/mode_keeper.py"}
