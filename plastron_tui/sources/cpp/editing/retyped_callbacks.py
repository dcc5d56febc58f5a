"""What an endpoint calls back, and whether that can do with messages of another type."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from tree_sitter import Node

from plastron_tui.diagnostics import Diagnostic, codes, listed
from plastron_tui.model.kinds import callback_of
from plastron_tui.ros.interfaces import FieldType, Interface, InterfaceKind, InterfaceName

from ..scopes import CppFile, Function, Scope, last_name
from .deletions import Deletions
from .leftovers import functions_of, has_uses, is_stub
from .replacing import NotInPlaceError, OtherCodeError, Replacement
from .uses import word

_NUMBERS = frozenset(
    [f"{sign}int{bits}" for sign in ("u", "") for bits in (8, 16, 32, 64)] + ["float32", "float64"]
)


def called_back(update: Replacement) -> tuple[Node | None, list[Function]]:
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


def check_retyped(update: Replacement, type_: InterfaceName, kind: InterfaceKind) -> None:
    """Tell of a callback that has code in it for the old type.

    Raises:
        OtherCodeError: it cannot do with the new one, or others call it too.
        NotInPlaceError: it is not known.
    """
    given, functions = called_back(update)
    if given is None:
        return
    bodies = list(_bodies(update, given, functions))
    if not functions and not bodies:
        # An object that is called, or what another file has: it takes the old type.
        raise NotInPlaceError
    if functions and _serves_others(update, functions):
        raise OtherCodeError
    _check_bodies(update, bodies, functions, type_, kind)


def vanishing(update: Replacement) -> list[Function]:
    """Return the functions that an endpoint calls back, where they only log, and go with that."""
    _, functions = called_back(update)
    defined = [each for each in functions if each.scope is not None]
    if not defined or not all(map(is_stub, defined)) or _serves_others(update, functions):
        return []
    return functions


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


def _check_bodies(
    update: Replacement,
    bodies: list[tuple[Node, CppFile, list[str]]],
    functions: list[Function],
    type_: InterfaceName,
    kind: InterfaceKind,
) -> None:
    """Tell of a callback that has code in it for the old type.

    Raises:
        NotInPlaceError: it cannot do with the new one, and no statement says to call it.
    """
    site, interface = update.site, update.catalog.find(type_, kind)
    is_log = bool(functions) and all(is_stub(each) for each in functions if each.scope is not None)
    missing: dict[str, None] = {}
    differing: dict[str, None] = {}
    is_whole = False
    old = None if site.endpoint.type is None else update.catalog.find(site.endpoint.type, kind)
    for body, file, parameters in bodies:
        for section, name in enumerate(parameters):
            is_whole = is_whole or _is_handed_on(body, file, name)
            for field in _fields_used(body, file, name):
                types = _field_types(old, interface, section, field)
                if types is None or types[1] is None:
                    missing[field] = None
                elif not _is_alike(*types) or (
                    is_log and types[0] != types[1] and _is_formatted(body, file, name, field)
                ):
                    differing[field] = None
    is_named = callback_of(update.change.endpoint) is not None
    lack = _lack(missing, differing)
    if is_log:
        # What logs a field is written anew for another one.
        if lack:
            raise OtherCodeError(lack)
        return
    if (lack or is_whole) and not is_named:
        raise OtherCodeError(lack)
    if not any(_uses_parameters(*each) for each in bodies):
        return
    what = "its callback" if site.endpoint.callback is None else f"`{site.endpoint.callback}`"
    message = f"{what} was written for `{site.endpoint.type}`, and gets `{type_}`"
    if lack:
        message += f", which {lack}"
    help_ = "change it by hand, or name another function with `calling`"
    note = Diagnostic(codes.OTHER_TYPE, message, update.change.endpoint.span, help=help_)
    update.plan.notes.append(note)


def _lack(missing: Iterable[str], differing: Iterable[str]) -> str:
    """Tell what a type has not of what code uses, "" for nothing."""
    parts = [
        f"{word} {listed(f'`{each}`' for each in names)}"
        for word, names in (("no", list(missing)), ("another", list(differing)))
        if names
    ]
    return f"has {' and '.join(parts)}" if parts else ""


def _field_types(
    old: Interface | None, new: Interface | None, section: int, field: str
) -> tuple[FieldType | None, FieldType | None] | None:
    """Return the types of a field of two interfaces, None where these are not known."""
    if old is None or new is None or section >= min(len(old.sections), len(new.sections)):
        return None
    found = [
        next((one.type for one in each.sections[section].fields if one.name == field), None)
        for each in (old, new)
    ]
    return found[0], found[1]


def _is_alike(one: FieldType | None, other: FieldType | None) -> bool:
    """Tell whether a field is of the same type, or a number as before."""
    if one is None or other is None or one == other:
        return one == other
    return all(
        each.package is None and not each.is_array and each.name in _NUMBERS
        for each in (one, other)
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
    for found in pattern.finditer(file.syntax.code, body.start_byte, body.end_byte):
        if found[2] is None:
            yield found[1].decode()


def _is_formatted(body: Node, file: CppFile, name: str, field: str) -> bool:
    """Tell whether a log gives a field to a format, which says the type of a number."""
    words = re.escape(name.encode()), re.escape(field.encode())
    given = re.compile(rb",\s*%s\s*(?:->|\.)\s*%s\s*[,)]" % words)
    return given.search(file.syntax.code, body.start_byte, body.end_byte) is not None


def _uses_parameters(body: Node, file: CppFile, names: list[str]) -> bool:
    code = file.syntax.code
    return any(name and word(name).search(code, body.start_byte, body.end_byte) for name in names)
