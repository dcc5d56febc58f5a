"""Nodes for rospy that are brought to ROS 2, and what is played to them there and in ROS 1."""

from __future__ import annotations

from played_nodes import HEADER, Case, vector
from traffic import call, send, wait

ROSPY_PORTS = [
    Case(
        "rospy/lift.py",
        (
            send("/go_to", {"data": 2}, "/floor", "/floor", "/arrived"),
            send("/go_to", {"data": 2}, "/arrived"),
            send("/go_to", {"data": -1}, "/floor", "/floor", "/floor", "/arrived"),
        ),
    ),
    Case(
        "rospy/ramp.py",
        (
            send("/clock_tick", {}, "/ramped"),
            send("/wanted", vector(0.375), "/accepted"),
            send("/clock_tick", {}, "/ramped"),
            send("/clock_tick", {}, "/ramped"),
            send("/wanted", vector(-1.0), "/accepted"),
            send("/clock_tick", {}, "/ramped"),
        ),
    ),
    Case(
        "rospy/joiner.py",
        (
            call("/flush", {}),
            send("/word", {"data": "hello "}, "/words_so_far"),
            send("/word", {"data": "wörld"}, "/words_so_far"),
            call("/flush", {}, "/sentence"),
        ),
    ),
    Case(
        "rospy/blinker.py",
        (
            wait("/blinker/colour", {"r": 1.0, "a": 1.0}),
            send("/blinker/set", {"g": 0.5, "a": 1.0}),
            wait("/blinker/colour", {"r": 0.0, "g": 0.5}),
            send("/blinker/enable", {"data": False}),
            wait("/blinker/colour", {"g": 0.0, "a": 0.0}),
        ),
    ),
    Case("rospy/square.py", tuple(send("/size", {"data": x}, "/corner") for x in (1.0, 2.0, 0.5))),
    Case(
        "rospy/histogram.py",
        tuple(
            send("/share", {"data": x}, "/share/bin", "/share/histogram")
            for x in (0.25, 7.0, -1.0, 0.5)
        ),
    ),
    Case(
        "rospy/watchdog.py",
        (
            wait("/bark", {"data": "woof"}),
            send("/feed", {}),
            wait("/bark", {"data": "..."}),
            call("/watchdog/sleep", {"data": True}),
            wait("/bark", {"data": "zzz"}),
        ),
    ),
    Case(
        "rospy/dead_reckoning.py",
        (
            send("/cmd_vel", {"linear": vector(2.0)}, "/pose2d"),
            send("/cmd_vel", {"angular": vector(0.0, 0.0, 1.0)}, "/pose2d"),
            send("/cmd_vel", {"linear": vector(-1.0)}, "/pose2d"),
            call("/reset_pose", {}, "/pose2d"),
        ),
    ),
    Case(
        "rospy/menu.py",
        (
            send("/order/tea", {"data": "Ann"}, "/bill", "/sum"),
            send("/order/cake", {"data": "Ann"}, "/bill", "/sum"),
            send("/order/cake", {"data": "Bert"}, "/bill", "/sum"),
        ),
    ),
    Case(
        "rospy/valve.py",
        (
            call("/valve/ask", {}),
            send("/pressure", {"data": 1.5}, "/valve/flow"),
            send("/pressure", {"data": 7.5}, "/valve/open", "/valve/flow"),
            call("/valve/ask", {}),
            call("/valve/set", {"data": True}, "/valve/open"),
            send("/pressure", {"data": 2.0}, "/valve/flow"),
        ),
    ),
    Case(
        "rospy/scan_slice.py",
        tuple(
            send(
                "/scan_full",
                {"header": HEADER, "range_max": 8.0, "ranges": ranges},
                "/scan_slice",
                "/front",
            )
            for ranges in ([1.0, 2.0, 3.0, 4.0], [4.0, 0.5, 0.25])
        ),
    ),
    Case("rospy/chatter.py", (wait("/chatter", {"data": "hello world from /chatter"}),)),
    Case("rospy/listener.py", tuple(send("/chat", {"data": x}, "/ack") for x in ("a", "", "%d"))),
    Case(
        "rospy/debouncer.py",
        (
            wait("/button/pressed", {"data": False}),
            send("/button/raw", {"data": True}, "/button/echo"),
            send("/button/raw", {"data": True}, "/button/echo"),
            send("/button/raw", {"data": True}, "/button/echo", "/button/pressed"),
            send("/button/raw", {"data": False}, "/button/echo", "/button/pressed"),
        ),
    ),
    Case(
        "rospy/tag_filter.py",
        tuple(
            send("/tag", {"header": {**HEADER, "frame_id": frame}, "pose": {"position": at}}, topic)
            for frame, at, topic in (
                ("door", vector(1.0), "/found"),
                ("cat", vector(2.0), "/unknown"),
                ("desk", vector(3.0), "/found"),
            )
        ),
    ),
    Case(
        "rospy/odd_even.py",
        tuple(
            send("/odd_even/number", {"data": x}, "/odd_even/odd" if x % 2 else "/odd_even/even")
            for x in (1, 2, -3, 2**40)
        ),
    ),
    Case(
        "rospy/clamp.py",
        tuple(send("/unclamped", {"data": x}, "/clamped") for x in (0.5, 9.0, -3.0)),
    ),
]
