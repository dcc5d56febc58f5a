"""Launch files of ROS 2 in Python, as far as literals go; nothing in them is run."""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path
from typing import Any

import tree_sitter_python
from tree_sitter import Language, Node

from plastron_tui.diagnostics import Diagnostic, Span, codes
from plastron_tui.ros.launch import Format, Item, LaunchFile, Place, Unread, Variable, items_of
from plastron_tui.ros.launch_text import text
from plastron_tui.sources.grammars import BoundedParser, python_lines

from .python_actions import Computed, placed, unknown_text
from .python_branches import Outcome, merged
from .python_calls import Calls, Returned
from .python_deferred import maybe
from .python_functions import Function
from .python_nodes import (
    arguments_of,
    callee,
    clauses,
    field,
    names_in,
    positional_of,
    short,
    source_of,
)
from .python_tracking import Tracking
from .python_values import MOST_WORK, is_of_context
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
    calls = Calls(_Reader)
    reader = _Reader(calls)
    reader.block(root)
    reader.enter()
    reader.block(function.child_by_field_name("body"))
    return LaunchRead(LaunchFile(calls.expanded(reader.items)), Format.PYTHON)


_BRANCHES = frozenset(("if_statement", "for_statement", "while_statement", "match_statement"))
_LEAVING = re.compile(rb"\b(?:break|continue|return|await|yield)\b")
_WORD = re.compile(rb"\w+")
_ADDING = frozenset(("append", "extend", "insert"))
_READING = frozenset(("get", "items", "keys", "values", "copy", "index", "count"))
_HARMLESS = frozenset(("print", "pprint", "len"))


@cache
def _language() -> Language:
    return Language(tree_sitter_python.language())


class _Reader(Tracking):
    """Goes over statements in their order.

    Attributes:
        returned: what the function returns, where it is not that which describes the launch.
    """

    def __init__(self, calls: Calls, *, is_function: bool = False) -> None:
        super().__init__(calls.values)
        self.returned: list[Returned] = []
        self._is_function = self._is_inside = is_function
        self._returns = 0

    def enter(self) -> None:
        """Go into the function that describes the launch: no other one sees what it names."""
        self.values.names = self.names = dict(self.names)
        self._is_inside = True

    def block(self, block: Node | None) -> bool:
        """Read the statements of a block, and tell whether it returns."""
        statements = () if block is None else block.named_children
        return any(self._statement(statement) for statement in statements)

    def _statement(self, node: Node) -> bool:
        if node.type == "expression_statement":
            for child in node.named_children:
                self._expression(child)
        elif node.type == "return_statement":
            self._return(node)
            return True
        elif node.type == "raise_statement":
            return True
        elif node.type == "function_definition":
            self.descriptions.discard(field(node, "name"))
            self.names[field(node, "name")] = Function(node, self.names)
        elif node.type == "if_statement" and self._is_inside:
            return self._if(node)
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
            for name in names_in(node):
                self.forget(name)
        return False

    def _return(self, node: Node) -> None:
        self._returns += 1
        inner = [child for child in node.named_children if child.type != "comment"]
        if not self._is_function:
            for child in inner:
                self._description(child)
            return
        value = self.values.value(inner[0]) if inner else None
        if inner and source_of(inner[0]) in self.descriptions:
            value, self.items = [*self.items], []
        self.returned.append(Returned(value, placed(node), ""))

    def _if(self, node: Node) -> bool:
        """Follow the branches of an `if`, each as one that may be taken, and tell if all return."""
        self.values.work += 10 * len(self.names)
        if self.values.work > MOST_WORK:
            self._branch(node, "an `if`")
            return False
        before, outcomes = dict(self.names), list[Outcome]()
        is_whole = False
        for condition, block in clauses(node):
            truth = True if condition is None else self.values.truth(condition)
            if truth is False:
                continue
            if truth and not outcomes:
                return self.block(block)
            what = "else" if condition is None else short(condition)
            outcomes.append(self._tried(block, what, before, placed(node)))
            if truth:
                is_whole = True
                break
        if not is_whole and outcomes:
            outcomes.append(Outcome(before, "else", is_over=False))
        if outcomes:
            self.set_names(merged(before, outcomes, placed(node)))
        return bool(outcomes) and all(each.is_over for each in outcomes)

    def _tried(
        self, block: Node | None, what: str, before: dict[str, Any], place: Place
    ) -> Outcome:
        """Follow a branch: what it adds to the description, and returns, is in doubt."""
        self.set_names(before)
        outer, self.items = self.items, []
        returned, descriptions = len(self.returned), set(self.descriptions)
        returns = self._returns
        is_over = self.block(block)
        after, added, self.items = dict(self.names), self.items, outer
        self.descriptions = descriptions
        if added:
            self.items.append(maybe(added, what, place))
        for each in set(items_of(tuple(added), Variable)):
            self.items.append(Variable(each.name, unknown_text(Computed(what)), place=place))
        more = self.returned[returned:]
        self.returned[returned:] = [x._replace(what=x.what or what) for x in more]
        if self._returns > returns and not self._is_function:
            self.items.append(Unread("what an `if` returns", place=place))
        return Outcome(after, what, is_over)

    def _loop(self, node: Node) -> bool:
        """Follow a `for` turn by turn, and tell whether that can be done."""
        left, body = node.child_by_field_name("left"), node.child_by_field_name("body")
        if body is None or _LEAVING.search(body.text or b""):
            return False
        if node.child_by_field_name("alternative") is not None:
            return False
        turns = self.values.turns(left, node.child_by_field_name("right"))
        for turn in turns or ():
            self.names.update(turn)
            self.descriptions.difference_update(turn)
            self.block(body)
        return turns is not None

    def _try(self, node: Node) -> bool:
        """Read a `try` as if nothing in it is raised; what else it may do is told."""
        returns = self._returns
        is_over = self.block(node.child_by_field_name("body")) and self._returns > returns
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
                self.descriptions.add(name)
                self._description(right)
            elif right.type == "identifier" and source_of(right) in self.descriptions:
                self.descriptions.add(name)
            else:
                self.descriptions.discard(name)
                self.names[name] = self.values.value(right)
        elif left.type == "subscript":
            self._set_element(left, self.values.value(right))
        else:
            self.forget_all(left)

    def _set_element(self, left: Node, value: Any) -> None:
        """Follow `name[key] = value` of a dictionary."""
        of, key = left.child_by_field_name("value"), left.child_by_field_name("subscript")
        if of is not None and key is not None and is_of_context(of):
            self.set_argument(self.values.value(key), value, left)
            return
        name = "" if of is None else source_of(of)
        found, word = self.names.get(name), None if key is None else self.values.value(key)
        if isinstance(found, dict) and isinstance(word, str):
            self.change(name, {**found, text(word): value})
        else:
            self.forget_all(left)

    def _augment(self, node: Node, left: Node, right: Node) -> None:
        name, value = source_of(left), self.values.value(right)
        found = self.names.get(name)
        if field(node, "operator") == "+=" and isinstance(found, list):
            self.change(name, [*found, *self.elements(value, right)])
        elif field(node, "operator") == "|=" and isinstance(found, dict) and type(value) is dict:
            self.change(name, {**found, **value})
        else:
            self.forget_all(left)

    def _call(self, node: Node) -> None:
        """Follow a call that is a statement."""
        function = node.child_by_field_name("function")
        of = None if function is None else function.child_by_field_name("object")
        name = "" if of is None else source_of(of)
        if function is None or of is None:
            pass
        elif name in self.descriptions and field(function, "attribute") == "add_action":
            for argument in arguments_of(node):
                value = argument.child_by_field_name("value") or argument
                self._add(self.values.value(value), value)
            return
        elif name in self.names:
            self._method(name, field(function, "attribute"), node)
            return
        else:
            self.forget_all(of)
        called = self.names.get(callee(node)) if of is None else None
        if isinstance(called, Function):
            self.values.value(node)
            words = set(_WORD.findall(called.node.text or b""))
            if any(each.encode() in words for each in self.descriptions):
                self.items.append(Unread(f"what `{called.name}` adds", place=placed(node)))
        if callee(node) not in _HARMLESS:
            self._hand_out(node, f"`{callee(node)}`")

    def _method(self, name: str, method: str, node: Node) -> None:
        """Follow a method of a list or a dictionary that changes it."""
        found = self.names[name]
        values = [self.values.value(each) for each in arguments_of(node)]
        match found, method, values:
            case list(), "append", [one]:
                self.change(name, [*found, one])
            case list(), "extend", [many]:
                self.change(name, [*found, *self.elements(many, node)])
            case list(), "insert", [int(at), one]:
                self.change(name, [*found[:at], one, *found[at:]])
            case dict(), "update", [dict(more)]:
                self.change(name, {**found, **more})
            case (list() | dict(), _, _) if method not in _READING:
                self.forget(name)

    def _hand_out(self, node: Node, what: str) -> None:
        """Take note of lists and descriptions that a function gets, which may add to them."""
        for argument in positional_of(node):
            name = source_of(argument) if argument.type == "identifier" else ""
            if name in self.descriptions:
                self.items.append(Unread(f"what {what} adds", place=placed(node)))
            elif name in self.names and callee(node) not in _ADDING:
                self.doubt(name, what, node)

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
            elif each.type == "identifier" and source_of(each) in self.descriptions:
                found.add("adds")
            elif each.type == "augmented_assignment":
                left = each.child_by_field_name("left")
                if left is not None and left.type == "identifier":
                    self.doubt(source_of(left), what, each)
                else:
                    self.forget_all(left)
            elif each.type in ("assignment", "for_statement", "named_expression", "as_pattern"):
                target = next((each.child_by_field_name(name) for name in ("left", "name", "alias")
                               if each.child_by_field_name(name) is not None), None)  # fmt: skip
                self.forget_all(target)
            elif of is not None and source_of(of) in self.names:
                if field(function, "attribute") not in _READING:  # type: ignore[arg-type]
                    self.doubt(source_of(of), what, each)
            elif each.type == "call":
                self._hand_out(each, what)
        self.items += (Unread(f"what {what} {does}", place=placed(node)) for does in sorted(found))

    def _description(self, node: Node) -> None:
        if node.type == "call" and callee(node) == "LaunchDescription":
            for argument in arguments_of(node):
                value = argument
                if argument.type == "keyword_argument":
                    value = argument.child_by_field_name("value") or argument
                self._add(self.values.value(value), value)
        elif not (node.type == "identifier" and source_of(node) in self.descriptions):
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
