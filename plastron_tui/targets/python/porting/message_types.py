"""The types of messages and of their fields, as far as the file says them."""

from __future__ import annotations

import builtins
from collections.abc import Iterable, Iterator

from tree_sitter import Node

from plastron_tui.model.source import EndpointKind
from plastron_tui.ros.interfaces import FieldType, InterfaceKind, InterfaceName, Section
from plastron_tui.sources.python.analysis import Site
from plastron_tui.sources.python.constants import without_none
from plastron_tui.sources.python.scopes import Binding, BindingKind, Scope

from .port_state import Work
from .types import target_type

_SIDES = ("Request", "Response")
# Each endpoint that calls a function with a message, and which part of its type that is.
_HANDED = {
    EndpointKind.SUBSCRIPTION: InterfaceKind.MESSAGE,
    EndpointKind.SERVICE: InterfaceKind.SERVICE,
}


def constructed(work: Work, callee: Node) -> tuple[InterfaceName, InterfaceKind, str] | None:
    """Return what a class of rospy makes: an interface, its kind, and a service's side."""
    name = work.slice(callee)
    # A package that is imported whole has no `ValueError`.
    if hasattr(builtins, name) and work.scope(callee).lookup(name) is None:
        return None
    return _interface(work.qualified(callee))


def _interface(names: Iterable[str]) -> tuple[InterfaceName, InterfaceKind, str] | None:
    for name in names:
        package, _, rest = name.partition(".")
        kind, _, type_name = rest.partition(".")
        module, _, public = type_name.partition(".")
        if module[:1] == "_" and public:
            type_name = public
        if not package or not type_name or type_name[0] == "_" or "." in type_name:
            continue
        if kind == "msg":
            return InterfaceName(package, type_name), InterfaceKind.MESSAGE, ""
        for side in _SIDES if kind == "srv" else ():
            if type_name.endswith(side) and type_name != side:
                base = type_name[: -len(side)]
                return InterfaceName(package, base), InterfaceKind.SERVICE, side
    return None


def typed(work: Work, node: Node) -> Section | FieldType | None:
    """Return the fields of a message that the file knows, or the type of a field of it."""
    if node.id not in work.types:
        work.types[node.id] = None
        work.types[node.id] = _type(work, node)
    return work.types[node.id]


def _type(work: Work, node: Node) -> Section | FieldType | None:
    if node.type == "attribute":
        holder, part = node.child_by_field_name("object"), node.child_by_field_name("attribute")
        if holder is None or part is None:
            return None
        outer = typed(work, holder)
        if isinstance(outer, FieldType):
            if outer.message is None or outer.is_array:
                return None
            outer = _section(work, outer.message, InterfaceKind.MESSAGE, "")
        if outer is not None:
            fields = {each.name: each.type for each in outer.fields}
            return fields.get(work.slice(part))
        bindings = work.analysis.resolver.attribute_bindings(node, work.scope(node))
    elif node.type == "identifier":
        found = work.scope(node).lookup(work.slice(node))
        bindings = found[1] if found is not None else []
    elif node.type == "call":
        return _of_call(work, node)
    elif node.type == "subscript":
        return _element(work, node.child_by_field_name("value"))
    else:
        return None
    types = [_of_bound(work, each) for each in without_none(bindings)]
    if types and types[0] is not None and all(each == types[0] for each in types):
        return types[0]
    made_by = work.analysis.resolver.instance(node, work.scope(node))
    found_class = _interface([made_by.qualified]) if made_by is not None else None
    return _section(work, *found_class) if found_class is not None else None


def _of_call(work: Work, call: Node) -> Section | None:
    """Return the message that a call makes, or that it waits for."""
    callee = call.child_by_field_name("function")
    made = constructed(work, callee) if callee is not None else None
    if made is not None:
        return _section(work, *made)
    waits = (site for site in work.analysis.sites if site.call.id == call.id)
    site = next((each for each in waits if each.shape.gives_message), None)
    # What waits in rclpy gives a pair, with the message in it.
    is_message = site is not None and work.before.ros_version == 1
    type_ = site.endpoint.type if site is not None and is_message else None
    return _section(work, type_, InterfaceKind.MESSAGE, "") if type_ is not None else None


def _element(work: Work, items: Node | None) -> FieldType | None:
    """Return the type of the elements of an array of messages."""
    found = typed(work, items) if items is not None else None
    if isinstance(found, FieldType) and found.is_array and found.package is not None:
        return found._replace(is_array=False, length=None, bound=None)
    return None


def section_of(work: Work, node: Node) -> Section | None:
    """Return the fields of the message that an expression gives, None where nobody knows it."""
    found = typed(work, node)
    if isinstance(found, FieldType):
        if found.message is None or found.is_array:
            return None
        return _section(work, found.message, InterfaceKind.MESSAGE, "")
    return found


def field_type(work: Work, target: Node) -> FieldType | None:
    """Return the type of the field that an assignment puts something into.

    Where nothing says what the message is, `x.linear.z` is a field of the types that the file
    imports, if they all agree.
    """
    if target.type != "attribute":
        return None
    found = typed(work, target)
    if found is not None:
        return found if isinstance(found, FieldType) else None
    holder = target.child_by_field_name("object")
    outer = holder.child_by_field_name("attribute") if holder is not None else None
    inner = target.child_by_field_name("attribute")
    if holder is None or outer is None or inner is None or typed(work, holder) is not None:
        return None
    if work.analysis.resolver.attribute_bindings(holder, work.scope(holder)):
        return None
    types = _nested(work).get((work.slice(outer), work.slice(inner)), set())
    return next(iter(types)) if len(types) == 1 else None


def _nested(work: Work) -> dict[tuple[str, str], set[FieldType]]:
    """Return the types of the fields of fields of all messages that the file knows, by names."""
    nested: dict[tuple[str, str], set[FieldType]] = {}
    messages = known_messages(work)
    for section in [*_imported(work), *messages.values()]:
        for field in section.fields:
            message = field.type.message
            for inner in messages[message].fields if message in messages else ():
                nested.setdefault((field.name, inner.name), set()).add(inner.type)
    return nested


def known_messages(work: Work) -> dict[InterfaceName, Section]:
    """Return the messages that a file imports or sends, and those in their fields, by name."""
    used = {site.endpoint.type for site in work.analysis.sites}
    pending = [name for name in used if name is not None]
    pending += [name for name, kind, _ in _imports(work) if kind is InterfaceKind.MESSAGE]
    sections = _imported(work)
    found: dict[InterfaceName, Section] = {}
    while pending or sections:
        for field in sections.pop().fields if sections else ():
            if field.type.message is not None:
                pending.append(field.type.message)
        name = pending.pop() if pending else None
        if name is None or name in found:
            continue
        section = _section(work, name, InterfaceKind.MESSAGE, "")
        if section is not None:
            found[name] = section
            sections.append(section)
    return found


def _imported(work: Work) -> list[Section]:
    """Return the messages and the sides of services that a file imports."""
    made = (_section(work, *each) for each in _imports(work))
    return [each for each in made if each is not None]


def _imports(work: Work) -> list[tuple[InterfaceName, InterfaceKind, str]]:
    targets = dict.fromkeys(
        each.target
        for scope in work.analysis.scopes.all
        for bindings in scope.bindings.values()
        for each in bindings
        if each.kind is BindingKind.IMPORT
    )
    return [found for each in targets if (found := _interface([each])) is not None]


def _of_bound(work: Work, binding: Binding) -> Section | None:
    """Return the message that a name is bound to: one that came in, or one that is made."""
    if binding.kind is BindingKind.PARAMETER and binding.owner is not None:
        return _of_parameter(work, binding, binding.owner)
    if binding.node.type == "for_statement":
        left, items = (binding.node.child_by_field_name(each) for each in ("left", "right"))
        one = _element(work, items) if left is not None and left.type == "identifier" else None
        message = one.message if one is not None else None
        return _section(work, message, InterfaceKind.MESSAGE, "") if message is not None else None
    if binding.value is None:
        return None
    found = typed(work, binding.value)
    if isinstance(found, FieldType) and found.message is not None and not found.is_array:
        return _section(work, found.message, InterfaceKind.MESSAGE, "")
    return found if isinstance(found, Section) else None


def _of_parameter(work: Work, binding: Binding, function: Scope) -> Section | None:
    is_first = binding.index == bool(function.self_name)
    callers = list(_callers(work, function)) if is_first else []
    if not callers and binding.value is not None:
        made = typed(work, binding.value) if binding.value.type == "call" else None
        return made if isinstance(made, Section) else None
    types = {(site.endpoint.type, _HANDED[site.endpoint.kind]) for site in callers}
    if len(types) != 1:
        return None
    [(name, kind)] = types
    return _section(work, name, kind, "") if name is not None else None


def _callers(work: Work, function: Scope) -> Iterator[Site]:
    for site in work.analysis.sites:
        if site.endpoint.kind not in _HANDED or site.shape.callback is None:
            continue
        given = site.arguments.get(site.shape.callback)
        is_itself = given is not None and given.id == function.node.id
        if is_itself or work.callback_of(site) is function:
            yield site


def _section(work: Work, name: InterfaceName, kind: InterfaceKind, side: str) -> Section | None:
    """Return the fields of a message, or of a service's side, in ROS 1."""
    target, _ = target_type(work, name, kind)
    new = work.catalog.find(target, kind) if target is not None else None
    found = work.before.find(name, kind) or new
    return found.sections[int(side == "Response")] if found is not None else None
