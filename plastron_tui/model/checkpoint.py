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
from .run import Run
from .type_agreement import Agreements
from .value_check import Fitted, Fitter
from .workspace import Generation, Node

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


class _Ground(NamedTuple):
    """What else than statements counted for what they mean."""

    library: str
    libraries: Libraries
    is_chosen: bool
    program: str


class Checkpoint(NamedTuple):
    """What the first statements of a program have built. Nobody changes it.

    Attributes:
        statements: those that were run.
        ground: what they were run with.
        catalogs: the interface types that they asked for, by generation of ROS.
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
    ground: _Ground
    catalogs: Mapping[int, Catalog]
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
    """

    statements: tuple[Statement, ...] = ()
    fitters: Mapping[int, Fitter] = {}
    checkpoint: Checkpoint | None = None
    clean: int = 0


NOTHING = Learnt()


def is_clean(run: Run) -> bool:
    """Tell whether what was run so far means the same whatever follows."""
    return not run.consequences.is_used and run.messages.are_sure


def resume(run: Run, earlier: Learnt, statements: Sequence[Statement]) -> tuple[int, int]:
    """Go on where an earlier run of nearly the same statements can be gone on with.

    Args:
        run: has run nothing yet.
        earlier: what the earlier run has left.
        statements: those that are to be run.

    Returns:
        How many statements are done with, and before how many a checkpoint is to be taken; 0 for
        none.
    """
    same = _common(earlier.statements, statements)
    start, known = 0, earlier.checkpoint
    if known is not None and len(known.statements) <= same and _holds(known, run.setting):
        start = len(known.statements)
        _restore(run, known, statements[start:])
    most = min(same - _BEFORE, earlier.clean)
    mark = start + _of_nodes(statements[start:most]) if most >= start + _LEAST else 0
    return start, mark if mark >= start + _LEAST else 0


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
        _ground(run.setting),
        run.types.catalogs,
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


def _holds(known: Checkpoint, setting: Setting) -> bool:
    """Tell whether statements mean the same in a setting as at a checkpoint."""
    catalogs = known.catalogs.items()
    return known.ground == _ground(setting) and all(
        setting.catalog(version) is catalog for version, catalog in catalogs
    )


def _ground(setting: Setting) -> _Ground:
    return _Ground(setting.library, setting.libraries, setting.is_chosen, setting.program)


def _of_nodes(statements: Sequence[Statement]) -> int:
    """Return how many of the first statements are about nodes and messages alone."""
    if _OF_NODES.issuperset(map(type, statements)):
        return len(statements)
    return next(at for at, each in enumerate(statements) if type(each) not in _OF_NODES)


def _common(earlier: Sequence[Statement], statements: Sequence[Statement]) -> int:
    """Return how many statements, from the first on, are the same objects."""
    are_same = [*map(is_, earlier, statements)]
    return are_same.index(False) if False in are_same else len(are_same)
