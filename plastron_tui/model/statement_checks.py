"""All that is wrong with a statement that has a mistake.

The handler of a statement stops at the first mistake. The checks here look at its parts one by
one: each at a slot, and at what cannot be told without others. Whatever several of them find at
one place is one mistake.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from functools import partial
from typing import Any

from plastron_tui.diagnostics import Diagnostic, Span
from plastron_tui.language import DECLARATIONS, Statement
from plastron_tui.language import statements as st
from plastron_tui.ros.interfaces import Interface
from plastron_tui.ros.names import check_parameter_name, spelled

from .kinds import INTERFACES, MADE_BY, Message
from .kinds.parameter import default_of, range_of, type_of
from .kinds.publisher import check_sent, check_unsent
from .kinds.quality import qos_of
from .kinds.rate import check_rate, rate_of
from .kinds.reaction import reaction_of
from .kinds.timer import check_not_repeated
from .launch_statements import check_launch_named
from .mistake import Mistake
from .node_statements import check_managed, check_node_name, check_work
from .package_statements import (
    check_description,
    check_executable,
    check_item,
    check_license,
    check_maintainer,
    check_package_named,
    check_package_there,
)
from .rename import RENAMED, kinds_having, kinds_of
from .robot_statement_checks import CHECKS as ROBOT_CHECKS
from .run import Run
from .type_statements import check_fields, check_type_named

_Check = Callable[[Run, Any], object]


def all_wrong(run: Run, statement: Statement, mistake: Mistake) -> list[Diagnostic]:
    """Return what is wrong with a statement, each mistake once, in their order.

    Args:
        run: what the statement works on.
        statement: the statement.
        mistake: the one that its handler stopped at.
    """
    found: dict[Span | None, Diagnostic] = {each.span: each for each in mistake.diagnostics}
    for check in _CHECKS.get(type(statement), ()):
        for each in _mistakes(check, run, statement) or ():
            found.setdefault(each.span, each)
    return sorted(found.values(), key=lambda each: each.span or statement.span)


def _mistakes(check: Callable[..., object], *arguments: object) -> tuple[Diagnostic, ...] | None:
    """Return what a check finds, None where it finds nothing."""
    try:
        check(*arguments)
    except Mistake as mistake:
        return mistake.diagnostics
    return None


def _any_passes(checks: Iterable[Callable[[], object]]) -> None:
    """Raise what the first of some checks finds, unless one of them finds nothing."""
    first: tuple[Diagnostic, ...] | None = None
    for check in checks:
        found = _mistakes(check)
        if found is None:
            return
        first = found if first is None else first
    raise Mistake(*first or ())


def _versions(run: Run, statement: Any) -> tuple[int, ...]:
    """Return the generations of ROS that a statement may be for: any, if its node is not there."""
    node = run.workspace.nodes.get(statement.node)
    return _any_version(run) if node is None else (run.checks.version_of(node),)


def _any_version(run: Run) -> tuple[int, int]:
    default = run.checks.version(None)
    return default, 3 - default


def _variable(run: Run, statement: Any) -> None:
    run.checks.new_variable(statement, statement.variable)


def _library(run: Run, statement: st.CreateNode | st.GenerateNode) -> None:
    run.checks.library(statement)


def _node(run: Run, statement: Statement) -> None:
    run.checks.node(statement)


def _node_name(run: Run, statement: st.CreateNode) -> None:
    library = statement.library
    is_known = library is None or library in run.setting.libraries
    versions = (run.checks.version(library),) if is_known else _any_version(run)
    _any_passes(partial(check_node_name, run, statement, version) for version in versions)


def _managed(run: Run, statement: st.CreateNode) -> None:
    check_managed(run, statement, run.checks.library(statement) or run.setting.library)


def _qos(run: Run, statement: st.Publish | st.Subscribe) -> None:
    # What is only a warning is told where the statement is carried out.
    qos_of(run, statement, 2)


def _work(run: Run, statement: st.GenerateNode) -> None:
    check_work(run, statement, run.checks.node(statement))


def _created(run: Run, statement: st.CreateMessage) -> None:
    run.messages.made(statement)


def _name(run: Run, statement: Statement) -> None:
    slot = MADE_BY[type(statement)].editing.name_slot
    written = getattr(statement, slot)
    _any_passes(
        partial(run.checks.name, statement, slot, written, version)
        for version in _versions(run, statement)
    )


def _named_type(run: Run, statement: Any, version: int) -> Interface:
    slots = DECLARATIONS[type(statement)].slots
    kind = next(INTERFACES[slot.kind] for slot in slots if slot.kind in INTERFACES)
    return run.types.named(statement, statement.type, kind, version)


def _type(run: Run, statement: Statement) -> None:
    versions = _versions(run, statement)
    _any_passes(partial(_named_type, run, statement, version) for version in versions)


def _request(run: Run, statement: st.ClientRequests | st.SendsGoal) -> None:
    def check(version: int) -> None:
        run.types.fit(statement, _named_type(run, statement, version), version)

    _any_passes(partial(check, version) for version in _versions(run, statement))


def _agreement(run: Run, statement: Statement) -> None:
    """Check a type against what others mean by the name; what the node has already is no other."""
    node, kind = run.checks.node(statement), MADE_BY[type(statement)]
    _name(run, statement)
    name = spelled(getattr(statement, kind.editing.name_slot))
    if name not in node.by_kind[kind]:
        type_ = _named_type(run, statement, run.checks.version_of(node))
        run.check_agreement(statement, node, kind.editing.endpoint(name, type_.name))


def _message(run: Run, statement: st.Publish) -> Message:
    return run.messages.find(statement)


def _sent(run: Run, statement: st.Publish) -> None:
    message, is_there = _message(run, statement), statement.node in run.workspace.nodes

    def check(version: int) -> None:
        sent = run.messages.for_version(message, version) if is_there else message
        check_sent(statement, sent, _named_type(run, statement, version).name)

    _any_passes(partial(check, version) for version in _versions(run, statement))


def _unsent(run: Run, statement: st.Publish) -> None:
    node, message = run.checks.node(statement), _message(run, statement)
    message = run.messages.for_version(message, run.checks.version_of(node))
    reaction = reaction_of(run, statement, node)
    check_unsent(run, statement, node, message, None if reaction is None else reaction[0])


def _rate(run: Run, statement: st.Publish | st.Repeats | st.ClientRequests) -> None:
    if isinstance(statement.rate, (int, float)):
        check_rate(statement, statement.rate)
    else:
        rate_of(run, statement, run.checks.node(statement))


def _trigger(run: Run, statement: st.Publish) -> None:
    reaction_of(run, statement, run.checks.node(statement))


def _parameter_name(run: Run, statement: st.HasParameter) -> None:
    name, check = statement.parameter, check_parameter_name
    _any_passes(
        partial(run.checks.name, statement, "parameter", name, version, check)
        for version in _versions(run, statement)
    )


def _parameter_type(_: Run, statement: st.HasParameter) -> None:
    type_of(statement)


def _default(_: Run, statement: st.HasParameter) -> None:
    type_ = type_of(statement)
    range_of(statement, type_, default_of(statement, type_))


def _answer(run: Run, statement: st.ProvidesService) -> None:
    def check(version: int) -> None:
        run.types.fit(statement, _named_type(run, statement, version), version, "answer")

    if statement.answer is not None:
        _any_passes(partial(check, version) for version in _versions(run, statement))


def _absent(run: Run, statement: Statement) -> None:
    run.checks.absent(statement, run.checks.node(statement))


def _not_repeated(run: Run, statement: st.Repeats) -> None:
    check_not_repeated(run, statement, run.checks.node(statement))


def _called(run: Run, statement: Any) -> None:
    run.checks.function(statement, run.checks.node(statement))


def _answering(run: Run, statement: st.ProvidesService | st.ProvidesAction) -> None:
    """Check a function that answers: also against what it answers for others of the kind."""
    _called(run, statement)
    node = run.checks.node(statement)
    type_ = _named_type(run, statement, run.checks.version_of(node))
    run.checks.function(statement, node, type_.name)


def _function(run: Run, statement: Any) -> None:
    run.checks.function_name(statement, run.workspace.nodes.get(statement.node))


def _renamed(_: Run, statement: st.Rename) -> None:
    kinds_of(statement)


def _old(run: Run, statement: st.Rename) -> None:
    kinds_having(run, statement, run.checks.node(statement), kinds_of(statement))


def _new(run: Run, statement: st.Rename) -> None:
    meant = RENAMED.get(statement.what)
    # A name that no kind of thing may have is wrong whatever is meant.
    kinds = [each[0] for each in RENAMED.values()] if meant is None else meant[:1]
    _any_passes(
        partial(run.checks.name, statement, "new", statement.new, version, kind.facts.check_name)
        for kind in kinds
        for version in _versions(run, statement)
    )


_CHECKS: dict[type[Statement], tuple[_Check, ...]] = {
    st.CreateNode: (_node_name, _variable, _library, _managed),
    st.Load: (_variable,),
    st.CreateMessage: (_variable, _created),
    st.Publish: (_node, _message, _name, _unsent, _type, _sent, _agreement, _rate, _trigger, _qos),
    st.Subscribe: (_node, _name, _absent, _type, _agreement, _qos, _function, _called),
    st.ProvidesService: (
        *(_node, _name, _absent, _type, _agreement, _answer, _function, _answering),
    ),
    st.ClientRequests: (_node, _name, _type, _agreement, _request, _rate),
    st.ProvidesAction: (_node, _name, _absent, _type, _agreement, _function, _answering),
    st.SendsGoal: (_node, _name, _type, _agreement, _request),
    st.Repeats: (_node, _not_repeated, _function, _called, _rate),
    st.HasParameter: (_node, _parameter_name, _absent, _parameter_type, _default),
    st.Rename: (_node, _renamed, _old, _new),
    st.GenerateNode: (_node, _work, _library),
    **dict.fromkeys(
        (st.CreateMessageType, st.CreateServiceType, st.CreateActionType),
        (check_type_named, check_fields),
    ),
    st.LoadType: (_variable,),
    st.CreatePackage: (
        *(_variable, check_package_named, check_description, check_maintainer, check_license),
    ),
    st.LoadPackage: (_variable,),
    st.Contains: (check_package_there, check_item, check_executable),
    st.CreateLaunch: (_variable, check_launch_named),
    st.LoadLaunch: (_variable,),
    **ROBOT_CHECKS,
}
"""What is looked at in each statement that may have several mistakes.

Of two mistakes at one place the one of the earlier check is told."""
