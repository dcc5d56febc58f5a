"""What the objects are whose methods a file calls, and in which namespace a node handle is.

Source: `ros/node_handle.h` of Noetic: a handle of `"~"` is the node's own namespace, one made of
another handle is in that handle's namespace; `nodelet/nodelet.h`: `getPrivateNodeHandle`.
"""

from __future__ import annotations

import re
from typing import NamedTuple

from tree_sitter import Node

from plastron_tui.sources.work_limits import bounded

from .arguments import Call, arguments_of, call_of
from .callers import Callers
from .scopes import Scope, Variable, type_text
from .type_texts import template_arguments, without_pointer
from .types import Types
from .unit import Unit, bound_calls
from .values import MOST_WRITES, Evaluator

NODE_CLASSES = frozenset(
    {
        "rclcpp::Node",
        "rclcpp_lifecycle::LifecycleNode",
        "nav2_util::LifecycleNode",
        "rclcpp::node::Node",
    }
)
_PARTS = {
    **dict.fromkeys(("get_node", "getNode"), "rclcpp::Node"),
    "get_node_parameters_interface": "rclcpp::node_interfaces::NodeParametersInterface",
}
MANAGED_CLASSES = frozenset({"rclcpp_lifecycle::LifecycleNode", "nav2_util::LifecycleNode"})
NODELET = "nodelet::Nodelet"
HANDLE = "ros::NodeHandle"
TRANSPORT = "image_transport::ImageTransport"
_NODELET_HANDLES = {
    "getNodeHandle": "",
    "getMTNodeHandle": "",
    "getPrivateNodeHandle": "~",
    "getMTPrivateNodeHandle": "~",
}
_NODE_TYPE = re.compile(r"(?:.*::)?\w*Node(?:T|Type|Class)?")
_ELEMENT = re.compile(
    r"(?:std|boost)::(?:vector|array|list|deque|set|unordered_set|initializer_list)<(.+)>"
)
_MAP = re.compile(r"(?:std|boost)::(?:unordered_)?map<(.+)>")
_PRIVATE = re.compile(
    r".*(?:priv|local|self).*|p_?nh.*|n_?h_?p_?|np_?|pn_?|ph_?|nh_?_?p\w?_?", re.I
)
_SAME_OBJECT = frozenset({"get", "lock", "value", "shared_from_this", "getRef"})
_POINTER_CASTS = frozenset(
    {"static_pointer_cast", "dynamic_pointer_cast", "const_pointer_cast", "static_cast"}
)


class Prefix(NamedTuple):
    """The namespace of a node handle.

    Attributes:
        text: the namespace, `~` for the node's own one, None where it is not known.
        is_guess: whether it is that of a handle that another file makes.
    """

    text: str | None
    is_guess: bool = False

    def joined(self, name: str) -> str | None:
        """Return a name as the handle resolves it, None where that is not known."""
        return joined(self.text, name)


def joined(prefix: str | None, name: str) -> str | None:
    """Return a name in a namespace."""
    if name.startswith("/"):
        return name
    if prefix is None:
        return None
    if name.startswith("~"):
        name = name[1:].lstrip("/")
        return f"~/{name}" if name else "~"
    if not prefix:
        return name
    return f"{prefix.rstrip('/')}/{name}" if name else prefix


class Receivers:
    """The objects of a unit, by expression."""

    def __init__(self, unit: Unit, types: Types, evaluator: Evaluator, callers: Callers) -> None:
        self._unit = unit
        self._types = types
        self._evaluator = evaluator
        self._callers = callers
        self.effort = unit.effort

    @bounded("")
    def type_of(self, node: Node | None, scope: Scope) -> str:
        """Return the type of an expression, without pointers; "" where it is not known."""
        if node is None:
            return ""
        syntax = scope.file.syntax
        match node.type:
            case "this":
                owner = self._unit.class_of(scope)
                return owner.qualified if owner is not None else ""
            case "identifier" | "field_identifier" | "type_identifier":
                name = syntax.word(node)
                variable = self._unit.lookup(name, scope, node.start_byte)
                return self.type_of_variable(variable) if variable is not None else ""
            case "field_expression":
                member = self.member(node, scope)
                return self.type_of_variable(member) if member is not None else ""
            case "pointer_expression" | "parenthesized_expression" | "cast_expression":
                inner = node.child_by_field_name("argument") or node.child_by_field_name("value")
                if inner is None and node.named_child_count:
                    inner = node.named_children[-1]
                return self.type_of(inner, scope)
            case "subscript_expression":
                outer = self.type_of(node.child_by_field_name("argument"), scope)
                return self._element(outer, scope)
            case "new_expression" | "compound_literal_expression":
                type_node = node.child_by_field_name("type")
                return self.plain(type_text(syntax.word(type_node)), scope) if type_node else ""
            case "call_expression":
                call = call_of(node, scope, syntax)
                return self._type_of_call(call) if call is not None else ""
            case "parameter_declaration":
                return HANDLE if _parsed_call(node, scope) in _NODELET_HANDLES else ""
            case _:
                return ""

    def member(self, node: Node, scope: Scope) -> Variable | None:
        """Return the member that `a.b` or `a->b` names, None where the type of `a` is not known."""
        holder = node.child_by_field_name("argument")
        inner = node.child_by_field_name("field")
        if holder is None or inner is None:
            return None
        if holder.type == "this":
            owner = self._unit.class_of(scope)
        else:
            owner = self._unit.find_class(self.type_of(holder, scope), scope)
        name = scope.file.syntax.word(inner)
        return self._unit.member(owner, name) if owner is not None else None

    def _element(self, container: str, scope: Scope) -> str:
        if found := _ELEMENT.fullmatch(container):
            return self.plain(template_arguments(found[1])[0], scope)
        if found := _MAP.fullmatch(container):
            return self.plain(template_arguments(found[1])[-1], scope)
        return ""

    def type_of_variable(self, variable: Variable) -> str:
        """Return the type of a variable, without pointers."""
        written = variable.type
        if written in ("auto", ""):
            if variable.kind == "loop":
                return self._element(self.type_of(variable.value, variable.scope), variable.scope)
            if variable.value is not None:
                return self.type_of(variable.value, variable.scope)
            given = variable.arguments or []
            return self.type_of(given[0], variable.scope) if len(given) == 1 else ""
        found = self.plain(written, variable.scope)
        owner = self._unit.find_class(found, variable.scope)
        for arrow in owner.functions.get("operator->", ()) if owner is not None else ():
            # A class of one's own that stands for a pointer.
            return self.plain(arrow.return_type, arrow.place)
        return found

    def plain(self, text: str, scope: Scope) -> str:
        """Return a type as it is written without aliases and pointers."""
        found = self._types.expand(text, scope)
        for _ in range(4):
            bare = without_pointer(found)
            if bare == found:
                break
            found = self._types.expand(bare, scope)
        return found

    def _type_of_call(self, call: Call) -> str:
        name, scope = call.name, call.scope
        syntax = scope.file.syntax
        if name in _NODELET_HANDLES:
            return HANDLE
        if call.type_nodes and name.startswith(("make_", "allocate_")):
            return self.plain(type_text(syntax.word(call.type_nodes[0])), scope)
        if call.type_nodes and name in _POINTER_CASTS:
            return self.plain(type_text(syntax.word(call.type_nodes[0])), scope)
        if name == "make_shared" and call.qualifier:
            return self.plain(call.qualifier, scope)
        if name in _SAME_OBJECT and call.receiver is not None:
            return self.type_of(call.receiver, scope)
        if name == "shared_from_this":
            owner = self._unit.class_of(scope)
            return owner.qualified if owner is not None else ""
        if name in ("move", "ref", "cref") and len(call.arguments) == 1:
            return self.type_of(call.arguments[0], scope)
        if name in ("at", "front", "back") and call.receiver is not None:
            return self._element(self.type_of(call.receiver, scope), scope)
        if call.receiver is None:
            made = self.plain(call.qualified, scope)
            if made == HANDLE or made in NODE_CLASSES or self._unit.find_class(made, scope):
                return made
            if call.template is not None:
                return self.plain(made + "".join(syntax.word(call.template).split()), scope)
        functions = self._unit.functions.get(name, [])
        returned = {each.return_type for each in functions}
        if len(returned) == 1 and (text := returned.pop()) not in ("auto", "void", ""):
            return self.plain(text, functions[0].place)
        if name in _PARTS and (call.receiver is None or not functions):
            return _PARTS[name]
        return self.plain(call.qualified, scope) if call.qualifier and not functions else ""

    def is_node(self, type_: str, scope: Scope) -> bool:
        """Whether a type is a node of ROS 2."""
        if type_ in NODE_CLASSES or type_ in _PARTS.values():
            return True
        owner = self._unit.find_class(type_, scope)
        if owner is not None:
            return self.is_node_class(owner)
        return _NODE_TYPE.fullmatch(type_.partition("<")[0]) is not None

    def is_node_class(self, owner: Scope) -> bool:
        """Whether objects of a class of the files are nodes of ROS 2, as far as is known."""
        for base in self._unit.foreign_bases(owner):
            found = self._types.expand(base, owner)
            name = found.partition("<")[0]
            if name in NODE_CLASSES or name.removesuffix("Base").endswith("Node"):
                return True
            if found == "Node" or self._types.is_parameter(found, owner):
                return True
        return False

    def derives_from(self, owner: Scope, names: frozenset[str]) -> bool:
        """Whether a class derives from one of some of other packages."""
        found = (
            self._types.expand(base, owner).partition("<")[0]
            for base in self._unit.foreign_bases(owner)
        )
        # Packages have lifecycle nodes of their own, and call them so.
        is_managed = names is MANAGED_CLASSES
        return any(
            each in names or (is_managed and each.endswith("::LifecycleNode")) for each in found
        )

    @bounded(Prefix(None))
    def prefix(self, node: Node | None, scope: Scope) -> Prefix:
        """Return the namespace of a node handle."""
        if node is None:
            return Prefix("")
        syntax = scope.file.syntax
        match node.type:
            case "identifier" | "field_identifier" | "type_identifier":
                name = syntax.word(node)
                variable = self._unit.lookup(name, scope, node.start_byte)
                if variable is None:
                    return Prefix("~" if _PRIVATE.fullmatch(name) else "", True)
                return self._prefix_of_variable(variable)
            case "field_expression":
                member = self.member(node, scope)
                if member is None:
                    inner = node.child_by_field_name("field")
                    name = syntax.word(inner) if inner is not None else ""
                    return Prefix("~" if _PRIVATE.fullmatch(name) else "", True)
                return self._prefix_of_variable(member)
            case "pointer_expression" | "parenthesized_expression":
                inner = node.child_by_field_name("argument")
                if inner is None and node.named_child_count:
                    inner = node.named_children[-1]
                return self.prefix(inner, scope)
            case "new_expression":
                return self._prefix_of(arguments_of(node.child_by_field_name("arguments")), scope)
            case "compound_literal_expression":
                return self._prefix_of(arguments_of(node.child_by_field_name("value")), scope)
            case "call_expression":
                call = call_of(node, scope, syntax)
                return self._prefix_of_call(call) if call is not None else Prefix(None)
            case "parameter_declaration":
                return Prefix(_NODELET_HANDLES.get(_parsed_call(node, scope)))
            case _:
                return Prefix(None)

    def _prefix_of_call(self, call: Call) -> Prefix:
        if call.name in _NODELET_HANDLES:
            return Prefix(_NODELET_HANDLES[call.name])
        if call.name in _SAME_OBJECT and call.receiver is not None:
            return self.prefix(call.receiver, call.scope)
        if call.name in ("move", "ref", "cref") and len(call.arguments) == 1:
            return self.prefix(call.arguments[0], call.scope)
        if call.receiver is None and self._type_of_call(call) in (HANDLE, TRANSPORT):
            functions = self._unit.functions.get(call.name, ())
            if not functions:
                return self._prefix_of(call.arguments, call.scope)
        return Prefix("~" if _PRIVATE.fullmatch(call.name) else "", True)

    def _prefix_of(self, given: list[Node], scope: Scope) -> Prefix:
        """Return the namespace of a handle by what its constructor gets."""
        if not given:
            return Prefix("")
        first = given[0]
        if self._is_handle(first, scope):
            outer = self.prefix(first, scope)
            if len(given) == 1:
                return outer
            name = self._evaluator.fold(given[1], scope)
            if name is None or name.text is None or name.is_default:
                return Prefix(None)
            return Prefix(joined(outer.text, name.text), outer.is_guess or name.is_guess)
        name = self._evaluator.fold(first, scope)
        if name is None or name.text is None or name.is_default:
            return Prefix(None)
        text = name.text
        return Prefix(joined("", text) if text.startswith("~") else text, name.is_guess)

    def _is_handle(self, node: Node, scope: Scope) -> bool:
        return self.type_of(node, scope) == HANDLE

    def _prefix_of_variable(self, variable: Variable) -> Prefix:
        guess = Prefix("~" if _PRIVATE.fullmatch(variable.name) else "", True)
        if variable.kind == "parameter":
            return self._given(variable, guess)
        if variable.kind == "loop":
            return Prefix(None)
        writes = self._unit.writes(variable)
        if len(writes) > 1:
            # A pointer is empty before it gets something to point to.
            writes = [each for each in writes if each.arguments or each.value is not None]
        found = []
        for write in writes[:MOST_WRITES]:
            if write.arguments is not None:
                found.append(self._prefix_of(write.arguments, write.scope))
            elif write.value is not None and write.value.type == "initializer_list":
                found.append(self._prefix_of(arguments_of(write.value), write.scope))
            elif write.value is not None and write.value.type != "null":
                found.append(self.prefix(write.value, write.scope))
        known = {each.text for each in found}
        if len(known) == 1 and found:
            return Prefix(found[0].text, any(each.is_guess for each in found))
        if found:
            return Prefix(None)
        is_object = "ptr" not in variable.type.lower() and not variable.is_pointer
        if not is_object or variable.is_reference or self._is_made_elsewhere(variable):
            return guess
        return Prefix("")

    def _is_made_elsewhere(self, variable: Variable) -> bool:
        """Whether the constructors of a member's class are in none of the files."""
        owner = variable.scope.enclosing("class") if variable.kind == "member" else None
        if owner is None:
            return False
        own = self._unit.functions_of(owner, owner.name)
        return bool(own) and all(each.scope is None for each in own)

    def _given(self, parameter: Variable, guess: Prefix) -> Prefix:
        """Return the namespace of a handle that a function is given."""
        function = parameter.scope.function
        if function is None:
            return guess
        position = next(
            (at for at, each in enumerate(function.parameters) if each is parameter), None
        )
        if position is None:
            return guess
        bound = self._unit.bindings.get(function)
        calls = bound_calls(bound) if bound is not None else self._callers.of(function)
        found = []
        for call in calls[:MOST_WRITES]:
            given = self._callers.given(call, function, position)
            if given is not None:
                found.append(self._converted(given, call.scope))
            else:
                default = self._callers.default_of(function, position)
                found.append(self._converted(default, function.place))
        if not found:
            return guess
        known = {each.text for each in found}
        if len(known) > 1 or len(calls) > MOST_WRITES:
            return Prefix(None)
        return Prefix(found[0].text, any(each.is_guess for each in found))

    def _converted(self, given: Node | None, scope: Scope) -> Prefix:
        """Return the namespace of a handle that an argument is, or that is made of it."""
        if given is None:
            return Prefix("")
        if given.type in ("string_literal", "concatenated_string"):
            return self._prefix_of([given], scope)
        if given.type == "initializer_list":
            return self._prefix_of(arguments_of(given), scope)
        return self.prefix(given, scope)


def _parsed_call(node: Node, scope: Scope) -> str:
    """Return what a call calls that is parsed as a parameter, `getNodeHandle()`."""
    type_node = node.child_by_field_name("type")
    return scope.file.syntax.word(type_node) if type_node is not None else ""
