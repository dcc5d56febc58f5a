"""Parameters, as they are declared and read."""

from __future__ import annotations

from plastron_tui.diagnostics import codes
from plastron_tui.model.kinds import Parameter
from plastron_tui.model.kinds.ranges import Interval, limits_of
from plastron_tui.ros.parameter_values import unfit
from plastron_tui.ros.parameters import ParameterType
from plastron_tui.sources.python import literals, naming

from ..plan import NodePlan, ParameterPlan
from .writing import Writing

_RANGES = {ParameterType.INT: "IntegerRange", ParameterType.FLOAT: "FloatingPointRange"}
_RANGE_FIELDS = {ParameterType.INT: "integer_range", ParameterType.FLOAT: "floating_point_range"}

_CHECKS = {
    ParameterType.BOOL: ("type({0}) is bool", "true or false"),
    ParameterType.INT: ("type({0}) is int", "an integer"),
    ParameterType.FLOAT: ("type({0}) in (int, float)", "a number"),
    ParameterType.STRING: ("type({0}) is str", "a string"),
}
"""How a value of ROS 1 is seen to be of a type, and what it is called."""

_PLURALS = {
    ParameterType.BOOL: "truth values",
    ParameterType.INT: "integers",
    ParameterType.FLOAT: "numbers",
    ParameterType.STRING: "strings",
}


def add_parameters(writing: Writing, plan: NodePlan) -> None:
    """Plan the parameters of a node."""
    for parameter in writing.node.of(Parameter).values():
        assert parameter.holds is not None  # statements say it
        name = parameter.name.removeprefix("~/")
        wrong = unfit(parameter.default or (), writing.dialect.ros_version)
        if wrong is not None:
            writing.refuse(codes.PARAMETER_TYPE_MISMATCH, wrong, parameter.span)
        # A name with a slash before it is one of the whole ROS 1, and not the node's own.
        is_own = not writing.is_rclpy and not name.startswith("/")
        limits = limits_of(writing.node, parameter, writing.dialect.ros_version)
        plan.parameters.append(
            ParameterPlan(
                name=literals.string(f"~{name}" if is_own else name),
                label=naming.label(name, "it"),
                default=writing.setting(parameter.default),
                attribute=writing.attributes.new(f"{naming.words(name)}_parameter"),
                getter=writing.attributes.new(f"get_{naming.words(name)}"),
                descriptor=_descriptor(writing, parameter, limits) if writing.is_rclpy else "",
                check=_check(writing, parameter.holds, limits),
                wanted=_wanted(writing, parameter.holds, limits),
            )
        )


def _descriptor(writing: Writing, parameter: Parameter, limits: Interval | None) -> str:
    """Write what describes a parameter, "" where there is nothing to say.

    A range is one of `rcl_interfaces/ParameterDescriptor`, by which rclpy refuses what is not in
    it.
    """
    given = []
    if parameter.description:
        given.append(f"description={literals.string(parameter.description)}")
    if limits is not None:
        assert parameter.holds is not None
        class_ = writing.imports.use("rcl_interfaces.msg", _RANGES[parameter.holds])
        low, high = map(writing.setting, limits)
        field = _RANGE_FIELDS[parameter.holds]
        given.append(f"{field}=[{class_}(from_value={low}, to_value={high})]")
    if not given:
        return ""
    class_ = writing.imports.use("rcl_interfaces.msg", "ParameterDescriptor")
    return f"{class_}({', '.join(given)})"


def _check(writing: Writing, type_: ParameterType, limits: Interval | None) -> str:
    """Write what holds of a `value` that is of a type, and within limits."""
    check, _ = _CHECKS[type_.element]
    if type_.is_list:
        return f"type(value) is list and all({check.format('each')} for each in value)"
    written = check.format("value")
    if limits is None:
        return written
    low, high = map(writing.setting, limits)
    return f"{written} and {low} <= value <= {high}"


def _wanted(writing: Writing, type_: ParameterType, limits: Interval | None) -> str:
    """Return what a value is to be, in words."""
    if type_.is_list:
        return f"a list of {_PLURALS[type_.element]}"
    words = _CHECKS[type_][1]
    if limits is None:
        return words
    low, high = map(writing.setting, limits)
    return f"{words} from {low} to {high}"
