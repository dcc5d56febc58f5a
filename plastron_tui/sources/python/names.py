"""What a name stands for, as far as the file says it, and never a guess."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from tree_sitter import Node

from plastron_tui.ros.interfaces import InterfaceName
from plastron_tui.sources.work_limits import bounded

from .calls import ClientLibrary
from .constants import MOST_BINDINGS, MOST_DEEP, Constants, Folded, without_none
from .containers import Given
from .imported_names import ImportedNames, joined
from .passes import Passes
from .scopes import Binding, BindingKind, Scope, ScopeTree
from .syntax import Syntax, parts_of
from .type_names import Types

# What `from our_tools import *` brings along, where no import of the file binds these names.
_LIBRARIES = frozenset({"rospy", "rclpy", "message_filters", "actionlib"})
_ANYTHING = frozenset({"typing.Any", "typing.TypeVar", "typing.Protocol"})


NODE = "a node"
"""What the qualified name of a node of the client library itself stands for."""


@dataclass(frozen=True, slots=True)
class Instance:
    """An object of a class: one of the file (`scope`), or an imported one (`qualified`)."""

    scope: Scope | None = None
    qualified: str = ""


class Resolver(Passes):
    """Answers what the names of one file stand for."""

    def __init__(
        self,
        syntax: Syntax,
        scopes: ScopeTree,
        calls: list[Node],
        library: ClientLibrary,
        package: ImportedNames | None = None,
    ) -> None:
        super().__init__(syntax, scopes, calls)
        self.package = package
        self._ros = library.distribution
        self._node_makers = library.node_classes | library.node_calls.keys()
        self._trace: list[Node] | None = None
        self._distinct_of: dict[tuple[Scope, str], list[Binding]] = {}
        self._foreign: dict[Scope, list[str]] = {}
        self._own_foreign: dict[Scope, list[str]] = {}

    @bounded(())
    def qualified(self, node: Node | None, scope: Scope, depth: int = 0) -> tuple[str, ...]:
        """Return the qualified names that an imported name may stand for.

        Where other files of the package hand it on, they are those that it has outside of it.
        """
        names = self.seen(node, scope, depth)
        if self.package is None:
            return names
        return tuple(dict.fromkeys(t for name in names for t in self.package.targets(name, depth)))

    def seen(self, node: Node | None, scope: Scope, depth: int) -> tuple[str, ...]:
        """Return the qualified names that the file itself gives to an imported name."""
        tail: list[str] = []
        while node is not None and node.type == "attribute":
            part = node.child_by_field_name("attribute")
            tail.append(self._syntax.slice(part) if part is not None else "")
            node = node.child_by_field_name("object")
        if node is None or node.type != "identifier" or depth > MOST_DEEP:
            return ()
        name = self._syntax.slice(node)
        suffix = "".join(f".{part}" for part in reversed(tail))
        found = scope.lookup(name)
        if found is None:
            stars = self.star_modules(scope)
            own = (name + suffix,) if name in _LIBRARIES and stars else ()
            return own + tuple(joined(module, name) + suffix for module in stars)
        targets: dict[str, None] = {}
        for binding in self._distinct(name, *found):
            for target in self.targets(binding, name, depth):
                targets[target + suffix] = None
        if not targets and tail and found[0].self_name == name:
            return self._held(found[0].parent, tail[::-1], depth)
        return tuple(targets)

    def _distinct(self, name: str, scope: Scope, bindings: list[Binding]) -> list[Binding]:
        """Return the bindings of a name, an import that is repeated only once."""
        if len(bindings) == 1:
            return bindings
        if (scope, name) not in self._distinct_of:
            seen = {
                b.target if b.kind is BindingKind.IMPORT else b: b for b in bindings[:MOST_BINDINGS]
            }
            self._distinct_of[scope, name] = list(seen.values())
        return self._distinct_of[scope, name]

    def _held(self, owner: Scope | None, path: list[str], depth: int) -> tuple[str, ...]:
        """Return what `self.library.name` stands for, where the attribute has one value."""
        first, *rest = path
        if owner is None:
            return ()
        attributes, names = owner.attributes.get(first, []), owner.bindings.get(first, [])
        if len(attributes) + len(names) > MOST_BINDINGS:
            return ()
        own = attributes + names
        # Most attributes hold what a call made, which is cheaper to see than their other values.
        if not any(map(_may_name, own)) and (own or not owner.bases):
            return ()
        bindings = without_none(self.classes.attribute(owner, first))
        if len(bindings) != 1:
            return ()
        return tuple(".".join((each, *rest)) for each in self.targets(bindings[0], "", depth))

    def star_modules(self, scope: Scope) -> list[str]:
        """Return the modules that are imported whole where a scope sees them."""
        found: list[str] = []
        current: Scope | None = scope
        while current is not None:
            found += current.star_imports
            current = current.parent
        return found if self.package is None else self.package.star_modules(found)

    def targets(self, binding: Binding, name: str, depth: int) -> tuple[str, ...]:
        """Return the qualified names of what is imported that a binding gives a name to."""
        if binding.kind is BindingKind.IMPORT:
            return (binding.target,)
        value, scope = binding.value, binding.scope
        item = self.item(binding, name)
        if isinstance(item, Given):
            value, scope = item
        elif binding.kind is BindingKind.PARAMETER and not self.keeps_default(binding, name, depth):
            return ()
        if value is None or value.type not in ("identifier", "attribute"):
            return ()
        if self._syntax.slice(value) == name and scope is binding.scope:
            return ()
        return self.qualified(value, scope, depth + 1)

    @bounded(None)
    def interface(self, node: Node | None, scope: Scope, depth: int = 0) -> InterfaceName | None:
        """Return the interface type that an expression names."""
        types = Types(self, self._syntax, self._ros)
        return types.named(node, scope, depth) if depth <= MOST_DEEP else None

    def attribute_bindings(self, node: Node, scope: Scope, depth: int = 0) -> list[Binding]:
        """Return what binds `object.name` where the object is of a class of the file."""
        holder, name = node.child_by_field_name("object"), node.child_by_field_name("attribute")
        if holder is None or name is None or depth > MOST_DEEP:
            return []
        owner = self.class_scope(holder, scope, depth + 1)
        return self.classes.attribute(owner, self._syntax.slice(name)) if owner is not None else []

    def class_scope(self, node: Node, scope: Scope, depth: int = 0) -> Scope | None:
        """Return the class of the file that an expression is, or is an instance of."""
        if node.type == "identifier":
            found = scope.lookup(self._syntax.slice(node))
            if found is not None and len(found[1]) == 1:
                binding = found[1][0]
                if binding.kind is BindingKind.CLASS:
                    return binding.owner
        instance = self.instance(node, scope, depth)
        return instance.scope if instance is not None else None

    def derives_from(self, owner: Scope, classes: frozenset[str]) -> bool:
        """Whether a class of the file derives from one of the named classes."""
        return not classes.isdisjoint(self.foreign_bases(owner))

    def foreign_bases(self, owner: Scope) -> list[str]:
        """Return the qualified names of the imported classes that a class derives from."""
        if owner not in self._foreign:
            scopes = (owner, *self.classes.bases(owner))
            found = dict.fromkeys(name for scope in scopes for name in self._foreign_of(scope))
            self._foreign[owner] = list(found)[:MOST_BINDINGS]
        return self._foreign[owner]

    def _foreign_of(self, owner: Scope) -> list[str]:
        if owner not in self._own_foreign:
            outer = owner.parent
            bases = {self._syntax.slice(base): base for base in owner.bases}.values()
            self._own_foreign[owner] = [
                name for base in bases if outer is not None for name in self.qualified(base, outer)
            ]
            if self.package is not None:
                for name in self._own_foreign[owner][:]:
                    self._own_foreign[owner] += self.package.bases(name)
        return self._own_foreign[owner]

    @bounded(None)
    def instance(self, node: Node | None, scope: Scope, depth: int = 0) -> Instance | None:
        """Return what an expression is an instance of; None where the file does not say it."""
        if node is None or depth > MOST_DEEP:
            return None
        if node.type == "parenthesized_expression" and node.named_child_count == 1:
            return self.instance(node.named_children[0], scope, depth + 1)
        if node.type == "call":
            return self._made_by(node, scope)
        if node.type in ("conditional_expression", "boolean_operator"):
            # `node or create_node('x')`: what is known of one side is meant of the other.
            parts = parts_of(node)
            sides = [self.instance(side, scope, depth + 1) for side in (parts[0], parts[-1])]
            known = {side for side in sides if side is not None}
            return known.pop() if len(known) == 1 else None
        bindings: list[Binding] = []
        if node.type == "identifier":
            name = self._syntax.slice(node)
            found = scope.lookup(name)
            if found is None:
                return None
            if found[0].self_name == name and found[0].parent is not None:
                return Instance(found[0].parent)
            bindings = found[1]
        elif node.type == "attribute":
            bindings = self.attribute_bindings(node, scope, depth + 1)
        if len(bindings) > MOST_BINDINGS:
            return None
        kinds = {self._instance_of(binding, node, depth) for binding in without_none(bindings)}
        return kinds.pop() if len(kinds) == 1 else None

    def _instance_of(self, binding: Binding, node: Node, depth: int) -> Instance | None:
        if binding.annotation is not None and binding.annotation.named_child_count:
            annotation = binding.annotation.named_children[0]
            for name in _annotated(annotation):
                if (made := self._class(name, binding.scope)) is not None:
                    return made
        if binding.kind is BindingKind.VALUE:
            return self.instance(binding.value, binding.scope, depth + 1)
        if binding.kind is BindingKind.PARAMETER:
            given = self.given(binding, self._syntax.slice(node))
            return self._common_instance(given, depth)
        if binding.kind is BindingKind.UNKNOWN and binding.node.type == "as_pattern":
            value = binding.node.named_children[0] if binding.node.named_child_count else None
            return self.instance(value, binding.scope, depth + 1)
        if binding.kind is BindingKind.UNKNOWN and binding.node.type == "for_statement":
            items = binding.node.child_by_field_name("right")
            if items is not None and items.type in ("list", "tuple"):
                values = [(item, binding.scope) for item in parts_of(items)]
                return self._common_instance(values, depth)
        return None

    def _common_instance(
        self, values: Sequence[tuple[Node | None, Scope]], depth: int
    ) -> Instance | None:
        # Each caller may have callers of its own: few of them settle it.
        found = {self.instance(value, scope, depth + 4) for value, scope in values}
        return found.pop() if len(found) == 1 else None

    def _made_by(self, call: Node, scope: Scope) -> Instance | None:
        callee = call.child_by_field_name("function")
        return self._class(callee, scope) if callee is not None else None

    def _class(self, node: Node, scope: Scope) -> Instance | None:
        if node.type == "string":
            name, dot, rest = self._syntax.slice(node).strip("\"'").partition(".")
            found = scope.lookup(name)
            for binding in found[1][:MOST_BINDINGS] if found is not None else []:
                if binding.kind is BindingKind.CLASS and not dot:
                    return Instance(binding.owner)
                if binding.kind is BindingKind.IMPORT:
                    return self._imported_class((binding.target + dot + rest,))
            return None
        if node.type == "identifier":
            found = scope.lookup(self._syntax.slice(node))
            for binding in found[1][:MOST_BINDINGS] if found is not None else []:
                if binding.kind is BindingKind.CLASS:
                    return Instance(binding.owner)
        return self._imported_class(self.qualified(node, scope))

    def _imported_class(self, names: Sequence[str]) -> Instance | None:
        if any(name in self._node_makers for name in names):
            return Instance(None, NODE)
        return Instance(None, names[0]) if names and names[0] not in _ANYTHING else None

    @bounded(None)
    def fold(self, node: Node | None, scope: Scope, depth: int = 0) -> Folded:
        """Return the constant that an expression is."""
        # Not kept: each would hold the other, and only the cycle collector would free them.
        constants = Constants(self, self._syntax, self._scopes, self._trace)
        return constants.fold(node, scope, depth)

    def fold_all(self, bindings: list[Binding], name: str, depth: int) -> Folded:
        """Return the constant that a name is by all that binds it."""
        constants = Constants(self, self._syntax, self._scopes, self._trace)
        return constants.fold_all(bindings, name, depth)

    def traced(self, fold: Callable[[], Folded]) -> tuple[Folded, list[Node]]:
        """Return the constant that an expression is, and the expressions that decide it."""
        before, trace = self._trace, list[Node]()
        self._trace = trace
        try:
            return fold(), trace
        finally:
            self._trace = before

    def read_for(self, node: Node, scope: Scope) -> list[Node]:
        """Return the expressions that decide which constant an expression is."""
        return self.traced(lambda: self.fold(node, scope))[1]


def _may_name(binding: Binding) -> bool:
    """Whether a binding may give something that is imported another name."""
    is_import = binding.kind is BindingKind.IMPORT
    return is_import or (
        binding.value is not None and binding.value.type in ("identifier", "attribute")
    )


def _annotated(annotation: Node) -> list[Node]:
    """Return the names in an annotation, those of `Optional[X]` and `X | None` included."""
    if annotation.type in ("identifier", "attribute", "string"):
        return [annotation]
    found: list[Node] = []
    pending = [annotation]
    while pending and len(found) < 8:
        node = pending.pop(0)
        if node.type in ("identifier", "attribute", "string"):
            found.append(node)
        else:
            pending.extend(node.named_children)
    return found[1:] if annotation.type in ("generic_type", "subscript") else found
