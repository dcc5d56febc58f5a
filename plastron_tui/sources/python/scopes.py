"""The scopes of a file, and what each name in them is bound to."""

from __future__ import annotations

from bisect import bisect_right
from dataclasses import dataclass, field
from enum import Enum

from tree_sitter import Node

from .imported_names import joined
from .syntax import Syntax, parts_of

MOST_BASES = 64
"""The most base classes of a class; each may be asked for each class that derives from it."""

_MOST_STARS = 64


class BindingKind(Enum):
    """How a name comes to its value."""

    VALUE = "value"
    IMPORT = "import"
    PARAMETER = "parameter"
    CLASS = "class"
    FUNCTION = "function"
    UNKNOWN = "unknown"


@dataclass(frozen=True, slots=True, eq=False)
class Binding:
    """One place that binds a name.

    Attributes:
        kind: how.
        scope: where `value` is evaluated.
        value: the expression (a parameter's default), None where there is none.
        target: the qualified name of an import.
        annotation: the annotation of a parameter or a variable.
        index: the position of a parameter, -1 for one that is not positional.
        owner: the scope that a class, a function or a parameter's function opens.
        node: the statement or the parameter.
    """

    kind: BindingKind
    scope: Scope
    node: Node
    value: Node | None = None
    target: str = ""
    annotation: Node | None = None
    index: int = -1
    owner: Scope | None = None


@dataclass(slots=True, eq=False)
class Scope:
    """A module, class, function, lambda or comprehension; `start` and `end` bound its body."""

    kind: str
    name: str
    node: Node
    start: int
    end: int
    parent: Scope | None = None
    bindings: dict[str, list[Binding]] = field(default_factory=dict)
    attributes: dict[str, list[Binding]] = field(default_factory=dict)
    globals: set[str] = field(default_factory=set)
    nonlocals: set[str] = field(default_factory=set)
    star_imports: list[str] = field(default_factory=list)
    bases: list[Node] = field(default_factory=list)
    self_name: str = ""

    def bind(self, name: str, binding: Binding) -> None:
        """Note a binding; a name declared global or nonlocal is bound further out."""
        target = self
        if name in self.globals:
            while target.parent is not None:
                target = target.parent
        elif name in self.nonlocals and self.parent is not None:
            found = self.parent.lookup(name)
            target = found[0] if found is not None else self
        target.bindings.setdefault(name, []).append(binding)

    def lookup(self, name: str) -> tuple[Scope, list[Binding]] | None:
        """Find a name by Python's rules: classes are skipped from inside their functions."""
        scope: Scope | None = self
        while scope is not None:
            if (scope is self or scope.kind != "class") and name in scope.bindings:
                return scope, scope.bindings[name]
            scope = scope.parent
        return None

    def enclosing(self, kind: str) -> Scope | None:
        """Return the nearest scope of a kind, this one included."""
        scope: Scope | None = self
        while scope is not None and scope.kind != kind:
            scope = scope.parent
        return scope

    def is_within(self, other: Scope) -> bool:
        """Whether this scope is `other` or inside it."""
        scope: Scope | None = self
        while scope is not None and scope is not other:
            scope = scope.parent
        return scope is not None


class ScopeTree:
    """The scopes of a file, found by offset; it owns them."""

    def __init__(self, module: Scope) -> None:
        self.module = module
        self.all: list[Scope] = [module]
        self._starts: list[int] = []

    def __del__(self) -> None:
        """Part the scopes and their bindings, which only the cycle collector would free else."""
        for scope in self.all:
            scope.bindings.clear()
            scope.attributes.clear()

    def at(self, offset: int) -> Scope:
        """Return the innermost scope whose body holds the offset."""
        if len(self._starts) != len(self.all):
            self.all.sort(key=lambda scope: (scope.start, -scope.end))
            self._starts = [scope.start for scope in self.all]
        scope = self.all[max(bisect_right(self._starts, offset) - 1, 0)]
        while scope.parent is not None and scope.end <= offset:
            scope = scope.parent
        return scope

    def classes(self) -> list[Scope]:
        """Return the class scopes in the order of the file."""
        return [scope for scope in self.all if scope.kind == "class"]


_COMPREHENSIONS = frozenset(
    {"list_comprehension", "set_comprehension", "dictionary_comprehension", "generator_expression"}
)


def build_scopes(syntax: Syntax, captures: dict[str, list[Node]]) -> ScopeTree:
    """Build the scopes of a file and bind their names."""
    root = syntax.root
    tree = ScopeTree(Scope("module", "", root, 0, len(syntax.text) + 1))
    static = _static_functions(syntax, captures.get("decorated", []))
    opening = [
        node for tag in ("class", "function", "lambda", "comprehension")
        for node in captures.get(tag, [])
    ]  # fmt: skip
    opening.sort(key=lambda node: (node.start_byte, -node.end_byte))
    around = [tree.module]
    for node in opening:
        while len(around) > 1 and around[-1].node.end_byte <= node.start_byte:
            around.pop()
        # A default value or a base class lies in the definition but outside its body.
        outer = next(scope for scope in reversed(around) if scope.start <= node.start_byte)
        around.append(_open(syntax, node, outer, static))
        tree.all.append(around[-1])
    binder = _Binder(syntax, tree)
    binder.run(captures)
    return tree


def _static_functions(syntax: Syntax, decorated: list[Node]) -> set[int]:
    found = set()
    for node in decorated:
        definition = node.child_by_field_name("definition")
        if definition is not None and "staticmethod" in syntax.between(
            node.start_byte, definition.start_byte
        ):
            found.add(definition.start_byte)
    return found


def _open(syntax: Syntax, node: Node, outer: Scope, static: set[int]) -> Scope:
    kind = {"class_definition": "class", "function_definition": "function"}.get(
        node.type, "comprehension" if node.type in _COMPREHENSIONS else "lambda"
    )
    body = node if kind == "comprehension" else node.child_by_field_name("body") or node
    name_node = node.child_by_field_name("name")
    name = syntax.slice(name_node) if name_node is not None else ""
    # The comments before the first statement belong to the body as well.
    start = body.start_byte
    scope = Scope(kind, name, node, start, node.end_byte, outer)
    if kind == "class":
        bases = node.child_by_field_name("superclasses")
        if bases is not None:
            listed = bases.named_children
            given = [each for each in listed if each.type != "keyword_argument"]
            scope.bases = given[:MOST_BASES]
        outer.bind(name, Binding(BindingKind.CLASS, outer, node, owner=scope))
    elif kind == "function":
        outer.bind(name, Binding(BindingKind.FUNCTION, outer, node, owner=scope))
    if kind in ("function", "lambda"):
        _bind_parameters(syntax, node, scope, outer)
        if outer.kind == "class" and kind == "function" and node.start_byte not in static:
            scope.self_name = next(iter(scope.bindings), "")
    return scope


def _bind_parameters(syntax: Syntax, node: Node, scope: Scope, outer: Scope) -> None:
    parameters = node.child_by_field_name("parameters")
    if parameters is None:
        return
    index = 0
    is_positional = True
    for child in parameters.named_children:
        name = child.child_by_field_name("name")
        if child.type in ("keyword_separator", "list_splat_pattern"):
            is_positional = False
        if child.type == "identifier":
            name = child
        elif name is None and child.named_child_count:
            name = child.named_children[0]
            if name.type in ("list_splat_pattern", "dictionary_splat_pattern"):
                is_positional = is_positional and name.type != "list_splat_pattern"
                name = name.named_children[0] if name.named_child_count else None
        if name is None or name.type != "identifier":
            continue
        binding = Binding(
            BindingKind.PARAMETER,
            outer,
            child,
            value=child.child_by_field_name("value"),
            annotation=child.child_by_field_name("type"),
            index=index if is_positional else -1,
            owner=scope,
        )
        scope.bindings.setdefault(syntax.slice(name), []).append(binding)
        index += is_positional


class _Binder:
    """Binds what the statements of a file assign."""

    def __init__(self, syntax: Syntax, tree: ScopeTree) -> None:
        self._syntax = syntax
        self._tree = tree

    def run(self, captures: dict[str, list[Node]]) -> None:
        for node in captures.get("global", []):
            scope = self._tree.at(node.start_byte)
            names = {self._syntax.slice(child) for child in node.named_children}
            if node.type == "global_statement":
                scope.globals |= names
            else:
                scope.nonlocals |= names
        for node in captures.get("import", []):
            self._import(node)
        for node in captures.get("import_from", []):
            self._import_from(node)
        for node in captures.get("assignment", []):
            self._assignment(node)
        for node in captures.get("walrus", []):
            self._target(node.child_by_field_name("name"), node.child_by_field_name("value"), node)
        for node in captures.get("case", []):
            self._case(node)
        for tag, name in (("augmented", "left"), ("loop", "left"), ("as", "alias")):
            for node in captures.get(tag, []):
                self._target(node.child_by_field_name(name), None, node)

    def _case(self, node: Node) -> None:
        """Bind the names that a `case` captures: those without a dot."""
        pending = [node]
        while pending:
            current = pending.pop()
            is_name = current.type == "dotted_name" and current.named_child_count == 1
            if is_name or (current.type == "splat_pattern" and current.named_child_count):
                self._target(current.named_children[0], None, node)
            elif current is node or current.type != "case_pattern":
                pending.extend(current.named_children)

    def _import(self, node: Node) -> None:
        scope = self._tree.at(node.start_byte)
        for name in node.children_by_field_name("name"):
            alias = name.child_by_field_name("alias")
            if alias is not None:
                dotted = name.child_by_field_name("name")
                bound, target = self._syntax.slice(alias), self._dotted(dotted)
            else:
                target = self._dotted(name).split(".")[0]
                bound = target
            scope.bind(bound, Binding(BindingKind.IMPORT, scope, node, target=target))

    def _import_from(self, node: Node) -> None:
        scope = self._tree.at(node.start_byte)
        module = self._dotted(node.child_by_field_name("module_name"))
        stars = scope.star_imports
        is_star = any(child.type == "wildcard_import" for child in node.named_children)
        # Each of them may bind each name that the file does not.
        if is_star and module not in stars and len(stars) < _MOST_STARS:
            stars.append(module)
        for name in node.children_by_field_name("name"):
            alias = name.child_by_field_name("alias")
            source = name.child_by_field_name("name") if alias is not None else name
            target = joined(module, self._dotted(source))
            bound = self._syntax.slice(alias if alias is not None else name)
            scope.bind(bound, Binding(BindingKind.IMPORT, scope, node, target=target))

    def _dotted(self, node: Node | None) -> str:
        return "".join(self._syntax.slice(node).split()) if node is not None else ""

    def _assignment(self, node: Node) -> None:
        value = node.child_by_field_name("right")
        while value is not None and value.type == "assignment":
            value = value.child_by_field_name("right")
        if value is None:
            return
        self._target(
            node.child_by_field_name("left"), value, node, node.child_by_field_name("type")
        )

    def _target(
        self, target: Node | None, value: Node | None, node: Node, annotation: Node | None = None
    ) -> None:
        if target is None:
            return
        scope = self._tree.at(target.start_byte)
        if target.type == "identifier":
            kind = BindingKind.VALUE if value is not None else BindingKind.UNKNOWN
            binding = Binding(kind, scope, node, value=value, annotation=annotation)
            if node.type == "named_expression" and scope.kind == "comprehension":
                scope = scope.enclosing("function") or self._tree.module
            scope.bind(self._syntax.slice(target), binding)
        elif target.type == "attribute":
            self._attribute(target, value, node, scope, annotation)
        elif target.type == "as_pattern_target" and target.named_child_count == 1:
            self._target(target.named_children[0], value, node)
        elif target.type in _SEQUENCES:
            targets = parts_of(target)
            for child, part in zip(targets, self._values(value, len(targets)), strict=True):
                self._target(child, part, node)

    @staticmethod
    def _values(value: Node | None, count: int) -> list[Node | None]:
        parts = parts_of(value) if value is not None and value.type in _SEQUENCES else []
        if len(parts) == count and not any(part.type == "list_splat" for part in parts):
            return list(parts)
        return [None] * count

    def _attribute(
        self, target: Node, value: Node | None, node: Node, scope: Scope, annotation: Node | None
    ) -> None:
        holder = target.child_by_field_name("object")
        name = target.child_by_field_name("attribute")
        if holder is None or name is None or holder.type != "identifier":
            return
        owner = self.class_of(self._syntax.slice(holder), scope)
        kind = BindingKind.VALUE if value is not None else BindingKind.UNKNOWN
        binding = Binding(kind, scope, node, value=value, annotation=annotation)
        if owner is not None:
            owner.attributes.setdefault(self._syntax.slice(name), []).append(binding)

    def class_of(self, name: str, scope: Scope) -> Scope | None:
        """Return the local class that `self`, an instance, or the class's own name stands for."""
        found = scope.lookup(name)
        if found is None:
            return None
        holder, bindings = found
        if holder.self_name == name and holder.parent is not None:
            return holder.parent
        if len(bindings) != 1:
            return None
        binding = bindings[0]
        if binding.kind is BindingKind.CLASS:
            return binding.owner
        if binding.value is not None and binding.value.type == "call":
            callee = binding.value.child_by_field_name("function")
            if callee is not None and callee.type == "identifier":
                made = binding.scope.lookup(self._syntax.slice(callee))
                if made is not None and len(made[1]) == 1 and made[1][0].kind is BindingKind.CLASS:
                    return made[1][0].owner
        return None


_SEQUENCES = frozenset(
    {"pattern_list", "tuple_pattern", "list_pattern", "expression_list", "tuple", "list"}
)  # fmt: skip
