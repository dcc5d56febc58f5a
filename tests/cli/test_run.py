from __future__ import annotations

import os
import pty
import re
import signal
import subprocess
import sysconfig
import venv
from collections.abc import Callable
from functools import partial
from pathlib import Path

import pytest
from command_line import BROKEN, LISTENER, PLASTRON, TALKER, Run
from machine import TALKING, find_ros, mostly_long, wait_until
from ros_runs import Ros, make_ros, said_by
from table_packages import made_packages, shared_cache

from plastron_tui.runtime import environment
from plastron_tui.runtime.master import master_pid

Elsewhere = Callable[..., tuple[int, str]]

TABLE_SERVICES = """\
create_node 'adder' as adder
adder provides_service 'add' of service_type AddTwoInts answering received.a + received.b
adder provides_service 'count' of service_type WordCount
generate_node adder
create_node 'caller' as caller
caller client_requests 'add' of service_type AddTwoInts with input 5, 6
caller client_requests 'count' of service_type WordCount with input "to be or not"
generate_node caller
"""


@pytest.fixture(params=["rospy", "rclpy"])
def ros(request: pytest.FixtureRequest, tmp_path: Path) -> Ros:
    return make_ros(request.param, tmp_path)


@pytest.fixture
def ros2(tmp_path: Path) -> Ros:
    return make_ros("rclpy", tmp_path)


# On ROS 2 it is said of a program of which only some nodes run, further down.
@pytest.mark.parametrize("ros", ["rospy"], indirect=True)
@pytest.mark.live
def test_a_program_is_generated_and_run(ros: Ros) -> None:
    ros.write("p.plastron", TALKER + LISTENER)
    said = ros.run_until(lambda said: len(heard_by(said, "listener")) > 10, "p.plastron")
    check_run(ros, said)
    assert master_pid(ros.environ["ROS_MASTER_URI"]) is None


def check_run(ros: Ros, said: str) -> None:
    """A run tells what it writes and starts, and leaves no process behind."""
    assert f"running {ros.library} nodes on ROS " in said
    assert "   create  output/talker_pub.py\n" in said
    assert (ros.folder / "output" / "talker_pub.py").exists()
    assert not ros.processes()


@pytest.mark.long
@pytest.mark.live
def test_types_of_the_table_that_nothing_installs(
    ros: Ros, tmp_path_factory: pytest.TempPathFactory
) -> None:
    """In ROS 2, where a build takes long, one of the two packages is there from another run."""
    ros.write("p.plastron", TABLE_SERVICES)
    names = ["basics"]
    if ros.library == "rospy":
        cache = ros.folder / "cache"
        names.append("beginner_tutorials")
    else:
        cache = shared_cache(tmp_path_factory)
        made_packages(find_ros(2), cache, ["example_interfaces"])
    ros.environ["XDG_CACHE_HOME"] = str(cache)

    def is_answered(said: str) -> bool:
        # rospy writes `sum: 11`, rclpy `AddTwoInts_Response(sum=11)`.
        answers = "\n".join(said_by(said, "caller")).replace("=", ": ")
        return all(each in answers for each in ("sum: 11", "count: 0"))

    said = ros.run_until(is_answered, "p.plastron")
    assert {*re.findall("building `(.*?)`: ", said)} == {*names}
    said = ros.run_until(is_answered, "p.plastron")
    assert "building" not in said


def heard_by(said: str, name: str) -> list[str]:
    return [line for line in said_by(said, name) if "hello" in line]


@pytest.mark.long
@pytest.mark.live
def test_a_program_runs_for_a_time(ros: Ros) -> None:
    ros.write("p.plastron", TALKER + LISTENER)
    done = ros.run("p.plastron", "--for", "8")
    assert done.returncode == 0, done.stderr
    assert not ros.processes()


@pytest.mark.live
def test_only_the_named_nodes_run(ros2: Ros) -> None:
    ros2.write("p.plastron", TALKING)
    said = ros2.run_until(
        lambda said: len(heard_by(said, "listener")) > 10, "p.plastron", "listener", "talker"
    )
    check_run(ros2, said)
    assert not said_by(said, "asker")
    written = {path.name for path in (ros2.folder / "output").glob("*.py")}
    assert written == {"listener_sub1.py", "talker_pub.py"}


def test_a_node_that_is_not_there(run: Run, here: Path) -> None:
    (here / "p.plastron").write_text(TALKER)
    done = run("run", "p.plastron", "talkr")
    assert done.returncode == 1
    assert b"error[unknown-node]: the program generates no node `talkr`" in done.stderr
    assert b"did you mean `talker`?" in done.stderr
    assert not (here / "output").exists()


def test_a_program_with_a_mistake_starts_nothing(run: Run, here: Path) -> None:
    (here / "p.plastron").write_text(BROKEN)
    done = run("run", "p.plastron")
    assert done.returncode == 1
    assert b"error[unknown-node]" in done.stderr
    assert not (here / "output").exists()


def test_a_program_that_generates_nothing(run: Run, here: Path) -> None:
    (here / "p.plastron").write_text("create_node 'a' as a\n")
    done = run("run", "p.plastron")
    assert done.returncode == 1
    assert b"error[nothing-to-generate]" in done.stderr
    assert b"`generate_node a`" in done.stderr


@pytest.mark.parametrize("seconds", ["0", "-1", "soon", "nan"])
def test_a_time_that_is_none(run: Run, here: Path, seconds: str) -> None:
    (here / "p.plastron").write_text(TALKER)
    assert run("run", "p.plastron", "--for", seconds).returncode == 2


@pytest.fixture
def elsewhere(here: Path, run_patched: Run, monkeypatch: pytest.MonkeyPatch) -> Elsewhere:
    """Run a program where the Python that plastron runs with, and the system's one, are others."""

    def elsewhere(python: Path, debian: Path, *arguments: str) -> tuple[int, str]:
        find = partial(environment.find_environments, interpreter=python, debian_python=debian)
        monkeypatch.setattr(environment, "find_environments", find)
        (here / "p.plastron").write_text(TALKER)
        done = run_patched("run", "p.plastron", *arguments)
        return done.returncode, done.stderr.decode()

    return elsewhere


@pytest.mark.parametrize(
    ("target", "command"),
    [
        (None, "pip install 'plastron-tui[ros2]'"),
        ("rclpy", "pip install 'plastron-tui[ros2]'"),
        ("rospy", "sudo apt install python3-rospy python3-rosmaster python3-std-msgs"),
    ],
)
def test_no_ros_at_all(here: Path, elsewhere: Elsewhere, target: str | None, command: str) -> None:
    arguments = () if target is None else ("--target", target)
    status, said = elsewhere(Path("/no/python"), Path("/no/python"), *arguments)
    assert status == 1
    assert "error[no-ros]: no ROS" in said
    # Without a target the program is for rospy, as without a sourced ROS.
    if target is not None:
        assert f" with `{command}`" in said
    assert not (here / "output").exists()


def test_half_a_ros(here: Path, elsewhere: Elsewhere) -> None:
    root = here / "env"
    venv.create(root, symlinks=True)
    package = next(root.glob("lib/python3*/site-packages")) / "rclpy"
    package.mkdir()
    (package / "__init__.py").touch()
    (package / f"_rclpy_pybind11{sysconfig.get_config_var('EXT_SUFFIX')}").touch()
    python = root / "bin" / "python3"
    status, said = elsewhere(python, Path("/no/python"), "--target", "rclpy")
    assert status == 1
    assert "error[half-a-ros]: rclpy is installed, but no middleware" in said
    assert "pip install ros-rmw-fastrtps-cpp" in said
    assert not (here / "output").exists()


@pytest.mark.live
@pytest.mark.parametrize("ros", mostly_long(["rospy", "rclpy"], ["rclpy"]), indirect=True)
def test_a_node_that_crashes_at_its_start(ros: Ros) -> None:
    ros.write("p.plastron", TALKER + LISTENER)
    assert ros.plastron("generate", "p.plastron", "--target", ros.library).returncode == 0
    listener = ros.folder / "output" / "listener_sub1.py"
    text = listener.read_text()
    listener.write_text(text.replace("\nclass ", '\nraise ValueError("no such motor")\n\n\nclass '))
    said = ros.run_until(lambda said: "listener died" in said, "p.plastron", status=1)
    assert "listener died with exit status 1" in said
    assert "ValueError: no such motor" in said
    assert not ros.processes()


@pytest.mark.live
@pytest.mark.parametrize("ros", mostly_long(["rospy", "rclpy"], ["rclpy"]), indirect=True)
def test_a_client_that_gets_no_answer_has_failed(ros: Ros) -> None:
    ros.write(
        "p.plastron",
        "create_node 'asker' as a\n"
        "a client_requests 'nobody' of service_type SetBool with input True\n"
        "generate_node a\n",
    )
    assert ros.plastron("generate", "p.plastron", "--target", ros.library).returncode == 0
    asker = ros.folder / "output" / "asker_client.py"
    text = asker.read_text()
    asker.write_text(text.replace("SERVICE_TIMEOUT = 10.0", "SERVICE_TIMEOUT = 0.5"))
    done = ros.run("p.plastron")
    assert done.returncode == 1
    assert "asker died with exit status 1: [ERROR]" in done.stderr
    assert not ros.processes()


@pytest.mark.live
@pytest.mark.long
def test_a_node_that_never_starts(ros: Ros) -> None:
    ros.write("p.plastron", TALKER + LISTENER)
    assert ros.plastron("generate", "p.plastron", "--target", ros.library).returncode == 0
    listener = ros.folder / "output" / "listener_sub1.py"
    stuck = (
        "import signal\nimport time\n\nsignal.signal(signal.SIGINT, signal.SIG_IGN)\n"
        "signal.signal(signal.SIGTERM, signal.SIG_IGN)\ntime.sleep(600)\n\n\nclass "
    )
    listener.write_text(listener.read_text().replace("\nclass ", f"\n{stuck}", 1))
    done = ros.run("p.plastron", "--for", "3")
    assert not said_by(done.stdout, "listener")
    assert "listener" in done.stderr
    assert not ros.processes()


@pytest.mark.long
@pytest.mark.live
def test_a_second_run_beside_the_first(ros: Ros) -> None:
    ros.write("p.plastron", TALKER + LISTENER)
    with ros.running("p.plastron") as first:
        wait_until(lambda: "hello" in ros.said("p.plastron"), "the first run talks", 120)
        other = Ros(ros.library, ros.folder / "other", ros.environ)
        other.folder.mkdir()
        other.write("q.plastron", LISTENER.replace("'listener'", "'second'"))
        other.run_until(lambda said: heard_by(said, "second"), "q.plastron")
        assert first.poll() is None
    assert "died" not in ros.said("p.plastron")


@pytest.mark.live
@pytest.mark.parametrize("ros", mostly_long(["rospy", "rclpy"], ["rospy"]), indirect=True)
def test_a_terminal_that_is_closed(ros: Ros) -> None:
    ros.write("p.plastron", TALKER + LISTENER)
    command = [*PLASTRON, "run", "p.plastron", "--target", ros.library]
    pid, terminal = pty.fork()
    if pid == 0:
        os.chdir(ros.folder)
        os.execve(command[0], command, ros.environ)
    shown = b""
    while b"hello" not in shown:
        shown += os.read(terminal, 4096)
    assert len(ros.processes()) >= 2
    os.close(terminal)
    _, status = os.waitpid(pid, 0)
    # The signal, or an output that nobody reads any more: whichever is seen first ends the run.
    assert os.waitstatus_to_exitcode(status) in (0, -signal.SIGHUP, 128 + signal.SIGHUP)
    wait_until(lambda: not ros.processes(), "the nodes are gone")
    assert master_pid(ros.environ["ROS_MASTER_URI"]) is None


@pytest.mark.long
@pytest.mark.live
def test_the_watch(ros: Ros) -> None:
    def is_told(said: str) -> bool:
        told = said_by(said, "watch")
        topics = [line for line in told if line.startswith("/chatter std_msgs/String")]
        return any(15 < float(line.split()[2]) < 25 for line in topics) and any(
            line.startswith("/switch (data: True) → (success: ") for line in told
        )

    ros.write("p.plastron", TALKING)
    ros.run_until(is_told, "p.plastron", "--watch")


KEPT_AND_PLAIN = """\
create_message news of message_type String and input "new"
create_node 'keeper' as keeper
keeper publish news to 'news' of message_type String once
generate_node keeper
create_node 'plain' as plain
plain publish news to 'news' of message_type String at 20 hz
generate_node plain
"""


@pytest.mark.long
@pytest.mark.live
def test_the_watch_hears_who_comes_later_and_offers_less(ros2: Ros) -> None:
    """What is kept for late subscriptions is asked for until a publisher comes that keeps none."""
    ros2.write("p.plastron", KEPT_AND_PLAIN)
    assert ros2.plastron("generate", "p.plastron", "--target", "rclpy").returncode == 0
    go, plain = ros2.folder / "go", ros2.folder / "output" / "plain_pub.py"
    waiting = f"import os, time\nwhile not os.path.exists({str(go)!r}):\n    time.sleep(0.01)\n"
    plain.write_text(plain.read_text().replace("import rclpy\n", f"{waiting}import rclpy\n", 1))

    def is_told(said: str) -> bool:
        news = [line for line in said_by(said, "watch") if line.startswith("/news ")]
        if news:
            go.touch()
        return any(15 < float(line.split()[2]) < 25 for line in news)

    ros2.run_until(is_told, "p.plastron", "--watch")


@pytest.mark.long
@pytest.mark.live
def test_a_full_disk_under_the_output_ends_the_run_with_2(ros2: Ros) -> None:
    ros2.write("p.plastron", TALKING)
    # So that the nodes are what writes first.
    assert ros2.plastron("generate", "p.plastron", "--target", "rclpy").returncode == 0
    with Path("/dev/full").open("wb") as full:
        done = subprocess.run(
            [*PLASTRON, "run", "p.plastron", "--target", "rclpy", "--watch"],
            cwd=ros2.folder,
            env=ros2.environ,
            stdout=full,
            stderr=subprocess.PIPE,
            timeout=90,
        )
    assert done.returncode == 2
    assert done.stderr.endswith(b"error: no space left on device\n")
    assert not ros2.processes()
