"""What holds an endpoint that is added: a member, a variable of the file, or a local one."""

from __future__ import annotations

import re
from collections.abc import Iterator

from tree_sitter import Node

from plastron_tui.model.kinds import Publisher
from plastron_tui.model.source import EndpointKind
from plastron_tui.ros.interfaces import InterfaceName

from ..scopes import CppFile, Scope, Variable
from .adding import Addition, variables_like
from .manner import variable_naming
from .place import access_of, is_managed
from .transitions import follow_transitions

K = EndpointKind

_ROS1 = {
    K.PUBLISHER: "ros::Publisher",
    K.SUBSCRIPTION: "ros::Subscriber",
    K.SERVICE: "ros::ServiceServer",
    K.CLIENT: "ros::ServiceClient",
    K.TIMER: "ros::Timer",
}
_ROS2 = {
    K.PUBLISHER: "rclcpp::Publisher<{}>::SharedPtr",
    K.SUBSCRIPTION: "rclcpp::Subscription<{}>::SharedPtr",
    K.SERVICE: "rclcpp::Service<{}>::SharedPtr",
    K.CLIENT: "rclcpp::Client<{}>::SharedPtr",
    K.TIMER: "rclcpp::TimerBase::SharedPtr",
    K.ACTION_SERVER: "rclcpp_action::Server<{}>::SharedPtr",
    K.ACTION_CLIENT: "rclcpp_action::Client<{}>::SharedPtr",
}


def respelled(text: str, old: InterfaceName, class_: str) -> str | None:
    """Return a text with the class of another type, None where it does not say the old one."""
    found = re.compile(
        rf"(?:::\s*)?(?:\b\w+\s*::\s*)*\b{re.escape(old.name)}(?=(?:Const)?(?:Ptr)?\b)"
    )
    changed, count = found.subn(class_, text)
    return changed if count else None


def type_of(added: Addition, kind: EndpointKind, class_: str) -> str:
    """Write the type of what holds an endpoint, as the file has its others."""
    for site, variable in reversed(variables_like(added, kind)):
        node = variable.type_node
        if node is None or variable.type == "auto" or variable.is_pointer or variable.is_list:
            continue
        if not _holds(added.analysis.receivers.type_of_variable(variable), added, kind):
            # Of a library that is used on top: `message_filters::Subscriber<T>`.
            continue
        text = variable.file.syntax.slice(node)
        if "Lifecycle" in text and not is_managed(added.analysis, added.owner):
            continue
        if kind is K.TIMER or not added.is_ros2:
            return text
        if site.endpoint.type is not None:
            again = respelled(text, site.endpoint.type, class_)
            if again is not None:
                return again
    if not added.is_ros2:
        return _ROS1[kind]
    text = _ROS2[kind].format(class_)
    if kind is K.PUBLISHER and is_managed(added.analysis, added.owner):
        text = text.replace("rclcpp::Publisher", "rclcpp_lifecycle::LifecyclePublisher")
    return text


def _holds(type_: str, added: Addition, kind: EndpointKind) -> bool:
    """Tell whether a type, without pointers, is what the client library has for a kind."""
    known = (_ROS2 if added.is_ros2 else _ROS1)[kind]
    wanted = known.partition("<")[0].removesuffix("::SharedPtr")
    found = type_.partition("<")[0].replace("_lifecycle::Lifecycle", "::")
    return found in (wanted, wanted.rpartition("::")[2])


def is_member(added: Addition) -> bool:
    """Tell whether what holds the endpoint is a member of a class."""
    return added.owner is not None


def is_local(added: Addition) -> bool:
    """Tell whether what holds the endpoint may be a variable of the function that creates it."""
    if added.owner is not None:
        return False
    endpoint = added.endpoint
    if isinstance(endpoint, Publisher) and any(x.reaction for x in endpoint.publications):
        # The function that hears sees what the file has.
        return False
    held = [variable for _, variable in variables_like(added, added.kind)]
    held = held or [variable for _, variable in variables_like(added)]
    globals_ = [each for each in held if each.kind == "global"]
    return added.place.function.name == "main" and len(globals_) * 2 <= len(held)


def hold(
    added: Addition, kind: EndpointKind, type_: str, words: str = ""
) -> tuple[str, CppFile | None]:
    """Declare what holds an endpoint, unless it is a local variable.

    Returns:
        Its name, and the file that declares it, None for a local one.
    """
    member = is_member(added)
    named = variable_naming(added.analysis, kind, added.sites, is_member=member)
    name = added.free(named.name(words or added.topic), named.end)
    if is_local(added):
        return name, None
    file = declare(added, f"{type_} {name};", kind)
    if kind is not K.PARAMETER and is_managed(added.analysis, added.owner):
        follow_transitions(added, kind, name)
    return name, file


def declare(added: Addition, line: str, kind: EndpointKind | None = None) -> CppFile:
    """Declare a member of the class, or a variable of the file; return the file."""
    if added.owner is None:
        return _declare_global(added, line, kind)
    owner = added.owner
    own = [each for _, each in variables_like(added, kind) if each.scope is owner] if kind else []
    own = own or [each for _, each in variables_like(added) if each.scope is owner]
    own = own or [each for each in _members(owner) if _is_hidden(owner, each.node)]
    if own:
        last = max(own, key=lambda each: each.node.start_byte)
        added.put_behind(owner.file, last.node, [line])
        return owner.file
    _declare_at_end(added, owner, line)
    return owner.file


def _members(owner: Scope) -> Iterator[Variable]:
    for variables in owner.variables.values():
        for each in variables:
            if each.node.type == "field_declaration":
                yield each


def _is_hidden(owner: Scope, node: Node) -> bool:
    """Tell whether a member is private or protected."""
    access = access_of(owner, node)
    return access in ("private", "protected")


def _declare_at_end(added: Addition, owner: Scope, line: str) -> None:
    """Declare a member at the end of the last private part of a class."""
    body = owner.node.child_by_field_name("body")
    assert body is not None, "a class that creates something has a body"
    parts = [each for each in body.named_children if each.type != "comment"]
    last = parts[-1] if parts else None
    file, text = owner.file, owner.file.syntax.text
    style = added.style(file)
    start = text.rfind(b"\n", 0, owner.node.start_byte) + 1
    outer = text[start : owner.node.start_byte]
    base = outer.decode("ascii") if not outer.strip() else ""
    is_private = last is not None and access_of(owner, body_end(last)) != "public"
    hidden = [each for each in parts if each.type == "access_specifier"]
    specifier = ""
    if not is_private and owner.node.type == "class_specifier":
        indent = _specifier_indent(file, hidden, base)
        specifier = f"{style.newline}{indent}private:{style.newline}"
    offset = text.rfind(b"\n", 0, body.end_byte - 1) + 1
    written = f"{base}{style.indent}{line}{style.newline}"
    if text[offset : body.end_byte - 1].strip():
        offset = body.end_byte - 1
        written = style.newline + written
    added.plan.replace(file, offset, offset, specifier + written)


def body_end(node: Node) -> Node:
    """Return what stands at the end of a member: the node behind it, or itself."""
    return node.next_sibling or node


def _specifier_indent(file: CppFile, specifiers: list[Node], base: str) -> str:
    if not specifiers:
        return base
    text = file.syntax.text
    start = text.rfind(b"\n", 0, specifiers[-1].start_byte) + 1
    blanks = text[start : specifiers[-1].start_byte]
    return blanks.decode("ascii") if not blanks.strip() else base


def _declare_global(added: Addition, line: str, kind: EndpointKind | None) -> CppFile:
    held = [each for _, each in variables_like(added, kind)] if kind is not None else []
    held = held or [each for _, each in variables_like(added)]
    own = [each for each in held if each.kind == "global" and each.file is added.place.file]
    file = added.place.file
    if own:
        added.put_behind(file, max(own, key=lambda each: each.node.start_byte).node, [line])
        return file
    first = min(
        (
            each.node
            for each in file.scopes
            if each.kind in ("function", "class") and each.parent is added.place.scope.parent
        ),
        key=lambda node: node.start_byte,
    )
    added.put_above(file, first, [line], gap=True)
    return file
