"""The parameters that the nodes of a Python file declare and use, and whether that is all of them.

Sources: `rclpy.node.Node` of Jazzy: what declares a parameter, and what refuses one that is not
declared.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from dataclasses import replace
from typing import NamedTuple

from tree_sitter import Node

from plastron_tui.diagnostics import Span
from plastron_tui.model.code_facts import ParameterAccess, ParameterFacts, ParameterUse
from plastron_tui.model.source import EndpointKind
from plastron_tui.sources.python.analysis import Analysis, NodeSite, Site
from plastron_tui.sources.python.arguments import Arguments
from plastron_tui.sources.python.base_classes import inherited_sites
from plastron_tui.sources.python.calls import Argument
from plastron_tui.sources.python.constants import Known
from plastron_tui.sources.python.evaluation import Evaluator
from plastron_tui.sources.python.nodes import makers_of, owned_sites
from plastron_tui.sources.python.parameter_details import parameter_details
from plastron_tui.sources.python.scopes import Scope
from plastron_tui.sources.python.syntax import parts_of

from .aliased_parameters import aliased_uses
from .base_arguments import declared_type
from .base_files import read_bases
from .whole_parameters import wholeness

_ACCESS = {
    "declare_parameter": ParameterAccess.DECLARE,
    "declare_parameters": ParameterAccess.DECLARE,
    "get_parameter": ParameterAccess.GET,
    "get_parameter_or": ParameterAccess.GET_OR,
    "has_parameter": ParameterAccess.HAS,
}
_LISTING = {
    "get_parameters": (Argument(0, "names"), ParameterAccess.GET),
    "set_parameters": (Argument(0, "parameter_list"), ParameterAccess.SET),
    "set_parameters_atomically": (Argument(0, "parameter_list"), ParameterAccess.SET),
}
"""The methods of a node that take a list of names, or of parameters, and refuse one of them."""

_ALLOWED = re.compile(
    rb"\b(?:allow_undeclared_parameters|automatically_declare_parameters_from_overrides)"
    rb"\s*=\s*(?!False\b)"
)
_MOST_NAMES = 200


def allows_undeclared(analysis: Analysis) -> bool:
    """Tell whether a file makes nodes that may have parameters which they do not declare.

    A class of another file that they derive from may say so, in whichever method makes the node.
    """
    if analysis.library.ros_version == 1:
        return False
    files = (analysis, *(each.file for each in read_bases(analysis) or ()))
    return any(_ALLOWED.search(each.syntax.text) is not None for each in files)


def parameter_facts(analysis: Analysis) -> Iterator[ParameterFacts]:
    """Yield what a file says of the parameters of each of its nodes, in their order."""
    if analysis.library.ros_version == 1:
        return
    parameters = [s for s in analysis.sites if s.endpoint.kind is EndpointKind.PARAMETER]
    makers = makers_of(analysis)
    owned = owned_sites(makers, replace(analysis, sites=parameters))
    for maker, sites in zip(makers, owned, strict=True):
        own = [each for each in sites if not _is_of_another(analysis, maker, each)]
        uses = list(_uses(analysis, own, ""))
        uses += _listed(analysis, maker)
        uses += aliased_uses(analysis, maker.owner) if maker.owner else ()
        for module, site in inherited_sites(analysis, maker.owner) if maker.owner else ():
            if site.endpoint.kind is EndpointKind.PARAMETER and module.package is not None:
                file = analysis.package.relative(module.package) if analysis.package else ""
                uses += _inherited(analysis, maker, module, site, file)
        is_known = all(u.name is not None for u in uses if u.access is ParameterAccess.DECLARE)
        is_whole, is_own = wholeness(analysis, maker) if is_known else (False, False)
        yield ParameterFacts(tuple(uses), is_whole, is_own, _takes_options(maker, analysis))


def _is_of_another(analysis: Analysis, maker: NodeSite, site: Site) -> bool:
    """Tell whether what is used may be a parameter of a node that an object was given.

    What declares may be meant for either, by another name.
    """
    if maker.owner is not None or maker.call is None or maker.call.parent is None:
        return False
    if any(_ACCESS.get(each) is ParameterAccess.DECLARE for each in site.shape.callees):
        return False
    made = maker.call.parent.child_by_field_name("left")
    callee = site.call.child_by_field_name("function")
    holder = None if callee is None else callee.child_by_field_name("object")
    if made is None or holder is None or {made.type, holder.type} != {"attribute"}:
        return False
    return analysis.syntax.slice(made) != analysis.syntax.slice(holder)


def _inherited(
    analysis: Analysis, maker: NodeSite, module: Analysis, site: Site, file: str
) -> Iterator[ParameterUse]:
    """Yield what a call of a base class says, with what the node's class gives to the base."""
    is_dynamic = b"dynamic_typing" in module.syntax.text
    for use in _uses(module, [site], file):
        is_open = use.access is ParameterAccess.DECLARE and use.type is None and not is_dynamic
        type_ = (
            declared_type(analysis, maker.owner, module, site) if maker.owner and is_open else None
        )
        yield use._replace(type=use.type if type_ is None else type_)


def _uses(analysis: Analysis, sites: Iterable[Site], file: str) -> Iterator[ParameterUse]:
    evaluator = Evaluator(analysis)
    is_dynamic = b"dynamic_typing" in analysis.syntax.text
    for site in sites:
        access = next((_ACCESS[each] for each in site.shape.callees if each in _ACCESS), None)
        if access is None:
            continue
        node = _name_node(analysis, site)
        span = site.endpoint.span if node is None else Span(node.start_byte, node.end_byte)
        is_guarded = _is_guarded(site.call)
        for name, type_ in _said(analysis, site, node, evaluator):
            known = type_ if access is ParameterAccess.DECLARE and not is_dynamic else None
            yield ParameterUse(access, name, span, file, known, is_guarded)


def _said(
    analysis: Analysis, site: Site, node: Node | None, evaluator: Evaluator
) -> Iterator[tuple[str | None, str | None]]:
    """Yield the names that a call gives, each with its type, None for what is not known."""
    if site.endpoint.name is not None:
        details = parameter_details(analysis, site, evaluator)
        name = None if site.endpoint.is_guess else site.endpoint.name
        yield name, None if details.is_guess else details.type
        return
    resolver = analysis.resolver
    is_listed = "declare_parameters" in site.shape.callees
    passes = [] if node is None or is_listed else resolver.passes(node, site.scope, site.call)
    if not passes:
        yield None, None
    for world in passes:
        with resolver.during(world):
            folded = resolver.fold(node, site.scope)
            details = parameter_details(analysis, site, Evaluator(analysis))
        value = folded.value if isinstance(folded, Known) else None
        yield (
            value if isinstance(value, str) else None,
            None if details.is_guess else details.type,
        )


def _name_node(analysis: Analysis, site: Site) -> Node | None:
    """Return what names the parameter of a call site."""
    given = site.arguments.get(site.shape.name)
    if given is None or "declare_parameters" not in site.shape.callees:
        return given
    for item in parts_of(given)[:_MOST_NAMES] if given.type in ("list", "tuple") else ():
        inner = parts_of(item)[0] if item.type == "tuple" and parts_of(item) else item
        if analysis.syntax.slice(inner) == site.endpoint.expression:
            return inner
    return None


class _Named(NamedTuple):
    """What names a parameter, and the scope that it stands in."""

    node: Node
    scope: Scope


def _listed(analysis: Analysis, maker: NodeSite) -> Iterator[ParameterUse]:
    """Yield what methods of the node itself get in a list."""
    if maker.owner is None:
        return
    classes = [maker.owner, *analysis.resolver.classes.bases(maker.owner)]
    for call in analysis.captures.get("call", []):
        said = _LISTING.get(analysis.syntax.called_name(call))
        callee = call.child_by_field_name("function")
        if said is None or callee is None or callee.type != "attribute":
            continue
        scope = analysis.scopes.at(call.start_byte)
        method = scope.enclosing("function")
        holder = analysis.syntax.slice(callee.child_by_field_name("object") or callee)
        if method is None or method.parent not in classes or holder != method.self_name:
            continue
        given = Arguments.of(call, analysis.syntax).get(said[0])
        for node in parts_of(given)[:_MOST_NAMES] if given and given.type == "list" else ():
            inner = node if said[1] is ParameterAccess.GET else _first(analysis, node)
            folded = analysis.resolver.fold(inner, scope) if inner is not None else None
            if inner is not None and isinstance(folded, Known) and isinstance(folded.value, str):
                span = Span(inner.start_byte, inner.end_byte)
                yield ParameterUse(said[1], folded.value, span, is_guarded=_is_guarded(call))


def _first(analysis: Analysis, node: Node) -> Node | None:
    """Return the name in `Parameter('x', …)`."""
    if analysis.syntax.called_name(node) != "Parameter":
        return None
    return Arguments.of(node, analysis.syntax).get(Argument(0, "name"))


def _is_guarded(call: Node) -> bool:
    """Tell whether a call stands where the code handles that it is refused, or asks before."""
    inner, outer = call, call.parent
    while outer is not None and outer.type not in ("function_definition", "module"):
        if outer.type == "try_statement" and inner == outer.child_by_field_name("body"):
            return True
        inner, outer = outer, outer.parent
    return False


def _takes_options(maker: NodeSite, analysis: Analysis) -> bool:
    """Tell whether who makes a node may say what it may have: its making hands arguments on."""
    return maker.call is not None and Arguments.of(maker.call, analysis.syntax).is_open
