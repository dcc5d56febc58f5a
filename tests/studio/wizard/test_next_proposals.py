"""What is proposed once statements are in the program: it stands first, all else as always."""

from __future__ import annotations

import pytest
from wizard_courses import ANSWER, MAKE, REACT, choose, course, form_after, to_menu_or_review

from plastron_tui.session import Session
from plastron_tui.studio.wizard import strings

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
ALWAYS = ["something more", "write the files", "run the nodes", "back to the text"]


@pytest.mark.parametrize(
    ("program", "first"),
    [
        (TALKER, "something more"),
        (TALKER + LISTENER, "run the nodes"),
    ],
)
def test_what_is_proposed_stands_first(program: str, first: str) -> None:
    items = list(strings.done_items(Session(program.encode(), environ={}), "").values())
    assert [item.title for item in items if item.is_advised] == [first]
    assert [item.title for item in items] == [first, *(each for each in ALWAYS if each != first)]


def test_who_listens_is_proposed_to_who_speaks_alone() -> None:
    it = course(TALKER)
    choose(it, MAKE)
    to_menu_or_review(it)
    offers = it.purpose_offers()
    assert [each.title for each in offers if each.is_advised] == [REACT]
    assert offers[0].title == REACT


def test_an_answer_that_is_still_to_be_written_is_said() -> None:
    it = course("")
    form = form_after(it, MAKE, ANSWER)
    form.enter("service", "words")
    form.enter("type", "WordCount")
    assert strings.unanswered(to_menu_or_review(it)) == "words"
    form.values["count",] = "1"
    assert strings.unanswered(it.look()) == ""
