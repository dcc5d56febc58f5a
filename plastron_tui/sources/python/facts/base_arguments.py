"""What a class gives to the constructor of its base class of another file."""

from __future__ import annotations

import re
from inspect import Parameter

from tree_sitter import Node

from plastron_tui.sources.python.analysis import Analysis, Site
from plastron_tui.sources.python.arguments import Arguments
from plastron_tui.sources.python.calls import Argument
from plastron_tui.sources.python.evaluation import Evaluator
from plastron_tui.sources.python.positional import signature_of
from plastron_tui.sources.python.scopes import BindingKind, Scope

_VALUE = Argument(1, "value")
_CONSTRUCTOR = re.compile(rb"super\([^()]*\)\.__init__")
_BY_POSITION = frozenset({Parameter.POSITIONAL_ONLY, Parameter.POSITIONAL_OR_KEYWORD})


def declared_type(analysis: Analysis, owner: Scope, file: Analysis, site: Site) -> str | None:
    """Return the type of a parameter whose default the constructor of a base is given.

    Args:
        analysis: the file of the node.
        owner: the class of the node.
        file: the file of the base.
        site: the call in it that declares the parameter.
    """
    value = site.arguments.get(_VALUE)
    method = site.scope.enclosing("function")
    if value is None or value.type != "identifier" or method is None or method.name != "__init__":
        return None
    if not _is_base(analysis, owner, method.parent):
        return None
    name = file.syntax.slice(value)
    bindings = method.bindings.get(name, [])
    if [each.kind for each in bindings] != [BindingKind.PARAMETER]:
        return None
    call = _call_of_base(analysis, owner)
    arguments = None if call is None else Arguments.of(call, analysis.syntax)
    signature = signature_of(method, file.syntax)
    if call is None or arguments is None or arguments.is_open or signature is None:
        return None
    names = [each.name for each in signature.parameters.values() if each.kind in _BY_POSITION]
    position = names.index(name) if name in names else -1
    given = arguments.get(Argument(position, name))
    if given is not None:
        worth = Evaluator(analysis).evaluate(given, analysis.scopes.at(given.start_byte))
    else:
        worth = Evaluator(file).evaluate(bindings[0].value, method.parent or method)
    return None if worth.is_guess else worth.type


def _is_base(analysis: Analysis, owner: Scope, base: Scope | None) -> bool:
    """Tell whether a class derives from another one, directly and from nothing else."""
    if analysis.package is None or len(owner.bases) != 1:
        return False
    names = analysis.resolver.qualified(owner.bases[0], owner.parent or owner)
    held = analysis.package.class_(names[0]) if len(names) == 1 else None
    return held is not None and held[1] is base


def _call_of_base(analysis: Analysis, owner: Scope) -> Node | None:
    """Return the one call of a class of the constructor that it derives."""
    found = []
    for call in analysis.resolver.calls_of("__init__"):
        callee = call.child_by_field_name("function")
        method = analysis.scopes.at(call.start_byte).enclosing("function")
        is_own = method is not None and method.name == "__init__" and method.parent is owner
        if is_own and callee is not None and _CONSTRUCTOR.fullmatch(callee.text or b""):
            found.append(call)
    return found[0] if len(found) == 1 else None
