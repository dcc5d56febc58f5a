"""Edits of nodes for rclpy, and what is played to the nodes."""

from __future__ import annotations

from played_nodes import HEADER, Case, vector
from traffic import call, send, wait

JOINTS = ("/head/joint/pan", "/head/joint/tilt")

RCLPY_EDITS = [
    Case(
        "rclpy/doubler.py",
        (send("/numbers", {"data": 4}, "/doubled"), send("/numbers", {"data": -1}, "/doubled")),
        statements="subscribe node to 'halves' of message_type Float32\n",
        new=(send("/halves", {"data": 0.5}),),
    ),
    Case(
        "rclpy/mode_keeper.py",
        (
            wait("/mode", {"data": "idle"}),
            send("/wanted_mode", {"data": "patrol"}, "/mode"),
            call("/mode_keeper/arm", {"data": True}, "/mode"),
            call("/mode_keeper/mode", {}),
        ),
        statements=(
            "node renames topic 'mode' to 'robot/mode'\n"
            "node provides_service 'relax' of service_type SetBool calling on_arm\n"
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
        (
            wait("/cruise/cmd_vel", {"linear": vector(0.0)}),
            send("/speed", {"data": 1.5}, "/cruise/limited"),
            wait("/cruise/cmd_vel", {"linear": vector(1.5)}),
            send("/speed", {"data": 9.0}, "/cruise/limited"),
            wait("/cruise/cmd_vel", {"linear": vector(2.0)}),
        ),
        statements="node stop_publishing to '/cruise/limited'\n",
        gone=("/cruise/limited",),
    ),
    Case(
        "rclpy/collector.py",
        (
            send("/temperature", {"data": 20.5}, "/report"),
            send("/humidity", {"data": 40.0}, "/report"),
            send("/pressure", {"data": 1013.0}, "/report"),
            send("/temperature", {"data": 21.5}, "/report"),
        ),
        statements=(
            "node renames topic 'temperature' to 'outside/temperature'\n"
            "unsubscribe node from 'humidity'\n"
        ),
        renames={"/temperature": "/outside/temperature"},
        gone=("/humidity",),
    ),
    Case(
        "rclpy/two_groups.py",
        (
            send("/step", {}, "/count"),
            send("/step", {}, "/count"),
            send("/back", {}, "/count"),
            call("/how_many", {}),
        ),
        statements=(
            "node stop_service 'how_many'\n"
            "node provides_service 'total' of service_type Trigger calling on_how_many\n"
        ),
        renames={"/how_many": "/total"},
    ),
    Case(
        "rclpy/ticker.py",
        (
            wait("/text", {"data": "tick"}),
            send("/set_quiet", {"data": True}),
            wait("/is_quiet", {"data": True}),
            send("/set_text", {"data": "tock"}),
            wait("/text", {"data": "tock"}),
        ),
        statements=(
            "node renames topic 'text' to '~/text'\n"
            "node stop_publishing to 'is_quiet'\n"
            "unsubscribe node from 'set_quiet'\n"
        ),
        renames={"/text": "/ticker/text"},
        gone=("/is_quiet", "/set_quiet"),
    ),
    Case(
        "rclpy/sensor_filter.py",
        (
            send("/raw", {"data": 1.0}, "/filtered", "/raw_copy"),
            send("/raw", {"data": 2.0}, "/filtered", "/raw_copy"),
            send("/raw", {"data": -4.0}, "/filtered", "/raw_copy"),
        ),
        statements=(
            "unsubscribe node from 'raw'\n"
            "subscribe node to 'imu/raw' of message_type Float32 calling on_raw\n"
        ),
        renames={"/raw": "/imu/raw"},
    ),
    Case(
        "rclpy/own_loop.py",
        (
            wait("/report", {"data": "heard 0"}),
            send("/number", {"data": 3}, "/twice"),
            wait("/report", {"data": "heard 3"}),
            send("/number", {"data": -3}, "/twice"),
        ),
        statements=(
            "create_message m of message_type Int32 and input 7\n"
            "node publish m to 'seven' of message_type Int32\n"
            "node renames topic 'twice' to 'doubled'\n"
        ),
        renames={"/twice": "/doubled"},
        new=(wait("/seven", {"data": 7}),),
    ),
    Case(
        "rclpy/threaded.py",
        (
            wait("/heater/power", {"data": 0.0}),
            call("/heater/switch", {"data": True}),
            wait("/heater/power", {"data": 100.0}),
            send("/heater/limit", {"data": 50.0}),
            wait("/heater/power", {"data": 50.0}),
            call("/heater/switch", {"data": True}),
        ),
        statements=(
            "node stop_service 'heater/switch'\n"
            "node provides_service 'switch' of service_type SetBool calling handleSwitch\n"
            "node renames topic 'heater/power' to 'power'\n"
        ),
        renames={"/heater/switch": "/switch", "/heater/power": "/power"},
    ),
    Case(
        "rclpy/two_arms.py",
        (
            send("/left/move", {"data": 1.5}, "/left/angle"),
            send("/right/move", {"data": 2.5}, "/right/angle"),
            send("/command", {"data": "up"}, "/left/angle"),
        ),
        statements=(
            "node renames topic 'command' to 'right/command'\n"
            "node stop_publishing to 'right/angle'\n"
        ),
        gone=("/right/angle",),
        new=(send("/right/command", {"data": "up"}),),
        node="right_arm",
    ),
    Case(
        "rclpy/gain.py",
        (
            send("/input", {"data": 3.0}, "/output"),
            call("/gain/tell", {}),
            send("/input", {"data": -0.5}, "/output"),
        ),
        statements=(
            "node renames parameter 'gain' to 'factor'\n"
            "node renames service '~/tell' to 'tell'\n"
            "node renames topic 'input' to 'in/value'\n"
        ),
        renames={"/input": "/in/value", "/gain/tell": "/tell"},
    ),
    Case(
        "rclpy/door.py",
        (
            send("/close", {"data": True}, "/lock", "/status"),
            send("/close", {"data": False}, "/lock", "/status"),
        ),
        statements=(
            "node renames service 'lock' to 'gate/lock'\n"
            "node client_requests 'bell' of service_type Trigger with input none\n"
        ),
        renames={"/lock": "/gate/lock"},
        new=(wait("/bell", {}),),
        serves={
            "/lock": ("std_srvs/SetBool", {"success": True, "message": "click"}),
            "/bell": ("std_srvs/Trigger", {"success": True}),
        },
    ),
    Case(
        "rclpy/camera_arm.py",
        (
            send("/head/aim", {"data": 0.5}, *JOINTS, "/head/camera_arm/error"),
            send("/camera_arm/home", {"data": 0.0}, *JOINTS, "/camera_arm/last"),
        ),
        statements=(
            "node renames topic '~/error' to 'error'\n"
            "unsubscribe node from 'aim'\n"
            "subscribe node to 'look_at' of message_type Float32 calling _aim\n"
        ),
        renames={"/head/camera_arm/error": "/head/error", "/head/aim": "/head/look_at"},
    ),
    Case(
        "rclpy/goal_relay.py",
        (
            send("/goal_in", {"header": HEADER, "pose": {"position": vector(4.0)}}, "/goal"),
            send("/cancel", {}, "/goal", "/cancelled"),
            send("/cancel", {}, "/goal", "/cancelled"),
        ),
        statements=(
            "unsubscribe node from 'cancel'\n"
            "subscribe node to 'stop' of message_type std_msgs/Empty calling cancel_callback\n"
            "node stop_publishing to 'cancelled'\n"
        ),
        renames={"/cancel": "/stop"},
        gone=("/cancelled",),
    ),
    Case(
        "rclpy/crane.py",
        (
            send("/lift", {"data": 1.5}, "/height", "/busy", "/busy"),
            send("/say", {"data": "up it goes"}, "/height"),
            send("/lift", {"data": 1.5}, "/height"),
        ),
        statements=(
            "node stop_publishing to 'busy'\n"
            "unsubscribe node from 'lift'\n"
            "subscribe node to 'winch' of message_type Float32 calling on_lift\n"
        ),
        renames={"/lift": "/winch"},
        gone=("/busy",),
    ),
]
