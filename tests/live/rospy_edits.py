"""Edits of nodes for rospy, and what is played to the nodes."""

from __future__ import annotations

from played_nodes import HEADER, Case, scan, vector
from traffic import call, send, wait

ROSPY_EDITS = [
    Case(
        "rospy/gate.py",
        (
            wait("/gate/state", {"data": "open"}),
            send("/in", {"data": 3}, "/out"),
            send("/open", {"data": False}, "/gate/state"),
            send("/in", {"data": 4}, "/gate/state"),
            send("/open", {"data": True}, "/gate/state"),
            send("/in", {"data": 5}, "/out"),
        ),
        statements="node renames topic 'in' to 'numbers'\n",
        renames={"/in": "/numbers"},
    ),
    Case(
        "rospy/averager.py",
        (
            send("/samples", {"data": 1.0}, "/mean"),
            send("/samples", {"data": 2.0}, "/mean"),
            call("/clear", {}),
            send("/samples", {"data": 7.0}, "/mean"),
            send("/samples", {"data": 8.0}, "/mean"),
        ),
        statements=(
            "node stop_service 'clear'\n"
            "node provides_service 'forget' of service_type Trigger calling handle_clear\n"
        ),
        renames={"/clear": "/forget"},
    ),
    Case(
        "rospy/mux.py",
        (
            send("/left", {"data": "one"}, "/mux/chosen"),
            send("/right", {"data": "two"}, "/mux/ignored"),
            send("/select", {"data": "right"}, "/mux/ignored"),
            send("/left", {"data": "three"}, "/mux/ignored"),
            send("/right", {"data": "four"}, "/mux/chosen"),
        ),
        statements=(
            "unsubscribe node from 'left'\n"
            "subscribe node to 'port' of message_type String calling callback\n"
        ),
        renames={"/left": "/port"},
    ),
    Case(
        "rospy/thermostat.py",
        (
            wait("/error", {"data": 5.0}),
            send("/target", {"data": 10.0}),
            wait("/error", {"data": -5.0}),
            send("/measured", {"data": 8.0}),
            wait("/heating", {"data": True}),
        ),
        statements=(
            'create_message m of message_type String and input "auto"\n'
            "node publish m to 'control_mode' of message_type String\n"
        ),
        new=(wait("/control_mode", {"data": "auto"}),),
    ),
    Case(
        "rospy/scaler.py",
        (
            send("/cmd_vel_in", {"linear": vector(1.0), "angular": vector(0, 0, -3.0)}, "/cmd_vel"),
            call("/enable", {"data": False}),
            send("/cmd_vel_in", {"linear": vector(2.0)}, "/cmd_vel"),
        ),
        statements=(
            "node renames topic 'cmd_vel' to '/base/cmd_vel'\n"
            "node renames service 'enable' to 'motors/enable'\n"
        ),
        renames={"/cmd_vel": "/base/cmd_vel", "/enable": "/motors/enable"},
    ),
    Case(
        "rospy/stamper.py",
        (
            send("/point", vector(1.0, 2.0), "/stamped"),
            send("/clicked", {"header": HEADER, "point": vector(3.0)}, "/shifted"),
            send("/point", vector(-1.0), "/stamped"),
        ),
        statements=(
            "unsubscribe node from 'clicked'\n"
            "subscribe node to 'rviz/clicked' of message_type PointStamped calling on_clicked\n"
        ),
        renames={"/clicked": "/rviz/clicked"},
    ),
    Case(
        "rospy/stopwatch.py",
        (
            wait("/running", {"data": False}),
            call("/lap", {}),
            call("/start", {"data": True}),
            wait("/running", {"data": True}),
            call("/lap", {}, "/laps"),
            call("/lap", {}, "/laps"),
            call("/start", {"data": True}),
        ),
        statements=(
            'create_message m of message_type String and input "stopwatch"\n'
            "node publish m to 'who' of message_type String\n"
            "node renames service 'lap' to 'next_lap'\n"
        ),
        renames={"/lap": "/next_lap"},
        new=(wait("/who", {"data": "stopwatch"}),),
    ),
    Case(
        "rospy/parrot.py",
        (
            send("/words", {"data": "aye"}, "/length", "/loud"),
            send("/secrets", {"data": "gold"}, "/backwards"),
            send("/words", {"data": "land ho"}, "/length", "/loud"),
        ),
        statements="node stop_publishing to 'loud'\nnode renames topic 'secrets' to 'whispers'\n",
        renames={"/secrets": "/whispers"},
        gone=("/loud",),
    ),
    Case(
        "rospy/greeter.py",
        (
            send("/english", {"data": "Ann"}, "/all/greetings"),
            send("/german", {"data": "Bert"}, "/all/greetings"),
            send("/leave", {}, "/all/greetings"),
        ),
        statements=(
            "unsubscribe node from 'german'\n"
            "node renames topic '/all/greetings' to 'greetings'\n"
            "node provides_service 'count' of service_type Trigger\n"
        ),
        renames={"/all/greetings": "/greetings"},
        gone=("/german",),
        new=(call("/count", {}, answer={"success": False, "message": ""}),),
    ),
    Case(
        "rospy/beacon.py",
        (
            wait("/beacon/status", {"data": "here"}),
            send("/beacon/ping", {}, "/beacon/pong"),
            send("/beacon/ping", {}, "/beacon/pong"),
        ),
        statements=(
            "node renames topic '~/status' to '~/state'\n"
            "node renames topic '/beacon/ping' to '/beacon/call'\n"
            "node renames parameter '~word' to '~text'\n"
        ),
        renames={"/beacon/status": "/beacon/state", "/beacon/ping": "/beacon/call"},
    ),
    Case(
        "rospy/battery.py",
        (
            wait("/battery/low", {"data": False}),
            send("/voltage", {"data": 12.0}, "/battery/level"),
            send("/voltage", {"data": 11.0}, "/battery/level", "/battery/low"),
            send("/charger", {"data": True}, "/battery/level"),
            send("/voltage", {"data": 10.0}, "/battery/level", "/battery/low"),
        ),
        statements=(
            "node renames topic 'voltage' to 'cell/voltage'\n"
            "subscribe node to 'current' of message_type Float32\n"
        ),
        renames={"/voltage": "/cell/voltage"},
        new=(send("/current", {"data": 0.5}),),
    ),
    Case(
        "rospy/nearest.py",
        (
            send("/scan", scan(0.2, 3.0, 1.5), "/nearest", "/blocked"),
            send("/scan", scan(9.0), "/blocked"),
            send("/scan", scan(0.25, 9.0), "/nearest", "/blocked"),
        ),
        statements=(
            "node stop_publishing to 'nearest'\n"
            'create_message m of message_type String and input "laser"\n'
            "node publish m to 'source' of message_type String at 20 hz\n"
        ),
        gone=("/nearest",),
        new=(wait("/source", {"data": "laser"}),),
    ),
    Case(
        "rospy/light_switch.py",
        (
            send("/motion", {"data": False}, "/log", "/lamp/switch"),
            send("/motion", {"data": True}, "/log", "/lamp/switch", "/bell"),
        ),
        statements=(
            "node renames service 'lamp/switch' to 'lamp/set'\n"
            "node renames topic 'log' to 'journal'\n"
        ),
        renames={"/lamp/switch": "/lamp/set", "/log": "/journal"},
        serves={
            "/lamp/switch": ("std_srvs/SetBool", {"success": True, "message": "switched"}),
            "/bell": ("std_srvs/Trigger", {"success": True}),
        },
    ),
    Case(
        "rospy/wheels.py",
        (
            send("/cmd_vel", {"linear": vector(1.0)}, "/left/speed", "/right/speed", "/debug"),
            send("/cmd_vel", {"angular": vector(0, 0, 2.0)}, "/left/speed", "/right/speed"),
        ),
        statements=(
            "node stop_publishing to 'debug'\n"
            "unsubscribe node from 'cmd_vel'\n"
            "subscribe node to '/base/cmd_vel' of message_type Twist calling drive\n"
        ),
        renames={"/cmd_vel": "/base/cmd_vel"},
        gone=("/debug",),
    ),
    Case(
        "rospy/tally.py",
        (
            send("/add", {"data": 3}, "/total"),
            call("/reset", {}, "/total"),
            send("/add", {"data": -3}),
            send("/add", {"data": 4}, "/total"),
        ),
        statements=(
            "node stop_service 'reset'\n"
            "subscribe node to 'extra' of message_type Int32 calling on_add\n"
        ),
        gone=("/reset",),
        new=(send("/extra", {"data": 5}, "/total"),),
    ),
]
