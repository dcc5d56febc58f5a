"""C++ nodes that were written by hand, with roscpp and with rclcpp or its stand-in.

What they talk to (`peer_of_cpp.py`, the probes) is in Python, and knows nothing of Plastron.
"""

from __future__ import annotations

from pathlib import Path

import pytest
from cpp_builds import STAND_IN, CppLibrary, find_rclcpp, find_roscpp
from graph import Graph

pytestmark = [pytest.mark.live, pytest.mark.long]

CPP = Path(__file__).with_name("cpp")
SWITCH = ("/switch", "std_srvs/SetBool", {"data": True})


@pytest.fixture(scope="module")
def rclcpp(tmp_path_factory: pytest.TempPathFactory) -> CppLibrary:
    return find_rclcpp(tmp_path_factory)


def test_the_stand_in_has_the_signatures_of_rclcpp(rclcpp: CppLibrary) -> None:
    rclcpp.check([STAND_IN / "signatures.cpp"])


def test_a_node_talks_to_python(rclcpp: CppLibrary, ros2: Graph, tmp_path: Path) -> None:
    program = rclcpp.compile(tmp_path / "everything", CPP / "everything.cpp")
    options = ("--ros-args", "-p", "label:=given")
    node = ros2.run_program(program, *options, environ=rclcpp.environ)
    peer = ros2.run_with(Path(__file__).with_name("peer_of_cpp.py"))
    peer.wait_to_print("asked True")

    heard = ros2.listen({"ticks": "std_msgs/String"}, 0.5, ["best_effort"])
    assert {each.message["data"] for each in heard["ticks"]} == {"given"}
    assert ros2.call(*SWITCH) == {"success": True, "message": "given"}

    assert ros2.set_parameter("everything", "label", "other") is None
    assert ros2.set_parameter("everything", "label", "") == "a label is not empty"
    assert ros2.set_parameter("everything", "rate", 0.5) is not None
    assert ros2.set_parameter("everything", "rate", 5) is not None
    assert ros2.set_parameter("everything", "nothing", 5) is not None
    assert ros2.call(*SWITCH) == {"success": True, "message": "other"}

    asks = rclcpp.compile(tmp_path / "asks", CPP / "asks.cpp")
    asking = ros2.run_program(asks, environ=rclcpp.environ)
    assert asking.wait(60) == 0, asking.output
    assert "answered: other" in asking.output
    assert "waited for: other" in asking.output

    assert node.interrupt() == 0, node.output
    assert 'words: {data: "true"}' in node.output


def test_a_node_of_ros1_talks_to_python(
    ros1: Graph, tmp_path: Path, tmp_path_factory: pytest.TempPathFactory
) -> None:
    roscpp = find_roscpp(tmp_path_factory)
    program = roscpp.compile(tmp_path / "talker", CPP / "talker_1.cpp")
    node = ros1.run_program(program, environ=roscpp.environ)
    heard = ros1.listen({"ticks": "std_msgs/String"}, 0.5)
    assert {each.message["data"] for each in heard["ticks"]} == {"roscpp"}
    assert ros1.call(*SWITCH) == {"success": True, "message": "roscpp"}
    assert node.interrupt() == 0, node.output


def test_a_warning_fails_a_build(rclcpp: CppLibrary, tmp_path: Path) -> None:
    source = tmp_path / "warned.cpp"
    source.write_text("int main(int argc, char **) {int unused; return 0;}\n")
    with pytest.raises(AssertionError, match="unused"):
        rclcpp.check([source])
