"""Targets of other distributions, by the entry points that they register.

Listing entry points reads the metadata of every installed distribution, so that it is done once,
and only where a name is not Plastron's own, or where names are listed.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cache, lru_cache, wraps
from importlib.metadata import EntryPoint, entry_points
from inspect import isfunction
from pathlib import Path
from types import UnionType
from typing import Any, ClassVar, TypeVar, get_args, get_origin, get_type_hints

from plastron_tui.diagnostics import Diagnostic, codes
from plastron_tui.model.source import FileSet
from plastron_tui.sources.base import Language, ReadResult, Rendered

from .base import API_VERSION, Target

GROUP = "plastron.targets"
"""The entry point group of targets: a name, and a `Target` class that takes a template folder."""

_T = TypeVar("_T", Language, Target)

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
    problem = _problem(name, f"`{entry.value}`", factory)
    return factory if problem is None else _unusable(name, problem)


def _problem(name: str, value: str, factory: Any) -> str | None:
    """Say why something is no target, None where it is one."""
    if not isinstance(factory, type) or not issubclass(factory, Target):
        return f"{value} is no class of a target"
    if factory.api_version != API_VERSION:
        return (
            f"{value} is for version {factory.api_version} of the interface of targets, and this "
            f"Plastron has version {API_VERSION}"
        )
    if getattr(factory, "name", None) != name:
        return f"the `name` of {value} is another"
    if getattr(factory, "ros_version", None) not in (1, 2):
        return f"the `ros_version` of {value} is neither 1 nor 2"
    language = getattr(factory, "language", None)
    if not isinstance(language, Language):
        return f"the `language` of {value} is none"
    suffixes = getattr(language, "suffixes", None)
    are_suffixes = isinstance(suffixes, tuple) and all(
        isinstance(each, str) and each.startswith(".") for each in suffixes
    )
    if not suffixes or not are_suffixes or not isinstance(getattr(language, "title", None), str):
        return f"the `language` of {value} has no `title`, or no tuple of `suffixes`"
    return None


def make_target(name: str, template_folder: Path | None) -> Target | None:
    """Return the target of a name, None where nobody registered one; it never raises."""
    factory = factory_of(name)
    if factory is None:
        return None
    try:
        target = factory(template_folder)
    except (Exception, SystemExit) as error:
        return _unusable(name, _told(error))(None)
    if isinstance(target, _Unusable):
        return target
    guarded = _guarded(Target, target, name)
    type(guarded).language = _guarded(Language, target.language, name)
    return guarded


def _guarded(base: type[_T], inner: _T, name: str) -> _T:
    """Return what asks another distribution's object: what it raises, or should not give, is told.

    Args:
        base: the class that says what may be asked, and what each answer is.
        inner: the object.
        name: the target that it belongs to.
    """
    own: dict[str, Any] = {
        attribute: getattr(inner, attribute) for attribute in get_type_hints(base) if attribute
    }
    for attribute, method in vars(base).items():
        if isfunction(method) and not attribute.startswith("_"):
            own[attribute] = _asking(method, inner, name)
    guarded: _T = type(f"Guarded{base.__name__}", (base,), own)()
    return guarded


def _asking(method: Callable[..., Any], inner: object, name: str) -> Callable[..., Any]:
    """Return a method that asks an object, and answers for it where the object fails."""
    hint = get_type_hints(method)["return"]
    # `tuple[str, ...] | None` is a tuple or None.
    hints = get_args(hint) if get_origin(hint) is UnionType else (hint,)
    kinds = tuple(get_origin(each) or each for each in hints)

    @wraps(method)
    def ask(self: object, *args: Any, **options: Any) -> Any:
        try:
            result = getattr(inner, method.__name__)(*args, **options)
        except (Exception, SystemExit) as error:
            problem = _told(error)
        else:
            problem = _unfit(result, kinds)
            if not problem:
                return result
        if kinds[0] in (Rendered, ReadResult):
            message = f"the target `{name}` failed: {problem}"
            return kinds[0](None, (Diagnostic(codes.UNSUPPORTED_TARGET, message),))
        missing = object()
        answer = getattr(method, "if_it_fails", missing)
        return method(self, *args, **options) if answer is missing else answer

    return ask


def _unfit(result: object, kinds: tuple[type, ...]) -> str:
    """Say why an answer is not what was asked for, "" where it is."""
    if not isinstance(result, kinds):
        expected = kinds[0].__name__
        return f"it gives a {type(result).__name__}, and no {expected}"
    files = result.files if isinstance(result, Rendered) else None
    return "" if files is None else _unfit_files(files)


def _unfit_files(files: Any) -> str:
    """Say why a set of files cannot be used, "" where it can."""
    if not isinstance(files, FileSet) or not files.texts:
        return f"it gives a {type(files).__name__}, and no set of files"
    if not all(isinstance(name, str) and isinstance(text, bytes) for name, text in files.texts):
        return "the text that it gives is no bytes"
    return ""


class _NoLanguage(Language):
    """The language of a target that cannot be used: no file is of it."""

    name: ClassVar[str] = ""
    title: ClassVar[str] = "unknown"
    suffixes: ClassVar[tuple[str, ...]] = ()
    suffix = ""


class _Unusable(Target):
    """Stands for a target that cannot be loaded: all that is asked of it is a diagnostic.

    It counts as ROS 1, so that a program that names it is still checked.
    """

    ros_version: ClassVar[int] = 1
    language: ClassVar[Language] = _NoLanguage()
    reason: ClassVar[str]

    def __init__(self, template_folder: Path | None = None) -> None:
        del template_folder

    def _cannot(self, what: str) -> Diagnostic:
        del what  # the reason is the same for all
        return Diagnostic(
            codes.UNSUPPORTED_TARGET, f"the target `{self.name}` cannot be used: {self.reason}"
        )


def _unusable(name: str, reason: str) -> Factory:
    return type("_Unusable", (_Unusable,), {"name": name, "reason": reason})


def _told(error: BaseException) -> str:
    return f"{type(error).__name__}: {error}"
