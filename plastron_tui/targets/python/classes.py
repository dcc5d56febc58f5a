"""Which classes of a file derive from which, and what their attributes are bound to."""

from __future__ import annotations

from .scopes import Binding, BindingKind, Scope, ScopeTree
from .syntax import Syntax

_MOST_BASES = 64


class Classes:
    """The classes of one file."""

    def __init__(self, syntax: Syntax, scopes: ScopeTree) -> None:
        self._syntax = syntax
        self._scopes = scopes
        self._derived: dict[Scope, list[Scope]] | None = None
        self._bases: dict[Scope, list[Scope]] = {}

    def bases(self, owner: Scope) -> list[Scope]:
        """Return the classes of the file that a class derives from."""
        if owner in self._bases:
            return self._bases[owner]
        found = self._bases[owner] = []
        pending = [owner]
        while pending and len(found) < _MOST_BASES:
            current = pending.pop()
            for base in current.bases:
                if base.type == "identifier" and current.parent is not None:
                    local = current.parent.lookup(self._syntax.slice(base))
                    for binding in local[1] if local is not None else []:
                        if binding.owner is None or binding.kind is not BindingKind.CLASS:
                            continue
                        if binding.owner not in found:
                            found.append(binding.owner)
                            pending.append(binding.owner)
        return found

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
        """Collect the bindings of an attribute, those of base and derived classes included."""
        own = owner.attributes.get(name, []) + owner.bindings.get(name, [])
        bases = [base for base in self.bases(owner) if base is not owner]
        if not own:
            for base in bases:
                own = own + base.attributes.get(name, []) + base.bindings.get(name, [])
        for other in self.derived(owner):
            own = own + other.attributes.get(name, []) + other.bindings.get(name, [])
        return own
