"""Every statement of the language has its way through the wizard."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest
from wizard_courses import (
    ALL,
    CHANGE,
    MORE,
    PACKAGED,
    ROBOTS,
    SEND,
    TWO_NODES,
    applied,
    choose,
    course,
    formatted,
    put_beside,
    to_menu_or_review,
)
from wizard_driver import way_to

from plastron_tui.diagnostics import codes
from plastron_tui.language import DECLARATIONS, Declaration, SlotKind, Statement
from plastron_tui.language import statements as st
from plastron_tui.language.declaration import slot, statement
from plastron_tui.model.interpreter import HANDLERS
from plastron_tui.session import Options, Session
from plastron_tui.studio.wizard.filling import Filler
from plastron_tui.studio.wizard.form import Form
from plastron_tui.studio.wizard.form_rows import specs
from plastron_tui.studio.wizard.goals import Aim, aim_of, declarations_of
from plastron_tui.studio.wizard.kinds import KINDS
from plastron_tui.studio.wizard.pages import PageKind

MORE_TO_DO = """\
talker has_parameter 'speed' of parameter_type float with default 0.5
talker repeats blink at 2 hz
talker provides_action 'fetch' of action_type Fibonacci
talker sends_goal to 'carry' of action_type Fibonacci with input 5
generate_node talker
"""
EVERYTHING = TWO_NODES.replace("generate_node talker\n", MORE_TO_DO)


def keyword(declaration: Declaration) -> str:
    return declaration.keyword


def test_every_kind_of_slot_is_known() -> None:
    assert set(KINDS) == set(SlotKind)


def test_every_statement_is_in_one_menu() -> None:
    listed = [declaration for aim in Aim for declaration in declarations_of(aim)]
    assert sorted(listed, key=keyword) == sorted(DECLARATIONS.values(), key=keyword)


def test_every_statement_says_what_it_is_for() -> None:
    for declaration in ALL:
        assert declaration.purpose and declaration.about.endswith(".")
        assert declaration.keyword not in declaration.purpose
        assert len([d for d in ALL if d.purpose == declaration.purpose]) == 1


@pytest.mark.parametrize("declaration", ALL, ids=keyword)
def test_every_statement_is_built_of_suggestions_alone(
    declaration: Declaration, tmp_path: Path
) -> None:
    put_beside(tmp_path)
    text = EVERYTHING
    if aim_of(declaration) in (Aim.TYPE, Aim.PACKAGE, Aim.LAUNCH):
        text += PACKAGED
    if aim_of(declaration) is Aim.ROBOT:
        text += ROBOTS
    if declaration.undoes is not None:
        # Something is left for each node to do.
        text = text.replace("generate_node", "// generate_node")
    it = course(text, tmp_path)
    choose(it, *way_to(declaration))
    look = to_menu_or_review(it)
    assert it.page.kind is PageKind.REVIEW
    assert look.outcome is not None
    assert look.problems == ()
    after = applied(text.encode(), look.outcome.edits)
    assert after == look.outcome.session.document.text
    fresh = Session(after, tmp_path / "program.plastron", environ={})
    assert fresh.diagnostics == ()
    before = Session(text.encode(), tmp_path / "program.plastron", environ={})
    made = len([one for one in fresh.program.statements if type(one) is declaration.type])
    had = len([one for one in before.program.statements if type(one) is declaration.type])
    assert made == had + 1
    assert formatted(after) == after


USED_IN_FILES = {"rospy": (st.NoLongerHasParameter,), "rclpy": ()}
"""What these take away is used by functions that are in the file, and is left to the user."""


# In the quick suite each statement is for one of the libraries, in turn.
IN_FILES = [
    pytest.param(
        declaration,
        target,
        id=f"{declaration.keyword}-{target}",
        marks=() if number % 2 == column else pytest.mark.long,
    )
    for number, declaration in enumerate(declarations_of(Aim.MORE))
    for column, target in enumerate(["rospy", "rclpy"])
]


@pytest.mark.parametrize(("declaration", "target"), IN_FILES)
def test_a_file_that_is_loaded_can_be_changed_in_every_way(
    declaration: Declaration, target: str, tmp_path: Path
) -> None:
    everything = EVERYTHING.replace("'chatter'", "'news'").replace("listener", "talker")
    everything = everything.replace("create_node 'talker' as talker\nsubscribe", "subscribe")
    everything = everything.replace("generate_node talker\n\n", "")
    options = Options(target=target)
    maker = Session(everything.encode(), tmp_path / "maker.plastron", options, environ={})
    plan, problems = maker.plan()
    assert not problems
    (tmp_path / "robot.py").write_bytes(plan.files[0].text)
    it = course("", tmp_path)
    choose(it, CHANGE, *way_to(declaration)[1:])
    look = to_menu_or_review(it)
    assert look.problems == () and look.outcome is not None
    assert look.outcome.lines[0] == "load 'robot.py' as robot"
    assert look.outcome.lines[-1] == "generate_node robot"
    after = look.outcome.session
    assert after.diagnostics == ()
    changed, problems = after.plan()
    if declaration.type in USED_IN_FILES[target]:
        assert [(each.code, bool(each.help)) for each in problems] == [
            (codes.ENDPOINT_IN_USE, True)
        ]
        return
    # What logs the name by hand is told, and stays; so does a function that was called.
    assert {each.code for each in problems} <= {codes.STILL_NAMED, codes.UNCALLED_FUNCTION}
    assert changed.files[0].name == "robot.py"


TWO_IN_A_FILE = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Left(Node):
    def __init__(self):
        super().__init__("left")
        self.create_subscription(String, "in", print, 10)


class Right(Node):
    def __init__(self):
        super().__init__("right")
        self.create_subscription(String, "in", print, 10)
"""


def test_of_a_file_of_two_nodes_one_after_the_other_is_suggested(tmp_path: Path) -> None:
    (tmp_path / "arms.py").write_text(TWO_IN_A_FILE)
    text = ""
    for name in ("left", "right"):
        it = course(text, tmp_path)
        choose(it, CHANGE, SEND)
        look = to_menu_or_review(it)
        assert look.problems == () and look.outcome is not None
        assert f"load 'arms.py' node '{name}' as {name}" in look.outcome.lines
        text = look.outcome.session.document.text.decode()


@contextmanager
def added(type_: type[Statement]) -> Iterator[None]:
    """Let a statement be in the language, one of which nothing follows."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setitem(HANDLERS, type_, lambda *_: None)
        yield
    del DECLARATIONS[type_]


@pytest.fixture
def whistle() -> Iterator[Declaration]:
    """A statement that is added to the language."""

    @statement(
        "whistle_statement",
        "{node} whistle {message} to {topic} of message_type {type} [at {rate} hz]",
        summary="Let a node whistle a message.",
        example="talker whistle greeting to 'chatter' of message_type String",
    )
    class Whistle(Statement):
        node: str = slot(SlotKind.NODE, "the node that whistles")
        message: str = slot(SlotKind.MESSAGE, "what it whistles")
        topic: str = slot(SlotKind.TOPIC, "where it is heard")
        type: str = slot(SlotKind.MESSAGE_TYPE, "the type of that")
        rate: float | None = slot(SlotKind.RATE, "how often")

    with added(Whistle):
        yield DECLARATIONS[Whistle]


@pytest.fixture
def watch() -> Iterator[Declaration]:
    """Another one, in which only nodes are named."""

    @statement(
        "watch_statement",
        "watch {node} with {other}",
        summary="Let a node watch another one.",
        example="watch talker with listener",
    )
    class Watch(Statement):
        node: str = slot(SlotKind.NODE, "the node that is watched")
        other: str = slot(SlotKind.NODE, "the node that watches")

    with added(Watch):
        yield DECLARATIONS[Watch]


def test_a_statement_about_nodes_alone_is_something_that_a_node_does(watch: Declaration) -> None:
    assert aim_of(watch) is Aim.MORE
    assert watch not in declarations_of(Aim.WRITE)
    it = course(TWO_NODES)
    choose(it, MORE)
    assert "let a node watch another one" in [each.title for each in it.offers()]
    filled = Filler().fill(Form(watch), it.scene)
    assert filled.text == "watch listener with talker"
    assert [spec.label for spec in specs(filled)] == ["node", "other"]


@pytest.fixture
def relay() -> Iterator[Declaration]:
    """One in which two topics are named."""

    @statement(
        "relay_statement",
        "{node} relay {topic} into {other}",
        summary="Let a node send on what it hears.",
        example="talker relay 'chatter' into 'echo'",
    )
    class Relay(Statement):
        node: str = slot(SlotKind.NODE, "the node that relays")
        topic: str = slot(SlotKind.TOPIC, "where it listens")
        other: str = slot(SlotKind.TOPIC, "where it sends")

    with added(Relay):
        yield DECLARATIONS[Relay]


def test_two_slots_of_a_kind_are_not_filled_alike(relay: Declaration) -> None:
    filled = Filler().fill(Form(relay), course(TWO_NODES).scene)
    topics = [filled.cells[name].text for name in ("topic", "other")]
    assert len(set(topics)) == 2 and all(topics)


def test_a_statement_says_that_it_writes_a_file() -> None:
    said = [declaration.keyword for declaration in ALL if declaration.writes_file]
    known = ["generate_node", "generate_type", "generate_package", "generate_launch"]
    known.append("generate_robot")
    assert sorted(said) == sorted(each for each in known if each in map(keyword, ALL))
    assert [each.keyword for each in declarations_of(Aim.WRITE)] == ["generate_node"]


def test_a_statement_that_is_added_has_its_form(whistle: Declaration) -> None:
    """No line of the wizard knows of it; only the grammar, which does not, is asked in the end."""
    assert aim_of(whistle) is Aim.MORE
    it = course(TWO_NODES)
    choose(it, MORE)
    assert "let a node whistle a message" in [each.title for each in it.offers()]
    filled = Filler().fill(Form(whistle), it.scene)
    assert filled.text == (
        "listener whistle chatter_2_message to 'chatter_2' of message_type String at 10 hz"
    )
    assert [spec.label for spec in specs(filled)] == ["node", "message", "topic", "type", "rate"]
    assert [each.form.declaration.keyword for each in filled.makers] == ["create_message"]
