"""What holds an endpoint that is added: a member, a variable of the file, or a local one."""

from __future__ import annotations

import re
from collections.abc import Iterator

from tree_sitter import Node

from plastron_tui.model.kinds import Publisher
from plastron_tui.model.source import EndpointKind
from plastron_tui.ros.interfaces import InterfaceName
from plastron_tui.sources.splices import line_start

from ..scopes import CppFile, Scope, Variable, statements_in
from .adding import Addition, variables_like
from .manner import is_marked_global, variable_naming
from .place import is_managed
from .transitions import follow_transitions
from .visibility import access_of

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
    outer = r"(?:::\s*)?(?:\b\w+\s*::\s*)*\b"
    found = re.compile(rf"{outer}{re.escape(old.name)}(?=(?:Const)?(?:Ptr)?\b)")
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
    added: Addition, kind: EndpointKind, type_: str, words: str = "", *, last: bool = False
) -> tuple[str, CppFile | None]:
    """Declare what holds an endpoint, unless it is a local variable.

    Args:
        added: the endpoint.
        kind: what is held.
        type_: the type of what holds it.
        words: what its name is made of, "" for the endpoint's name.
        last: whether it stands behind all that was declared, not beside its like.

    Returns:
        Its name, and the file that declares it, None for a local one.
    """
    member = is_member(added)
    named = variable_naming(added.analysis, kind, added.sites, is_member=member)
    wanted = named.name(words or added.topic)
    if not member and not is_local(added) and is_marked_global(added.analysis):
        wanted = f"g_{wanted.removeprefix('g_')}"
    name = added.free(wanted, named.end)
    if is_local(added):
        return name, None
    file = declare(added, f"{type_} {name};", None if last else kind)
    if kind is not K.PARAMETER and is_managed(added.analysis, added.owner):
        follow_transitions(added, kind, name)
    return name, file


def declare(added: Addition, line: str, kind: EndpointKind | None = None) -> CppFile:
    """Declare a member of the class, or a variable of the file; return the file."""
    if added.owner is None:
        return _declare_global(added, line, kind)
    owner = added.owner
    own = [each for _, each in variables_like(added, kind) if each.scope is owner] if kind else []
    # What holds a parameter stands with the settings, and not with the endpoints.
    held = [(site, each) for site, each in variables_like(added) if each.scope is owner]
    own = own or [each for site, each in held if site.endpoint.kind is not K.PARAMETER]
    own = own or [each for _, each in held]
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
    parts = statements_in(body)
    last = parts[-1] if parts else None
    is_private = last is not None and access_of(owner, body_end(last)) != "public"
    if not is_private and owner.node.type == "class_specifier":
        added.hidden_members.append(line)
    else:
        _put_at_end(added, owner, [line])


def open_private(added: Addition) -> None:
    """Write the private part that a class has not yet, if anything goes into it."""
    owner = added.owner
    if owner is None or not (added.hidden_functions or added.hidden_members):
        return
    lines: list[str] = []
    for each in added.hidden_functions:
        is_definition = len(each) > 1
        lines += [*([""] if lines and is_definition else []), *each]
    if lines and added.hidden_members:
        lines.append("")
    body = owner.node.child_by_field_name("body")
    parts = body.named_children if body is not None else []
    hidden = [each for each in parts if each.type == "access_specifier"]
    indent = _specifier_indent(owner.file, hidden, _outer(owner))
    newline = added.style(owner.file).newline
    is_apart = any(is_after_gap(owner.file, each) for each in hidden[1:]) or len(hidden) < 2
    first = f"{newline if is_apart else ''}{indent}private:{newline}"
    _put_at_end(added, owner, [*lines, *added.hidden_members], first)


def is_after_gap(file: CppFile, node: Node) -> bool:
    """Tell whether an empty line stands above a node."""
    text = file.syntax.text
    start = line_start(text, node.start_byte)
    return start > 0 and not text[line_start(text, start - 1) : start].strip()


def _outer(owner: Scope) -> str:
    text = owner.file.syntax.text
    outer = text[line_start(text, owner.node.start_byte) : owner.node.start_byte]
    return outer.decode("ascii") if not outer.strip() else ""


def _put_at_end(added: Addition, owner: Scope, lines: list[str], first: str = "") -> None:
    body = owner.node.child_by_field_name("body")
    assert body is not None, "a class that creates something has a body"
    file, text = owner.file, owner.file.syntax.text
    style = added.style(file)
    offset = line_start(text, body.end_byte - 1)
    written = first + style.laid_out(lines, _outer(owner) + style.indent)
    if text[offset : body.end_byte - 1].strip():
        offset = body.end_byte - 1
        written = style.newline + written
    added.plan.replace(file, offset, offset, written)


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
    file = added.place.file
    held = [each for _, each in variables_like(added) if each.kind == "global"]
    held = [each for each in held if each.file is file]
    like = variables_like(added, kind) if kind is not None else []
    own = [each for _, each in like if any(each is other for other in held)] or held
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
