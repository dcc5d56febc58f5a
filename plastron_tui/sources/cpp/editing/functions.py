"""Functions that an edit writes, and where they go."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from tree_sitter import Node

from plastron_tui.model.source import EndpointKind

from ..scopes import CppFile, Function, Scope
from .adding import Addition
from .doc_comments import comment_like, is_apart
from .lambdas import handed_functions
from .members import access_of

_LAST_NAME = re.compile(r"(\w+)$")


def callbacks_of(added: Addition, kind: EndpointKind | None = None) -> list[Function]:
    """Return the functions that the node's endpoints of a kind call, those of its own class."""
    found: list[Function] = []
    for site in added.sites:
        if kind is not None and site.endpoint.kind is not kind:
            continue
        called = site.callback.functions or handed_functions(added.analysis, site, added.owner)
        for function in called:
            owner = added.analysis.unit.class_of_function(function)
            if function.file.is_beside:
                continue
            if owner is added.owner and all(each is not function for each in found):
                found.append(function)
    return found


def write_function(
    added: Addition,
    name: str,
    parameters: Sequence[str],
    body: Iterable[str],
    said: str,
    returns: str = "void",
) -> CppFile:
    """Write a function that an endpoint calls: a method of its class, or one of its namespace.

    Args:
        added: the endpoint.
        name: the name of the function.
        parameters: its parameters.
        body: its statements.
        said: what it is for, where functions of the file have comments that say so.
        returns: what it returns.

    Returns:
        The file that has the first mention of its parameters: that of its declaration.
    """
    owner = added.owner
    function = _New(
        name,
        parameters,
        [f"\t{each}" if each else "" for each in body],
        said,
        returns,
        callbacks_of(added, added.kind) or callbacks_of(added),
    )
    if owner is None:
        return _write_free(added, function)
    definitions = [each for each in function.like if each.scope is not None]
    place = added.place.function
    outside = [each for each in definitions if each.qualifier and each.file is added.place.file]
    is_template = owner.parent is not None and owner.parent.kind == "template"
    is_outside = bool(outside) or (not definitions and bool(place.qualifier))
    if not is_outside or is_template:
        _write_inline(added, owner, definitions, function)
        return owner.file
    model = max(outside, key=lambda each: each.node.start_byte) if outside else place
    style = added.style(model.file)
    node = _whole(model.node)
    others = [
        each
        for scope in model.file.scopes
        if scope.kind == "function" and (each := scope.function) is not None and each.qualifier
    ]
    comment = function.comment(model.file, [_whole(each.node) for each in outside or others])
    written = [*comment, *style.opened(function.head(f"{model.qualifier}::")), *function.body, "}"]
    added.put_behind(model.file, node, written, gap=True)
    _declare(added, owner, function)
    return owner.file


@dataclass(frozen=True, slots=True)
class _New:
    """A function on its way into a file; see `write_function`.

    Attributes:
        like: the functions of the files that are like it.
    """

    name: str
    parameters: Sequence[str]
    body: Sequence[str]
    said: str
    returns: str
    like: list[Function]

    def head(self, qualifier: str = "") -> str:
        """Write what stands before its body."""
        return f"{self.returns} {qualifier}{self.name}({', '.join(self.parameters)})"

    def comment(self, file: CppFile, nodes: Sequence[Node]) -> list[str]:
        """Return the lines that document it, as functions of a file have them."""
        names = [found[1] for each in self.parameters if (found := _LAST_NAME.search(each))]
        return comment_like(file, nodes, self.said, names, returns=self.returns != "void")


def _whole(node: Node) -> Node:
    """Return a definition with the `template<…>` before it."""
    parent = node.parent
    return parent if parent is not None and parent.type == "template_declaration" else node


def _write_inline(
    added: Addition, owner: Scope, definitions: list[Function], function: _New
) -> None:
    style = added.style(owner.file)
    own = [_whole(each.node) for each in definitions if each.place is owner]
    comment = function.comment(owner.file, own or _functions(owner))
    written = [*comment, *style.opened(function.head()), *function.body, "}"]
    beside = own or _private_functions(owner)
    if beside:
        last = max(beside, key=lambda each: each.start_byte)
        added.put_behind(owner.file, last, written, gap=True)
        return
    specifier = _private_specifier(owner)
    if specifier is not None:
        _put_behind_specifier(added, owner, specifier, [*written, ""])
    elif owner.node.type == "class_specifier":
        added.hidden_functions.append(written)
    else:
        body = owner.node.child_by_field_name("body")
        assert body is not None, "a class that creates something has a body"
        functions = _functions(owner) or body.named_children
        added.put_behind(owner.file, functions[-1], written, gap=True)


def _declare(added: Addition, owner: Scope, function: _New) -> None:
    """Declare a method beside those that are like it."""
    own = [
        declared.node
        for each in function.like
        for declared in owner.functions.get(each.name, ())
        if declared.scope is None
    ]
    comment = function.comment(owner.file, own or _functions(owner))
    written = [*comment, f"{function.head()};"]
    own = own or _private_functions(owner)
    if own:
        last = max(own, key=lambda each: each.start_byte)
        gap = bool(comment) and is_apart(owner.file, last)
        added.put_behind(owner.file, last, written, gap=gap)
        return
    specifier = _private_specifier(owner)
    if specifier is not None:
        _put_behind_specifier(added, owner, specifier, written)
    elif owner.node.type == "class_specifier":
        added.hidden_functions.append(written)
    elif functions := _functions(owner):
        added.put_behind(owner.file, functions[-1], written)


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


def _write_free(added: Addition, function: _New) -> CppFile:
    file = added.place.file
    style = added.style(file)
    creating = added.place.function.node
    before = [
        _whole(each.node)
        for each in function.like
        if each.scope is not None
        and each.file is file
        and each.node.end_byte <= creating.start_byte
    ]
    comment = function.comment(file, before)
    written = [*comment, *style.opened(function.head()), *function.body, "}"]
    if before:
        last = max(before, key=lambda each: each.start_byte)
        added.put_behind(file, last, written, gap=True)
    else:
        added.put_above(file, _whole(creating), written, gap=True)
    return file
