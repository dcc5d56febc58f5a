"""What rospy makes messages of by itself: what is published, asked, or returned as plain values."""

from __future__ import annotations

from tree_sitter import Node

from plastron_tui.model.source import EndpointKind
from plastron_tui.ros.interfaces import FieldType, InterfaceKind
from plastron_tui.sources.python.analysis import Site
from plastron_tui.sources.python.callbacks import callback_target
from plastron_tui.sources.python.constants import Known
from plastron_tui.sources.python.scopes import Scope
from plastron_tui.sources.python.splices import Splice
from plastron_tui.sources.python.syntax import parts_of

from .endpoints import site_of, visible_type
from .fields import (
    Fields,
    Given,
    fields_of,
    is_real_elsewhere,
    is_unchecked,
    write_fields,
    write_value,
)
from .kinds import LIST, is_plain, kind_of, some_plain
from .message_types import constructed, field_type, section_of
from .port_state import Work

_RESPONSE = "a handler of rclpy returns a response"
_FUNCTIONS = ("function_definition", "lambda", "class_definition")
_PATTERNS = ("pattern_list", "tuple_pattern", "list_pattern")
_SEQUENCES = ("expression_list", "tuple", "list")


def port_plain(work: Work) -> None:
    """Make messages of plain values, where it is sure what they are, and mark the others."""
    for call in work.analysis.captures.get("call", []):
        callee = call.child_by_field_name("function")
        arguments = call.child_by_field_name("arguments")
        if callee is None or arguments is None or work.is_gone(call):
            continue
        if arguments.type != "argument_list":
            continue
        text = work.slice(callee)
        if text == "setattr":
            _port_set(work, call, arguments)
        elif text.endswith(".publish"):
            _port_publish(work, call, callee, arguments)
        else:
            _port_message(work, call, callee, arguments)
    for node in work.analysis.captures.get("assignment", []):
        _port_assignment(work, node)
    for site in work.analysis.sites:
        if site.endpoint.kind is EndpointKind.SERVICE:
            _port_handler(work, site)


def given_to(work: Work, arguments: Node) -> Given | None:
    """Return what a call gives, None where a splat may hide more."""
    found: Given = []
    for each in parts_of(arguments):
        if "splat" in each.type or each.type in ("ERROR", "generator_expression"):
            return None
        name, value = each.child_by_field_name("name"), each.child_by_field_name("value")
        is_named = each.type == "keyword_argument" and name is not None and value is not None
        if is_named:
            assert name is not None
            assert value is not None
            found.append((work.slice(name), value))
        else:
            found.append((None, each))
    return found


def _port_message(work: Work, call: Node, callee: Node, arguments: Node) -> None:
    """Name the fields of a message that is made, and make numbers what its fields assert."""
    made = constructed(work, callee)
    given = given_to(work, arguments)
    if made is None or given == []:
        return
    fields = fields_of(work, *made)
    if given is None or given[0][0] is None:
        splices = write_fields(work, given, fields) if fields is not None and given else None
        if splices is not None:
            put(work, splices)
        elif any(each.type != "dictionary_splat" for each in parts_of(arguments)):
            work.mark(call, f"{work.slice(callee)} takes keywords only", "name the fields")
        else:
            _port_splats(work, call, work.slice(callee), arguments, fields or {})
        return
    splices = write_fields(work, given, fields, is_sure=False) if fields is not None else []
    if splices is not None:
        put(work, splices)
        return
    missing = [name for name, _ in given if name is not None and not (fields or {}).get(name)]
    for name in missing:
        remedy = f"{made[0]} of ROS 2 has no field `{name}`"
        work.mark(call, f"{name} of {work.slice(callee)}", remedy)


def _port_splats(work: Work, call: Node, class_: str, arguments: Node, fields: Fields) -> None:
    """Make numbers of what `**{...}` gives; mark what may be given otherwise."""
    for each in parts_of(arguments):
        held = each.named_children[0]
        given = _returned(work, held) if held.type == "dictionary" else None
        splices = write_fields(work, given, fields, is_sure=False) if given is not None else None
        if splices is not None:
            put(work, splices)
        elif any(type_ is not None and is_unchecked(type_) for type_ in fields.values()):
            work.mark(call, f"the fields of {class_}", "a field of a number takes a `float` only")


def _port_assignment(work: Work, node: Node) -> None:
    """Make a number what the field of a message asserts: `twist.linear.x = 1`."""
    left, right = node.child_by_field_name("left"), node.child_by_field_name("right")
    if left is None or right is None or right.type == "assignment":
        return
    _port_targets(work, node, left, right)


def _port_targets(work: Work, node: Node, left: Node, right: Node) -> None:
    """Make numbers of what is put into fields, through `v.x, (v.y, v.z) = 1, (2, 3)`."""
    targets = parts_of(left) if left.type in _PATTERNS else [left]
    values = parts_of(right) if right.type in _SEQUENCES else [right]
    is_splat = any("splat" in each.type for each in (*targets, *values))
    if left.type not in _PATTERNS:
        type_ = field_type(work, left)
        if type_ is None and right.type == "integer" and is_real_elsewhere(work, left):
            type_ = FieldType("float64")
        splices = write_value(work, right, type_) if type_ is not None else []
        if splices is None:
            work.mark(node, work.slice(left), f"the field takes a `{type_}`")
        put(work, splices or [])
        return
    if len(targets) == len(values) and right.type in _SEQUENCES and not is_splat:
        for target, value in zip(targets, values, strict=True):
            _port_targets(work, node, target, value)
        return
    types = [field_type(work, each) for each in _leaves(left)]
    numbers = [each is not None and each.name.startswith("float") for each in types]
    is_flat = len(types) == len(targets) and not is_splat
    if is_flat and all(numbers) and not any(each is None or each.is_array for each in types):
        work.insert(right.start_byte, "map(float, ")
        work.insert(right.end_byte, ")")
    elif any(numbers):
        work.mark(node, "fields of numbers", "give each its `float(...)`")


def _leaves(target: Node) -> list[Node]:
    """Return the targets of an assignment, without the patterns around them."""
    if target.type not in _PATTERNS:
        return [target]
    return [leaf for each in parts_of(target) for leaf in _leaves(each)]


def _port_set(work: Work, call: Node, arguments: Node) -> None:
    """Make a number what `setattr` puts into a message."""
    given = parts_of(arguments)
    section = section_of(work, given[0]) if len(given) == 3 else None
    if section is None:
        return
    folded = work.analysis.resolver.fold(given[1], work.scope(call))
    name = folded.value if isinstance(folded, Known) else None
    types = {each.type for each in section.fields if name in (None, each.name)}
    if len(types) == 1:
        put(work, write_value(work, given[2], types.pop()) or [])
    elif any(each.name.startswith("float") for each in types):
        work.mark(call, "setattr", "a field of a number takes a `float` only")


def _port_publish(work: Work, call: Node, callee: Node, arguments: Node) -> None:
    """Make the message that rospy makes of what is given to `publish`."""
    given = given_to(work, arguments)
    holder = callee.child_by_field_name("object")
    site = site_of(work, holder, EndpointKind.PUBLISHER) if holder is not None else None
    if site is None and holder is not None and _is_foreign(work, holder):
        return
    if given is not None and len(given) == 1 and given[0][0] is None:
        value = given[0][1]
        kind = kind_of(work, value)
        if not is_plain(kind):
            if some_plain(work, value) or (kind is None and _takes_value(work, site)):
                _mark_publish(work, call)
            return
    class_ = visible_type(work, site, call) if site is not None else None
    if given is None or site is None or class_ is None or site.endpoint.type is None:
        if holder is not None:
            _mark_publish(work, call)
        return
    if not given:
        work.insert(arguments.start_byte + 1, f"{class_}()")
        return
    fields = fields_of(work, site.endpoint.type, InterfaceKind.MESSAGE, "")
    splices = write_fields(work, given, fields) if fields is not None else None
    if splices is None:
        _mark_publish(work, call)
        return
    wrap(work, class_, parts_of(arguments), splices)


def _takes_value(work: Work, site: Site | None) -> bool:
    """Tell whether what a publisher takes may be the only field of its message, in rospy.

    A publisher that nobody knows is one of the file's.
    """
    publishers = [
        each for each in work.analysis.sites if each.endpoint.kind is EndpointKind.PUBLISHER
    ]
    for each in [site] if site is not None else publishers:
        type_ = each.endpoint.type
        fields = fields_of(work, type_, InterfaceKind.MESSAGE, "") if type_ is not None else None
        types = list(fields.values()) if fields is not None else []
        if len(types) != 1 or types[0] is None or types[0].package is not None:
            return False
    return site is not None or bool(publishers)


def wrap(work: Work, class_: str, items: list[Node], splices: list[Splice]) -> None:
    """Put the call of a class around the values that it takes."""
    work.insert(items[0].start_byte, f"{class_}(")
    put(work, splices)
    work.insert(items[-1].end_byte, ")")


def put(work: Work, splices: list[Splice]) -> None:
    """Note what values become."""
    for each in splices:
        if each.text or each.end > each.start:
            work.cut(each)


def _mark_publish(work: Work, call: Node) -> None:
    work.mark(call, "publish takes a message", "make the message first")


def _is_foreign(work: Work, holder: Node) -> bool:
    """Tell whether what publishes is of the file's own, or of another library, for sure."""
    found = work.analysis.resolver.instance(holder, work.scope(holder))
    if found is not None and found.scope is not None:
        return "publish" in found.scope.bindings
    return found is not None and bool(found.qualified) and "rospy." not in found.qualified


def _port_handler(work: Work, site: Site) -> None:
    """Make the response that rospy makes of what a handler returns."""
    if site.shape.callback is None:
        return
    given = site.arguments.get(site.shape.callback)
    if given is not None and given.type == "lambda":
        body = given.child_by_field_name("body")
        if body is not None:
            _port_return(work, site, given, body)
        return
    function = work.callback_of(site) or _wrapped_function(work, site, given)
    if function is None or function.node.id in work.done:
        return
    work.done.add(function.node.id)
    is_shared = any(
        work.callback_of(other) is function
        and (other.endpoint.kind, other.endpoint.type) != (site.endpoint.kind, site.endpoint.type)
        for other in work.analysis.sites
    )
    pending = list(function.node.named_children)
    while pending:
        node = pending.pop()
        if node.type in _FUNCTIONS:
            continue
        if node.type == "return_statement":
            value = next(iter(parts_of(node)), None)
            if not is_shared:
                _port_return(work, site, node, value)
            elif value is None or not is_side(work, value, "Response"):
                work.mark(node, "return a response", _RESPONSE)
        pending.extend(node.named_children)


def _wrapped_function(work: Work, site: Site, given: Node | None) -> Scope | None:
    """Return the function of the file that is wrapped in a `functools.partial`."""
    target = callback_target(given, site.scope, work.analysis)
    if target is None or target is given or target.type != "identifier":
        return None
    found = site.scope.lookup(work.slice(target))
    owners = [each.owner for each in found[1]] if found is not None else []
    return owners[0] if len(owners) == 1 else None


def _port_return(work: Work, site: Site, statement: Node, value: Node | None) -> None:
    """Make a response of what is returned; mark what may be none."""
    if value is not None and is_side(work, value, "Response"):
        return
    type_, class_ = site.endpoint.type, visible_type(work, site, statement)
    given = _returned(work, value) if value is not None else None
    fields = fields_of(work, type_, InterfaceKind.SERVICE, "Response") if type_ else None
    splices = None
    if given is not None and fields is not None:
        splices = write_fields(work, given, fields)
    if value is None or class_ is None or splices is None:
        work.mark(statement, "return a response", _RESPONSE)
        return
    made = f"{class_}.Response("
    if value.type not in ("list", "tuple", "dictionary", "expression_list"):
        wrap(work, made[:-1], [value], splices)
        return
    # The brackets go, and what is between them stays where it is.
    is_bare = value.type == "expression_list"
    start = value.start_byte if is_bare else value.start_byte + 1
    end = value.end_byte if is_bare else value.end_byte - 1
    encode = work.analysis.syntax.encode
    work.cut(Splice(value.start_byte, start, encode(made)))
    put(work, splices)
    if value.type == "dictionary":
        _name_keys(work, value)
    work.cut(Splice(end, value.end_byte, b")"))


def _name_keys(work: Work, value: Node) -> None:
    """Write the keys of a dictionary as keywords."""
    encode = work.analysis.syntax.encode
    for pair in parts_of(value):
        key, held = pair.child_by_field_name("key"), pair.child_by_field_name("value")
        if key is not None and held is not None:
            name = work.slice(key)[1:-1]
            work.cut(Splice(key.start_byte, held.start_byte, encode(f"{name}=")))


def _returned(work: Work, value: Node) -> Given | None:
    """Return the values that rospy puts into a response, None where it is not sure."""
    if value.type == "dictionary":
        found: Given = []
        for pair in parts_of(value):
            key, held = pair.child_by_field_name("key"), pair.child_by_field_name("value")
            name = work.slice(key)[1:-1] if key is not None and key.type == "string" else ""
            if held is None or not name.isidentifier():
                return None
            found.append((name, held))
        return found
    if value.type in ("list", "tuple", "expression_list"):
        items = parts_of(value)
        return None if any("splat" in each.type for each in items) else [(None, x) for x in items]
    kind = kind_of(work, value)
    if kind in (None, LIST, "dict") or not is_plain(kind):
        return None
    return [(None, value)]


def is_side(work: Work, value: Node, side: str) -> bool:
    """Tell whether an expression is a response, or request, for sure: one made, or a name of it."""
    if value.type == "parenthesized_expression":
        return is_side(work, value.named_children[0], side)
    if value.type == "conditional_expression":
        parts = parts_of(value)
        return is_side(work, parts[0], side) and is_side(work, parts[-1], side)
    callee = value.child_by_field_name("function")
    if callee is not None:
        return any(".srv." in f".{name}" and name.endswith(side) for name in work.qualified(callee))
    made = [
        each.value is not None and each.value.type == "call" and is_side(work, each.value, side)
        for each in work.bindings(value)
    ]
    return bool(made) and all(made)
