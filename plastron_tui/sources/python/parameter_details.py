"""What a call says of a parameter: its type, default, range and description."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import NamedTuple

from tree_sitter import Node

from plastron_tui.model.endpoint_details import ParameterDetails, Range

from .analysis import Analysis, Site
from .arguments import Arguments
from .containers import Given
from .evaluated import UNKNOWN
from .evaluation import Evaluator
from .parameter_calls import VALUE_FIELDS, parameter_call
from .references import STATEMENT_PARENTS
from .scopes import Scope
from .syntax import parts_of

_SCALARS = {"BOOL": "bool", "INTEGER": "int", "DOUBLE": "float", "STRING": "string"}
_LISTS = {f"{name}_ARRAY": f"{type_}_list" for name, type_ in _SCALARS.items()}
_TYPES = {**_SCALARS, **_LISTS, "BYTE_ARRAY": "byte_list"}
# `rclpy.parameter.Parameter.Type`, `rcl_interfaces/msg/ParameterType`
_TYPE_NAME = re.compile(
    r"rclpy\.(?:\w+\.)?Parameter\.Type\.(?P<type>\w+)"
    r"|rcl_interfaces\.msg\.(?:\w+\.)?ParameterType\.PARAMETER_(?P<number>\w+)"
)
_DESCRIPTOR = re.compile(r"rcl_interfaces\.msg\.(?:\w+\.)?ParameterDescriptor")
_RANGE = re.compile(r"rcl_interfaces\.msg\.(?:\w+\.)?(?:FloatingPoint|Integer)Range")
# More are set of one variable for many parameters; each would be looked at for each.
_MOST_FIELDS = 64
_RANGES = ("floating_point_range", "integer_range")


def parameter_details(analysis: Analysis, site: Site, evaluator: Evaluator) -> ParameterDetails:
    """Return what a call says of the parameter of a call site."""
    call = parameter_call(analysis, site)
    said = _type_named(analysis, call.default, site.scope)
    default = call.default if said is None else None
    if default is not None and default.type == "none":
        default = None
    worth = evaluator.evaluate(default, site.scope)
    set_to = evaluator.evaluate(call.value, site.scope) if call.value is not None else UNKNOWN
    fields = _message_fields(evaluator, call.descriptor, site.scope, _DESCRIPTOR, analysis)
    described = _Descriptor(analysis, fields)
    types = (
        said,
        _type_named(analysis, call.type, site.scope),
        worth.type,
        set_to.type,
        described.type(),
        _type_of_use(analysis, site.call),
    )
    return ParameterDetails(
        type=next((each for each in types if each is not None), None),
        default=worth.value,
        default_expression=analysis.syntax.slice(default) if default is not None else "",
        range=described.range(evaluator),
        description=described.text(evaluator),
        is_read_only=described.is_read_only(evaluator),
        is_guess=worth.is_guess,
    )


def _type_named(analysis: Analysis, node: Node | None, scope: Scope) -> str | None:
    """Return the type that `Parameter.Type.DOUBLE` and its like name."""
    given = analysis.resolver.containers.literal(node, scope) if node is not None else None
    # `Parameter.Type.DOUBLE.value` is its number.
    node = given.node if given is not None else node
    if node is None or node.type != "attribute":
        return None
    scope = given.scope if given is not None else scope
    for name in analysis.resolver.qualified(node, scope):
        found = _TYPE_NAME.fullmatch(name.removesuffix(".value"))
        if found is not None:
            return _TYPES.get(found["type"] or found["number"])
    return None


def _type_of_use(analysis: Analysis, call: Node) -> str | None:
    """Return the type that `….get_parameter_value().double_value` reads of a parameter."""
    syntax, node = analysis.syntax, call
    for _ in range(2):
        attribute = node.parent
        if attribute is None or attribute.type != "attribute":
            return None
        field = attribute.child_by_field_name("attribute")
        name = syntax.slice(field) if field is not None else ""
        if name in VALUE_FIELDS:
            return VALUE_FIELDS[name]
        if name != "get_parameter_value" or attribute.parent is None:
            return None
        node = attribute.parent
    return None


class _Descriptor(NamedTuple):
    """What a `ParameterDescriptor` is made of.

    Attributes:
        analysis: the file.
        fields: what it is given, by the names of its fields; not what is set twice.
    """

    analysis: Analysis
    fields: Mapping[str, Given]

    def type(self) -> str | None:
        """Return the type that it names, or that its range is for."""
        given = self.fields.get("type")
        named = _type_named(self.analysis, given.node, given.scope) if given is not None else None
        if named is None and "floating_point_range" in self.fields:
            return "float"
        return "int" if named is None and "integer_range" in self.fields else named

    def text(self, evaluator: Evaluator) -> str | None:
        """Return its description."""
        given = self.fields.get("description")
        value = evaluator.evaluate(given.node, given.scope).value if given is not None else None
        return value if isinstance(value, str) else None

    def is_read_only(self, evaluator: Evaluator) -> bool:
        """Tell whether it says that nobody may change the parameter."""
        given = self.fields.get("read_only")
        return given is not None and evaluator.evaluate(given.node, given.scope).value is True

    def range(self, evaluator: Evaluator) -> Range | None:
        """Return the range that it sets, None where it sets none, or it is not known."""
        given = next((self.fields[name] for name in _RANGES if name in self.fields), None)
        listed = evaluator.resolved(given.node, given.scope) if given is not None else None
        if listed is None or listed.node.type not in ("list", "tuple"):
            return None
        items = parts_of(listed.node)
        if len(items) != 1:
            return None
        ends = _message_fields(evaluator, items[0], listed.scope, _RANGE, self.analysis)
        found = {name: evaluator.evaluate(each.node, each.scope) for name, each in ends.items()}
        low, high = (found.get(name, UNKNOWN) for name in ("from_value", "to_value"))
        step = found.get("step", UNKNOWN)
        if not isinstance(low.value, int | float) or not isinstance(high.value, int | float):
            return None
        if low.is_guess or high.is_guess:
            return None
        return Range(
            low.value, high.value, step.value if isinstance(step.value, int | float) else 0
        )


def _message_fields(
    evaluator: Evaluator,
    node: Node | None,
    scope: Scope,
    wanted: re.Pattern[str],
    analysis: Analysis,
) -> dict[str, Given]:
    """Return what a message is given as it is made, and by assignments to its fields.

    Args:
        evaluator: evaluates the expressions of the file.
        node: the expression that is the message.
        scope: the scope of the expression.
        wanted: the qualified names that its class may have.
        analysis: the file.
    """
    held = analysis.resolver.containers.literal(node, scope) if node is not None else None
    if node is None or held is None or held.node.type != "call":
        return {}
    callee = held.node.child_by_field_name("function")
    if not any(map(wanted.fullmatch, analysis.resolver.qualified(callee, held.scope))):
        return {}
    made = Arguments.of(held.node, analysis.syntax)
    if made.is_open:
        return {}
    found = {name: Given(value, held.scope) for name, value in made.keywords.items()}
    if node.type in ("identifier", "attribute"):
        _assign(evaluator, node, scope, found, analysis)
    return found


def _assign(
    evaluator: Evaluator, node: Node, scope: Scope, found: dict[str, Given], analysis: Analysis
) -> None:
    """Put what `descriptor.description = 'speed'` sets in its place; what may be set is unknown.

    Set for sure is what the function sets once, before the line and in a block around it.
    """
    seen: set[str] = set()
    values = evaluator.field_values(node)
    if len(values) > _MOST_FIELDS:
        found.clear()
        return
    for name, value in values:
        block = value
        while block.parent is not None and block.type not in STATEMENT_PARENTS:
            block = block.parent
        is_before = value.end_byte <= node.start_byte < block.end_byte
        is_here = is_before and analysis.scopes.at(value.start_byte) is scope
        if name in seen or not is_here:
            found.pop(name, None)
        else:
            found[name] = Given(value, scope)
        seen.add(name)
