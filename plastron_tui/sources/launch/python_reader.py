"""Launch files of ROS 2 in Python, as far as literals go; nothing in them is run."""

from __future__ import annotations

import ast
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

import tree_sitter_python
from tree_sitter import Language, Node, Parser

from plastron_tui.diagnostics import Diagnostic, Span, codes
from plastron_tui.ros.launch import Format, Group, Item, LaunchFile, Unread
from plastron_tui.ros.launch_text import Text, text

from .python_actions import ACTIONS, Computed, as_text, placed
from .xml_reader import LaunchRead

_DEEPEST = 60
_LONGEST_LITERAL = 20_000
_HEAVIEST = 50_000
"""How many values and characters a value has at most: one that is doubled again and again is none
that a person wrote."""


def read_launch_python(source: bytes, file: Path | None = None) -> LaunchRead:
    """Read a launch file in Python; what is computed is an `Unread` item."""
    root = Parser(_language()).parse(source).root_node
    if root.has_error:
        found = Diagnostic(codes.BROKEN_LAUNCH, "this is no Python that can be read", file=file)
        return LaunchRead(None, Format.PYTHON, None, (found,))
    function = next(
        (
            node
            for node in root.named_children
            if node.type == "function_definition"
            and _field(node, "name") == b"generate_launch_description"
        ),
        None,
    )
    if function is None:
        message = "a launch file has a function `generate_launch_description`"
        found = Diagnostic(codes.BROKEN_LAUNCH, message, Span(0, 0), file)
        return LaunchRead(None, Format.PYTHON, None, (found,))
    reader = _Reader()
    reader.block(root)
    reader.block(function.child_by_field_name("body"))
    return LaunchRead(LaunchFile(tuple(reader.items)), Format.PYTHON)


@cache
def _language() -> Language:
    return Language(tree_sitter_python.language())


def _field(node: Node, name: str) -> bytes:
    child = node.child_by_field_name(name)
    return b"" if child is None or child.text is None else child.text


def _source(node: Node) -> str:
    return (node.text or b"").decode("utf-8", "replace")


class _Reader:
    """Goes over statements in their order, and knows the values of plain names.

    Attributes:
        items: what the launch description has so far.
    """

    def __init__(self) -> None:
        self.items: list[Item] = []
        self._names: dict[str, Any] = {}
        self._descriptions: set[str] = set()
        self._depth = 0

    def block(self, block: Node | None) -> None:
        """Read the statements of a block."""
        for statement in block.named_children if block is not None else ():
            if statement.type == "expression_statement":
                for child in statement.named_children:
                    self._expression(child)
            elif statement.type == "return_statement":
                for child in statement.named_children:
                    self._description(child)
            elif statement.type in ("if_statement", "for_statement", "while_statement"):
                self._forget(statement)
                # What a branch or a loop adds is not known to be added once.
                if any(f"{name}.add_action" in _source(statement) for name in self._descriptions):
                    what = f"what an `{statement.type.removesuffix('_statement')}` adds"
                    self.items.append(Unread(what, place=placed(statement)))

    def _expression(self, node: Node) -> None:
        if node.type == "assignment":
            left, right = node.child_by_field_name("left"), node.child_by_field_name("right")
            if left is None or right is None or left.type != "identifier":
                return
            name = _source(left)
            if right.type == "call" and _callee(right) == "LaunchDescription":
                self._descriptions.add(name)
                self._description(right)
            else:
                self._names[name] = self._value(right)
        elif node.type == "call":
            function = node.child_by_field_name("function")
            if function is not None and _field(function, "object").decode() in self._descriptions:
                for argument in _positional(node):
                    self._add(self._value(argument), argument)
        elif node.type == "augmented_assignment":
            self._forget(node)

    def _forget(self, node: Node) -> None:
        """Forget the names that are assigned to somewhere in a node."""
        stack = [node]
        while stack:
            each = stack.pop()
            if each.type in ("assignment", "augmented_assignment"):
                self._names[_field(each, "left").decode("utf-8", "replace")] = Computed("a loop")
            stack.extend(each.named_children)

    def _description(self, node: Node) -> None:
        if node.type == "call" and _callee(node) == "LaunchDescription":
            for argument in _arguments(node):
                value = argument
                if argument.type == "keyword_argument":
                    value = argument.child_by_field_name("value") or argument
                self._add(self._value(value), value)
        elif not (node.type == "identifier" and _source(node) in self._descriptions):
            self.items.append(Unread("a description that is computed", place=placed(node)))

    def _add(self, value: Any, node: Node) -> None:
        if isinstance(value, list):
            for each in value:
                self._add(each, node)
        elif isinstance(value, Item):
            self.items.append(value)
        else:
            what = value.what if isinstance(value, Computed) else "a value"
            self.items.append(Unread(f"`{what}`", place=placed(node)))

    def _value(self, node: Node) -> Any:
        self._depth += 1
        try:
            if self._depth > _DEEPEST:
                return Computed("what is nested too deep")
            reader = _VALUES.get(node.type)
            found = Computed(_short(node)) if reader is None else reader(self, node)
            return Computed("a huge value") if _is_heavy(found) else found
        finally:
            self._depth -= 1

    def _literal(self, node: Node) -> Any:
        source = node.text or b""
        if len(source) > _LONGEST_LITERAL:
            return Computed("a long literal")
        try:
            return ast.literal_eval(source.decode("utf-8", "replace"))
        except (ValueError, SyntaxError, MemoryError, RecursionError):
            return Computed(_short(node))

    def _string(self, node: Node) -> Any:
        if any(child.type == "interpolation" for child in node.named_children):
            return Computed(_short(node))
        if _source(node)[:1] in "fF":
            return Computed(_short(node))
        return self._literal(node)

    def _concatenated(self, node: Node) -> Any:
        parts = [self._value(child) for child in node.named_children if child.type == "string"]
        if all(isinstance(part, str) for part in parts):
            return "".join(parts)
        return Computed(_short(node))

    def _identifier(self, node: Node) -> Any:
        return self._names.get(_source(node), Computed(_short(node)))

    def _list(self, node: Node) -> Any:
        return [self._value(child) for child in node.named_children if child.type != "comment"]

    def _tuple(self, node: Node) -> Any:
        return tuple(self._list(node))

    def _dictionary(self, node: Node) -> Any:
        found = {}
        for pair in node.named_children:
            if pair.type == "comment":
                continue
            key, value = pair.child_by_field_name("key"), pair.child_by_field_name("value")
            if pair.type != "pair" or key is None or value is None:
                return Computed(_short(node))
            name = as_text(self._value(key))
            if name is None:
                return Computed(_short(node))
            found[name] = self._value(value)
        return found

    def _binary(self, node: Node) -> Any:
        left, right = node.child_by_field_name("left"), node.child_by_field_name("right")
        if left is None or right is None or _field(node, "operator") != b"+":
            return Computed(_short(node))
        values = self._value(left), self._value(right)
        if isinstance(values[0], list) and isinstance(values[1], list):
            return values[0] + values[1]
        parts = [each if isinstance(each, (str, Text)) else None for each in values]
        known = [part for part in parts if part is not None]
        return text(*known) if len(known) == len(parts) else Computed(_short(node))

    def _parenthesized(self, node: Node) -> Any:
        inner = [child for child in node.named_children if child.type != "comment"]
        return self._value(inner[0]) if len(inner) == 1 else Computed(_short(node))

    def _call(self, node: Node) -> Any:
        name = _callee(node)
        function = node.child_by_field_name("function")
        if name == "items" and function is not None:
            of = function.child_by_field_name("object")
            found = self._value(of) if of is not None else None
            return list(found.items()) if isinstance(found, dict) else Computed(_short(node))
        if name == "float" and len(_positional(node)) == 1:
            word = self._value(_positional(node)[0])
            return float(word) if word in ("inf", "-inf", "nan") else Computed(_short(node))
        if name in ("str", "dict", "float", "int"):
            values = [self._value(each) for each in _positional(node)]
            is_one = len(values) == 1 and name == "str" and isinstance(values[0], (str, Text))
            return values[0] if is_one else Computed(_short(node))
        action = ACTIONS.get(name)
        if action is None:
            return Computed(name or _short(node))
        positional: list[Any] = []
        named: dict[str, Any] = {}
        for argument in _arguments(node):
            if argument.type == "keyword_argument":
                value = argument.child_by_field_name("value")
                named[_field(argument, "name").decode()] = value and self._value(value)
            elif argument.type in ("list_splat", "dictionary_splat"):
                return Computed(name)
            else:
                positional.append(self._value(argument))
        found = action(positional, named, placed(node))
        return Computed(name) if found is None else found


_VALUES: dict[str, Callable[[_Reader, Node], Any]] = {
    "string": _Reader._string,
    "concatenated_string": _Reader._concatenated,
    "integer": _Reader._literal,
    "float": _Reader._literal,
    "unary_operator": _Reader._literal,
    "true": lambda reader, node: True,
    "false": lambda reader, node: False,
    "none": lambda reader, node: None,
    "identifier": _Reader._identifier,
    "list": _Reader._list,
    "tuple": _Reader._tuple,
    "dictionary": _Reader._dictionary,
    "binary_operator": _Reader._binary,
    "parenthesized_expression": _Reader._parenthesized,
    "call": _Reader._call,
    "attribute": lambda reader, node: Computed(_short(node)),
}


def _is_heavy(value: Any) -> bool:
    weight = 0
    stack = [value]
    while stack and weight <= _HEAVIEST:
        each = stack.pop()
        weight += 1
        if isinstance(each, str):
            weight += len(each)
        elif isinstance(each, Text):
            weight += sum(len(part) if isinstance(part, str) else 1 for part in each.parts)
        elif isinstance(each, (list, tuple)) and not isinstance(each, Computed):
            stack.extend(each[:_HEAVIEST])
        elif isinstance(each, dict):
            stack.extend(each.values())
        elif isinstance(each, Group):
            stack.extend(each.items)
    return weight > _HEAVIEST


def _callee(node: Node) -> str:
    """Return the last word of what is called: `join` for `os.path.join`."""
    function = node.child_by_field_name("function")
    if function is None:
        return ""
    if function.type == "attribute":
        return _field(function, "attribute").decode("utf-8", "replace")
    return _source(function) if function.type == "identifier" else ""


def _arguments(node: Node) -> list[Node]:
    arguments = node.child_by_field_name("arguments")
    if arguments is None or arguments.type != "argument_list":
        return []
    return [child for child in arguments.named_children if child.type != "comment"]


def _positional(node: Node) -> list[Node]:
    return [each for each in _arguments(node) if each.type != "keyword_argument"]


def _short(node: Node) -> str:
    first = _source(node).split("\n", 1)[0]
    return first if len(first) <= 40 else f"{first[:40]}…"
