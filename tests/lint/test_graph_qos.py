"""What RG102 tells of the quality of service of two that are to hear each other."""

from __future__ import annotations

from pathlib import Path

import pytest
from graph_packages import LISTENER, TALKER, alone, code_of, found_in, package_of
from linted import run_over, write_tree

QOS = {
    "a_profile": (code_of(TALKER, qos="qos_profile_sensor_data"), "", 1),
    "a_policy": (
        code_of(TALKER, qos="QoSProfile(depth=5, reliability=ReliabilityPolicy.BEST_EFFORT)"),
        "",
        1,
    ),
    "a_policy_set_afterwards": (
        "",
        code_of(
            LISTENER,
            before="q = QoSProfile(depth=1); q.durability = DurabilityPolicy.TRANSIENT_LOCAL",
            qos="q",
        ),
        1,
    ),
    "both_of_them": (
        code_of(TALKER, qos="qos_profile_sensor_data"),
        code_of(LISTENER, qos="qos_profile_sensor_data"),
        0,
    ),
    "more_than_asked_for": ("", code_of(LISTENER, qos="qos_profile_sensor_data"), 0),
    "a_conflict_of_types": (
        code_of(TALKER, qos="qos_profile_sensor_data", type="Int32"),
        "",
        0,
    ),
    "a_second_publisher_of_the_node": (
        code_of(
            TALKER,
            qos="qos_profile_sensor_data",
            more="self.other = self.create_publisher(String, 'chatter', 10)",
        ),
        "",
        0,
    ),
}


@pytest.mark.parametrize(("talker", "listener", "count"), QOS.values(), ids=QOS)
def test_qos_never_matches(tmp_path: Path, talker: str, listener: str, count: int) -> None:
    assert len(found_in(tmp_path, package_of(talker, listener), "RG102")) == count


BEST_EFFORT = {"qos": "qos_profile_sensor_data"}
SHOWS = code_of(LISTENER, **BEST_EFFORT)
RELIABLE = code_of(TALKER)
PARTNERS = {
    "of_the_subscription_alone": ((RELIABLE,), True),
    "of_the_publisher_alone": ((SHOWS,), True),
    "of_both": ((RELIABLE, SHOWS), False),
    "of_another_type": ((code_of(TALKER, type="Int32"), SHOWS), True),
    "of_a_type_that_is_not_known": ((code_of(TALKER, type="self.type"), SHOWS), False),
    "of_a_quality_that_is_not_known": ((code_of(TALKER, qos="self.qos"), SHOWS), False),
    "in_a_node_with_several": (
        (
            code_of(
                TALKER,
                **BEST_EFFORT,
                more="self.other = self.create_publisher(String, 'chatter', 10)",
            ),
            SHOWS,
        ),
        False,
    ),
}


@pytest.mark.parametrize(("others", "is_told"), PARTNERS.values(), ids=PARTNERS)
def test_quality_of_service_of_nodes_that_no_launch_file_starts_together(
    tmp_path: Path, others: tuple[str, ...], is_told: bool
) -> None:
    """Two that both have partners may be of two robots."""
    files = {
        **alone("talks", "rclpy", code_of(TALKER, **BEST_EFFORT)),
        **alone("hears", "rclpy", code_of(LISTENER)),
    }
    for number, code in enumerate(others):
        files |= alone(f"other_{number}", "rclpy", code)
    run = run_over(write_tree(tmp_path, files), "RG102")
    found = [(x.diagnostic.file, x.diagnostic.labels[0].file) for x in run.told]
    sides = tuple(tmp_path / f"src/{name}/{name}/node.py" for name in ("hears", "talks"))
    assert found == [sides] * is_told
