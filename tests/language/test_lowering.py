from __future__ import annotations

import math

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from machine import examples
from plastron_programs import argument, read, shape, statements

from plastron_tui.diagnostics import escapes
from plastron_tui.language import DECLARATIONS, Clause, Document, lower
from plastron_tui.language.inputs import DEEPEST_NESTING, Literal
from plastron_tui.language.statements import CreateMessage

CASES = {
    "create_node 'talker' as n": ("CreateNode", "talker", "n", False, None),
    "create_node 'talker' as n using rclpy": ("CreateNode", "talker", "n", False, "rclpy"),
    "create_node 'talker' as n managed": ("CreateNode", "talker", "n", True, None),
    "create_node 'talker' as n using rclpy managed": ("CreateNode", "talker", "n", True, "rclpy"),
    "load talker_pub as n": ("Load", "talker_pub", None, "n"),
    "load two node 'a' as n": ("Load", "two", "a", "n"),
    "load 'a b/c.py' as n": ("Load", "a b/c.py", None, "n"),
    "create_message m of message_type Point and input 1, .5": (
        "CreateMessage",
        "m",
        "Point",
        ("1", "0.5"),
    ),
    "create_message m of message_type a/B and input none": ("CreateMessage", "m", "a/B", ()),
    "create_message m of message_type a/msg/B and input x=1": (
        "CreateMessage",
        "m",
        "a/msg/B",
        (("x", "=", "1"),),
    ),
    "subscribe n to '/a/b' of message_type String": (
        "Subscribe",
        "n",
        "/a/b",
        "String",
        None,
        None,
    ),
    "subscribe n to 'a' of message_type String calling f with qos depth 5, reliable": (
        *("Subscribe", "n", "a", "String", "depth 5 reliable None", "f"),
    ),
    "subscribe n to '~a' of message_type String calling _f": (
        "Subscribe",
        "n",
        "~a",
        "String",
        None,
        "_f",
    ),
    "unsubscribe n from 'a'": ("Unsubscribe", "n", "a"),
    "n publish m to 'a' of message_type String": (
        *("Publish", "n", "m", "a", "String", None, False, None, None, None),
    ),
    "n publish m to 'a' of message_type String at parameter 'r' hz": (
        *("Publish", "n", "m", "a", "String", "parameter r", False, None, None, None),
    ),
    "n publish m to 'a' of message_type String with qos latched once": (
        *("Publish", "n", "m", "a", "String", None, True, None, None, "latched None"),
    ),
    "n publish m to 'a' of message_type String for_each 'b' with qos depth 2": (
        *("Publish", "n", "m", "a", "String", None, False, "b", None, "depth 2"),
    ),
    "n publish m to 'a' of message_type String for_each 'b' when any received.x.y < 0.5": (
        *("Publish", "n", "m", "a", "String", None, False, "b"),
        *(("any", "received x.y", "<", "0.5"), None),
    ),
    "n publish m to 'a' of message_type String for_each 'b' when received.any[1] = \"x\"": (
        *("Publish", "n", "m", "a", "String", None, False, "b"),
        *((None, "received any[1]", "=", "'x'"), None),
    ),
    "n publish m to 'a' of message_type String at 2.5 hz": (
        "Publish",
        "n",
        "m",
        "a",
        "String",
        2.5,
        False,
        None,
        None,
        None,
    ),
    "n stop_publishing to 'a'": ("StopPublishing", "n", "a"),
    "n client_requests 's' of service_type T with input 1, True": (
        "ClientRequests",
        "n",
        "s",
        "T",
        ("1", "True"),
        None,
    ),
    "n client_requests 's' of service_type T with input at=1, 2 at parameter 'r' hz": (
        *("ClientRequests", "n", "s", "T", (("at", "=", "1"), "2"), "parameter r"),
    ),
    "n client_requests 's' of service_type T with input none": (
        "ClientRequests",
        "n",
        "s",
        "T",
        (),
        None,
    ),
    "n client_requests 's' of service_type T with input none at 2 hz": (
        *("ClientRequests", "n", "s", "T", (), 2),
    ),
    "n stop_request 's'": ("StopRequest", "n", "s"),
    "n provides_service 's' of service_type T": ("ProvidesService", "n", "s", "T", None, None),
    "n provides_service 's' of service_type T answering none": (
        *("ProvidesService", "n", "s", "T", (), None),
    ),
    "n provides_service 's' of service_type T calling f answering a=received.b + 1, 2": (
        *("ProvidesService", "n", "s", "T", (("a", "=", "received b + 1"), "2"), "f"),
    ),
    "n provides_service 's' of service_type T calling f": (
        "ProvidesService",
        "n",
        "s",
        "T",
        None,
        "f",
    ),
    "n stop_service 's'": ("StopService", "n", "s"),
    "n provides_action 'a' of action_type T": ("ProvidesAction", "n", "a", "T", None),
    "n provides_action 'a' of action_type p/action/T calling f": (
        *("ProvidesAction", "n", "a", "p/action/T", "f"),
    ),
    "n stop_action 'a'": ("StopAction", "n", "a"),
    "n sends_goal to 'a' of action_type T with input x=parameter 'p' * 2": (
        *("SendsGoal", "n", "a", "T", (("x", "=", "parameter p * 2"),)),
    ),
    "n sends_goal to 'a' of action_type T with input none": ("SendsGoal", "n", "a", "T", ()),
    "n stop_goal to 'a'": ("StopGoal", "n", "a"),
    "n has_parameter 'p' of parameter_type float with default -0.5": (
        *("HasParameter", "n", "p", "float", "-0.5", None, None, None),
    ),
    "n has_parameter 'p' of parameter_type int with default 1 between -1 and +2": (
        *("HasParameter", "n", "p", "int", "1", -1, 2, None),
    ),
    "n has_parameter 'p' of parameter_type int_list with default [1] described_as \"x\"": (
        *("HasParameter", "n", "p", "int_list", ["list", "1"], None, None, "x"),
    ),
    "n has_parameter 'p' of parameter_type int with default 1 described_as \"x\" between 0 and 2": (
        *("HasParameter", "n", "p", "int", "1", 0, 2, "x"),
    ),
    "n no_longer_has_parameter 'p'": ("NoLongerHasParameter", "n", "p"),
    "n repeats f at 2 hz": ("Repeats", "n", "f", 2),
    "repeats repeats _f at parameter 'r' hz": ("Repeats", "repeats", "_f", "parameter r"),
    "n stop_repeating f": ("StopRepeating", "n", "f"),
    "n renames topic 's' to 'a/s'": ("Rename", "n", "topic", "s", "a/s"),
    "generate_node n": ("GenerateNode", "n", None),
    "generate_node n using rospy": ("GenerateNode", "n", "rospy"),
    "create_message_type A with none": ("CreateMessageType", "A", ()),
    'create_message_type p/A with string <= 10 x default "a", p/B[<=3] y, uint8 OK = 1': (
        *("CreateMessageType", "p/A"),
        (
            ("string<=10", "x", "default", "'a'"),
            ("p/B[<=3]", "y", "", None),
            ("uint8", "OK", "=", "1"),
        ),
    ),
    "create_service_type A with bool with returning int32[2] returning": (
        *("CreateServiceType", "A", (("bool", "with", "", None),)),
        (("int32[2]", "returning", "", None),),
    ),
    "create_action_type A with none returning bool a reporting none": (
        *("CreateActionType", "A", (), (("bool", "a", "", None),), ()),
    ),
    "load_type 'msg/A.msg' as A": ("LoadType", "msg/A.msg", "A"),
    'A has_field "x"': ("HasField", "A", "x", None),
    'A has_field "x" in response': ("HasField", "A", "x", "response"),
    "A no_longer_has_field 'x'": ("NoLongerHasField", "A", "x", None),
    "A no_longer_has_field 'x' in goal": ("NoLongerHasField", "A", "x", "goal"),
    "drop_type A": ("DropType", "A"),
    "generate_type A": ("GenerateType", "A"),
    "create_package 'p' as p": ("CreatePackage", "p", "p", None, None, None),
    "create_package 'p' as p described_as \"d\"": ("CreatePackage", "p", "p", "d", None, None),
    'create_package \'p\' as p licensed_under "MIT" maintained_by "<a@b.c>"': (
        *("CreatePackage", "p", "p", None, "<a@b.c>", "MIT"),
    ),
    'create_package \'p\' as p licensed_under "MIT" described_as "d"': (
        *("CreatePackage", "p", "p", "d", None, "MIT"),
    ),
    "load_package 'src/p' as p": ("LoadPackage", "src/p", "p"),
    "p contains n": ("Contains", "p", "n", None),
    "contains contains contains as 'n'": ("Contains", "contains", "contains", "n"),
    "p no_longer_contains n": ("NoLongerContains", "p", "n"),
    "p no_longer_contains 'n'": ("NoLongerContains", "p", "'n'"),
    "generate_package p": ("GeneratePackage", "p"),
    "create_launch 'l' as l": ("CreateLaunch", "l", "l"),
    "load_launch 'a/l.launch' as l": ("LoadLaunch", "a/l.launch", "l"),
    "l has_argument 'a'": ("HasArgument", "l", "a", None),
    "l has_argument 'a' with default [1]": ("HasArgument", "l", "a", ["list", "1"]),
    "l no_longer_has_argument 'a'": ("NoLongerHasArgument", "l", "a"),
    "l starts n": ("Starts", "l", "n", *(None,) * 6),
    "l starts 'p/n' as 'm'": ("Starts", "l", "'p/n'", "m", *(None,) * 5),
    "l starts starts in 's' inside 'c'": (
        *("Starts", "l", "starts", None, "s", "c", None, None, None),
    ),
    "l starts n inside 'c'": ("Starts", "l", "n", None, None, "c", None, None, None),
    "l starts n with parameters 'f.yaml' remapping 'a' to 'b', 'c' to 'd'": (
        *("Starts", "l", "n", None, None, None, (("a", "b"), ("c", "d")), None, "f.yaml"),
    ),
    "l starts n setting 'a' = 5, 'b' = [True] as 'm'": (
        *("Starts", "l", "n", "m", None, None, None),
        *((("a", "5"), ("b", ["list", "True"])), None),
    ),
    "l starts n with parameters 'f.yaml'": ("Starts", "l", "n", *(None,) * 5, "f.yaml"),
    "l no_longer_starts 'n'": ("NoLongerStarts", "l", "n"),
    "l includes 'p/a.launch'": ("Includes", "l", "p/a.launch"),
    "l no_longer_includes 'p/a.launch'": ("NoLongerIncludes", "l", "p/a.launch"),
    "generate_launch l": ("GenerateLaunch", "l"),
}


@pytest.mark.parametrize(("text", "expected"), CASES.items(), ids=list(CASES))
def test_a_statement_becomes_its_slots(text: str, expected: tuple[object, ...]) -> None:
    program = read(text + "\n")
    assert program.diagnostics == ()
    assert shape(program) == [expected]


def test_the_cases_have_every_statement_with_and_without_its_clauses() -> None:
    counts = {declaration.type.__name__: 0 for declaration in DECLARATIONS.values()}
    for expected in CASES.values():
        counts[str(expected[0])] += 1
    for declaration in DECLARATIONS.values():
        clauses = sum(isinstance(element, Clause) for element in declaration.elements)
        assert counts[declaration.type.__name__] >= 1 + clauses


@pytest.mark.parametrize("text", CASES, ids=list(CASES))
@pytest.mark.parametrize(
    "comment", ["/* c */", "/* two\nlines */", "/**/", "\t", "\ufeff", "/* 'a' \" as */"]
)
def test_comments_and_space_between_words_say_nothing(text: str, comment: str) -> None:
    spread = f" {comment} ".join(text.split(" ")) if "a b" not in text else text
    program = read(spread + " // the end\n")
    assert program.diagnostics == ()
    assert shape(program) == [CASES[text]]


@pytest.mark.parametrize(
    "wrap",
    ["{}", "{}\n", "{}\r\n", "\r\n{}\r\n\r\n", "\ufeff{}\n", "\n\n  {}", "// c\n{} // d"],
    ids=["none", "newline", "crlf", "crlf around", "byte order mark", "spaces", "comments"],
)
def test_what_is_around_a_statement_says_nothing(wrap: str) -> None:
    for text, expected in CASES.items():
        program = read(wrap.format(text))
        assert program.diagnostics == ()
        assert shape(program) == [expected]


def test_statements_come_in_their_order_around_a_broken_line() -> None:
    program = read("create_node 'a' as n\nsubscribe n\ngenerate_node n\n")
    assert [type(found).__name__ for found in program.statements] == ["CreateNode", "GenerateNode"]
    assert [found.code for found in program.diagnostics] == ["syntax-error"]


def test_a_statement_knows_where_its_slots_are() -> None:
    text = "subscribe nö to 'a' of message_type String // ö\n".replace("nö", "n")
    (statement,) = read("// ö\n" + text).statements
    start = len("// ö\n".encode())
    assert statement.span == (start, start + len("subscribe n to 'a' of message_type String"))
    assert statement.span_of("topic") == (start + 15, start + 18)
    assert statement.span_of("function") == statement.span


NUMBERS = {
    "5": 5,
    "-5": -5,
    "+5": 5,
    "-0": 0,
    "007": 7,
    "0.25": 0.25,
    ".5": 0.5,
    "-.5": -0.5,
    "5.": 5.0,
    "1e-3": 0.001,
    "1E+3": 1000.0,
    "1e999": math.inf,
    "-1e999": -math.inf,
    "1e-999": 0.0,
    "9" * 5000: math.inf,
    "-" + "9" * 5000: -math.inf,
    "9" * 400: int("9" * 400),
    "0." + "3" * 5000: float("0." + "3" * 50),
}


@pytest.mark.parametrize(("text", "value"), NUMBERS.items(), ids=[key[:12] for key in NUMBERS])
def test_numbers(text: str, value: float) -> None:
    (found,) = values_of(text)
    assert isinstance(found, Literal)
    assert found.value == value
    assert type(found.value) is type(value)


STRINGS = {
    '""': "",
    '"a b"': "a b",
    '" a "': " a ",
    r'"\"\\\n\t"': '"\\\n\t',
    r'"\u00e9\u0041"': "éA",
    r'"\ud83d\ude00"': "😀",
    r'"a\ud83d\ude00b\ud83d"': "a😀b\ud83d",
    r'"\ude00\ud83d"': "\ude00\ud83d",
    r'"\u0000"': "\0",
    r'"\\u0041"': "\\u0041",
    '"// no /* comment */"': "// no /* comment */",
    '"it\'s, ok"': "it's, ok",
    '"世界🐢é"': "世界🐢é",
    '"{{ x }} {% y %}"': "{{ x }} {% y %}",
    '"\u202eabc"': "\u202eabc",
    '"\ufeff"': "\ufeff",
    '"tab\there"': "tab\there",
}


@pytest.mark.parametrize(("text", "value"), STRINGS.items())
def test_strings(text: str, value: str) -> None:
    (found,) = values_of(text)
    assert isinstance(found, Literal)
    assert found.value == value


@pytest.mark.parametrize(("escape", "meaning"), escapes.MEANINGS.items())
def test_what_is_listed_as_an_escape_is_one(escape: str, meaning: str) -> None:
    (found,) = values_of(f'"a{escape}b"')
    assert isinstance(found, Literal)
    assert found.value == f"a{meaning}b"


@given(st.text(st.characters(exclude_characters='"\\\r\n', exclude_categories=["Cs"])))
def test_a_string_is_what_stands_in_it(text: str) -> None:
    (found,) = values_of(f'"{text}"')
    assert isinstance(found, Literal)
    assert found.value == text


SHAPES = {
    "True, False": ["True", "False"],
    "[]": [["list"]],
    "[1, [2], []]": [["list", "1", ["list", "2"], ["list"]]],
    "()": [["nested"]],
    "(1, x=2), y = (z.w = [()])": [
        ["nested", "1", ("x", "=", "2")],
        ("y", "=", ["nested", ("z.w", "=", ["list", ["nested"]])]),
    ],
    "to=1, none=2, True=3, publish . x = 4": [
        ("to", "=", "1"),
        ("none", "=", "2"),
        ("True", "=", "3"),
        ("publish.x", "=", "4"),
    ],
    "a /* c */ . /* d */ b = /* e */ [ /* f */ 1 /* g */ ]": [("a.b", "=", ["list", "1"])],
    "parameter 'p', [parameter '~q'], (x=parameter 'r')": [
        "parameter p",
        ["list", "parameter ~q"],
        ["nested", ("x", "=", "parameter r")],
    ],
    "received.a, received.b.to[3], x = received . none": [
        "received a",
        "received b.to[3]",
        ("x", "=", "received none"),
    ],
    "received.a-1, received.a - -1, received.a * 2 + .5 / 3": [
        "received a - 1",
        "received a - -1",
        "received a * 2 + 0.5 / 3",
    ],
    "received /* c */ . /* d */ a /* e */ [ /* f */ 1 ] /* g */ * /* h */ 2": ["received a[1] * 2"],
    "parameter=1, received=2, received.x=3, parameter.x=4, x.received=5, x.parameter=6": [
        ("parameter", "=", "1"),
        ("received", "=", "2"),
        ("received.x", "=", "3"),
        ("parameter.x", "=", "4"),
        ("x.received", "=", "5"),
        ("x.parameter", "=", "6"),
    ],
}


@pytest.mark.parametrize(("text", "expected"), SHAPES.items())
def test_values_of_values(text: str, expected: list[object]) -> None:
    assert [argument(value) for value in values_of(text)] == expected


def values_of(text: str) -> tuple[object, ...]:
    program = read(f"create_message m of message_type T and input {text}\n")
    assert program.diagnostics == ()
    (statement,) = program.statements
    assert isinstance(statement, CreateMessage)
    return statement.input


@pytest.mark.parametrize(("opening", "closing"), ["()", "[]", ("(x=", ")"), ("([", "])")])
def test_nesting_has_a_limit(opening: str, closing: str) -> None:
    each = opening.count("(") + opening.count("[")

    def nested(depth: int) -> str:
        values = opening * depth + "1" + closing * depth
        return f"create_message m of message_type T and input {values}\ngenerate_node n\n"

    assert read(nested(DEEPEST_NESTING // each)).diagnostics == ()
    for depth in (DEEPEST_NESTING // each + 1, 20_000):
        program = read(nested(depth))
        assert [found.code for found in program.diagnostics] == ["too-deep"]
        assert [type(found).__name__ for found in program.statements] == ["GenerateNode"]
        assert "m" in program.broken.declared


@settings(max_examples=examples(100), deadline=None)
@given(st.lists(statements(), max_size=6), st.sampled_from(["\n", "\r\n", "\n\n // c\n"]))
def test_every_statement_is_lowered(lines: list[str], ending: str) -> None:
    program = lower(Document(ending.join(lines).encode()))
    assert program.diagnostics == ()
    assert len(program.statements) == len(lines)
