"""Which class a manager or a container loads a node as that somebody wrote."""

from __future__ import annotations

from pathlib import Path

import pytest

from plastron_tui.session import Session
from plastron_tui.sources.cpp.mentioned import registered_classes
from plastron_tui.targets import find_target

NODES = Path(__file__).parents[1] / "nodes"


@pytest.mark.parametrize(
    ("text", "classes"),
    [
        (b"PLUGINLIB_EXPORT_CLASS(a::B, nodelet::Nodelet)\n", ["a::B"]),
        (b"PLUGINLIB_EXPORT_CLASS (\n  ::a::B,\n  nodelet::Nodelet);\n", ["a::B"]),
        (b"PLUGINLIB_DECLARE_CLASS(pkg, B, a::c::B, nodelet::Nodelet);\n", ["a::c::B"]),
        (b"  RCLCPP_COMPONENTS_REGISTER_NODE( a::B )\n", ["a::B"]),
        (b"CLASS_LOADER_REGISTER_CLASS(a::B, rclcpp::Node)\n", ["a::B"]),
        (b"// PLUGINLIB_EXPORT_CLASS(a::B, nodelet::Nodelet)\n", []),
        (b"REGISTER(A)\nREGISTER(B)\n", []),
    ],
)
def test_the_registered_classes_are_found(text: bytes, classes: list[str]) -> None:
    assert registered_classes(text) == classes


@pytest.mark.parametrize(
    ("file", "node", "loaded_as"),
    [
        ("component/health/src/cpu_health.cpp", "", "health::CpuHealth"),
        ("nodelet/lights_nodelet/src/lights_nodelet.cpp", "", "LightsNodelet"),
        ("nodelet/old_macro.cpp", "", "old::Watchdog"),
        ("nodelet/two_nodelets.cpp", " node 'Pong'", "pair::Pong"),
        ("roscpp/talker.cpp", "", None),
    ],
)
def test_a_loaded_node_is_loaded_as_what_it_registers(
    file: str, node: str, loaded_as: str | None
) -> None:
    text = f"load '{file}'{node} as it\n"
    session = Session(text.encode(), NODES / "x.plastron", environ={})
    loaded = session.workspace.nodes["it"]
    assert loaded.source is not None
    target = find_target(loaded.source.library)
    assert target is not None
    assert target.plugin_class(loaded) == loaded_as
