"""Type names, as a program writes them, looked up in a distribution."""

from __future__ import annotations

from typing import NamedTuple

from plastron_tui.diagnostics import Code, Label, codes
from plastron_tui.diagnostics.suggest import nearest
from plastron_tui.ros.catalog import Catalog
from plastron_tui.ros.interfaces import Interface, InterfaceKind, InterfaceName

_WORDS = {
    InterfaceKind.MESSAGE: "message type",
    InterfaceKind.SERVICE: "service type",
    InterfaceKind.ACTION: "action type",
}


def _one(kind: InterfaceKind) -> str:
    word = _WORDS[kind]
    return f"an {word}" if word.startswith("a") else f"a {word}"


_MOST_LISTED = 8


class TypeProblem(NamedTuple):
    """Why a type name means nothing, or too much.

    Attributes:
        code: the kind of mistake.
        message: what is wrong.
        help: the remedy, in words.
        right: the name to write, where that is known.
        labels: other places that matter.
    """

    code: Code
    message: str
    help: str | None
    right: str | None = None
    labels: tuple[Label, ...] = ()


class TypeResolver:
    """Looks up type names in one distribution, each only once."""

    def __init__(self, catalog: Catalog) -> None:
        self.catalog = catalog
        self._ros = f"ROS {catalog.ros_version} {catalog.distribution}"
        self._known: dict[tuple[str, InterfaceKind], Interface | TypeProblem] = {}

    def resolve(self, text: str, kind: InterfaceKind) -> Interface | TypeProblem:
        """Return the interface that `Point`, `pkg/Point` or `pkg/msg/Point` means."""
        key = (text, kind)
        found = self._known.get(key)
        if found is None:
            found = self._known[key] = self._resolve(text, kind)
        return found

    def _resolve(self, text: str, kind: InterfaceKind) -> Interface | TypeProblem:
        *prefix, name = text.split("/")
        if not prefix:
            return self._bare(name, kind)
        package, *folder = prefix
        if folder and folder[0] != kind.value:
            return TypeProblem(
                codes.UNKNOWN_TYPE,
                f"`{text}` is no {_WORDS[kind]}",
                f"{_one(kind)} is written {package}/{kind.value}/{name}",
                f"{package}/{kind.value}/{name}",
            )
        full = InterfaceName(package, name)
        found = self.catalog.find(full, kind)
        return found if found is not None else self._unknown(full, kind)

    def _bare(self, name: str, kind: InterfaceKind) -> Interface | TypeProblem:
        candidates = self.catalog.candidates(name, kind)
        if len(candidates) == 1:
            found = self.catalog.find(candidates[0], kind)
            return found if found is not None else self._unknown(candidates[0], kind)
        if candidates:
            listed = [str(candidate) for candidate in candidates[:_MOST_LISTED]]
            return TypeProblem(
                codes.AMBIGUOUS_TYPE,
                f"several packages have {_one(kind)} `{name}`",
                f"write one of {', '.join(listed)}",
            )
        return self._no_such(name, name, kind)

    def _unknown(self, full: InterfaceName, kind: InterfaceKind) -> TypeProblem:
        if full.package in self.catalog.packages(kind):
            return self._no_such(str(full), full.name, kind, full.package)
        guess = nearest(full.package, self.catalog.packages(kind))
        message = f"no package `{full.package}` with {_WORDS[kind]}s is known in {self._ros}"
        if guess is not None:
            right = f"{guess}/{full.name}"
            return TypeProblem(codes.UNKNOWN_TYPE, message, f"did you mean `{right}`?", right)
        return TypeProblem(
            codes.UNKNOWN_TYPE,
            message,
            "source the workspace that has it, or name its folder under `types` in plastron.yaml",
        )

    def _no_such(
        self, shown: str, name: str, kind: InterfaceKind, package: str | None = None
    ) -> TypeProblem:
        message = f"no {_WORDS[kind]} `{shown}` is known in {self._ros}"
        other = InterfaceKind.SERVICE if kind is InterfaceKind.MESSAGE else InterfaceKind.MESSAGE
        if package is None and self.catalog.candidates(name, other):
            return TypeProblem(
                codes.UNKNOWN_TYPE, message, f"`{name}` is {_one(other)}, not {_one(kind)}"
            )
        names = {
            full.name: full
            for full in self.catalog.names(kind)
            if package is None or full.package == package
        }
        if name in names:
            return TypeProblem(codes.UNKNOWN_TYPE, message, "its definition file has a mistake")
        guess = nearest(name, names)
        if guess is None:
            return TypeProblem(codes.UNKNOWN_TYPE, message, "`plastron types` lists what is known")
        text = guess if package is None else str(names[guess])
        return TypeProblem(codes.UNKNOWN_TYPE, message, f"did you mean `{text}`?", text)
