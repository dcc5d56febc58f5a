"""Giving an endpoint another type: in its call, its member, its callback, and the includes."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from tree_sitter import Node

from plastron_tui.ros.interfaces import InterfaceKind, InterfaceName
from plastron_tui.sources.splices import line_end, line_start, newline_of

from .. import interface_types
from ..scopes import CppFile, Variable, scope_at
from ..shapes import OBJECTS
from .creation import creation_of
from .include_place import add_include
from .leftovers import headers_of, named
from .replacing import NotInPlaceError, Replacement
from .resending import Sending
from .retyped_callbacks import called_back, check_retyped, vanishing
from .statements import is_inside
from .uses import uses_of

_POINTER = re.compile(r"(?:Const)?Ptr\Z|(?:::(?:Const)?(?:Shared|Unique|Weak)?Ptr)\Z")
_PART = re.compile(r"::(?:Request|Response|Event)(?:Type)?\b.*|(?:Request|Response)(?:Ptr)?\Z")
# Methods that are the same whatever the type is.
_ANY_TYPE = frozenset(
    {b"shutdown", b"reset", b"on_activate", b"on_deactivate", b"service_is_ready", b"isValid"}
    | {b"wait_for_service", b"waitForExistence", b"exists", b"getService", b"getTopic"}
    | {b"get_service_name", b"get_topic_name", b"getNumSubscribers", b"get_subscription_count"}
)
# Functions that Plastron writes, for any type.
_WAITS = frozenset({b"is_served", b"wait_until_served", b"wait_for_action"})
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
        check_retyped(update, type_, kind)
    is_said = sum(written.put_types(site.file, each) for each in site.call.type_nodes)
    is_said += _retype_variable(update, written, sent)
    for each in sent:
        _retype_sent(each, written)
    if calls_same:
        is_said += _retype_callback(update, written)
    else:
        is_said += site.shape.type == "callback"
        for function in vanishing(update):
            listed = function.declarator.child_by_field_name("parameters")
            if listed is not None:
                written.note(function.file, listed)
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
    if type_node is None:
        return 0
    said = variable.file.syntax.word(type_node)
    if "<" not in said:
        scope = scope_at(variable.file, type_node.start_byte)
        if "<" in update.analysis.types.expand(said, scope):
            # A name of the file stands for the old type; others may say it too.
            raise NotInPlaceError
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
        not (file is creation.file and is_inside(node, whole))
        and not _only_ends(node)
        and not any(is_inside(node, each.sent.call) for each in sent if each.sent.file is file)
        for file, node, _ in uses_of(update.analysis, variable)
        if node.id != own.id
    )


def _only_ends(node: Node) -> bool:
    outer = node.parent
    field = None if outer is None else outer.child_by_field_name("field")
    text = b"" if field is None else field.text or b""
    call = None if outer is None or outer.type != "argument_list" else outer.parent
    called = None if call is None else call.child_by_field_name("function")
    return text in _ANY_TYPE or (called is not None and called.text in _WAITS)


def _retype_callback(update: Replacement, written: _Written) -> int:
    """Write the new type in what the endpoint calls back: its declaration, its definition."""
    given, functions = called_back(update)
    if given is None:
        return 0
    found = written.put_types(update.site.place.file, given)
    for each in functions:
        listed_parameters = each.declarator.child_by_field_name("parameters")
        if listed_parameters is not None:
            found += written.put_types(each.file, listed_parameters)
    return found


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
    # Whether headers include it, and the source: a header does not see what its source includes.
    having = {
        bool(file.name)
        for file in files
        if any(include.path == header for include in file.syntax.includes)
    }
    is_named = _is_named(update, old, places)
    saying = [each for each in files if any(name == each.name for name, _, _ in places)]
    own = next((each for each in saying if each.name), files[0])
    for file in files:
        text = file.syntax.text
        # What a header includes, and does not need itself, may be for other sources.
        says = any(name == file.name for name, _, _ in places)
        is_kept = is_named or (bool(file.name) and not says)
        for include in file.syntax.includes:
            if include.path not in headers:
                continue
            start = line_start(text, include.start)
            is_there = True in having or (not file.name and bool(having))
            if not is_kept and not is_there:
                at = text.index(include.path.encode(), start)
                update.put_between(file, at, at + len(include.path.encode()), header)
            elif not is_kept:
                update.put_between(file, start, line_end(text, start), "")
            elif not is_there and bool(file.name) and not says:
                # Who says the new type includes it, and not a header that others have too.
                add_include(update.plan, update.analysis.unit, own, header, version)
            elif not is_there:
                line = f"#include <{header}>" if include.is_angled else f'#include "{header}"'
                end = line_end(text, start)
                update.put_between(file, end, end, line + newline_of(text).decode())
            having.add(bool(file.name))
    if not having:
        raise NotInPlaceError


def _is_named(update: Replacement, old: InterfaceName, places: set[tuple[str, int, int]]) -> bool:
    """Tell whether anything else says the old type."""
    pattern = named(old.name)
    for file in update.analysis.unit.all_files:
        own = [(start, end) for name, start, end in places if name == file.name]
        for found in pattern.finditer(file.syntax.code):
            if not any(start <= found.start() < end for start, end in own):
                return True
    return False
