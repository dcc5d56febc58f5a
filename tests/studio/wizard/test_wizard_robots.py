"""Robots by the wizard: described, given parts, limited, changed."""

from __future__ import annotations

from pathlib import Path

import pytest
from wizard_courses import DESCRIBE, ROBOTS, applied, choose, course, form_after, to_menu_or_review
from wizard_driver import wizard

from plastron_tui.session import Session
from plastron_tui.studio.wizard.done_menu import done_items
from plastron_tui.studio.wizard.flow import Course
from plastron_tui.studio.wizard.pages import Look, PageKind

NEW = "describe a robot: its parts, and how they move"
PART = "give it a part"
JOINT = "hold two parts together"
LIMIT = "say how far a joint moves"
LET_GO = "no longer hold two parts together"
ROVER = ROBOTS[: ROBOTS.index("\ncreate_robot 'plate'")]


def lines_of(it: Course) -> tuple[Look, list[str]]:
    """Accept what is left, and return what is written."""
    look = to_menu_or_review(it)
    assert it.page.kind is PageKind.REVIEW and look.problems == () and look.outcome is not None
    after = applied(it.session.document.text, look.outcome.edits)
    assert Session(after, it.session.path, environ={}).diagnostics == ()
    return look, list(look.outcome.lines)


def test_a_new_robot_begins_with_a_body() -> None:
    it = course("")
    choose(it, DESCRIBE, NEW)
    look, lines = lines_of(it)
    assert lines == [
        "create_robot 'rover' as rover",
        "rover has_link 'base_link'",
        "rover has_link 'body' shaped box 0.4, 0.3, 0.1 weighing 5 painted blue",
        "rover has_joint 'body_joint' of joint_type fixed from 'base_link' to 'body' at 0, 0, 0.05",
        *(
            f"rover {line}"
            for side, place in (("left", "0, 0.17, 0"), ("right", "0, -0.17, 0"))
            for line in (
                f"has_link '{side}_wheel' shaped cylinder 0.1, 0.04 weighing 0.5"
                " painted dark_gray turned 90, 0, 0 deg",
                f"has_joint '{side}_wheel_joint' of joint_type continuous from 'body'"
                f" to '{side}_wheel' at {place} with axis 0, 1, 0",
            )
        ),
        "generate_robot rover",
    ]
    assert [option.key for option in it.options(look)] == ["base", "wheels", "write"]
    it.want("wheels", False)
    assert len(it.look().outcome.lines) == 5  # type: ignore[union-attr]
    it.want("base", False)
    assert "rover has_link 'base_link'" not in it.look().outcome.lines  # type: ignore[union-attr]


def test_what_can_be_done_with_a_robot_names_it_and_its_package() -> None:
    alone = done_items(Session(f"{ROVER}generate_robot rover\n".encode(), None, environ={}), "")
    assert "robot" in alone["more"].about
    assert alone["screen.run(True, True)"].closed == "the program has no node to run yet"
    lines = "create_package 'pack' as pack\npack contains rover\ngenerate_package pack\n"
    packed = done_items(Session(f"{ROVER}{lines}".encode(), None, environ={}), "")
    assert packed["screen.run(True, True)"].closed == ""
    assert alone["screen.show('robots')"].is_advised
    assert {"part", "package"} <= set(alone) and "package" not in packed


def test_a_part_is_held_where_it_would_be_a_second_root() -> None:
    it = course(ROVER + "generate_robot rover\n")
    form = form_after(it, DESCRIBE, PART)
    entered = {"link": "lamp", "shape": "cylinder", "weight": "0.2", "color": "#ff8000"}
    for slot, text in entered.items():
        form.enter(slot, text)
    form.values.update({
        ("size", "radius"): "0.02", ("size", "length"): "0.1", ("position", "z"): "0.3",
        ("rotation", "pitch"): "90",
    })  # fmt: skip
    look, lines = lines_of(it)
    assert lines == [
        "rover has_link 'lamp' shaped cylinder 0.02, 0.1 weighing 0.2 painted \"#ff8000\""
        " at 0, 0, 0.3 turned 0, 90, 0 deg",
        "rover has_joint 'lamp_joint' of joint_type fixed from 'base_link' to 'lamp'",
    ]
    after = applied(it.session.document.text, look.outcome.edits)  # type: ignore[union-attr]
    assert after.endswith(b"'lamp'\ngenerate_robot rover\n")


@pytest.mark.parametrize(
    ("entered", "lines"),
    [
        ({"type": "continuous"}, [
            "rover has_link 'body' shaped box 0.4, 0.3, 0.1 weighing 1",
            "rover has_joint 'body_joint' of joint_type continuous from 'base_link' to 'body'"
            " with axis 0, 1, 0",
        ]),
        ({"type": "prismatic", "joint": "lift", "parent": "base_link"}, [
            "rover has_link 'body' shaped box 0.4, 0.3, 0.1 weighing 1",
            "rover has_joint 'lift' of joint_type prismatic from 'base_link' to 'body'"
            " with axis 0, 0, 1",
            "rover limits_joint 'lift' between 0 and 0.5 m with effort 10 and velocity 1",
        ]),
        ({"type": "revolute", "mimicked": "mast_joint", "factor": "-1"}, [
            "rover has_link 'body' shaped box 0.4, 0.3, 0.1 weighing 1",
            "rover has_joint 'body_joint' of joint_type revolute from 'base_link' to 'body'"
            " with axis 0, 0, 1 mimicking 'mast_joint' times -1",
            "rover limits_joint 'body_joint' between -90 and 90 deg with effort 10 and velocity 1",
        ]),
    ],
)  # fmt: skip
def test_a_joint_comes_with_the_link_that_it_holds(
    entered: dict[str, str], lines: list[str]
) -> None:
    it = course(ROVER + "generate_robot rover\n")
    form = form_after(it, DESCRIBE, JOINT)
    for slot, text in entered.items():
        form.enter(slot, text)
    assert lines_of(it)[1] == lines


def test_the_ends_of_what_slides_are_in_metres() -> None:
    it = course(
        ROVER + "rover has_link 'fork' shaped box 1, 1, 1 weighing 1\n"
        "rover has_joint 'lift' of joint_type prismatic from 'base_link' to 'fork'\n"
    )
    form_after(it, DESCRIBE, LIMIT).enter("joint", "lift")
    limit = "rover limits_joint 'lift' between 0 and 0.5 m with effort 10 and velocity 1"
    assert lines_of(it)[1][0] == limit


def test_a_link_goes_along_with_the_joint_that_held_it() -> None:
    it = course(ROVER + "generate_robot rover\n")
    choose(it, DESCRIBE, LET_GO)
    assert lines_of(it)[1] == [
        "rover no_longer_has_joint 'wheel_joint'",
        "rover no_longer_has_link 'wheel'",
    ]


@pytest.mark.parametrize(
    ("purpose", "entered", "values", "slot", "words"),
    [
        (PART, {"shape": "box"}, {("size", "y"): ""}, "size", "y is needed, such as 0.3"),
        (PART, {"shape": "box"}, {("size", "y"): "wide"}, "size", "y is a number"),
        (PART, {"shape": "ball"}, {}, "shape", "no such shape"),
        (PART, {"shape": "mesh"}, {}, "size", "uri is needed"),
        (PART, {}, {("position", "x"): "1 m"}, "position", "x is a number"),
        (PART, {"weight": "heavy"}, {}, "weight", "a number of kilograms"),
        (PART, {"color": "bleu"}, {}, "color", "`bleu`"),
        (PART, {"weight": "0"}, {}, "weight", "0"),
        (JOINT, {"type": "hinge"}, {}, "type", "no such joint type"),
        (JOINT, {"type": "continuous", "axis": "up"}, {}, "axis", "three numbers"),
        (JOINT, {"type": "continuous", "axis": "0, 0, 0"}, {}, "axis", "nowhere"),
        (LIMIT, {"effort": "much"}, {}, "effort", "it is a number"),
    ],
)  # fmt: skip
def test_what_is_wrong_is_said_at_its_row(
    purpose: str,
    entered: dict[str, str],
    values: dict[tuple[str, ...], str],
    slot: str,
    words: str,
) -> None:
    it = course(ROVER)
    form = form_after(it, DESCRIBE, purpose)
    for name, text in entered.items():
        form.enter(name, text)
    form.values.update(values)
    found = it.look().problems[0]
    assert found.slot == slot and words in found.words
    assert not values or found.path == next(iter(values))


def test_a_loaded_robot_is_changed_in_what_it_has(tmp_path: Path) -> None:
    (tmp_path / "old.urdf").write_text(
        '<?xml version="1.0"?>\n<robot name="old">\n  <link name="base"/>\n'
        '  <link name="arm"/>\n  <joint name="turn" type="continuous">\n'
        '    <parent link="base"/>\n    <child link="arm"/>\n    <mimic joint="hand"/>\n'
        '  </joint>\n  <link name="tip"/>\n  <joint name="hand" type="continuous">\n'
        '    <parent link="arm"/>\n    <child link="tip"/>\n  </joint>\n</robot>\n'
    )
    it = course("load_robot 'old.urdf' as old\n", tmp_path)
    part = form_after(it, DESCRIBE, PART)
    part.enter("link", "arm")
    part.enter("shape", "sphere")
    # It is held already.
    arm = "old has_link 'arm' shaped sphere 0.05 weighing 1"
    assert lines_of(it)[1] == [arm, "generate_robot old"]
    it = course("load_robot 'old.urdf' as old\n", tmp_path)
    form = form_after(it, DESCRIBE, JOINT)
    filled = it.look().of(form)
    assert filled is not None
    assert [each.text for each in it.choices(filled, "joint", None, "")] == ["turn", "hand"]
    form.enter("joint", "turn")
    form.values["position", "z"] = "0.2"
    filled = it.look().of(form)
    assert filled is not None
    assert [each.text for each in it.choices(filled, "mimicked", None, "")] == ["hand", "none"]
    form.enter("mimicked", "none")
    assert lines_of(it)[1][0] == "old has_joint 'turn' at 0, 0, 0.2 mimicking none"
    form.enter("mimicked", "")
    assert lines_of(it)[1] == [
        "old has_joint 'turn' at 0, 0, 0.2",
        "generate_robot old",
    ]


@pytest.mark.long
async def test_a_robot_is_seen_while_its_form_is_filled(program: Path) -> None:
    program.write_text(ROVER)
    async with wizard(program) as it:
        await it.go(DESCRIBE, PART)
        await it.go_to("shape")
        assert it.choices[:2] == ["box", "cylinder"]
        await it.press("down")
        before = it.view("graph")
        assert it.rows["size radius"] == "0.1" and "size x" not in it.rows
        await it.write("size radius", "0.3")
        assert "cylinder 0.3, 0.05" in it.statements[0]
        assert it.view("graph") != before
        assert 'cylinder radius="0.3"' in it.view("code")


@pytest.mark.long
async def test_a_robot_is_described_from_nothing_by_keys(here: Path) -> None:
    async with wizard() as it:
        await it.go(DESCRIBE, NEW)
        await it.finish()
        await it.pick("something more")
        await it.go(DESCRIBE, JOINT)
        await it.write("type", "continuous")
        await it.write("position y", "0.17")
        await it.press("enter")
        await it.write("link", "wheel")
        await it.write("shape", "cylinder")
        await it.write("rotation roll", "90")
        await it.finish()
        text = it.driver.text
    session = Session(text.encode(), environ={})
    assert session.diagnostics == ()
    (robot,) = session.workspace.robots.values()
    wheels = ["left_wheel", "right_wheel", "wheel"]
    assert list(robot.description.links) == ["base_link", "body", *wheels]
    assert it.keys <= 60
