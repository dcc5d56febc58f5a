"""Comments above parts of a robot that are taken away."""

from __future__ import annotations

from dataclasses import replace

import pytest

from plastron_tui.ros.robots.description import Description
from plastron_tui.sources.urdf.edits import edited
from plastron_tui.sources.urdf.reader import read_urdf

WHEEL = """\
  <link name="left_wheel"/>
  <joint name="left_joint" type="fixed">
    <parent link="base"/>
    <child link="left_wheel"/>
  </joint>
"""


def without_wheel(robot: Description) -> Description:
    links = {name: link for name, link in robot.links.items() if name != "left_wheel"}
    joints = {name: joint for name, joint in robot.joints.items() if name != "left_joint"}
    return replace(robot, links=links, joints=joints)


def rover(inner: str) -> str:
    return f'<!-- left wheel -->\n<robot name="r">\n  <link name="base"/>\n{inner}</robot>\n'


STAYS = "a comment stays that stood above `left_wheel`, which is taken away"
LAST = '\n  <link name="lidar"/>\n'
CASES = {
    "its name": ("\n  <!-- Left wheel -->\n" + WHEEL + LAST, LAST, None),
    "its name, with nothing apart": (
        "  <!-- the left wheel, and its joint -->\n" + WHEEL,
        "  <!-- the left wheel, and its joint -->\n",
        STAYS,
    ),
    "its name between rulers": (
        "\n  <!-- *** -->\n  <!-- left_wheel link -->\n  <!-- *** -->\n" + WHEEL + LAST,
        LAST,
        None,
    ),
    "a word of its own": (
        "\n  <!-- 40 grams -->\n" + WHEEL + LAST,
        "\n  <!-- 40 grams -->\n" + LAST,
        STAYS,
    ),
    "what somebody left out": (
        '\n  <!-- <link name="left_wheel"/> -->\n' + WHEEL,
        '\n  <!-- <link name="left_wheel"/> -->\n',
        STAYS,
    ),
    "of a part that stays as well": (
        "\n  <!-- left wheel -->\n" + WHEEL + LAST.lstrip("\n"),
        "\n  <!-- left wheel -->\n" + LAST.lstrip("\n"),
        None,
    ),
    "apart from it": (
        "\n  <!-- left wheel -->\n\n" + WHEEL + LAST,
        "\n  <!-- left wheel -->\n" + LAST,
        None,
    ),
    "in the line of the part before": (
        '  <link name="lidar"/> <!-- left wheel -->\n' + WHEEL,
        '  <link name="lidar"/> <!-- left wheel -->\n',
        None,
    ),
    "above the part and above its joint": (
        "  <!-- left wheel -->\n" + WHEEL.replace("  <joint", "  <!-- left joint -->\n  <joint"),
        "",
        None,
    ),
}


@pytest.mark.parametrize("newline", ["\n", "\r\n"])
@pytest.mark.parametrize("name", CASES)
def test_a_comment_goes_with_what_it_names_alone(name: str, newline: str) -> None:
    before, after, told = CASES[name]
    text = rover(before).replace("\n", newline).encode()
    robot = read_urdf(text).description
    assert robot is not None
    edit = edited(text, robot, without_wheel(robot))
    assert edit.text is not None
    assert edit.text.decode().replace("\r\n", "\n") == rover(after)
    assert [each.message.partition(":")[0] for each in edit.diagnostics] == [told] * bool(told)
    for each in edit.diagnostics:
        assert each.span is not None
        assert text[each.span.start :].startswith(b"<!--")
