"""Which message, or part of one, an expression of C++ is, as far as its declarations say it.

Sources: `rosidl_generator_cpp` of Jazzy, `gencpp` of Noetic for the classes of messages and the
pointers to them; `rclcpp/client.hpp`, `rclcpp_action/server_goal_handle.hpp`,
`rclcpp_action/client_goal_handle.hpp` for what requests and goals are got by.
"""

from __future__ import annotations

import re
from functools import cached_property
from typing import NamedTuple

from tree_sitter import Node

from plastron_tui.diagnostics import Span
from plastron_tui.model.code_facts import ITEM, MessageType, Part
from plastron_tui.model.source import EndpointKind
from plastron_tui.sources.cpp.analysis import Analysis, Site
from plastron_tui.sources.cpp.arguments import Call, call_of
from plastron_tui.sources.cpp.scopes import Scope, Variable, type_text
from plastron_tui.sources.cpp.type_texts import template_arguments, without_pointer

_FULL = ("msg::", "srv::", "action::")
_DEEPEST = 24
_PARTS = {
    "Request": Part.REQUEST,
    "Response": Part.RESPONSE,
    "Goal": Part.GOAL,
    "Result": Part.RESULT,
    "Feedback": Part.FEEDBACK,
}
_PART = re.compile(r"::(Request|Response|Goal|Result|Feedback)\Z")
_PART_OF_ROS1 = re.compile(r"(.+\w)(Request|Response|Goal|Result|Feedback)\Z")
_ELEMENTS = re.compile(r"(?:std|boost)::(?:vector|array|list|deque)<(.+)>")
_ONE_OF = frozenset({"at", "front", "back"})
_MAKERS = frozenset({"make_shared", "make_unique", "allocate_shared"})
_SAME = frozenset({"move", "ref", "cref", "forward", "as_const"})
_RESPONSES = re.compile(
    r"(?:rclcpp::Client<(.+)>)::(?:SharedFuture|SharedFutureWithRequest|FutureAndRequestId|Future)"
)
_GOAL_HANDLES = re.compile(r"rclcpp_action::(?:Server|Client)GoalHandle<(.+)>")
_RESULTS = re.compile(r"rclcpp_action::ClientGoalHandle<(.+)>::WrappedResult")


class Reach(NamedTuple):
    """A message, or what a path of fields leads to in one.

    Attributes:
        type: the type of the message.
        path: the names of the fields that lead there, with `ITEM` for an index.
        spans: where the names stand.
        is_list: whether it is a list of such messages that no field has.
    """

    type: MessageType
    path: tuple[str, ...] = ()
    spans: tuple[Span, ...] = ()
    is_list: bool = False

    @property
    def element(self) -> Reach | None:
        """What an element of it is, None for what is no list."""
        if self.is_list:
            return self._replace(is_list=False)
        return self._replace(path=(*self.path, ITEM)) if self.path else None

    @property
    def names(self) -> tuple[str, ...]:
        """The path without indices."""
        return tuple(each for each in self.path if each != ITEM)

    def field(self, name: str, span: Span) -> Reach | None:
        """Return what a field of it is, None for what has none."""
        if self.is_list:
            return None
        is_of_service = self.type.part is Part.MESSAGE and name in ("request", "response")
        if is_of_service and not self.path:
            # The class of a service in ROS 1 has its two messages.
            return Reach(self.type._replace(part=_PARTS[name.capitalize()]))
        return self._replace(path=(*self.path, name), spans=(*self.spans, span))


class MessageTypes:
    """The messages of a unit, by expression; each is looked for once."""

    def __init__(self, analysis: Analysis) -> None:
        self._a = analysis
        self._unit = analysis.unit
        self._by_node: dict[tuple[int, int], Reach | None] = {}
        self._by_variable: dict[Variable, Reach | None] = {}
        self._by_text: dict[str, Reach | None] = {}
        self._depth = 0

    def of(self, node: Node | None, scope: Scope) -> Reach | None:
        """Return what an expression is, None where that is no message, or not sure."""
        if node is None or self._depth > _DEEPEST:
            return None
        key = id(scope.file), node.id
        if key not in self._by_node:
            self._by_node[key] = None
            self._depth += 1
            self._by_node[key] = self._of(node, scope)
            self._depth -= 1
        return self._by_node[key]

    def _of(self, node: Node, scope: Scope) -> Reach | None:
        syntax = scope.file.syntax
        match node.type:
            case "identifier":
                variable = self._unit.lookup(syntax.word(node), scope, node.start_byte)
                return None if variable is None else self.of_variable(variable)
            case "field_expression":
                return self._field(node, scope)
            case "pointer_expression":
                return self.of(node.child_by_field_name("argument"), scope)
            case "parenthesized_expression":
                inner = node.named_children
                return self.of(inner[0], scope) if len(inner) == 1 else None
            case "subscript_expression":
                listed = self.of(node.child_by_field_name("argument"), scope)
                return None if listed is None else listed.element
            case "compound_literal_expression" | "new_expression":
                made = node.child_by_field_name("type")
                return None if made is None else self.of_type(syntax.word(made), scope)
            case "call_expression":
                call = call_of(node, scope, syntax)
                return None if call is None else self._called(call)
            case _:
                return None

    def _field(self, node: Node, scope: Scope) -> Reach | None:
        holder, inner = node.child_by_field_name("argument"), node.child_by_field_name("field")
        if holder is None or inner is None or inner.type != "field_identifier":
            return None
        outer = None if holder.type == "this" else self.of(holder, scope)
        if outer is not None:
            name = scope.file.syntax.word(inner)
            return outer.field(name, Span(inner.start_byte, inner.end_byte))
        if (result := self._wrapped_result(holder, inner, scope)) is not None:
            return result
        member = self._a.receivers.member(node, scope)
        return None if member is None else self.of_variable(member)

    def _wrapped_result(self, holder: Node, inner: Node, scope: Scope) -> Reach | None:
        """Return what `result.result` is, of what an action client's callback gets."""
        if scope.file.syntax.word(inner) != "result" or holder.type != "identifier":
            return None
        name = scope.file.syntax.word(holder)
        variable = self._unit.lookup(name, scope, holder.start_byte)
        found = None if variable is None else _RESULTS.fullmatch(self._plain(variable))
        return None if found is None else self._part(found[1], Part.RESULT, scope)

    def _plain(self, variable: Variable) -> str:
        text = self._a.types.expand(variable.type, variable.scope)
        return self._a.types.expand(without_pointer(text), variable.scope)

    def _called(self, call: Call) -> Reach | None:
        scope, syntax = call.scope, call.scope.file.syntax
        if call.receiver is not None:
            return self._method(call)
        if call.name in _MAKERS:
            made = call.type_nodes
            return self.of_type(syntax.word(made[0]), scope) if made else None
        if call.name in _SAME and call.qualifier in ("std", "boost"):
            return self.of(call.argument(0), scope)
        functions = self._unit.functions.get(call.name, ())
        if functions:
            returned = {each.return_type for each in functions}
            text = returned.pop() if len(returned) == 1 else ""
            return None if text in ("", "auto") else self.of_type(text, functions[0].place)
        # What is called like a type makes one.
        made_text = call.qualified
        if call.template is not None or self._unit.lookup(call.name, scope, call.node.start_byte):
            return None
        return self.of_type(made_text, scope)

    def _method(self, call: Call) -> Reach | None:
        """Return an element of a list, or the message that a handle, or a future, has."""
        if call.name in _ONE_OF:
            listed = self.of(call.receiver, call.scope)
            return None if listed is None else listed.element
        if call.name not in ("get", "get_goal") or call.arguments or call.receiver is None:
            return None
        if call.receiver.type != "identifier":
            return None
        name = call.scope.file.syntax.word(call.receiver)
        variable = self._unit.lookup(name, call.scope, call.receiver.start_byte)
        if variable is None:
            return None
        text = self._plain(variable)
        if call.name == "get_goal":
            handle = _GOAL_HANDLES.fullmatch(text)
            return None if handle is None else self._part(handle[1], Part.GOAL, variable.scope)
        future = _RESPONSES.fullmatch(text)
        if future is None or "WithRequest" in text:
            return None
        return self._part(future[1], Part.RESPONSE, variable.scope)

    def _part(self, text: str, part: Part, scope: Scope) -> Reach | None:
        name = self._a.types.interface(text, scope)
        return None if name is None else Reach(MessageType(name, part))

    def of_variable(self, variable: Variable) -> Reach | None:
        """Return what a variable is, None where that is no message, or not sure."""
        if variable not in self._by_variable:
            self._by_variable[variable] = None
            self._by_variable[variable] = self._of_variable(variable)
        return self._by_variable[variable]

    def _of_variable(self, variable: Variable) -> Reach | None:
        if variable.type not in ("auto", ""):
            found = self.of_type(variable.type, variable.scope)
            is_list = found is not None and variable.is_array
            return found._replace(is_list=True) if found is not None and is_list else found
        if variable.kind == "loop":
            listed = self.of(variable.value, variable.scope)
            return None if listed is None else listed.element
        if variable.kind == "parameter":
            return self._given.get(variable)
        if variable.value is not None:
            return self.of(variable.value, variable.scope)
        given = variable.arguments or []
        return self.of(given[0], variable.scope) if len(given) == 1 else None

    def of_type(self, text: str, scope: Scope) -> Reach | None:
        """Return what a value of a type, a pointer to one or a list of them is."""
        text = type_text(text)
        first, _, rest = text.partition("::")
        if not rest.startswith(_FULL) or self._a.types.may_be(first, ()):
            return self._of_type(text, scope)
        # It means the same wherever it stands.
        if text not in self._by_text:
            self._by_text[text] = self._of_type(text, scope)
        return self._by_text[text]

    def _of_type(self, text: str, scope: Scope) -> Reach | None:
        if self._a.types.is_parameter(text, scope):
            return None
        for _ in range(6):
            text = self._a.types.expand(text, scope)
            bare = without_pointer(text)
            if bare == text:
                break
            text = bare
        if (listed := _ELEMENTS.fullmatch(text)) is not None:
            inner = self.of_type(template_arguments(listed[1])[0], scope)
            return None if inner is None or inner.is_list else inner._replace(is_list=True)
        if "<" in text or not text:
            return None
        part = Part.MESSAGE
        if (found := _PART.search(text)) is not None:
            part, text = _PARTS[found[1]], text[: found.start()]
            if part in (Part.GOAL, Part.RESULT, Part.FEEDBACK) and self._a.ros_version == 1:
                return None
        name = self._a.types.interface(text, scope)
        if name is None:
            return None
        if self._a.ros_version == 1 and part is Part.MESSAGE:
            short = _PART_OF_ROS1.fullmatch(name.name)
            if short is not None and self._is_part(name.package, short[1], short[2]):
                return Reach(MessageType(name._replace(name=short[1]), _PARTS[short[2]]))
        return Reach(MessageType(name, part))

    def _is_part(self, package: str, name: str, part: str) -> bool:
        """Tell whether a class of ROS 1 is a part of a service, or of an action.

        Messages have such names too: the headers that are included tell.
        """
        if f"{package}/{name}{part}.h" in self._included:
            return False
        whole = name if part in ("Request", "Response") else f"{name}Action"
        return f"{package}/{whole}.h" in self._included

    @cached_property
    def _included(self) -> frozenset[str]:
        files = self._unit.files
        return frozenset(each.path for file in files for each in file.syntax.includes)

    @cached_property
    def _given(self) -> dict[Variable, Reach]:
        """What lambdas get whose parameters are `auto`: what their endpoints give them."""
        found: dict[Variable, Reach] = {}
        lambdas = {
            (id(file), scope.node.id): scope
            for file in self._unit.files
            for scope in file.scopes
            if scope.kind == "lambda"
        }
        for site in self._a.sites:
            at = site.shape.callback
            if site.endpoint.type is None or at is None or at >= len(site.arguments):
                continue
            scope = lambdas.get((id(site.place.file), site.arguments[at].id))
            function = None if scope is None else scope.function
            for position, parameter in enumerate(function.parameters if function else ()):
                part = _given_part(site, position)
                if parameter.type == "auto" and part is not None and not site.endpoint.is_guess:
                    found[parameter] = Reach(MessageType(site.endpoint.type, part))
        return found


def _given_part(site: Site, position: int) -> Part | None:
    """Return which message a callback gets in a position."""
    if site.endpoint.kind is EndpointKind.SUBSCRIPTION:
        return Part.MESSAGE if position == 0 else None
    if site.endpoint.kind is EndpointKind.SERVICE and position < 2:
        return Part.RESPONSE if position else Part.REQUEST
    return None
