"""The interpreter: statements, from top to bottom, become a workspace.

A statement with a mistake has no effect, and gives one diagnostic for each; what merely follows
from a mistake gives none.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import partial
from typing import Any, NamedTuple

from plastron_tui.diagnostics import Diagnostic, has_errors
from plastron_tui.language import statements as st
from plastron_tui.language.declaration import Statement
from plastron_tui.language.lowering import Program
from plastron_tui.ros.interfaces import Interface, InterfaceKind, InterfaceName

from . import launch_statements, robot_statements
from .absent_packages import absent_packages
from .checkpoint import NOTHING, Learnt, is_clean, leave, start, take
from .circles import check_circles
from .context import Setting
from .kinds import EDITABLE, EndpointKind
from .launch_checks import check_launches
from .load_package import load_package
from .meetings import check_meetings
from .mistake import Mistake
from .node_statements import create_node, generate_node, load
from .other_things import decided
from .own_types import OwnInterfaces
from .package_statements import contains, create_package, generate_package, no_longer_contains
from .rename import rename
from .robot_checks import check_robots
from .robot_joint_names import check_joint_names
from .run import Run
from .stale_statements import late_changes, late_changes_of_parts
from .statement_checks import all_wrong
from .type_statements import (
    create_type,
    drop_type,
    generate_type,
    has_field,
    load_type,
    no_longer_has_field,
)
from .unconditional_motion import check_motion
from .workspace import Node, Workspace


class Interpretation(NamedTuple):
    """What a program means, and what is wrong with it.

    Attributes:
        workspace: what it builds.
        diagnostics: what is wrong with it.
        learnt: a help with the same program after an edit.
        own_types: its own interface types, by generation of ROS.
    """

    workspace: Workspace
    diagnostics: tuple[Diagnostic, ...]
    learnt: Learnt
    own_types: Mapping[int, OwnInterfaces] = {}


_STRETCH = 256
"""How many statements are run between two beats of the pulse: less than a millisecond of them."""


def interpret(
    program: Program,
    setting: Setting,
    earlier: Learnt | None = None,
    pulse: Callable[[], None] | None = None,
) -> Interpretation:
    """Run the statements of a program and return the workspace that they build.

    Args:
        program: the statements.
        setting: what they are interpreted in.
        earlier: what an interpretation of the program before it was edited has left.
        pulse: called now and then; what it raises ends the interpretation.
    """
    interpreter = Interpreter(setting, earlier or NOTHING)
    diagnostics = interpreter.run(program, pulse)
    diagnostics += tuple(
        absent_packages(program, interpreter.workspace, setting, interpreter.type_named)
    )
    # In a program with a mistake, the statement that generates may be the mistake.
    if not has_errors(diagnostics):
        workspace, version_of = interpreter.workspace, interpreter.version_of
        diagnostics += tuple(late_changes(program, workspace))
        diagnostics += tuple(check_meetings(program, workspace, version_of))
        diagnostics += tuple(check_circles(workspace, version_of))
        diagnostics += tuple(check_motion(workspace, version_of))
        diagnostics += tuple(late_changes_of_parts(program, workspace))
        diagnostics += tuple(check_launches(workspace, setting.ros_version, setting.libraries))
        diagnostics += tuple(check_robots(program, workspace))
        diagnostics += tuple(check_joint_names(program, workspace))
    workspace = interpreter.workspace
    own_types = {each: interpreter.own_types(each) for each in (1, 2)} if workspace.types else {}
    return Interpretation(workspace, diagnostics, interpreter.learnt, own_types)


def _stretches(start: int, mark: int, end: int) -> Iterator[tuple[int, int]]:
    """Yield from where to where statements are run at once; one of them begins at the mark."""
    for low, high in ((start, mark), (max(start, mark), end)):
        for first in range(low, high, _STRETCH):
            yield first, min(first + _STRETCH, high)


def _end(kind: EndpointKind, run: Run, statement: Statement) -> None:
    run.take(statement, kind)


HANDLERS: dict[type[Statement], Callable[[Run, Any], None]] = {
    st.CreateNode: create_node,
    st.Load: load,
    st.CreateMessage: lambda run, statement: run.messages.create(statement),
    st.GenerateNode: generate_node,
    st.Rename: rename,
    st.CreateMessageType: create_type,
    st.CreateServiceType: create_type,
    st.CreateActionType: create_type,
    st.LoadType: load_type,
    st.HasField: has_field,
    st.NoLongerHasField: no_longer_has_field,
    st.DropType: drop_type,
    st.GenerateType: generate_type,
    st.CreatePackage: create_package,
    st.LoadPackage: load_package,
    st.Contains: contains,
    st.NoLongerContains: no_longer_contains,
    st.GeneratePackage: generate_package,
    **launch_statements.HANDLERS,
    **robot_statements.HANDLERS,
    **{kind.editing.made_by: kind.editing.make for kind in EDITABLE},
    **{kind.editing.ended_by: partial(_end, kind) for kind in EDITABLE},
}
"""What each statement does."""


class Interpreter:
    """Runs programs, one after the other, in one workspace."""

    def __init__(self, setting: Setting, earlier: Learnt = NOTHING) -> None:
        """Start with an empty workspace; the arguments are those of `interpret`."""
        self._run = Run(setting, earlier.fitters)
        self._earlier = earlier
        self.learnt = NOTHING
        """What the last program leaves to the same one after an edit."""

    @property
    def workspace(self) -> Workspace:
        """What the programs have built."""
        return self._run.workspace

    def version_of(self, node: Node) -> int:
        """Return the generation of ROS that a node is for."""
        return self._run.checks.version_of(node)

    def type_named(self, text: str, kind: InterfaceKind, version: int) -> InterfaceName | None:
        """Return the full name of a type that a program names, None for what is none."""
        found = self._run.types.resolver(version).resolve(text, kind)
        return found.name if isinstance(found, Interface) else None

    def own_types(self, version: int) -> OwnInterfaces:
        """Return the program's own interface types in a generation of ROS."""
        return self._run.types.own_interfaces(version)

    def run(
        self, program: Program, pulse: Callable[[], None] | None = None
    ) -> tuple[Diagnostic, ...]:
        """Run the statements of a program, and return all that is wrong with it, in its order."""
        run, statements = self._run, program.statements
        run.begin(program)
        earlier, self._earlier = self._earlier, NOTHING
        done, mark, checkpoint, moved = start(run, earlier, statements)
        clean = len(statements)
        for first, last in _stretches(done, mark, len(statements)):
            if pulse is not None:
                pulse()
            if first == mark > done and is_clean(run):
                checkpoint = take(run, statements, first)
            self._run_all(statements[first:last])
            clean = clean if is_clean(run) else min(clean, first)
        self.learnt = moved or leave(run, statements, checkpoint, clean)
        found = run.found
        if program.diagnostics:
            found += [(0 if each.span is None else each.span.start, each)
                      for each in decided(self._run.workspace, program)]  # fmt: skip
            found.sort(key=lambda entry: entry[0])
        return tuple([each for _, each in found])

    def _run_all(self, statements: Sequence[Statement]) -> None:
        run = self._run
        for statement in statements:
            try:
                HANDLERS[type(statement)](run, statement)
            except Mistake as mistake:  # noqa: PERF203 - each statement has its own
                for found in all_wrong(run, statement, mistake):
                    run.report(statement, found)
                run.consequences.add(statement)
