"""Changing what a file says of a parameter where it declares or reads it."""

from __future__ import annotations

import re

from tree_sitter import Node

from plastron_tui.diagnostics import codes
from plastron_tui.model.endpoint_details import ParameterDetails
from plastron_tui.model.kinds import Parameter
from plastron_tui.ros.parameters import ParameterType

from .. import literals
from ..analysis import Site
from ..details import Details
from ..read_parameters import parameter_call
from ..scopes import last_name
from .interfaces import refuse
from .parameters import no_range, setting_text
from .replacing import NotInPlaceError, Replacement

_VECTOR = re.compile(r"std::vector<[\w:]+>\s*(?=\{)")
_RANGE = re.compile(r"(?:floating_point|integer)_range\[0\]\.(from|to)_value")


def says_default(site: Site) -> bool:
    """Tell whether a call says the default of its parameter."""
    return parameter_call(site.call).default is not None


def redeclare(update: Replacement, parameter: Parameter) -> None:
    """Write another default, range or description for a parameter of the same type.

    Raises:
        NotInPlaceError: its type differs, or no literal says what differs.
        RefusedError: its default would be out of the range that it has.
    """
    site, analysis = update.site, update.analysis
    details = Details(analysis).of(site).details
    found = details if isinstance(details, ParameterDetails) else ParameterDetails()
    said = parameter_call(site.call)
    if said.default is None:
        return
    holds = None if parameter.holds is None else parameter.holds.value
    if None not in (holds, found.type) and holds != found.type:
        raise NotInPlaceError
    if analysis.ros_version == 2:
        _describe(update, parameter, found, said.descriptor)
    elif parameter.minimum is not None:
        update.plan.notes.append(no_range(parameter))
    default = parameter.default
    if default is None or (default == found.default and type(default) is type(found.default)):
        return
    if isinstance(default, tuple):
        update.put(site.place.file, said.default, _listed(update, said.default, parameter))
        return
    if not _is_literal(said.default):
        raise NotInPlaceError
    update.put(site.place.file, said.default, literals.scalar(default))


def _listed(update: Replacement, node: Node, parameter: Parameter) -> str:
    """Write a list as the file writes its own."""
    assert parameter.default is not None, "somebody asks for it"
    assert parameter.holds is not None, "statements say it"
    text = update.site.place.file.syntax.word(node)
    whole = setting_text(parameter.default, parameter.holds, update.analysis.ros_version)
    values = whole[whole.index("{") :]
    head = _VECTOR.match(text)
    if head is None and not text.startswith("{"):
        raise NotInPlaceError
    return f"{'' if head is None else head[0]}{values}"


def _describe(
    update: Replacement, parameter: Parameter, found: ParameterDetails, descriptor: Node | None
) -> None:
    """Write another range and description in the lines that fill a descriptor."""
    wanted = parameter.minimum, parameter.maximum
    is_range = wanted == (None, None) or (found.range is not None and found.range[:2] == wanted)
    if is_range and wanted == (None, None):
        _check_range(parameter, found)
    is_described = parameter.description in ("", found.description)
    if is_range and is_described:
        return
    scope = update.site.place
    name = "" if descriptor is None else last_name(descriptor, scope)
    variable = None
    if descriptor is not None and name:
        variable = update.analysis.unit.lookup(name, scope, descriptor.start_byte)
    done = 0
    for node, path, given, place in update.analysis.fields.of(name) if variable else ():
        if update.analysis.unit.lookup(name, place, node.start_byte) is not variable:
            continue
        end = _RANGE.fullmatch(path)
        if path == "description" and not is_described and _is_literal(given):
            update.put(place.file, given, literals.string(parameter.description))
            is_described = True
        elif end is not None and not is_range and _is_literal(given):
            value = wanted[end[1] == "to"]
            assert value is not None, "a range has two ends"
            is_whole = parameter.holds is ParameterType.INT
            written = literals.integer(int(value)) if is_whole else literals.real(float(value))
            update.put(place.file, given, written)
            done += 1
    if not is_described or (not is_range and done != len(wanted)):
        raise NotInPlaceError


def _check_range(parameter: Parameter, found: ParameterDetails) -> None:
    default, limits = parameter.default, found.range
    if limits is None or isinstance(default, bool) or not isinstance(default, int | float):
        return
    if not limits.low <= default <= limits.high:
        bare = parameter.name.removeprefix("~/")
        refuse(
            codes.EDIT_REFUSED,
            f"the file lets `{bare}` be from {limits.low:g} to {limits.high:g}, not {default:g}",
            parameter.span,
            "say another range as well: `between MIN and MAX`",
        )


def _is_literal(node: Node) -> bool:
    if node.type == "unary_expression":
        inner = node.child_by_field_name("argument")
        return inner is not None and inner.type == "number_literal"
    return node.type in ("number_literal", "string_literal", "true", "false")
