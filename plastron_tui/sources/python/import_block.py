"""The imports of a generated Python file, sorted as `ruff check --select I` wants them."""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Collection, Iterable, Iterator, Mapping

from .layout import LINE_LENGTH
from .naming import Scope, capitals

_Key = tuple[object, ...]

Symbol = tuple[str, str]
"""A module, and a name that is imported from it."""


class Imports:
    """The names that a file uses, by the modules that they come from."""

    def __init__(self, aliases: Mapping[Symbol, str] | None = None) -> None:
        self._aliases = aliases or {}
        self._used: dict[Symbol, str] = {}

    def use(self, module: str, name: str) -> str:
        """Import a name, and return what the file calls it."""
        symbol = (module, name)
        return self._used.setdefault(symbol, self._aliases.get(symbol, name))

    def names(self) -> set[str]:
        """Return the names that the file has from its imports."""
        return set(self._used.values())

    def clashes(self, reserved: Collection[str], own: Collection[Symbol]) -> dict[Symbol, str]:
        """Return an alias for every name that two modules share, or that is reserved.

        `std_msgs.msg.Empty` beside `std_srvs.srv.Empty` becomes `StdMsgsEmpty`. What the template
        imports itself keeps its name.
        """
        modules: dict[str, list[Symbol]] = defaultdict(list)
        for symbol, name in self._used.items():
            modules[name].append(symbol)
        clashing = [
            symbol
            for name, symbols in modules.items()
            if len(symbols) > 1 or name in reserved
            for symbol in symbols
            if symbol not in own
        ]
        scope = Scope({*reserved, *modules})
        return {
            (module, name): scope.new(capitals(module.partition(".")[0]) + name)
            for module, name in clashing
        }

    def render(
        self, standard: Iterable[str], plain: Iterable[str], symbols: Iterable[Symbol]
    ) -> str:
        """Write the import lines.

        Args:
            standard: modules of Python itself, imported whole.
            plain: modules of ROS, imported whole.
            symbols: names that the template needs besides those in use.
        """
        found: dict[str, dict[str, str]] = defaultdict(dict)
        for module, name in symbols:
            found[module][name] = name
        for (module, name), used in self._used.items():
            found[module][name] = used
        lines = [f"import {module}" for module in sorted(standard)]
        lines += [""] if lines else []
        lines += [f"import {module}" for module in sorted(plain)]
        for module in sorted(found, key=_natural):
            lines += _from(module, found[module])
        return "\n".join(lines)


def _from(module: str, names: Mapping[str, str]) -> Iterator[str]:
    """Write the imports from one module; an alias has a statement of its own."""
    bare = sorted((name for name, used in names.items() if name == used), key=member_key)
    statements = [
        (member_key(name), [f"{name} as {names[name]}"]) for name in names if name not in bare
    ]
    if bare:
        statements.append((member_key(bare[0]), bare))
    for _, members in sorted(statements):
        line = f"from {module} import {', '.join(members)}"
        if len(line) <= LINE_LENGTH:
            yield line
        else:
            yield from (f"from {module} import (", *(f"    {each}," for each in members), ")")


def member_key(name: str) -> _Key:
    """Sort constants before classes before the rest, as isort's `order-by-type` does."""
    is_constant = len(name) > 1 and name.isupper()
    rank = 0 if is_constant else 1 if name[:1].isupper() else 2
    return (rank, *_natural(name))


def _natural(name: str) -> tuple[object, ...]:
    """Sort names without regard to case, numbers in them by value."""
    return (_digits_apart(name.lower()), _digits_apart(name))


def _digits_apart(text: str) -> list[tuple[int, int, str]]:
    parts = re.findall(r"\d+|\D", text)
    return [(0, int(part), part) if part.isdigit() else (1, 0, part) for part in parts]
