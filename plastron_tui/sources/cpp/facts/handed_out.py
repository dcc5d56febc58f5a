"""What a C++ file gives its nodes to."""

from __future__ import annotations

import re
from collections.abc import Iterator

from tree_sitter import Node

from plastron_tui.sources.cpp.analysis import Analysis
from plastron_tui.sources.cpp.receivers import NODE_CLASSES
from plastron_tui.sources.cpp.scopes import CppFile, Variable

from .places import scope_at

MAKING = frozenset({"make_shared", "make_unique"})
"""What makes an object of the class that it is given."""

_HANDED = re.compile(
    rb"\b(?:this|shared_from_this|get_node\w*|(?:\w*_)?(?:node|nh)(?:_?(?:handle|ptr|base))?_*)\b",
    re.I,
)
_PASSING = re.compile(
    r"(?:std::)?(?:move|forward|ref"
    r"|(?:(?:shared|unique)_ptr|(?:static|dynamic)_pointer_cast)<[\w:]+>)"
)
"""What gives what it gets."""

_MOST = 2_000
_LETTERS = frozenset(
    bytes([each]) for each in range(128) if chr(each).isalnum() or each == ord("_")
)


def handed_out(analysis: Analysis, file: CppFile) -> Iterator[tuple[CppFile, Node | None]]:
    """Yield what may be a node and is an argument of something; None where there is too much."""
    for count, node in enumerate(_named(analysis, file)):
        if count > _MOST:
            yield file, None
            return
        given = None
        if node.type == "type_identifier":
            given = _parsed_as_type(analysis, file, node) or _made(file, node)
        elif node.type in ("identifier", "this", "field_identifier"):
            given = _argument(node, file)
        if given is not None and _may_be_node(analysis, file, given):
            yield file, given


def _named(analysis: Analysis, file: CppFile) -> Iterator[Node]:
    """Yield what is called as nodes are, or as what has a node here, and the nodes' classes."""
    classes = {node.owner.name for node in analysis.nodes if node.owner is not None}
    words = classes | {
        variable.name
        for scope in file.scopes
        for variables in scope.variables.values()
        for variable in variables
        if variable.name and _has_node(analysis, variable, classes)
    }
    starts = dict(each.span() for each in file.syntax.matches(_HANDED))
    for word in words:
        starts.update(_places(file.syntax.code, word.encode()))
    for start, end in sorted(starts.items()):
        node = file.syntax.root.descendant_for_byte_range(start, end)
        if node is not None:
            yield node


def _places(code: bytes, word: bytes) -> Iterator[tuple[int, int]]:
    """Yield where a word stands; to look for each is faster than for any of them."""
    end = 0
    while (start := code.find(word, end)) >= 0:
        end = start + len(word)
        if code[end : end + 1] not in _LETTERS and code[max(start - 1, 0) : start] not in _LETTERS:
            yield start, end


def _has_node(analysis: Analysis, variable: Variable, classes: set[str]) -> bool:
    """Tell whether a variable has a node, or a list of nodes."""
    said = set(re.findall(r"\w+", variable.type))
    if not said.isdisjoint(classes | {"Node", "LifecycleNode"}):
        return True
    if variable.type != "auto" or variable.value is None:
        return False
    type_ = analysis.receivers.type_of_variable(variable)
    return type_ in NODE_CLASSES or type_.rpartition("::")[2] in classes


def _made(file: CppFile, node: Node) -> Node | None:
    """Return the argument in `run(std::make_shared<Driver>())`, None for another use of a class."""
    made = node.parent
    while made is not None and made.type in (
        "qualified_identifier", "template_argument_list", "template_function", "type_descriptor"
    ):  # fmt: skip
        made = made.parent
    if made is None or made.type not in ("call_expression", "new_expression"):
        return None
    callee = made.child_by_field_name("function")
    if callee is not None:
        name = file.syntax.word(callee).partition("<")[0].rpartition("::")[2]
        if name not in MAKING:
            return None
    return _argument(made, file)


def _may_be_node(analysis: Analysis, file: CppFile, given: Node) -> bool:
    """Tell whether an expression may be a node: `this` of another class is none."""
    scope = scope_at(file, given.start_byte)
    if given.type not in ("this", "identifier", "field_expression"):
        return True
    type_ = analysis.receivers.type_of(given, scope)
    if not type_:
        return True
    own = analysis.unit.find_class(type_, scope)
    if own is None:
        return "node" in type_.lower() or type_ in ("auto", "T")
    # A class that keeps a node hands that on with itself.
    return analysis.receivers.is_node_class(own) or any(
        "node" in name.lower() for name in own.variables
    )


def _parsed_as_type(analysis: Analysis, file: CppFile, node: Node) -> Node | None:
    """Return the argument in `Driver driver(node);`, which looks as if it declared a function."""
    around = node.parent
    if around is None or around.type != "parameter_declaration" or around.named_child_count != 1:
        return None
    scope = scope_at(file, node.start_byte)
    name = file.syntax.word(node)
    return None if analysis.unit.lookup(name, scope, node.start_byte) is None else around


def _argument(node: Node, file: CppFile) -> Node | None:
    """Return the argument that a node is as a whole, `this` or `this->shared_from_this()`."""
    while node.parent is not None and node.parent.type in (
        "pointer_expression", "field_expression", "call_expression", "parenthesized_expression",
    ):  # fmt: skip
        parent = node.parent
        if parent.type == "field_expression" and parent.child_by_field_name("field") != node:
            # Of `node->name` only what the name is counts.
            return None
        if parent.type == "call_expression" and parent.child_by_field_name("function") != node:
            break
        node = parent
    around = node.parent
    if around is None or around.type not in ("argument_list", "initializer_list"):
        return None
    call = around.parent
    callee = None if call is None else call.child_by_field_name("function")
    if call is not None and callee is not None:
        passed = "".join(file.syntax.word(callee).split())
        if _PASSING.fullmatch(passed):
            return _argument(call, file)
    return node
