"""What is proposed once statements are in the program: it stands first, all else as always."""

from __future__ import annotations

import pytest
from wizard_courses import (
    ANSWER,
    MAKE,
    MORE,
    REACT,
    SEND,
    choose,
    course,
    form_after,
    to_menu_or_review,
)

from plastron_tui.language import DECLARATIONS
from plastron_tui.language import statements as st
from plastron_tui.session import Session
from plastron_tui.studio.wizard import strings
from plastron_tui.studio.wizard.done_menu import done_items

TALKER = """\
create_node 'talker' as talker
create_message hello of message_type String and input "hello"
talker publish hello to 'chatter' of message_type String
generate_node talker
"""
LISTENER = """\
create_node 'listener' as listener
subscribe listener to 'chatter' of message_type String
generate_node listener
"""
DRIVER = """\
create_node 'driver' as driver
subscribe driver to 'scan' of message_type sensor_msgs/LaserScan
create_message ahead of message_type Twist and input linear.x=0.2
driver publish ahead to 'cmd_vel' of message_type Twist for_each 'scan'
generate_node driver
"""
"""A robot sends what the node hears, and takes what it sends."""
ALWAYS = ["something more", "write the files", "run the nodes", "back to the text"]


@pytest.mark.parametrize(
    ("program", "first"),
    [
        (TALKER, "add another node"),
        (DRIVER, "run the nodes"),
        (TALKER + LISTENER, "run the nodes"),
    ],
)
def test_what_is_proposed_stands_first(program: str, first: str) -> None:
    items = list(done_items(Session(program.encode(), environ={}), "").values())
    assert [item.title for item in items if item.is_advised] == [first]
    if first == "add another node":
        assert items[0].about == "Nobody listens to the topic `chatter` yet: make a node that does."
    assert [item.title for item in items] == [first, *(each for each in ALWAYS if each != first)]


@pytest.mark.parametrize("is_called", [False, True])
def test_how_a_service_is_called_that_no_node_calls_is_said(is_called: bool) -> None:
    text = "create_node 'a' as a\na provides_service 'reset' of service_type Trigger\n"
    if is_called:
        text += "a client_requests 'reset' of service_type Trigger with input none\n"
    items = done_items(Session(f"{text}generate_node a\n".encode(), environ={}), "")
    about = next(each.about for each in items.values() if each.title == "run the nodes")
    assert about.endswith("Enter on `reset` in Live calls it: no node does yet.") != is_called


def test_another_node_is_asked_for_at_once() -> None:
    it = course(TALKER)
    it.begin_with(DECLARATIONS[st.CreateNode])
    assert it.page.form is not None and it.page.form is it.head_form
    choose(it, REACT)
    assert "'chatter'" in it.look().filled[-1].text


def test_who_listens_is_proposed_to_who_speaks_alone() -> None:
    it = course(TALKER)
    choose(it, MAKE)
    to_menu_or_review(it)
    offers = it.offers()
    assert [each.title for each in offers if each.is_advised] == [REACT]
    assert offers[0].title == REACT


def test_an_answer_that_is_still_to_be_written_is_said() -> None:
    it = course("")
    form = form_after(it, MAKE, ANSWER)
    form.enter("service", "words")
    form.enter("type", "WordCount")
    assert strings.unanswered(to_menu_or_review(it)) == "words"
    assert next(iter(done_items(it.session, "", "words"))) == "screen.code('words')"
    form.values["count",] = "1"
    assert strings.unanswered(it.look()) == ""


def test_the_message_that_a_topic_gets_already_is_offered_first() -> None:
    more = 'create_message other of message_type String and input "more"\n'
    second = "create_node 'second' as second\n"
    it = course(TALKER + more + second)
    form = form_after(it, MORE, SEND)
    filled = it.look().of(form)
    assert filled is not None and filled.cells["message"].text == "other"
    form.enter("topic", "chatter")
    filled = it.look().of(form)
    assert filled is not None and filled.cells["message"].text == "hello"
    names = [each.text for each in it.choices(filled, "message", None, "")]
    assert names[1:] == ["hello", "other"]
