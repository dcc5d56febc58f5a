"""What is asked of the files that a file imports from."""

from __future__ import annotations

from typing import TYPE_CHECKING, Protocol

if TYPE_CHECKING:
    from .constants import Folded


class ImportedNames(Protocol):
    """What the names stand for that a file imports from others of its package.

    A qualified name is one as the file sees it: `demo.topics.SCAN`, or `.topics.SCAN`.
    """

    def targets(self, name: str, depth: int) -> tuple[str, ...]:
        """Return the qualified names that a name stands for outside of the package, or itself."""

    def star_modules(self, modules: list[str]) -> list[str]:
        """Return modules that are imported whole, with those that they import whole in turn."""

    def constant(self, name: str, depth: int) -> Folded:
        """Return the constant that a name is, None where the package does not say it."""

    def bases(self, name: str) -> list[str]:
        """Return the qualified names outside of the package that a class of it derives from."""


def joined(module: str, name: str) -> str:
    """Return the qualified name of what a module has; `.` is the package that the file is in."""
    return f"{module}{name}" if module.endswith(".") else f"{module}.{name}"
