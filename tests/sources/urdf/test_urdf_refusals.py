"""Changes of robots' files that are refused, or made with a word; the place is that in the file."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import pytest

from plastron_tui.ros.robots.description import (
    Body,
    Description,
    Joint,
    JointType,
    Link,
    Pose,
    Sphere,
)
from plastron_tui.sources.urdf.edits import UrdfEdit, edited
from plastron_tui.sources.urdf.reader import read_urdf

Change = Callable[[Description], Description]
TEXT = """\
<robot name="r">
  <link name="a"/>
  <link name="b"/>
  <joint name="j" type="fixed">
    <parent link="a"/>
    <child link="b"/>
    <origin xyz="0 0 1"/>
  </joint>
  <gazebo reference="b"><gravity>0</gravity></gazebo>
  <gazebo reference="j"/>
  <gazebo reference="a"/>
</robot>
"""
MACROS = TEXT.replace('name="r"', 'name="r" xmlns:xacro="http://www.ros.org/wiki/xacro"')


def make(text: str, change: Change) -> UrdfEdit:
    before = read_urdf(text.encode()).description
    assert before is not None
    return edited(text.encode(), before, change(before))


def without_b(robot: Description) -> Description:
    return replace(robot, links={"a": robot.links["a"]}, joints={})


def placed(robot: Description) -> Description:
    return replace(robot, joints={"j": robot.joints["j"]._replace(pose=Pose())})


def with_k(robot: Description) -> Description:
    return replace(robot, joints={**robot.joints, "k": Joint("k", JointType.FIXED, "b", "c")})


def seen(robot: Description) -> Description:
    return replace(robot, links={**robot.links, "b": Link("b", (Body(Sphere(1)),))})


REFUSED: dict[str, tuple[str, Change, str, str]] = {
    "what would count instead": (
        TEXT.replace("<origin", '<origin xyz="0 0 3"/><origin'),
        placed,
        'joint name="j"',
        "the joint `j` would not be what was asked for: something else stands in the file",
    ),
    "what cannot be read": (
        TEXT.replace("</robot>", '  <joint name="k" type="fixed"/>\n</robot>'),
        with_k,
        'joint name="k"',
        "a joint `k` stands here that cannot be read; correct it",
    ),
    "what a macro has a hand in": (
        MACROS.replace("0 0 1", "0 0 ${h}"),
        without_b,
        "0 0 ${h}",
        "`xyz` of `<origin>` is computed by a macro: `0 0 ${h}`",
    ),
    "what a macro computes": (
        MACROS.replace("0 0 1", "0 ${h} 1"),
        lambda robot: replace(
            robot, joints={"j": robot.joints["j"]._replace(pose=Pose((0, 0, 2)))}
        ),
        "origin",
        "`xyz` of `<origin>` is computed by a macro: `0 ${h} 1`",
    ),
    "where a macro may write it": (
        MACROS.replace('<link name="b"/>', '<link name="b"><xacro:x/></link>'),
        seen,
        "xacro:x",
        "`<xacro:x>` may write a `<visual>` here: add it where that is",
    ),
}


@pytest.mark.parametrize("name", REFUSED)
def test_what_cannot_be_made_as_asked_is_refused_at_its_place(name: str) -> None:
    text, change, where, message = REFUSED[name]
    edit = make(text, change)
    assert edit.text is None
    (told,) = edit.diagnostics
    assert told.message.startswith(message)
    assert told.span is not None
    assert text[told.span.start :].startswith(where)


def test_what_names_a_part_that_goes_is_told() -> None:
    edit = make(TEXT, without_b)
    assert edit.text is not None
    assert [each.message for each in edit.diagnostics] == [
        "`<gazebo>` in line 9 still names `b`, which is taken away",
        "`<gazebo>` in line 10 still names `j`, which is taken away",
    ]


def at(x: float, y: float, z: float) -> Change:
    def changed(robot: Description) -> Description:
        return replace(robot, joints={"j": robot.joints["j"]._replace(pose=Pose((x, y, z)))})

    return changed


@pytest.mark.parametrize(
    ("by_hand", "made"),
    [("0 0 2", "0 0 2"), ("0 0 1.0", "0 0 2"), ("0 0 3", None), ("5 0 1", None)],
)
def test_what_somebody_changed_meanwhile_is_not_written_over(
    by_hand: str, made: str | None
) -> None:
    before = read_urdf(TEXT.encode()).description
    assert before is not None
    edit = edited(TEXT.replace("0 0 1", by_hand).encode(), before, at(0, 0, 2)(before))
    if made is not None:
        assert edit.text == TEXT.replace("0 0 1", made).encode()
    else:
        assert edit.text is None
        assert "something else of the joint `j` by now" in edit.diagnostics[0].message


def test_what_cannot_be_read_stays_beside_what_changes() -> None:
    seen = (
        '<visual><geometry><sphere radius="1"/></geometry><material name="m">{}</material></visual>'
    )
    color = '<color rgba="red"/>'
    text = TEXT.replace('<link name="b"/>', f'<link name="b">{seen.format(color)}</link>')
    before = read_urdf(text.encode()).description
    assert before is not None
    body = before.links["b"].visuals[0]
    assert body.material is not None
    body = body._replace(material=body.material._replace(name="n"))
    after = replace(before, links={**before.links, "b": Link("b", (body,))})
    assert edited(text.encode(), before, after).text == text.replace('"m"', '"n"').encode()
