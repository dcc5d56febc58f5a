"""Whether a function that the files have can be called by an endpoint.

Source: `ros/node_handle.h` of Noetic, `rclcpp/any_subscription_callback.hpp`,
`rclcpp/any_service_callback.hpp` and `rclcpp/create_timer.hpp` of Jazzy.
"""

from __future__ import annotations

import re

from plastron_tui.diagnostics import Span, codes, counted
from plastron_tui.model.source import EndpointKind
from plastron_tui.ros.interfaces import InterfaceName

from ..analysis import Analysis
from ..naming import is_name
from ..scopes import CppFile, Function
from .interfaces import refuse
from .place import Place

K = EndpointKind

# How many arguments a function may take, the usual number first.
_TAKEN = {
    (1, K.SUBSCRIPTION): (1,),
    (1, K.SERVICE): (2, 1),
    (1, K.TIMER): (1,),
    (2, K.SUBSCRIPTION): (1, 2),
    (2, K.SERVICE): (2, 3),
    (2, K.TIMER): (0, 1),
}

# What a function that is written calls.
_LOGGED = frozenset({"get_logger", "to_yaml"})


def check_callback(
    analysis: Analysis,
    kind: EndpointKind,
    function: Function,
    type_: InterfaceName | None,
    span: Span | None,
) -> None:
    """Refuse to let an endpoint call a function that does not take what it would be called with.

    Raises:
        RefusedError: it takes other arguments.
    """
    message = misfit(analysis, kind, function, type_)
    if message is not None:
        remedy = "name another function with `calling`"
        refuse(codes.INVALID_FUNCTION, message, span, remedy)


def check_new_name(analysis: Analysis, place: Place, name: str, span: Span | None) -> None:
    """Refuse to write a function under a name that stands for something else where it is called.

    Raises:
        RefusedError: it does.
    """
    message = None
    if not is_name(name):
        message = f"`{name}` cannot be a name in C++"
    elif analysis.unit.lookup(name, place.scope, place.offset) is not None:
        message = f"`{name}` is the name of a variable in the file"
    elif place.owner is not None and (name in _LOGGED or _is_called(place.owner.file, name)):
        message = f"the file calls a function `{name}` of another class"
    if message is not None:
        refuse(codes.INVALID_FUNCTION, message, span, "choose another name")


def _is_called(file: CppFile, name: str) -> bool:
    """Tell whether a file has a call that a method of a name would take from a base class."""
    pattern = rb"(?:(?<![\w.>:])|\bthis->)" + name.encode() + rb"\s*(?:<[^;(]*>\s*)?\("
    return re.search(pattern, file.syntax.code) is not None


def misfit(
    analysis: Analysis, kind: EndpointKind, function: Function, type_: InterfaceName | None
) -> str | None:
    """Return why an endpoint of a type cannot call a function, None where nothing is known of it.

    The others of its name are not looked at: several functions of a name fit or not, who knows.
    """
    same = {len(each.parameters) for each in analysis.unit.functions.get(function.name, ())}
    ways = _TAKEN.get((analysis.ros_version, kind))
    if ways is None or len(same) > 1:
        return None
    count = len(function.parameters)
    name = f"`{function.name}`"
    if count not in ways:
        return f"{name} takes {counted(count, 'argument')}, and would be called with {ways[0]}"
    if type_ is None or kind not in (K.SUBSCRIPTION, K.SERVICE):
        return None
    taken = function.parameters[0]
    found = analysis.types.interface(taken.type, function.scope or function.place, True)
    if found is None or found == type_:
        return None
    return f"{name} takes `{found}`, and would be called with `{type_}`"
