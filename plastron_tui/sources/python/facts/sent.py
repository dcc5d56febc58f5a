"""Messages that are published, and which of their fields may have got a value until then."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from tree_sitter import Node

from plastron_tui.diagnostics import Span
from plastron_tui.model.code_facts import REMOVING, MessageType, Sent, adds
from plastron_tui.sources.grammars import is_inside
from plastron_tui.sources.python.arguments import Arguments
from plastron_tui.sources.python.references import (
    function_of,
    identifiers,
    is_member,
    statement_of,
)
from plastron_tui.sources.python.scopes import Binding, BindingKind, Scope
from plastron_tui.sources.python.syntax import FUNCTIONS, REPEATING, parts_of
from plastron_tui.sources.unreachable import is_unreachable

from .message_values import MessageValues
from .other_files import function_elsewhere
from .returns import is_special, returned_values

_SENDING = frozenset({"publish", "sendTransform"})
_READING = frozenset({"print", "str", "repr", "type", "len", "publish", "sendTransform"})
_LOGGING = frozenset(
    {"debug", "info", "warn", "warning", "error", "fatal", "logdebug", "loginfo", "logwarn"}
    | {"logerr", "logfatal"}
)
_SEEN = frozenset(
    {"interpolation", "comparison_operator", "not_operator", "if_statement", "while_statement"}
)

_LOOKING = frozenset({"binary_operator", "comparison_operator", "interpolation"})
_ASKING = (
    _READING
    | _LOGGING
    | {"float", "from_msg", "get_logger", "int", "isinstance", "Duration", "Time"}
)
"""What leaves its arguments as they are."""

Paths = frozenset[tuple[str, ...]]


class Making(NamedTuple):
    """How a message is made: its type, the fields that may get a value, and where its variable is.

    The place is -1 for a message that is held by no variable.
    """

    type: MessageType
    paths: Paths
    place: int = -1


def sent_messages(messages: MessageValues) -> Iterator[Sent]:
    """Yield the messages that are published, where all that is done with them is known."""
    syntax = messages.analysis.syntax
    for call in messages.analysis.captures.get("call", []):
        if syntax.called_name(call) not in _SENDING or _is_static(messages, call):
            continue
        arguments = Arguments.of(call, syntax)
        if len(arguments.positional) != 1 or arguments.keywords or arguments.is_open:
            continue
        making = _making(messages, call, arguments.positional[0])
        if making is not None and not is_unreachable(call):
            span = Span(call.start_byte, call.end_byte)
            yield Sent(making.type, making.paths, span, made=making.place)


def _is_static(messages: MessageValues, call: Node) -> bool:
    """Whether a call sends a transform that holds for all times, whose stamp says nothing."""
    callee = call.child_by_field_name("function")
    receiver = callee.child_by_field_name("object") if callee is not None else None
    if receiver is None:
        return True
    if b"static" in (receiver.text or b"").lower():
        return True
    values = (each.value for each in messages.bindings(receiver)[1])
    return any(b"Static" in (value.text or b"") for value in values if value is not None)


def _making(messages: MessageValues, sending: Node, node: Node, taken: int = 0) -> Making | None:
    """Return how what a call sends is made, None where not all of that is known."""
    if node.type == "call":
        return _made_by(messages, node)
    bindings = messages.bindings(node)[1] if node.type in ("identifier", "attribute") else []
    if messages.is_elsewhere and any(each.scope.kind != "function" for each in bindings):
        # Whoever calls the function may get at what it keeps.
        return None
    made = []
    for binding in bindings:
        value = binding.value
        if binding.kind is not BindingKind.VALUE or value is None or value.type != "call":
            return None
        # `a, b = String(), String()` and `a = b = String()` give one message several names.
        target = binding.node.child_by_field_name("left")
        outer = binding.node.parent
        is_plain = binding.node.type == "assignment" and target is not None and outer is not None
        if not is_plain or outer is None or outer.type == "assignment":
            return None
        if (right := binding.node.child_by_field_name("right")) is None or right.id != value.id:
            return None
        making = _made_by(messages, value)
        if making is None:
            return None
        made.append(making)
    if len({each.type for each in made}) != 1:
        return None
    used = _used(messages, sending, node, bindings, taken)
    if used is None:
        return None
    place = min(each.node.start_byte for each in bindings)
    return Making(made[0].type, used.union(*(each.paths for each in made)), place)


def _made_by(messages: MessageValues, call: Node) -> Making | None:
    type_ = messages.class_of(call.child_by_field_name("function"))
    arguments = Arguments.of(call, messages.analysis.syntax)
    if type_ is None:
        return _by_library(messages, call, arguments) or _by_function(messages, call)
    if arguments.is_open or arguments.positional:
        return None
    paths: set[tuple[str, ...]] = set()
    for name, value in arguments.keywords.items():
        inner = _header(_made_by(messages, value)) if value.type == "call" else None
        if inner is None:
            paths.add((name,))
            if (name,) == REMOVING[:1] and not adds(value.text or b""):
                paths.add(REMOVING)
        else:
            paths |= {(name, *path) for path in inner.paths}
    return Making(type_, frozenset(paths))


def _by_function(messages: MessageValues, call: Node) -> Making | None:
    """Return how a function makes the message that it gives, one of the file or of another."""
    callee = call.child_by_field_name("function")
    if callee is None or (messages.is_elsewhere and callee.type == "attribute"):
        # The class that derives from its class may have another method of the name.
        return None
    function = function_of(callee, messages.analysis)
    if function is None and (elsewhere := function_elsewhere(messages, callee)) is not None:
        messages, function = messages.of_file(elsewhere[0]), elsewhere[1]
    if function is None or is_special(function) or function.node.id in messages.makers:
        return None
    messages.makers.add(function.node.id)
    found = []
    for value in returned_values(function):
        if value.type == "none":
            continue
        making = _making(messages, value.parent or value, value)
        if making is None:
            break
        found.append(making)
    else:
        if len({each.type for each in found}) == 1:
            messages.makers.discard(function.node.id)
            paths = frozenset(path for each in found for path in each.paths)
            return Making(found[0].type, paths)
    messages.makers.discard(function.node.id)
    return None


def _by_library(messages: MessageValues, call: Node, arguments: Arguments) -> Making | None:
    """Return what cv_bridge makes of an image; the header is an argument, or stays as it is."""
    held = messages.given_by_library(call)
    if len(held) != 1 or held[0].type.name.name != "Image" or arguments.is_open:
        return None
    if len(arguments.positional) > 2 or "header" in arguments.keywords:
        return None
    return Making(held[0].type, frozenset({("data",)}))


def _used(
    messages: MessageValues, sending: Node, node: Node, bindings: Sequence[Binding], taken: int
) -> Paths | None:
    """Return the paths of what is done with a variable; None where it goes anywhere else.

    The use `taken` is known, and does not count.
    """
    paths: set[tuple[str, ...]] = set()
    for use in _uses(messages, node, bindings):
        if use is None:
            return None
        if node.type == "identifier" and _is_behind(use, sending, bindings):
            continue
        path, whole = _path(messages, use)
        if path:
            if len(path) < 2 or not _is_read(messages, whole):
                inner = _given_to(messages, sending, whole) if len(path) == 1 else None
                # A header that is made there, and whose making is known, is more than touched.
                paths |= {(*path, *each) for each in inner.paths} if inner is not None else {path}
                if path == REMOVING[:1] and not _is_added(whole):
                    paths.add(REMOVING)
        elif use.id != taken and not _is_harmless(messages, sending, use):
            return None
    return frozenset(paths)


def _is_added(action: Node) -> bool:
    """Tell whether an action gets a value with which a marker stays, or is shown."""
    parent = action.parent
    value = parent.child_by_field_name("right") if parent is not None else None
    return value is not None and adds(value.text or b"")


def _given_to(messages: MessageValues, sending: Node, field: Node) -> Making | None:
    """Return the message that an assignment gives to a field of the one that is sent."""
    parent = field.parent
    left = parent.child_by_field_name("left") if parent is not None else None
    if parent is None or parent.type != "assignment" or left is None or left.id != field.id:
        return None
    value = parent.child_by_field_name("right")
    if value is None or value.type not in ("call", "identifier") or value.id in messages.makers:
        return None
    messages.makers.add(value.id)
    made = _making(messages, sending, value, value.id)
    messages.makers.discard(value.id)
    return _header(made)


def _header(making: Making | None) -> Making | None:
    """Return how a header is made; what else is constructed is a value that somebody has chosen."""
    is_header = making is not None and making.type.name.name == "Header"
    return making if is_header else None


def _is_behind(use: Node, sending: Node, bindings: Sequence[Binding]) -> bool:
    """Whether a local is only used once it has been sent, and made anew before the next time."""
    if use.start_byte < sending.end_byte:
        return False
    current = sending.parent
    while current is not None and current.type not in FUNCTIONS:
        is_loop = current.type in REPEATING
        if is_loop and not all(is_inside(each.node, current) for each in bindings):
            return False
        current = current.parent
    return current is not None


def _uses(
    messages: MessageValues, node: Node, bindings: Sequence[Binding]
) -> Iterator[Node | None]:
    """Yield the uses of a variable that may see its bindings, None for what may be one or not."""
    analysis = messages.analysis
    if node.type == "identifier":
        name = analysis.syntax.slice(node)
        found = messages.scope(node).lookup(name)
        owner = found[0] if found is not None else None
        for each in identifiers(name, analysis):
            if is_member(each) or _owner(messages, each, name) is not owner:
                continue
            if not set(bindings).isdisjoint(messages.bindings(each)[1]):
                yield each
        return
    name_node = node.child_by_field_name("attribute")
    holder = node.child_by_field_name("object")
    if name_node is None or holder is None:
        yield None
        return
    owner = messages.object_class(holder)
    for each in identifiers(analysis.syntax.slice(name_node), analysis):
        parent = each.parent
        if parent is None or parent.type != "attribute" or _is_object(parent, each):
            continue
        of = parent.child_by_field_name("object")
        where = messages.object_class(of) if of is not None else None
        if where is not None and where is owner:
            yield parent
        elif of is not None and not messages.held(of):
            yield None


def _is_object(parent: Node, node: Node) -> bool:
    holder = parent.child_by_field_name("object")
    return holder is not None and holder.id == node.id


def _owner(messages: MessageValues, node: Node, name: str) -> Scope | None:
    found = messages.scope(node).lookup(name)
    return found[0] if found is not None else None


def _is_read(messages: MessageValues, node: Node) -> bool:
    """Whether a field of a field is only looked at: `tell(msg.header.stamp)`."""
    parent = node.parent
    call = parent.parent if parent is not None and parent.type == "argument_list" else None
    if parent is None or call is None:
        return parent is not None and parent.type in _LOOKING
    callee = call.child_by_field_name("function")
    function = function_of(callee, messages.analysis) if callee is not None else None
    if function is None:
        return messages.analysis.syntax.called_name(call) in _ASKING
    return not is_special(function) and _only_looks(messages, function)


def _only_looks(messages: MessageValues, function: Scope) -> bool:
    """Whether a function surely changes nothing of what it gets."""
    pending = [function.node]
    while pending:
        node = pending.pop()
        if node.type == "call" and messages.analysis.syntax.called_name(node) not in _ASKING:
            return False
        if node.type in ("assignment", "augmented_assignment"):
            target = node.child_by_field_name("left")
            if target is None or target.type != "identifier":
                return False
        pending += node.named_children
    return True


def _path(messages: MessageValues, use: Node) -> tuple[tuple[str, ...], Node]:
    """Return the path that is looked into, as far as it has names, and what has it."""
    path: list[str] = []
    node, parent = use, use.parent
    while parent is not None and parent.type == "attribute" and _is_object(parent, node):
        name = parent.child_by_field_name("attribute")
        path.append(messages.analysis.syntax.slice(name) if name is not None else "")
        node, parent = parent, parent.parent
    return tuple(path), node


def _is_harmless(messages: MessageValues, sending: Node, use: Node) -> bool:
    """Whether a message stays what it is where it is used whole, until it is sent."""
    parent = use.parent
    if parent is None:
        return False
    if parent.id == sending.id:
        return True
    if parent.type == "assignment":
        left = parent.child_by_field_name("left")
        is_target = left is not None and left.id == use.id
        behind = statement_of(parent).next_named_sibling
        # `self.last = msg` in the line before.
        return is_target or (behind is not None and is_inside(sending, behind))
    if parent.type in _SEEN:
        return True
    if parent.type == "argument_list" and parent.parent is not None:
        called = messages.analysis.syntax.called_name(parent.parent)
        only = len(parts_of(parent)) == 1
        return (called in _READING and only) or called in _LOGGING
    return False
