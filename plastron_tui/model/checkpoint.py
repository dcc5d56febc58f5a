"""Going on in the middle of a program that was interpreted before, and was edited since.

What stands before an edit means what it meant: a checkpoint keeps what those statements have
built, and only the others are run anew. There is one checkpoint, just before the last edit, for
the next edit is likely to be there too.

Statements before a checkpoint are such that nothing behind them has a part in what they mean:
they make and change nodes and messages, and none of them has a mistake.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from operator import is_
from typing import NamedTuple

from plastron_tui.diagnostics import Diagnostic, Span
from plastron_tui.language import statements as st
from plastron_tui.language.declaration import Statement
from plastron_tui.ros.catalog import Catalog

from .context import Setting
from .kinds import EDITABLE, Message
from .libraries import Libraries
from .messages import MessageHistory
from .moved_workspace import are_moved, move
from .run import Run
from .type_agreement import Agreements
from .value_check import Fitted, Fitter
from .workspace import Generation, Node, Workspace

_BEFORE = 20
"""How many statements a checkpoint is before an edit: the next edit may be some lines above."""

_LEAST = 200
"""How many statements a new checkpoint has to spare: fewer are run in less than a millisecond."""

_OF_NODES: frozenset[type[Statement]] = frozenset(
    {
        *(st.CreateNode, st.CreateMessage, st.GenerateNode, st.Rename),
        *(kind.editing.made_by for kind in EDITABLE),
        *(kind.editing.ended_by for kind in EDITABLE),
    }
)
"""The statements that may be before a checkpoint: others read files, or change several things."""


class Ground(NamedTuple):
    """What else than statements counted for what they mean.

    Attributes:
        library: the client library of a node that names none.
        libraries: the client libraries that there are.
        is_chosen: whether somebody chose `library`.
        program: the name of the program's file without its ending.
        catalogs: the interface types that were asked for, by generation of ROS.
    """

    library: str
    libraries: Libraries
    is_chosen: bool
    program: str
    catalogs: Mapping[int, Catalog]

    def holds(self, setting: Setting) -> bool:
        """Tell whether statements mean the same in a setting."""
        now = _ground(setting, self.catalogs)
        catalogs = self.catalogs.items()
        return self == now and all(setting.catalog(version) is each for version, each in catalogs)


class Checkpoint(NamedTuple):
    """What the first statements of a program have built. Nobody changes it.

    Attributes:
        statements: those that were run.
        ground: what they were run with.
        nodes: the nodes, by variable.
        messages: the messages, by variable.
        generations: the nodes that are written.
        node_names: the names of the nodes, and where each was given.
        history: how the messages were made.
        agreements: who uses which type for a topic or a service.
        fitted: the values of the statements, by generation of ROS.
        found: the warnings.
    """

    statements: tuple[Statement, ...]
    ground: Ground
    nodes: Mapping[str, Node]
    messages: Mapping[str, Message]
    generations: tuple[Generation, ...]
    node_names: Mapping[str, Span]
    history: MessageHistory
    agreements: Agreements
    fitted: Mapping[int, Mapping[int, Fitted]]
    found: tuple[tuple[int, Diagnostic], ...]


class Learnt(NamedTuple):
    """What an interpretation leaves to that of the same program after an edit.

    Attributes:
        statements: those that were run.
        fitters: what knows their values, by generation of ROS.
        checkpoint: where one can go on.
        clean: how many of them have no mistake before them.
        workspace: what they have built, if nothing is wrong with any of them, and all are about
            nodes and messages.
        ground: what they were run with, in that case.
    """

    statements: tuple[Statement, ...] = ()
    fitters: Mapping[int, Fitter] = {}
    checkpoint: Checkpoint | None = None
    clean: int = 0
    workspace: Workspace | None = None
    ground: Ground | None = None


NOTHING = Learnt()


class Start(NamedTuple):
    """How a run begins.

    Attributes:
        done: how many statements are done with.
        mark: before how many a checkpoint is to be taken; 0 for none.
        checkpoint: the one that the run goes on from; None for none.
        moved: what is left where all have only moved, and nothing is to be run.
    """

    done: int
    mark: int
    checkpoint: Checkpoint | None
    moved: Learnt | None = None


def is_clean(run: Run) -> bool:
    """Tell whether what was run so far means the same whatever follows."""
    # What is wrong with a definition is told once more only when it is asked for again.
    is_fine = not any(each.problems for each in run.types.catalogs.values())
    return is_fine and not run.consequences.is_used and run.messages.are_sure


def start(run: Run, earlier: Learnt, statements: tuple[Statement, ...]) -> Start:
    """Begin a run where an earlier one of nearly the same statements can be gone on with.

    Args:
        run: has run nothing yet.
        earlier: what the earlier run has left.
        statements: those that are to be run.
    """
    same = _common(earlier.statements, statements)
    known = earlier.checkpoint
    if known is not None and (len(known.statements) > same or not known.ground.holds(run.setting)):
        known = None
    done = 0 if known is None else len(known.statements)
    most = min(same - _BEFORE, earlier.clean)
    mark = done + _of_nodes(statements[done:most]) if most >= done + _LEAST else 0
    mark = mark if mark >= done + _LEAST else 0
    if not mark and earlier.workspace is not None and _are_moved(run, earlier, statements, same):
        before = {} if known is None else known.nodes
        run.workspace = move(earlier.workspace, earlier.statements, statements, same, before)
        moved = earlier._replace(statements=statements, checkpoint=known, workspace=run.workspace)
        return Start(len(statements), 0, known, moved)
    if known is not None:
        _restore(run, known, statements[done:])
    return Start(done, mark, known)


def leave(
    run: Run, statements: tuple[Statement, ...], checkpoint: Checkpoint | None, clean: int
) -> Learnt:
    """Return what a run leaves; the arguments are what `Learnt` has."""
    learnt = Learnt(statements, run.types.fitters, checkpoint, clean)
    if clean < len(statements) or run.found or _of_nodes(statements) < len(statements):
        return learnt
    ground = _ground(run.setting, run.types.catalogs)
    return learnt._replace(workspace=run.workspace, ground=ground)


def _are_moved(run: Run, earlier: Learnt, statements: tuple[Statement, ...], same: int) -> bool:
    """Tell whether nothing happens but that statements about nodes and messages have moved."""
    return (
        earlier.ground is not None
        and are_moved(earlier.statements, statements, same)
        and earlier.ground.holds(run.setting)
    )


def take(run: Run, statements: Sequence[Statement], count: int) -> Checkpoint:
    """Take a checkpoint of a run that is clean.

    Args:
        run: what has run so far.
        statements: those of its program.
        count: how many of them it has run.
    """
    known = run.workspace
    checkpoint = Checkpoint(
        tuple(statements[:count]),
        _ground(run.setting, run.types.catalogs),
        dict(known.nodes),
        dict(known.messages),
        tuple(known.generations),
        dict(run.node_names),
        run.messages.history,
        run.agreements.fork(),
        {version: fitter.fitted for version, fitter in run.types.fitters.items()},
        tuple(run.found),
    )
    _share(run, statements[count:])
    return checkpoint


def _restore(run: Run, known: Checkpoint, rest: Sequence[Statement]) -> None:
    workspace = run.workspace
    workspace.nodes.update(known.nodes)
    workspace.messages.update(known.messages)
    workspace.generations.extend(known.generations)
    run.node_names.update(known.node_names)
    run.messages.resume(known.history)
    run.agreements = known.agreements.fork()
    for version, fitted in known.fitted.items():
        run.types.resolver(version)
        run.types.fitters[version].resume(fitted)
    run.found += known.found
    _share(run, rest)


def _share(run: Run, rest: Sequence[Statement]) -> None:
    """Let the nodes that there are be the checkpoint's, and those that change be copies."""
    run.checks.share()
    if _of_nodes(rest) < len(rest):
        # What is said of packages and types may change any node.
        run.checks.own_all()


def _ground(setting: Setting, catalogs: Mapping[int, Catalog]) -> Ground:
    library, libraries = setting.library, setting.libraries
    return Ground(library, libraries, setting.is_chosen, setting.program, catalogs)


def _of_nodes(statements: Sequence[Statement]) -> int:
    """Return how many of the first statements are about nodes and messages alone."""
    if _OF_NODES.issuperset(map(type, statements)):
        return len(statements)
    return next(at for at, each in enumerate(statements) if type(each) not in _OF_NODES)


def _common(earlier: Sequence[Statement], statements: Sequence[Statement]) -> int:
    """Return how many statements, from the first on, are the same objects."""
    are_same = [*map(is_, earlier, statements)]
    return are_same.index(False) if False in are_same else len(are_same)
