from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from plastron_tui.ros.names import (
    MAX_NAME_LENGTH,
    MAX_NODE_NAME_LENGTH,
    check_node_name,
    check_service_name,
    check_topic_name,
    name_as_read,
    name_as_written,
    resolved_name,
    spelled,
)

VALID_TOPICS = {
    1: [
        "chatter",
        "/chatter",
        "/arm/joint_1",
        "~private",
        "~/private",
        "a",
        "A__b",
        "a_",
        "/_hidden",
        "/1/2",
        "chatter/",
        "a/1",
        "~1",
    ],
    2: [
        "chatter",
        "/chatter",
        "/arm/joint_1",
        "~/private",
        "_hidden",
        "a/_b",
        "a_",
        "{node}/state",
        "robot_{ns}",
        "/{namespace}/x",
        "{node}",
    ],
}

# (name, ROS version, the wrong part, where it starts, a name that would do)
WRONG_TOPICS = [
    ("", 1, "", 0, None),
    ("1abc", 1, "1", 0, "topic_1abc"),
    ("_a", 1, "_", 0, "a"),
    ("a b", 1, " ", 1, "a_b"),
    ("my topic name", 1, " ", 2, "my_topic_name"),
    ("a-b", 1, "-", 1, "a_b"),
    ("a.b", 2, ".", 1, "a_b"),
    ("café", 1, "é", 3, "cafe"),
    ("日本", 1, "日本", 0, None),
    ("a//b", 1, "//", 1, "a/b"),
    ("//", 1, "//", 0, None),
    ("/", 1, "/", 0, None),
    ("~", 1, "~", 0, None),
    ("~", 2, "~", 0, None),
    ("a/~b", 1, "~", 2, "a/b"),
    ("~~a", 1, "~", 1, "~/a"),
    ("a\nb", 1, "\n", 1, "a_b"),
    ("a\n", 1, "\n", 1, "a"),
    ("a\n", 2, "\n", 1, "a"),
    ("../../x", 1, "..", 0, "x"),
    ("a{b}", 1, "{", 1, "a_b"),
    ("~private", 2, "~", 0, "~/private"),
    ("chatter/", 2, "/", 7, "chatter"),
    ("a__b", 2, "__", 1, "a_b"),
    ("a____b", 2, "____", 1, "a_b"),
    ("/1a", 2, "1", 1, "/topic_1a"),
    ("a/23b", 2, "23", 2, "a/topic_23b"),
    ("{nope}", 2, "{nope}", 0, "nope"),
    ("{node", 2, "{", 0, "node"),
    ("a}", 2, "}", 1, "a"),
    ("x_{node}__a", 2, "__", 8, "x_node_a"),
    ("a//b", 2, "//", 1, "a/b"),
]


@pytest.mark.parametrize(
    ("name", "version"), [(name, version) for version in (1, 2) for name in VALID_TOPICS[version]]
)
def test_valid_names_have_no_problem(name: str, version: int) -> None:
    assert check_topic_name(name, version) is None
    assert check_service_name(name, version) is None


@pytest.mark.parametrize(("name", "version", "wrong", "offset", "suggestion"), WRONG_TOPICS)
def test_the_wrong_part_of_a_topic_name_is_marked(
    name: str, version: int, wrong: str, offset: int, suggestion: str | None
) -> None:
    problem = check_topic_name(name, version)
    assert problem is not None
    marked = name[problem.offset : problem.offset + problem.length]
    assert (marked, problem.offset, problem.suggestion) == (wrong, offset, suggestion)


PRIVATE = [
    # What the code has, what `rospy.names.resolve_name` makes of it in a node `/n`, how programs
    # spell that, and how the code is written.
    ("~scan", 1, "/n/scan", "~/scan", "~scan"),
    ("~a/b", 1, "/n/a/b", "~/a/b", "~a/b"),
    ("~1", 1, "/n/1", "~/1", "~1"),
    ("~/scan", 1, "/scan", "/scan", "/scan"),
    ("~//scan", 1, "/scan", "/scan", "/scan"),
    ("~/scan", 2, "/n/scan", "~/scan", "~/scan"),
    ("scan", 1, "/scan", "scan", "scan"),
    ("/scan", 2, "/scan", "/scan", "/scan"),
]


@pytest.mark.parametrize(("code", "version", "full", "name", "written"), PRIVATE)
def test_what_a_library_makes_of_a_private_name(
    code: str, version: int, full: str, name: str, written: str
) -> None:
    read = name_as_read(code, version)
    assert (read, resolved_name("n", read), name_as_written(read, version)) == (name, full, written)


@given(st.from_regex(r"[~/]{0,3}[a-z0-9_]{0,4}(/[a-z]{1,2})?/?", fullmatch=True))
def test_a_name_that_is_written_is_read_as_it_is_spelled(name: str) -> None:
    for version in (1, 2):
        if check_topic_name(name, version) is None:
            wanted = spelled(name)
            assert check_topic_name(wanted, version) is None
            assert name_as_read(name_as_written(wanted, version), version) == wanted


WRONG_NODES = [
    ("", 1, "", None),
    ("arm/left", 1, "/", "arm_left"),
    ("/arm", 2, "/", "arm"),
    ("~arm", 1, "~", "arm"),
    ("2nd", 1, "2", "node_2nd"),
    ("2nd", 2, "2", "node_2nd"),
    ("_a", 1, "_", "a"),
    ("my node", 1, " ", "my_node"),
    ("../../x", 1, "/", "x"),
    ("__import__('os')", 1, "('", "import_os"),
    ("a\u202eb", 1, "\u202e", "a_b"),
    ("Ａ", 1, "Ａ", "A"),
    ("a\ud800", 1, "\ud800", "a"),
]


@pytest.mark.parametrize(("name", "version", "wrong", "suggestion"), WRONG_NODES)
def test_the_wrong_part_of_a_node_name_is_marked(
    name: str, version: int, wrong: str, suggestion: str | None
) -> None:
    problem = check_node_name(name, version)
    assert problem is not None
    assert name[problem.offset : problem.offset + problem.length] == wrong
    assert problem.suggestion == suggestion


@pytest.mark.parametrize(("name", "version"), [("a", 1), ("A_1__x", 1), ("_a", 2), ("class", 1)])
def test_valid_node_names(name: str, version: int) -> None:
    assert check_node_name(name, version) is None


@pytest.mark.parametrize("version", [1, 2])
def test_a_name_has_a_longest_length(version: int) -> None:
    longest = "a" * MAX_NAME_LENGTH[version]
    assert check_topic_name(longest, version) is None
    problem = check_topic_name(longest + "bc", version)
    assert problem is not None
    assert (problem.offset, problem.length) == (len(longest), 2)
    assert problem.suggestion == longest
    assert check_node_name("a" * MAX_NODE_NAME_LENGTH, version) is None
    assert check_node_name("a" * (MAX_NODE_NAME_LENGTH + 1), version) is not None


@given(st.text(alphabet=st.one_of(st.sampled_from("aZ1_/~{}. é"), st.characters())), st.booleans())
def test_every_problem_lies_in_the_name_and_every_suggestion_is_valid(
    name: str, is_ros2: bool
) -> None:
    version = 2 if is_ros2 else 1
    for check in (check_topic_name, check_service_name, check_node_name):
        problem = check(name, version)
        if problem is None:
            continue
        assert 0 <= problem.offset <= problem.offset + problem.length <= len(name)
        assert (problem.length > 0) == bool(name)
        assert problem.message[0].islower() or problem.message.startswith(("`", "ROS"))
        assert problem.suggestion is None or check(problem.suggestion, version) is None


def test_a_long_wrong_name_is_answered_at_once() -> None:
    for name in ("_" * 900 + "/", "a/" * 120 + "__", "{" * 240, "/" * 240):
        for version in (1, 2):
            check_topic_name(name, version)
            check_topic_name(name * 10_000, version)
