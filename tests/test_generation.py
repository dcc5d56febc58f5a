"""Generating into a folder: what lies there is not always what Plastron would put there."""

from __future__ import annotations

import os
import stat
from pathlib import Path
from typing import Any

import pytest

from plastron_tui.model.workspace import Node
from plastron_tui.output.node_json import recall
from plastron_tui.output.writer import write
from plastron_tui.session import Options, Session

PROGRAM = """\
create_node 'talker' as n
subscribe n to 'a' of message_type String
generate_node n
"""


def session(folder: Path, text: str, *, in_place: bool = False) -> Session:
    chosen = Options("rospy", folder / "output", in_place=in_place)
    return Session(text.encode(), folder / "a.plastron", chosen, environ={})


@pytest.fixture
def generated(tmp_path: Path) -> Path:
    plan, _ = session(tmp_path, PROGRAM).plan()
    assert write(plan).diagnostics == ()
    return tmp_path / "output" / "talker_sub1.py"


def test_pipe_in_the_output_folder_is_told_and_not_read(tmp_path: Path) -> None:
    (tmp_path / "output").mkdir()
    os.mkfifo(tmp_path / "output" / "talker_sub1.py")
    _, diagnostics = session(tmp_path, PROGRAM).plan()
    assert [found.code for found in diagnostics] == ["cannot-write"]


@pytest.mark.parametrize("mode", [0o640, 0o750])
@pytest.mark.parametrize("in_place", [True, False])
@pytest.mark.parametrize("folder", ["mine", "output"])
def test_file_that_is_written_over_where_it_came_from_keeps_its_mode(
    tmp_path: Path, generated: Path, mode: int, in_place: bool, folder: str
) -> None:
    (tmp_path / folder).mkdir(exist_ok=True)
    file = generated.rename(tmp_path / folder / "talker_sub1.py")
    file.chmod(mode)
    text = f"load '{folder}/talker_sub1.py' as n\nsubscribe n to 'b' of message_type Int32\n"
    plan, _ = session(tmp_path, f"{text}generate_node n\n", in_place=in_place).plan()
    assert write(plan).diagnostics == ()
    written = file if in_place else generated
    assert b"Int32" in written.read_bytes()
    if written == file:
        assert stat.S_IMODE(file.stat().st_mode) == mode


def test_rate_that_no_float_holds_is_a_broken_entry() -> None:
    base: dict[str, Any] = {"node": "n", "library": "rospy", "publishers": {}}
    assert isinstance(recall(base), Node)
    sends = [[10**400, {"std_msgs/String": {}}]]
    base["publishers"] = {"a": {"type": "std_msgs/String", "sends": sends}}
    assert recall(base) is None


@pytest.mark.parametrize("handwork", ["", "# mine\n"])
def test_two_programs_with_a_node_of_one_name_keep_their_files_apart(
    tmp_path: Path, generated: Path, handwork: str
) -> None:
    before = generated.read_text() + handwork
    generated.write_text(before)
    text = PROGRAM.replace("'a'", "'b'")

    def other(*, force: bool) -> Session:
        options = Options("rospy", tmp_path / "output", force=force)
        return Session(text.encode(), tmp_path / "b.plastron", options, environ={})

    plan, diagnostics = other(force=False).plan()
    (conflict,) = plan.conflicts
    assert (conflict.code, diagnostics) == ("file-conflict", ())
    assert conflict.message.endswith("another program, `a.plastron`")
    plan, _ = other(force=True).plan()
    assert write(plan, force=True).diagnostics == ()
    assert '"b"' in generated.read_text()
    assert (generated.parent / "talker_sub1.py.bak").read_text() == before
    plan, _ = other(force=False).plan()
    assert [file.state.value for file in plan.files] == ["identical"]
    assert "`b.plastron`" in session(tmp_path, PROGRAM).plan()[0].conflicts[0].message


CROWDED = """\
import rospy
from std_msgs.msg import Bool, String


def on_gone(message):
    pass


rospy.init_node("crowded")
# A publisher that goes.
first = rospy.Publisher("first", String, queue_size=1)
first.publish("hello")
second = rospy.Publisher("second", Bool, queue_size=1)
rospy.Subscriber("gone", String, on_gone)
rospy.Subscriber("kept", String, print)
print(second.get_num_connections())
rospy.spin()
"""


def test_broken_manifest_behind_a_link_is_told_once(tmp_path: Path) -> None:
    (tmp_path / "real").mkdir()
    (tmp_path / "real" / ".plastron.json").write_text("broken")
    (tmp_path / "output").symlink_to(tmp_path / "real")
    (tmp_path / "mine.py").write_text(CROWDED)
    text = f"{PROGRAM}load 'mine.py' as other\ngenerate_node other\n"
    plan, diagnostics = session(tmp_path, text).plan()
    assert len(plan.files) == 2
    assert [found.code for found in diagnostics] == ["bad-manifest"]


@pytest.mark.parametrize("using", ["", " using rclpy"])
def test_refusal_names_the_lines_of_the_file_as_it_is(tmp_path: Path, using: str) -> None:
    (tmp_path / "mine.py").write_text(CROWDED)
    text = (
        "load 'mine.py' as n\nn stop_publishing to 'first'\nunsubscribe n from 'gone'\n"
        f"n stop_publishing to 'second'\ngenerate_node n{using}\n"
    )
    line = CROWDED[: CROWDED.index("print(")].count("\n") + 1
    for in_place in (False, True):
        plan, (found,) = session(tmp_path, text, in_place=in_place).plan()
        assert plan.files == ()
        assert (found.code, found.message) == (
            "endpoint-in-use", f"the publisher `second` is used in line {line}",
        )  # fmt: skip
        assert found.span is not None
        assert text.encode()[slice(*found.span)] == b"n stop_publishing to 'second'"


def test_refusal_names_the_lines_of_what_was_written_before(tmp_path: Path) -> None:
    file = tmp_path / "mine.py"
    file.write_text(CROWDED)
    less = "load 'mine.py' as n\nn stop_publishing to 'first'\nunsubscribe n from 'gone'\n"
    plan, _ = session(tmp_path, f"{less}generate_node n\n", in_place=True).plan()
    assert write(plan).diagnostics == ()
    text = f"{less}n stop_publishing to 'second'\ngenerate_node n\n"
    _, (found,) = session(tmp_path, text, in_place=True).plan()
    now = file.read_text()
    line = now[: now.index("print(")].count("\n") + 1
    assert line < CROWDED[: CROWDED.index("print(")].count("\n") + 1
    assert found.message == f"the publisher `second` is used in line {line}"


OTHER_TYPES = """\
import rospy
import std_msgs.msg
from std_msgs import msg
from beginner_tutorials.srv import AddTwoInts

rospy.init_node('mine')
rospy.Subscriber('a', std_msgs.msg.Time, print)
rospy.Subscriber('b', msg.Duration, print)
rospy.Subscriber('c', std_msgs.msg.String, print)
rospy.ServiceProxy('d', AddTwoInts)
rospy.spin()
"""


def test_what_is_to_be_ported_by_hand_has_its_place_in_the_file_as_it_is(tmp_path: Path) -> None:
    (tmp_path / "mine.py").write_text(OTHER_TYPES)
    _, found = session(tmp_path, "load 'mine.py' as n\ngenerate_node n using rclpy\n").plan()
    places = [None if each.span is None else OTHER_TYPES[slice(*each.span)] for each in found]
    assert places == [
        "rospy.Subscriber('a', std_msgs.msg.Time, print)",
        "rospy.Subscriber('b', msg.Duration, print)",
    ]
    changed = "load 'mine.py' as n\nunsubscribe n from 'c'\ngenerate_node n using rclpy\n"
    _, found = session(tmp_path, changed).plan()
    assert [(each.code, each.span) for each in found] == [("port-by-hand", None)] * 2


def test_types_that_the_other_ros_names_otherwise_are_told(tmp_path: Path) -> None:
    (tmp_path / "mine.py").write_text(OTHER_TYPES)
    plan, found = session(tmp_path, "load 'mine.py' as n\ngenerate_node n using rclpy\n").plan()
    (file,) = plan.files
    assert [(each.code, each.message.split("`")[1], each.help) for each in found] == [
        ("port-by-hand", "std_msgs/Time", "it is `builtin_interfaces/Time` there"),
        ("port-by-hand", "std_msgs/Duration", "it is `builtin_interfaces/Duration` there"),
    ]
    assert b"from example_interfaces.srv import AddTwoInts" in file.text


DOUBTS = """\
create_node 'robot' as n using {}
subscribe n to 'joy' of message_type Joy
create_message m of message_type Twist and input linear=(received.axes[1], received.axes[4], 0)
n publish m to 'v' of message_type Twist for_each 'joy' when received.buttons[2] = 1
create_message j of message_type Int8 and input received.buttons[0] + 1
n publish j to 'w' of message_type Int8 for_each 'joy'
n provides_service 'add' of service_type AddTwoInts answering sum=received.a * 2
generate_node n
"""


@pytest.mark.parametrize("library", ["rospy", "rclpy"])
def test_a_warning_names_what_may_not_be_there(tmp_path: Path, library: str) -> None:
    plan, diagnostics = session(tmp_path, DOUBTS.format(library)).plan()
    assert not diagnostics
    text = next(file.text for file in plan.files if file.path.suffix == ".py").decode()
    for name, unsure in {
        "v": "received.buttons[2], received.axes[1], received.axes[4]",
        "w": "received.buttons[0]",
        "add": "received.a",
    }.items():
        assert f"{name}, of {unsure}: " in text
