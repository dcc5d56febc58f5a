from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from plastron_tui.ros.names import resolved_name
from plastron_tui.ros.run_names import Remap, RunNames, parse_namespace, parse_remap

NAMES = st.lists(st.sampled_from(["a", "b", "arm", "x1"]), min_size=1, max_size=3).map("/".join)
SPELLED = st.builds(str.__add__, st.sampled_from(["", "/", "~/"]), NAMES)
SPACES = st.one_of(st.none(), st.just(""), NAMES.map("/{}".format))


def names(*remaps: str, namespace: str | None = None) -> RunNames:
    found = [parse_remap(text) for text in remaps]
    return RunNames(namespace, tuple(each for each in found if isinstance(each, Remap)))


@pytest.mark.parametrize(
    ("text", "remap"),
    [
        ("a:=b", Remap("a", "b")),
        ("/a/b:=~/c", Remap("/a/b", "~/c")),
        ("~scan:=~x", Remap("~/scan", "~/x")),
        ("talker:a:=b", Remap("a", "b", "talker")),
        ("a b:=c", Remap("a b", "c")),  # a name that is wrong, not a form
    ],
)
def test_a_rule(text: str, remap: Remap) -> None:
    assert parse_remap(text) == remap


@pytest.mark.parametrize("text", ["", "a", "a=b", ":=", "a:=", ":=b", ":a:=b", "n::=b", "a:b"])
def test_a_form_that_is_none(text: str) -> None:
    assert parse_remap(text) == "a remap is `FROM:=TO`, or `NODE:FROM:=TO` for one node"


@pytest.mark.parametrize("text", ["__ns:=/a", "n:__ns:=/a", "__name:=x", "__node:=x"])
def test_a_special_name_is_no_topic(text: str) -> None:
    found = parse_remap(text)
    assert isinstance(found, str)
    assert ("--namespace" in found) == ("__ns" in text)


@pytest.mark.parametrize(
    ("text", "namespace"),
    [
        *(("/robot1", "/robot1"), ("robot1", "/robot1"), ("/a/b/", "/a/b"), ("/", "")),
        *((text, None) for text in ("", "//", "/a b", "~x", "/a//b", "/a-b", "a:=b")),
    ],
)
def test_a_namespace(text: str, namespace: str | None) -> None:
    assert parse_namespace(text) == namespace


# What rospy and rclpy make of a name in the namespace /r for the node `n`; see the live tests.
@pytest.mark.parametrize(
    ("remaps", "name", "full"),
    [
        ([], "a", "/r/a"),
        ([], "/a", "/a"),
        ([], "~/a", "/r/n/a"),
        ([], "{ns}/a", "/r/a"),
        ([], "{node}/a", "/r/n/a"),
        (["a:=b"], "a", "/r/b"),
        (["a:=b"], "/r/a", "/r/b"),
        (["/a:=b"], "a", "/r/a"),
        (["a:=/b"], "a", "/b"),
        (["~/a:=b"], "~/a", "/r/b"),
        (["a:=~/b"], "a", "/r/n/b"),
        (["a:=b", "b:=c"], "a", "/r/b"),
        (["n:a:=b"], "a", "/r/b"),
        (["m:a:=b"], "a", "/r/a"),
    ],
)
def test_a_name_at_run_time(remaps: list[str], name: str, full: str) -> None:
    assert names(*remaps, namespace="/r").of("n").resolved("n", name) == full


@given(SPELLED, SPELLED, SPELLED, SPACES)
def test_a_rule_applies_to_one_name_and_to_that_once(
    old: str, new: str, name: str, space: str | None
) -> None:
    plain, given_ = RunNames(space), RunNames(space, (Remap(old, new), Remap(new, "never")))
    is_same = plain.resolved("n", old) == plain.resolved("n", name)
    if plain.resolved("n", new) != plain.resolved("n", name) or is_same:
        expected = new if is_same else name
        assert given_.resolved("n", name) == plain.resolved("n", expected)


@given(SPELLED, NAMES)
def test_a_namespace_moves_what_is_not_global(name: str, space: str) -> None:
    alone, moved = resolved_name("n", name), resolved_name("n", name, f"/{space}")
    assert moved == (alone if name.startswith("/") else f"/{space}{alone}")


@pytest.mark.parametrize(
    ("remaps", "ros_version", "problem"),
    [
        (["a:=b"], 1, None),
        (["a:=1b"], 1, "starts with a letter"),
        (["a:=b", "a:=c"], 1, "for the same name"),
        (["a:=b", "/r/a:=c"], 2, "for the same name"),
        (["a:=b", "/a:=c"], 2, None),
        (["a b:=c"], 2, "white space"),
        (["a:={node}/b"], 2, "substitutions"),
        (["a__b:=c"], 1, None),
        (["a__b:=c"], 2, "`__`"),
    ],
)
def test_what_is_wrong_with_names(remaps: list[str], ros_version: int, problem: str | None) -> None:
    found = names(*remaps, namespace="/r").problem(ros_version, "n")
    assert found is None if problem is None else problem in (found or "")


@pytest.mark.parametrize("ros_version", [1, 2])
def test_an_action_is_several_topics_and_services(ros_version: int) -> None:
    given_ = names("fib:=count", "x:=y", namespace="/r")
    found = given_.with_actions("n", ["/r/fib"], ros_version)
    more = found.remaps[len(given_.remaps) :]
    assert len(more) == 5
    assert all(each.old.replace("fib/", "count/", 1) == each.new for each in more)
