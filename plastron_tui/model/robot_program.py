"""The description of a robot, written as a program that describes the same."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping
from typing import Any

from plastron_tui.diagnostics import Diagnostic, Severity, codes
from plastron_tui.language import DECLARATIONS
from plastron_tui.language.sentence import sentence
from plastron_tui.language.statements import (
    CreateRobot,
    GenerateRobot,
    HasJoint,
    HasLink,
    LimitsJoint,
)
from plastron_tui.ros.robots.bodies import Bodies
from plastron_tui.ros.robots.description import (
    ORIGIN,
    Body,
    Description,
    Joint,
    JointType,
    Limit,
    Link,
    Material,
    Pose,
)
from plastron_tui.ros.robots.materials import defined_materials, meant
from plastron_tui.ros.robots.names import is_name

from .program_text import Variables
from .robot_words import angle_words, color_words, limit_words, number, numbers, shape_words

_OF_THE_WHOLE = (codes.NO_TREE, codes.MISSING_LIMITS)
"""What is wrong with a robot, and no better without one of its statements."""

_MOST_TURNS = 10

_BODIES = Bodies(lambda _: None)
"""What follows from shapes, without meshes: their files are not looked at."""

Check = Callable[[bytes], Iterable[Diagnostic]]
"""Returns what is wrong with a program."""


def _right(_: bytes) -> Iterable[Diagnostic]:
    return ()


def program_of_robot(robot: Description, stem: str, check: Check = _right) -> str:
    """Return a program that describes a robot.

    What a statement can say becomes one, and the rest a comment. So does a statement that is
    wrong, such as a box without height.

    Args:
        robot: the robot.
        stem: what a robot is called that has no name that a program may give it.
        check: returns what is wrong with a program.
    """
    program = _program(robot, stem)
    # What names a part that is not there is found when that is a comment.
    for _ in range(_MOST_TURNS):
        wrong: dict[int, str] = {}
        text = program.encode()
        for each in check(text):
            if each.severity is Severity.ERROR and each.span and each.code not in _OF_THE_WHOLE:
                wrong.setdefault(text.count(b"\n", 0, each.span.start), each.message)
        if not wrong:
            break
        lines = enumerate(program.split("\n"))
        program = "\n".join(
            _left_out(line, wrong[at]) if at in wrong else line for at, line in lines
        )
    return program


def _left_out(line: str, message: str) -> str:
    return f"// {' '.join(message.split())}\n// {line}"


def _program(robot: Description, stem: str) -> str:
    lines: list[str] = []
    name = robot.name
    if not is_name(name):
        lines.append(f"// the robot's name is {_shown(name)}")
        name = re.sub(r"[^\w.-]+", "_", stem, flags=re.ASCII).strip("_.-") or "robot"
        name = name if is_name(name) else f"robot_{name}"
    variable = Variables().new(name)
    lines.append(_sentence(CreateRobot, {"name": name, "variable": variable}))
    materials = defined_materials(robot)
    for link in robot.links.values():
        lines += _link(variable, link, materials)
    # A joint follows one that is there.
    joints = sorted(robot.joints.values(), key=lambda each: each.mimic is not None)
    for joint in joints:
        lines += _joint(variable, joint, robot)
    lines.append(_sentence(GenerateRobot, {"robot": variable}))
    return "\n".join(lines) + "\n"


def _sentence(statement: Any, slots: dict[str, str]) -> str:
    return sentence(DECLARATIONS[statement], slots)


def _link(variable: str, link: Link, materials: Mapping[str, Material]) -> Iterator[str]:
    if not is_name(link.name):
        yield f"// a link is called {_shown(link.name)}, which no program can say"
        return
    bodies = (*link.visuals, *link.collisions)
    body = next((each for each in bodies if each.shape is not None), None)
    slots = {"robot": variable, "link": link.name}
    if body is not None and body.shape is not None:
        shape, _, size = shape_words(body.shape).partition(" ")
        slots |= {"shape": shape, "size": size, **_placed(body.pose)}
        if link.inertial is not None and link.inertial.mass > 0:
            slots["weight"] = number(link.inertial.mass)
        material = next((each.material for each in link.visuals if each.material), None)
        if material is not None:
            slots["color"] = color_words(meant(material, materials)) or ""
    yield from (f"// {link.name}: {each}" for each in _unsaid(link, body, slots))
    yield _sentence(HasLink, slots)


def _placed(pose: Pose) -> dict[str, str]:
    slots = {}
    if pose.position != ORIGIN:
        slots["position"] = numbers(pose.position)
    if pose.rotation != ORIGIN:
        slots["rotation"], _, slots["unit"] = angle_words(pose.rotation).rpartition(" ")
    return slots


def _unsaid(link: Link, body: Body | None, slots: dict[str, str]) -> Iterator[str]:
    """Yield what the statement of a link leaves out, or says otherwise."""
    if body is None:
        if link.inertial is not None:
            yield f"it weighs {number(link.inertial.mass)} kg, and has no shape"
        if link.visuals or link.collisions:
            yield "its shape is not known"
        return
    same = (body.shape, body.pose)
    if len(link.visuals) > 1 or not link.visuals:
        yield (
            f"what is seen of it are {len(link.visuals)} shapes"
            if link.visuals
            else ("nothing is seen of it")
        )
    if len(link.collisions) != 1 or (link.collisions[0].shape, link.collisions[0].pose) != same:
        yield "what collides is something else" if link.collisions else "it does not collide"
    if any(each.material is not None for each in link.visuals) and not slots.get("color"):
        yield "its material is one that a program has no words for"
    if link.inertial is not None and not _BODIES.follows(link.inertial, body):
        yield "its inertia is another one than that of its shape"


def _joint(variable: str, joint: Joint, robot: Description) -> Iterator[str]:
    names = (joint.name, joint.parent, joint.child)
    strange = next((each for each in names if not is_name(each)), None)
    if strange is not None:
        yield f"// a joint says {_shown(strange)}, which no program can say"
        return
    slots = {
        "robot": variable,
        "joint": joint.name,
        "type": joint.type.value,
        "parent": joint.parent,
        "child": joint.child,
        **_placed(joint.pose),
    }
    if joint.axis is not None and joint.type.has_axis and any(joint.axis):
        slots["axis"] = numbers(joint.axis)
    followed = None if joint.mimic is None else robot.joints.get(joint.mimic.joint)
    if joint.mimic is not None and (followed is None or followed.type is JointType.FIXED):
        yield f"// {joint.name}: it follows {_shown(joint.mimic.joint)}, which does not move"
    elif joint.mimic is not None:
        slots["mimicked"] = joint.mimic.joint
        if joint.mimic.multiplier != 1:
            slots["factor"] = number(joint.mimic.multiplier)
        if joint.mimic.offset:
            offset = number(joint.mimic.offset)
            yield f"// {joint.name}: it is {offset} further than what it follows"
    yield _sentence(HasJoint, slots)
    limits = dict(_limits(joint))
    if limits:
        yield _sentence(LimitsJoint, {"robot": variable, "joint": joint.name, **limits})


def _limits(joint: Joint) -> Iterator[tuple[str, str]]:
    limit, dynamics = joint.limit or Limit(), joint.dynamics
    if joint.type.is_limited and joint.limit is not None:
        words = re.fullmatch(r"between (\S+) and (\S+) (\S+)", limit_words(joint))
        assert words is not None, "a range is two numbers and a unit"
        yield from zip(("minimum", "maximum", "unit"), words.groups(), strict=True)
    if joint.limit is not None and (joint.type.is_limited or joint.type.turns):
        yield "effort", number(limit.effort)
        yield "velocity", number(limit.velocity)
    if dynamics is not None and joint.type.has_axis:
        yield "damping", number(dynamics.damping)
        yield "friction", number(dynamics.friction)


def _shown(name: str) -> str:
    return f"`{' '.join(name.split())}`"
