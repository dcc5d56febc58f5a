"""The statements about parameters."""

from __future__ import annotations

from ..declaration import SlotKind, Statement, slot, statement
from ..inputs import InputValue

PARAMETER_HELP = "the parameter, a name of the node's own"


@statement(
    "has_parameter_statement",
    "{node} has_parameter {parameter} of parameter_type {type} with default {default}"
    " [between {minimum} and {maximum}] [described_as {description}]",
    summary="Give a node a value that can be set from outside.",
    example="driver has_parameter 'speed' of parameter_type float with default 0.5 between 0 and 2",
    purpose="have a value that can be set from outside",
    ros_term="parameter",
    about="A parameter is set when the node is started, or while it runs.",
)
class HasParameter(Statement):
    """Give a node a value that can be set from outside."""

    node: str = slot(SlotKind.NODE, "the node that has it")
    parameter: str = slot(SlotKind.PARAMETER, PARAMETER_HELP)
    type: str = slot(SlotKind.PARAMETER_TYPE, "what its values are")
    default: InputValue = slot(SlotKind.DEFAULT, "the value that it has where none is set")
    minimum: int | float | None = slot(SlotKind.BOUND, "the least value")
    maximum: int | float | None = slot(SlotKind.BOUND, "the greatest value")
    description: str | None = slot(SlotKind.TEXT, "what it is for, for those who set it")


@statement(
    "no_longer_has_parameter_statement",
    "{node} no_longer_has_parameter {parameter}",
    summary="Take a parameter away from a node.",
    example="driver no_longer_has_parameter 'speed'",
    purpose="no longer have a value that can be set",
    ros_term="parameter",
    about="Takes a parameter away again.",
    undoes=HasParameter,
)
class NoLongerHasParameter(Statement):
    """Take a parameter away from a node."""

    node: str = slot(SlotKind.NODE, "the node that has it")
    parameter: str = slot(SlotKind.PARAMETER, PARAMETER_HELP)
