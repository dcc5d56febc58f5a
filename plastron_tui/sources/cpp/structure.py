"""From the tree of a file to its scopes, variables, functions and calls, in one pass."""

from __future__ import annotations

import re
from collections.abc import Callable

from tree_sitter import Node

from plastron_tui.sources.text_memo import lent

from .arguments import arguments_of, call_of
from .scopes import _FUNCTION_LIKE, _KINDS, CppFile, Function, Scope, Variable, declared, type_text
from .syntax import Syntax

_CLASSES = ("class_specifier", "struct_specifier")
MOST_SCOPES_DEEP = 200
"""Scopes within more others are taken for the innermost of these."""


def outline(name: str, syntax: Syntax) -> CppFile:
    """Return a file with the scopes of its names."""
    file = lent(_outlined, syntax, syntax.text)
    file.name, file.is_beside = name, False
    return file


def _outlined(syntax: Syntax) -> CppFile:
    file = CppFile("", syntax)
    root = Scope(file, "file", "", syntax.root, None, 0, len(syntax.text))
    file.root = root
    file.scopes.append(root)
    events = [
        (node.start_byte, -node.end_byte, _ORDER[capture], capture, node)
        for capture, nodes in syntax.captures("structure").items()
        for node in nodes
    ]
    events.sort(key=lambda event: event[:3])
    stack = [root]
    for start, end, _, capture, node in events:
        while stack[-1].end <= start and len(stack) > 1:
            stack.pop()
        inner = stack[-1]
        if capture == "scope":
            if node.type == "compound_statement" and inner.kind == "function":
                continue
            if node.type in _CLASSES and node.child_by_field_name("body") is None:
                continue
            scope = _scope(node, inner, start, -end)
            file.scopes.append(scope)
            if len(stack) < MOST_SCOPES_DEEP:
                stack.append(scope)
        else:
            _HANDLERS[capture](node, inner)
    return file


def _scope(node: Node, parent: Scope, start: int, end: int) -> Scope:
    kind = _KINDS.get(node.type, "block")
    syntax = parent.file.syntax
    scope = Scope(parent.file, kind, "", node, parent, start, end)
    if kind in ("namespace", "class"):
        name = node.child_by_field_name("name")
        scope.name = "" if name is None else "".join(syntax.word(name).partition("<")[0].split())
    if kind == "class":
        scope.bases = tuple(_bases(node, syntax))
    elif kind == "template":
        scope.template_names = tuple(_template_names(node, syntax))
    elif kind in _FUNCTION_LIKE:
        _add_function(scope, parent)
    return scope


def _bases(node: Node, syntax: Syntax) -> list[str]:
    clause = next((each for each in node.children if each.type == "base_class_clause"), None)
    if clause is None:
        return []
    kinds = ("type_identifier", "qualified_identifier", "template_type")
    return [type_text(syntax.word(each)) for each in clause.named_children if each.type in kinds]


def _template_names(node: Node, syntax: Syntax) -> list[str]:
    listed = node.child_by_field_name("parameters")
    found = []
    for each in listed.named_children if listed is not None else ():
        names = [inner for inner in each.named_children if inner.type == "type_identifier"]
        if names:
            found.append(syntax.word(names[0]))
        else:
            found.append("")
    return found


def _add_function(scope: Scope, parent: Scope) -> None:
    """Note what a scope is the body of, and its parameters."""
    syntax = scope.file.syntax
    outer = scope.node.child_by_field_name("declarator")
    name, _, function, _, _ = declared(outer, syntax)
    if scope.kind == "lambda":
        function = outer
    if function is None:
        return
    qualifier, _, last = _split(name)
    scope.name = last
    made = Function(last, qualifier, scope.node, function, scope, parent)
    scope.function = made
    for parameter in made.parameters:
        if parameter.name:
            scope.variables.setdefault(parameter.name, []).append(parameter)
    if scope.kind == "function" and last:
        _place(parent).functions.setdefault(last, []).append(made)


def _split(name: str) -> tuple[str, str, str]:
    return "".join(name.split()).rpartition("::")


def _place(scope: Scope) -> Scope:
    while scope.kind == "template" and scope.parent is not None:
        scope = scope.parent
    return scope


def _add_declaration(node: Node, scope: Scope) -> None:
    type_node = node.child_by_field_name("type")
    if type_node is None:
        _add_constructor(node, scope)
        return
    syntax = scope.file.syntax
    value = node.child_by_field_name("default_value")
    kind = {"class": "member", "namespace": "global", "file": "global"}.get(
        _place(scope).kind, "local"
    )
    for outer in node.children_by_field_name("declarator"):
        declarator = outer
        arguments = None
        given = value
        if outer.type == "init_declarator":
            inner = outer.child_by_field_name("declarator")
            given = outer.child_by_field_name("value")
            declarator = outer if inner is None else inner
        if given is not None and given.type in ("argument_list", "initializer_list"):
            is_assigned = b"=" in syntax.code[declarator.end_byte : given.start_byte]
            if given.type == "argument_list" or not is_assigned:
                arguments, given = arguments_of(given), None
        name, inner, function, pointer, reference = declared(declarator, syntax)
        if function is not None:
            if kind != "local":
                qualifier, _, last = _split(name)
                made = Function(last, qualifier, node, function, None, scope)
                _place(scope).functions.setdefault(last, []).append(made)
                continue
            # In a body `T it(nh);` makes an object.
            arguments = arguments_of(function.child_by_field_name("parameters"))
        if not name:
            continue
        start = outer.start_byte
        found = Variable(
            name.rpartition("::")[2],
            kind,
            type_node,
            node,
            scope,
            start,
            given,
            arguments,
            inner,
            pointer,
            reference,
        )
        _place(scope).variables.setdefault(found.name, []).append(found)


def _add_constructor(node: Node, scope: Scope) -> None:
    """Note the declaration of a constructor, which has no type."""
    place = _place(scope)
    name, _, function, _, _ = declared(node.child_by_field_name("declarator"), scope.file.syntax)
    if place.kind == "class" and function is not None and name == place.name:
        made = Function(name, "", node, function, None, scope)
        place.functions.setdefault(name, []).append(made)


def _add_enumerator(node: Node, scope: Scope) -> None:
    name = node.child_by_field_name("name")
    if name is None:
        return
    place = _place(scope)
    kind = "member" if place.kind == "class" else "global"
    word = scope.file.syntax.word(name)
    value = node.child_by_field_name("value")
    found = Variable(word, kind, None, node, scope, node.start_byte, value, None, name)
    place.variables.setdefault(word, []).append(found)


def _add_loop(node: Node, scope: Scope) -> None:
    """Note the variable of `for (auto x : list)`: its value is one of several."""
    syntax = scope.file.syntax
    declarator = node.child_by_field_name("declarator")
    name, inner, _, pointer, reference = declared(declarator, syntax)
    type_node = node.child_by_field_name("type")
    right = node.child_by_field_name("right")
    if name and right is not None:
        found = Variable(
            name, "loop", type_node, node, scope, node.start_byte, right, None, inner, pointer,
            reference,
        )  # fmt: skip
        scope.variables.setdefault(name, []).append(found)


def _add_alias(node: Node, scope: Scope) -> None:
    syntax = scope.file.syntax
    place = _place(scope)
    if node.type == "alias_declaration":
        name, type_ = node.child_by_field_name("name"), node.child_by_field_name("type")
        if name is not None and type_ is not None:
            place.aliases[syntax.word(name)] = type_text(syntax.word(type_))
    elif node.type == "namespace_alias_definition":
        name = node.child_by_field_name("name")
        target = node.named_children[-1] if node.named_child_count > 1 else None
        if name is not None and target is not None:
            place.aliases[syntax.word(name)] = type_text(syntax.word(target))
    else:
        type_ = node.child_by_field_name("type")
        for declarator in node.children_by_field_name("declarator"):
            word, _, function, _, _ = declared(declarator, syntax)
            if type_ is not None and word and function is None:
                place.aliases[word] = type_text(syntax.word(type_))


_USING = re.compile(r"using\s+(namespace\b)?\s*([\w:\s]+?)\s*;?\Z")


def _add_using(node: Node, scope: Scope) -> None:
    found = _USING.match(scope.file.syntax.word(node))
    if found is None:
        return
    name = "".join(found[2].split()).removeprefix("::")
    if found[1]:
        _place(scope).usings.append(name)
    else:
        _place(scope).aliases.setdefault(name.rpartition("::")[2], name)


def _add_call(node: Node, scope: Scope) -> None:
    call = call_of(node, scope, scope.file.syntax)
    if call is not None:
        scope.file.calls.append(call)


_HANDLERS: dict[str, Callable[[Node, Scope], None]] = {
    "declaration": _add_declaration,
    "loop": _add_loop,
    "enumerator": _add_enumerator,
    "alias": _add_alias,
    "using": _add_using,
    "call": _add_call,
    "assignment": lambda node, scope: scope.file.assignments.append((node, scope)),
    "initializer": lambda node, scope: scope.file.initializers.append((node, scope)),
    "new": lambda node, scope: scope.file.news.append((node, scope)),
}
_ORDER = {"scope": 0, **dict.fromkeys(_HANDLERS, 1)}
