"""The calls of a function, and the turns of a loop, in which one call creates several endpoints."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from tree_sitter import Node

from .arguments import Call
from .scopes import Function, Scope, Variable
from .value import Value

if TYPE_CHECKING:
    from .analysis import Analysis
    from .found import Found

MOST_WORLDS = 64
_MOST_DEEP = 3
Bindings = tuple[tuple[Function, Call], ...]


def worlds(analysis: Analysis, found: Found, name: Node | None) -> Iterator[Bindings]:
    """Yield the calls of the function around a call, each bound while it is looked at."""
    unit = analysis.unit
    scope = (found.options or found.call).scope
    turns = _turns(analysis, name, scope)
    if len(turns) > MOST_WORLDS:
        analysis.cut.add(found.call.node.id)
    for items in turns[:MOST_WORLDS]:
        unit.items = items
        chosen = list(_calls(analysis, scope, 0)) or [()]
        if len(chosen) > MOST_WORLDS:
            analysis.cut.add(found.call.node.id)
        for bindings in chosen[:MOST_WORLDS]:
            analysis.worlds_left -= 1
            if analysis.worlds_left < 0:
                analysis.cut.add(found.call.node.id)
                break
            unit.bindings = {function: (call, {}) for function, call in bindings}
            yield bindings
            unit.bindings = {}
        unit.items = {}


def _turns(analysis: Analysis, name: Node | None, scope: Scope) -> list[dict[Variable, Value]]:
    """Return the values of the variable of the loop around a call, one for each turn."""
    for each in scope.chain:
        if each.kind in ("function", "lambda"):
            break
        if each.node.type == "for_statement" and name is not None:
            counted = _counted(analysis, each)
            if counted:
                return counted
        for variables in each.variables.values():
            for variable in variables:
                if variable.kind != "loop" or name is None:
                    continue
                listed = analysis.evaluator.fold(variable.value, variable.scope)
                if listed is not None and isinstance(listed.value, tuple):
                    few = listed.value[: MOST_WORLDS + 1]
                    return [{variable: Value(item).like(listed)} for item in few]
    return [{}]


def _counted(analysis: Analysis, loop: Scope) -> list[dict[Variable, Value]]:
    """Return the turns of `for (int i = 0; i < 3; i++)`, none where the ends are not known."""
    names = [name for name, found in loop.variables.items() if len(found) == 1]
    condition = loop.node.child_by_field_name("condition")
    update = loop.node.child_by_field_name("update")
    if len(names) != 1 or condition is None or update is None:
        return []
    variable = loop.variables[names[0]][0]
    syntax = loop.file.syntax
    text = "".join(syntax.word(update).split())
    if text not in (f"{names[0]}++", f"++{names[0]}") or condition.type != "binary_expression":
        return []
    left, operator = (
        condition.child_by_field_name("left"),
        condition.child_by_field_name("operator"),
    )
    if left is None or operator is None or syntax.word(left) != names[0]:
        return []
    first = analysis.evaluator.fold(variable.value, loop)
    last = analysis.evaluator.fold(condition.child_by_field_name("right"), loop)
    if first is None or last is None or last.is_default or last.is_guess:
        return []
    start, stop = first.value, last.value
    if type(start) is not int or type(stop) is not int or operator.type not in ("<", "<=", "!="):
        return []
    stop += operator.type == "<="
    if not 0 < stop - start <= MOST_WORLDS:
        return []
    return [{variable: Value(number)} for number in range(start, stop)]


def _calls(analysis: Analysis, scope: Scope, depth: int) -> Iterator[Bindings]:
    function = scope.around
    if function is None or depth >= _MOST_DEEP:
        return
    has_template = function.place.kind == "template"
    if not function.parameters and not has_template:
        return
    for call in analysis.callers.of(function)[: MOST_WORLDS + 1]:
        outer = list(_calls(analysis, call.scope, depth + 1))[: MOST_WORLDS + 1]
        for bindings in outer or [()]:
            if all(each is not function for each, _ in bindings):
                yield ((function, call), *bindings)
