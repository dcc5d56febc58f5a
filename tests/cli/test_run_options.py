"""`plastron run` and `plastron graph` with names and parameters of the user's."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from command_line import LISTENER, TALKER, Run
from machine import mostly_long, wait_until
from ros_runs import Ros, make_ros, said_by

from plastron_tui.runtime.parameters import SetStatus
from plastron_tui.session import Options, Session

# Nodes of one's own, with parameters that change while they run.
GAIN = {
    "rclpy": """\
#!/usr/bin/env python3
import rclpy
from rcl_interfaces.msg import SetParametersResult
from rclpy.node import Node
from std_msgs.msg import String


class Gain(Node):
    def __init__(self):
        super().__init__("gain")
        self.declare_parameter("speed", 1.0)
        self.declare_parameter("label", "none")
        self.declare_parameter("pid.steps", [0])
        self.add_on_set_parameters_callback(self.check)
        self.publisher = self.create_publisher(String, "state", 10)
        self.create_subscription(String, "~/stop", self.on_stop, 10)
        self.create_timer(0.1, self.tick)

    def check(self, parameters):
        is_fast = any(each.name == "speed" and each.value > 5 for each in parameters)
        return SetParametersResult(successful=not is_fast, reason="too fast" if is_fast else "")

    def on_stop(self, message):
        pass

    def tick(self):
        speed = self.get_parameter("speed").value
        label = self.get_parameter("label").value
        steps = list(self.get_parameter("pid.steps").value)
        text = ascii((speed, label, steps))
        print(text, flush=True)
        self.publisher.publish(String(data=text))


def main(args=None):
    rclpy.init(args=args)
    rclpy.spin(Gain())


if __name__ == "__main__":
    main()
""",
    "rospy": """\
#!/usr/bin/env python3
import rospy
from std_msgs.msg import String


def on_stop(message):
    pass


def main():
    rospy.init_node("gain")
    publisher = rospy.Publisher("state", String, queue_size=10)
    rospy.Subscriber("~stop", String, on_stop)
    rate = rospy.Rate(10)
    while not rospy.is_shutdown():
        speed = rospy.get_param("~speed", 1.0)
        label = rospy.get_param("~label", "none")
        steps = rospy.get_param("~pid/steps", [0])
        text = ascii((speed, label, steps))
        print(text, flush=True)
        publisher.publish(text)
        rate.sleep()


if __name__ == "__main__":
    main()
""",
}

PROGRAM = """\
load 'gain.py' as g
generate_node g
create_node 'listener' as l
subscribe l to 'heard' of message_type String
generate_node l
"""

LABEL = 'a:=b "c" # \\ é 😀'


def test_names_that_are_none_are_wrong_usage(run: Run, here: Path) -> None:
    (here / "p.plastron").write_text(TALKER)
    for arguments, said in (
        (["--remap", "a"], b"FROM:=TO"),
        (["--remap", "chatter:=a b"], b"white space"),
        (["--remap", "chatter:=a", "--remap", "/chatter:=b"], b"the same name"),
        (["--remap", "__ns:=/a"], b"--namespace"),
        (["--namespace", "a b"], b"no namespace"),
    ):
        for command in ("run", "graph"):
            done = run(command, "p.plastron", *arguments)
            assert done.returncode == 2, arguments
            assert said in done.stderr
            assert not done.stdout
    assert not (here / "output").exists()


@pytest.mark.parametrize(
    ("setting", "said"),
    [
        ("speed=1", b"NODE.NAME=VALUE"),
        ("talker.a b=1", b"no name of a parameter"),
        ("talker.speed=[1, 2.0]", b"write each number with a point"),
        ("talker.speed=[1, a]", b"a list is of one type"),
        ("talker.speed=a: b", b"in quotes"),
        ("talker.__name=x", b"names in ROS 1"),
        ("talker.n=3000000000", b"32 bits"),
    ],
)
def test_a_value_that_is_none_is_wrong_usage(
    run: Run, here: Path, setting: str, said: bytes
) -> None:
    (here / "p.plastron").write_text(TALKER)
    done = run("run", "p.plastron", "--set", setting, "--target", "rospy")
    assert done.returncode == 2
    assert said in done.stderr
    assert not (here / "output").exists()


@pytest.mark.parametrize("option", [["--set", "talkr.a=1"], ["--remap", "talkr:a:=b"]])
def test_a_node_that_is_not_there(run: Run, here: Path, option: list[str]) -> None:
    (here / "p.plastron").write_text(TALKER)
    done = run("run", "p.plastron", *option)
    assert done.returncode == 1
    assert b"error[unknown-node]: the program generates no node `talkr`" in done.stderr
    assert b"did you mean `talker`?" in done.stderr
    assert not (here / "output").exists()


def test_the_graph_shows_the_names_of_a_run(run: Run, here: Path) -> None:
    (here / "p.plastron").write_text(TALKER + LISTENER)
    options = ["--remap", "talker:chatter:=/news", "--namespace", "robot1", "--format", "json"]
    graph = json.loads(run("graph", "p.plastron", *options).stdout)
    assert [node["name"] for node in graph["nodes"]] == ["/robot1/talker", "/robot1/listener"]
    assert {topic["name"]: topic["missing"] for topic in graph["topics"]} == {
        "/news": "subscriber",
        "/robot1/chatter": "publisher",
    }


def test_a_remap_of_no_name_is_a_warning(run: Run, here: Path) -> None:
    (here / "p.plastron").write_text(TALKER + LISTENER)
    done = run("graph", "p.plastron", "--remap", "chattr:=news", "--remap", "listener:chatter:=x")
    assert done.returncode == 0
    assert done.stderr.count(b"warning[unmet-remap]") == 1
    assert b"did you mean `chatter`?" in done.stderr


@pytest.mark.parametrize(
    "publisher",
    [
        "    publisher = rospy.Publisher(name_of(1)",
        '    topic = rospy.get_param("~topic", "stop")\n    publisher = rospy.Publisher(topic',
        # Another file may call it with another name.
        '\n\ndef start(topic="stop"):\n    publisher = rospy.Publisher(topic',
    ],
)
def test_a_name_that_is_not_known_may_be_the_one(run: Run, here: Path, publisher: str) -> None:
    text = GAIN["rospy"].replace('    publisher = rospy.Publisher("state"', publisher)
    assert publisher in text
    (here / "gain.py").write_text(text)
    (here / "p.plastron").write_text(PROGRAM)
    assert b"unmet" not in run("graph", "p.plastron", "--remap", "other:=news").stderr


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("gain: [\n", b"this is no YAML"),
        ("gain: {ros__parameters: {speed: [1, x]}}\n", b"p.yaml:1:33"),
        ("\n/**:\n  ros__parameters:\n    a: &a 1\n", b"p.yaml:4:8"),
        ("gain: {ros__parameters: {big: 3000000000}}\n", b"32 bits"),
        ("\xff", b"not UTF-8"),
        ("#" * (1 << 19), b"it is larger than 256 kB"),
    ],
)
def test_a_parameter_file_with_a_mistake_starts_nothing(
    run: Run, here: Path, text: str, said: bytes
) -> None:
    (here / "gain.py").write_text(GAIN["rospy"])
    (here / "p.plastron").write_text(PROGRAM)
    (here / "config").mkdir()
    (here / "config" / "p.yaml").write_text(text, encoding="latin-1")
    done = run("run", "p.plastron", "--target", "rospy")
    assert done.returncode == 1
    assert b"error[bad-parameters]" in done.stderr
    assert said in done.stderr
    assert not (here / "output").exists()


def test_a_parameter_file_outside_of_the_project_is_not_read(run: Run, here: Path) -> None:
    own = here / "own"
    (own / "config").mkdir(parents=True)
    (here / "p.yaml").write_text("gain: [")
    (own / "config" / "p.yaml").symlink_to(here / "p.yaml")
    (own / "gain.py").write_text(GAIN["rospy"])
    # Another mistake, so that nothing is run.
    (own / "p.plastron").write_text(PROGRAM)
    done = run("run", "p.plastron", "--set", "g.n=3000000000", "--target", "rospy", cwd=own)
    assert done.returncode == 2
    session = Session((own / "p.plastron").read_bytes(), own / "p.plastron")
    params, (found,) = session.params()
    assert (params, found.code) == ((), "outside-project")


@pytest.fixture(params=["rospy", "rclpy"])
def ros(request: pytest.FixtureRequest, tmp_path: Path) -> Ros:
    made = make_ros(request.param, tmp_path)
    made.write("gain.py", GAIN[made.library])
    made.write("p.plastron", PROGRAM)
    return made


def is_said(ros: Ros, *state: object) -> bool:
    """Tell whether the node has these values, and the listener hears it."""
    said = ros.said("p.plastron")
    return ascii(state) in said_by(said, "gain") and any(
        f"({state[0]}, " in line for line in said_by(said, "listener")
    )


@pytest.mark.parametrize("ros", mostly_long(["rospy", "rclpy"], ["rospy"]), indirect=True)
@pytest.mark.live
def test_a_run_has_the_names_and_values_that_are_asked_for(ros: Ros) -> None:
    (ros.folder / "config").mkdir()
    (ros.folder / "config" / "p.yaml").write_text(
        "/**:\n  ros__parameters:\n    speed: 2.0\n    label: from the file\n"
        "gain:\n  ros__parameters:\n    pid: {steps: [-1, 2]}\n"
    )
    names = ["--namespace", "/robot1", "--remap", "state:=heard", "--remap", "g:~/stop:=/halt"]
    values = ["--set", "g.speed=-0.5", "--set", f"gain.label={yaml_quoted(LABEL)}"]
    # A node that is watched is started in another way.
    watch = ["--watch"] if ros.library == "rclpy" else []
    with ros.running("p.plastron", *names, *values, *watch):
        wait_until(lambda: is_said(ros, -0.5, LABEL, [-1, 2]), "the values are there")
        wait_until(lambda: is_described(ros), "the graph has the names", 60)
        session = session_of(ros)
        outcomes = [
            session.set_parameter(node, name, value, namespace="/robot1")
            for node, name, value in (
                ("g", "label", f"{LABEL}\n"),
                ("gain", "pid.steps", (7, 8)),
                ("gain", "speed", 3),
            )
        ]
        assert [each.status for each in outcomes] == [SetStatus.DONE] * 3, outcomes
        speed = 3 if ros.library == "rospy" else 3.0
        wait_until(lambda: is_said(ros, speed, f"{LABEL}\n", [7, 8]), "the new values are there")
        if ros.library == "rclpy":
            refused = session.set_parameter("g", "speed", 9.5, namespace="/robot1")
            assert refused == (SetStatus.REFUSED, "too fast")
        nobody = session.set_parameter("l", "speed", 1.0)
        assert nobody.status is SetStatus.ABSENT
    assert "died" not in ros.said("p.plastron")


def yaml_quoted(text: str) -> str:
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"') + '"'


def is_described(ros: Ros) -> bool:
    told = ros.plastron("describe", "--ros", ros.version).stdout
    parts = (
        *("// /robot1/gain\n", "// /robot1/listener\n", "create_node 'gain' "),
        *("to '/robot1/heard' of", "subscribe gain to '/halt' of"),
    )
    return all(part in told for part in parts)


def session_of(ros: Ros) -> Session:
    path = ros.folder / "p.plastron"
    return Session(path.read_bytes(), path, Options(ros.library), ros.environ)
