"""Which classes of a file derive from which, and what their attributes are bound to."""

from __future__ import annotations

from collections.abc import Iterator

from .constants import MOST_BINDINGS
from .scopes import MOST_BASES, Binding, BindingKind, Scope, ScopeTree
from .syntax import Syntax


class Classes:
    """The classes of one file."""

    def __init__(self, syntax: Syntax, scopes: ScopeTree) -> None:
        self._syntax = syntax
        self._scopes = scopes
        self._derived: dict[Scope, list[Scope]] | None = None
        self._bases: dict[Scope, list[Scope]] = {}
        self._direct: dict[Scope, list[Scope]] = {}
        self._attributes: dict[tuple[Scope, str], list[Binding]] = {}

    def bases(self, owner: Scope) -> list[Scope]:
        """Return the classes of the file that a class derives from."""
        if owner not in self._bases:
            found: dict[Scope, None] = {}
            pending = [owner]
            while pending and len(found) < MOST_BASES:
                for base in self._direct_bases(pending.pop()):
                    if base not in found:
                        found[base] = None
                        pending.append(base)
            self._bases[owner] = list(found)
        return self._bases[owner]

    def _direct_bases(self, owner: Scope) -> list[Scope]:
        if owner not in self._direct:
            names = [self._syntax.slice(base) for base in owner.bases if base.type == "identifier"]
            found: dict[Scope, None] = {}
            for name in dict.fromkeys(names):
                local = owner.parent.lookup(name) if owner.parent is not None else None
                for binding in local[1][:MOST_BINDINGS] if local is not None else []:
                    if binding.owner is not None and binding.kind is BindingKind.CLASS:
                        found[binding.owner] = None
            self._direct[owner] = list(found)[:MOST_BASES]
        return self._direct[owner]

    def derived(self, owner: Scope) -> list[Scope]:
        """Return the other classes of the file that derive from a class."""
        if self._derived is None:
            self._derived = {}
            for other in self._scopes.classes():
                for base in self.bases(other):
                    if base is not other:
                        self._derived.setdefault(base, []).append(other)
        return self._derived.get(owner, [])

    def attribute(self, owner: Scope, name: str) -> list[Binding]:
        """Collect the bindings of an attribute, those of base and derived classes included.

        Where they are more than anybody looks through, nothing is said of them: as for an
        attribute that another file binds.
        """
        key = owner, name
        if key not in self._attributes:
            self._attributes[key] = self._collect(owner, name)
        return self._attributes[key]

    def _collect(self, owner: Scope, name: str) -> list[Binding]:
        found: list[Binding] = []
        for holder in self._holders(owner, name):
            for bindings in (holder.attributes.get(name, ()), holder.bindings.get(name, ())):
                if len(found) + len(bindings) > MOST_BINDINGS:
                    return []
                found += bindings
        return found

    def _holders(self, owner: Scope, name: str) -> Iterator[Scope]:
        yield owner
        if name not in owner.attributes and name not in owner.bindings:
            yield from (base for base in self.bases(owner) if base is not owner)
        yield from self.derived(owner)
