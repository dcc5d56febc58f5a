"""Parameters that a file gets, and changes of those that it has.

Source: `rclpy.node.Node.declare_parameter`, `rcl_interfaces/msg/ParameterDescriptor` of Jazzy;
`rospy.get_param`, `rospy.set_param` of Noetic.
"""

from __future__ import annotations

from tree_sitter import Node

from plastron_tui.diagnostics import Diagnostic, Severity, codes
from plastron_tui.model.endpoint_details import ParameterDetails, Range
from plastron_tui.model.kinds import Parameter
from plastron_tui.model.source import EndpointKind
from plastron_tui.ros.names import name_as_written
from plastron_tui.ros.parameters import ParameterType, Setting

from . import literals, naming
from .addition import Addition
from .analysis import Analysis, Site
from .arguments import Arguments
from .calls import Argument
from .conventions import Conventions
from .insertion_point import behind_node, find_place
from .messages import CannotAddError
from .parameter_calls import parameter_call
from .place import Place, beside
from .qos_arguments import put_argument
from .references import statement_of
from .replacing import NotInPlaceError, Replacement
from .surroundings import is_attribute_style
from .syntax import parts_of
from .writing import Key

_RANGES = {
    ParameterType.INT: ("integer_range", "IntegerRange"),
    ParameterType.FLOAT: ("floating_point_range", "FloatingPointRange"),
}
_MESSAGES = "rcl_interfaces.msg"
_DESCRIPTOR = Argument(2, "descriptor")
_DECLARING = frozenset({"declare_parameter", "rospy.get_param"})


def setting_text(value: Setting | None, conventions: Conventions) -> str:
    """Write the value of a parameter; a list is a list of Python."""
    match value:
        case tuple():
            return f"[{', '.join(setting_text(each, conventions) for each in value)}]"
        case str():
            return conventions.string(value)
        case bool() | None:
            return repr(value)
        case _:
            return literals.number(value)


def parameter_place(node: Analysis, place: Place | None) -> Place | None:
    """Return where a parameter goes: behind those that the node has, or behind the node itself.

    Args:
        node: what is known of the node.
        place: where an endpoint would go.
    """
    for site in reversed(node.sites):
        is_alike = site.endpoint.kind is EndpointKind.PARAMETER and not site.passes
        is_alike = is_alike and not _DECLARING.isdisjoint(site.shape.callees)
        found = beside(node, site) if is_alike and _is_setup(node, site) else None
        if found is not None:
            return found
    if place is not None and place.owner is not None and not node.library.node_classes:
        # What an object reads is its own, wherever the node is named.
        return place
    for each in node.nodes:
        if (found := behind_node(node, each)) is not None:
            return found
    return place or find_place(node, EndpointKind.PARAMETER)


def _is_setup(node: Analysis, site: Site) -> bool:
    """Whether a call runs for sure when the node is set up, where that is made."""
    function = site.scope.enclosing("function")
    block = statement_of(site.call).parent
    if block is None or (function is not None and function.name not in ("__init__", "main")):
        return False
    if function is not None and (block.parent is None or block.parent.id != function.node.id):
        return False
    if function is None and block.type != "module":
        return False
    if function is not None and function.self_name and not node.library.node_classes:
        return True
    owners = [function.parent] if function is not None else []
    return any(
        each.scope.enclosing("function") is function or (each.owner and each.owner in owners)
        for each in node.nodes
    )


def declare(added: Addition, parameter: Parameter) -> list[str]:
    """Return the statements that give a node a parameter."""
    conventions = added.writer.conventions
    name = conventions.string(name_as_written(parameter.name, added.dialect.ros_version))
    default = setting_text(parameter.default, conventions)
    key: Key = (EndpointKind.PARAMETER, parameter.name, "None", "")
    added.writer.endpoints.append(key)
    if added.is_rclpy:
        receiver = added.place.receiver
        given = [name, default, *_described(added, parameter)]
        return [f"{receiver}.declare_parameter({', '.join(given)})"]
    if parameter.minimum is not None:
        added.writer.notes.append(_no_range(parameter))
    read = f"{added.rospy('get_param')}({name}, {default})"
    is_function = added.place.scope.parent is not None
    words = naming.words(parameter.name)
    if is_attribute_style(added.analysis, added.place, EndpointKind.PARAMETER):
        variable = added.free_name(words, f"{words}_parameter")
        return [f"{added.place.self_name}.{variable} = {read}"]
    if not is_function:
        return [f"{added.free_name(words, f'{words}_parameter')} = {read}"]
    # A variable of a function that nothing uses would be of no use: what is set can be seen.
    added.writer.endpoints.append(key)
    return [f"{added.rospy('set_param')}({name}, {read})"]


def _no_range(parameter: Parameter) -> Diagnostic:
    bare = parameter.name.removeprefix("~/")
    return Diagnostic(
        codes.NOT_IN_ROS_1,
        f"ROS 1 has no ranges: that of `{bare}` is left out",
        parameter.span,
        help=f"check by hand what is read of `{bare}`",
        severity=Severity.WARNING,
    )


def _described(added: Addition, parameter: Parameter) -> list[str]:
    """Return what describes a parameter of rclpy: its range, and what it is for."""
    given = []
    if parameter.description:
        text = added.writer.conventions.string(parameter.description)
        given.append(f"description={text}")
    if (limits := _range(added, parameter)) is not None:
        given.append(limits)
    if not given:
        return []
    return [f"{added.imports.use(_MESSAGES, 'ParameterDescriptor')}({', '.join(given)})"]


def _range(added: Addition, parameter: Parameter) -> str | None:
    if parameter.minimum is None or parameter.holds not in _RANGES:
        return None
    field, class_ = _RANGES[parameter.holds]
    low, high = map(literals.number, (parameter.minimum, parameter.maximum or 0))
    made = f"{added.imports.use(_MESSAGES, class_)}(from_value={low}, to_value={high})"
    return f"{field}=[{made}]"


def redeclare(update: Replacement, parameter: Parameter, found: ParameterDetails) -> None:
    """Change the default and the range that a call gives a parameter; what says them stays.

    Raises:
        NotInPlaceError: the call says no default.
        CannotAddError: the range cannot be changed.
    """
    analysis, site = update.analysis, update.site
    call = parameter_call(analysis, site)
    if call.default is None:
        raise NotInPlaceError
    if found.default != parameter.default or type(found.default) is not type(parameter.default):
        text = setting_text(parameter.default, update.added.writer.conventions)
        update.put(_first_value(analysis, site, call.default), text)
    _set_range(update, parameter, found, call.descriptor)
    if not update.added.is_rclpy and parameter.minimum is not None:
        update.notes.append(_no_range(parameter))
    if parameter.holds is not None and found.type not in (None, parameter.holds.value):
        update.notes.append(_other_type(parameter, found))


def _first_value(analysis: Analysis, site: Site, default: Node) -> Node:
    """Return the default, or what it is at first: that of the last good value, `self.speed`."""
    if default.type != "attribute":
        return default
    bindings = analysis.resolver.attribute_bindings(default, site.scope)
    values = [each.value for each in bindings if each.value is not None]
    known = [each for each in values if analysis.resolver.fold(each, site.scope) is not None]
    return known[0] if len(known) == 1 and len(values) > 1 else default


def _other_type(parameter: Parameter, found: ParameterDetails) -> Diagnostic:
    bare = parameter.name.removeprefix("~/")
    assert parameter.holds is not None
    return Diagnostic(
        codes.OTHER_TYPE,
        f"what reads `{bare}` was written for `{found.type}`, and gets `{parameter.holds.value}`",
        parameter.span,
        help="change it by hand",
    )


def _set_range(
    update: Replacement, parameter: Parameter, found: ParameterDetails, descriptor: Node | None
) -> None:
    wanted = parameter.minimum, parameter.maximum
    if not update.added.is_rclpy:
        return
    if wanted == (None, None):
        _check_range(parameter, found.range)
        return
    if found.range is not None and found.range[:2] == wanted:
        return
    if descriptor is None:
        if "declare_parameter" not in update.site.shape.callees:
            raise _refused(parameter, "in a list of parameters")
        written = _described(update.added, parameter)
        put_argument(update, _DESCRIPTOR, written[0])
        return
    ends = _ends(update.analysis, descriptor)
    if ends is None:
        raise _refused(parameter, f"in line {descriptor.start_point.row + 1}")
    for node, value in zip(ends, wanted, strict=True):
        assert value is not None
        update.put(node, literals.number(value))


def _ends(analysis: Analysis, descriptor: Node) -> tuple[Node, Node] | None:
    """Return what says the ends of the one range in the call that makes a descriptor."""
    if descriptor.type != "call":
        return None
    given = Arguments.of(descriptor, analysis.syntax).keywords
    listed = given.get("floating_point_range") or given.get("integer_range")
    items = parts_of(listed) if listed is not None and listed.type == "list" else []
    if len(items) != 1 or items[0].type != "call":
        return None
    ends = Arguments.of(items[0], analysis.syntax).keywords
    low, high = ends.get("from_value"), ends.get("to_value")
    return None if low is None or high is None else (low, high)


def _refused(parameter: Parameter, where: str) -> CannotAddError:
    bare = parameter.name.removeprefix("~/")
    message = f"the range of `{bare}` is not written where it is declared, {where}"
    return CannotAddError(codes.EDIT_REFUSED, message, parameter.span, "change the range by hand")


def _check_range(parameter: Parameter, limits: Range | None) -> None:
    default = parameter.default
    if limits is None or isinstance(default, bool) or not isinstance(default, int | float):
        return
    if not limits.low <= default <= limits.high:
        bare = parameter.name.removeprefix("~/")
        raise CannotAddError(
            codes.EDIT_REFUSED,
            f"the file lets `{bare}` be from {limits.low:g} to {limits.high:g}, not {default:g}",
            parameter.span,
            "say another range as well: `between MIN and MAX`",
        )


def has_asked(parameter: Parameter, found: ParameterDetails, version: int) -> bool:
    """Tell whether a call says of a parameter what is asked for, as far as its ROS has it."""
    if found.default is not None and found.default != parameter.default:
        return False
    wanted = parameter.minimum, parameter.maximum
    is_range = version == 1 or wanted == (None, None)
    return is_range or (found.range is not None and found.range[:2] == wanted)


def reads(site: Site, analysis: Analysis) -> bool:
    """Whether a call says the default of a parameter."""
    return parameter_call(analysis, site).default is not None
