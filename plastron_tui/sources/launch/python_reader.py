"""Launch files of ROS 2 in Python, as far as literals go; nothing in them is run."""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path
from typing import Any

import tree_sitter_python
from tree_sitter import Language, Node

from plastron_tui.diagnostics import Diagnostic, Span, codes
from plastron_tui.ros.launch import Format, Item, LaunchFile, Unread
from plastron_tui.ros.launch_text import text
from plastron_tui.sources.grammars import BoundedParser, python_lines

from .python_actions import SEQUENCES, Computed, placed
from .python_values import (
    HEAVIEST,
    Values,
    arguments_of,
    callee,
    field,
    positional_of,
    short,
    source_of,
    weight_of,
)
from .xml_reader import LaunchRead


def read_launch_python(source: bytes, file: Path | None = None) -> LaunchRead:
    """Read a launch file in Python; what is computed is an `Unread` item."""
    root = BoundedParser(_language()).parse(python_lines(source)).root_node
    if root.has_error:
        found = Diagnostic(codes.BROKEN_LAUNCH, "this is no Python that can be read", file=file)
        return LaunchRead(None, Format.PYTHON, None, (found,))
    function = next(
        (
            node
            for node in root.named_children
            if node.type == "function_definition"
            and field(node, "name") == "generate_launch_description"
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


_MOST_WORK = 1_000_000
"""How many values are copied at most where lists are changed again and again."""

_BRANCHES = frozenset(("if_statement", "for_statement", "while_statement", "match_statement"))
_LEAVING = re.compile(rb"\b(?:break|continue|return|await|yield)\b")
_ADDING = frozenset(("append", "extend", "insert"))
_READING = frozenset(("get", "items", "keys", "values", "copy", "index", "count"))
_HARMLESS = frozenset(("print", "pprint", "len"))


@cache
def _language() -> Language:
    return Language(tree_sitter_python.language())


class _Reader:
    """Goes over statements in their order.

    Attributes:
        items: what the launch description has so far.
    """

    def __init__(self) -> None:
        self.items: list[Item] = []
        self._values = Values()
        self._names = self._values.names
        self._descriptions: set[str] = set()
        self._work = 0

    def block(self, block: Node | None) -> bool:
        """Read the statements of a block, and tell whether it returns."""
        statements = () if block is None else block.named_children
        return any(self._statement(statement) for statement in statements)

    def _statement(self, node: Node) -> bool:
        if node.type == "expression_statement":
            for child in node.named_children:
                self._expression(child)
        elif node.type == "return_statement":
            for child in node.named_children:
                self._description(child)
            return True
        elif node.type == "with_statement":
            for child in node.named_children:
                if child.type == "with_clause":
                    self._branch(child, "a `with`")
            return self.block(node.child_by_field_name("body"))
        elif node.type == "try_statement":
            return self._try(node)
        elif node.type == "for_statement" and self._loop(node):
            return False
        elif node.type in _BRANCHES:
            word = node.type.removesuffix("_statement")
            self._branch(node, f"{'an' if word == 'if' else 'a'} `{word}`")
        elif node.type == "delete_statement":
            for name in _names_in(node):
                self._forget(name)
        return False

    def _loop(self, node: Node) -> bool:
        """Follow a `for` turn by turn, and tell whether that can be done."""
        left, body = node.child_by_field_name("left"), node.child_by_field_name("body")
        if body is None or _LEAVING.search(body.text or b""):
            return False
        if node.child_by_field_name("alternative") is not None:
            return False
        turns = self._values.turns(left, node.child_by_field_name("right"))
        for turn in turns or ():
            self._names.update(turn)
            self._descriptions.difference_update(turn)
            self.block(body)
        return turns is not None

    def _try(self, node: Node) -> bool:
        """Read a `try` as if nothing in it is raised; what else it may do is told."""
        is_over = self.block(node.child_by_field_name("body"))
        for child in node.named_children:
            if child.type.startswith("except"):
                self._branch(child, "an `except`")
            elif child.type == "else_clause" and not is_over:
                is_over = self.block(child.child_by_field_name("body"))
            elif child.type == "finally_clause":
                blocks = (each for each in child.named_children if each.type == "block")
                is_over = any(self.block(each) for each in blocks) or is_over
        return is_over

    def _expression(self, node: Node) -> None:
        left, right = node.child_by_field_name("left"), node.child_by_field_name("right")
        if node.type == "assignment" and left is not None and right is not None:
            self._assign(left, right)
        elif node.type == "augmented_assignment" and left is not None and right is not None:
            self._augment(node, left, right)
        elif node.type == "call":
            self._call(node)

    def _assign(self, left: Node, right: Node) -> None:
        if right.type == "assignment":
            self._expression(right)
            right = right.child_by_field_name("left") or right
        if left.type == "identifier":
            name = source_of(left)
            if right.type == "call" and callee(right) == "LaunchDescription":
                self._descriptions.add(name)
                self._description(right)
            elif right.type == "identifier" and source_of(right) in self._descriptions:
                self._descriptions.add(name)
            else:
                self._descriptions.discard(name)
                self._names[name] = self._values.value(right)
        elif left.type == "subscript":
            self._set_element(left, self._values.value(right))
        else:
            self._forget_all(left)

    def _set_element(self, left: Node, value: Any) -> None:
        """Follow `name[key] = value` of a dictionary."""
        of, key = left.child_by_field_name("value"), left.child_by_field_name("subscript")
        name = "" if of is None else source_of(of)
        found, word = self._names.get(name), None if key is None else self._values.value(key)
        if isinstance(found, dict) and isinstance(word, str):
            self._change(name, {**found, text(word): value})
        else:
            self._forget_all(left)

    def _augment(self, node: Node, left: Node, right: Node) -> None:
        name, value = source_of(left), self._values.value(right)
        found = self._names.get(name)
        if field(node, "operator") == "+=" and isinstance(found, list):
            self._change(name, [*found, *self._elements(value, right)])
        elif field(node, "operator") == "|=" and isinstance(found, dict) and type(value) is dict:
            self._change(name, {**found, **value})
        else:
            self._forget_all(left)

    def _call(self, node: Node) -> None:
        """Follow a call that is a statement."""
        function = node.child_by_field_name("function")
        of = None if function is None else function.child_by_field_name("object")
        name = "" if of is None else source_of(of)
        if function is None or of is None:
            pass
        elif name in self._descriptions and field(function, "attribute") == "add_action":
            for argument in arguments_of(node):
                value = argument.child_by_field_name("value") or argument
                self._add(self._values.value(value), value)
            return
        elif name in self._names:
            self._method(name, field(function, "attribute"), node)
            return
        else:
            self._forget_all(of)
        if callee(node) not in _HARMLESS:
            self._hand_out(node, f"`{callee(node)}`")

    def _method(self, name: str, method: str, node: Node) -> None:
        """Follow a method of a list or a dictionary that changes it."""
        found = self._names[name]
        values = [self._values.value(each) for each in arguments_of(node)]
        match found, method, values:
            case list(), "append", [one]:
                self._change(name, [*found, one])
            case list(), "extend", [many]:
                self._change(name, [*found, *self._elements(many, node)])
            case list(), "insert", [int(at), one]:
                self._change(name, [*found[:at], one, *found[at:]])
            case dict(), "update", [dict(more)]:
                self._change(name, {**found, **more})
            case (list() | dict(), _, _) if method not in _READING:
                self._forget(name)

    def _elements(self, value: Any, node: Node) -> list[Any]:
        if type(value) in SEQUENCES:
            return list(value)
        what = value.what if isinstance(value, Computed) else short(node)
        return [Unread(f"`{what}`", place=placed(node))]

    def _hand_out(self, node: Node, what: str) -> None:
        """Take note of lists and descriptions that a function gets, which may add to them."""
        for argument in positional_of(node):
            name = source_of(argument) if argument.type == "identifier" else ""
            if name in self._descriptions:
                self.items.append(Unread(f"what {what} adds", place=placed(node)))
            elif name in self._names and callee(node) not in _ADDING:
                self._doubt(name, what, node)

    def _branch(self, node: Node, what: str) -> None:
        """Take note of what a branch or a loop may do: it is not known to be done once."""
        found: set[str] = set()
        stack = list(node.named_children)
        while stack:
            each = stack.pop()
            if each.type in ("function_definition", "class_definition", "lambda"):
                continue
            stack.extend(each.named_children)
            function = each.child_by_field_name("function")
            of = None if function is None else function.child_by_field_name("object")
            if each.type == "return_statement":
                found.add("returns")
            elif each.type == "identifier" and source_of(each) in self._descriptions:
                found.add("adds")
            elif each.type == "augmented_assignment":
                left = each.child_by_field_name("left")
                if left is not None and left.type == "identifier":
                    self._doubt(source_of(left), what, each)
                else:
                    self._forget_all(left)
            elif each.type in ("assignment", "for_statement", "named_expression", "as_pattern"):
                target = next((each.child_by_field_name(name) for name in ("left", "name", "alias")
                               if each.child_by_field_name(name) is not None), None)  # fmt: skip
                self._forget_all(target)
            elif of is not None and source_of(of) in self._names:
                if field(function, "attribute") not in _READING:  # type: ignore[arg-type]
                    self._doubt(source_of(of), what, each)
            elif each.type == "call":
                self._hand_out(each, what)
        self.items += (Unread(f"what {what} {does}", place=placed(node)) for does in sorted(found))

    def _doubt(self, name: str, what: str, node: Node) -> None:
        """Take note that a list may get more elements, or that a value is not known any more."""
        found = self._names.get(name)
        if isinstance(found, list):
            self._change(name, [*found, Unread(f"what {what} adds", place=placed(node))])
        elif isinstance(found, dict) or (found is not None and node.type != "call"):
            self._forget(name)

    def _change(self, name: str, new: Any) -> None:
        """Give a name another value, and all names that stand for the same list."""
        old, weight = self._names[name], weight_of(new)
        is_shared = isinstance(old, (list, dict))
        self._work += weight
        if weight > HEAVIEST or self._work > _MOST_WORK:
            new = Computed(name)
        same = [key for key, value in self._names.items() if is_shared and value is old]
        self._names |= dict.fromkeys((name, *same), new)

    def _forget(self, name: str) -> None:
        self._descriptions.discard(name)
        if name in self._names:
            self._change(name, Computed(name))

    def _forget_all(self, target: Node | None) -> None:
        """Forget what is assigned to: a name, some, or a part of what a name stands for."""
        for name in set() if target is None else _names_in(target):
            if target is not None and name in self._descriptions:
                self.items.append(Unread(f"`{short(target)}`", place=placed(target)))
            self._forget(name)

    def _description(self, node: Node) -> None:
        if node.type == "call" and callee(node) == "LaunchDescription":
            for argument in arguments_of(node):
                value = argument
                if argument.type == "keyword_argument":
                    value = argument.child_by_field_name("value") or argument
                self._add(self._values.value(value), value)
        elif not (node.type == "identifier" and source_of(node) in self._descriptions):
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


def _names_in(node: Node) -> set[str]:
    """Return the names that something stands for, without those in what selects a part of it."""
    found, stack = set(), [node]
    while stack:
        each = stack.pop()
        if each.type == "identifier":
            found.add(source_of(each))
        elif each.type in ("attribute", "subscript"):
            of = each.child_by_field_name("object") or each.child_by_field_name("value")
            stack += [] if of is None else [of]
        elif each.type != "call":
            stack += each.named_children
    return found
