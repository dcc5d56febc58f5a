"""The parameters that the nodes of C++ files declare and use, and whether that is all of them.

Sources: `rclcpp/node.hpp`, `rclcpp/node_options.hpp` of Jazzy.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from tree_sitter import Node

from plastron_tui.diagnostics import Span
from plastron_tui.model.code_facts import ParameterAccess, ParameterFacts, ParameterUse
from plastron_tui.model.source import EndpointKind
from plastron_tui.sources.cpp.analysis import Analysis, Site
from plastron_tui.sources.cpp.listed_parameters import listed_parameters, value_of
from plastron_tui.sources.cpp.nodes import owned_sites
from plastron_tui.sources.cpp.parameter_details import parameter_details
from plastron_tui.sources.cpp.read_parameters import parameter_call

from .default_types import type_of_default
from .helped_parameters import helped_uses
from .listed_names import possible_names
from .places import is_guarded
from .set_parameters import set_uses
from .whole_parameters import Wholeness, is_elsewhere, rest_wholeness, wholeness

_ALLOWED = re.compile(
    rb"\b(?:allow_undeclared_parameters|automatically_declare_parameters_from_overrides)"
    rb"\s*\(\s*(?!false\b)"
)


def allows_undeclared(analysis: Analysis) -> bool:
    """Tell whether files make nodes that may have parameters which they do not declare."""
    files = (file.syntax for file in analysis.unit.files)
    return analysis.ros_version == 2 and any(each.has(_ALLOWED) for each in files)


def parameter_facts(analysis: Analysis) -> Iterator[ParameterFacts]:
    """Yield what files say of the parameters of each of their nodes, in their order."""
    if analysis.ros_version == 1 or not analysis.nodes:
        return
    code = [file.syntax.code for file in analysis.unit.files]
    is_dynamic = any(b"dynamic_typing" in text for text in code)
    takes_options = any(b"NodeOptions" in text for text in code)
    for maker, sites in zip(analysis.nodes, owned_sites(analysis), strict=True):
        uses = tuple(_uses(analysis, sites, is_dynamic=is_dynamic))
        uses += tuple(helped_uses(analysis, maker, is_dynamic=is_dynamic))
        uses += tuple(set_uses(analysis, maker))
        declared = [use for use in uses if use.access is ParameterAccess.DECLARE]
        is_known = all(use.name is not None for use in declared)
        is_left = is_elsewhere(analysis, maker)
        known = rest = Wholeness()
        if is_known:
            known = wholeness(analysis, maker)
            rest = rest_wholeness(analysis, maker) if is_left else rest
        yield ParameterFacts(
            uses, known.is_whole, known.is_own, takes_options, is_left, rest.is_whole
        )


def _uses(analysis: Analysis, sites: Iterable[Site], *, is_dynamic: bool) -> Iterator[ParameterUse]:
    for site in sites:
        access = _access(site) if site.endpoint.kind is EndpointKind.PARAMETER else None
        if access is None:
            continue
        node = _name_node(site)
        place = site.call.node if node is None else node
        type_ = None
        if access is ParameterAccess.DECLARE and not is_dynamic:
            type_ = _type(analysis, site, node)
        use = ParameterUse(
            access,
            _name(analysis, site),
            Span(place.start_byte, place.end_byte),
            site.endpoint.file,
            type_,
            is_guarded(site.call.node),
        )
        if access is ParameterAccess.DECLARE and site.call.node.id in analysis.cut:
            yield use._replace(name=None)
        is_open = use.name is None and site.call.name == "declare_parameter"
        names = possible_names(analysis, node, site.place) if is_open else None
        yield from (use,) if names is None else (use._replace(name=name) for name in sorted(names))


def _access(site: Site) -> ParameterAccess | None:
    match site.call.name:
        case "declare_parameter" | "declare_parameters":
            return ParameterAccess.DECLARE
        case "get_parameter" if len(site.call.arguments) == 1:
            return ParameterAccess.GET
        case "get_parameter":
            # What it returns tells whether the parameter is declared; who looks at it, asks.
            around = site.call.node.parent
            is_alone = around is not None and around.type == "expression_statement"
            return ParameterAccess.READ if is_alone else ParameterAccess.HAS
        case "get_parameter_or":
            return ParameterAccess.GET_OR
        case "has_parameter":
            return ParameterAccess.HAS
        case _:
            return None


def _name(analysis: Analysis, site: Site) -> str | None:
    """Return the name of a parameter, None where it is not sure."""
    name = None if site.endpoint.is_guess else site.endpoint.name
    if site.call.name != "declare_parameters" or name is None:
        return name
    before = analysis.evaluator.fold(site.call.argument(0), site.place)
    if before is None or before.text is None:
        return None
    return f"{before.text}.{name}" if before.text else name


def _name_node(site: Site) -> Node | None:
    """Return what names the parameter of a call site."""
    if site.call.name != "declare_parameters":
        return site.call.argument(0)
    listed = listed_parameters(site.arguments, site.place)
    return next((node for node, text in listed if text == site.endpoint.expression), None)


def _type(analysis: Analysis, site: Site, name: Node | None) -> str | None:
    """Return the type that a declaration gives a parameter, None where it is not sure."""
    said = parameter_call(site.call)
    if site.call.type_nodes:
        return parameter_details(analysis, site).type
    is_listed = site.call.name == "declare_parameters"
    default = value_of(site.arguments, name) if is_listed else said.default
    return None if default is None else type_of_default(analysis, default, site.place)
