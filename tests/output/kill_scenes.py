"""What is there before a command is killed, the command, and what comes next."""

from __future__ import annotations

import io
from collections.abc import Callable
from contextlib import redirect_stderr, redirect_stdout
from pathlib import Path
from typing import NamedTuple

from broken_calls import break_call

from plastron_tui.cli.group import cli
from plastron_tui.studio.files import open_file, save_file

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
