"""Parameters that a unit gets, and what reads those that it has.

Source: `rclcpp/node.hpp` of Jazzy (`declare_parameter`, `get_parameter`), `ros/node_handle.h` of
Noetic (`param`, `setParam`).
"""

from __future__ import annotations

from typing import NamedTuple

from plastron_tui.diagnostics import Diagnostic, Severity, codes
from plastron_tui.model.endpoint_details import ParameterDetails
from plastron_tui.model.kinds import Parameter
from plastron_tui.model.kinds.ranges import EVERY_FLOAT, EVERY_INTEGER, Interval
from plastron_tui.model.source import EndpointKind
from plastron_tui.ros.names import parameter_name
from plastron_tui.ros.parameters import ParameterType, Setting
from plastron_tui.sources import naming

from .. import literals
from ..details import Details
from .adding import Addition
from .handles import handle_for
from .interfaces import refuse
from .members import hold
from .own_functions import getter_of
from .place import beside, node_in_methods, start_rank
from .shared_names import shared_name

K = EndpointKind

_CLASSES = {
    1: {"bool": "bool", "int": "int", "float": "double", "string": "std::string"},
    2: {"bool": "bool", "int": "int64_t", "float": "double", "string": "std::string"},
}
_GETTERS = {"bool": "as_bool", "int": "as_int", "float": "as_double", "string": "as_string"}
_ARRAYS = {
    "bool": "as_bool_array",
    "int": "as_integer_array",
    "float": "as_double_array",
    "string": "as_string_array",
}
_HEADER = "rcl_interfaces/msg/parameter_descriptor.hpp"


class Read(NamedTuple):
    """What reads a parameter.

    Attributes:
        text: the expression.
        range: the numbers that it may be, None for no number.
    """

    text: str
    range: Interval | None


def class_of(type_: ParameterType, ros_version: int) -> str:
    """Write the type of what a parameter holds."""
    element = _CLASSES[ros_version][type_.element.value]
    return f"std::vector<{element}>" if type_.is_list else element


def setting_text(value: Setting, type_: ParameterType, ros_version: int) -> str:
    """Write the value of a parameter, of its type."""
    if isinstance(value, tuple):
        listed = ", ".join(_scalar(each, type_) for each in value)
        return f"{class_of(type_, ros_version)}{{{listed}}}"
    return _scalar(value, type_)


def _scalar(value: object, type_: ParameterType) -> str:
    assert isinstance(value, bool | int | float | str), "what a list holds is no list"
    if type_.element is ParameterType.FLOAT and not isinstance(value, str):
        return literals.real(float(value))
    return literals.scalar(value)


def declare_parameter(added: Addition, parameter: Parameter) -> None:
    """Give a node a parameter."""
    assert parameter.holds is not None, "statements say it"
    assert parameter.default is not None, "statements say it"
    version = added.analysis.ros_version
    value = setting_text(parameter.default, parameter.holds, version)
    class_ = class_of(parameter.holds, version)
    added.expect(K.PARAMETER, parameter.name, None, "")
    if added.is_ros2:
        _declare_in_ros2(added, parameter, class_, value)
        return
    if parameter.minimum is not None:
        added.plan.notes.append(no_range(parameter))
    handle, name = handle_for(added.analysis, added.place, parameter.name)
    text = literals.string(name)
    if added.owner is not None:
        words = naming.words(parameter.name)
        variable, _ = hold(added, K.PARAMETER, class_, words)
        added.lines.append(f"{handle}param<{class_}>({text}, {variable}, {value});")
        return
    # A variable of a function that nothing uses would be a warning: what is set can be seen.
    added.expect(K.PARAMETER, parameter.name, None, "")
    added.lines.append(f"{handle}setParam({text}, {handle}param<{class_}>({text}, {value}));")


def no_range(parameter: Parameter) -> Diagnostic:
    """Return the warning that nothing in ROS 1 keeps a parameter in its range."""
    bare = parameter.name.removeprefix("~/")
    message = f"ROS 1 has no ranges: that of `{bare}` is left out"
    remedy = f"check by hand what is read of `{bare}`"
    code, severity = codes.NOT_IN_ROS_1, Severity.WARNING
    return Diagnostic(code, message, parameter.span, help=remedy, severity=severity)


def _declare_in_ros2(added: Addition, parameter: Parameter, class_: str, value: str) -> None:
    assert parameter.holds is not None, "statements say it"
    node, name = added.place.node, literals.string(parameter.name)
    template = "" if parameter.holds.is_list else f"<{class_}>"
    for header in ("string", "vector"):
        if f"std::{header}" in f"{template}{value}":
            added.include(added.place.file, header)
    lines = []
    if parameter.description:
        lines.append(f"descriptor.description = {literals.string(parameter.description)};")
    if parameter.minimum is not None and parameter.maximum is not None:
        is_whole = parameter.holds.element is ParameterType.INT
        kind = "integer" if is_whole else "floating_point"
        lines.append(f"descriptor.{kind}_range.resize(1);")
        for field, number in (("from", parameter.minimum), ("to", parameter.maximum)):
            written = literals.integer(int(number)) if is_whole else literals.real(float(number))
            lines.append(f"descriptor.{kind}_range[0].{field}_value = {written};")
    arguments = [name, value]
    if lines:
        arguments.append("descriptor")
        added.include(added.place.file, _HEADER)
        added.interfaces.packages["rcl_interfaces"] = None
        lines.insert(0, "rcl_interfaces::msg::ParameterDescriptor descriptor;")
    has_block = bool(lines)
    lines.append(f"{node}declare_parameter{template}({', '.join(arguments)});")
    if shared_name(added) is not None:
        # Who declares a parameter twice gets a `ParameterAlreadyDeclaredException`.
        style = added.style(added.place.file)
        added.expect(K.PARAMETER, parameter.name, None, "")
        added.lines += style.block(f"if (!{node}has_parameter({name}))", lines)
    elif has_block:
        added.lines += ["{", *(f"\t{each}" for each in lines), "}"]
    else:
        added.lines += lines


def read_parameter(added: Addition, name: str, *, in_method: bool = False) -> Read:
    """Write what reads a parameter of the node, and tell which numbers it may be.

    Args:
        added: the endpoint.
        name: the parameter.
        in_method: whether it is read in what the endpoint calls, and not where it is created.

    Raises:
        RefusedError: the files do not say its type, or in ROS 1 its default.
    """
    version = added.analysis.ros_version
    whole = parameter_name(name, version)
    details = Details(added.analysis)
    said = [
        found
        for site in added.sites
        if site.endpoint.kind is K.PARAMETER and site.endpoint.name == whole
        if isinstance(found := details.of(site).details, ParameterDetails)
    ]
    type_ = next((each.type for each in said if each.type is not None), None)
    default = next((each.default for each in said if each.default is not None), None)
    if type_ is None or (version == 1 and default is None) or "byte" in type_:
        what = "type" if type_ is None else "default"
        message = f"the file does not say the {what} of `{name}` in one place"
        refuse(
            codes.EDIT_REFUSED, message, added.span, f"write by hand what `{name}` is needed for"
        )
    element = type_.removesuffix("_list")
    range_ = {"int": EVERY_INTEGER, "float": EVERY_FLOAT}.get(element)
    added.expect(K.PARAMETER, whole, None, "")
    if added.is_ros2:
        if not in_method:
            _follow_declaration(added, whole)
        getter = (_ARRAYS if type_ != element else _GETTERS)[element]
        node = node_in_methods(added.analysis, added.place) if in_method else added.place.node
        if node is None:
            message = f"no method of the class sees the node that has `{name}`"
            remedy = f"keep the node, or `{name}`, in a member of the class first"
            refuse(codes.EDIT_REFUSED, message, added.span, remedy)
        return Read(f"{node}get_parameter({literals.string(whole)}).{getter}()", range_)
    own_getter = getter_of(added.analysis, whole) if in_method else None
    if own_getter is not None:
        added.plan.added.pop()
        return Read(f"{own_getter.name}()", range_)
    handle, own = handle_for(added.analysis, added.place, whole, in_method=in_method)
    holds = ParameterType(type_)
    assert default is not None, "it was refused otherwise"
    value = setting_text(default, holds, 1)  # type: ignore[arg-type]
    return Read(f"{handle}param<{class_of(holds, 1)}>({literals.string(own)}, {value})", range_)


def _follow_declaration(added: Addition, name: str) -> None:
    """Create the endpoint behind the call that declares a parameter, which ROS 2 asks for.

    Raises:
        RefusedError: it is not declared where the endpoint is created.
    """
    places = [
        place
        for site in added.sites
        if site.endpoint.kind is K.PARAMETER
        and site.endpoint.name == name
        and site.call.name == "declare_parameter"
        if (place := beside(added.analysis, site)) is not None
    ]
    here = [each for each in places if each.function is added.place.function]
    if any(each.offset <= added.place.offset for each in here):
        return
    # What runs once as the node starts is as good a place.
    here += [
        each
        for each in places
        if each.owner is added.place.owner and start_rank(added.analysis, each.function) is not None
    ]
    if not here:
        message = f"`{name}` is not declared where `{added.endpoint.name}` is created"
        refuse(codes.EDIT_REFUSED, message, added.span, "write the timer by hand")
    added.place = here[0]
