"""Parameters, as they are declared and read."""

from __future__ import annotations

from plastron_tui.diagnostics import codes
from plastron_tui.model.kinds import Parameter
from plastron_tui.model.kinds.ranges import Interval, limits_of
from plastron_tui.ros.parameter_values import unfit
from plastron_tui.ros.parameters import ParameterType
from plastron_tui.sources import naming

from .plan import NodePlan, ParameterPlan
from .writing import Writing

_WORDS = {
    ParameterType.BOOL: ("true or false", "truth values"),
    ParameterType.INT: ("an integer", "integers"),
    ParameterType.FLOAT: ("a number", "numbers"),
    ParameterType.STRING: ("a string", "strings"),
}
"""What a value of a type is called, and what several are."""


def add_parameters(writing: Writing, plan: NodePlan) -> None:
    """Plan the parameters of a node."""
    for parameter in writing.node.of(Parameter).values():
        assert parameter.holds is not None  # statements say it
        name = parameter.name.removeprefix("~/")
        wrong = unfit(parameter.default or (), writing.ros_version)
        if wrong is not None:
            writing.refuse(codes.PARAMETER_TYPE_MISMATCH, wrong, parameter.span)
        # A name with a slash before it is one of the whole ROS 1, and not the node's own.
        is_own = not writing.is_ros2 and not name.startswith("/")
        limits = limits_of(writing.node, parameter, writing.ros_version)
        plan.parameters.append(
            ParameterPlan(
                name=writing.parameter_name(name, is_own=is_own),
                label=naming.label(name, "it"),
                default=writing.setting(parameter.default),
                type=writing.parameter_type(parameter.holds),
                attribute=writing.attributes.new(f"{naming.words(name)}_parameter"),
                getter=writing.getter(name),
                descriptor=writing.descriptor(parameter, limits) if writing.is_ros2 else "",
                check=writing.check(parameter.holds, limits),
                wanted=_wanted(writing, parameter.holds, limits),
                is_own=is_own,
            )
        )


def _wanted(writing: Writing, type_: ParameterType, limits: Interval | None) -> str:
    """Return what a value is to be, in words."""
    one, several = _WORDS[type_.element]
    if type_.is_list:
        return f"a list of {several}"
    if limits is None:
        return one
    low, high = map(writing.setting, limits)
    return f"{one} from {low} to {high}"
