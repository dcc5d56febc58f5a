"""Bringing a name into a file, in the manner in which the file imports the others."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator

from tree_sitter import Node

from plastron_tui.ros.interfaces import InterfaceName

from . import naming
from .analysis import Analysis
from .constants import without_none
from .conventions import Conventions, leading_space
from .import_block import Imports, member_key
from .import_place import imports_in, is_library, module_of, place_import
from .imports import is_interface_module
from .references import identifiers, is_member
from .scopes import Binding, BindingKind, Scope
from .splices import Splice, line_end, line_start
from .stars import star_interface


class FileImports(Imports):
    """The imports of a file that is edited: what it has, and what an edit adds."""

    def __init__(self, analysis: Analysis, conventions: Conventions) -> None:
        super().__init__()
        self._analysis = analysis
        self._conventions = conventions
        self._given: dict[tuple[int, str, str], str] = {}
        self._new: dict[tuple[int, str], list[tuple[str, str]]] = {}
        self._new_modules: list[tuple[int, str]] = []
        self._homes: dict[int, Node] = {}
        self._module = analysis.scopes.module
        self._scope, self._offset = self._module, 0
        self._method: Scope | None = None

    def stand(self, scope: Scope, offset: int, method: Scope | None = None) -> None:
        """Say where what is written next stands: names that are imported there are seen there.

        What the method imports that creates the endpoint, the other methods do not see.
        """
        self._scope, self._offset, self._method = scope, offset, method

    def use(self, module: str, name: str) -> str:
        """Import a name unless the file has it, and return what the file calls it."""
        local = self._local(module, name)
        if local is not None:
            return local
        symbol = (self._home(), module, name)
        if symbol not in self._given:
            self._given[symbol] = self._existing(module, name) or self._imported(module, name)
        return self._given[symbol]

    def library(self, module: str, name: str, scope: Scope) -> str:
        """Return what the code of a scope calls a name of the client library."""
        current: Scope | None = scope
        while current is not None:
            for bound, bindings in current.bindings.items():
                if any(b.kind is BindingKind.IMPORT and b.target == module for b in bindings):
                    return f"{bound}.{name}"
            current = current.parent
        existing = self._existing(module, name)
        if existing is not None:
            return existing
        if self._extendable(self._home(), module) is not None:
            return self.use(module, name)
        if not (self._module.star_imports and self._is_used_unbound(module)):
            self._new_modules.append((self._home(), module))
        return f"{module}.{name}"

    def _functions(self) -> Iterator[Scope]:
        """Yield the functions around the place, the innermost first."""
        scope: Scope | None = self._scope
        while scope is not None and scope.parent is not None:
            if scope.kind != "class":
                yield scope
            scope = scope.parent

    def _local(self, module: str, name: str) -> str | None:
        """Return what a function around the place calls a name that it imports itself."""
        hidden: set[str] = set()
        for scope in self._functions():
            for bound, bindings in scope.bindings.items():
                targets = {binding.target for binding in bindings}
                is_import = all(
                    binding.kind is BindingKind.IMPORT and binding.node.end_byte <= self._offset
                    for binding in bindings
                )
                if not is_import or bound in hidden:
                    continue
                if targets == {f"{module}.{name}"}:
                    return bound
                if targets == {module} and "." in module and bound != module:
                    return f"{bound}.{name}"
            hidden |= scope.bindings.keys()
        return None

    def _existing(self, module: str, name: str) -> str | None:
        wanted = f"{module}.{name}"
        hidden = {bound for scope in self._functions() for bound in scope.bindings}
        for bound, every in self._module.bindings.items():
            bindings = [each for each in without_none(every) if not _is_for_types_only(each.node)]
            if bound in hidden or not bindings:
                continue
            if all(binding.kind is BindingKind.IMPORT for binding in bindings):
                targets = {binding.target for binding in bindings}
                if targets == {wanted}:
                    return bound
                if targets == {module} and (module != bound or "." not in module):
                    return f"{bound}.{name}"
                if any(self._imports_whole(binding, module) for binding in bindings):
                    return wanted
        if name in self._module.bindings:
            return None
        stars = self._module.star_imports
        if module in stars:
            # A service's module has its request and response classes as well.
            base = re.sub("(Request|Response)$", "", name) if module.endswith(".srv") else name
            found = star_interface(base, stars, self._analysis.library.distribution)
            is_interface = is_interface_module(module)
            if not is_interface or found == InterfaceName(module.partition(".")[0], base):
                return name
        return None

    def _imports_whole(self, binding: Binding, module: str) -> bool:
        return binding.node.type == "import_statement" and any(
            child.type == "dotted_name" and self._analysis.syntax.slice(child) == module
            for child in binding.node.children_by_field_name("name")
        )

    def _imported(self, module: str, name: str) -> str:
        if self._prefers_modules(module):
            self._new_modules.append((self._home(), module))
            return f"{module}.{name}"
        taken = {*self._module.bindings, *self._given.values()} - self._typing_names(module, name)
        taken = taken.union(*(scope.bindings for scope in self._functions()))
        package = naming.capitals(module.partition(".")[0])
        if self._is_used_unbound(name):
            taken.add(name)
        bound = name if name not in taken else naming.Scope(taken).new(package + name)
        self._new.setdefault((self._home(), module), []).append((name, bound))
        return bound

    def _typing_names(self, module: str, name: str) -> set[str]:
        """Return the name itself where all that the file binds to it is the same, for types."""
        bindings = self._module.bindings.get(name, [])
        is_same = all(
            each.target == f"{module}.{name}" and _is_for_types_only(each.node) for each in bindings
        )
        return {name} if is_same else set()

    def _is_used_unbound(self, name: str) -> bool:
        """Whether the file uses a name that a star import may bring, which a new one would hide."""
        return any(
            not is_member(node) and self._analysis.scopes.at(node.start_byte).lookup(name) is None
            for node in identifiers(name, self._analysis)
        )

    def _prefers_modules(self, module: str) -> bool:
        """Whether the file imports the modules of interface types whole."""
        if not is_interface_module(module):
            return False
        named = whole = 0
        for bindings in self._module.bindings.values():
            for binding in bindings:
                if binding.kind is not BindingKind.IMPORT or "." not in binding.target:
                    whole += any(
                        self._imports_whole(binding, self._analysis.syntax.slice(name))
                        and is_interface_module(self._analysis.syntax.slice(name))
                        for name in binding.node.children_by_field_name("name")
                    )
                elif is_interface_module(binding.target):
                    named += binding.target.count(".") > 1
        root = self._module.bindings.get(module.partition(".")[0], [])
        is_free = all(b.target == module.partition(".")[0] for b in root)
        return whole > 0 and named == 0 and is_free

    def splices(self) -> list[Splice]:
        """Return what adds the new imports to the file."""
        splices = []
        for (home, module), every in sorted(self._new.items()):
            names = sorted(every, key=lambda symbol: member_key(symbol[0]))
            statement = self._extendable(home, module)
            if self._has_line_each(home):
                lines = [f"from {module} import {item}" for item in map(_import_item, names)]
                splices += [self._line(home, module, line) for line in lines]
            elif statement is not None:
                splices += [self._extend(statement, name, bound) for name, bound in names]
            else:
                listed = ", ".join(map(_import_item, names))
                splices.append(self._line(home, module, f"from {module} import {listed}"))
        for home, module in dict.fromkeys(self._new_modules):
            splices.append(self._line(home, module, f"import {module}"))
        return splices

    def _home(self) -> int:
        """Return which block has the imports of ROS that the place sees, by its number.

        That is the module, unless it does so under a `try`, or a function around the place does.
        """
        root = self._analysis.syntax.root
        blocks = [root]
        for child in root.named_children:
            body = child.child_by_field_name("body")
            if child.type == "try_statement" and body is not None:
                blocks.append(body)
        for scope in reversed(list(self._functions())):
            body = scope.node.child_by_field_name("body")
            if scope is not self._method and body is not None:
                blocks.append(body)
        home = next((block for block in blocks if self._has_ros(block)), root)
        self._homes[home.id] = home
        return home.id

    def _has_ros(self, block: Node) -> bool:
        return any(
            is_interface_module(module) or is_library(module)
            for statement in imports_in(block)
            if block.type == "module" or statement.end_byte <= self._offset
            for module in [module_of(self._analysis, statement)]
        )

    def _extendable(self, home: int, module: str) -> Node | None:
        for statement in reversed(imports_in(self._homes[home])):
            is_named = bool(statement.children_by_field_name("name"))
            is_alike = statement.type == "import_from_statement" and is_named
            if (
                is_alike
                and module_of(self._analysis, statement) == module
                and not statement.has_error
            ):
                return statement
        return None

    def _has_line_each(self, home: int) -> bool:
        """Whether every name has an import of its own, as isort's `force_single_line` wants it."""
        count = Counter(
            module_of(self._analysis, statement)
            for statement in imports_in(self._homes[home])
            if len(statement.children_by_field_name("name")) == 1
            and statement.type == "import_from_statement"
        )
        return any(number > 1 for number in count.values())

    def _extend(self, statement: Node, name: str, bound: str) -> Splice:
        """Import a name too: behind those that it sorts behind, or all where they do not sort."""
        names = statement.children_by_field_name("name")
        item = _import_item((name, bound))
        text = self._analysis.syntax.text
        keys = [member_key(self._analysis.syntax.slice(each)) for each in names]
        is_sorted = keys == sorted(keys)
        place = sum(key < member_key(item) for key in keys) if is_sorted else len(names)
        last = names[max(place - 1, 0)]
        start = line_start(text, last.start_byte)
        before = text[start : last.start_byte]
        is_listed = b"(" in text[statement.start_byte : last.start_byte]
        is_each_apart = len({each.start_point.row for each in names}) == len(names) > 1
        gap = " "
        if is_listed and (is_each_apart or not before.strip()):
            margin = re.sub(rb"\S", b" ", before).decode("ascii", "replace")
            gap = self._conventions.newline + margin
        encode = self._analysis.syntax.encode
        if not place:
            return Splice(last.start_byte, last.start_byte, encode(f"{item},{gap}"))
        return Splice(last.end_byte, last.end_byte, encode(f",{gap}{item}"))

    def _line(self, home: int, module: str, line: str) -> Splice:
        """Place a new import: in the group of its like, or at the top of the file."""
        imports = imports_in(self._homes[home])
        newline = self._conventions.newline
        if imports:
            line = leading_space(self._analysis, imports[-1]) + line
            return place_import(self._analysis, imports, module, line, newline)
        at = self._after_docstring()
        return Splice(at, at, self._analysis.syntax.encode(line + newline))

    def _after_docstring(self) -> int:
        text = self._analysis.syntax.text
        for child in self._analysis.syntax.root.named_children:
            if child.type in ("comment", "future_import_statement"):
                continue
            is_string = (
                child.type == "expression_statement"
                and child.named_child_count == 1
                and child.named_children[0].type == "string"
            )
            return (
                line_end(text, child.end_byte) if is_string else line_start(text, child.start_byte)
            )
        return len(text)


def _is_for_types_only(node: Node) -> bool:
    """Whether a statement is under `if TYPE_CHECKING`, and brings in nothing when it runs."""
    parent = node.parent
    while parent is not None and parent.type != "if_statement":
        parent = parent.parent
    condition = parent.child_by_field_name("condition") if parent is not None else None
    return condition is not None and (condition.text or b"").endswith(b"TYPE_CHECKING")


def _import_item(symbol: tuple[str, str]) -> str:
    name, bound = symbol
    return name if name == bound else f"{name} as {bound}"
