"""The constants of a file: what an expression is, as far as the file says it literally."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from contextlib import AbstractContextManager
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Protocol

from tree_sitter import Node

from plastron_tui.sources.work_limits import Effort

from . import literals
from .arguments import Arguments
from .calls import Argument
from .flow import reaching
from .imported_names import ImportedNames
from .scopes import Binding, BindingKind, Scope, ScopeTree
from .syntax import Syntax, parts_of

if TYPE_CHECKING:
    from .names import Instance

# What a person writes is far flatter; a file that is deeper was made to break readers.
MOST_DEEP = 24
# How often a name is bound at most that is looked up; a file may look a name up as often.
MOST_BINDINGS = 200
_PARAMETER_READERS = {
    "rospy.get_param": Argument(1, "default"),
    "rospy.client.get_param": Argument(1, "default"),
    "rospy.get_param_cached": Argument(1, "default"),
}
_TEXT_METHODS = frozenset({"lower", "upper", "strip", "lstrip", "rstrip", "replace"})
# A field width such as `%99999999d` would make a text larger than the memory.
_WIDTH = re.compile(r"\d{4}")


@dataclass(frozen=True, slots=True)
class Known:
    """A constant of the file."""

    value: str | int | float | None


@dataclass(frozen=True, slots=True)
class Defaulted:
    """A string that is read from a parameter when the node starts, with a literal default."""

    value: str


Folded = Known | Defaulted | None


class Names(Protocol):
    """What folding asks of names, which ask for constants in turn."""

    effort: Effort
    package: ImportedNames | None

    def attribute_bindings(self, node: Node, scope: Scope, depth: int = 0) -> list[Binding]:
        """Return what an attribute of an object of the file is bound to."""

    def parameter(self, binding: Binding, name: str, depth: int) -> Folded:
        """Return the constant that a parameter has wherever the file calls the function."""

    def qualified(self, node: Node | None, scope: Scope, depth: int = 0) -> tuple[str, ...]:
        """Return the qualified names that an expression may stand for."""

    def calls_of(self, name: str) -> list[Node]:
        """Return the calls of a function or method of a name."""

    def during(self, world: Mapping[int, Any]) -> AbstractContextManager[None]:
        """Answer for one pass through the file, in which nothing else is chosen."""

    def fold_item(self, binding: Binding, name: str, depth: int) -> Folded:
        """Return the constant that a parameter or the variable of a loop is in this pass."""

    def fold_held(self, node: Node, scope: Scope, depth: int) -> Folded:
        """Return the constant that `TOPICS['scan']` or `TOPICS.get('scan')` is."""

    def option(self, node: Node, scope: Scope, depth: int) -> Folded:
        """Return the default of `args.topic`, an option of the command line."""

    def returned(self, call: Node, scope: Scope, depth: int) -> Folded:
        """Return the constant that a call of a function of the file gives."""

    def seen(self, node: Node | None, scope: Scope, depth: int) -> tuple[str, ...]:
        """Return the qualified names that the file itself gives to an imported name."""

    def instance(self, node: Node | None, scope: Scope, depth: int = 0) -> Instance | None:
        """Return what an expression is an instance of; None where the file does not say it."""


class Constants:
    """Folds the expressions of one file.

    `trace` gets the expressions that were folded on the way, but for the names of parameters.
    """

    def __init__(
        self, names: Names, syntax: Syntax, scopes: ScopeTree, trace: list[Node] | None = None
    ) -> None:
        self._names = names
        self._syntax = syntax
        self._scopes = scopes
        self._trace = trace

    def fold(self, node: Node | None, scope: Scope, depth: int = 0) -> Folded:
        """Return the constant that an expression is."""
        if node is None or depth > MOST_DEEP or not self._names.effort.spend():
            return None
        if self._trace is not None:
            self._trace.append(node)
        handler = _FOLDERS.get(node.type)
        return handler(self, node, scope, depth + 1) if handler is not None else None

    def _literal(self, node: Node, scope: Scope, depth: int) -> Folded:
        try:
            value = literals.value_of(self._syntax.slice(node))
        except (ValueError, SyntaxError, MemoryError, RecursionError):
            return None
        if value is None or (isinstance(value, str | int | float) and not isinstance(value, bool)):
            return Known(value)
        return None

    def _string(self, node: Node, scope: Scope, depth: int) -> Folded:
        if not any(child.type == "interpolation" for child in node.named_children):
            start = self._syntax.slice(node)[:3].lower()
            if "f" in start.split("'")[0].split('"')[0]:
                return self._format_string(node, scope, depth)
            return self._literal(node, scope, depth)
        return self._format_string(node, scope, depth)

    def _format_string(self, node: Node, scope: Scope, depth: int) -> Folded:
        parts: list[Folded] = []
        prefix = self._syntax.slice(node.children[0]).rstrip("'\"").lower()
        for child in node.children[1:-1]:
            if child.type == "interpolation":
                # `{name=}` writes the name as well, `{name!r}` and `{name:3}` change the value.
                is_plain = all(part.type in ("{", "}") or part.is_named for part in child.children)
                if len(child.named_children) != 1 or not is_plain:
                    return None
                parts.append(self.fold(child.child_by_field_name("expression"), scope, depth))
            elif child.type == "string_content":
                text = self._syntax.slice(child)
                if "\\" in text and "r" not in prefix:
                    return None
                parts.append(Known(text.replace("{{", "{").replace("}}", "}")))
        return _join(parts)

    def _concatenated(self, node: Node, scope: Scope, depth: int) -> Folded:
        return _join([self.fold(child, scope, depth) for child in parts_of(node)])

    def _parenthesized(self, node: Node, scope: Scope, depth: int) -> Folded:
        inner = parts_of(node)
        return self.fold(inner[0], scope, depth) if len(inner) == 1 else None

    def _operator(self, node: Node, scope: Scope, depth: int) -> Folded:
        operator = node.child_by_field_name("operator")
        left_node, right = node.child_by_field_name("left"), node.child_by_field_name("right")
        left = self.fold(left_node, scope, depth)
        if operator is None or right is None or left is None:
            return None
        if operator.type == "%":
            values = parts_of(right) if right.type == "tuple" else [right]
            return _format(left, [self.fold(value, scope, depth) for value in values], _percent)
        other = self.fold(right, scope, depth)
        if operator.type in ("+", "+=") and other is not None:
            is_text = isinstance(left.value, str) and isinstance(other.value, str)
            return _join([left, other]) if is_text else None
        return None

    def _identifier(self, node: Node, scope: Scope, depth: int) -> Folded:
        name = self._syntax.slice(node)
        found = scope.lookup(name)
        if found is None:
            return self._imported(node, scope, depth)
        if len(found[1]) > MOST_BINDINGS:
            return None
        return self.fold_all(reaching(found[1], found[0], node, scope), name, depth)

    def _attribute(self, node: Node, scope: Scope, depth: int) -> Folded:
        name = node.child_by_field_name("attribute")
        text = self._syntax.slice(name) if name is not None else ""
        holder = node.child_by_field_name("object")
        if holder is None:
            return None
        if text in ("value", "string_value") and holder.type == "call":
            return self._parameter_value(holder, scope, depth)
        bindings = self._names.attribute_bindings(node, scope, depth)
        if not bindings:
            option = self._names.option(node, scope, depth)
            return self._imported(node, scope, depth) if option is None else option
        found = scope.lookup(self._syntax.slice(holder)) if holder.type == "identifier" else None
        if found is not None and found[0].self_name == self._syntax.slice(holder):
            return self.fold_all(bindings, text, depth)
        # Which call has made another object is not known.
        with self._names.during({}):
            return self.fold_all(bindings, text, depth)

    def fold_all(self, bindings: list[Binding], name: str, depth: int) -> Folded:
        """Fold what a name is bound to; None unless every binding says the same."""
        if len(bindings) > MOST_BINDINGS:
            return None
        bindings = without_none(bindings)
        if len(bindings) > 8:
            return None
        values = {self._fold_binding(binding, name, depth) for binding in bindings}
        return values.pop() if len(values) == 1 else None

    def _fold_binding(self, binding: Binding, name: str, depth: int) -> Folded:
        if binding.kind is BindingKind.PARAMETER:
            return self._names.parameter(binding, name, depth)
        if binding.kind is BindingKind.VALUE:
            return self.fold(binding.value, binding.scope, depth)
        if binding.kind is BindingKind.IMPORT:
            package = self._names.package
            return None if package is None else package.constant(binding.target, depth)
        if binding.node.type == "augmented_assignment":
            return self._operator(binding.node, binding.scope, depth)
        return self._names.fold_item(binding, name, depth)

    def _imported(self, node: Node, scope: Scope, depth: int) -> Folded:
        """Fold a name that another file of the package has."""
        package = self._names.package
        if package is None:
            return None
        names = self._names.seen(node, scope, depth)
        part = node.child_by_field_name("attribute")
        if part is not None and not names:
            made = self._names.instance(node.child_by_field_name("object"), scope, depth)
            names = (f"{made.qualified}.{self._syntax.slice(part)}",) if made is not None else ()
        values = {package.constant(name, depth) for name in names} - {None}
        return values.pop() if len(values) == 1 else None

    def _call(self, node: Node, scope: Scope, depth: int) -> Folded:
        callee = node.child_by_field_name("function")
        if callee is None:
            return None
        arguments = Arguments.of(node, self._syntax)
        for name in self._names.qualified(callee, scope, depth):
            if name in _PARAMETER_READERS:
                return as_default(self.fold(arguments.get(_PARAMETER_READERS[name]), scope, depth))
        if callee.type == "identifier" and self._syntax.slice(callee) == "str":
            inner = self.fold(arguments.get(Argument(0, "")), scope, depth)
            is_builtin = scope.lookup("str") is None and len(arguments.positional) == 1
            return _join([inner]) if is_builtin else None
        method = callee.child_by_field_name("attribute")
        holder = callee.child_by_field_name("object")
        if method is None or holder is None or arguments.is_open:
            return self._names.returned(node, scope, depth)
        text = self._syntax.slice(method)
        if text == "format":
            return self._format_call(holder, arguments, scope, depth)
        if text in _TEXT_METHODS:
            values = [self.fold(each, scope, depth) for each in arguments.positional]
            return _with_method(text, [self.fold(holder, scope, depth), *values])
        if text == "get":
            return self._names.fold_held(node, scope, depth)
        return self._names.returned(node, scope, depth)

    def _subscript(self, node: Node, scope: Scope, depth: int) -> Folded:
        return self._names.fold_held(node, scope, depth)

    def _choice(self, node: Node, scope: Scope, depth: int) -> Folded:
        """Fold `topic or 'default'`."""
        left, operator, right = (node.child_by_field_name(n) for n in ("left", "operator", "right"))
        folded = self.fold(left, scope, depth)
        if folded is None or operator is None or operator.type != "or":
            return None
        return folded if folded.value else self.fold(right, scope, depth)

    def _format_call(self, holder: Node, arguments: Arguments, scope: Scope, depth: int) -> Folded:
        names = list(arguments.keywords)
        values = [*arguments.positional, *arguments.keywords.values()]
        count = len(arguments.positional)
        return _format(
            self.fold(holder, scope, depth),
            [self.fold(value, scope, depth) for value in values],
            lambda text, parts: text.format(
                *parts[:count], **dict(zip(names, parts[count:], strict=True))
            ),
        )

    def _parameter_value(self, call: Node, scope: Scope, depth: int) -> Folded:
        """Fold `node.declare_parameter('x', 'd').value` and what reads it back."""
        callee = call.child_by_field_name("function")
        method = callee.child_by_field_name("attribute") if callee is not None else None
        if callee is None or method is None:
            return None
        name = self._syntax.slice(method)
        arguments = Arguments.of(call, self._syntax)
        if name == "declare_parameter":
            default = arguments.get(Argument(1, "value"))
            return as_default(self.fold(default, scope, depth))
        if name == "get_parameter_value":
            inner = callee.child_by_field_name("object")
            is_call = inner is not None and inner.type == "call"
            return self._parameter_value(inner, scope, depth) if inner and is_call else None
        if name == "get_parameter":
            wanted = self._name(arguments, scope, depth)
            return self._declared_default(wanted, depth) if wanted is not None else None
        return None

    def _name(self, arguments: Arguments, scope: Scope, depth: int) -> Folded:
        """Return the name of a parameter."""
        plain = self if self._trace is None else Constants(self._names, self._syntax, self._scopes)
        return plain.fold(arguments.get(Argument(0, "name")), scope, depth)

    def _declared_default(self, wanted: Known | Defaulted, depth: int) -> Folded:
        found: set[Folded] = set()
        for call in self._names.calls_of("declare_parameter"):
            if not self._names.effort.spend():
                return None
            scope = self._scopes.at(call.start_byte)
            arguments = Arguments.of(call, self._syntax)
            if self._name(arguments, scope, depth) == wanted:
                found.add(self.fold(arguments.get(Argument(1, "value")), scope, depth))
        return as_default(found.pop()) if len(found) == 1 else None


_FOLDERS: dict[str, Callable[[Constants, Node, Scope, int], Folded]] = {
    "string": Constants._string,
    "integer": Constants._literal,
    "float": Constants._literal,
    "concatenated_string": Constants._concatenated,
    "parenthesized_expression": Constants._parenthesized,
    "binary_operator": Constants._operator,
    "identifier": Constants._identifier,
    "attribute": Constants._attribute,
    "call": Constants._call,
    "subscript": Constants._subscript,
    "boolean_operator": Constants._choice,
}


def without_none(bindings: list[Binding]) -> list[Binding]:
    """Leave out the placeholder `None`: an endpoint that is named by it would not start."""
    return [
        binding
        for binding in bindings
        if binding.kind is BindingKind.PARAMETER
        or binding.value is None
        or binding.value.type != "none"
    ]


def as_default(folded: Folded) -> Folded:
    """Return a constant as what something has that the run may give another value."""
    if folded is not None and isinstance(folded.value, str):
        return Defaulted(folded.value)
    return None


def _with_method(method: str, values: list[Folded]) -> Folded:
    """Fold a method of a text that takes texts."""
    if any(value is not None and not isinstance(value.value, str) for value in values):
        return None
    render = getattr(str, method)
    return _format(values[0], values[1:], lambda text, parts: render(text, *parts))


def _join(parts: list[Folded]) -> Folded:
    return _format(Known(""), parts, lambda _, values: "".join(map(str, values)))


def _percent(text: str, values: list[str | int | float | None]) -> str:
    return text % tuple(values)


def _format(
    template: Folded,
    values: list[Folded],
    render: Callable[[str, list[str | int | float | None]], str],
) -> Folded:
    """Render constants into a text; a part that is a parameter's default makes it one."""
    if template is None or not isinstance(template.value, str):
        return None
    if _WIDTH.search(template.value):
        return None
    parts: list[str | int | float | None] = []
    for value in values:
        if value is None or value.value is None:
            return None
        parts.append(value.value)
    try:
        text = render(template.value, parts)
    except (ValueError, TypeError, KeyError, IndexError, AttributeError, OverflowError):
        return None
    if len(text) > 4096:
        return None
    is_default = any(isinstance(value, Defaulted) for value in (template, *values))
    return Defaulted(text) if is_default else Known(text)
