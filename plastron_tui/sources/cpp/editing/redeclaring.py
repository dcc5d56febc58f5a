"""Changing what a file says of a parameter where it declares or reads it."""

from __future__ import annotations

import re

from tree_sitter import Node

from plastron_tui.model.endpoint_details import ParameterDetails
from plastron_tui.model.kinds import Parameter

from .. import literals
from ..analysis import Site
from ..details import Details
from ..read_parameters import parameter_call
from .parameters import setting_text
from .replacing import NotInPlaceError, Replacement

_SUFFIX = re.compile(r"(?<=[\d.])[uUlLfF]+$")
"""What says of which type a number is."""


def says_default(site: Site) -> bool:
    """Tell whether a call says the default of its parameter."""
    return parameter_call(site.call).default is not None


def redeclare(update: Replacement, parameter: Parameter) -> None:
    """Write another default for a parameter of the same type.

    Raises:
        NotInPlaceError: its type or its range differs, or no literal says its default.
    """
    site = update.site
    details = Details(update.analysis).of(site).details
    found = details if isinstance(details, ParameterDetails) else ParameterDetails()
    said = parameter_call(site.call)
    if said.default is None:
        return
    holds = None if parameter.holds is None else parameter.holds.value
    if None not in (holds, found.type) and holds != found.type:
        raise NotInPlaceError
    limits = parameter.minimum, parameter.maximum
    is_range_there = found.range is not None and found.range[:2] == limits
    if update.analysis.ros_version == 2 and limits != (None, None) and not is_range_there:
        raise NotInPlaceError
    if parameter.description and parameter.description != (found.description or ""):
        raise NotInPlaceError
    default = parameter.default
    if default is None or (default == found.default and type(default) is type(found.default)):
        return
    if not _is_literal(said.default) or isinstance(default, tuple):
        raise NotInPlaceError
    written = literals.scalar(default)
    if parameter.holds is not None:
        written = setting_text(default, parameter.holds, update.analysis.ros_version)
    # `param("limit", limit, 0.5f)` is none of a `double`.
    suffix = _SUFFIX.search(site.place.file.syntax.slice(said.default))
    update.put(site.place.file, said.default, written + (suffix[0] if suffix else ""))


def _is_literal(node: Node) -> bool:
    if node.type == "unary_expression":
        inner = node.child_by_field_name("argument")
        return inner is not None and inner.type == "number_literal"
    return node.type in ("number_literal", "string_literal", "true", "false")
