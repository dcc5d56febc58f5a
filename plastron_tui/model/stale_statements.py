"""Statements that come too late to reach a file."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import cache
from typing import Any, NamedTuple

from plastron_tui.diagnostics import Diagnostic, Edit, Fix, Label, Span, codes
from plastron_tui.language import DECLARATIONS, SlotKind, Statement
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
        generation = _generation(statement, named, last) if named.nodes else None
        if generation is None:
            continue
        variable = generation.node.variable
        messages = [workspace.messages[getattr(statement, name)] for name in named.messages]
        fix = None
        if all(message.span.start < generation.span.start for message in messages):
            fix = _moved(statement, generation.span.start, "write it before that")
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
    if not (packages or launches or robots):
        return
    found: list[tuple[Statement, Span, Diagnostic]] = []
    for statement in program.statements:
        type_: Any = type(statement)  # which mypy takes for not hashable
        declaration = DECLARATIONS[type_]
        for slot in () if declaration.writes_file else declaration.slots:
            verb, last = written.get(slot.kind, ("", {}))
            variable = getattr(statement, slot.name) if last else ""
            where = last.get(variable)
            if where is not None and where.start <= statement.span.start:
                late = Diagnostic(
                    codes.CHANGED_AFTER_GENERATING,
                    f"this comes after `{variable}` was generated, and is not in its files",
                    statement.span,
                    help=f"write it before `{verb} {variable}`",
                    labels=(Label(where, "generated here"),),
                )
                found.append((statement, where, late))
    # What comes late may need what comes late before it: they stay, and are generated after all.
    last_of = {where: statement for statement, where, _ in found}
    writing = {each.span: each for each in program.statements if each.span in last_of}
    for _, where, late in found:
        end, moved = last_of[where].span.end, writing.get(where)
        fix = None if moved is None else _moved(moved, end, "generate after all of that")
        yield late._replace(fix=fix)


def _generation(
    statement: Statement, named: _Named, last: Mapping[str, Generation]
) -> Generation | None:
    """Return the last time that a node was written before a statement changes it."""
    for name in named.nodes:
        generation = last.get(getattr(statement, name))
        if generation is not None and generation.span.start <= statement.span.start:
            return generation
    return None


def _moved(statement: Statement, to: int, title: str) -> Fix | None:
    """Return the remedy that writes a statement where another one begins, or ends."""
    if statement.syntax.text is None:
        return None
    text = statement.syntax.text.decode("utf-8", "replace").strip()
    text = f"{text}\n" if to <= statement.span.start else f"\n{text}"
    return Fix(title, (Edit(Span(to, to), text), Edit(statement.span, "")))
