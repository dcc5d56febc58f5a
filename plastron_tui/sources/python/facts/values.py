"""Messages that a file constructs, and the values that fields of messages get."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator

from tree_sitter import Node

from plastron_tui.diagnostics import Span
from plastron_tui.model.code_facts import (
    ITEM,
    Built,
    FieldValue,
    MessageField,
    MessageType,
    Part,
    ValueKind,
)
from plastron_tui.model.kinds import EndpointKind
from plastron_tui.sources.python.arguments import Arguments
from plastron_tui.sources.python.functions import callback_scope
from plastron_tui.sources.python.scopes import Scope
from plastron_tui.sources.python.syntax import parts_of

from .handed_messages import Helds
from .message_values import MessageValues, field_of
from .returns import gives_nothing, is_decorated, return_statements, returned_values
from .value_kinds import Known, ValueKinds

_CONVERTED = frozenset({ValueKind.INT, ValueKind.BOOL, ValueKind.FLOAT})
"""What an array of numbers takes as an element, and makes a number of its own of."""

_CALLS = frozenset({"call", "call_async"})
_ANSWERS = frozenset({ValueKind.NONE, ValueKind.LIST, ValueKind.DICT})
"""What rospy takes for an answer besides the answer itself."""


def field_values(messages: MessageValues, kinds: ValueKinds) -> Iterator[FieldValue]:
    """Yield the values that fields get: by assignments, by constructors, in what is sent."""
    for node in messages.analysis.captures.get("assignment", []):
        yield from _assigned(messages, kinds, node)
    for call in messages.analysis.captures.get("call", []):
        callee = call.child_by_field_name("function")
        made = messages.class_of(callee)
        if made is not None:
            yield from _constructed(messages, kinds, call, made)
        elif callee is not None:
            yield from _added(messages, kinds, call, callee)
            yield from _sent(messages, kinds, call, callee)


def answered_values(messages: MessageValues, kinds: ValueKinds) -> Iterator[FieldValue]:
    """Yield what callbacks of services give as their answer.

    A callback of rospy may give None on purpose, which is an error of the call, and the values of
    the fields as a list or a dict.
    """
    is_rospy = messages.analysis.library.ros_version == 1
    for function, type_ in _answering(messages):
        fields = (MessageField(type_),)
        for statement in return_statements(function):
            for value in parts_of(statement):
                is_tuple = value.type == "expression_list"
                known = Known(ValueKind.LIST) if is_tuple else kinds.of(value)
                if known is not None and not (is_rospy and known.kind in _ANSWERS):
                    yield _value(fields, known, value)
            if not parts_of(statement) and not is_rospy:
                yield _value(fields, Known(ValueKind.NONE), statement)
        name = function.node.child_by_field_name("name")
        if name is not None and gives_nothing(function):
            yield _value(fields, Known(ValueKind.NONE), name)


def _answering(messages: MessageValues) -> Iterator[tuple[Scope, MessageType]]:
    """Yield the callbacks of services, each with what it answers with."""
    for site in messages.sites.values():
        function = callback_scope(messages.analysis, site)
        held = messages.of_site(site, Part.RESPONSE)
        is_service = site.endpoint.kind is EndpointKind.SERVICE
        if function is not None and is_service and held and not is_decorated(function):
            yield function, held[0].type


def _answers(messages: MessageValues) -> Iterator[Built]:
    """Yield the lists that callbacks of rospy give, of which it makes an answer."""
    for function, type_ in _answering(messages):
        for value in returned_values(function):
            parts = parts_of(value)
            is_list = value.type in ("expression_list", "list", "tuple")
            if is_list and parts and not any("splat" in each.type for each in parts):
                yield Built(type_, len(parts), (), Span(value.start_byte, value.end_byte))


def built_messages(messages: MessageValues, kinds: ValueKinds) -> Iterator[Built]:
    """Yield what makes messages: constructors, in rospy `publish` with fields, and answers."""
    syntax = messages.analysis.syntax
    for call in messages.analysis.captures.get("call", []):
        type_ = messages.class_of(call.child_by_field_name("function"))
        if type_ is None:
            type_ = _published_fields(messages, kinds, call)
        if type_ is None:
            continue
        arguments = Arguments.of(call, syntax)
        if arguments.is_open and not arguments.keywords:
            continue
        names = _keyword_names(call, syntax.slice)
        places = (
            () if arguments.is_open else tuple(each.start_byte for each in arguments.positional)
        )
        span = Span(call.start_byte, call.end_byte)
        yield Built(type_, len(places), names, span, places=places)
    if messages.analysis.library.ros_version == 1:
        yield from _answers(messages)


def _keyword_names(call: Node, slice_: Callable[[Node], str]) -> tuple[tuple[str, Span], ...]:
    found = []
    for child in parts_of(call.child_by_field_name("arguments")):
        name = child.child_by_field_name("name") if child.type == "keyword_argument" else None
        if name is not None:
            found.append((slice_(name), Span(name.start_byte, name.end_byte)))
    return tuple(found)


def _assigned(messages: MessageValues, kinds: ValueKinds, node: Node) -> Iterator[FieldValue]:
    value = node.child_by_field_name("right")
    while value is not None and value.type == "assignment":
        value = value.child_by_field_name("right")
    target = node.child_by_field_name("left")
    if target is None or value is None:
        return
    if target.type in ("pattern_list", "tuple_pattern"):
        targets, values = parts_of(target), parts_of(value)
        is_paired = value.type in ("expression_list", "tuple") and len(targets) == len(values)
        pairs = list(zip(targets, values, strict=True)) if is_paired else []
    else:
        pairs = [(target, value)]
    sides = ((place, each) for place, given in pairs for each in branches(given))
    for place, given in sides:
        if place.type not in ("attribute", "subscript"):
            continue
        field = "object" if place.type == "attribute" else "value"
        if not messages.held(place.child_by_field_name(field)):
            continue
        is_slice = place.type == "subscript" and _is_slice(place)
        known = None if is_slice else kinds.of(given)
        if known is None or (place.type == "subscript" and known.kind in _CONVERTED):
            continue
        yield from _values(messages.held(place), known, given)


def branches(node: Node) -> list[Node]:
    """Return the values that an expression chooses from: each of them is given at times."""
    found: list[Node] = []
    pending = [node]
    while pending:
        current = pending.pop()
        parts = parts_of(current)
        if current.type == "parenthesized_expression" and len(parts) == 1:
            pending.append(parts[0])
        elif current.type == "conditional_expression" and len(parts) == 3:
            pending += [parts[2], parts[0]]
        else:
            found.append(current)
    return found


def _is_slice(node: Node) -> bool:
    index = node.child_by_field_name("subscript")
    return index is not None and index.type == "slice"


def _constructed(
    messages: MessageValues, kinds: ValueKinds, call: Node, type_: MessageType
) -> Iterator[FieldValue]:
    arguments = Arguments.of(call, messages.analysis.syntax)
    given = arguments.keywords.items()
    for name, value in ((name, each) for name, whole in given for each in branches(whole)):
        known = kinds.of(value)
        if known is not None:
            yield _value((MessageField(type_, (name,)),), known, value)
    if not arguments.is_open:
        yield from _by_position(kinds, type_, arguments)


def _by_position(
    kinds: ValueKinds, type_: MessageType, arguments: Arguments
) -> Iterator[FieldValue]:
    for position, value in enumerate(arguments.positional):
        known = kinds.of(value)
        if known is not None:
            yield _value((MessageField(type_, (f"#{position}",)),), known, value)


def _added(
    messages: MessageValues, kinds: ValueKinds, call: Node, callee: Node
) -> Iterator[FieldValue]:
    """Yield what is appended to a list of a message."""
    if messages.analysis.syntax.called_name(call) != "append" or callee.type != "attribute":
        return
    holder = messages.held(callee.child_by_field_name("object"))
    arguments = Arguments.of(call, messages.analysis.syntax)
    if len(arguments.positional) != 1 or not holder:
        return
    value = arguments.positional[0]
    known = kinds.of(value)
    if known is not None and known.kind not in _CONVERTED:
        items = tuple(each._replace(path=(*each.path, ITEM)) for each in holder)
        yield from _values(items, known, value)


def _sent(
    messages: MessageValues, kinds: ValueKinds, call: Node, callee: Node
) -> Iterator[FieldValue]:
    """Yield what is sent whole: published, or asked of a service."""
    type_ = _sent_type(messages, call, callee)
    if type_ is None:
        return
    arguments = Arguments.of(call, messages.analysis.syntax)
    if arguments.is_open or not arguments.positional:
        return
    known = [kinds.of(each) for each in arguments.positional]
    first = known[0]
    is_rospy = messages.analysis.library.ros_version == 1
    if is_rospy and (len(known) > 1 or (first is not None and first.kind is not ValueKind.MESSAGE)):
        yield from _by_position(kinds, type_, arguments)
    elif len(known) == 1 and first is not None and first.kind is not ValueKind.BYTES:
        yield _value((MessageField(type_),), first, arguments.positional[0])


def _sent_type(messages: MessageValues, call: Node, callee: Node) -> MessageType | None:
    """Return the message that a call sends through an endpoint of the file."""
    name = messages.analysis.syntax.called_name(call)
    is_rospy = messages.analysis.library.ros_version == 1
    if callee.type == "attribute" and (name == "publish" or name in _CALLS):
        site = messages.site_of(callee.child_by_field_name("object"))
    elif is_rospy:
        site = messages.site_of(callee)
    else:
        return None
    if site is None:
        return None
    kinds = {EndpointKind.PUBLISHER: Part.MESSAGE, EndpointKind.CLIENT: Part.REQUEST}
    part = kinds.get(site.endpoint.kind)
    if part is None or (part is Part.MESSAGE) != (name == "publish"):
        return None
    held = messages.of_site(site, part)
    return held[0].type if held else None


def _published_fields(messages: MessageValues, kinds: ValueKinds, call: Node) -> MessageType | None:
    """Return the message that `publish` or a service proxy of rospy makes of its arguments."""
    callee = call.child_by_field_name("function")
    if messages.analysis.library.ros_version != 1 or callee is None:
        return None
    type_ = _sent_type(messages, call, callee)
    if type_ is None:
        return None
    arguments = Arguments.of(call, messages.analysis.syntax)
    if arguments.is_open or not arguments.positional or arguments.keywords:
        return None
    if len(arguments.positional) == 1:
        known = kinds.of(arguments.positional[0])
        if known is None or known.kind is ValueKind.MESSAGE:
            return None
    return type_


def _values(held: Helds, known: Known, value: Node) -> Iterator[FieldValue]:
    fields = tuple(field_of(each) for each in held if not each.behind)
    if fields and len(fields) == len(held):
        yield _value(fields, known, value)


def _value(fields: Iterable[MessageField], known: Known, value: Node) -> FieldValue:
    first, *others = fields
    source = known.sources[0] if len(known.sources) == 1 else None
    message = source.type.name if source is not None and not source.path else None
    return FieldValue(
        first.type,
        first.path,
        known.kind,
        Span(value.start_byte, value.end_byte),
        text=known.text,
        elements=known.elements,
        message=message,
        source=source,
        items=known.items,
        others=tuple(others),
        extremes=known.extremes,
    )
