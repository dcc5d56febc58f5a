"""Which messages the callbacks of a file get, by the positions of their parameters.

Sources: `rclpy.subscription`, `rclpy.service` and `rclpy.action` of Jazzy; `rospy.topics`,
`rospy.impl.tcpros_service` and `actionlib` of Noetic.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import NamedTuple

from tree_sitter import Node

from plastron_tui.model.code_facts import ITEM, MessageType, Part
from plastron_tui.model.endpoint_details import ActionDetails
from plastron_tui.model.kinds import EndpointKind
from plastron_tui.ros.interfaces import InterfaceName
from plastron_tui.sources.python.action_callbacks import action_details
from plastron_tui.sources.python.analysis import Analysis, Site
from plastron_tui.sources.python.arguments import Arguments
from plastron_tui.sources.python.callbacks import callback_target
from plastron_tui.sources.python.calls import ACTIONS, Argument
from plastron_tui.sources.python.handed_on import handed_by_partial
from plastron_tui.sources.python.references import function_of
from plastron_tui.sources.python.scopes import BindingKind, Scope
from plastron_tui.sources.python.syntax import holders

from .synchronized import made_by, synchronized


class Held(NamedTuple):
    """A message, or what it has at a path.

    Attributes:
        type: the type of the message.
        path: the names of the fields.
        behind: the attribute that has it, for an object that only holds it: the handle of a goal
            has the goal in `request`.
        is_said: whether only an annotation says it, which may be wrong.
    """

    type: MessageType
    path: tuple[str, ...] = ()
    behind: str = ""
    is_said: bool = False

    def attribute(self, name: str) -> tuple[Held, ...]:
        """Return what an attribute of it is."""
        if self.behind:
            return (self._replace(behind=""),) if name == self.behind else ()
        return (self._replace(path=(*self.path, name)),)


Helds = tuple[Held, ...]
"""What an expression may be, one or another of them; none where it may be something else."""

_MOST_OTHERS = 4
_Given = tuple[tuple[Part, str], ...]

_RCLPY: dict[EndpointKind, _Given] = {
    EndpointKind.SUBSCRIPTION: ((Part.MESSAGE, ""),),
    EndpointKind.SERVICE: ((Part.REQUEST, ""), (Part.RESPONSE, "")),
    EndpointKind.ACTION_SERVER: ((Part.GOAL, "request"),),
}
_ROSPY: dict[EndpointKind, _Given] = {
    EndpointKind.SUBSCRIPTION: ((Part.MESSAGE, ""),),
    EndpointKind.SERVICE: ((Part.REQUEST, ""),),
}
_SIMPLE_SERVER = "actionlib.SimpleActionServer"

_DETAILS: dict[int, dict[str, tuple[int, Part, str]]] = {
    1: {"feedback": (0, Part.FEEDBACK, ""), "result": (1, Part.RESULT, "")},
    2: {"goal": (0, Part.GOAL, ""), "feedback": (0, Part.FEEDBACK, "feedback")},
}
"""What other functions of actions get, by their part in it: the position, and the message."""

_SENDING: dict[int, dict[str, tuple[tuple[Argument, tuple[int, Part, str]], ...]]] = {
    1: {
        "send_goal": (
            (Argument(1, "done_cb"), (1, Part.RESULT, "")),
            (Argument(3, "feedback_cb"), (0, Part.FEEDBACK, "")),
        )
    },
    2: {
        name: ((Argument(position, "feedback_callback"), (0, Part.FEEDBACK, "feedback")),)
        for name, position in {"send_goal_async": 1, "send_goal": -1}.items()
    },
}
"""The same of the functions that are handed on with a goal."""


def merged(found: Iterable[Helds]) -> Helds:
    """Return all that something may be, nothing where one of the ways is not known."""
    all_of_them: dict[Held, None] = {}
    for each in found:
        if not each:
            return ()
        all_of_them |= dict.fromkeys(each)
    return tuple(all_of_them) if len(all_of_them) <= _MOST_OTHERS else ()


def items(holders: Helds) -> Helds:
    """Return the elements of lists."""
    return merged(each.attribute(ITEM) for each in holders)


def handed_messages(analysis: Analysis) -> dict[int, dict[int, tuple[Held, ...]]]:
    """Return what the functions that are callbacks get, by their nodes and by position."""
    found: dict[int, dict[int, tuple[Held, ...]]] = {}
    for function, position, held in _handed(analysis):
        parent = function.node.parent
        if parent is not None and parent.type == "decorated_definition":
            continue
        known = found.setdefault(function.node.id, {})
        before = known.get(position)
        if held is None or before == ():
            # One of the calls hands on what is not known.
            known[position] = ()
        else:
            known[position] = tuple(dict.fromkeys((*(before or ()), held)))
    return found


def sure_types(analysis: Analysis) -> dict[int, InterfaceName]:
    """Return the types of endpoints, by the calls that create them, as far as they are sure.

    A type that a parameter of a function or an attribute of an object says is another one for
    another caller, or in a class of another file that derives from it.
    """
    found: dict[int, set[InterfaceName | None]] = {}
    for site in analysis.sites:
        is_sure = _names_type(analysis, site)
        found.setdefault(site.call.id, set()).add(site.endpoint.type if is_sure else None)
    alone = {call: next(iter(types)) for call, types in found.items() if len(types) == 1}
    return {call: type_ for call, type_ in alone.items() if type_ is not None}


def _names_type(analysis: Analysis, site: Site) -> bool:
    """Whether a call names a type by what the file imports or defines."""
    is_guess = site.endpoint.is_guess
    given = site.arguments.get(site.shape.type) if site.shape.type is not None else None
    if given is None or given.type not in ("identifier", "attribute"):
        return not is_guess
    base = (holders(given) or [given])[-1]
    found = site.scope.lookup(analysis.syntax.slice(base))
    if found is None:
        return not is_guess
    if found[0].self_name == analysis.syntax.slice(base):
        return False
    if is_guess:
        # The name of the topic may be one, and the type is imported by its own name.
        return all(each.kind is BindingKind.IMPORT for each in found[1]) and len(found[1]) == 1
    return all(each.kind is not BindingKind.PARAMETER for each in found[1])


def _handed(analysis: Analysis) -> Iterator[tuple[Scope, int, Held | None]]:
    types = sure_types(analysis)
    for site in analysis.sites:
        function, before = _callback(analysis, site)
        if function is None:
            continue
        for position, (part, behind) in enumerate(_given(analysis, site)):
            yield function, before + position, _held(types, site, part, behind)
    sites = {site.call.id: site for site in analysis.first_sites()}
    for site in sites.values():
        if site.endpoint.kind in ACTIONS:
            named = _functions_named(analysis, action_details(analysis, site, with_uses=True))
            for function, (position, part, behind) in named:
                yield function, position, _held(types, site, part, behind)
    for function, position, subscriber in synchronized(analysis, sites):
        yield function, position, _held(types, subscriber, Part.MESSAGE, "")
    for call in analysis.captures.get("call", []):
        sent = _SENDING[analysis.library.ros_version].get(analysis.syntax.called_name(call))
        if sent is None:
            continue
        callee = call.child_by_field_name("function")
        receiver = callee.child_by_field_name("object") if callee is not None else None
        made = made_by(analysis, receiver) if receiver is not None else None
        client = sites.get(made.id) if made is not None else None
        arguments = Arguments.of(call, analysis.syntax)
        for argument, (position, part, behind) in sent:
            given = function_of(node, analysis) if (node := arguments.get(argument)) else None
            if given is not None:
                yield given, position, _held(types, client, part, behind)


def _held(
    types: dict[int, InterfaceName], site: Site | None, part: Part, behind: str
) -> Held | None:
    type_ = types.get(site.call.id) if site is not None else None
    return None if type_ is None else Held(MessageType(type_, part), (), behind)


def _functions_named(
    analysis: Analysis, details: ActionDetails
) -> Iterator[tuple[Scope, tuple[int, Part, str]]]:
    """Yield the functions of the file that have the names which an action has called."""
    for what, given in _DETAILS[analysis.library.ros_version].items():
        name = getattr(details, what)
        functions = [each for each in analysis.scopes.all if each.name == name and name]
        if len(functions) == 1 and functions[0].kind == "function":
            yield functions[0], given


def _given(analysis: Analysis, site: Site) -> _Given:
    kind = site.endpoint.kind
    if analysis.library.ros_version == 2:
        return _RCLPY.get(kind, ())
    if kind is EndpointKind.ACTION_SERVER:
        return ((Part.GOAL, ""),) if _SIMPLE_SERVER in site.shape.callees else ()
    return _ROSPY.get(kind, ())


def _callback(analysis: Analysis, site: Site) -> tuple[Scope | None, int]:
    """Return the function that a call site has called, and what it gets before the message."""
    if site.shape.callback is None:
        return None, 0
    return callback_function(analysis, site, site.arguments.get(site.shape.callback))


def callback_function(
    analysis: Analysis, site: Site, given: Node | None
) -> tuple[Scope | None, int]:
    """Return the function of the file that a callback is, and how much it gets before its own."""
    if given is None:
        return None, 0
    if given.type == "lambda":
        return next((each for each in analysis.scopes.all if each.node.id == given.id), None), 0
    if given.type == "call":
        wrapped = handed_by_partial(analysis, site, given)
        if wrapped is None:
            return None, 0
        function, more = wrapped
        return function_of(function, analysis), len(more.before)
    target = callback_target(given, site.scope, analysis)
    if target is not None and target.id != given.id:
        # A name that a partial was given to: what that hands on is not looked up.
        return None, 0
    return function_of(given, analysis), 0
