"""Where a statement goes that is written for somebody: where it takes effect."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, NamedTuple

from plastron_tui.diagnostics import Edit, Span
from plastron_tui.language import DECLARATIONS, SlotKind, Statement
from plastron_tui.language.incremental_lowering import Lowered, lower_edited

if TYPE_CHECKING:
    from plastron_tui.language import Document, Program
    from plastron_tui.model.workspace import Workspace


_NAMING = frozenset(
    {
        *(SlotKind.NODE, SlotKind.MESSAGE, SlotKind.PACKAGE, SlotKind.LAUNCH, SlotKind.OWN_TYPE),
        SlotKind.ROBOT,
        *(SlotKind.ITEM, SlotKind.HELD, SlotKind.STARTED),
        *(SlotKind.MESSAGE_TYPE, SlotKind.SERVICE_TYPE, SlotKind.ACTION_TYPE),
    }
)
"""The slots that name something which a statement makes."""

_CHANGED = frozenset(
    {SlotKind.NODE, SlotKind.PACKAGE, SlotKind.LAUNCH, SlotKind.ROBOT, SlotKind.OWN_TYPE}
)
"""The slots that name what a statement is about."""


class Ground(NamedTuple):
    """A program: its text, its statements, and what it builds."""

    document: Document
    program: Program
    workspace: Workspace


@dataclass(frozen=True, slots=True)
class Placing:
    """Statements, and where they go.

    Attributes:
        lines: the statements, with those that the place asks for.
        edit: what writes them into the program.
        spans: where each of them stands then.
    """

    lines: tuple[str, ...]
    edit: Edit
    spans: tuple[Span, ...]


def placed(
    ground: Ground,
    variable: str | None,
    lines: Sequence[str],
    *,
    late: Sequence[str] = (),
    after: Span | None = None,
    is_apart: bool = False,
) -> Placing:
    """Return where statements take effect.

    They go before the line on which their node is generated last, or below the last one about a
    robot that is not written, unless that is no place for statements or something that they name
    is made further down; and else to the end.

    Args:
        ground: the program.
        variable: the node, the robot and so on that they change; None puts them at the end.
        lines: the statements.
        late: more of them, for the end alone.
        after: what they have to follow.
        is_apart: whether at the end an empty line comes before them.
    """
    text = ground.document.text
    made = _written_at(ground.workspace, variable)
    if made is not None and (after is None or after.end <= made.start):
        line = text.rfind(b"\n", 0, made.start) + 1
        placing = _placing(lines, line, line, b"", b"\n")
        if _takes_effect(ground, placing):
            return placing
    all_lines = (*lines, *late)
    end = len(text.rstrip())
    below = _end_of_robot(ground, variable) if made is None else end
    if below < end and (after is None or after.end <= below):
        placing = _placing(all_lines, below, below, b"\n", b"")
        if _takes_effect(ground, placing):
            return placing
    if not end:
        return _placing(all_lines, 0, len(text), b"", b"\n")
    behind = b"" if text[end:].startswith((b"\n", b"\r\n")) else b"\n"
    return _placing(all_lines, end, end, b"\n\n" if is_apart else b"\n", behind)


def _written_at(workspace: Workspace, variable: str | None) -> Span | None:
    """Return the first statement of those that write last what changes along with a variable.

    They are those of a node itself, and of the packages that contain it.
    """
    last: dict[object, Span] = {}
    for node in workspace.generations:
        if node.node.variable == variable:
            last["node"] = node.span
    for written in workspace.written_packages:
        package = written.package
        if variable == package.variable or variable in package.contents:
            last["package", package.variable] = written.span
    for launch in workspace.written_launches:
        if launch.launch.variable == variable:
            last["launch"] = launch.span
    for robot in workspace.written_robots:
        if robot.robot.variable == variable:
            last["robot"] = robot.span
    return min(last.values(), default=None, key=lambda span: span.start)


def _end_of_robot(ground: Ground, variable: str | None) -> int:
    """Return where the line of the last statement about a robot ends; of what is none, the end."""
    text, robot = ground.document.text, ground.workspace.robots.get(variable or "")
    if robot is None:
        return len(text)
    about = (x.span for x in ground.program.statements if names_node(x, robot.variable))
    end = text.find(b"\n", max(each.end for each in (robot.span, *about)))
    return len(text) if end < 0 else end


def _placing(lines: Sequence[str], start: int, end: int, before: bytes, behind: bytes) -> Placing:
    written = [_encoded(line) for line in lines]
    spans = []
    at = start + len(before)
    for line in written:
        spans.append(Span(at, at + len(line)))
        at += len(line) + 1
    new = before + b"\n".join(written) + behind
    edit = Edit(Span(start, end), new.decode("utf-8", "surrogatepass"))
    return Placing(tuple(lines), edit, tuple(spans))


def _takes_effect(ground: Ground, placing: Placing) -> bool:
    """Tell whether statements are statements where they are put, and name nothing made later."""
    start, end = placing.edit.span
    document = ground.document.snapshot()
    document.edit(start, end, _encoded(placing.edit.text))
    program = lower_edited(document, Lowered(ground.document.text, ground.program))
    there = {each.span: each for each in program.statements if each.span in placing.spans}
    if len(there) < len(placing.spans):
        return False
    workspace = ground.workspace
    named = {name for each in there.values() for name in _named(each)}
    made = (found for name in named if (found := workspace.what(name)) is not None)
    return all(span.start < start for _, span in made)


def _named(statement: Statement) -> Iterator[str]:
    """Yield the variables that a statement needs to be there."""
    type_: Any = type(statement)  # which mypy takes for not hashable
    for slot in DECLARATIONS[type_].slots:
        if slot.kind in _NAMING:
            name = getattr(statement, slot.name)
            if name is not None:
                yield name


def _encoded(text: str) -> bytes:
    return text.encode("utf-8", "surrogatepass")


def is_generated_last(program: Program, workspace: Workspace, variable: str) -> Span | None:
    """Return the statement that writes something, if nothing changes that further down."""
    spans = [made.span for made in workspace.generations if made.node.variable == variable]
    spans += [each.span for each in workspace.written_packages if each.package.variable == variable]
    spans += [each.span for each in workspace.written_launches if each.launch.variable == variable]
    spans += [each.span for each in workspace.written_robots if each.robot.variable == variable]
    spans += [span for name, span in workspace.written_types.items() if name == variable]
    if not spans:
        return None
    end = spans[-1].end
    later = (statement for statement in program.statements if statement.span.start >= end)
    return None if any(names_node(each, variable) for each in later) else spans[-1]


def names_node(statement: Statement, variable: str) -> bool:
    """Tell whether a statement is about a node, a package, a launch file, a robot or a type."""
    type_: Any = type(statement)  # which mypy takes for not hashable
    return any(
        slot.kind in _CHANGED and getattr(statement, slot.name) == variable
        for slot in DECLARATIONS[type_].slots
    )
