"""Functions that an edit writes, and where they go."""

from __future__ import annotations

from collections.abc import Iterable

from tree_sitter import Node

from plastron_tui.model.source import EndpointKind

from ..scopes import CppFile, Function, Scope
from .adding import Addition
from .place import access_of


def callbacks_of(added: Addition, kind: EndpointKind | None = None) -> list[Function]:
    """Return the functions that the node's endpoints of a kind call, those of its own class."""
    found: list[Function] = []
    for site in added.sites:
        if kind is not None and site.endpoint.kind is not kind:
            continue
        for function in site.callback.functions:
            owner = added.analysis.unit.class_of_function(function)
            if function.file.is_beside:
                continue
            if owner is added.owner and all(each is not function for each in found):
                found.append(function)
    return found


def write_function(
    added: Addition, name: str, parameters: str, body: Iterable[str], returns: str = "void"
) -> CppFile:
    """Write a function that an endpoint calls: a method of its class, or one of its namespace.

    Returns:
        The file that has the first mention of its parameters: that of its declaration.
    """
    lines = [f"\t{each}" if each else "" for each in body]
    owner = added.owner
    like = callbacks_of(added, added.kind) or callbacks_of(added)
    if owner is None:
        return _write_free(added, name, parameters, lines, returns, like)
    definitions = [each for each in like if each.scope is not None]
    place = added.place.function
    outside = [each for each in definitions if each.qualifier and each.file is added.place.file]
    is_template = owner.parent is not None and owner.parent.kind == "template"
    is_outside = bool(outside) or (not definitions and bool(place.qualifier))
    if not is_outside or is_template:
        _write_inline(added, owner, definitions, name, parameters, lines, returns)
        return owner.file
    model = max(outside, key=lambda each: each.node.start_byte) if outside else place
    head = f"{returns} {model.qualifier}::{name}({parameters})"
    style = added.style(model.file)
    node = _whole(model.node)
    added.put_behind(model.file, node, [*style.opened(head), *lines, "}"], gap=True)
    _declare(added, owner, like, f"{returns} {name}({parameters});")
    return owner.file


def _whole(node: Node) -> Node:
    """Return a definition with the `template<…>` before it."""
    parent = node.parent
    return parent if parent is not None and parent.type == "template_declaration" else node


def _write_inline(
    added: Addition,
    owner: Scope,
    definitions: list[Function],
    name: str,
    parameters: str,
    lines: list[str],
    returns: str,
) -> None:
    style = added.style(owner.file)
    written = [*style.opened(f"{returns} {name}({parameters})"), *lines, "}"]
    own = [each for each in definitions if each.place is owner]
    if own:
        last = max(own, key=lambda each: each.node.start_byte)
        added.put_behind(owner.file, _whole(last.node), written, gap=True)
        return
    hidden = _private_functions(owner)
    if hidden:
        added.put_behind(owner.file, hidden[-1], written, gap=True)
        return
    specifier = _private_specifier(owner)
    if specifier is not None:
        _put_behind_specifier(added, owner, specifier, [*written, ""])
        return
    body = owner.node.child_by_field_name("body")
    functions = _functions(owner)
    assert body is not None, "a class that creates something has a body"
    added.put_behind(
        owner.file, functions[-1] if functions else body.named_children[-1], written, gap=True
    )


def _declare(added: Addition, owner: Scope, like: list[Function], line: str) -> None:
    """Declare a method beside those that are like it."""
    own = [
        declared.node
        for function in like
        for declared in owner.functions.get(function.name, ())
        if declared.scope is None
    ]
    own = own or _private_functions(owner)
    if own:
        added.put_behind(owner.file, max(own, key=lambda each: each.start_byte), [line])
        return
    specifier = _private_specifier(owner)
    if specifier is not None:
        _put_behind_specifier(added, owner, specifier, [line])
        return
    functions = _functions(owner)
    if functions:
        added.put_behind(owner.file, functions[-1], [line])


def _functions(owner: Scope) -> list[Node]:
    """Return the methods that a class declares or defines, in order."""
    found = [
        _whole(each.node)
        for functions in owner.functions.values()
        for each in functions
        if each.place is owner or each.place.parent is owner
    ]
    return sorted(found, key=lambda node: node.start_byte)


def _private_functions(owner: Scope) -> list[Node]:
    return [each for each in _functions(owner) if access_of(owner, each) != "public"]


def _private_specifier(owner: Scope) -> Node | None:
    body = owner.node.child_by_field_name("body")
    for each in body.named_children if body is not None else ():
        if each.type == "access_specifier" and owner.file.syntax.word(each).strip() != "public":
            return each
    return None


def _put_behind_specifier(added: Addition, owner: Scope, node: Node, lines: list[str]) -> None:
    """Write members behind `private:`."""
    file, text = owner.file, owner.file.syntax.text
    style = added.style(file)
    start = text.rfind(b"\n", 0, owner.node.start_byte) + 1
    outer = text[start : owner.node.start_byte]
    base = outer.decode("ascii") if not outer.strip() else ""
    end = text.find(b"\n", node.end_byte) + 1
    if text[node.end_byte : end].strip(b" \t\r\n:"):
        end = text.find(b":", node.end_byte) + 1
        written = style.newline + style.laid_out(lines, base + style.indent)
    else:
        written = style.laid_out(lines, base + style.indent)
    added.plan.replace(file, end, end, written)


def _write_free(
    added: Addition,
    name: str,
    parameters: str,
    lines: list[str],
    returns: str,
    like: list[Function],
) -> CppFile:
    file = added.place.file
    style = added.style(file)
    written = [*style.opened(f"{returns} {name}({parameters})"), *lines, "}"]
    creating = added.place.function.node
    before = [
        each
        for each in like
        if each.scope is not None
        and each.file is file
        and each.node.end_byte <= creating.start_byte
    ]
    if before:
        last = max(before, key=lambda each: each.node.start_byte)
        added.put_behind(file, _whole(last.node), written, gap=True)
    else:
        added.put_above(file, _whole(creating), written, gap=True)
    return file
