"""How long durations are, in seconds.

Sources: ISO C++20 [time.duration]; `ros/duration.h`, `ros/rate.h` of Noetic;
`rclcpp/duration.hpp`, `rclcpp/rate.hpp` of Jazzy.
"""

from __future__ import annotations

import math
import re

from tree_sitter import Node

from .analysis import Analysis
from .arguments import call_of
from .held import Held
from .literals import number_value
from .scopes import Scope
from .value import Value

_UNITS = {
    "nanoseconds": 1e-9,
    "microseconds": 1e-6,
    "milliseconds": 1e-3,
    "seconds": 1.0,
    "minutes": 60.0,
    "hours": 3600.0,
}
_SUFFIXES = {"ns": 1e-9, "us": 1e-6, "ms": 1e-3, "s": 1.0, "min": 60.0, "h": 3600.0}
_RATIOS = {"std::nano": 1e-9, "std::micro": 1e-6, "std::milli": 1e-3, "std::ratio<1>": 1.0}
_CHRONO = re.compile(r"(?:std::)?chrono::(\w+)(?:<.*>)?")
_COUNTED = re.compile(r"(?:std::)?chrono::duration<([\w:]+)(?:,(.+))?>")
_ROS1 = re.compile(r"ros::(?:Wall)?Duration")
_RATES = re.compile(r"(?:ros::(?:Wall)?Rate|rclcpp::(?:Wall)?Rate(?:Base)?)")
_LITERAL = re.compile(r"([\d.'eE+-]+?)(ns|us|ms|s|min|h)")
_MOST_DEEP = 12


def seconds(analysis: Analysis, node: Node | None, scope: Scope, depth: int = 0) -> Value | None:
    """Return the seconds of a duration, or of a number of seconds; None where not known."""
    if node is None or depth > _MOST_DEEP:
        return None
    syntax = scope.file.syntax
    match node.type:
        case "user_defined_literal":
            found = _LITERAL.fullmatch(syntax.word(node).strip())
            number = number_value(found[1]) if found is not None else None
            return None if found is None or number is None else _scaled(number, _SUFFIXES[found[2]])
        case "parenthesized_expression":
            inner = node.named_children
            return seconds(analysis, inner[0], scope, depth + 1) if len(inner) == 1 else None
        case "binary_expression":
            return _calculated(analysis, node, scope, depth)
        case "number_literal" | "unary_expression":
            return analysis.evaluator.fold(node, scope)
    held = analysis.holding.of(node, scope)
    if held is None:
        return None
    if held.node.type == "user_defined_literal" or held.node.type == "binary_expression":
        if held.node.id != node.id:
            return seconds(analysis, held.node, held.scope, depth + 1)
        return None
    found_value = _made(analysis, held, depth)
    if found_value is not None:
        return found_value._replace(is_guess=found_value.is_guess or held.is_guess)
    if held.type or held.call is not None:
        return None
    return analysis.evaluator.fold(node, scope)


def _scaled(number: int | float, factor: float) -> Value:
    # 10 * 1e-3 would be 0.01 and a bit.
    value = number / round(1 / factor) if factor < 1 else number * factor
    return Value(float(value))


def _calculated(analysis: Analysis, node: Node, scope: Scope, depth: int) -> Value | None:
    """Return the seconds of `1s / rate` and its like."""
    folded = analysis.evaluator.fold(node, scope)
    if folded is not None:
        return folded
    left = seconds(analysis, node.child_by_field_name("left"), scope, depth + 1)
    right = seconds(analysis, node.child_by_field_name("right"), scope, depth + 1)
    operator = node.child_by_field_name("operator")
    if left is None or right is None or operator is None:
        return None
    one, other = left.number, right.number
    if one is None or other is None:
        return None
    match operator.type:
        case "+":
            result = one + other
        case "-":
            result = one - other
        case "*":
            result = one * other
        case "/" if other:
            result = one / other
        case _:
            return None
    return Value(float(result)).like(left, right)


def _made(analysis: Analysis, held: Held, depth: int) -> Value | None:
    """Return the seconds of a duration that is made, or that a method gives."""
    given, scope = held.arguments, held.scope
    call = held.call
    if call is not None and call.receiver is not None:
        if call.name in ("period", "expectedCycleTime", "to_chrono", "toSec", "seconds"):
            return seconds(analysis, call.receiver, scope, depth + 1)
        if call.name in ("as_double", "as_int", "get", "get_value"):
            return analysis.evaluator.fold(call.node, scope)
        return None
    type_ = held.type
    if _RATES.fullmatch(type_) and given:
        rate = analysis.evaluator.fold(given[0], scope)
        if rate is None or rate.number is None:
            return seconds(analysis, given[0], scope, depth + 1)
        return Value(1 / rate.number).like(rate) if rate.number else None
    if _ROS1.fullmatch(type_) or type_ == "rclcpp::Duration":
        return _sum(analysis, held, depth)
    if type_.endswith(("Duration::from_seconds", "Duration")) and given:
        return analysis.evaluator.fold(given[0], scope)
    if type_.endswith("Duration::from_nanoseconds") and given:
        return _times(analysis, given[0], scope, 1e-9, depth)
    if (counted := _COUNTED.fullmatch(type_)) and given:
        factor = _RATIOS.get(counted[2] or "std::ratio<1>")
        return None if factor is None else _times(analysis, given[0], scope, factor, depth)
    chrono = _CHRONO.fullmatch(type_)
    if chrono is None or not given:
        bare = type_.rpartition("::")[2]
        if bare in _UNITS and given and "chrono" in "".join(_usings(scope)):
            return _times(analysis, given[0], scope, _UNITS[bare], depth)
        return None
    if chrono[1] in _UNITS:
        return _times(analysis, given[0], scope, _UNITS[chrono[1]], depth)
    if chrono[1] in ("duration_cast", "floor", "ceil", "round"):
        return seconds(analysis, given[0], scope, depth + 1)
    return None


def _usings(scope: Scope) -> list[str]:
    return [using for each in scope.chain for using in each.usings]


def _times(analysis: Analysis, node: Node, scope: Scope, factor: float, depth: int) -> Value | None:
    number = analysis.evaluator.fold(node, scope)
    if number is None or number.number is None:
        return seconds(analysis, node, scope, depth + 1) if _is_duration(node, scope) else None
    if not math.isfinite(number.number):
        return None
    return _scaled(number.number, factor).like(number)


def _is_duration(node: Node, scope: Scope) -> bool:
    """Whether an argument is a duration that is converted, and no number."""
    if node.type == "user_defined_literal":
        return True
    call = call_of(node, scope, scope.file.syntax) if node.type == "call_expression" else None
    return call is not None and ("chrono" in call.qualifier or call.name in _UNITS)


def _sum(analysis: Analysis, held: Held, depth: int) -> Value | None:
    """Return what `ros::Duration(1, 500000000)`, or `rclcpp::Duration(1s)` is."""
    given, scope = held.arguments, held.scope
    if len(given) == 1:
        number = analysis.evaluator.fold(given[0], scope)
        if number is not None and number.number is not None:
            return Value(float(number.number)).like(number)
        return seconds(analysis, given[0], scope, depth + 1)
    if len(given) != 2:
        return Value(0.0) if not given else None
    whole = analysis.evaluator.fold(given[0], scope)
    rest = analysis.evaluator.fold(given[1], scope)
    if whole is None or rest is None or whole.number is None or rest.number is None:
        return None
    return Value(whole.number + rest.number / 1e9).like(whole, rest)
