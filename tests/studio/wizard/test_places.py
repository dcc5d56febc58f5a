"""Statements stand where they take effect."""

from __future__ import annotations

import pytest
from wizard_courses import (
    ANSWER,
    ASK,
    MAKE,
    MORE,
    REACT,
    SEND,
    TWO_NODES,
    applied,
    choose,
    course,
    form_after,
    to_menu_or_review,
)

from plastron_tui.session import Session

EARS = "create_node 'ears' as ears\nsubscribe ears to 'a' of message_type String\n"
NEW = "subscribe ears to 'chatter' of message_type String"

PLACES = [
    # Before the node is generated, where it is; else at the end.
    (f"{EARS}generate_node ears\n", f"{EARS}{NEW}\ngenerate_node ears\n"),
    (f"{EARS}generate_node ears", f"{EARS}{NEW}\ngenerate_node ears"),
    (f"{EARS}  generate_node ears // at last\n", f"{EARS}{NEW}\n  generate_node ears // at last\n"),
    (EARS, f"{EARS}{NEW}\ngenerate_node ears\n"),
    (EARS.rstrip("\n"), f"{EARS}{NEW}\ngenerate_node ears\n"),
    (f"{EARS}\n\n", f"{EARS}{NEW}\ngenerate_node ears\n\n\n"),
    (f"{EARS}// the end", f"{EARS}// the end\n{NEW}\ngenerate_node ears\n"),
    # Of several generations the last one counts.
    (
        f"{EARS}generate_node ears\ngenerate_node ears using rclpy\n",
        f"{EARS}generate_node ears\n{NEW}\ngenerate_node ears using rclpy\n",
    ),
    # A line that begins within a remark is no place for a statement.
    (
        f"{EARS}/* so\nfar */ generate_node ears\n",
        f"{EARS}/* so\nfar */ generate_node ears\n{NEW}\ngenerate_node ears\n",
    ),
    # A line that is not finished stays as it is.
    (f"{EARS}create_node 'x'\n", f"{EARS}create_node 'x'\n{NEW}\ngenerate_node ears\n"),
]


@pytest.mark.parametrize(("before", "after"), PLACES)
def test_where_a_statement_goes(before: str, after: str) -> None:
    it = course(before)
    form = form_after(it, MORE, REACT)
    form.entered = {"node": "ears", "topic": "chatter"}
    look = to_menu_or_review(it)
    assert look.outcome is not None and look.problems == ()
    assert applied(before.encode(), look.outcome.edits).decode() == after


def test_what_is_made_later_is_sent_later_and_generated_anew() -> None:
    before = f"{EARS}generate_node ears\ncreate_message m of message_type String and input none\n"
    it = course(before)
    form = form_after(it, MORE, SEND)
    form.entered = {"node": "ears", "message": "m", "topic": "out"}
    look = to_menu_or_review(it)
    assert look.outcome is not None and look.problems == ()
    after = applied(before.encode(), look.outcome.edits).decode()
    assert after == (
        f"{before}ears publish m to 'out' of message_type String at 10 hz\ngenerate_node ears\n"
    )
    assert Session(after.encode(), environ={}).diagnostics == ()


def test_a_new_node_stands_apart() -> None:
    it = course(f"{EARS}generate_node ears\n")
    choose(it, MAKE, ANSWER)
    look = to_menu_or_review(it)
    assert look.outcome is not None
    assert look.outcome.session.document.text.decode() == (
        f"{EARS}generate_node ears\n\ncreate_node 'answerer' as answerer\n"
        "answerer provides_service 'switch' of service_type SetBool "
        'answering True, "done"\n'
        "generate_node answerer\n"
    )


def test_the_node_is_not_generated_unless_that_is_wanted() -> None:
    it = course("")
    choose(it, MAKE, REACT)
    it.generates = False
    look = to_menu_or_review(it)
    assert look.outcome is not None and look.can_generate
    assert look.outcome.lines[-1].startswith("subscribe listener")


def test_another_ros_has_types_and_names_of_its_own() -> None:
    it = course("")
    form = form_after(it, MAKE)
    form.entered["library"] = "rclpy"
    form = form_after(it, ASK)
    form.entered["type"] = "AddTwoInts"
    look = to_menu_or_review(it)
    assert look.outcome is not None and look.problems == ()
    assert look.outcome.session.workspace.nodes["asker"].packages == {"example_interfaces"}


def test_nodes_of_one_ros_are_kept_together() -> None:
    it = course("create_node 'a' as a using rclpy\nsubscribe a to 'x' of message_type String\n")
    form = form_after(it, MAKE)
    filled = it.look().of(form)
    assert filled is not None
    assert filled.cells["library"].text == "rclpy"
    assert "do not hear each other" in it.helps(filled)["library", None]


def test_no_topic_of_its_own_is_suggested_to_a_node() -> None:
    one = TWO_NODES.partition("create_node 'listener'")[0]
    it = course(one)
    choose(it, MORE, REACT)
    assert it.page.form is not None
    filled = it.look().of(it.page.form)
    assert filled is not None
    assert filled.cells["node"].text == "talker" and filled.cells["topic"].text != "chatter"


def test_a_private_name_is_offered_to_others_in_full() -> None:
    it = course(
        "create_node 'arm' as arm\ncreate_message m of message_type Bool and input True\n"
        "arm publish m to '~ready' of message_type Bool\ncreate_node 'eye' as eye\n"
    )
    form = form_after(it, MORE, REACT)
    form.entered = {"node": "eye"}
    filled = it.look().of(form)
    assert filled is not None
    assert it.choices(filled, "topic", None, "")[0].text == "/arm/ready"
    assert filled.cells["topic"].text == "/arm/ready"
