"""Statements that come too late to reach a file."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import cache
from typing import Any, NamedTuple

from plastron_tui.diagnostics import Diagnostic, Edit, Fix, Label, Span, codes
from plastron_tui.language.declaration import DECLARATIONS, SlotKind, Statement
from plastron_tui.language.lowering import Program

from .workspace import Generation, Workspace


class _Named(NamedTuple):
    """The slots of a statement that name the nodes it changes, and the messages for that."""

    nodes: tuple[str, ...]
    messages: tuple[str, ...]


@cache
def _named(type_: type[Statement]) -> _Named:
    """Return what a statement names: one that makes a node, or writes it, changes none."""
    declaration = DECLARATIONS[type_]
    kinds = {slot.kind for slot in declaration.slots}
    if declaration.writes_file or SlotKind.NEW_NODE in kinds:
        return _Named((), ())
    nodes, messages = (
        tuple(slot.name for slot in declaration.slots if slot.kind is kind)
        for kind in (SlotKind.NODE, SlotKind.MESSAGE)
    )
    return _Named(nodes, messages)


def late_changes(program: Program, workspace: Workspace) -> Iterator[Diagnostic]:
    """Yield a warning for each statement that changes a node after it was last generated."""
    last: dict[str, Generation] = {
        generation.node.variable: generation for generation in workspace.generations
    }
    if not last:
        return
    for statement in program.statements:
        type_: Any = type(statement)  # which mypy takes for not hashable
        named = _named(type_)
        generation = _generation(statement, named, last)
        if generation is None:
            continue
        variable = generation.node.variable
        messages = [workspace.messages[getattr(statement, name)] for name in named.messages]
        fix = None
        if all(message.span.start < generation.span.start for message in messages):
            fix = _moved(statement, generation)
        yield Diagnostic(
            codes.CHANGED_AFTER_GENERATING,
            f"this comes after `{variable}` was generated, and is not in its file",
            statement.span,
            help=f"write it before `generate_node {variable}`",
            fix=fix,
            labels=(Label(generation.span, "generated here"),),
        )


def late_changes_of_parts(program: Program, workspace: Workspace) -> Iterator[Diagnostic]:
    """Yield a warning for each statement that changes a package, a launch file or a robot too late.

    What is in a package that is written is written as it is at the program's end, and so are
    types.
    """
    packages = {each.package.variable: each.span for each in workspace.written_packages}
    held = {variable for each in workspace.written_packages for variable in each.package.contents}
    launches = {
        each.launch.variable: each.span
        for each in workspace.written_launches
        if each.launch.variable not in held
    }
    robots = {
        each.robot.variable: each.span
        for each in workspace.written_robots
        if each.robot.variable not in held
    }
    written: dict[SlotKind, tuple[str, Mapping[str, Span]]] = {
        SlotKind.PACKAGE: ("generate_package", packages),
        SlotKind.LAUNCH: ("generate_launch", launches),
        SlotKind.ROBOT: ("generate_robot", robots),
    }
    for statement in program.statements if packages or launches or robots else ():
        type_: Any = type(statement)  # which mypy takes for not hashable
        declaration = DECLARATIONS[type_]
        for slot in () if declaration.writes_file else declaration.slots:
            verb, last = written.get(slot.kind, ("", {}))
            variable = getattr(statement, slot.name) if last else ""
            where = last.get(variable)
            if where is not None and where.start <= statement.span.start:
                yield Diagnostic(
                    codes.CHANGED_AFTER_GENERATING,
                    f"this comes after `{variable}` was generated, and is not in its files",
                    statement.span,
                    help=f"write it before `{verb} {variable}`",
                    labels=(Label(where, "generated here"),),
                )


def _generation(
    statement: Statement, named: _Named, last: Mapping[str, Generation]
) -> Generation | None:
    """Return the last time that a node was written before a statement changes it."""
    for name in named.nodes:
        generation = last.get(getattr(statement, name))
        if generation is not None and generation.span.start <= statement.span.start:
            return generation
    return None


def _moved(statement: Statement, generation: Generation) -> Fix | None:
    """Return the remedy that writes a statement before its node is generated."""
    text = statement.syntax.text
    if text is None:
        return None
    start = generation.span.start
    before = Edit(Span(start, start), text.decode("utf-8", "replace").strip() + "\n")
    return Fix("write it before that", (before, Edit(statement.span, "")))
