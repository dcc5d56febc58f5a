from __future__ import annotations

import math

import pytest
import yaml
from hypothesis import example, given
from hypothesis import strategies as st

from plastron_tui.ros.parameter_values import (
    Assignment,
    Mistake,
    params_file,
    parse_assignment,
    parse_value,
    read_params,
    unfit,
    values_of,
    yaml_text,
)
from plastron_tui.ros.parameters import Setting

# What a line of YAML may hold, and much that it may not.
TEXTS = st.text(st.characters(exclude_categories=["Cs"]), max_size=30)
WORDS = st.sampled_from(
    ["", "0.8", "1", "yes", "on", "null", "~", "- a", "#x", "a: b", "*a", "&a", "!!int 1", "a:=b"]
)
SCALARS = [st.booleans(), st.integers(-(2**63), 2**63 - 1), st.floats(), st.one_of(TEXTS, WORDS)]
VALUES = st.one_of(
    *SCALARS, *(st.lists(each, min_size=1, max_size=4).map(tuple) for each in SCALARS)
)
PLAIN = st.from_regex(r"[A-Za-z_][A-Za-z0-9_]{0,8}", fullmatch=True)
DOTTED = st.lists(PLAIN, min_size=1, max_size=3).map(".".join)


def repr_of_start(value: object) -> str:
    return repr(value)[:20]


def is_same(one: object, other: object) -> bool:
    """Tell whether two values are equal in type too, and nan is nan."""
    if isinstance(one, tuple) and isinstance(other, tuple):
        return len(one) == len(other) and all(map(is_same, one, other))
    if isinstance(one, float) and isinstance(other, float) and math.isnan(one):
        return math.isnan(other)
    return type(one) is type(other) and one == other


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("0.8", 0.8),
        ("-3", -3),
        ("+5", 5),
        ("0x1f", 31),
        ("010", 8),
        ("08", 8.0),
        ("1.", 1.0),
        (".5", 0.5),
        ("1e5", 1e5),
        ("-.inf", -math.inf),
        ("inf", math.inf),
        ("99999999999999999999", 1e20),
        ("1e999", "1e999"),
        ("1_0", "1_0"),
        ("1:30", "1:30"),
        ("2020-01-01", "2020-01-01"),
        ("yes", True),
        ("OFF", False),
        ("tRUE", "tRUE"),
        ("null", "null"),
        ("", ""),
        ("  ", ""),
        ('""', ""),
        ('"0.8"', "0.8"),
        ("'yes'", "yes"),
        ("!!str 5", "5"),
        ("two words", "two words"),
        ("a:=b", "a:=b"),
        ("[1, 2]", (1, 2)),
        ("[1.0, -2.5]", (1.0, -2.5)),
        ('[a, "1"]', ("a", "1")),
    ],
)
def test_a_text_has_the_type_that_ros_gives_it(text: str, value: Setting) -> None:
    found = parse_value(text)
    assert is_same(found, value), found


@pytest.mark.parametrize(
    "text",
    [
        *("a: b", "{}", "[[1]]", "[1, 2.5]", "[1, a]", "[]", "[", "]", '"', "*a", "&a 1", "!x 1"),
        *("!!int 1", "!!python/object/apply:os.system [ls]", "#ff0000", "red #1", "a\n---\nb"),
        *("\x1b", "\udcff", '"\\ud800"', '"\\U99999999"', "[" * 5000, "%", "@a", "`a`"),
    ],
)
def test_a_text_that_is_no_value(text: str) -> None:
    assert isinstance(parse_value(text), Mistake)


@pytest.mark.parametrize(
    ("text", "found"),
    [
        ("talker.speed=0.8", Assignment("talker", "speed", 0.8)),
        ("talker.pid.p=1", Assignment("talker", "pid.p", 1)),
        ("talker.text=", Assignment("talker", "text", "")),
        ("talker.text=a=b", Assignment("talker", "text", "a=b")),
    ],
)
def test_an_assignment(text: str, found: Assignment) -> None:
    assert parse_assignment(text) == found


@pytest.mark.parametrize(
    "text",
    ["", "speed=1", ".speed=1", "a.=1", "a.b", "a.b c=1", "a.1=1", "a.b:=1", "a.b..c=1", "a.b=[1"],
)
def test_an_assignment_that_is_none(text: str) -> None:
    assert isinstance(parse_assignment(text), Mistake)


@given(st.text(max_size=40))
def test_no_text_is_more_than_a_mistake(text: str) -> None:
    parse_assignment(f"a.b={text}")
    found, mistakes = read_params(text)
    assert all(0 <= each.start <= each.end <= len(text) + 1 for each in mistakes)
    values_of(found, "/a")


@given(VALUES)
@example("a:=b")
@example(("1e5", "y", ":=:="))
def test_a_value_comes_back_from_its_argument(value: Setting) -> None:
    text = yaml_text(value)
    # rospy splits its arguments there, and an argument is one line.
    assert text.isascii() and text.isprintable() and ":=" not in text
    assert is_same(parse_value(text), value)
    # rospy reads it by PyYAML.
    loaded = yaml.safe_load(text)
    assert is_same(tuple(loaded) if isinstance(loaded, list) else loaded, value)


@given(st.dictionaries(PLAIN, st.dictionaries(DOTTED, VALUES, max_size=4), max_size=3))
def test_a_file_comes_back(nodes: dict[str, dict[str, Setting]]) -> None:
    found, mistakes = read_params(params_file(nodes))
    assert not mistakes
    assert [each.pattern for each in found] == [f"/{name}" for name, of in nodes.items() if of]
    for name, values in nodes.items():
        read = values_of(found, f"/{name}")
        assert read.keys() == values.keys()
        assert all(is_same(read[key], value) for key, value in values.items())


def test_a_file_as_people_write_it() -> None:
    found, mistakes = read_params(
        "/**:\n  ros__parameters:\n    rate: 10\n    pid: {p: 1.0, i: 0.0}\n"
        "/robot1:\n  talker:\n    ros__parameters:\n      rate: 20\n"
        "listener:\n  ros__parameters: {words: [a, b]}\n"
        "/*/camera:\n  ros__parameters: {rate: 30}\n"
    )
    assert not mistakes
    everywhere = {"rate": 10, "pid.p": 1.0, "pid.i": 0.0}
    assert values_of(found, "/x/y/z") == everywhere
    assert values_of(found, "/robot1/talker") == {**everywhere, "rate": 20}
    assert values_of(found, "/listener") == {**everywhere, "words": ("a", "b")}
    assert values_of(found, "/listener", "/robot1/listener")["words"] == ("a", "b")
    assert values_of(found, "/left/camera")["rate"] == 30
    assert values_of(found, "/camera")["rate"] == 10


@pytest.mark.parametrize(
    ("text", "wrong", "message"),
    [
        ("a: [\n", "", "this is no YAML"),
        ("3", "3", "below `ros__parameters:`"),
        ("a: 3", "3", "below `ros__parameters:`"),
        ("a b: {}", "a b", "is no name of a node"),
        ("a: {ros__parameters: 3}", "3", "`name: value`"),
        ("a: {ros__parameters: {b-c: 3}}", "b-c", "is no name of a parameter"),
        ("a: {ros__parameters: {b: 3, b: 4}}", "b", "is set twice"),
        ("a: {ros__parameters: {b: [1, x]}}", "[1, x]", "a list is of one type"),
        ("a: &x {b: *x}", "&x {b: *x}", "no anchors"),
        ("a: {ros__parameters: {b: &x 1, c: *x}}", "&x 1", "no anchors"),
        ("a: {ros__parameters: {b: !t 1}}", "!t 1", "no tags"),
    ],
)
def test_a_mistake_in_a_file_has_its_place(text: str, wrong: str, message: str) -> None:
    _, mistakes = read_params(text)
    assert message in mistakes[0].message
    assert text[mistakes[0].start : mistakes[0].end].strip() == wrong


@pytest.mark.parametrize(
    ("value", "ros_versions"),
    [
        (2**31 - 1, {1, 2}),
        (2**31, {2}),
        ((0, -(2**31) - 1), {2}),
        (1e300, {1, 2}),
        ("a\tb\nc", {1, 2}),
        ("a\x1bb", {2}),
        (("a", "b\ufffe"), {2}),
        ("a\0b", set()),
        (True, {1, 2}),
        ("x" * 99_000, {1, 2}),
        ("é" * 99_000, set()),
        (("x" * 10,) * 10_000, set()),
    ],
    ids=repr_of_start,
)
def test_what_a_ros_cannot_have(value: Setting, ros_versions: set[int]) -> None:
    assert {version for version in (1, 2) if unfit(value, version) is None} == ros_versions
