"""How often the loops and the timers of a file run, where the file says so literally."""

from __future__ import annotations

from typing import NamedTuple

from tree_sitter import Node

from plastron_tui.model.source import EndpointKind

from . import literals
from .analysis import Analysis, Site
from .constants import Known
from .references import Use, references, variable_of
from .scopes import Scope
from .splices import Splice
from .syntax import parts_of

_MAKERS = ("Rate", "create_rate")
_DURATIONS = ("Duration", "from_sec")
# What takes more characters is written as one by the rate.
_MOST_DIGITS = 6


class Pace(NamedTuple):
    """What says how often something runs.

    Attributes:
        node: a rate in Hz, or a period in seconds.
        scope: where that is.
        is_period: whether it is a period.
    """

    node: Node
    scope: Scope
    is_period: bool

    def hertz(self, analysis: Analysis) -> float | None:
        """Return the rate in Hz, None where it is not literal."""
        number = _number(analysis, self.node, self.scope)
        return _inverse(number) if self.is_period else number

    def set_to(self, analysis: Analysis, rate: float) -> Splice | None:
        """Return what sets another rate, in Hz; None where the file does not say it literally."""
        node, value, is_period = self.node, rate, self.is_period
        while node.type == "call":
            callee, inner = node.child_by_field_name("function"), _first(node)
            if inner is None or _last(analysis, callee) not in _DURATIONS:
                return None
            node = inner
        above, below = node.child_by_field_name("left"), node.child_by_field_name("right")
        if is_period and above is not None and below is not None:
            if _quotient(analysis, node, self.scope) is None:
                return None
            if _number(analysis, above, self.scope) != 1:
                return None
            node, is_period = below, False
        if node.type not in ("integer", "float"):
            return None
        if is_period:
            value = 1 / rate
        is_whole = node.type == "integer" and float(value).is_integer()
        written = literals.number(int(value) if is_whole else value)
        if is_period and len(written) > _MOST_DIGITS:
            written = f"1.0 / {literals.number(rate)}"
        return Splice(node.start_byte, node.end_byte, written.encode())


def loop_pace(analysis: Analysis, loop: Node) -> Pace | None:
    """Return what says how often a loop runs, None where it sleeps twice."""
    scope = analysis.scopes.at(loop.start_byte)
    paces: list[Pace | None] = []
    for call in analysis.captures.get("call", []):
        is_inside = loop.start_byte <= call.start_byte and call.end_byte <= loop.end_byte
        callee = call.child_by_field_name("function") if is_inside else None
        holder = callee.child_by_field_name("object") if callee is not None else None
        if holder is not None and _last(analysis, callee) == "sleep":
            given = _first(call)
            if given is not None:
                paces.append(Pace(given, scope, is_period=True))
            else:
                paces.append(_made_pace(analysis, holder, scope))
    return paces[0] if len(paces) == 1 else None


def timer_pace(analysis: Analysis, site: Site) -> Pace | None:
    """Return what says how often a timer runs."""
    assert site.endpoint.kind is EndpointKind.TIMER
    given = site.arguments.get(site.shape.name)
    return Pace(given, site.scope, is_period=True) if given is not None else None


def is_once(timer: Site) -> bool:
    """Whether a timer may run once, or not before something starts it."""
    keywords, positional = timer.arguments.keywords, timer.arguments.positional
    if "create_timer" in timer.shape.callees:
        return "autostart" in keywords
    given = keywords.get("oneshot") or next(iter(positional[2:]), None)
    return given is not None and given.type != "false"


def loop_rate(analysis: Analysis, loop: Node) -> float | None:
    """Return the rate of a loop in Hz, None where it is not literal or it sleeps twice."""
    pace = loop_pace(analysis, loop)
    return None if pace is None else pace.hertz(analysis)


def timer_rate(analysis: Analysis, site: Site) -> float | None:
    """Return the rate of a timer in Hz, None where it is not literal."""
    pace = timer_pace(analysis, site)
    return None if pace is None else pace.hertz(analysis)


def is_shared(analysis: Analysis, pace: Pace, loop: Node) -> bool:
    """Whether something else than a loop sleeps at its pace."""
    if loop.start_byte <= pace.node.start_byte < loop.end_byte:
        return False
    assignment: Node | None = pace.node
    while assignment is not None and assignment.type != "assignment":
        assignment = assignment.parent
    target = assignment.child_by_field_name("left") if assignment is not None else None
    variable = variable_of(target, analysis) if target is not None else None
    return variable is None or any(
        each.use is not Use.BINDING and not loop.start_byte <= each.node.start_byte < loop.end_byte
        for each in references(variable, analysis)
    )


def _made_pace(analysis: Analysis, holder: Node, scope: Scope) -> Pace | None:
    """Return the rate that an object sleeps at, from the one call that makes it."""
    if holder.type == "identifier":
        found = scope.lookup(analysis.syntax.slice(holder))
        values = [each.value for each in found[1]] if found is not None else []
    elif holder.type == "attribute":
        bindings = analysis.resolver.attribute_bindings(holder, scope)
        values = [each.value for each in bindings]
    else:
        values = [holder]
    made = values[0] if len(values) == 1 else None
    callee = made.child_by_field_name("function") if made is not None else None
    given = _first(made) if made is not None and _last(analysis, callee) in _MAKERS else None
    if made is None or given is None:
        return None
    return Pace(given, analysis.scopes.at(made.start_byte), is_period=False)


def _number(analysis: Analysis, node: Node, scope: Scope) -> float | None:
    """Return a literal number, also one in `rospy.Duration(…)`."""
    callee = node.child_by_field_name("function") if node.type == "call" else None
    inner = _first(node) if _last(analysis, callee) in _DURATIONS else None
    folded = analysis.resolver.fold(inner or node, scope)
    value = folded.value if isinstance(folded, Known) else None
    if value is None and node.type == "binary_operator":
        return _quotient(analysis, node, scope)
    return float(value) if isinstance(value, int | float) else None


def _quotient(analysis: Analysis, node: Node, scope: Scope) -> float | None:
    """Return what `1.0 / 30` is."""
    parts = [node.child_by_field_name(name) for name in ("left", "operator", "right")]
    left, operator, right = parts
    if left is None or right is None or operator is None or operator.type != "/":
        return None
    above, below = _number(analysis, left, scope), _number(analysis, right, scope)
    return above / below if above is not None and below else None


def _inverse(seconds: float | None) -> float | None:
    return 1 / seconds if seconds else None


def _first(call: Node) -> Node | None:
    """Return the first argument of a call."""
    first = next(iter(parts_of(call.child_by_field_name("arguments"))), None)
    is_named = first is not None and first.type == "keyword_argument"
    return first.child_by_field_name("value") if first is not None and is_named else first


def _last(analysis: Analysis, callee: Node | None) -> str:
    """Return the last part of a dotted name."""
    return analysis.syntax.slice(callee).rpartition(".")[2] if callee is not None else ""
