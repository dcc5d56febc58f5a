"""Kills a command at each call that changes the disk, and runs the next one.

    kill_driver.py SCENE EVENT FOLDER [CALLS]

EVENT is `kill`; or the name of an error number that each call fails with in turn; or `clean`, for
new texts that vanish before it; or `read`, for a reader that looks, where there are no locks.
CALLS, separated by commas, restricts it to some. Prints how many calls there were, and what went
wrong, as JSON.
"""

from __future__ import annotations

import errno
import fcntl
import io
import json
import os
import shutil
import stat
import sys
from collections.abc import Callable, Iterator
from contextlib import redirect_stderr, redirect_stdout
from pathlib import Path
from typing import NamedTuple, cast

from plastron_tui.cli.group import cli
from plastron_tui.output import recovery
from plastron_tui.output.own_files import PREFIX, temporary_kind
from plastron_tui.studio.files import open_file, save_file

CALLS = ("open", "write", "fsync", "link", "replace", "rename", "unlink", "mkdir", "rmdir",
         "fchmod", "fchown", "setxattr")  # fmt: skip

_KILLED = 99

Outcome = tuple[object, ...]


class Scene(NamedTuple):
    """What is there, what is done to it, and what comes next, by name.

    A crash comes between the first two: where it happened is in a journal.
    """

    prepare: Callable[[], None]
    act: Callable[[], object]
    following: dict[str, Callable[[], object]]
    crash: Callable[[], object] | None = None


def command(*arguments: str) -> Outcome:
    """Run a command; return its status and what it said."""
    out, err = io.TextIOWrapper(io.BytesIO()), io.StringIO()
    status = 0
    with redirect_stdout(out), redirect_stderr(err):
        try:
            cli.main(list(arguments), standalone_mode=True)
        except SystemExit as left:
            status = left.code if isinstance(left.code, int) else 1
        out.flush()
    return status, out.buffer.getvalue().decode(), err.getvalue()


def created(topics: str) -> str:
    """Return a program of three nodes that subscribe to topics."""
    lines = []
    for name in ("one", "two", "three"):
        lines.append(f"create_node '{name}' as {name}")
        lines += [f"subscribe {name} to '{topic}' of message_type String" for topic in topics]
        lines.append(f"generate_node {name}")
    return "\n".join(lines) + "\n"


LOADED = """\
load 'src/robot.py' as robot
subscribe robot to '{}' of message_type Int32
generate_node robot
"""

ROBOT = """\
#!/usr/bin/env python3
import rospy
from std_msgs.msg import String

rospy.init_node('robot')
rospy.Subscriber('chatter', String, print)
rospy.spin()
"""


PAIR = "load 'src/robot.cpp' as robot\n{}generate_node robot\n"
"""A node of a header and a source that is changed in both."""

MORE = "subscribe robot to 'other' of message_type Int32\n"
LESS = "unsubscribe robot from 'chatter'\n"

HEADER = """\
#pragma once
#include <ros/ros.h>
#include <std_msgs/String.h>

class Robot
{
public:
  Robot();

private:
  void on_chatter(const std_msgs::String & message);

  ros::NodeHandle nh_;
  ros::Subscriber chatter_;
};
"""

SOURCE = """\
#include "robot.h"

Robot::Robot()
{
  chatter_ = nh_.subscribe("chatter", 1, &Robot::on_chatter, this);
}

void Robot::on_chatter(const std_msgs::String & message)
{
  ROS_INFO("%s", message.data.c_str());
}

int main(int argc, char ** argv)
{
  ros::init(argc, argv, "robot");
  Robot robot;
  ros::spin();
  return 0;
}
"""


def put(name: str, text: str) -> None:
    """Write a file of the scene."""
    Path(name).parent.mkdir(exist_ok=True)
    Path(name).write_text(text)


def prepare_created() -> None:
    """Three nodes, of which one was changed by hand."""
    put("a.plastron", created("xy"))
    assert command("generate", "a.plastron")[0] == 0
    file = next(Path("output").glob("two*.py"))
    file.write_text(file.read_text() + "\n\n# by hand\n")
    put("a.plastron", created("xz"))


def prepare_in_place() -> None:
    """A node that is changed where it is, and created ones in the output folder."""
    put("src/robot.py", ROBOT)
    put("a.plastron", created("xy") + LOADED.format("other"))
    assert command("generate", "--in-place", "a.plastron")[0] == 0
    put("a.plastron", created("xz") + LOADED.format("another"))


def prepare_pair() -> None:
    """A header and a source that are changed where they are, and then by hand."""
    put("src/robot.cpp", SOURCE)
    put("src/robot.h", HEADER)
    put("a.plastron", PAIR.format(MORE))
    assert command("generate", "--in-place", "a.plastron")[0] == 0
    header = Path("src/robot.h")
    header.write_text(header.read_text().replace("#pragma once\n", "#pragma once  // by hand\n"))
    put("a.plastron", PAIR.format(MORE + LESS))


def prepare_forced() -> None:
    """Nodes in the way of what is generated."""
    put("a.plastron", created("xy"))
    for name in ("one_node.py", "two_node.py"):
        put(f"output/{name}", "by hand\n")


def generate(text: str, *flags: str) -> Callable[[], object]:
    """Return what writes a program and generates it."""

    def act() -> object:
        put("a.plastron", text)
        return command("generate", *flags, "a.plastron")

    return act


def checked(*flags: str) -> Callable[[], object]:
    """Return what only looks, and then generates."""

    def act() -> object:
        looked = command("check", "a.plastron")
        return (
            looked,
            not list(Path().rglob(".plastron-*")),
            command("generate", *flags, "a.plastron"),
        )

    return act


def save() -> object:
    """Save what was typed in the studio."""
    path = Path("a.plastron")
    saved = save_file(path, b"create_node 'b' as b\n", open_file(path).disk)
    return saved.refusal and saved.refusal.message


def crash() -> object:
    """Be killed when two of four files were replaced."""
    break_call(3, "kill", ("replace",))
    return command("generate", "a.plastron")


SCENES = {
    "created": Scene(
        prepare_created,
        lambda: command("generate", "a.plastron"),
        {
            "again": lambda: command("generate", "a.plastron"),
            "put back": generate(created("xy")),
            "another": generate(created("vxz")),
            "check": checked(),
        },
    ),
    "fresh": Scene(
        lambda: put("a.plastron", created("xy")),
        lambda: command("generate", "a.plastron"),
        {"again": lambda: command("generate", "a.plastron"), "other": generate(created("z"))},
    ),
    "in place": Scene(
        prepare_in_place,
        lambda: command("generate", "--in-place", "a.plastron"),
        {
            "again": lambda: command("generate", "--in-place", "a.plastron"),
            "put back": generate(created("xy") + LOADED.format("other"), "--in-place"),
            "check": checked("--in-place"),
        },
    ),
    "pair": Scene(
        prepare_pair,
        lambda: command("generate", "--in-place", "a.plastron"),
        {
            "again": lambda: command("generate", "--in-place", "a.plastron"),
            "put back": generate(PAIR.format(MORE), "--in-place"),
            "check": checked("--in-place"),
        },
    ),
    "forced": Scene(
        prepare_forced,
        lambda: command("generate", "--force", "a.plastron"),
        {"again": lambda: command("generate", "--force", "a.plastron")},
    ),
    "recovery": Scene(
        prepare_created,
        lambda: command("check", "a.plastron"),
        {"again": lambda: command("generate", "a.plastron")},
        crash,
    ),
    "save": Scene(
        lambda: put("a.plastron", "create_node 'a' as a\n"),
        save,
        {"again": save, "check": lambda: command("check", "a.plastron")},
    ),
}


def snapshot(root: Path) -> dict[str, object]:
    """Return everything that is in a folder: modes and contents."""
    found: dict[str, object] = {}
    for path in sorted(root.rglob("*")):
        mode = path.lstat().st_mode
        text = path.read_bytes().decode() if stat.S_ISREG(mode) else None
        found[str(path.relative_to(root))] = (stat.S_IMODE(mode), text)
    return found


def visible(found: dict[str, object]) -> dict[str, object]:
    """Return what is there without the writer's own files, where removing them is what failed."""
    return {name: what for name, what in found.items() if not Path(name).name.startswith(PREFIX)}


def is_success(outcome: object) -> bool:
    """Tell whether a command, or saving, reports that everything was written."""
    if outcome is None:
        return True
    if isinstance(outcome, str):  # why it was not saved
        return False
    status, _, said = cast("tuple[int, str, str]", outcome)
    return status == 0 and "interrupted-write" not in said


def no_locks(*_: object) -> None:
    """Answer as a file system without locks."""
    raise OSError(errno.ENOLCK, os.strerror(errno.ENOLCK))


def break_call(at: int, event: str, calls: tuple[str, ...]) -> list[int]:
    """Let the nth call that changes the disk be the last, or fail; return the counter."""
    count = [0]
    if event == "read":
        fcntl.flock = no_locks

    def broken(name: str) -> Callable[..., object]:
        real = getattr(os, name)

        def call(*args: object, **kwargs: object) -> object:
            if name == "open" and not int(str(args[1])) & os.O_CREAT:
                return real(*args, **kwargs)
            count[0] += 1
            if count[0] != at:
                return real(*args, **kwargs)
            if event == "read":
                for folder in {path.parent for path in Path().rglob(f"{PREFIX}*")}:
                    recovery.settle(folder)
                return real(*args, **kwargs)
            if event == "clean":
                for path in Path().rglob(f"{PREFIX}*"):
                    if temporary_kind(path.name) == "new":
                        os.unlink(path)
                return real(*args, **kwargs)
            if event == "kill":
                if name == "write":
                    real(args[0], bytes(args[1])[: len(bytes(args[1])) // 2])  # type: ignore[arg-type]
                os._exit(_KILLED)
            number = getattr(errno, event)
            raise OSError(number, os.strerror(number), args[0])

        return call

    for name in calls:
        setattr(os, name, broken(name))
    return count


def in_child(folder: Path, act: Callable[[], object]) -> tuple[int, object]:
    """Run something in a process of its own, in a folder; return its status and its result."""
    reading, writing = os.pipe()
    child = os.fork()
    if child == 0:
        os.close(reading)
        os.chdir(folder)
        status, result = 0, None
        really_write = os.write
        try:
            result = act()
        except BaseException as error:
            status, result = 1, repr(error)
        data = memoryview(json.dumps(result).encode())
        while data:
            data = data[really_write(writing, data) :]
        os._exit(status)
    os.close(writing)
    with open(reading, "rb") as stream:
        data = stream.read()
    status = os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
    return status, json.loads(data) if data else None


def outcomes(scene: Scene, base: Path, root: Path, following: str) -> Iterator[Outcome]:
    """Yield what the next command leads to where nothing is interrupted: after nothing, and all.

    And where there was no crash: what had begun may be taken back as well as finished.
    """
    ways = [(scene, ()), (scene, (scene.act,)), (scene._replace(crash=None), ())]
    for each, acts in ways:
        fresh(base, root, each)
        for act in acts:
            assert in_child(root, act)[0] == 0
        yield in_child(root, scene.following[following]), snapshot(root)


def fresh(base: Path, root: Path, scene: Scene) -> None:
    """Make the scene's folder again."""
    shutil.rmtree(root, ignore_errors=True)
    shutil.copytree(base, root)
    if scene.crash is not None:
        assert in_child(root, scene.crash)[0] == _KILLED


def warm_up(scene: Scene, base: Path, folder: Path) -> None:
    """Do all that children will do in this process, so that they need not import it each."""
    shutil.copytree(base, folder)
    os.chdir(folder)
    assert command("check", "a.plastron")[0] == 0
    for act in (scene.act, *scene.following.values()):
        act()


def run(name: str, event: str, folder: Path, calls: tuple[str, ...]) -> tuple[int, list[str]]:
    """Break each call of a scene's command in turn; return their number, and what was wrong."""
    scene, base, root = SCENES[name], folder / "base", folder / "root"
    base.mkdir()
    os.chdir(base)
    scene.prepare()
    warm_up(scene, base, folder / "warm")
    os.chdir(folder)
    # After an error everything is old or new, and one command tells.
    commands = list(scene.following)[: None if event == "kill" else 1]
    expected = {each: list(outcomes(scene, base, root, each)) for each in commands}
    fresh(base, root, scene)
    assert is_success(in_child(root, scene.act)[1])
    new = visible(snapshot(root))
    wrong = []
    for at in range(1, 10_000):
        is_over = False
        for following in commands:
            fresh(base, root, scene)

            def act(at: int = at) -> object:
                count = break_call(at, event, calls)
                return count, scene.act()

            status, result = in_child(root, act)
            if status not in (0, _KILLED):
                wrong.append(f"call {at}: {result}")
            if status == 0:
                count, outcome = cast("tuple[list[int], object]", result)
                is_over = count[0] < at
                is_new = visible(snapshot(root)) == new
                # Who finishes another's write warns until it is synced, though all is new.
                may_warn = is_new and scene.crash is not None
                if is_success(outcome) != is_new and not may_warn:
                    wrong.append(f"call {at}: the tree is {'' if is_new else 'not '}new: {outcome}")
            found = in_child(root, scene.following[following]), snapshot(root)
            if found not in expected[following]:
                wrong.append(f"call {at}, then {following}: {found}")
        if is_over:
            return at - 1, wrong
    raise AssertionError("it never ends")


if __name__ == "__main__":
    # What was finished is told; a run that was never interrupted has nothing to tell.
    recovery._told = lambda *_: iter(())
    names = tuple(sys.argv[4].split(",")) if len(sys.argv) > 4 else CALLS
    found, wrong = run(sys.argv[1], sys.argv[2], Path(sys.argv[3]), names)
    print(json.dumps({"calls": found, "wrong": wrong}))
