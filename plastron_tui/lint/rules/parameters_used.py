"""Parameters that nodes use and never declare."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from pathlib import Path

from plastron_tui.diagnostics import Code, Diagnostic, Severity, Span
from plastron_tui.diagnostics.suggest import nearest
from plastron_tui.lint.made_nodes import facts_of
from plastron_tui.lint.rule import rule
from plastron_tui.lint.tree import SourceTree
from plastron_tui.model.code_facts import ParameterAccess, ParameterUse
from plastron_tui.ros.name_slips import is_slip

from .parameters_examples import UNDECLARED, node
from .parameters_given import is_of_every_node, receivers_of

_OUTCOMES = {
    ParameterAccess.GET: "ROS 2 refuses it",
    ParameterAccess.SET: "ROS 2 refuses it",
    ParameterAccess.READ: "the variable stays as it is",
    ParameterAccess.GET_OR: "the other value is what it always gives",
}


@rule(
    "RP304",
    "undeclared-parameter",
    "A node of ROS 2 uses a parameter that it never declares.",
    why="ROS 2 refuses it: rclpy raises `ParameterNotDeclaredException`, rclcpp throws the same, "
    "and the node ends. `get_parameter_or`, and `get_parameter` with a variable to put it into, go "
    "on as if nobody had set it. It is told where all is read that may declare a parameter of the "
    "node, or where the node declares a name one slip from it that it never uses. What is asked "
    "for with `has_parameter` before, or in a `try`, is meant.",
    bad=UNDECLARED,
    good={"driver.py": node()},
)
def undeclared_parameter(tree: SourceTree, code: Code) -> Iterator[Diagnostic]:
    """Find parameters that are used and not declared."""
    receivers = receivers_of(tree)
    bases = {
        unit.file(use.file)
        for unit in tree.units
        for facts in unit.code.parameters
        for use in facts.uses
        if use.file and unit.is_python
    }
    for unit in tree.built:
        if unit.is_test or unit.path in bases:
            continue
        told: set[tuple[str, Span]] = set()
        for each in unit.nodes:
            facts = facts_of(unit, each)
            if receivers.may_have_more(unit, each, facts):
                continue
            for use, meant in _undeclared(facts.uses, is_whole=facts.is_own):
                if (use.file, use.span) not in told:
                    told.add((use.file, use.span))
                    yield _told(code, unit.file(use.file), use, meant)


def _undeclared(
    uses: Iterable[ParameterUse], *, is_whole: bool
) -> Iterator[tuple[ParameterUse, str | None]]:
    """Yield the uses of what is not declared, each with the declared name that was meant."""
    by: dict[ParameterAccess, set[str]] = {access: set() for access in ParameterAccess}
    for use in uses:
        if use.name is not None:
            by[use.access].add(use.name)
    declared, asked = by[ParameterAccess.DECLARE], by[ParameterAccess.HAS]
    used = set().union(*(by[access] for access in _OUTCOMES))
    for use in uses:
        name = use.name
        if use.access not in _OUTCOMES or name is None or is_of_every_node(name):
            continue
        if name in declared or name in asked:
            continue
        slip = next((each for each in sorted(declared - used) if is_slip(name, each)), None)
        if slip is not None or (is_whole and not use.is_guarded):
            yield use, slip or nearest(name, sorted(declared))


def _told(code: Code, file: Path, use: ParameterUse, meant: str | None) -> Diagnostic:
    refused = use.access in (ParameterAccess.GET, ParameterAccess.SET)
    return Diagnostic(
        code,
        f"the parameter `{use.name}` is used and never declared: {_OUTCOMES[use.access]}",
        use.span,
        file,
        help=f"declare `{use.name}`" if meant is None else f"did you mean `{meant}`?",
        severity=Severity.ERROR if refused else Severity.WARNING,
    )
