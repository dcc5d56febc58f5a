"""Driving the wizard without a screen."""

from __future__ import annotations

from pathlib import Path

from plastron_tui.diagnostics import Edit
from plastron_tui.language import Document, format_document
from plastron_tui.session import Session
from plastron_tui.studio.wizard.context import Surroundings
from plastron_tui.studio.wizard.flow import Course, Look, PageKind
from plastron_tui.studio.wizard.form import Form

MAKE = "make a node"
MESSAGE = "make a message"
MORE = "give a node something more to do"
SEND = "send something, at a rate, once, or when something arrives"
REACT = "react to what others send"
ASK = "ask a question and wait for the answer"
ANSWER = "answer questions"
HAVE = "have a value that can be set from outside"
REPEAT = "do something, again and again"
DO = "do a task that takes its time"
OWN = "make a message of your own"
PACKAGE = "make it a package"
TOGETHER = "start several nodes together"
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

NODE_FILE = """\
#!/usr/bin/env python3
import rospy
from std_msgs.msg import String

rospy.init_node('sonar')
publisher = rospy.Publisher('range', String, queue_size=10)
publisher.publish('x')
rospy.spin()
"""


def course(text: str, folder: Path | None = None) -> Course:
    """Return the wizard's state for a program; it sees no ROS."""
    path = None if folder is None else folder / "program.plastron"
    return Course(Session(text.encode(), path, environ={}), Surroundings())


def choose(it: Course, *titles: str) -> Look:
    """Take entries of menus, with all suggestions of the forms between them."""
    look = it.look()
    for title in titles:
        look = to_menu_or_review(it)
        is_start = it.page.kind is PageKind.START
        offers = it.start_offers() if is_start else it.purpose_offers()
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
