"""What is wrong with sentences about robots, on the word that is wrong, and what helps."""

from __future__ import annotations

import pytest
from robots_run import MADE, applied, run
from workspaces import marked

from plastron_tui.diagnostics import codes

BEFORE = f"""\
{MADE}r has_link 'a'
r has_link 'b'
r has_link 'c'
r has_joint 'j' of joint_type revolute from 'a' to 'b'
r has_joint 'f' of joint_type fixed from 'b' to 'c'
"""
LONG = "d" * 196
LIMIT = "r limits_joint 'j'"
JOINT = "r has_joint 'k' of joint_type"
SLIDES = (
    "r has_link 'd'\nr has_joint 's' of joint_type prismatic from 'c' to 'd'\n"
    "r limits_joint 's' between {} with effort 1 and velocity 1"
)

# The line, the code, what is marked, what the help says.
MISTAKES: list[tuple[str, str, str, str]] = [
    ("x has_link 'd'", "unknown-robot", "x", "make it first"),
    ("r has_link '1d'", "bad-robot-name", "'1d'", "starts with a letter"),
    (f"r has_link '{LONG}'", "bad-robot-name", f"'{LONG}'", "a shorter one"),
    (
        f"{JOINT.replace('k', LONG)} fixed from 'a' to 'c'",
        "bad-robot-name",
        f"'{LONG}'",
        "a shorter one",
    ),
    ("r has_link 'a'", "part-exists", "'a'", "one sentence"),
    ("r has_link 'd' weighing 5", "bad-shape", "5", "say `shaped …`"),
    ("r has_link 'd' painted red", "bad-shape", "red", "say `shaped …`"),
    ("r has_link 'd' at 0, 0, 1", "bad-shape", "0, 0, 1", "say `shaped …`"),
    ("r has_link 'd' shaped sfere 1", "bad-shape", "sfere", "did you mean `sphere`?"),
    ("r has_link 'd' shaped box 1, 2", "bad-shape", "1, 2", "box 0.4, 0.3, 0.1"),
    ("r has_link 'd' shaped box 1, 2, 3, 4", "bad-shape", "4", "box 0.4, 0.3, 0.1"),
    ("r has_link 'd' shaped box 1, 2, y=3", "bad-shape", "y=3", ""),
    ("r has_link 'd' shaped cylinder radus=1, length=1", "bad-shape", "radus=1", "`radius`"),
    ("r has_link 'd' shaped box 0,4, 1, 0,05", "bad-shape", "0,4, 1, 0,05", "`0.4, 1, 0.05`"),
    ("r has_link 'd' shaped sphere 0,1", "bad-shape", "0,1", "write `0.1`"),
    ("r has_link 'd' shaped box (1, 2, .5)", "bad-shape", "(1, 2, .5)", "write `1, 2, .5`"),
    ("r has_link 'd' shaped box size=[1, 2, 3]", "bad-shape", "size=[1, 2, 3]", "`1, 2, 3`"),
    ("r has_link 'd' shaped cylinder \"1 2\"", "bad-shape", '"1 2"', "write `1, 2`"),
    ("r has_link 'd' shaped box x=1, width=2, z=3", "bad-shape", "width", "write `y`"),
    ("r has_link 'd' shaped cylinder 1, height=2", "bad-shape", "height", "write `length`"),
    ("r has_link 'd' shaped sphere 0", "bad-shape", "0", ""),
    ("r has_link 'd' shaped cylinder 1, length=-2", "bad-shape", "length=-2", "write `2`"),
    ("generate_node r", "unknown-node", "r", "is a robot: write `generate_robot`"),
    ("r has_link 'd' shaped sphere 1e-9", "bad-shape", "1e-9", ""),
    ("r has_link 'd' shaped sphere True", "bad-shape", "True", ""),
    ("r has_link 'd' shaped mesh \"\"", "bad-shape", '""', "package://"),
    (
        "r has_link 'd' shaped mesh \"a\", scale=[1, 1e-3, 2]",
        *("bad-shape", "scale=[1, 1e-3, 2]", "write `(1, 1e-3, 2)`"),
    ),
    ("r has_link 'd' shaped mesh \"a\", [1, 2]", "bad-shape", "[1, 2]", "leave it out"),
    ("r has_link 'd' shaped mesh \"a\", scale=0", "bad-shape", "scale=0", ""),
    ("r has_link 'd' shaped sphere 1 weighing -1", "bad-weight", "-1", "leave it out"),
    ("r has_link 'd' shaped sphere 1 painted rde", "unknown-color", "rde", "did you mean `red`?"),
    ("r has_link 'd' shaped sphere 1 painted nothing", "unknown-color", "nothing", "write `none`"),
    ("r has_link 'd' shaped sphere 1 painted \"#12\"", "unknown-color", '"#12"', "#3060ff"),
    ("r has_link 'd' shaped sphere 1 at 0, 1e999, 0", "bad-robot-number", "1e999", ""),
    ("r has_link 'd' shaped sphere 1 turned 0, 0, 9 degs", "bad-unit", "degs", "`deg`"),
    ("r no_longer_has_link 'd'", "unknown-link", "'d'", "make it first"),
    ("r no_longer_has_link 'a'", "part-in-use", "'a'", "no_longer_has_joint 'j'"),
    (f"{JOINT} fixed from 'a' to 'x'", "unknown-link", "'x'", "make it first"),
    (f"{JOINT} fixed from 'a' to 'a'", "no-tree", "'a'", "two links"),
    (f"{JOINT} hinge from 'a' to 'c'", "unknown-joint-type", "hinge", "two angles is `revolute`"),
    (f"{JOINT} fix from 'a' to 'c'", "unknown-joint-type", "fix", "did you mean `fixed`?"),
    (f"{JOINT} fixed from 'a' to 'c' with axis 0, 0, 1", "bad-axis", "0, 0, 1", ""),
    (f"{JOINT} planar from 'a' to 'c' with axis 0, 0, 0", "bad-axis", "0, 0, 0", "points up"),
    (f"{JOINT} fixed from 'a' to 'c' mimicking 'j'", "bad-mimic", "'j'", ""),
    (f"{JOINT} planar from 'a' to 'c' mimicking 'f'", "bad-mimic", "'f'", ""),
    (f"{JOINT} planar from 'a' to 'c' mimicking 'k'", "bad-mimic", "'k'", "that it follows"),
    (f"{JOINT} planar from 'a' to 'c' mimicking 'g'", "unknown-joint", "'g'", "so far, it has `j`"),
    (f"{JOINT} planar from 'a' to 'c' mimicking 'j' times 0", "bad-mimic", "0", ""),
    ("r has_joint 'k'", "incomplete-joint", "'k'", "has_joint 'k' of joint_type fixed from"),
    ("r has_joint 'k' of joint_type fixed", "incomplete-joint", "'k'", "fixed from '…' to '…'"),
    ("r has_joint 'k' from 'a' to 'c'", "incomplete-joint", "'k'", "from 'a' to 'c'"),
    ("r has_joint 'j' at 0, 0, 1", "part-exists", "'j'", "one sentence"),
    ("r no_longer_has_joint 'x'", "unknown-joint", "'x'", "it has `j`, `f`"),
    (f"{LIMIT}", "bad-limits", "'j'", "between"),
    (
        f"{LIMIT} between 90 and -90 deg with effort 1 and velocity 1",
        "bad-limits",
        "90 and -90",
        "",
    ),
    (f"{LIMIT} between 9 and 9 deg with effort 1 and velocity 1", "bad-limits", "9 and 9", "fixed"),
    (f"{LIMIT} between 0 and 1 m with effort 1 and velocity 1", "bad-unit", "m", ""),
    (SLIDES.format("0 and 90 deg"), "bad-unit", "deg", "is `revolute`"),
    (SLIDES.format("-5 and 30 cm"), "bad-unit", "cm", "write `between -0.05 and 0.3 m`"),
    (SLIDES.format("0 and 30 inches"), "bad-unit", "inches", ""),
    (f"{LIMIT} between 0 and 1 rad with effort -1 and velocity 1", "bad-limits", "-1", ""),
    (f"{LIMIT} between 0 and 1 rad with effort 0 and velocity 0", "bad-limits", "0", "how fast"),
    (f"{LIMIT} with damping 1 and friction 1e999", "bad-limits", "1e999", ""),
    (f"{LIMIT} with effort 1 and velocity 1", "missing-limits", "'j'", "between"),
    (f"{LIMIT} between 0 and 1 rad", "missing-limits", "'j'", "with effort"),
    ("r limits_joint 'f' between 0 and 1 deg", "bad-limits", "'f'", "two angles is `revolute`"),
    ("r limits_joint 'f' with damping 0 and friction 1", "bad-limits", "'f'", ""),
    # What no further sentence mends is told of a robot that is not written, too.
    (f"{JOINT} fixed from 'a' to 'c'", "no-tree", "'c'", "no_longer_has_joint 'k'"),
    (f"{JOINT} fixed from 'c' to 'a'", "no-tree", "'a'", "no_longer_has_joint 'k'"),
    # Numbers of other units.
    ("r has_link 'd' shaped box 400, 300, 100", "unit-slip", "400, 300, 100", "0.4, 0.3, 0.1"),
    ("r has_link 'd' shaped sphere 1 at 0, 0, 250", "unit-slip", "0, 0, 250", "0, 0, 0.25"),
    ("r has_link 'd' shaped sphere 1 weighing 500000", "unit-slip", "500000", "`500`"),
    ("r has_link 'd' shaped sphere 1 turned 0, 0, 90 rad", "unit-slip", "rad", "`deg`"),
    ("r has_link 'd' shaped sphere 1 turned 0, 0, 1.57 deg", "unit-slip", "deg", "`rad`"),
    (f"{LIMIT} between -90 and 90 rad with effort 1 and velocity 1", "unit-slip", "rad", "`deg`"),
    (f"{LIMIT} between 0 and 3.14 deg with effort 1 and velocity 1", "unit-slip", "deg", "`rad`"),
]


@pytest.mark.parametrize("case", MISTAKES, ids=[case[0] for case in MISTAKES])
def test_a_sentence_with_a_mistake(case: tuple[str, str, str, str]) -> None:
    line, code, where, remedy = case
    text = f"{BEFORE}{line}\n"
    (found,) = run(text).diagnostics
    assert (found.code, marked(text, found)) == (code, where)
    assert remedy in (found.help or "")
    if found.fix is not None:
        left = run(applied(text, found.fix)).diagnostics
        assert code not in {each.code for each in left}


RIGHT = [
    "r has_link 'd' shaped sphere 1 weighing 5000",
    "r has_link 'd' shaped box 50, 3, 3 at 0, 0, 99",
    "r has_link 'd' shaped sphere 1 turned 0, 0, 6.2832 rad",
    "r has_link 'd' shaped sphere 1 turned 0, 1.5, 2 deg",
    "r has_link 'd' shaped sphere 1 turned 1.57, 0, 10 deg",
    f"{LIMIT} between -6.2832 and 12.6 rad with effort 1 and velocity 1",
    f"{LIMIT} between -3600 and 3600 deg with effort 1 and velocity 1",
    f"{LIMIT} with damping 1 and friction 0",
    "r has_link '_d.e-1'",
    # Half of a robot is no mistake as long as it is not written.
    "r has_link 'd' shaped sphere 1 weighing 1",
]


@pytest.mark.parametrize("line", RIGHT)
def test_a_sentence_without_mistakes(line: str) -> None:
    assert run(f"{BEFORE}{line}\n").diagnostics == ()


# What is written, and what is told of it: codes, marked texts, helps.
WRITTEN: list[tuple[str, list[tuple[str, str, str]]]] = [
    ("", [("no-tree", "r", "has_link 'base_link'")]),
    ("r has_link 'a'\n", []),
    ("r has_link 'a'\nr has_link 'b'\n", [("no-tree", "'b'", "has_joint 'b_joint'")]),
    (
        "r has_link 'a'\nr has_link 'b'\nr has_joint 'j' of joint_type revolute from 'a' to 'b'\n",
        [("missing-limits", "revolute", "limits_joint 'j' between -90 and 90 deg")],
    ),
    (
        "r has_link 'a'\nr has_link 'b'\nr has_joint 'j' of joint_type prismatic from 'a' to 'b'\n",
        [("missing-limits", "prismatic", "between 0 and 0.5 m")],
    ),
    (
        "r has_link 'a'\nr has_link 'b' shaped sphere 1\n"
        "r has_joint 'j' of joint_type planar from 'a' to 'b'\n",
        [("missing-weight", "'b'", "weighing 0.5")],
    ),
    # What is held fast becomes a part of what holds it.
    (
        "r has_link 'a'\nr has_link 'b' shaped sphere 1\n"
        "r has_joint 'j' of joint_type fixed from 'a' to 'b'\n",
        [],
    ),
    ("r has_link 'a' shaped sphere 1 weighing 2\n", [("root-inertia", "2", "an empty link")]),
]


@pytest.mark.parametrize(("lines", "told"), WRITTEN)
def test_what_is_wrong_with_a_robot_that_is_written(
    lines: str, told: list[tuple[str, str, str]]
) -> None:
    text = f"{MADE}{lines}generate_robot r\n"
    found = run(text).diagnostics
    assert [(each.code, marked(text, each)) for each in found] == [each[:2] for each in told]
    for each, (_, _, remedy) in zip(found, told, strict=True):
        assert remedy in (each.help or "")
    assert run(f"{MADE}{lines}").diagnostics == ()


def test_the_remedy_for_a_root_with_inertia_mends_it() -> None:
    text = f"{MADE}r has_link 'root' shaped sphere 1 weighing 2\ngenerate_robot r\n"
    (found,) = run(text).diagnostics
    assert found.fix is not None
    assert run(applied(text, found.fix)).diagnostics == ()


# What follows from a mistake is none of its own.
FOLLOWING: list[tuple[str, list[str]]] = [
    ("create_robot 'a b' as r\nr has_link 'a'\ngenerate_robot r\n", ["bad-robot-name"]),
    (f"{MADE}r has_link 'a' shaped sphere 0\nr no_longer_has_link 'a'\n", ["bad-shape"]),
    (
        f"{MADE}r has_link 'a'\nr has_link 'b' weighing 0\n"
        "r has_joint 'j' of joint_type revolute from 'a' to 'b'\n"
        "r limits_joint 'j' with effort 1 and velocity 1\nr no_longer_has_joint 'j'\n",
        ["bad-weight"],
    ),
    (
        f"{MADE}r has_link 'a'\nr has_lnk 'b'\n"
        "r has_joint 'j' of joint_type fixed from 'a' to 'b'\ngenerate_robot r\n",
        ["unknown-statement"],
    ),
    (
        f"{BEFORE}{JOINT} planar from 'c' to 'd' mimicking 'j'\nr no_longer_has_joint 'k'\n"
        "r no_longer_has_joint 'x'\nr no_longer_has_joint 'x'\n",
        ["unknown-link", "unknown-joint"],
    ),
]


@pytest.mark.parametrize(("text", "told"), FOLLOWING)
def test_what_follows_from_a_mistake_is_silent(text: str, told: list[str]) -> None:
    assert [each.code for each in run(text).diagnostics] == told


def test_what_comes_after_a_robot_is_generated_is_told() -> None:
    text = f"{MADE}r has_link 'a'\ngenerate_robot r\nr no_longer_has_link 'a'\n"
    (found,) = run(text).diagnostics
    assert found.code == codes.CHANGED_AFTER_GENERATING
    assert marked(text, found) == "r no_longer_has_link 'a'"


def test_the_remedy_for_what_comes_late_generates_after_it() -> None:
    late = "r has_link 'b'\nr has_joint 'j' of joint_type fixed from 'a' to 'b'\n"
    text = f"{MADE}r has_link 'a'\ngenerate_robot r\n{late}"
    for found in run(text).diagnostics:
        assert found.fix is not None
        mended = applied(text, found.fix)
        assert run(mended).diagnostics == ()
        assert mended.split("\n")[-2] == "generate_robot r"
