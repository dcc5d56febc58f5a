from __future__ import annotations

import pytest

from plastron_tui.language import Document
from plastron_tui.language.expectations import Expectation, ValuePlace, expected_at
from plastron_tui.language.keywords import FIRST_WORDS, VERBS

PUBLISH = "n publish m to 't' of message_type String"
PARAMETER = "n has_parameter 'p' of parameter_type float with default 1"


def at_bar(text: str) -> Expectation:
    """What is expected at the `|` of a text."""
    before, after = text.split("|")
    return expected_at(Document((before + after).encode()), len(before.encode()))


@pytest.mark.parametrize(
    ("text", "slot", "prefix"),
    [
        ("subscribe |", "node", ""),
        ("subscribe li|", "node", "li"),
        ("subscribe listener to |", "topic", ""),
        ("subscribe listener to 'cha|", "topic", "'cha"),
        ("subscribe listener to 'cha|tter' of message_type String", "topic", "'cha"),
        ("subscribe listener to 'cha| of message_type String", "topic", "'cha"),
        ("subscribe n to 't' of message_type |", "type", ""),
        ("subscribe n to 't' of message_type geometry_msgs/|", "type", "geometry_msgs/"),
        ("subscribe n to 't' of message_type geometry_msgs/Tw|", "type", "geometry_msgs/Tw"),
        ("subscribe n to 't' of message_type String calling |", "function", ""),
        ("n publish |", "message", ""),
        ("n publish m to 't' of message_type String at |", "rate", ""),
        (f"{PUBLISH} at parameter |", "rate", ""),
        (f"{PUBLISH} at parameter 'r|", "rate", "'r"),
        (f"{PUBLISH} for_each |", "trigger", ""),
        (f"{PUBLISH} for_each 'b' when |", "condition", ""),
        (f"{PUBLISH} for_each 'b' when any received.|", "condition", "received."),
        (f"{PUBLISH} with qos |", "qos", ""),
        (f"{PUBLISH} with qos depth 5, rel|", "qos", "rel"),
        (f"{PARAMETER} between |", "minimum", ""),
        (f"{PARAMETER} between 0 and |", "maximum", ""),
        (f"{PARAMETER} described_as |", "description", ""),
        ("n has_parameter 'p' of parameter_type |", "type", ""),
        ("n has_parameter 'p' of parameter_type float with default |", "default", ""),
        ("n client_requests 's' of service_type T with input none at |", "rate", ""),
        ("n provides_service 's' of service_type T answering |", "answer", ""),
        ("create_message m of message_type T and input x=received.|", "input", "received."),
        ("n repeats |", "function", ""),
        ("n stop_repeating |", "function", ""),
        ("n sends_goal to |", "action", ""),
        ("n provides_action 'a' of action_type |", "type", ""),
        ("n no_longer_has_parameter |", "parameter", ""),
        ("load two node |", "name", ""),
        ("create_node 't' as |", "variable", ""),
        ("create_node 't' as t using ro|", "library", "ro"),
        ("load |", "source", ""),
        ("load 'scr|", "source", "'scr"),
        ("generate_node |\nsubscribe n to 't' of message_type String\n", "node", ""),
        ("/* a\nb */ subscribe |", "node", ""),
        ("subscribe /* who */ |", "node", ""),
        ("unsubscribe é |", None, ""),
        ("create_node talker as |", "variable", ""),
        ("load my-driver.py as |", "variable", ""),
        ("subscribe to |", "topic", ""),
        ("publish |", "message", ""),
        ("subscribe to to |", "topic", ""),
        ("r has_link 'b' at |", "position", ""),
        ("r has_link 'b' at 0, |", "position", ""),
        ("r has_link 'b' at 0, 0, 0 |", None, ""),
        ("r has_link 'b' turned 0, 0, 90 |", "unit", ""),
        ("r has_link 'b' turned 0, 0, 90 de|", "unit", "de"),
        ("r has_link 'b' painted b|", "color", "b"),
        ("r has_joint 'j' of joint_type fixed from 'a' to '|", "child", "'"),
        ("r limits_joint 'j' between 0 and 1 |", "unit", ""),
    ],
)
def test_slot(text: str, slot: str | None, prefix: str) -> None:
    expected = at_bar(text)
    assert (expected.slot.name if expected.slot else None, expected.prefix) == (slot, prefix)


@pytest.mark.parametrize(
    ("text", "keywords"),
    [
        ("|", FIRST_WORDS),
        ("sub|", FIRST_WORDS),
        ("create_node 'a' as a\n|\nload b as b", FIRST_WORDS),
        ("talker |", VERBS),
        ("talker pub|", VERBS),
        ("subscribe n |", ("to",)),
        ("subscribe n to 't' o|", ("of",)),
        ("subscribe n to 't' of |", ("message_type",)),
        ("subscribe n to 't' of message_type String |", ("with", "calling")),
        ("subscribe n to 't' of message_type String calling f |", ("with",)),
        ("subscribe n to 't' of message_type String with qos latched |", ("calling",)),
        ("subscribe n to 't' of message_type String with qos latched, |", ()),
        (f"{PUBLISH} |", ("at", "once", "for_each", "with")),
        (f"{PUBLISH} at parameter |", ()),
        (f"{PUBLISH} at parameter 'r' |", ("hz",)),
        (f"{PUBLISH} at 5 hz |", ("with",)),
        (f"{PUBLISH} for_each 'b' |", ("when", "with")),
        (f"{PUBLISH} for_each 'b' when any |", ()),
        (f"{PUBLISH} for_each 'b' when received.x < |", ()),
        (f"{PUBLISH} for_each 'b' when received.x < 5 |", ("with",)),
        (f"{PUBLISH} with qos depth 5 |", ("at", "once", "for_each")),
        (f"{PUBLISH} with qos latched once |", ()),
        ("n client_requests 's' of service_type T with input none |", ("at",)),
        ("n client_requests 's' of service_type T with input x=1 |", ("at",)),
        ("n client_requests 's' of service_type T with input x=1, |", ()),
        ("n client_requests 's' of service_type T with input (x=1 |", ()),
        ("n provides_service 's' of service_type T |", ("answering", "calling")),
        ("n provides_service 's' of service_type T answering |", ("none",)),
        ("n provides_service 's' of service_type T answering x=1 |", ("calling",)),
        (f"{PARAMETER} |", ("between", "described_as")),
        (f"{PARAMETER} between 0 |", ("and",)),
        (f"{PARAMETER} between 0 and 2 |", ("described_as",)),
        (f'{PARAMETER} described_as "x" |', ("between",)),
        ("create_node 'a' as n |", ("managed", "using")),
        ("create_node 'a' as n managed |", ("using",)),
        ("load two |", ("node", "as")),
        ("n repeats f |", ("at",)),
        ("n sends_goal |", ("to",)),
        ("n publish m to 't' of message_type String at 5 |", ("hz",)),
        ("create_message m of message_type Point and input |", ("none",)),
        ("create_message m of message_type Point and input 1, |", ()),
        ("create_message m of message_type Point and input none |", ()),
        ("create_message of |", ("message_type",)),
        ('create_message m of message_type String and input "no|', ()),
        ("subscribe n foo |", ()),
        ("generate_node n using rospy |", ()),
        ("r has_link 'b' shaped box |", ()),
        ("r has_link 'b' shaped box 1, 2, 3 |", ("weighing", "painted", "at", "turned")),
        ("r has_link 'b' at 0, 0 |", ()),
        ("r has_link 'b' at 0, 0, 0 turned 0, 0, 9 deg |", ("shaped", "weighing", "painted")),
        (
            "r has_joint 'j' of joint_type fixed from 'a' to 'b' mimicking 'k' times 2 |",
            ("at", "turned", "with"),
        ),
        ("r limits_joint 'j' |", ("between", "with")),
        ("r limits_joint 'j' with |", ("effort", "damping")),
        ("r limits_joint 'j' with damping 1 and friction 2 |", ("between", "with")),
        ("r limits_joint 'j' with damping 1 and friction 2 with |", ("effort",)),
        ("// subscribe |", ()),
        ("subscribe /* n| */", ()),
        ("subscribe n // |", ()),
    ],
)
def test_keywords(text: str, keywords: tuple[str, ...]) -> None:
    assert at_bar(text).keywords == keywords


@pytest.mark.parametrize(
    ("values", "place"),
    [
        ("|", ValuePlace()),
        ("1, |", ValuePlace(index=1)),
        ("x=1, |", ValuePlace(index=1, used=frozenset({"x"}))),
        ("linear.|", ValuePlace()),
        ("linear.x=|", ValuePlace(name="linear.x", used=frozenset({"linear.x"}))),
        ("(|", ValuePlace(path=(0,))),
        ("(1,2,3), (1, |", ValuePlace(path=(1,), index=1)),
        ("linear=(x=1, |", ValuePlace(path=("linear",), index=1, used=frozenset({"x"}))),
        ("linear=(1,2,3), |", ValuePlace(index=1, used=frozenset({"linear"}))),
        ("ranges=[1, |", ValuePlace(path=("ranges",), index=1, is_list=True)),
        ('"(', ValuePlace(is_text=True)),
    ],
)
def test_place_in_values(values: str, place: ValuePlace) -> None:
    text = f"create_message m of message_type T and input {values}"
    assert at_bar(text if "|" in text else text + "|").values == place


def test_span_is_the_whole_word() -> None:
    expected = at_bar("subscribe lis|tener to 'chatter'")
    assert tuple(expected.span) == (10, 18)
    assert expected.prefix == "lis"


def test_filled_slots_are_those_before() -> None:
    expected = at_bar("subscribe n to 'topic' of message_type |")
    assert expected.filled == {"node": "n", "topic": "'topic'"}


def test_the_statement_is_known_by_its_keyword_wherever_the_place_is() -> None:
    for text in ("talker| publish m", "|talker publish m", "talker publish m|"):
        declaration = at_bar(text).declaration
        assert declaration is not None
        assert declaration.keyword == "publish"


def test_the_statement_is_known_by_its_keyword_where_its_node_is_left_out() -> None:
    expected = at_bar("|publish m to 'chatter'")
    assert expected.declaration is not None
    assert expected.declaration.keyword == "publish"
    assert expected.element is expected.slot


def test_after_none_there_are_no_values() -> None:
    expected = at_bar("create_message m of message_type Point and input none |")
    assert (expected.slot, expected.values) == (None, None)


def test_every_place_of_every_prefix_of_a_program_has_an_answer() -> None:
    line = "n client_requests 's' of service_type a/srv/B with input x=(1,[2]), \"é\" // c"
    for cut in range(len(line) + 1):
        document = Document(line[:cut].encode())
        for offset in range(len(document.text) + 1):
            expected = expected_at(document, offset)
            assert 0 <= expected.span.start <= offset <= expected.span.end
