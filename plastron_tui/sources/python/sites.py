"""The call sites of a file that create endpoints, and the nodes that they belong to."""

from __future__ import annotations

import re
from dataclasses import replace
from typing import TYPE_CHECKING

from tree_sitter import Node

from .analysis import Analysis, NodeSite, Site
from .arguments import Arguments
from .calls import Argument, CallShape, ClientLibrary
from .constants import Known
from .created import created_by
from .disguised import disguised
from .names import NODE, Resolver
from .scopes import Scope, build_scopes
from .syntax import Syntax

if TYPE_CHECKING:
    from .package import PackageNames

# How people call a variable that holds a node, where nothing else says what it is.
_NODE_VARIABLE = re.compile(r"(?:\w*_)?node(?:handle)?_*$", re.IGNORECASE)
_NODE_MAKER = re.compile(r"(Node|_node)$")
# Packages whose classes are no nodes, so that a class derived from them is none either.
_NO_NODES = frozenset(
    {"threading", "multiprocessing", "unittest", "enum", "abc", "typing", "collections", "logging"}
    | {"PyQt5", "PyQt6", "PySide2", "PySide6", "python_qt_binding", "tkinter", "dataclasses"}
)


def outline(
    syntax: Syntax, library: ClientLibrary, package: PackageNames | None = None
) -> Analysis:
    """Find out what the names of a file stand for, and no call sites yet."""
    captures = syntax.captures("structure")
    scopes = build_scopes(syntax, captures)
    calls = sorted(captures.get("call", []), key=lambda node: node.start_byte)
    resolver = Resolver(syntax, scopes, calls, library, package)
    if package is not None and package.is_beside:
        resolver.effort = package.effort
    return Analysis(syntax, library, scopes, resolver, captures, package=package)


def complete(outlined: Analysis) -> Analysis:
    """Find the call sites of a file of which no more than the names were known."""
    finder = _Finder(outlined)
    for call in sorted(outlined.captures.get("call", []), key=lambda node: node.start_byte):
        finder.visit(call)
    finder.add_unsure()
    finder.add_node_classes()
    # An outer call comes before the calls in its arguments, as in the text.
    finder.sites.sort(key=lambda site: (site.call.start_byte, site.endpoint.span.start))
    return replace(
        outlined,
        sites=tuple(finder.sites),
        disguised=tuple(finder.disguised),
        nodes=tuple(finder.nodes),
    )


class _Finder:
    def __init__(self, analysis: Analysis) -> None:
        self.sites: list[Site] = []
        self.disguised: list[Site] = []
        self.nodes: list[NodeSite] = []
        self._a = analysis
        self._functions = analysis.library.functions()
        self._methods = analysis.library.methods()
        self._disguising = disguised(analysis.library.module)
        self._node_calls = analysis.library.node_calls
        self._node_classes = analysis.library.node_classes
        self._nodes_by_use: set[tuple[int, str]] = set()
        self._class_names: dict[Scope, tuple[Node | None, str | None, str]] = {}
        self._heirs: dict[Scope, Scope | None] = {}
        self._unsure: list[tuple[Node, CallShape, Scope, Node, Arguments]] = []

    def visit(self, call: Node) -> None:
        callee = call.child_by_field_name("function")
        if callee is None or callee.type not in ("identifier", "attribute"):
            return
        scope = self._a.scopes.at(call.start_byte)
        shape: CallShape | None = None
        holder: Node | None = None
        if callee.type == "attribute":
            name = callee.child_by_field_name("attribute")
            text = self._a.syntax.slice(name) if name is not None else ""
            shape = self._methods.get(text)
            holder = callee.child_by_field_name("object")
            if shape is not None and holder is not None:
                arguments = Arguments.of(call, self._a.syntax)
                if self._is_node(holder, scope, shape, arguments):
                    self._add(call, shape, scope, holder, arguments)
                elif self._may_be_shown(holder, scope, shape, arguments):
                    self._unsure.append((call, shape, scope, holder, arguments))
                return
        for qualified in self._a.resolver.qualified(callee, scope):
            if qualified in self._functions:
                arguments = Arguments.of(call, self._a.syntax)
                self._add(call, self._functions[qualified], scope, None, arguments)
                return
            for shape in self._disguising.get(qualified, ()):
                arguments = Arguments.of(call, self._a.syntax)
                self._add(call, shape, scope, None, arguments, self.disguised)
            if qualified in self._node_calls:
                self._add_node(call, scope, self._node_calls[qualified])
                return
            if qualified in self._node_classes:
                self._add_node(call, scope, Argument(0, "node_name"))
                return

    def add_unsure(self) -> None:
        """Add what is made on an object that creates something of an interface type elsewhere."""
        for call, shape, scope, holder, arguments in self._unsure:
            if self._variable(holder, scope) in self._nodes_by_use:
                self._add(call, shape, scope, holder, arguments)

    def _may_be_shown(
        self, holder: Node, scope: Scope, shape: CallShape, arguments: Arguments
    ) -> bool:
        """Whether other calls may show that an object is a node, as this one does not."""
        instance = self._a.resolver.instance(holder, scope)
        is_unknown = instance is None or bool(instance.qualified)
        return shape.type is None and is_unknown and self._is_complete(shape, arguments)

    def _variable(self, holder: Node, scope: Scope) -> tuple[int, str] | None:
        """Return the variable that holds an object: the scope that it is of, and its source."""
        root = holder
        while root.type == "attribute" and (inner := root.child_by_field_name("object")):
            root = inner
        found = scope.lookup(self._a.syntax.slice(root)) if root.type == "identifier" else None
        if found is None:
            return None
        is_self = found[0].self_name == self._a.syntax.slice(root)
        owner = found[0].parent if is_self and found[0].parent is not None else found[0]
        return owner.start, self._a.syntax.slice(holder)

    def _add_node(self, call: Node, scope: Scope, argument: Argument) -> None:
        name, expression = self._node_name(call, scope, argument)
        self.nodes.append(NodeSite(name, expression, call, scope))

    def _node_name(self, call: Node, scope: Scope, argument: Argument) -> tuple[str | None, str]:
        given = Arguments.of(call, self._a.syntax).get(argument)
        if given is None:
            return None, ""
        folded = self._a.resolver.fold(given, scope)
        is_known = isinstance(folded, Known) and isinstance(folded.value, str)
        name = folded.value if is_known and isinstance(folded, Known) else None
        return (name if isinstance(name, str) else None), self._a.syntax.slice(given)

    def add_node_classes(self) -> None:
        """Add the classes that derive from a node class, under the name that they give."""
        if not self._node_classes:
            return
        for owner in self._a.scopes.classes():
            is_used = any(site.owner is owner and site.receiver for site in self.sites)
            if self.is_node_class(owner, is_used):
                call, name, expression = self._class_name(owner)
                self.nodes.append(NodeSite(name, expression, call, owner, owner))
        self.nodes.sort(key=lambda node: (node.call or node.scope.node).start_byte)

    def is_node_class(self, owner: Scope, is_used: bool) -> bool:
        """Whether instances of a class of the file are nodes; `is_used` as such, at least."""
        if self._a.resolver.derives_from(owner, self._node_classes):
            return True
        return is_used and self._may_be_node(owner)

    def _class_name(self, owner: Scope) -> tuple[Node | None, str | None, str]:
        """Find the call that names a node class: its own constructor's, or its maker's."""
        if owner not in self._class_names:
            # Classes may derive from each other, in a file that does not run.
            self._class_names[owner] = None, None, ""
            self._class_names[owner] = self._find_class_name(owner)
        return self._class_names[owner]

    def _find_class_name(self, owner: Scope) -> tuple[Node | None, str | None, str]:
        syntax = self._a.syntax
        found: list[tuple[Node | None, str | None, str]] = []
        for call in self._a.captures.get("call", []):
            if not (owner.start <= call.start_byte < owner.end):
                continue
            scope = self._a.scopes.at(call.start_byte)
            function = scope.enclosing("function")
            if function is None or function.parent is not owner or function.name != "__init__":
                continue
            callee = call.child_by_field_name("function")
            text = "".join(syntax.slice(callee).split()) if callee is not None else ""
            holder, _, method = text.rpartition(".")
            if method != "__init__":
                continue
            is_super = holder.startswith("super(") and holder.endswith(")")
            found.append(self._base_name(owner, call, scope, 0 if is_super else 1))
        if found:
            first, name, expression = found[0]
            return first, name if all(name == other[1] for other in found) else None, expression
        if not any(s.parent is owner and s.name == "__init__" for s in self._a.scopes.all):
            return self._maker_name(owner)
        return None, None, ""

    def _base_name(
        self, owner: Scope, call: Node, scope: Scope, offset: int
    ) -> tuple[Node | None, str | None, str]:
        name, expression = self._node_name(call, scope, Argument(offset, "node_name"))
        if name is None and not expression:
            # A base class of the file may name the node.
            for base in self._a.resolver.classes.bases(owner)[:8]:
                if base is not owner:
                    _, name, expression = self._class_name(base)
                    if name is not None:
                        return call, name, expression
        return call, name, expression

    def _maker_name(self, owner: Scope) -> tuple[Node | None, str | None, str]:
        found = []
        for call in self._a.captures.get("call", []):
            callee = call.child_by_field_name("function")
            if callee is not None and self._a.syntax.slice(callee) == owner.name:
                found.append(call)
        names = {
            self._node_name(call, self._a.scopes.at(call.start_byte), Argument(0, "node_name"))
            for call in found
        }
        if len(names) == 1:
            name, expression = names.pop()
            return None, name, expression
        return None, None, ""

    def _is_node(self, holder: Node, scope: Scope, shape: CallShape, arguments: Arguments) -> bool:
        """Whether a method's object is a node, as far as the file can tell."""
        resolver = self._a.resolver
        instance = resolver.instance(holder, scope)
        if instance is not None:
            if instance.qualified == NODE:
                return True
            if instance.qualified:
                # Of a class of another file, or made by a function of one: nothing but a node
                # takes an interface type; what takes none says no more than what it is called.
                is_called_node = _NODE_MAKER.search(instance.qualified) is not None
                may_be_node = instance.qualified.partition(".")[0] not in _NO_NODES
                is_shown = is_called_node or (shape.type is not None and may_be_node)
                return is_shown and self._is_typed(shape, arguments, scope)
            owner = instance.scope
            if owner is not None and resolver.derives_from(owner, self._node_classes):
                return True
            return owner is not None and self._is_mixin(owner, shape, arguments, scope)
        if holder.type == "call" and self._is_super(holder, scope):
            return True
        is_typed = shape.type is not None and self._is_typed(shape, arguments, scope)
        if not self._is_called_node(holder, scope):
            return is_typed and shape.node is None
        # Nothing but a node has these methods, with as many arguments.
        return shape.type is None or is_typed or self._is_complete(shape, arguments)

    def _is_mixin(self, owner: Scope, shape: CallShape, arguments: Arguments, scope: Scope) -> bool:
        """Whether the method must be that of a node, which another class or file brings in."""
        scopes = [owner, *self._a.resolver.classes.bases(owner)]
        if any(name in each.bindings for each in scopes for name in shape.callees):
            return False
        if self.heir(owner) is not None or not self._a.resolver.foreign_bases(owner):
            return not any(base.type == "call" for each in scopes for base in each.bases)
        return self._may_be_node(owner) and self._is_typed(shape, arguments, scope)

    def _is_super(self, holder: Node, scope: Scope) -> bool:
        callee = holder.child_by_field_name("function")
        owner = scope.enclosing("class")
        return (
            callee is not None
            and self._a.syntax.slice(callee) == "super"
            and owner is not None
            and self._a.resolver.derives_from(owner, self._node_classes)
        )

    def heir(self, owner: Scope) -> Scope | None:
        """Return the node class of the file that inherits from a class that is none itself."""
        if owner not in self._heirs:
            resolver = self._a.resolver
            derived = resolver.classes.derived(owner)
            nodes = (each for each in derived if resolver.derives_from(each, self._node_classes))
            self._heirs[owner] = next(nodes, None)
        return self._heirs[owner]

    def _may_be_node(self, owner: Scope) -> bool:
        """Whether a class derives from a class of another file, which may be a node's."""
        return any(
            name.partition(".")[0] not in _NO_NODES
            for name in self._a.resolver.foreign_bases(owner)
        )

    def _is_called_node(self, holder: Node, scope: Scope) -> bool:
        """Whether an object that comes from elsewhere goes by the name of a node."""
        node = holder
        if holder.type == "attribute":
            node = holder.child_by_field_name("attribute") or holder
        if node.type != "identifier" or not _NODE_VARIABLE.match(self._a.syntax.slice(node)):
            return False
        # A bare name must at least be bound; an attribute may be set by another file.
        return holder.type == "attribute" or scope.lookup(self._a.syntax.slice(node)) is not None

    def _is_complete(self, shape: CallShape, arguments: Arguments) -> bool:
        """Whether a call gives all that an endpoint needs, in a file that imports the library."""
        wanted = (shape.name, shape.type, shape.callback)
        is_given = all(each is None or arguments.get(each) is not None for each in wanted)
        return (
            is_given or arguments.is_open
        ) and self._a.library.module.encode() in self._a.syntax.text

    def _is_typed(self, shape: CallShape, arguments: Arguments, scope: Scope) -> bool:
        """Whether the call names an interface type where the shape wants one."""
        if shape.type is None:
            return True
        return self._a.resolver.interface(arguments.get(shape.type), scope) is not None

    def _add(
        self,
        call: Node,
        shape: CallShape,
        scope: Scope,
        holder: Node | None,
        arguments: Arguments,
        sites: list[Site] | None = None,
    ) -> None:
        sites = self.sites if sites is None else sites
        owner: Scope | None = None
        receiver = ""
        if shape.node is not None:
            holder = arguments.get(shape.node)
        if holder is not None:
            receiver = self._a.syntax.slice(holder)
            instance = self._a.resolver.instance(holder, scope)
            owner = instance.scope if instance is not None else None
            if owner is None and holder.type == "call":
                owner = scope.enclosing("class")
            variable = self._variable(holder, scope)
            if variable is not None and shape.type is not None:
                self._nodes_by_use.add(variable)
        if owner is not None and not self._a.resolver.derives_from(owner, self._node_classes):
            owner = self.heir(owner) or owner
        is_guess = shape.node is None and self._may_be_other(holder, scope)
        for endpoint, passes in created_by(self._a, call, shape, scope, arguments):
            found = endpoint._replace(is_guess=endpoint.is_guess or is_guess)
            site = Site(found, call, scope, receiver, owner, arguments, shape, passes)
            sites.append(site)

    def _may_be_other(self, holder: Node | None, scope: Scope) -> bool:
        """Whether an object is of another file and has no name that nodes have."""
        instance = self._a.resolver.instance(holder, scope)
        qualified = instance.qualified if instance is not None else ""
        return qualified not in ("", NODE) and not _NODE_MAKER.search(qualified)
