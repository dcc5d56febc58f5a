"""What is wrong with sentences about robots of files, on the word that is wrong, and what helps."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest
from robots_run import FILE, LOAD, applied, expanded, run, source, with_macros
from workspaces import marked

from plastron_tui.diagnostics import Diagnostic, Severity, Span, codes
from plastron_tui.ros.robots.description import Joint, JointType, Link, Mimic

# What is told of changes to a robot that is loaded.
LOADED: list[tuple[str, list[tuple[str, str]]]] = [
    ("", []),
    ("r has_link 'arm'", [("part-exists", "'arm'")]),
    ("r has_joint 'turn'", [("part-exists", "'turn'")]),
    ("r has_joint 'trun' at 0, 0, 1", [("incomplete-joint", "'trun'")]),
    ("r has_joint 'turn' at 0, 0, 1\nr has_joint 'turn' at 0, 0, 1", [("part-exists", "'turn'")]),
    ("r has_joint 'hold' with axis 0, 0, 1", [("bad-axis", "0, 0, 1")]),
    ("r has_joint 'hold' mimicking 'turn'", [("bad-mimic", "'turn'")]),
    ("r has_joint 'slide' from 'hand' to 'arm'", [("no-tree", "'arm'"), ("no-tree", "'slide'")]),
    (
        "r has_joint 'hold' of joint_type revolute",
        [("missing-limits", "revolute"), ("missing-weight", "'hold'")],
    ),
    ("r has_link 'tip' painted none", [("bad-shape", "none")]),
    ("r has_link 'arm' weighing 2\nr has_link 'arm' painted red", [("part-exists", "'arm'")]),
    ("r has_link 'hand' shaped sphere 1", [("several-shapes", "sphere")]),
    ("r has_link 'hand' at 0, 0, 1", [("several-shapes", "0, 0, 1")]),
    ("r has_link 'hand' weighing 1", [("several-shapes", "1")]),
    ("r has_link 'tip' painted red", [("bad-shape", "red")]),
    ("r has_link 'base' weighing 1", [("bad-shape", "1")]),
    ("r has_link 'arm' shaped mesh \"a.stl\"", [("mesh-inertia", "mesh")]),
    ("r has_link 'base' shaped sphere 1 weighing 1", [("root-inertia", "1")]),
    ("r no_longer_has_joint 'slide'", [("no-tree", "'slide'")]),
    (
        "r no_longer_has_joint 'turn'\nr has_link 'base' painted red shaped sphere 1\n"
        "r has_link 'arm' weighing 2",
        [("no-tree", "'turn'")],
    ),
    (
        "r no_longer_has_joint 'slide'\nr has_link 'tip' shaped sphere 1",
        [("no-tree", "'slide'")],
    ),
    ("r no_longer_has_joint 'slide'\nr no_longer_has_link 'tip'", []),
    (
        "r has_joint 'turn' of joint_type prismatic from 'base' to 'arm'",
        [("missing-limits", "prismatic")],
    ),
    (
        "r has_joint 'turn' of joint_type fixed from 'base' to 'arm'\n"
        "r limits_joint 'turn' between 0 and 1 deg",
        [("bad-limits", "'turn'")],
    ),
    (
        "r has_joint 'slide' of joint_type fixed from 'hand' to 'arm'",
        [("no-tree", "'arm'"), ("no-tree", "'slide'")],
    ),
    ("r has_link 'new'", [("no-tree", "'new'")]),
    (
        "r limits_joint 'turn' between 0 and 1 rad\n"
        "r has_joint 'turn' of joint_type revolute from 'base' to 'arm'\n"
        "r limits_joint 'turn' between 0 and 1 rad",
        [("part-exists", "'turn'")],
    ),
    (
        "r no_longer_has_joint 'slide'\nr no_longer_has_link 'tip'\n"
        "r has_joint 'hold' of joint_type fixed from 'base' to 'hand'\n"
        "r no_longer_has_joint 'turn'\nr no_longer_has_link 'arm'",
        [],
    ),
    (
        "r limits_joint 'turn' between 0 and 1 rad\nr limits_joint 'turn' between 0 and 1 rad",
        [("part-exists", "'turn'")],
    ),
]


@pytest.mark.parametrize(("lines", "told"), LOADED)
def test_what_is_told_of_changes_to_a_loaded_robot(lines: str, told: list[tuple[str, str]]) -> None:
    text = f"{LOAD}{lines}\ngenerate_robot r\n"
    found = run(text).diagnostics
    assert [(each.code, marked(text, each)) for each in found] == told


def test_a_joint_that_is_misspelt_is_guessed() -> None:
    text = f"{LOAD}r has_joint 'trun' at 0, 0, 1\n"
    (found,) = run(text).diagnostics
    assert found.help == "did you mean `turn`?"
    assert found.fix is not None
    assert run(applied(text, found.fix)).diagnostics == ()


def test_a_link_that_is_misspelt_is_guessed() -> None:
    text = f"{LOAD}r has_link 'amr' painted red weighing 2\n"
    (found,) = run(text).diagnostics
    assert (found.code, marked(text, found)) == ("bad-shape", "'amr'")
    assert found.help == "did you mean `arm`?"
    assert found.fix is not None
    assert run(applied(text, found.fix)).diagnostics == ()


def test_a_link_that_hangs_loose_in_a_loaded_robot_may_go() -> None:
    text = f"{LOAD}r no_longer_has_joint 'slide'\ngenerate_robot r\n"
    (found,) = run(text).diagnostics
    assert (found.help or "").endswith("; or take the link away: `r no_longer_has_link 'tip'`")


@pytest.mark.parametrize(
    ("said", "remedy"),
    [
        ("at 0, 0, 1", "`r has_joint 'hold' at …` is about all of it; one alone is changed in its"),
        ("turned 0, 0, 1 rad", "`r has_joint 'hold' turned …` is about all of it"),
        ("shaped sphere 1", "change it in its file, or take the link away and make it anew"),
    ],
)
def test_several_shapes_have_a_way_out(said: str, remedy: str) -> None:
    (found,) = run(f"{LOAD}r has_link 'hand' {said}\n").diagnostics
    assert "`hand` has 2 visuals and 0 collisions" in found.message
    assert (found.help or "").startswith(remedy)


def test_what_is_broken_in_a_file_can_be_changed() -> None:
    broken = Diagnostic(codes.BROKEN_URDF, "`x` is no number", Span(3, 4), Path("a.urdf"))
    found = run(f"{LOAD}r has_link 'arm' painted red\n", told=(broken,))
    assert found.diagnostics == (broken._replace(severity=Severity.WARNING),)


def test_faults_of_a_file_are_warnings_and_stay_where_they_are() -> None:
    broken = replace(
        FILE,
        links={**FILE.links, "lost": Link("lost")},
        joints={
            **FILE.joints,
            "odd": Joint("odd", JointType.FLOATING, "tip", "gone", mimic=Mimic("hold")),
        },
    )
    for lines in ("", "r has_link 'arm' painted red\n"):
        text = f"{LOAD}{lines}generate_robot r\n"
        found = run(text, source(broken)).diagnostics
        assert [(each.code, each.severity) for each in found] == [
            ("unknown-link", Severity.WARNING),
            ("no-tree", Severity.WARNING),
            ("bad-mimic", Severity.WARNING),
        ]
        assert {marked(text, each) for each in found} == {"'a.urdf'"}
    text = f"{LOAD}r has_link 'more'\ngenerate_robot r\n"
    *_, added = run(text, source(broken)).diagnostics
    # What hangs on the other root now is more.
    held = "".join(
        f"r has_link 'l{at}'\nr has_joint 'j{at}' of joint_type fixed from 'lost' to 'l{at}'\n"
        for at in range(5)
    )
    grown = run(f"{LOAD}{held}generate_robot r\n", source(broken)).diagnostics
    assert {each.severity for each in grown} == {Severity.WARNING}
    assert (added.code, added.severity, marked(text, added)) == ("no-tree", "error", "'more'")


@pytest.mark.parametrize(
    ("line", "word"),
    [
        ("has_link 'camera' painted red", "'camera'"),
        ("no_longer_has_link 'camera'", "'camera'"),
        ("has_joint 'camera_joint' of joint_type fixed from 'hand' to 'tip'", "'camera_joint'"),
        ("no_longer_has_joint 'camera_joint'", "'camera_joint'"),
        ("limits_joint 'camera_joint' with effort 1 and velocity 1", "'camera_joint'"),
    ],
)
def test_what_macros_make_does_not_change(line: str, word: str) -> None:
    text = f"{LOAD}r {line}\n"
    (found,) = run(text, with_macros(expanded())).diagnostics
    assert (found.code, marked(text, found)) == (codes.MADE_BY_MACRO, word)


def test_a_part_of_the_file_that_cannot_be_read_is_not_made_anew() -> None:
    broken = source()._replace(spans={("joint", "odd"): Span(0, 1), ("link", "tip"): Span(0, 1)})
    text = f"{LOAD}r has_joint 'odd' of joint_type fixed from 'hand' to 'tip'\n"
    (found,) = run(text, broken).diagnostics
    assert (found.code, marked(text, found)) == (codes.BROKEN_URDF, "'odd'")
    again = "r no_longer_has_joint 'slide'\nr no_longer_has_link 'tip'\nr has_link 'tip'\n"
    assert run(f"{LOAD}{again}", broken).diagnostics == ()


def test_of_macros_that_are_not_expanded_nothing_is_told() -> None:
    lines = "r no_longer_has_joint 'slide'\nr has_link 'new'\n"
    assert run(f"{LOAD}{lines}generate_robot r\n", with_macros(None)).diagnostics == ()
    found = run(f"{LOAD}{lines}generate_robot r\n", with_macros(expanded())).diagnostics
    assert [each.code for each in found] == ["no-tree", "no-tree"]


@pytest.mark.parametrize(
    ("line", "words"),
    [
        ('input name=["turn", "slide"]', []),
        ('input name=["trun", "slide"]', ['"trun"']),
        ('input header.frame_id="trun", name=["a", "b"], position=[1, 2]', ['"a"', '"b"']),
    ],
)
def test_joints_that_messages_name_are_joints_of_the_robot(line: str, words: list[str]) -> None:
    message = f"create_message m of message_type JointState and {line}\n"
    for text in (f"{LOAD}{message}", f"{message}{LOAD}"):
        found = run(text).diagnostics
        assert [marked(text, each) for each in found] == words
        assert {each.code for each in found} <= {codes.UNKNOWN_JOINT_NAME}
    full = message.replace("JointState", "sensor_msgs/msg/JointState")
    assert [each.code for each in run(f"{LOAD}{full}").diagnostics] == [each.code for each in found]
    # Of two robots nobody knows which is meant.
    assert run(f"{LOAD}{message}create_robot 'other' as s\n").diagnostics == ()
    assert run(f"{LOAD}{message}", with_macros(None)).diagnostics == ()


def test_a_type_of_ones_own_names_what_it_likes() -> None:
    own = "create_message_type JointState with string[] name\n"
    line = 'create_message m of message_type JointState and input name=["x"]\n'
    found = run(f"{LOAD}{own}{line}").diagnostics
    assert [each.code for each in found] == [codes.TYPE_HIDDEN]


def test_the_remedy_for_the_root_of_a_file_with_inertia_mends_it() -> None:
    links = {**FILE.links, "base": FILE.links["arm"]._replace(name="base")}
    loaded = source(replace(FILE, links=links))
    for text in (LOAD, f"{LOAD}r has_link 'arm' weighing 2\ngenerate_robot r\n"):
        (found,) = run(text, loaded).diagnostics
        assert (found.code, marked(text, found)) == (codes.ROOT_INERTIA, "'a.urdf'")
        assert found.fix is not None
        mended = applied(text, found.fix)
        assert run(mended, loaded).diagnostics == ()
    # What is said of the root tells it once, and with its own place.
    text = f"{LOAD}r has_link 'base' weighing 2\n"
    assert [each.code for each in run(text, loaded).diagnostics] == [codes.ROOT_INERTIA]


def test_a_change_elsewhere_leaves_the_root_that_a_file_means() -> None:
    # The first link is a mere place, and no joint holds what weighs something.
    base = FILE.links["arm"]._replace(name="base")
    loaded = source(replace(FILE, links={"world": Link("world"), **FILE.links, "base": base}))
    for line in ("", "r has_joint 'turn' at 0, 0, 1\n"):
        (found,) = run(f"{LOAD}{line}generate_robot r\n", loaded).diagnostics
        assert (found.code, found.severity) == (codes.NO_TREE, Severity.WARNING)
        assert found.message == "no joint holds `base`"
