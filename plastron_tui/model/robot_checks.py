"""What is wrong with robots, once a program has come to its end."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any, NamedTuple, TypeAlias

from plastron_tui.diagnostics import Diagnostic, Edit, Fix, Label, Span
from plastron_tui.language import statements as st
from plastron_tui.language.declaration import Statement
from plastron_tui.language.lowering import Program
from plastron_tui.ros.robots.faults import Fault, FaultKind, faults, heavy_root, meant_root

from .robot_faults import CODES, help_of, message_of
from .robots import Robot
from .unique_names import numbered
from .workspace import Workspace

_SAID = frozenset({FaultKind.LONG, FaultKind.HEAVY, FaultKind.NAME, FaultKind.NO_VELOCITY})
"""What is told of the statement that says it, whatever else the robot is."""

_OF_THE_WHOLE = frozenset(
    {
        *(FaultKind.NO_LINKS, FaultKind.LOOSE, FaultKind.NO_PARENT, FaultKind.NO_CHILD),
        *(FaultKind.MIMICS_NOTHING, FaultKind.ROOT_INERTIA),
    }
)
"""What nobody can tell of a file whose macros are not expanded."""

_SLOTS: Mapping[FaultKind, str] = {
    FaultKind.LOOSE: "link",
    FaultKind.CIRCLE: "child",
    FaultKind.HELD_TWICE: "child",
    FaultKind.NO_PARENT: "parent",
    FaultKind.NO_CHILD: "child",
    FaultKind.NO_LIMITS: "type",
    FaultKind.MIMICS_NOTHING: "mimicked",
    FaultKind.MIMICS_FIXED: "mimicked",
    FaultKind.MIMIC_CIRCLE: "mimicked",
    FaultKind.MASS: "weight",
    FaultKind.SIZE: "size",
    FaultKind.INERTIA: "weight",
    FaultKind.ROOT_INERTIA: "weight",
}
"""The slot that is wrong of the statement that a fault comes from."""

_Key: TypeAlias = "tuple[str, str, str]"


class _Said(NamedTuple):
    """The statements about a program's robots.

    Attributes:
        of_parts: the last one about each part, by the robot's variable, `link` or `joint`, and
            the part's name.
        last: the last one that changes each robot, by its variable.
        writing: the last one that writes each robot likewise.
    """

    of_parts: Mapping[_Key, Statement]
    last: Mapping[str, Statement]
    writing: Mapping[str, Statement]


_PARTS: Mapping[type[Statement], str] = {
    st.HasLink: "link",
    st.NoLongerHasLink: "link",
    st.HasJoint: "joint",
    st.NoLongerHasJoint: "joint",
    st.LimitsJoint: "joint",
}
"""The slots of the parts that statements are about."""


def check_robots(program: Program, workspace: Workspace) -> Iterator[Diagnostic]:
    """Yield what is wrong with the robots of a program that has no other mistakes.

    What is only missing yet is told of robots that are written. Of a loaded robot only what the
    program adds is told; the rest was told where it was loaded.
    """
    if not workspace.robots:
        return
    written = _written(workspace)
    said = _said(program)
    for variable in workspace.robots:
        robot = written.get(variable, workspace.robots[variable])
        yield from _heavy_root_of_file(program, robot)
        if robot.source is not None and robot.description == robot.source.description:
            continue
        whole, source = robot.whole, robot.source
        start = None if source is None else source.whole or source.description
        before = set() if start is None else {(each.kind, each.part) for each in faults(start)}
        root = None if start is None else meant_root(start)
        for fault in faults(robot.description if whole is None else whole, root):
            is_lack = fault.kind.is_lack and variable not in written
            is_open = whole is None and fault.kind in _OF_THE_WHOLE
            is_unmeasured = fault.kind is FaultKind.WEIGHTLESS and _weighs(fault, said, variable)
            is_old = (fault.kind, fault.part) in before
            is_told = is_unmeasured or fault.kind in _SAID
            if not (is_lack or is_open or is_old or is_told):
                yield _told(fault, robot, said)


def _weighs(fault: Fault, said: _Said, robot: str) -> bool:
    """Tell whether a link has a weight that no inertia follows from: that of a mesh, say."""
    statement = said.of_parts.get((robot, "link", fault.part))
    return isinstance(statement, st.HasLink) and statement.weight is not None


def _heavy_root_of_file(program: Program, robot: Robot) -> Iterator[Diagnostic]:
    """Yield a warning for the root of a file that has an inertia, and still is the root."""
    start = None if robot.source is None else robot.source.whole
    root = None if start is None else heavy_root(start)
    whole = robot.whole
    if root is None or whole is None or heavy_root(whole, root) != root:
        return
    fault = Fault(FaultKind.ROOT_INERTIA, root)
    loading = next((each for each in program.statements if each.span == robot.span), None)
    fix = None if loading is None else _with_root(root, robot, Span(robot.span.end, robot.span.end))
    where = robot.span if loading is None else loading.span_of("source")
    code, help_ = CODES[fault.kind], help_of(fault, robot)
    yield Diagnostic(code, message_of(fault), where, help=help_, fix=fix)


def _written(workspace: Workspace) -> dict[str, Robot]:
    """Return the robots that are written, by variable, each as it is written last."""
    found = {each.robot.variable: each.robot for each in workspace.written_robots}
    for written in workspace.written_packages:
        for contained in written.package.contents.values():
            if isinstance(contained.item, Robot):
                found[contained.item.variable] = contained.item
    return found


def _said(program: Program) -> _Said:
    of_parts: dict[_Key, Statement] = {}
    last: dict[str, Statement] = {}
    writing: dict[str, Statement] = {}
    for statement in program.statements:
        type_: Any = type(statement)  # which mypy takes for not hashable
        slot = _PARTS.get(type_)
        of: Any = statement
        if isinstance(statement, st.GenerateRobot):
            writing[statement.robot] = statement
        if slot is None:
            continue
        last[of.robot] = statement
        # Limits are a second thing that is said of a joint.
        key = "limits" if type_ is st.LimitsJoint else slot
        of_parts[of.robot, key, getattr(of, slot)] = statement
    return _Said(of_parts, last, writing)


def _told(fault: Fault, robot: Robot, said: _Said) -> Diagnostic:
    where, statement = _place(fault, robot, said)
    labels = tuple(
        Label(other.span, "this is one of them")
        for other in _others(fault, robot, said)
        if other is not statement
    )
    fix = None
    if fault.kind is FaultKind.ROOT_INERTIA and isinstance(statement, st.HasLink):
        fix = _with_root(fault.part, robot, statement.span)
    help_ = help_of(fault, robot)
    return Diagnostic(
        CODES[fault.kind], message_of(fault), where, help=help_, fix=fix, labels=labels
    )


def _place(fault: Fault, robot: Robot, said: _Said) -> tuple[Span, Statement | None]:
    """Return where a fault stands, and the statement that it comes from, if that is known."""
    writing = said.writing.get(robot.variable)
    if fault.kind is FaultKind.NO_LINKS and writing is not None:
        return writing.span_of("robot"), writing
    what = "joint" if fault.kind.is_of_joint else "link"
    keys = ["limits", what] if fault.kind is FaultKind.NO_RANGE else [what]
    found = [said.of_parts.get((robot.variable, key, fault.part)) for key in keys]
    of_part = next((each for each in found if each is not None), None)
    statement = _lost_hold(fault, robot, said) or of_part or _cause(fault, robot, said)
    if statement is None:
        return robot.span, None
    slot = _SLOTS.get(fault.kind, what)
    of: Any = statement
    if getattr(of, slot, None) is not None:
        return statement.span_of(slot), statement
    word = "joint" if hasattr(of, "joint") else "link"
    return statement.span_of(word), statement


def _lost_hold(fault: Fault, robot: Robot, said: _Said) -> Statement | None:
    """Return the statement about the joint of a file that held what nothing holds any more."""
    if fault.kind is FaultKind.LOOSE and robot.source is not None:
        for joint in robot.source.description.joints.values():
            if joint.child == fault.part:
                return said.of_parts.get((robot.variable, "joint", joint.name))
    return None


def _cause(fault: Fault, robot: Robot, said: _Said) -> Statement | None:
    """Return the statement about another part that a fault comes from, if that is known."""
    others = [*_others(fault, robot, said)]
    return others[-1] if others else said.last.get(robot.variable)


def _others(fault: Fault, robot: Robot, said: _Said) -> Iterator[Statement]:
    """Yield the statements about the joints that a fault is about besides."""
    if fault.kind.is_of_joint:
        for name in fault.others:
            found = said.of_parts.get((robot.variable, "joint", name))
            if found is not None:
                yield found


def _with_root(link: str, robot: Robot, span: Span) -> Fix:
    """Return the remedy that gives a robot an empty root.

    Args:
        link: the root so far.
        robot: the robot.
        span: the statement that makes or changes that link, or the end of the one that loads it.
    """
    names = robot.shown
    root = next(each for each in numbered("root") if each not in names.links)
    joint = next(each for each in numbered("root_joint") if each not in names.joints)
    variable = robot.variable
    before = f"{variable} has_link '{root}'\n"
    after = f"\n{variable} has_joint '{joint}' of joint_type fixed from '{root}' to '{link}'"
    title = "let an empty link be the root"
    if span.start == span.end:
        return Fix(title, (Edit(span, f"\n{before.rstrip()}{after}"),))
    edits = Edit(Span(span.start, span.start), before), Edit(Span(span.end, span.end), after)
    return Fix(title, edits)
