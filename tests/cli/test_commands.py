"""`check`, `fmt`, `graph`, `inspect` and `types`, as one uses them."""

from __future__ import annotations

import json
import os
import pty
import stat
import subprocess
import xml.etree.ElementTree as ET
from pathlib import Path

import pytest
from command_line import BROKEN, LISTENER, PLASTRON, TALKER, Run, snapshot

from plastron_tui.output.graphs import FORMATS

UNTIDY = "create_node   'a'  as a // note\n\n\n\nsubscribe  a to 'x' of message_type String\n"
TIDY = "create_node 'a' as a // note\n\nsubscribe a to 'x' of message_type String\n"


def write(folder: Path, text: str, name: str = "a.plastron") -> None:
    (folder / name).write_bytes(text.encode())


def test_check_says_nothing_of_a_right_program(run: Run, here: Path) -> None:
    write(here, TALKER)
    result = run("check", "a.plastron")
    assert (result.returncode, result.stdout, result.stderr) == (0, b"", b"")


@pytest.mark.parametrize(("text", "told"), [(TALKER, b"no problems\r\n"), (BROKEN, b"")])
def test_check_says_on_a_terminal_that_nothing_is_wrong(here: Path, text: str, told: bytes) -> None:
    write(here, text)
    reader, terminal = pty.openpty()
    command = [*PLASTRON, "check", "a.plastron"]
    subprocess.run(command, stdin=subprocess.DEVNULL, stdout=terminal, stderr=subprocess.DEVNULL)
    os.write(terminal, b"|")
    shown = b""
    while not shown.endswith(b"|"):
        shown += os.read(reader, 1024)
    os.close(reader)
    os.close(terminal)
    assert shown == told + b"|"


def test_check_says_what_is_refused_of_a_loaded_file(run: Run, here: Path) -> None:
    write(here, "import rospy\nrospy.init_node('n')\n", "n.py")
    write(here, "load 'n.py' as n\ngenerate_node n using roscpp\n")
    told = [run(command, "a.plastron") for command in ("check", "generate")]
    assert [result.returncode for result in told] == [1, 1]
    assert told[0].stderr == told[1].stderr
    assert told[0].stderr.startswith(b"error[unsupported-target]")


def test_check_shows_place_and_remedy(run: Run, here: Path) -> None:
    write(here, BROKEN)
    result = run("check", "a.plastron")
    assert (result.returncode, result.stdout) == (1, b"")
    assert result.stderr.decode() == (
        "error[unknown-node]: no node `nod1`\n"
        " --> a.plastron:3:11\n"
        "  |\n"
        "3 | subscribe nod1 to 'other' of message_type String\n"
        "  |           ^^^^\n"
        "  = help: did you mean `node1`?\n"
        "\n"
        "found 1 error\n"
    )


def test_check_as_json(run: Run, here: Path) -> None:
    write(here, TALKER)
    assert run("check", "--format", "json", "a.plastron").stdout == b"[]\n"
    write(here, BROKEN, "b.plastron")
    result = run("check", "--format", "json", "a.plastron", "b.plastron")
    (found,) = json.loads(result.stdout)
    assert result.returncode == 1
    assert (found["file"], found["code"]) == ("b.plastron", "unknown-node")
    assert found["range"] == {
        "start": {"line": 3, "column": 11},
        "end": {"line": 3, "column": 15},
    }
    assert result.stdout.isascii()


def test_check_for_another_target(run: Run, here: Path) -> None:
    write(here, TALKER.replace("String", "builtin_interfaces/Time").replace('"hello"', "none"))
    assert run("check", "a.plastron").returncode == 1
    assert run("check", "--target", "rclpy", "a.plastron").returncode == 0
    assert run("check", "a.plastron", env={"ROS_VERSION": "2"}).returncode == 0


def test_colors_follow_the_environment(run: Run, here: Path) -> None:
    write(here, BROKEN)
    assert b"\x1b" not in run("check", "a.plastron").stderr
    forced = run("check", "a.plastron", env={"FORCE_COLOR": "1"}).stderr
    assert b"\x1b[31;1merror[unknown-node]" in forced
    both = run("check", "a.plastron", env={"FORCE_COLOR": "1", "NO_COLOR": "1"}).stderr
    assert b"\x1b" not in both


def test_control_characters_of_a_program_do_not_reach_the_terminal(run: Run, here: Path) -> None:
    write(here, "create_node 'a\x1b[31m\x9b\u202e' as a\nfoo \x07\x1b]0;title\x07\n")
    for command in ("check", "generate", "graph"):
        result = run(command, "a.plastron", env={"FORCE_COLOR": ""})
        assert result.returncode == 1
        shown = (result.stdout + result.stderr).decode().replace("\n", "")
        assert shown.isprintable()


def test_fmt_writes_tidy_programs(run: Run, here: Path) -> None:
    write(here, UNTIDY)
    (here / "a.plastron").chmod(0o640)
    first = run("fmt", "a.plastron")
    assert (first.returncode, first.stdout) == (0, b"reformatted a.plastron\n")
    assert (here / "a.plastron").read_text() == TIDY
    assert stat.S_IMODE((here / "a.plastron").stat().st_mode) == 0o640
    again = run("fmt", "a.plastron")
    assert (again.returncode, again.stdout) == (0, b"")
    assert [path.name for path in here.iterdir()] == ["a.plastron"]


def test_fmt_keeps_crlf(run: Run, here: Path) -> None:
    write(here, UNTIDY.replace("\n", "\r\n"))
    assert run("fmt", "a.plastron").returncode == 0
    assert (here / "a.plastron").read_bytes() == TIDY.replace("\n", "\r\n").encode()


def test_fmt_of_standard_input_goes_to_standard_output(run: Run, here: Path) -> None:
    result = run("fmt", "-", stdin=UNTIDY.encode())
    assert (result.returncode, result.stdout.decode()) == (0, TIDY)
    checked = run("fmt", "--check", "-", stdin=UNTIDY.encode())
    assert (checked.returncode, checked.stdout) == (1, b"would reformat standard input\n")


def test_fmt_check_writes_nothing(run: Run, here: Path) -> None:
    write(here, UNTIDY)
    write(here, TIDY, "b.plastron")
    before = snapshot(here)
    result = run("fmt", "--check", "a.plastron", "b.plastron")
    assert (result.returncode, result.stdout) == (1, b"would reformat a.plastron\n")
    assert snapshot(here) == before


def test_fmt_leaves_a_file_with_a_line_that_does_not_parse(run: Run, here: Path) -> None:
    text = UNTIDY + "subscribe   a  to\n" + "unsubscribe a  from 'x'"
    write(here, text)
    for arguments in (("fmt",), ("fmt", "--check")):
        result = run(*arguments, "a.plastron")
        assert (result.returncode, result.stdout) == (1, b"")
        assert b"error[" in result.stderr
        assert (here / "a.plastron").read_text() == text
    result = run("fmt", "-", stdin=text.encode())
    assert (result.returncode, result.stdout.decode()) == (
        1, TIDY + "subscribe   a  to\nunsubscribe a from 'x'\n",
    )  # fmt: skip


def test_fmt_follows_a_link_and_takes_a_file_once(run: Run, here: Path) -> None:
    (here / "real").mkdir()
    write(here, UNTIDY, "real/a.plastron")
    (here / "a.plastron").symlink_to("real/a.plastron")
    assert run("fmt", "a.plastron", "a.plastron").returncode == 0
    assert (here / "a.plastron").is_symlink()
    assert (here / "real" / "a.plastron").read_text() == TIDY


def test_fmt_does_not_judge_what_a_program_means(run: Run, here: Path) -> None:
    write(here, BROKEN)
    assert run("fmt", "a.plastron").returncode == 0


@pytest.mark.parametrize("format_", FORMATS)
@pytest.mark.parametrize("text", [TALKER + LISTENER, TALKER + LISTENER + "nonsense here\n", ""])
def test_graph_shows_what_is_right(run: Run, here: Path, format_: str, text: str) -> None:
    write(here, text)
    result = run("graph", "--format", format_, "a.plastron")
    assert result.returncode == (1 if "nonsense" in text else 0)
    assert (b"error[" in result.stderr) == ("nonsense" in text)
    shown = result.stdout.decode()
    assert all(name in shown for name in ("talker", "listener", "chatter")) == bool(text)
    if format_ == "json":
        assert len(json.loads(shown)["nodes"]) == (2 if text else 0)
    if format_ == "svg":
        assert ET.fromstring(shown).tag.endswith("svg")


def test_graph_joins_programs(run: Run, here: Path) -> None:
    write(here, TALKER, "a.plastron")
    write(here, LISTENER.replace("as listener", "as talker").replace("subscribe listener",
          "subscribe talker").replace("node listener", "node talker"), "b.plastron")  # fmt: skip
    result = run("graph", "--format", "json", "a.plastron", "b.plastron")
    graph = json.loads(result.stdout)
    assert [node["name"] for node in graph["nodes"]] == ["talker", "listener"]
    assert [node["variable"] for node in graph["nodes"]] == ["talker", "b.talker"]
    (topic,) = graph["topics"]
    assert (topic["missing"], topic["publishers"][0]["node"]) == (None, "talker")
    assert all(node["generated"] for node in graph["nodes"])


def test_inspect_of_what_was_generated(run: Run, here: Path) -> None:
    write(here, TALKER + LISTENER)
    assert run("generate", "a.plastron").returncode == 0
    text = run("inspect", "output/talker_pub.py", "output/listener_sub1.py").stdout.decode()
    assert "output/talker_pub.py (rospy)" in text
    assert "std_msgs/String" in text
    one = json.loads(run("inspect", "-f", "json", "output/talker_pub.py").stdout)
    assert (one["file"], one["client_library"]) == ("output/talker_pub.py", "rospy")
    (publisher,) = one["nodes"][0]["publishers"]
    assert (publisher["topic"], publisher["type"]) == ("chatter", "std_msgs/String")
    both = run("inspect", "-f", "json", "output/talker_pub.py", "output/listener_sub1.py").stdout
    assert len([json.loads(line) for line in both.splitlines()]) == 2
    program = run("inspect", "-f", "plastron", "output/listener_sub1.py").stdout
    assert run("check", "-", stdin=program).returncode == 0
    assert b"'chatter' of message_type" in program


def test_inspect_of_several_goes_on_after_one_that_fails(run: Run, here: Path) -> None:
    write(here, LISTENER)
    assert run("generate", "a.plastron").returncode == 0
    result = run("inspect", "missing.py", "output/listener_sub1.py")
    assert result.returncode == 2
    assert b"chatter" in result.stdout
    assert b"missing.py" in result.stderr


def test_inspect_shows_no_control_characters(run: Run, here: Path) -> None:
    write(here, LISTENER)
    assert run("generate", "a.plastron").returncode == 0
    file = here / "output" / "listener_sub1.py"
    file.write_text(file.read_text().replace('"chatter"', 'name("\x1b[31m\u202e")'))
    for format_ in ("text", "json", "plastron"):
        shown = run("inspect", "-f", format_, file).stdout.decode()
        assert "\x1b" not in shown
        assert "\u202e" not in shown


def test_check_says_what_generate_would(run: Run, here: Path) -> None:
    write(here, "create_node 'a' as a\n", "idle.plastron")
    for command in ("check", "generate"):
        idle = run(command, "idle.plastron")
        assert idle.returncode == 0
        assert b"warning[nothing-to-generate]" in idle.stderr
    assert (
        json.loads(run("check", "-f", "json", "idle.plastron").stdout)[0]["severity"] == "warning"
    )


def test_types_lists_and_shows(run: Run) -> None:
    listed = run("types").stdout.decode().split()
    assert "geometry_msgs/msg/Twist" in listed
    assert "std_srvs/srv/SetBool" in listed
    assert set(run("types", "nav_msgs/*").stdout.decode().split()) <= set(listed)
    assert run("types", "laser").stdout.decode().split() == [
        name for name in listed if "laser" in name.lower()
    ]
    shown = run("types", "geometry_msgs/Twist").stdout.decode()
    assert shown.startswith("geometry_msgs/msg/Twist\n")
    assert shown.count("velocity in free space") == 1
    assert "geometry_msgs/Vector3 linear" in shown
    assert run("types", "SetBool").stdout.decode().count("---") == 1


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["Twits"], "no type matches 'Twits' in noetic; did you mean 'Twist'?"),
        (["geometry_msg/Twist"], "did you mean 'geometry_msgs/Twist'?"),
        (["zzz*"], "no type matches 'zzz*' in noetic"),
        (["\x1b[31m"], r"no type matches '\x1b[31m' in noetic"),
    ],
)
def test_types_without_a_match_is_1(run: Run, arguments: list[str], said: str) -> None:
    result = run("types", *arguments)
    assert (result.returncode, result.stdout) == (1, b"")
    assert said in result.stderr.decode()


def test_types_by_what_they_are_for(run: Run) -> None:
    lines = run("types", "on/off").stdout.decode().splitlines()
    assert lines[0].split("  ", 1)[0] == "std_msgs/msg/Bool"
    assert any("std_srvs/srv/SetBool  " in line and "Switch something" in line for line in lines)


def test_types_by_a_pattern_of_the_bare_name(run: Run) -> None:
    found = run("types", "Laser*").stdout.decode().split()
    assert "sensor_msgs/msg/LaserScan" in found
    assert all(name.split("/")[-1].startswith("Laser") for name in found)


@pytest.mark.parametrize(
    ("arguments", "project", "said"),
    [
        ((), "", "types of ROS 1 noetic: it is installed; `--target rclpy` shows those of ROS 2\n"),
        ((), "distribution: noetic\n", "types of ROS 1 noetic: plastron.yaml says so\n"),
        ((), "distribution: humble\n", "types of ROS 2 humble: plastron.yaml says so\n"),
        (("-t", "rospy"), "distribution: humble\n", "types of ROS 1 noetic: the command line "),
        (("-d", "kilted"), "", ""),
    ],
)
def test_types_say_which_ros_they_are_of(
    run: Run, here: Path, arguments: tuple[str, ...], project: str, said: str
) -> None:
    (here / "plastron.yaml").write_text(project)
    for what in ("Twist", "twist"):
        told = run("types", what, *arguments).stderr.decode()
        assert told.startswith(said) if said else not told


def test_types_of_a_distribution(run: Run) -> None:
    assert run("types", "-d", "jazzy", "builtin_interfaces/Time").returncode == 0
    assert run("types", "-d", "noetic", "builtin_interfaces/Time").returncode == 1
    assert run("types", "-t", "rclpy", "builtin_interfaces/Time").returncode == 0


def test_project_file_counts_for_every_command(run: Run, here: Path) -> None:
    (here / "plastron.yaml").write_text("target: rclpy\ndistribution: humble\noutput: nodes\n")
    (here / "deep").mkdir()
    write(here, TALKER, "deep/a.plastron")
    assert run("generate", "deep/a.plastron").stdout == b"   create  nodes/talker_pub.py\n"
    assert "rclpy" in (here / "nodes" / "talker_pub.py").read_text()
    assert run("types", "nonsense").stderr == b"no type matches 'nonsense' in humble\n"
    assert run("generate", "--target", "rospy", "-o", "x", "deep/a.plastron").returncode == 0
    assert "rospy" in (here / "x" / "talker_pub.py").read_text()


def test_mistake_in_the_project_file_is_told_once(run: Run, here: Path) -> None:
    (here / "plastron.yaml").write_text("targt: rospy\n")
    write(here, TALKER)
    write(here, LISTENER, "b.plastron")
    for command in ("check", "generate"):
        result = run(command, "a.plastron", "b.plastron")
        assert result.returncode == 1
        assert result.stderr.decode() == (
            "error[bad-project]: `targt` is no key of a project file\n"
            f" --> {here}/plastron.yaml:1:1\n"
            "  |\n"
            "1 | targt: rospy\n"
            "  | ^^^^^\n"
            "  = help: did you mean `target`?\n"
            "\n"
            "found 1 error\n"
        )
    assert run("types", "Twist").returncode == 1
    assert run("shell", stdin=b"").returncode == 1
    assert not (here / "output").exists()


def test_own_types(run: Run, here: Path) -> None:
    (here / "interfaces" / "my_msgs" / "msg").mkdir(parents=True)
    definition = here / "interfaces" / "my_msgs" / "msg" / "Wheel.msg"
    definition.write_text("int32 turns\nstring name\n")
    (here / "plastron.yaml").write_text("types: interfaces\n")
    text = TALKER.replace("String", "Wheel").replace('"hello"', '3, "left"')
    write(here, text)
    assert run("generate", "a.plastron").returncode == 0
    node = (here / "output" / "talker_pub.py").read_text()
    assert "from my_msgs.msg import Wheel" in node
    assert 'Wheel(turns=3, name="left")' in node
    assert b"int32 turns" in run("types", "Wheel").stdout
    definition.write_text("int32\n")
    result = run("check", "a.plastron")
    assert result.returncode == 1
    assert b"error[bad-definition]" in result.stderr
    assert b"Wheel.msg:1:1" in result.stderr


def test_own_templates(run: Run, here: Path) -> None:
    (here / "plastron.yaml").write_text("templates: mine\n")
    (here / "mine" / "rospy").mkdir(parents=True)
    template = here / "mine" / "rospy" / "node.py.j2"
    template.write_text("# mine\n")
    write(here, TALKER)
    env = {"XDG_STATE_HOME": str(here / "state")}
    assert run("trust", env=env).returncode == 0
    assert run("generate", "a.plastron", env=env).returncode == 0
    assert (here / "output" / "talker_pub.py").read_text() == "# mine\n"
    template.write_text("{{ nonsense }}")
    result = run("generate", "a.plastron", env=env)
    assert (result.returncode, b"error[template-error]" in result.stderr) == (1, True)


def test_commands_work_without_a_shell_around_them(here: Path) -> None:
    write(here, TALKER)
    result = subprocess.run(
        [*PLASTRON, "check", "a.plastron"], stdin=subprocess.DEVNULL, capture_output=True, env={}
    )
    assert (result.returncode, result.stderr) == (0, b"")


def test_check_tells_of_types_that_a_sourced_ros_does_not_have(here: Path, run: Run) -> None:
    write(here, "create_node 'a' as a\nsubscribe a to 'odom' of message_type Odometry\n")
    (here / "ros" / "share" / "std_msgs").mkdir(parents=True)
    ros = str(here / "ros")
    sourced = {"ROS_VERSION": "2", "ROS_DISTRO": "kilted", "AMENT_PREFIX_PATH": ros}
    assert b"missing-ros-package" in run("check", "a.plastron", env=sourced).stderr
    assert b"missing-ros-package" not in run("check", "a.plastron").stderr
