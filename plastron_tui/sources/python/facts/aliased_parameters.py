"""Calls of a node's method under another name: `declare = self.declare_parameter`."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from tree_sitter import Node

from plastron_tui.diagnostics import Span
from plastron_tui.model.code_facts import ParameterAccess, ParameterUse
from plastron_tui.sources.python.analysis import Analysis
from plastron_tui.sources.python.arguments import Arguments
from plastron_tui.sources.python.calls import Argument
from plastron_tui.sources.python.constants import Known
from plastron_tui.sources.python.evaluation import Evaluator
from plastron_tui.sources.python.scopes import Scope

_METHODS = {
    "declare_parameter": ParameterAccess.DECLARE,
    "get_parameter": ParameterAccess.GET,
}
_NAME, _VALUE = Argument(0, "name"), Argument(1, "value")


class Alias(NamedTuple):
    """A local name of a method of the node itself.

    Attributes:
        name: the name.
        method: the name of the method, in the tree.
        scope: the scope that has the name.
        owner: the class of the node.
        access: what the method does.
    """

    name: str
    method: Node
    scope: Scope
    owner: Scope
    access: ParameterAccess


def aliases(analysis: Analysis) -> Iterator[Alias]:
    """Yield the names that stand for nothing else."""
    for assignment in analysis.captures.get("assignment", []):
        left, right = (assignment.child_by_field_name(side) for side in ("left", "right"))
        if left is None or right is None or (left.type, right.type) != ("identifier", "attribute"):
            continue
        method = right.child_by_field_name("attribute")
        held = right.child_by_field_name("object")
        if method is None or held is None:
            continue
        access = _METHODS.get(analysis.syntax.slice(method))
        scope = analysis.scopes.at(assignment.start_byte)
        name = analysis.syntax.slice(left)
        is_self = scope.self_name != "" and analysis.syntax.slice(held) == scope.self_name
        if access is None or scope.parent is None or not is_self:
            continue
        if len(scope.bindings.get(name, ())) == 1:
            yield Alias(name, method, scope, scope.parent, access)


def aliased_uses(analysis: Analysis, owner: Scope) -> Iterator[ParameterUse]:
    """Yield what is declared and used under such names in a class and those it derives from."""
    family = (owner, *analysis.resolver.classes.bases(owner))
    evaluator = Evaluator(analysis)
    for alias in aliases(analysis):
        if alias.owner not in family:
            continue
        for call in analysis.resolver.calls_of(alias.name):
            callee = call.child_by_field_name("function")
            scope = analysis.scopes.at(call.start_byte)
            found = scope.lookup(alias.name)
            if callee is None or callee.type != "identifier" or found is None:
                continue
            if found[0] is alias.scope:
                yield _use(analysis, evaluator, alias, call, scope)


def _use(
    analysis: Analysis, evaluator: Evaluator, alias: Alias, call: Node, scope: Scope
) -> ParameterUse:
    arguments = Arguments.of(call, analysis.syntax)
    given, value = arguments.get(_NAME), arguments.get(_VALUE)
    folded = analysis.resolver.fold(given, scope) if given is not None else None
    name = folded.value if isinstance(folded, Known) else None
    worth = evaluator.evaluate(value, scope)
    is_typed = alias.access is ParameterAccess.DECLARE and not worth.is_guess
    place = call if given is None else given
    return ParameterUse(
        alias.access,
        name if isinstance(name, str) else None,
        Span(place.start_byte, place.end_byte),
        type=worth.type if is_typed and b"dynamic_typing" not in analysis.syntax.text else None,
    )
