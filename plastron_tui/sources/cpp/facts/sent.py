"""The messages that the code of a unit publishes, where all that it does with them is known."""

from __future__ import annotations

import re
from collections.abc import Iterator

from tree_sitter import Node

from plastron_tui.model.code_facts import REMOVING, MessageType, Part, Sent, adds
from plastron_tui.sources.cpp.analysis import Analysis
from plastron_tui.sources.cpp.arguments import Call, arguments_of, call_of
from plastron_tui.sources.cpp.scopes import CppFile, Function, Scope, Variable
from plastron_tui.sources.cpp.type_texts import without_pointer
from plastron_tui.sources.unreachable import is_unreachable

from .fields import method_of
from .mentions import mentions
from .message_types import MessageTypes
from .places import Conditionals, span_of

_LAST = re.compile(r"\w+\Z")
_LOOPS = frozenset({"do_statement", "for_range_loop", "for_statement", "while_statement"})
_MAKERS = frozenset({"make_shared", "make_unique"})


def sent_messages(analysis: Analysis, types: MessageTypes) -> Iterator[Sent]:
    """Yield the messages that are published."""
    conditionals = {id(file): Conditionals(file) for file in analysis.unit.files}
    for call in analysis.unit.calls.get("publish", ()):
        file = call.scope.file
        is_one = call.receiver is not None and len(call.arguments) == 1
        if not is_one or file.is_beside or conditionals[id(file)].has(call.node.start_byte):
            continue
        if _is_dead(analysis, call.scope):
            continue
        found = _published(analysis, types, call)
        if found is not None and not is_unreachable(call.node):
            type_, paths, made = found
            yield Sent(type_, paths, span_of(call.node), file.name, made)


def _is_dead(analysis: Analysis, scope: Scope) -> bool:
    """Tell whether nothing of a whole program names the function that a scope is in."""
    unit, function = analysis.unit, scope.around
    if function is None or not function.name.isidentifier() or "main" not in unit.functions:
        return False
    owner = unit.class_of_function(function)
    if function.name == "main" or (owner is not None and owner.name == function.name):
        return False
    known = unit.functions.get(function.name, ())
    if any(b"override" in each.file.syntax.code[slice(*_head(each))] for each in known):
        return False
    word = re.compile(rb"\b" + function.name.encode() + rb"\b")
    mentions = sum(len(word.findall(file.syntax.code)) for file in unit.all_files)
    return mentions <= len(known)


def _head(function: Function) -> tuple[int, int]:
    """Return where a function's declarator is, and what is behind it."""
    end = function.declarator.end_byte
    return function.declarator.start_byte, end + len(" const override")


def _published(
    analysis: Analysis, types: MessageTypes, call: Call
) -> tuple[MessageType, frozenset[tuple[str, ...]], int] | None:
    """Return the type of what a call publishes, the fields that may have got a value, its place."""
    given = _bare(call.arguments[0], call.scope)
    reach = types.of(given, call.scope)
    if given is None or reach is None or reach.path or reach.is_list:
        return None
    if reach.type.part is not Part.MESSAGE:
        return None
    if given.type != "identifier":
        return (reach.type, frozenset(), -1) if _is_empty(analysis, given, call.scope) else None
    name = call.scope.file.syntax.word(given)
    variable = analysis.unit.lookup(name, call.scope, given.start_byte)
    if variable is None or not _is_made_empty(analysis, variable):
        return None
    named = mentions(analysis.unit, variable)
    if named is None or any(file.is_beside for file, _ in named):
        return None
    is_shared = variable.is_pointer or _is_pointer(variable)
    paths: set[tuple[str, ...]] = set()
    for file, node in named:
        if _is_behind(node, call, variable):
            continue
        path = _path(file, node, is_shared=is_shared)
        if path is None:
            return None
        if path:
            paths.add(path)
        if path == REMOVING[:1] and not _is_added(file, node):
            paths.add(REMOVING)
    return reach.type, frozenset(paths), (variable.declarator or variable.node).start_byte


def _is_behind(node: Node, call: Call, variable: Variable) -> bool:
    """Tell whether a variable of a function is only named once it has been sent.

    In a loop it has to be made anew in each turn.
    """
    kinds = ("function", "lambda")
    scopes = call.scope.enclosing(*kinds), variable.scope.enclosing(*kinds)
    if variable.kind != "local" or scopes[0] is None or scopes[0] is not scopes[1]:
        return False
    if node.start_byte < call.node.end_byte or _is_kept(variable):
        return False
    around = call.node.parent
    while around is not None and around.start_byte > variable.node.start_byte:
        if around.type in _LOOPS:
            return False
        around = around.parent
    return True


def _is_kept(variable: Variable) -> bool:
    code = variable.file.syntax.code
    return b"static" in code[variable.node.start_byte : variable.start]


def _is_added(file: CppFile, node: Node) -> bool:
    """Tell whether an action gets a value with which a marker stays, or is shown."""
    current: Node | None = node
    while current is not None and current.type != "assignment_expression":
        current = None if current.type.endswith("statement") else current.parent
    value = current.child_by_field_name("right") if current is not None else None
    return value is not None and adds(file.syntax.word(value).encode())


def _bare(node: Node | None, scope: Scope) -> Node | None:
    """Return what `*msg` and `std::move(msg)` hand on."""
    for _ in range(4):
        if node is None:
            return None
        if node.type == "pointer_expression":
            node = node.child_by_field_name("argument")
        elif node.type == "parenthesized_expression" and node.named_child_count == 1:
            node = node.named_children[0]
        elif node.type == "call_expression":
            call = call_of(node, scope, scope.file.syntax)
            if call is None or call.name != "move" or len(call.arguments) != 1:
                return node
            node = call.arguments[0]
        else:
            return node
    return None


def _is_made_empty(analysis: Analysis, variable: Variable) -> bool:
    """Tell whether a variable begins as a message all of whose fields have their defaults."""
    if variable.kind not in ("local", "member", "global") or variable.is_reference:
        return False
    if variable.kind == "member" and variable.name in analysis.unit.initialized:
        return False
    value = variable.value
    if value is None:
        bare = analysis.types.expand(variable.type, variable.scope)
        is_object = without_pointer(bare) == bare and not variable.is_pointer
        return is_object and not variable.arguments and variable.type != "auto"
    return _is_empty(analysis, value, variable.scope)


def _is_pointer(variable: Variable) -> bool:
    """Tell whether a variable is given a pointer to a message."""
    value = variable.value
    if value is None or value.type != "call_expression":
        return value is not None and value.type == "new_expression"
    call = call_of(value, variable.scope, variable.file.syntax)
    return call is not None and call.name in _MAKERS


def _is_empty(analysis: Analysis, node: Node, scope: Scope) -> bool:
    """Tell whether an expression makes a message without a value for any field."""
    match node.type:
        case "call_expression":
            call = call_of(node, scope, scope.file.syntax)
            if call is None or call.receiver is not None or call.arguments:
                return False
            # What a function of the files returns may have values.
            is_type = call.template is None and call.name not in analysis.unit.functions
            return is_type or call.name in _MAKERS
        case "new_expression":
            return not arguments_of(node.child_by_field_name("arguments"))
        case "compound_literal_expression":
            return not arguments_of(node.child_by_field_name("value"))
        case "initializer_list":
            return not node.named_child_count
        case _:
            return False


def _path(file: CppFile, node: Node, *, is_shared: bool) -> tuple[str, ...] | None:
    """Return the fields that a mention of a message leads to, () where it stays as it is.

    None where more may be done with it: it is handed on, assigned to, or has a method called.
    """
    while (outer := _around(node)) is not None:
        node = outer
    path: list[str] = []
    syntax = file.syntax
    while (parent := node.parent) is not None:
        holder = parent.child_by_field_name("argument")
        if holder is None or holder.id != node.id:
            break
        if parent.type == "field_expression":
            inner = parent.child_by_field_name("field")
            if inner is None or method_of(parent) is not None:
                return tuple(path) or None
            path.append(syntax.word(inner))
        elif parent.type != "subscript_expression" or not path:
            break
        node = parent
    # A pointer that somebody else has leads to the same message.
    if (path or not is_shared) and _is_read(node):
        return ()
    return tuple(path) if path or _is_published(file, node) else None


def _is_read(node: Node) -> bool:
    """Tell whether what a node names is copied, compared or calculated with, and stays as it is."""
    parent = node.parent
    if parent is None:
        return False
    if parent.type == "assignment_expression":
        right = parent.child_by_field_name("right")
        return right is not None and right.id == node.id
    operator = parent.child_by_field_name("operator")
    is_streamed = operator is not None and operator.type == ">>"
    return bool(parent.type == "binary_expression") and not is_streamed


def _around(node: Node) -> Node | None:
    """Return `this->msg`, `*msg` or `(*msg)` around a name, None for none."""
    parent = node.parent
    if parent is None:
        return None
    if parent.type == "parenthesized_expression":
        return parent
    if parent.type == "pointer_expression":
        operator = parent.child_by_field_name("operator")
        return parent if operator is not None and operator.type == "*" else None
    if parent.type == "field_expression" and node.type == "field_identifier":
        holder = parent.child_by_field_name("argument")
        return parent if holder is not None and holder.type == "this" else None
    return None


def _is_published(file: CppFile, node: Node) -> bool:
    """Tell whether a message is all that a call of `publish` gets, moved or not."""
    for _ in range(2):
        listed = node.parent
        call = None if listed is None or listed.type != "argument_list" else listed.parent
        called = None if call is None else call.child_by_field_name("function")
        if listed is None or call is None or called is None or listed.named_child_count != 1:
            return False
        last = _LAST.search(file.syntax.word(called))
        if last is None or last[0] != "move":
            return last is not None and last[0] == "publish"
        node = call
    return False
