"""Driving the wizard without a screen."""

from __future__ import annotations

from pathlib import Path

from plastron_tui.diagnostics import Edit
from plastron_tui.language import DECLARATIONS, Document, format_document
from plastron_tui.language import statements as _statements  # noqa: F401 - declares the statements
from plastron_tui.language.declaration import Statement
from plastron_tui.model.interpreter import HANDLERS
from plastron_tui.session import Session
from plastron_tui.studio.wizard.context import Surroundings
from plastron_tui.studio.wizard.flow import Course
from plastron_tui.studio.wizard.form import Form
from plastron_tui.studio.wizard.pages import Look, PageKind

MAKE = "make a node"
MESSAGE = "make a message"
MORE = "give a node something more to do"
SEND = "send something, at a rate, once, or when something arrives"
REACT = "react to what others send"
ASK = "ask a question and wait for the answer"
ANSWER = "answer questions"
HAVE = "have a value that can be set from outside"
REPEAT = "do something again and again, or at another rate"
DO = "do a task that takes its time"
OWN = "make a type of message, service or action"
PACKAGE = "make it a package"
TOGETHER = "start several nodes together"
DESCRIBE = "describe a robot"
AWAY = "take something away"
CHANGE = "change a node file that exists"

TWO_NODES = """\
create_node 'talker' as talker
create_message greeting of message_type String and input "hello"
talker publish greeting to 'chatter' of message_type String
talker client_requests 'switch' of service_type SetBool with input True
generate_node talker

create_node 'listener' as listener
subscribe listener to 'chatter' of message_type String
listener provides_service 'switch' of service_type SetBool
generate_node listener
"""

PACKAGED = """
create_message_type Speed with float64 left, float64 right
create_package 'rover' as rover
rover contains listener
create_launch 'everything' as everything
everything has_argument 'robot'
everything starts listener
everything includes 'other/sensors.launch.xml'
"""
"""What a program has besides in which there is something of every kind that is no node."""

ROBOTS = """
create_robot 'rover' as rover
rover has_link 'base_link'
rover has_link 'mast' shaped cylinder 0.02, 0.4 weighing 1
rover has_joint 'mast_joint' of joint_type revolute from 'base_link' to 'mast' with axis 0, 0, 1
rover limits_joint 'mast_joint' between -90 and 90 deg with effort 10 and velocity 1
rover has_link 'wheel' shaped cylinder 0.1, 0.04 weighing 1 turned 90, 0, 0 deg
rover has_joint 'wheel_joint' of joint_type continuous from 'base_link' to 'wheel' with axis 0, 1, 0

create_robot 'plate' as plate
plate has_link 'base_link'
"""
"""Two robots: one with joints, one of a link that can be taken away."""

NODE_FILE = """\
#!/usr/bin/env python3
import rospy
from std_msgs.msg import String

rospy.init_node('sonar')
publisher = rospy.Publisher('range', String, queue_size=10)
publisher.publish('x')
rospy.spin()
"""


PACKAGE_XML = """\
<?xml version="1.0"?>
<package format="3">
  <name>old_robot</name>
  <version>0.1.0</version>
  <description>What was there before.</description>
  <maintainer email="ann@example.org">Ann</maintainer>
  <license>MIT</license>
  <buildtool_depend>ament_python</buildtool_depend>
  <export>
    <build_type>ament_python</build_type>
  </export>
</package>
"""
SETUP_PY = """\
from setuptools import setup

setup(
    name="old_robot",
    version="0.1.0",
    packages=["old_robot"],
    entry_points={"console_scripts": []},
)
"""
LAUNCH_XML = """\
<launch>
  <node pkg="old_robot" exec="arm" name="arm"/>
</launch>
"""


URDF = """\
<?xml version="1.0"?>
<robot name="old">
  <link name="base_link"/>
</robot>
"""


def put_beside(folder: Path) -> None:
    """Write what statements can read: a node, a definition, a package, a launch file, a robot."""
    files = {
        "sonar.py": NODE_FILE,
        "msg/Old.msg": "# how far it is\nfloat64 distance\n",
        "old_robot/package.xml": PACKAGE_XML,
        "old_robot/setup.py": SETUP_PY,
        "old_robot/old_robot/__init__.py": "",
        "launch/old.launch.xml": LAUNCH_XML,
        "urdf/old.urdf": URDF,
    }
    for name, text in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)


def _means_something(type_: type[Statement]) -> bool:
    """Tell whether a statement has an effect: those to come are in the language before."""
    code = getattr(HANDLERS[type_], "__code__", None)
    return code is None or bool(code.co_names or code.co_freevars)


ALL = [each for each in DECLARATIONS.values() if _means_something(each.type)]
"""The statements, but for those that mean nothing yet."""


def course(text: str, folder: Path | None = None) -> Course:
    """Return the wizard's state for a program; it sees no ROS."""
    path = None if folder is None else folder / "program.plastron"
    return Course(Session(text.encode(), path, environ={}), Surroundings())


def choose(it: Course, *titles: str) -> Look:
    """Take entries of menus, with all suggestions of the forms between them."""
    look = it.look()
    for title in titles:
        look = to_menu_or_review(it)
        offers = it.offers()
        offer = next(each for each in offers if each.title == title)
        assert not offer.closed, offer
        it.take(offer)
        look = it.look()
    return look


def form_after(it: Course, *titles: str) -> Form:
    """Return the form that entries of menus lead to."""
    choose(it, *titles)
    form = it.page.form
    assert form is not None
    return form


def to_menu_or_review(it: Course) -> Look:
    """Accept forms until something else is asked."""
    look = it.look()
    while it.page.kind is PageKind.FORM:
        assert not it.blocking(look), it.blocking(look)
        it.at += 1
        look = it.look()
    return look


def applied(text: bytes, edits: tuple[Edit, ...]) -> bytes:
    """Return a text after edits."""
    for edit in sorted(edits, key=lambda each: each.span.start, reverse=True):
        text = text[: edit.span.start] + edit.text.encode() + text[edit.span.end :]
    return text


def formatted(text: bytes) -> bytes:
    """Return a program as the formatter lays it out."""
    return format_document(Document(text))
