"""The function that a statement names with `calling`: whether the file has it, and it fits."""

from __future__ import annotations

import builtins
import math
from collections.abc import Iterator
from typing import NoReturn

from plastron_tui.diagnostics import codes, counted
from plastron_tui.model.source import EndpointKind

from . import literals
from .addition import Addition
from .functions import definition
from .messages import CannotAddError
from .place import place_behind
from .positional import bounds, signature_of, takes
from .scopes import Binding, BindingKind, Scope

_ANOTHER = "name another function with `calling`"


class NotCallableError(CannotAddError):
    """A function does not take what it would be called with, wherever the call stands."""


def existing_callback(added: Addition, wanted: str) -> str | None:
    """Return the source of a function that the file has, None for one that may be written.

    Raises:
        CannotAddError: the name means something else, or nothing yet where the call stands.
    """
    if not literals.is_name(wanted):
        _refuse(added, f"`{wanted}` cannot be a name in Python")
    owner = added.place.owner
    if owner is not None:
        attributes = list(_attributes(added, owner, wanted))
        _check_attribute(added, wanted, attributes)
        if attributes:
            return f"{added.place.self_name}.{wanted}"
    found = added.place.scope.lookup(wanted)
    if found is not None and any(each.kind is BindingKind.FUNCTION for each in found[1]):
        _stand_behind(added, wanted, *found)
        return wanted
    beside = _called_beside(added, wanted)
    if beside is not None:
        return beside
    _check_free(added, wanted, found[1] if found is not None else [])
    return None


def _called_beside(added: Addition, wanted: str) -> str | None:
    """Return the method of another object that an endpoint created before in the function calls."""
    module = added.analysis.scopes.module
    for site in added.analysis.sites:
        given = site.arguments.get(site.shape.callback) if site.shape.callback else None
        is_method = given is not None and given.type == "attribute"
        function = site.scope.enclosing("function") or module
        is_seen = function is added.place.scope and site.call.end_byte <= added.place.offset
        if given is not None and is_method and is_seen and site.endpoint.callback == wanted:
            return added.analysis.syntax.slice(given)
    return None


def check_parameters(added: Addition, callback: str) -> None:
    """Raise an error where the file's function does not take what it would be called with.

    Raises:
        NotCallableError: it takes fewer arguments, or more.
    """
    message = misfit(added, callback)
    if message is not None:
        raise NotCallableError(codes.INVALID_FUNCTION, message, added.endpoint.span, _ANOTHER)


def misfit(added: Addition, callback: str) -> str | None:
    """Return why the file's function cannot be called, None where it can, as far as is known.

    rospy calls a callback with a message, a request or a goal; rclpy calls that of a service with a
    response besides, that of a subscription with a `MessageInfo` besides where it takes two, and
    that of a timer with nothing.
    """
    function = _function(added, callback)
    signature = signature_of(function, added.analysis.syntax) if function is not None else None
    if signature is None:
        return None
    given = 2 if added.is_rclpy and added.kind is EndpointKind.SERVICE else 1
    is_action = added.kind is EndpointKind.ACTION_SERVER
    ways = {given, 2} if added.is_rclpy and not is_action else {given}
    if added.is_rclpy and added.kind is EndpointKind.TIMER:
        given, ways = 0, {0}
    given += len(added.handed)
    if any(takes(signature, each + len(added.handed)) for each in ways):
        return None
    least, most = bounds(signature)
    taken = least if least > given or most == math.inf else int(most)
    name = callback.rpartition(".")[2]
    return f"`{name}` takes {counted(taken, 'argument')}, and would be called with {given}"


def _function(added: Addition, callback: str) -> Scope | None:
    """Return the one function of the file that a callback is."""
    holder, _, name = callback.rpartition(".")
    owner = added.place.owner
    if holder and (owner is None or holder != added.place.self_name):
        return None
    if holder and owner is not None:
        found = list(_attributes(added, owner, name))
    else:
        visible = added.place.scope.lookup(name)
        found = visible[1] if visible is not None else []
    functions = [each for each in found if each.kind is BindingKind.FUNCTION]
    return functions[0].owner if len(found) == len(functions) == 1 else None


def _attributes(added: Addition, owner: Scope, name: str) -> Iterator[Binding]:
    """Yield what binds an attribute of a class's objects, in the classes around it as well."""
    classes = added.analysis.resolver.classes
    for scope in dict.fromkeys([owner, *classes.bases(owner), *classes.derived(owner)]):
        yield from scope.bindings.get(name, [])
        yield from scope.attributes.get(name, [])


def _check_attribute(added: Addition, wanted: str, attributes: list[Binding]) -> None:
    """Raise an error where an attribute holds something else than a method."""
    for each in attributes:
        if each.kind is not BindingKind.FUNCTION:
            _refuse(added, f"line {_line(each)} sets the attribute `{wanted}` to something else")
        if each.owner is not None and _is_property(added, each.owner):
            _refuse(added, f"`{wanted}` is a property, and no function that can be called")


def _is_property(added: Addition, function: Scope) -> bool:
    return any(
        "property" in added.analysis.syntax.slice(each)
        for each in definition(function).children
        if each.type == "decorator"
    )


def _stand_behind(added: Addition, wanted: str, scope: Scope, bindings: list[Binding]) -> None:
    """Go behind the definition of a function, which is not there before it."""
    place, first = added.place, bindings[0]
    is_later = all(each.node.start_byte >= place.offset for each in bindings)
    if scope is not place.scope or not is_later:
        return
    later = place_behind(added.analysis, place, first.node)
    if later is None:
        message = f"`{wanted}` is defined in line {_line(first)}, after the line that would use it"
        _refuse(added, message, f"move the definition up, or {_ANOTHER}")
    added.place = later
    added.stand(is_nested=True)


def _check_free(added: Addition, wanted: str, bindings: list[Binding]) -> None:
    """Raise an error where a function of a name would take the place of something else."""
    owner = added.place.owner
    for each in bindings:
        if each.kind is BindingKind.IMPORT:
            _refuse(added, f"`{wanted}` is imported in line {_line(each)}")
        if owner is None:
            _refuse(added, f"`{wanted}` is something else in line {_line(each)}")
    if not bindings and wanted in dir(builtins):
        _refuse(added, f"`{wanted}` is a name of Python itself")
    if owner is None:
        return
    if wanted.startswith("__") and wanted.endswith("__"):
        _refuse(added, f"`{wanted}` has a meaning of its own in Python")
    if wanted in added.dialect.method_names:
        _refuse(added, f"`{wanted}` is a method that every {added.dialect.library} node has")


def _line(binding: Binding) -> int:
    return int(binding.node.start_point.row) + 1


def _refuse(added: Addition, message: str, remedy: str = _ANOTHER) -> NoReturn:
    raise CannotAddError(codes.INVALID_FUNCTION, message, added.endpoint.span, remedy)
