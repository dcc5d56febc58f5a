"""Targets of other distributions, by the entry points that they register.

Listing entry points reads the metadata of every installed distribution, so that it is done once,
and only where a name is not Plastron's own, or where names are listed.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from functools import cache, lru_cache
from importlib.metadata import EntryPoint, entry_points
from pathlib import Path
from typing import ClassVar, TypeVar, cast

from plastron_tui.diagnostics import Diagnostic
from plastron_tui.model.source import Change, SourceFile
from plastron_tui.model.workspace import Node
from plastron_tui.ros.catalog import Catalog

from .base import ReadResult, Rendered, Target

GROUP = "plastron.targets"
"""The entry point group of targets: a name, and a `Target` class that takes a template folder."""

_T = TypeVar("_T")

Factory = Callable[[Path | None], Target]
"""The class of a target, which is made with a folder of the user's templates, or None."""


@cache
def registered() -> Mapping[str, EntryPoint]:
    """Return the entry points by name; of two with one name the first that is installed counts."""
    found: dict[str, EntryPoint] = {}
    for entry in entry_points(group=GROUP):
        found.setdefault(entry.name, entry)
    return dict(sorted(found.items()))


@lru_cache(64)
def factory_of(name: str) -> Factory | None:
    """Load what makes the target of a name, None where nobody registered one."""
    entry = registered().get(name)
    if entry is None:
        return None
    try:
        factory = entry.load()
    # Code of another distribution may fail in any way as it is imported.
    except (Exception, SystemExit) as error:
        return _unusable(name, _told(error))
    if not isinstance(factory, type) or not issubclass(factory, Target):
        return _unusable(name, f"`{entry.value}` is no class of a target")
    if getattr(factory, "name", None) != name:
        return _unusable(name, f"the `name` of `{entry.value}` is another")
    if getattr(factory, "ros_version", None) not in (1, 2):
        return _unusable(name, f"the `ros_version` of `{entry.value}` is neither 1 nor 2")
    return factory


def make_target(name: str, template_folder: Path | None) -> Target | None:
    """Return the target of a name, None where nobody registered one; it never raises."""
    factory = factory_of(name)
    if factory is None:
        return None
    try:
        target = factory(template_folder)
    except (Exception, SystemExit) as error:
        return _unusable(name, _told(error))(None)
    kept = ("name", "ros_version", "suffix", "is_executable")
    own = {each: getattr(target, each) for each in kept}
    guarded: Target = type("_Guarded", (_Guarded,), own)(target)
    return guarded


def ros_version_of(name: str) -> int | None:
    """Return the generation of ROS that a registered target is for, None where there is none.

    It loads the target. One that cannot be loaded counts as ROS 1, so that a program that names
    it is still checked; that it cannot be used is told where a node is generated for it.
    """
    factory = factory_of(name)
    return None if factory is None else cast("type[Target]", factory).ros_version


class _Guarded(Target):
    """Asks a target of another distribution: what it raises, or should not give, is told."""

    def __init__(self, target: Target) -> None:
        self._target = target

    def file_name(self, node: Node) -> str:
        name, _ = self._ask(lambda: self._target.file_name(node), str)
        return super().file_name(node) if name is None else name

    def render(self, node: Node, catalog: Catalog) -> Rendered:
        return self._rendered(lambda: self._target.render(node, catalog))

    def read(self, path: Path, text: bytes) -> ReadResult:
        result, problem = self._ask(lambda: self._target.read(path, text), ReadResult)
        return ReadResult(None, (problem,)) if result is None else result

    def edit(self, source: SourceFile, changes: Sequence[Change], catalog: Catalog) -> Rendered:
        return self._rendered(lambda: self._target.edit(source, changes, catalog))

    def port(self, node: Node, source: SourceFile, catalog: Catalog) -> Rendered:
        return self._rendered(lambda: self._target.port(node, source, catalog))

    def is_worse(self, text: bytes, *others: bytes) -> bool:
        # What cannot be judged is not trusted.
        result, _ = self._ask(lambda: self._target.is_worse(text, *others), bool)
        return result is not False

    def definitions(self, text: bytes, name: str) -> int:
        result, _ = self._ask(lambda: self._target.definitions(text, name), int)
        return super().definitions(text, name) if result is None else result

    def mentions(self, text: bytes, name: str) -> bool:
        result, _ = self._ask(lambda: self._target.mentions(text, name), bool)
        return super().mentions(text, name) if result is None else result

    def lines_of_code(self, text: bytes) -> Counter[bytes]:
        result, _ = self._ask(lambda: self._target.lines_of_code(text), Counter)
        return super().lines_of_code(text) if result is None else result

    def _rendered(self, asked: Callable[[], Rendered]) -> Rendered:
        result, problem = self._ask(asked, Rendered)
        if result is not None and not isinstance(result.text, bytes | None):
            result, problem = None, self._failed("the text that it gives is no bytes")
        return Rendered(None, (problem,)) if result is None else result

    def _ask(self, asked: Callable[[], _T], kind: type[_T]) -> tuple[_T | None, Diagnostic]:
        try:
            result = asked()
        except (Exception, SystemExit) as error:
            return None, self._failed(_told(error))
        problem = self._failed(f"it gives a {type(result).__name__}, and no {kind.__name__}")
        return (result if isinstance(result, kind) else None), problem

    def _failed(self, reason: str) -> Diagnostic:
        return Diagnostic("unsupported-target", f"the target `{self.name}` failed: {reason}")


class _Unusable(Target):
    """Stands for a target that cannot be loaded: all that is asked of it is a diagnostic."""

    ros_version: ClassVar[int] = 1
    reason: ClassVar[str]

    def __init__(self, template_folder: Path | None = None) -> None:
        del template_folder

    def _cannot(self, what: str) -> Diagnostic:
        del what  # the reason is the same for all
        return Diagnostic(
            "unsupported-target", f"the target `{self.name}` cannot be used: {self.reason}"
        )


def _unusable(name: str, reason: str) -> Factory:
    return type("_Unusable", (_Unusable,), {"name": name, "reason": reason})


def _told(error: BaseException) -> str:
    return f"{type(error).__name__}: {error}"
