"""Robots' files with random damage are read, or told to be wrong, in no time."""

from __future__ import annotations

import random
from dataclasses import replace

import pytest
from machine import examples
from mutated_urdf import ROBOT, mutated

from plastron_tui.ros.robots.description import Body, Description, Joint, Link, Pose, Sphere
from plastron_tui.sources.urdf.edits import edited
from plastron_tui.sources.urdf.equality import same_robot
from plastron_tui.sources.urdf.reader import read_urdf


def test_a_damaged_file_is_read_and_changed_as_far_as_it_can_be() -> None:
    choice = random.Random(15)
    for _ in range(examples(600)):
        text = mutated(choice)
        before = read_urdf(text).description
        if before is None:
            continue
        after = changed(before, choice)
        edit = edited(text, before, after)
        assert edit.diagnostics or edit.text is not None
        if edit.text is not None:
            again = read_urdf(edit.text).description
            assert again is not None
            assert same_robot(replace(again, links={}), replace(after, links={}))


def changed(robot: Description, choice: random.Random) -> Description:
    """Return a robot with a link and a joint changed, or with more of them."""
    links, joints = dict(robot.links), dict(robot.joints)
    for name, link in list(links.items())[: choice.randrange(3)]:
        links[name] = link._replace(collisions=(Body(Sphere(choice.random() + 1)),))
    for name, joint in list(joints.items())[: choice.randrange(3)]:
        joints[name] = joint._replace(pose=Pose((choice.random(), 0, 0)))
    if choice.random() < 0.3:
        links["more"] = Link("more")
    for name, joint in list(joints.items())[: choice.randrange(2)]:
        del joints[name]
        joints["other"] = Joint("other", joint.type, joint.child, joint.parent)
    return replace(robot, links=links, joints=joints)


HOSTILE = {
    "entities": b'<!DOCTYPE robot [<!ENTITY a "aaaa"><!ENTITY b "&a;&a;&a;">]>'
    b'<robot name="&b;"><link name="a"/></robot>',
    "a file": b'<!DOCTYPE robot [<!ENTITY a SYSTEM "file:///etc/passwd">]>'
    b'<robot name="&a;"><link name="a"/></robot>',
    "depth": b"<robot name='a'>" * 100_000,
    "size": b"<robot name='a'>" + b" " * 5_000_000 + b"</robot>",
    "no text": bytes(range(256)),
    "nothing": b"",
}


@pytest.mark.parametrize("name", HOSTILE)
def test_nothing_is_expanded_and_all_is_bounded(name: str) -> None:
    read = read_urdf(HOSTILE[name])
    assert read.description is None
    (found,) = read.diagnostics
    assert found.message


def test_a_number_of_many_digits_is_read() -> None:
    text = ROBOT.replace(b'"0.5"', b'"' + b"1" * 100_000 + b'"')
    read = read_urdf(text)
    assert read.description is not None
    assert any("is no number" in each.message for each in read.diagnostics)
    assert all(len(each.message) < 10_000 for each in read.diagnostics)


def test_mistakes_without_end_are_counted() -> None:
    read = read_urdf(b"<robot name='r'>" + b"<link/>" * 1_000 + b"</robot>")
    assert len(read.diagnostics) == 101
    assert read.diagnostics[-1].message == "there are 900 mistakes more in the file"
