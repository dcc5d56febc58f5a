"""What a program means at one moment: the data that the panels show.

It is made by a worker from a snapshot of the session, part by part as panels ask for it, and is
read by everybody afterwards.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Callable, Hashable, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import TypeVar, cast

from plastron_tui.diagnostics import Diagnostic
from plastron_tui.language import Program
from plastron_tui.model.graph import Graph, graph_of
from plastron_tui.model.workspace import Workspace
from plastron_tui.project.loaded_problems import loaded_problems
from plastron_tui.session import Session

from .insertion_point import Ground

_T = TypeVar("_T")

_ABOUT = ("node", "package", "launch", "robot", "variable", "type")
"""The slots that name what a statement is about."""


class PartMemo:
    """What was made of parts of a program, for the next analysis, which has most of them too.

    What that one does not ask for is forgotten.
    """

    def __init__(self, earlier: PartMemo | None = None) -> None:
        # One that was not asked for everything has kept what the one before it has.
        self._earlier: dict[Hashable, object] = (
            {} if earlier is None else {**earlier._earlier, **earlier._made}
        )
        self._made: dict[Hashable, object] = {}

    def once(self, key: Hashable, make: Callable[[], _T]) -> _T:
        """Return what is made for a key, which says all that it follows from."""
        if key not in self._made:
            self._made[key] = self._earlier[key] if key in self._earlier else make()
        return cast("_T", self._made[key])

    def swap(self, key: Hashable, now: _T) -> _T | None:
        """Keep something for the next analysis; return what the one before has kept."""
        self._made[key] = now
        return cast("_T | None", self._earlier.get(key))

    def forget(self) -> None:
        """Forget what the one before has kept, now that all is made."""
        self._earlier = {}


@dataclass(repr=False)
class Analysis:
    """What follows from a text.

    Attributes:
        session: the snapshot that it was made from; only the worker asks it anything.
        text: the program.
        program: its statements.
        workspace: what it builds.
        diagnostics: what is wrong with it.
        in_files: what breaks a rule of the linter in the files that it loads.
        counts: how much is in each panel, by the panel's name.
        made: what was made of it for the panels, by what was asked for.
        memo: what was made for the panels of parts of it; only the worker asks.
    """

    session: Session
    text: bytes
    program: Program
    workspace: Workspace
    diagnostics: tuple[Diagnostic, ...]
    in_files: tuple[Diagnostic, ...] = ()
    counts: Mapping[str, int] = field(default_factory=dict)
    made: dict[Hashable, object] = field(default_factory=dict)
    memo: PartMemo = field(default_factory=PartMemo)

    @cached_property
    def graph(self) -> Graph:
        """Who meets whom; only the worker asks, for the panels that show it."""
        return graph_of(self.workspace)

    @property
    def ground(self) -> Ground:
        """What statements that are written for somebody go into."""
        return Ground(self.session.document, self.program, self.workspace)

    def once(self, key: Hashable, make: Callable[[], _T]) -> _T:
        """Return what is made of it for a key; made when it is first asked for, by the worker."""
        if key not in self.made:
            self.made[key] = make()
        return cast("_T", self.made[key])

    def robot_at(self, offset: int) -> str | None:
        """Return the variable of the robot that the statement on an offset's line is about."""
        named = self._named_at(offset)
        return next((name for name in named if name in self.workspace.robots), None)

    def written_at(self, offset: int) -> str | None:
        """Return what the statement on an offset's line is about, of all that becomes files."""
        known = self.workspace
        kinds = (known.nodes, known.packages, known.launches, known.robots, known.types)
        named = self._named_at(offset)
        return next((name for name in named if any(name in each for each in kinds)), None)

    def _named_at(self, offset: int) -> tuple[str, ...]:
        """Return the names in a statement that may be what it is about, those first that count."""
        statements = self.program.statements
        end = self.text.find(b"\n", offset)
        end = len(self.text) if end < 0 else end
        index = bisect_right(statements, end, key=lambda statement: statement.span.start) - 1
        if index < 0 or self.text.find(b"\n", statements[index].span.start, offset) >= 0:
            return ()
        found = (getattr(statements[index], slot, None) for slot in _ABOUT)
        return tuple(name for name in found if isinstance(name, str))


def analyse(session: Session, check: Callable[[], None]) -> Analysis:
    """Find out what a program means.

    `check` is called now and then, and raises something when there is a newer text.
    """
    program = session.program
    check()
    session.interpret(check)
    workspace = session.workspace
    diagnostics = session.diagnostics
    check()
    in_files = loaded_problems(session)
    check()
    return Analysis(session, session.document.text, program, workspace, diagnostics, in_files)
