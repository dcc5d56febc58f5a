"""Robots as entries: the tree of their links, each below the joint that holds it."""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Iterable, Iterator, Mapping
from math import degrees
from typing import TYPE_CHECKING

from plastron_tui.diagnostics import Diagnostic, Span, counted
from plastron_tui.language.declaration import DECLARATIONS
from plastron_tui.language.sentence import sentence
from plastron_tui.language.statements import (
    HasJoint,
    HasLink,
    NoLongerHasJoint,
    NoLongerHasLink,
)
from plastron_tui.model.robot_macros import call_words
from plastron_tui.output.graphs.robots.captions import axis_text
from plastron_tui.output.graphs.robots.shades import color_of
from plastron_tui.ros.robots.description import (
    Body,
    Box,
    Cylinder,
    Joint,
    JointType,
    Limit,
    Link,
    Material,
    Mesh,
    Rgba,
    Shape,
    Sphere,
)
from plastron_tui.ros.robots.materials import defined_materials, meant
from plastron_tui.ros.robots.tree import Branch, branches, held_by, holders

from .entry import SIGNS, Entries, Entry, Subject
from .robot_places import faults_in, place_of

if TYPE_CHECKING:
    from plastron_tui.language import Program
    from plastron_tui.model.robots import Places, Robot

    from ..analysis import Analysis

_EMPTY = "no robots yet\ncreate_robot 'rover' as rover"
_BETWEEN = " · "
_CALL = "⋯"
"""The sign of a call of a macro that is not expanded."""

_PLACE_ONLY = "□"
"""The sign of a link that has no shape."""

_JOINT_SIGNS = {
    JointType.FIXED: "─",
    JointType.REVOLUTE: "◠",
    JointType.CONTINUOUS: "○",
    JointType.PRISMATIC: "⇄",
    JointType.PLANAR: "▱",
    JointType.FLOATING: "∗",
}


def robot_entries(analysis: Analysis) -> Entries:
    """Return the entries of all robots of a program."""
    faults = _Faults(analysis.diagnostics)
    robots = analysis.workspace.robots.values()
    written = {each.robot.variable for each in analysis.workspace.written_robots}
    held = {name for each in analysis.workspace.packages.values() for name in each.contents}
    found: list[Entry] = []
    for robot in robots:
        is_written = robot.variable in written | held
        found += _Tree(robot, faults).entries(is_written)
        found += _without_effect(robot, analysis.program, faults)
    return Entries(found, _EMPTY)


class _Faults:
    """What is wrong, by where it is."""

    def __init__(self, diagnostics: Iterable[Diagnostic]) -> None:
        self.all = tuple(diagnostics)
        own = [each for each in self.all if each.file is None and each.span is not None]
        self._found = sorted(own, key=lambda each: each.span or (0, 0))
        self._starts = [each.span.start for each in self._found if each.span is not None]

    def within(self, *spans: Span | None) -> Diagnostic | None:
        """Return the first mistake in some statements, None where none is."""
        for span in spans:
            at = len(self._starts) if span is None else bisect_left(self._starts, span.start)
            if span is not None and at < len(self._starts) and self._starts[at] < span.end:
                return self._found[at]
        return None


class _Tree:
    """The entries of one robot."""

    def __init__(self, robot: Robot, faults: _Faults) -> None:
        self._robot = robot
        self._description = robot.shown
        self._holders = holders(robot.shown)
        self._materials = defined_materials(robot.shown)
        self._faults = faults
        source = robot.source
        self._in_file = {} if source is None else faults_in(source, faults.all)

    def entries(self, is_written: bool) -> Iterator[Entry]:
        """Yield the robot, and its links in the order of the tree; then what is in none."""
        robot, description = self._robot, self._description
        source = robot.source
        parts = ["" if robot.variable == robot.name else robot.variable]
        parts.append("" if source is None else source.path.name)
        count = len(description.links)
        parts.append(counted(count, "link") if count else "")
        fault = self._faults.within(robot.span)
        warning = "" if is_written or source is not None else "not written"
        yield Entry(
            f"robot {robot.variable}",
            robot.name,
            _BETWEEN.join(filter(None, parts)),
            *SIGNS[Subject.ROBOT],
            warning=fault.message if fault is not None else warning,
            span=robot.span,
            subject=Subject.ROBOT,
            name=robot.variable,
            is_branch=bool(description.links),
        )
        children = held_by(description)
        links, joints = set[str](), set[str]()
        for branch in branches(description):
            links.add(branch.link)
            if branch.joint is not None:
                joints.add(branch.joint.name)
                yield self._joint(branch.joint, branch.depth + 1)
            yield self._link(branch, bool(children.get(branch.link)))
        for name in description.links:
            if name not in links:
                yield self._link(Branch(name, None, 0), is_branch=False)
        for joint in description.joints.values():
            if joint.name not in joints:
                yield self._joint(joint, 1)
        yield from self._calls()

    def _calls(self) -> Iterator[Entry]:
        """Yield the calls of macros that are not expanded, in the place of what they make."""
        source = self._robot.source
        if source is None or source.macros is None or source.expanded is not None:
            return
        for number, call in enumerate(source.macros.calls):
            yield Entry(
                f"call {self._robot.variable} {number}",
                call.macro,
                call_words(call),
                _CALL,
                depth=1,
                robot=self._robot.variable,
                place=f"{source.path.name}, line {call.line}",
            )

    def _link(self, branch: Branch, is_branch: bool) -> Entry:
        link = self._description.links[branch.link]
        sign, tone = _swatch(link, self._materials)
        return self._part(
            Subject.LINK, link.name, self._robot.links.get(link.name), link_text(link), sign, tone,
            branch.depth + 1, is_branch=is_branch,
        )  # fmt: skip

    def _joint(self, joint: Joint, depth: int) -> Entry:
        return self._part(
            Subject.JOINT, joint.name, self._robot.joints.get(joint.name), joint_text(joint),
            _JOINT_SIGNS[joint.type], SIGNS[Subject.JOINT][1], depth,
        )  # fmt: skip

    def _part(
        self,
        subject: Subject,
        name: str,
        places: Places | None,
        detail: str,
        sign: str,
        tone: str,
        depth: int,
        *,
        is_branch: bool = False,
    ) -> Entry:
        robot = self._robot
        spans = () if places is None else (places.made, places.changed, places.limited)
        fault = self._faults.within(*spans)
        source = robot.source
        return Entry(
            f"{subject.value} {robot.variable} {name}",
            name,
            detail,
            sign,
            tone,
            warning=fault.message if fault is not None else self._in_file.get((subject, name), ""),
            depth=depth,
            span=next((each for each in spans if each is not None), None),
            subject=subject,
            name=name,
            edits=fault.fix.edits if fault is not None and fault.fix is not None else (),
            is_branch=is_branch,
            ending=self._ending(subject, name),
            robot=robot.variable,
            place="" if source is None else place_of(source, (subject, name)),
        )

    def _ending(self, subject: Subject, name: str) -> str:
        """Return what takes a part away; a link goes along with the joint that holds it."""
        if subject is Subject.JOINT:
            texts = {"robot": self._robot.variable, "joint": name}
            return sentence(DECLARATIONS[NoLongerHasJoint], texts)
        texts = {"robot": self._robot.variable, "link": name}
        ending = sentence(DECLARATIONS[NoLongerHasLink], texts)
        holder = self._holders.get(name)
        if holder is None:
            return ending
        return f"{self._ending(Subject.JOINT, holder.name)}\n{ending}"


def _without_effect(robot: Robot, program: Program, faults: _Faults) -> Iterator[Entry]:
    """Yield the sentences about parts of a robot that have a mistake, and so no effect."""
    for statement in program.statements:
        if not isinstance(statement, HasLink | HasJoint) or statement.robot != robot.variable:
            continue
        is_link = isinstance(statement, HasLink)
        name = statement.link if isinstance(statement, HasLink) else statement.joint
        there = robot.shown.links if is_link else robot.shown.joints
        fault = faults.within(statement.span)
        if name in there or fault is None:
            continue
        yield Entry(
            f"broken {robot.variable} {name}",
            name,
            sign="✖",
            tone="error",
            warning=fault.message,
            depth=1,
            span=statement.span,
            edits=fault.fix.edits if fault.fix is not None else (),
            robot=robot.variable,
        )


def _swatch(link: Link, materials: Mapping[str, Material]) -> tuple[str, str]:
    """Return a square in the colour of a link; an empty one of a link without a shape."""
    if not (link.visuals or link.collisions):
        return _PLACE_ONLY, "quiet"
    rgba = _color_of(link.visuals, materials)
    return SIGNS[Subject.LINK] if rgba is None else (SIGNS[Subject.LINK][0], color_of(rgba))


def _color_of(bodies: Iterable[Body], materials: Mapping[str, Material]) -> Rgba | None:
    """Return the first colour of bodies, by what the names of materials mean."""
    found = (each.material for each in bodies if each.material is not None)
    return next((rgba for each in found if (rgba := meant(each, materials).rgba)), None)


def link_text(link: Link) -> str:
    """Return what a link is: its shape in metres, what it weighs, its colour."""
    bodies = link.visuals or link.collisions
    parts = [shape_text(bodies[0].shape) if bodies else "a place"]
    if len(bodies) > 1:
        parts[0] += f" and {len(bodies) - 1} more"
    if link.inertial is not None:
        parts.append(f"{link.inertial.mass:g} kg")
    names = (each.material.name for each in link.visuals if each.material is not None)
    parts.append(next(names, ""))
    return _BETWEEN.join(filter(None, parts))


def shape_text(shape: Shape | None) -> str:
    """Return a shape, its lengths in metres."""
    match shape:
        case Box(size=size):
            return f"box {' × '.join(f'{each:g}' for each in size)}"
        case Cylinder(radius=radius, length=length):
            return f"cylinder r {radius:g}, l {length:g}"
        case Sphere(radius=radius):
            return f"sphere r {radius:g}"
        case Mesh(uri=uri):
            return f"mesh {uri.rpartition('/')[2]}"
        case None:
            return "a shape that is not known"


def joint_text(joint: Joint) -> str:
    """Return how a joint moves: its type, axis and limits."""
    parts = [joint.type.value]
    if joint.type.has_axis:
        parts[0] += f" {axis_text(joint.axis)}"
    if joint.limit is not None:
        parts += limit_texts(joint.limit, joint.type)
    if joint.mimic is not None:
        parts.append(f"follows {joint.mimic.joint}")
    return _BETWEEN.join(parts)


def limit_texts(limit: Limit, type_: JointType) -> Iterator[str]:
    """Yield what limits a joint: degrees or metres, then effort and velocity."""
    if type_.is_limited:
        is_angle = type_.turns
        ends = (limit.lower, limit.upper)
        low, high = (f"{round(degrees(x), 1) if is_angle else x:g}" for x in ends)
        yield f"{low} to {high}{'°' if is_angle else ' m'}"
    if limit.effort or limit.velocity:
        turns = type_.turns
        yield f"{limit.effort:g} {'N m' if turns else 'N'}"
        yield f"{limit.velocity:g} {'rad/s' if turns else 'm/s'}"
