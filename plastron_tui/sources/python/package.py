"""The other files of the package, or the workspace, that a file is in, as far as it imports them.

They are read and never run: constants, classes, and what they import in turn. What leads out of
the workspace stays a name.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path
from typing import NamedTuple
from weakref import proxy

from tree_sitter import Node

from plastron_tui.regular_files import Stamp, read_regular, stamp_of
from plastron_tui.sources.work_limits import Effort, bounded

from .analysis import Analysis
from .calls import ClientLibrary
from .constants import MOST_BINDINGS, MOST_DEEP, Folded
from .imported_names import joined
from .module_files import Found, ModuleFiles
from .reading_cost import is_readable
from .scopes import Binding, BindingKind, Scope
from .sites import complete, outline
from .syntax import parse

MOST_MODULES = 32
"""The most files of a package that one file is read with."""

_LARGEST = 256 * 1024
_MOST_BYTES = 1024 * 1024


class Package:
    """The modules of a package, each read when a name first leads to it.

    Attributes:
        paths: the files that were looked into.
        main: the file that is read.
        effort: what is left of the steps for all of them.
        led: the names outside of the package that names of a file stand for, as far as known.
        constants: the constants that names of a file are, as far as known.
    """

    def __init__(self, main: Path, library: ClientLibrary, *, in_workspace: bool = False) -> None:
        """Begin with the file that is read; its own text is never taken from the disk.

        Args:
            main: the file.
            library: its client library.
            in_workspace: whether names lead to other packages of the workspace, too.
        """
        self.main = os.path.realpath(main)
        self._library = library
        self._files = ModuleFiles(self.main, in_workspace=in_workspace)
        self._texts: dict[str, bytes | None] = {}
        self._stamps: dict[str, Stamp | None] = {}
        self._modules: dict[str, Analysis | None] = {}
        self.effort = Effort(_MOST_BYTES)
        self.led: dict[tuple[str, str], tuple[str, ...]] = {}
        self.constants: dict[tuple[str, str], Folded] = {}
        self._left = _MOST_BYTES
        self._complete: dict[str, Analysis] = {}

    @property
    def paths(self) -> tuple[Path, ...]:
        """The files that were looked into."""
        return tuple(map(Path, self._texts))

    @property
    def names(self) -> PackageNames:
        """What the names of the file itself stand for."""
        return PackageNames(self, self.main)

    @property
    def size(self) -> int:
        """How many bytes were read of other files."""
        return _MOST_BYTES - self._left

    def is_current(self) -> bool:
        """Tell whether each question to the disk would be answered now as it was."""
        return self._files.is_current() and all(
            stamp_of(Path(path)) == stamp for path, stamp in self._stamps.items()
        )

    def find(self, name: str, seen_from: str) -> Found | None:
        """Return the module that a qualified name leads to, None where it leads elsewhere.

        Args:
            name: the name.
            seen_from: the file that imports it.
        """
        return self._files.find(name, seen_from)

    def text(self, path: str) -> bytes | None:
        """Return what a module holds, None where it is not read."""
        if path not in self._texts:
            if len(self._texts) == MOST_MODULES:
                return None
            self._texts[path] = None
            # Before it is read: what is written meanwhile counts as written later.
            self._stamps[path] = stamp_of(Path(path))
            with suppress(OSError, ValueError):
                self._texts[path] = read_regular(path, min(_LARGEST, self._left))
            self._left -= len(self._texts[path] or b"")
        return self._texts[path]

    def defines(self, path: str, name: str) -> bool:
        """Whether a module has a function or a class of a name, which leads no further."""
        definition = rb"^(?:async +def|def|class)[ \t]+%s\b" % re.escape(name.encode())
        return re.search(definition, self.text(path) or b"", re.MULTILINE) is not None

    def module(self, path: str) -> Analysis | None:
        """Return what the names of a module stand for, None where it is not read."""
        if path not in self._modules:
            text = self.text(path)
            syntax = parse(text) if text is not None and is_readable(text) else None
            # Held by no module: each would hold the other.
            names = PackageNames(proxy(self), path)
            known = outline(syntax, self._library, names) if syntax is not None else None
            self._modules[path] = known
        return self._modules[path]

    def complete(self, path: str, module: Analysis) -> Analysis:
        """Return what is known of a module, its call sites among it."""
        if path not in self._complete:
            self._complete[path] = complete(module)
        return self._complete[path]


class _Led(NamedTuple):
    """The file that a name leads to.

    Attributes:
        module: the file.
        names: the names in it that lead on: the first is one of the module's own.
        outer: what the names of the file itself stand for.
    """

    module: Analysis
    names: tuple[str, ...]
    outer: PackageNames

    @property
    def bindings(self) -> list[Binding] | None:
        """What binds the first name in the file, None where the file does not."""
        return self.module.scopes.module.bindings.get(self.names[0])

    def starred(self) -> Iterator[str]:
        """Yield what the names may stand for of each module that the file imports whole."""
        for star in self.module.scopes.module.star_imports:
            yield ".".join((joined(star, self.names[0]), *self.names[1:]))

    def behind(self, target: str) -> str:
        """Return what the names stand for where the first one stands for another name."""
        return ".".join((target, *self.names[1:]))


class PackageNames:
    """What the names stand for that one file of a package imports from the others."""

    def __init__(self, package: Package, path: str) -> None:
        """Set the package, and the file that imports."""
        self._package = package
        self.path = path
        self.effort = package.effort

    @property
    def is_beside(self) -> bool:
        """Whether the file is one of the others itself."""
        return self.path != self._package.main

    @property
    def paths(self) -> tuple[Path, ...]:
        """The files of the package that were looked into."""
        return self._package.paths

    @property
    def size(self) -> int:
        """How many bytes were read of other files."""
        return self._package.size

    def is_current(self, other: PackageNames) -> bool:
        """Tell whether others that ask now would be answered by the disk as these were."""
        return other._package is self._package or self._package.is_current()

    def complete(self, module: Analysis) -> Analysis:
        """Return what is known of another file, its call sites among it."""
        return (
            module
            if module.package is None
            else self._package.complete(module.package.path, module)
        )

    def relative(self, other: PackageNames) -> str:
        """Return the path of another file of the package from the folder of this one."""
        return os.path.relpath(other.path, os.path.dirname(self.path))  # noqa: PTH120

    def targets(self, name: str, depth: int = 0) -> tuple[str, ...]:
        """Return the qualified names that a name stands for outside of the package, or itself."""
        key = name, self.path
        if key not in self._package.led:
            self._package.led[key] = self._targets(name, depth)
        return self._package.led[key]

    @bounded(())
    def _targets(self, name: str, depth: int) -> tuple[str, ...]:
        found = self._package.find(name, self.path)
        if found is None or not found.names or self._package.defines(found.path, found.names[0]):
            return (name,)
        led = self._lead(name, depth)
        if led is None:
            return (name,)
        names = list(led.starred()) if led.bindings is None else []
        for binding in (led.bindings or [])[:MOST_BINDINGS]:
            targets = led.module.resolver.targets(binding, led.names[0], depth + 1)
            names += map(led.behind, targets)
        found_as = dict.fromkeys(
            out for each in names for out in led.outer.targets(each, depth + 1)
        )
        # What stays in the package is told apart by the name that leads there.
        return tuple(each for each in found_as if led.outer.leads_out(each)) or (name,)

    def _lead(self, name: str, depth: int) -> _Led | None:
        """Return the file that a name of one of its own leads to, None for any other name."""
        found = self._package.find(name, self.path) if depth <= MOST_DEEP else None
        module = self._package.module(found.path) if found is not None and found.names else None
        if found is None or module is None or module.package is None:
            return None
        return _Led(module, found.names, module.package)

    def star_modules(self, modules: list[str]) -> list[str]:
        """Return modules that are imported whole, with those that they import whole in turn."""
        led = dict.fromkeys(modules)
        pending = [(self, name) for name in modules]
        seen: set[str] = set()
        while pending:
            names, name = pending.pop(0)
            found = self._package.find(name, names.path)
            module = self._package.module(found.path) if found is not None else None
            if found is None:
                led[name] = None
            elif module is not None and not found.names and found.path not in seen:
                seen.add(found.path)
                outer = PackageNames(self._package, found.path)
                pending += [(outer, star) for star in module.scopes.module.star_imports]
        return list(led)

    def leads_out(self, name: str) -> bool:
        """Whether a name is of no module of the package."""
        return self._package.find(name, self.path) is None and not name.startswith(".")

    def constant(self, name: str, depth: int = 0) -> Folded:
        """Return the constant that a name is, None where the package does not say it.

        What only the default of a parameter says is none: another file may give another value.
        """
        key = name, self.path
        if key not in self._package.constants:
            self._package.constants[key] = self._constant(name, depth)
        return self._package.constants[key]

    @bounded(None)
    def _constant(self, name: str, depth: int) -> Folded:
        led = self._lead(name, depth)
        if led is None:
            return None
        bindings = led.bindings
        if bindings is None:
            values = {led.outer.constant(each, depth + 1) for each in led.starred()} - {None}
            return values.pop() if len(values) == 1 else None
        if len(bindings) == 1 and bindings[0].kind is BindingKind.IMPORT:
            return led.outer.constant(led.behind(bindings[0].target), depth + 1)
        for part in led.names[1:]:
            bindings = _members(led.module, bindings, part)
        return _folded(led.module, bindings, led.names[-1], depth + 1)

    @bounded(None)
    def bound(self, name: str, depth: int = 0) -> tuple[Analysis, list[Binding]] | None:
        """Return what binds a name of another file of the package, and that file."""
        led = self._lead(name, depth)
        if led is None:
            return None
        bindings = led.bindings
        if bindings is None:
            starred = (led.outer.bound(each, depth + 1) for each in led.starred())
            return next((each for each in starred if each is not None), None)
        if len(bindings) == 1 and bindings[0].kind is BindingKind.IMPORT:
            return led.outer.bound(led.behind(bindings[0].target), depth + 1)
        for part in led.names[1:]:
            bindings = _members(led.module, bindings, part)
        return (led.module, bindings) if bindings else None

    def bases(self, name: str) -> list[str]:
        """Return the qualified names outside of the package that a class of it derives from."""
        held = self.class_(name)
        names = held[0].package if held is not None else None
        if held is None or names is None:
            return []
        return [each for each in held[0].resolver.foreign_bases(held[1]) if names.leads_out(each)]

    @bounded(None)
    def class_(self, name: str, depth: int = 0) -> tuple[Analysis, Scope] | None:
        """Return the class of the package that a name stands for, and the file that has it."""
        led = self._lead(name, depth)
        if led is None or len(led.names) != 1:
            return None
        if led.bindings is None:
            held = (led.outer.class_(star, depth + 1) for star in led.starred())
            return next((each for each in held if each is not None), None)
        if len(led.bindings) != 1:
            return None
        (binding,) = led.bindings
        if binding.kind is BindingKind.IMPORT:
            return led.outer.class_(binding.target, depth + 1)
        is_class = binding.kind is BindingKind.CLASS
        return (led.module, binding.owner) if is_class and binding.owner is not None else None


def _members(module: Analysis, bindings: list[Binding], name: str) -> list[Binding]:
    """Return what an attribute of a class or an object of a module is bound to."""
    if len(bindings) != 1:
        return []
    owner = bindings[0].owner if bindings[0].kind is BindingKind.CLASS else None
    if owner is None and bindings[0].value is not None:
        made = module.resolver.instance(bindings[0].value, bindings[0].scope)
        owner = made.scope if made is not None else None
    return [] if owner is None else module.resolver.classes.attribute(owner, name)


def _folded(module: Analysis, bindings: list[Binding], name: str, depth: int) -> Folded:
    """Fold what a module binds a name to, where no parameter has a part in it."""
    resolver = module.resolver
    folded, trace = resolver.traced(lambda: resolver.fold_all(bindings, name, depth))
    reads = (each for each in trace if each.type == "identifier")
    return None if any(_is_parameter(module, read) for read in reads) else folded


def _is_parameter(module: Analysis, read: Node) -> bool:
    found = module.scopes.at(read.start_byte).lookup(module.syntax.slice(read))
    bindings = [] if found is None else found[1][:MOST_BINDINGS]
    return any(binding.kind is BindingKind.PARAMETER for binding in bindings)
