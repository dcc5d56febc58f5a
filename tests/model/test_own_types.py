"""Interface types of the program's own: what they become, and what is wrong with them."""

from __future__ import annotations

import pytest
from workspaces import marked, run

from plastron_tui.model.interpreter import Interpretation

A = "create_message_type A with int32 x\n"
B = f"{A}create_message_type B with A a\n"
S = "create_service_type S with int32 x returning none\n"
USED = f"{A}create_message m of message_type A and input x=5\n"
ROSPY = "create_node 'n' as n using rospy\n"
RCLPY = "create_node 'n' as n using rclpy\n"

VALUE = "'b\\\\c'"
SLASH = f'A has_field "string y {VALUE}"'
LISTED = "create_message_type A with string[] x default "
QUOTES = '["a\'\\""]'

MADE = {
    "create_message_type A with none\n": "",
    A: "int32 x\n",
    B: "A a\n",
    "create_message_type A with float64 x, uint8 OK = 1\n": "uint8 OK=1\nfloat64 x\n",
    "create_message_type A with Point[] path, string label\n": (
        "geometry_msgs/Point[] path\nstring label\n"
    ),
    'create_message_type A with string NAME = "a b"\n': 'string NAME="a b"\n',
    "create_message_type A with int32[3] x default [1, 2, 3]\n": "int32[3] x [1, 2, 3]\n",
    "create_message_type A with string<=5[<=3] names\n": "string<=5[<=3] names\n",
    'create_message_type A with string[] x default ["a \\"b\\"", "c"]\n': (
        'string[] x [\'a "b"\', "c"]\n'
    ),
    S: "int32 x\n---\n",
    "create_action_type A with none returning bool ok reporting float32 left\n": (
        "---\nbool ok\n---\nfloat32 left\n"
    ),
    f'{A}A has_field "float64 y"\n': "int32 x\nfloat64 y\n",
    f'{A}A has_field "float64 x"\n': "float64 x\n",
    f'{A}A has_field "Point p"\n': "int32 x\ngeometry_msgs/Point p\n",
    f"{A}A no_longer_has_field 'x'\n": "",
    f'{S}S has_field "bool ok" in response\n': "int32 x\n---\nbool ok\n",
    f"{S}S no_longer_has_field 'x' in request\n": "---\n",
}

LONG = "A" + "a" * 279
WORDS = "Aa" * 90
WRONG: list[tuple[str, str, str, str, str | None]] = [
    ("", "create_message_type wheel_speed with none", "bad-type-name", "wheel_speed",
     "write `WheelSpeed`"),
    ("", "create_message_type p/msg/A with none", "bad-type-name", "p/msg/A", "write `p/A`"),
    ("", "create_message_type Bad/A with none", "bad-type-name", "Bad/A", None),
    ("", "create_message_type std_msgs/A with none", "type-exists", "std_msgs/A", "leave"),
    ("", f"create_message_type {LONG} with none", "bad-type-name", LONG, None),
    ("", f"create_action_type {WORDS} with none returning none reporting none",
     "bad-type-name", WORDS, None),
    ("", f"create_message_type {LONG.lower()}/A with none", "bad-type-name",
     f"{LONG.lower()}/A", None),
    (A, "create_message_type A with none", "type-exists", "A", "`A has_field"),
    (A, "create_service_type a with none returning none", "bad-type-name", "a", "`A`"),
    ("create_message_type HTTPServer with none\n", "create_message_type HttpServer with none",
     "type-exists", "HttpServer", "another name"),
    (RCLPY, "create_message_type n with none", "variable-exists", "n", None),
    (A, "create_node 'n' as A", "variable-exists", "A", None),
    ("", "create_message_type A with float64 leftWheel", "bad-field", "leftWheel", "lower-case"),
    ("", "create_message_type A with int32 x, bool x", "bad-field", "x", None),
    ("", "create_message_type A with int32 class", "bad-field", "class", None),
    ("", "create_message_type A with flot64 x", "unknown-type", "flot64", "`float64`"),
    ("", "create_message_type A with Nowhere x", "unknown-type", "Nowhere", None),
    ("", "create_message_type A with A x", "circular-type", "A", None),
    ("", "create_message_type A with A[] x", "circular-type", "A[]", None),
    ("", "create_message_type A with uint8 X = 300", "bad-field", "300", None),
    ("", "create_message_type A with uint8 X = parameter 'a'", "bad-field", "parameter 'a'", None),
    ("", 'create_message_type A with string<=3 x default "abcd"', "bad-field", '"abcd"', None),
    ("", "create_message_type A with int32<=3 x", "bad-field", "int32<=3", None),
    ("", 'create_message_type A with string X = "a\\\\b"', "bad-field", '"a\\\\b"', None),
    ("", 'create_message_type A with string[] x default ["é"]', "bad-field", '["é"]', None),
    ("", "create_message_type A with int32 linux", "bad-field", "linux", None),
    (A, 'A has_field "int32 x"', "field-exists", '"int32 x"', None),
    (A, 'A has_field "int32"', "bad-field", '"int32"', "float64 x"),
    ("", 'create_message_type A with string x default "a\u2028b"', "bad-field", '"a\u2028b"', None),
    (A, SLASH, "bad-field", VALUE, None),
    ("", f"{LISTED}{QUOTES}", "bad-field", QUOTES, None),
    (A, 'A has_field "foo y"', "unknown-type", "foo", None),
    (A, 'A has_field "A a"', "circular-type", "A", None),
    (A, 'A has_field "  int32 class"', "bad-field", "class", "class_value"),
    (A, 'A has_field "Pose2D  class"', "bad-field", "class", "class_value"),
    (A, 'A has_field "string<=2 y \'äöü\'"', "bad-field", "'äöü'", None),
    ("", LISTED + '["\\""]', "bad-field", '["\\""]', None),
    ("", LISTED + '["\\"ab\\""]', "bad-field", '["\\"ab\\""]', None),
    (A, 'A has_field "uint8 \\u004eO = 300 # high"', "bad-field", "300", None),
    (A, 'A has_field "int32<=2 y"', "bad-field", "<=2", None),
    (A, 'A has_field "int32 linux"', "bad-field", "linux", None),
    (A, 'A has_field "string y \'\U0001f600\tb\'"', "bad-field", "\t", "t"),
    (A, 'A has_field "string y \'\\ud83d\\ude00\\tb\'"', "bad-field", "\\t", "t"),
    (A, 'A has_field "string<=3 y \'a\\\\tb\'"', "bad-field", "'a\\\\tb'", None),
    ("", 'create_message_type A with string<=3 x default "a\\tb"', "bad-field", '"a\\tb"', None),
    (A, 'A has_field "int32 y" in response', "no-such-field", "response", "leave it out"),
    (S, 'S has_field "int32 y" in respons', "no-such-field", "respons", "`response`"),
    (S, "S no_longer_has_field 'x' in response", "no-such-field", "'x'", None),
    (A, "A no_longer_has_field 'y'", "no-such-field", "'y'", None),
    (A, "AA no_longer_has_field 'x'", "unknown-own-type", "AA", "`A`"),
    (RCLPY, "n no_longer_has_field 'x'", "unknown-own-type", "n", "`n` is a node"),
    ("", 'String has_field "int32 x"', "unknown-own-type", "String", None),
    (B, 'A has_field "B b"', "circular-type", "B", None),
    (B, "drop_type A", "type-in-use", "drop_type A", None),
    (USED, "drop_type A", "type-in-use", "drop_type A", None),
    (USED, "A no_longer_has_field 'x'", "type-in-use", "A no_longer_has_field 'x'", None),
    (USED, 'A has_field "string x"', "type-in-use", 'A has_field "string x"', None),
    ("", "generate_type A", "unknown-own-type", "A", None),
    ("", "load_type 'a.msg' as A", "file-not-found", "'a.msg'", None),
]  # fmt: skip


def text_of(found: Interpretation, version: int = 2) -> str:
    [*_, own] = found.workspace.types.values()
    return own.definitions[version].text.decode()


@pytest.mark.parametrize(("text", "definition"), MADE.items(), ids=list(MADE))
def test_a_type_becomes_its_definition(text: str, definition: str) -> None:
    found = run(text, "rclpy")
    assert list(found.diagnostics) == []
    assert text_of(found) == definition


@pytest.mark.parametrize(
    ("before", "line", "code", "where", "remedy"), WRONG, ids=[each[1] for each in WRONG]
)
def test_what_is_wrong(before: str, line: str, code: str, where: str, remedy: str | None) -> None:
    text = f"{before}{line}\n"
    [found] = run(text, "rclpy").diagnostics
    assert (found.code, marked(text, found)) == (code, where)
    assert remedy is None or remedy in (found.help or "")


@pytest.mark.parametrize("line", [each[:2] for each in WRONG if each[0]])
def test_a_mistake_changes_no_type(line: tuple[str, str]) -> None:
    before = run(line[0], "rclpy").workspace.types
    after = run(f"{line[0]}{line[1]}\n", "rclpy").workspace.types
    assert {name: each.definitions for name, each in after.items()} == {
        name: each.definitions for name, each in before.items()
    }


def test_ros_1_makes_folders_of_a_package_and_a_type() -> None:
    package, name = "a" * 150, "A" + "a" * 50
    text = f"create_message_type {package}/{name} with none\n"
    [found] = run(text, "rospy").diagnostics
    assert (found.code, marked(text, found)) == ("bad-type-name", f"{package}/{name}")
    assert list(run(text, "rclpy").diagnostics) == []


def test_who_uses_a_type_is_told() -> None:
    text = f"{USED}A no_longer_has_field 'x'\n"
    [found] = run(text, "rclpy").diagnostics
    [label] = found.labels
    start, end = label.span
    assert text[start:end].startswith("create_message m")


PACKAGES = {
    (A, 1): "program_interfaces",
    (A, 2): "program_interfaces",
    (f"{A}create_package 'rover' as rover\n", 1): "rover",
    (f"{A}create_package 'rover' as rover\n", 2): "rover_interfaces",
    ("create_message_type own_msgs/A with int32 x\n", 2): "own_msgs",
}


@pytest.mark.parametrize(("text", "version"), PACKAGES, ids=str)
def test_a_type_belongs_to_the_package(text: str, version: int) -> None:
    found = run(text, "rclpy", program="program")
    [(_, name)] = found.own_types[version]
    assert str(name) == f"{PACKAGES[text, version]}/A"


LATER = [
    ("create_message_type A with B b\ncreate_message_type B with A a\n", "circular-type",
     "`A` contains itself: `A` in `B` in `A`", "B"),
    ("create_message_type A with B[] b\ncreate_message_type B with p/C c\n"
     "create_message_type p/C with string s, A[<=3] a\n", "circular-type",
     "`A` contains itself: `A` in `C` in `B` in `A`", "B[]"),
    (f'{A}A has_field "B b"\ncreate_message_type B with A a\n', "circular-type",
     "`A` contains itself: `A` in `B` in `A`", "B"),
    ("create_message_type A with B b\ncreate_message_type B with int32 a\n", "unknown-type",
     "`B` is made further down, and used here already", "B"),
    ("create_message_type A with B b\ncreate_message_type B with C c\n"
     "create_message_type C with B b\n", "unknown-type",
     "`B` is made further down, and used here already", "B"),
    ("create_service_type A with B b returning none\ncreate_message_type B with int32 x\n",
     "unknown-type", "`B` is made further down, and used here already", "B"),
    ("create_message m of message_type q/B and input x=1\ncreate_message_type q/B with int32 x\n",
     "unknown-type", "`B` is made further down, and used here already", "q/B"),
    ("create_message m of message_type q/B and input x=1\ncreate_message_type B with int32 x\n",
     "unknown-type", None, "q/B"),
    ("create_message m of message_type B and input x=1\n"
     "create_service_type B with int32 x returning none\n", "unknown-type", None, "B"),
]  # fmt: skip


@pytest.mark.parametrize(("text", "code", "message", "where"), LATER)
def test_a_type_is_made_before_it_is_used(
    text: str, code: str, message: str | None, where: str
) -> None:
    found, *others = run(text, "rclpy").diagnostics
    assert (found.code, marked(text, found)) == (code, where)
    assert not others or code == "unknown-type"
    assert (found.message == message) if message else ("further down" not in found.message)


def test_a_type_is_used_from_the_next_line_on() -> None:
    use = "create_message m of message_type A and input x=5\n"
    assert list(run(A + use, "rclpy").diagnostics) == []
    [found] = run(use + A, "rclpy").diagnostics
    assert found.code == "unknown-type"


USES = """\
create_message_type B with A a, A[] more
create_service_type S with B b returning none
create_message m of message_type A and input none
n publish m to 'a' of message_type A
n provides_service 's' of service_type S
A has_field "int32 y"
generate_type A
"""


@pytest.mark.parametrize(
    ("line", "code"),
    [
        ("create_message_type A with flot64 x", "unknown-type"),
        ("create_message_type own_msgs/A with float64 x, float64 x", "bad-field"),
        ("create_message_type A with A a", "circular-type"),
        ("create_message_type A width float64 x", "syntax-error"),
    ],
)
def test_a_broken_type_is_told_once(line: str, code: str) -> None:
    found = run(f"create_node 'n' as n\n{line}\n{USES}").diagnostics
    assert [each.code for each in found] == [code]


@pytest.mark.parametrize("library", ["rclpy", "rospy"])
def test_a_change_that_is_taken_back_is_as_if_it_had_never_been(library: str) -> None:
    """What is written after it has the type as it was."""
    used = "create_node 'n' as n\nsubscribe n to 'in' of message_type A\n"
    needs = "create_message out of message_type Float64 and input data=received.x\n"
    sends = "n publish out to 'out' of message_type Float64 for_each 'in'\n"
    before = f"create_message_type A with int32 x, int32 y\n{used}{needs}{sends}"
    text = f"{before}A no_longer_has_field 'x'\ncreate_message m of message_type A and input x=1\n"
    [found] = run(text, library).diagnostics
    assert found.code == "type-in-use"


def test_a_type_that_one_ros_cannot_have_stays_so_when_it_changes() -> None:
    text = 'create_message_type A with string<=5 x\nA has_field "int8 y"\n'
    found = run(text, "rclpy")
    assert list(found.diagnostics) == []
    [own] = found.workspace.types.values()
    assert own.definitions.keys() == {2}
    use = f"{text}{ROSPY}subscribe n to 'a' of message_type A\n"
    [told] = run(use, "rclpy").diagnostics
    assert told.message == "`A` is no type of ROS 1: ROS 1 has no bounded types"
    # Nor where what one could not have is taken away.
    less = f"{text}A no_longer_has_field 'x'\n"
    assert [each.definitions.keys() for each in run(less, "rclpy").workspace.types.values()] == [
        {2}
    ]


def test_what_else_is_wrong_in_a_type_is_told() -> None:
    line = "create_message_type B with A a, Nowhere x, uint8 n default 300"
    found = run(f"create_message_type A with flot64 x\n{line}\n").diagnostics
    assert [each.code for each in found] == ["unknown-type", "unknown-type", "bad-field"]


def test_what_one_ros_cannot_have_is_told_where_it_is_used() -> None:
    text = "create_message_type A with string<=5 x\n"
    assert list(run(text, "rclpy").diagnostics) == []
    [found] = run(text, "rospy").diagnostics
    assert (found.code, marked(text, found)) == ("bad-field", "string<=5")
    use = f"{text}{ROSPY}subscribe n to 'a' of message_type A\n"
    [found] = run(use, "rclpy").diagnostics
    assert found.message == "`A` is no type of ROS 1: ROS 1 has no bounded types"


def test_messages_of_an_action_of_ros_1_are_no_other_messages() -> None:
    action = "create_action_type Dock with none returning none reporting none\n"
    message = "create_message_type DockGoal with none\n"
    for text, where in ((action + message, "DockGoal"), (message + action, "Dock")):
        assert list(run(text, "rclpy").diagnostics) == []
        [found] = run(text, "rospy").diagnostics
        assert (found.code, marked(text, found)) == ("type-exists", where)


def test_a_type_that_the_program_is_not_for_may_be_for_its_nodes() -> None:
    text = f"{ROSPY}create_message_type A with int32 someField\n"
    use = f"{text}subscribe n to 'a' of message_type A\n"
    assert list(run(use, "rclpy").diagnostics) == []
