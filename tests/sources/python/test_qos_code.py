"""Quality of service, as the client libraries take it."""

from __future__ import annotations

import math

import pytest

from plastron_tui.ros.qos import DEFAULT, PROFILES, Qos
from plastron_tui.sources.python.qos_code import keywords, new_keywords, profile

KEEP_ALL = Qos(history="keep_all")
LATCHED = Qos("reliable", "transient_local", "keep_last", 1)

PROFILES_OF = [
    (Qos(), "10"),
    (DEFAULT, "10"),
    (Qos(depth=3), "3"),
    (PROFILES["sensor_data"], "qos_profile_sensor_data"),
    (PROFILES["system_default"], "qos_profile_system_default"),
    (KEEP_ALL, "QoSProfile(history=HistoryPolicy.KEEP_ALL)"),
    (LATCHED, "QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)"),
    (
        Qos(deadline=0.5, lifespan=2.0, liveliness="manual_by_topic", lease=math.inf),
        "QoSProfile(depth=10, deadline=Duration(seconds=0.5), lifespan=Duration(seconds=2), "
        "liveliness=LivelinessPolicy.MANUAL_BY_TOPIC)",
    ),
    (Qos(lease=1.5), "QoSProfile(depth=10, liveliness_lease_duration=Duration(seconds=1.5))"),
]


@pytest.mark.parametrize(("qos", "written"), PROFILES_OF)
def test_rclpy_is_told_what_differs_from_its_default(qos: Qos, written: str) -> None:
    used: set[str] = set()

    def use(module: str, name: str) -> str:
        used.add(f"{module}.{name}")
        return name

    assert profile(qos, use) == written
    assert {each.rpartition(".")[0] for each in used} <= {"rclpy.qos", "rclpy.duration"}
    assert all(each.rpartition(".")[2] in written for each in used)


@pytest.mark.parametrize(
    ("qos", "changed", "publisher", "subscription"),
    [
        (Qos(), {}, {"queue_size": "10"}, {}),
        (
            LATCHED,
            {"queue_size": "1", "latch": "True"},
            {"queue_size": "1", "latch": "True"},
            {"queue_size": "1"},
        ),
        (Qos(durability="volatile"), {"latch": "False"}, {"queue_size": "10"}, {}),
        # ROS 1 has no word for it, whatever it comes close to.
        (Qos(durability="transient_local"), {}, {"queue_size": "10"}, {}),
        (PROFILES["system_default"], {}, {"queue_size": "10"}, {}),
    ],
)
def test_rospy_is_told_what_it_has(
    qos: Qos, changed: dict[str, str], publisher: dict[str, str], subscription: dict[str, str]
) -> None:
    assert keywords(qos, is_publisher=True) == changed
    assert new_keywords(qos, is_publisher=True) == publisher
    assert new_keywords(qos, is_publisher=False) == subscription
