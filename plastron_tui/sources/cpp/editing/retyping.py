"""Giving an endpoint another type: in its call, its member, its callback, and the includes."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence

from tree_sitter import Node

from plastron_tui.diagnostics import Diagnostic, codes, listed
from plastron_tui.model.kinds import callback_of
from plastron_tui.ros.interfaces import Interface, InterfaceKind, InterfaceName
from plastron_tui.sources.splices import line_end, line_start, newline_of

from .. import interface_types
from ..scopes import CppFile, Function, Scope, Variable, last_name
from ..shapes import OBJECTS
from .creation import creation_of
from .deletions import Deletions
from .leftovers import functions_of, has_uses, headers_of, is_stub, named
from .replacing import NotInPlaceError, OtherCodeError, Replacement
from .resending import Sending
from .uses import scope_at, uses_of, word

_POINTER = re.compile(r"(?:Const)?Ptr\Z|(?:::(?:Const)?(?:Shared|Unique|Weak)?Ptr)\Z")
_PART = re.compile(r"::(?:Request|Response|Event)(?:Type)?\b.*|(?:Request|Response)(?:Ptr)?\Z")
_NUMBERS = frozenset(
    [f"{sign}int{bits}" for sign in ("u", "") for bits in (8, 16, 32, 64)] + ["float32", "float64"]
)
_BOTH = 2
_TYPES = frozenset({"qualified_identifier", "type_identifier"})


def retype(
    update: Replacement,
    type_: InterfaceName,
    kind: InterfaceKind,
    *,
    calls_same: bool,
    sent: Sequence[Sending] = (),
) -> None:
    """Write another type wherever an endpoint says its own.

    Args:
        update: the change.
        type_: the type.
        kind: its kind.
        calls_same: whether the endpoint goes on calling what it calls.
        sent: what is sent through the endpoint, and will be filled anew.

    Raises:
        OtherCodeError: what it calls is made for the old type; nothing was written yet.
        NotInPlaceError: something of the file is made for the old type.
    """
    site, analysis = update.site, update.analysis
    old = site.endpoint.type
    if old is None or site.shape.fixed is not None or site.shape in OBJECTS.values():
        raise NotInPlaceError
    new_class = interface_types.class_name(type_, kind, analysis.ros_version)
    written = _Written(update, old, new_class)
    if calls_same:
        _check_callback(update, type_, kind)
    is_said = sum(written.put_types(site.file, each) for each in site.call.type_nodes)
    is_said += _retype_variable(update, written, sent)
    for each in sent:
        _retype_sent(each, written)
    if calls_same:
        is_said += _retype_callback(update, written)
    elif site.shape.type == "callback":
        is_said = 1
    if not is_said:
        raise NotInPlaceError
    _include(update, old, type_, kind, written.places)


def _retype_sent(sending: Sending, written: _Written) -> None:
    """Write the new type where a message is made that is sent, or goes."""
    sent = sending.sent
    if sending.refilling is not None:
        if sent.variable is None or not written.put_types(sent.file, sent.variable.node):
            raise NotInPlaceError
        return
    for node in (sent.given, *sending.unused):
        if node is not None:
            written.note(sent.file, node)


class _Written:
    """The places that say the old type.

    Attributes:
        places: where they are.
    """

    def __init__(self, update: Replacement, old: InterfaceName, new_class: str) -> None:
        self._update = update
        self._old = old
        self._new_class = new_class
        self.places: set[tuple[str, int, int]] = set()

    def put_types(self, file: CppFile, node: Node) -> int:
        """Write the new type in a part of a file; return how often that says the old one."""
        found = 0
        for each in self._types(file, node):
            self.places.add((file.name, each.start_byte, each.end_byte))
            self._update.put(file, each, self._text(file.syntax.word(each)))
            found += 1
        return found

    def note(self, file: CppFile, node: Node) -> None:
        """Note that a part of a file says the old type no longer."""
        self.places |= {
            (file.name, each.start_byte, each.end_byte) for each in self._types(file, node)
        }

    def _types(self, file: CppFile, node: Node) -> Iterator[Node]:
        types = self._update.analysis.types
        pending = [node]
        while pending:
            each = pending.pop()
            if each.type in _TYPES:
                text = "".join(file.syntax.word(each).split())
                scope = scope_at(file, each.start_byte)
                has_templates = "<" in text
                if not has_templates and types.interface(text, scope, True) == self._old:
                    yield each
                    continue
            if each.type != "compound_statement":
                pending += each.named_children

    def _text(self, said: str) -> str:
        """Return the new type with what the old one has behind it: `::SharedPtr`, `ConstPtr`."""
        said = "".join(said.split())
        name = self._old.name
        found = re.search(rf"(?:\A|::){re.escape(name)}(?P<rest>(?:::|Const|Ptr|Re).*)?\Z", said)
        if found is not None:
            return self._new_class + (found["rest"] or "")
        behind = _PART.search(said) or _POINTER.search(said)
        return self._new_class + ("" if behind is None else behind[0])


def _retype_variable(update: Replacement, written: _Written, sent: Sequence[Sending]) -> int:
    """Write the new type where the variable is declared that holds the endpoint."""
    site = update.site
    creation = creation_of(update.analysis, site)
    variable = None if creation is None else creation.variable
    if variable is None:
        return 0
    is_sending = not site.shape.callback
    if is_sending and _is_used(update, variable, sent):
        # What is sent, or asked for, is of the old type.
        raise NotInPlaceError
    type_node = variable.type_node
    if type_node is None or "<" not in variable.file.syntax.word(type_node):
        return 0
    if len(variable.node.children_by_field_name("declarator")) > 1:
        raise NotInPlaceError
    found = written.put_types(variable.file, type_node)
    if not found:
        raise NotInPlaceError
    return found


def _is_used(update: Replacement, variable: Variable, sent: Sequence[Sending]) -> bool:
    own = update.site.call.node
    creation = creation_of(update.analysis, update.site)
    assert creation is not None
    whole = creation.node
    return any(
        not (file is creation.file and whole.start_byte <= node.start_byte < whole.end_byte)
        and not _only_ends(node)
        and not any(_is_in(node, each.sent.call) for each in sent if each.sent.file is file)
        for file, node, _ in uses_of(update.analysis, variable)
        if node.id != own.id
    )


def _is_in(node: Node, outer: Node) -> bool:
    return outer.start_byte <= node.start_byte < outer.end_byte


def _only_ends(node: Node) -> bool:
    outer = node.parent
    field = None if outer is None else outer.child_by_field_name("field")
    text = b"" if field is None else field.text or b""
    return text in (b"shutdown", b"reset", b"on_activate", b"on_deactivate")


def _retype_callback(update: Replacement, written: _Written) -> int:
    """Write the new type in what the endpoint calls back: its declaration, its definition."""
    given, functions = _called(update)
    if given is None:
        return 0
    found = written.put_types(update.site.place.file, given)
    for each in functions:
        listed_parameters = each.declarator.child_by_field_name("parameters")
        if listed_parameters is not None:
            found += written.put_types(each.file, listed_parameters)
    return found


def _called(update: Replacement) -> tuple[Node | None, list[Function]]:
    """Return what an endpoint calls back, with the functions of the files that this is."""
    site, position = update.site, update.site.shape.callback
    if position is None:
        return None, []
    if position >= len(site.arguments):
        raise NotInPlaceError
    given, place = site.arguments[position], site.place
    name = last_name(given, place)
    if name and update.analysis.unit.lookup(name, place, given.start_byte) is not None:
        # What a variable holds may be called for others as well.
        raise NotInPlaceError
    functions = [each for listed in functions_of(update.analysis, site) for each in listed]
    return given, functions


def _check_callback(update: Replacement, type_: InterfaceName, kind: InterfaceKind) -> None:
    given, functions = _called(update)
    if given is None:
        return
    if functions and _serves_others(update, functions):
        raise OtherCodeError
    _check_body(update, given, functions, type_, kind)


def _serves_others(update: Replacement, functions: list[Function]) -> bool:
    """Whether anything but the endpoint calls a function."""
    analysis, site = update.analysis, update.site
    if any(
        each is not site and set(each.callback.functions) & set(functions)
        for each in analysis.sites
    ):
        return True
    gone = Deletions()
    gone.part(site.file, site.call.node.start_byte, site.call.node.end_byte)
    if site.options is not None:
        node = site.options.node
        gone.part(site.file, node.start_byte, node.end_byte)
    return has_uses(analysis, functions, gone)


def _check_body(
    update: Replacement,
    given: Node,
    functions: list[Function],
    type_: InterfaceName,
    kind: InterfaceKind,
) -> None:
    """Tell of a callback that has code in it for the old type.

    Raises:
        NotInPlaceError: it cannot do with the new one, and no statement says to call it.
    """
    site, interface = update.site, update.catalog.find(type_, kind)
    bodies = list(_bodies(update, given, functions))
    is_stubs = all(is_stub(each) for each in functions if each.scope is not None)
    if functions and is_stubs and not _uses_fields(bodies):
        return
    missing: dict[str, None] = {}
    is_whole = False
    old = None if site.endpoint.type is None else update.catalog.find(site.endpoint.type, kind)
    for body, file, parameters in bodies:
        for section, name in enumerate(parameters):
            is_whole = is_whole or _is_handed_on(body, file, name)
            for field in _fields_used(body, file, name):
                if not _is_same_field(old, interface, section, field):
                    missing[field] = None
    is_named = callback_of(update.change.endpoint) is not None
    if (missing or is_whole) and not is_named:
        raise OtherCodeError(missing)
    if not any(_uses_parameters(*each) for each in bodies):
        return
    what = "its callback" if site.endpoint.callback is None else f"`{site.endpoint.callback}`"
    message = f"{what} was written for `{site.endpoint.type}`, and gets `{type_}`"
    if missing:
        message += f", which has no {listed(f'`{each}`' for each in missing)}"
    help_ = "change it by hand, or name another function with `calling`"
    note = Diagnostic(codes.OTHER_TYPE, message, update.change.endpoint.span, help=help_)
    update.plan.notes.append(note)


def _is_same_field(old: Interface | None, new: Interface | None, section: int, field: str) -> bool:
    """Tell whether a field of a new type is one of the old type's, or a number as that is."""
    types = []
    for interface in (old, new):
        if interface is None or section >= len(interface.sections):
            return False
        fields = interface.sections[section].fields
        types += [each.type for each in fields if each.name == field]
    if len(types) != _BOTH:
        return False
    return types[0] == types[1] or all(
        each.package is None and not each.is_array and each.name in _NUMBERS for each in types
    )


def _is_handed_on(body: Node, file: CppFile, name: str) -> bool:
    """Tell whether code does more with a parameter than to look into it, or to log it."""
    if not name:
        return False
    code = file.syntax.code
    for found in word(name).finditer(code, body.start_byte, body.end_byte):
        if re.match(rb"\s*(?:->|\.)", code[found.end() : found.end() + 8]):
            continue
        before = code[max(body.start_byte, found.start() - 16) : found.start()]
        if re.search(rb"(?:->|\.|\(void\)\s*|static_cast<void>\()\Z", before):
            continue
        return True
    return False


def _bodies(
    update: Replacement, given: Node, functions: Iterable[Function]
) -> Iterator[tuple[Node, CppFile, list[str]]]:
    """Yield what an endpoint calls back: the body, its file, the names of its parameters."""
    for each in functions:
        body = each.body
        if body is not None:
            yield body, each.file, [parameter.name for parameter in each.parameters]
    stack = [given]
    while stack:
        node = stack.pop()
        if node.type == "lambda_expression":
            found = _scope_of(update.site.file, node)
            body = node.child_by_field_name("body")
            if body is not None and found is not None and found.function is not None:
                names = [parameter.name for parameter in found.function.parameters]
                yield body, update.site.file, names
        else:
            stack += node.named_children


def _scope_of(file: CppFile, node: Node) -> Scope | None:
    return next((each for each in file.scopes if each.node.id == node.id), None)


def _fields_used(body: Node, file: CppFile, name: str) -> Iterator[str]:
    """Yield the fields that code uses of a parameter."""
    if not name:
        return
    pattern = re.compile(
        rb"(?<![\w.>])" + re.escape(name.encode()) + rb"\s*(?:->|\.)\s*(\w+)(\s*\()?"
    )
    uses = pattern.finditer(file.syntax.code, body.start_byte, body.end_byte)
    yield from (found[1].decode() for found in uses if found[2] is None)


def _uses_fields(bodies: Iterable[tuple[Node, CppFile, list[str]]]) -> bool:
    return any([*_fields_used(*each[:2], name)] for each in bodies for name in each[2])


def _uses_parameters(body: Node, file: CppFile, names: list[str]) -> bool:
    code = file.syntax.code
    return any(name and word(name).search(code, body.start_byte, body.end_byte) for name in names)


def _include(
    update: Replacement,
    old: InterfaceName,
    new: InterfaceName,
    kind: InterfaceKind,
    places: set[tuple[str, int, int]],
) -> None:
    """Include the new type where the old one is included, which goes if nothing else says it."""
    version = update.analysis.ros_version
    headers = headers_of(old, kind, version)
    header = interface_types.header(new, kind, version)
    files = [each for each in update.analysis.unit.files if not each.is_beside]
    is_there = any(include.path == header for file in files for include in file.syntax.includes)
    is_named = _is_named(update, old, places)
    for file in files:
        text = file.syntax.text
        for include in file.syntax.includes:
            if include.path not in headers:
                continue
            start = line_start(text, include.start)
            if not is_named and not is_there:
                at = text.index(include.path.encode(), start)
                update.put_between(file, at, at + len(include.path.encode()), header)
            elif not is_named:
                update.put_between(file, start, line_end(text, start), "")
            elif not is_there:
                line = f"#include <{header}>" if include.is_angled else f'#include "{header}"'
                end = line_end(text, start)
                update.put_between(file, end, end, line + newline_of(text).decode())
            is_there = True
    if not is_there:
        raise NotInPlaceError


def _is_named(update: Replacement, old: InterfaceName, places: set[tuple[str, int, int]]) -> bool:
    """Tell whether anything else says the old type."""
    pattern = named(old.name)
    for file in update.analysis.unit.files:
        own = [(start, end) for name, start, end in places if name == file.name]
        for found in pattern.finditer(file.syntax.code):
            if not any(start <= found.start() < end for start, end in own):
                return True
    return False
