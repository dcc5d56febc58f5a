"""The files of a package that exists, as a program changes it.

A package is changed from what its files hold when the program runs, each time anew: what is there
already is not added again, and what is not there is not taken out. So no layers are remembered.
"""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from plastron_tui.diagnostics import Diagnostic, Span, codes
from plastron_tui.diagnostics.severity import Severity
from plastron_tui.model.workspace import Node
from plastron_tui.output.plan import OutputFile
from plastron_tui.ros.interfaces import InterfaceKind
from plastron_tui.ros.package_keys import key_of_module
from plastron_tui.sources import find_language
from plastron_tui.sources.packages import Changed, add_node, remove_executable
from plastron_tui.targets.packages.dependencies import dependencies_of
from plastron_tui.targets.packages.spec import BuildType, PackagedNode, PackageSpec

if TYPE_CHECKING:
    from plastron_tui.model.package_source import PackageSource
    from plastron_tui.model.packages import Contained, Package

    from .apply_changes import Library
    from .generation import Generated


class LoadedFiles(NamedTuple):
    """The files that a program changes in a loaded package, or none with the reason.

    Attributes:
        files: those that are written; empty where something is refused.
        nodes: the names of node files that `files` has in place of the nodes' own.
        diagnostics: what there is to say.
    """

    files: tuple[OutputFile, ...]
    nodes: frozenset[str] = frozenset()
    diagnostics: tuple[Diagnostic, ...] = ()


def loaded_package_files(
    package: Package,
    made: Sequence[Generated],
    libraries: Mapping[str, Library],
    output: Path,
    *,
    in_place: bool,
) -> LoadedFiles:
    """Change a loaded package; nothing of it is written where a part is refused.

    Args:
        package: the package, which was loaded.
        made: the files of the nodes that the program generates.
        libraries: the client libraries, by name.
        output: the output folder, which gets the changed and the new files.
        in_place: whether they are written where the package is instead.
    """
    source = package.source
    assert source is not None, "the package was loaded"
    work = _Change(package, source, libraries, output, in_place, dict(source.texts))
    work.take_out()
    by_variable = {each.generation.node.variable: each for each in made}
    for variable, contained in package.contents.items():
        generated = by_variable.get(variable)
        if isinstance(contained.item, Node) and generated is not None:
            work.put(contained, generated)
    if any(each.severity is Severity.ERROR for each in work.found):
        return LoadedFiles((), frozenset(), tuple(work.found))
    return LoadedFiles((*work.files(), *work.written), frozenset(work.moved), tuple(work.found))


@dataclass
class _Change:
    package: Package
    source: PackageSource
    libraries: Mapping[str, Library]
    output: Path
    in_place: bool
    texts: dict[str, bytes]
    found: list[Diagnostic] = field(default_factory=list)
    written: list[OutputFile] = field(default_factory=list)
    moved: list[str] = field(default_factory=list)

    def take_out(self) -> None:
        """Take out what the program takes out of the package."""
        for name, span in self.package.removed.items():
            file = self.source.executables[name].file
            changed = remove_executable(self.source, self.texts, name, self._needs)
            if not self._take(changed, span) or file is None:
                continue
            is_back = any(each.name == name for each in self.package.contents.values())
            if file in self.source.texts and not is_back:
                message = f"`{file}` of `{self.source.name}` stays where it is"
                help_ = "remove it by hand if nothing else needs it"
                self.found.append(Diagnostic(codes.FILE_STAYS, message, span, help=help_))

    def _needs(self, text: bytes) -> Mapping[str, Sequence[str]]:
        """Return what a Python text needs to run, by key, each with its modules."""
        version = self.source.ros_version
        known: frozenset[str] = frozenset()
        for library in self.libraries.values():
            if library.target.ros_version == version:
                known = _packages(library)
        found: dict[str, list[str]] = {}
        for module in sorted(find_language("python").imports(text)):
            key = key_of_module(module, version, known)
            if key is not None and module.partition(".")[0] != self.source.name:
                found.setdefault(key, []).append(module.partition(".")[0])
        return found

    def put(self, contained: Contained, generated: Generated) -> None:
        """Put a node into the package."""
        if generated.files is None or generated.files.files.main is None:
            return
        file = generated.files.name.removeprefix(f"{self.source.name}/")
        text = generated.files.files.main
        known = self.source.texts.get(file)
        if known is not None and known != text and not self._is_in_place(file):
            message = f"the package `{self.source.name}` has a file `{file}` already"
            help_ = "name the node otherwise: `contains … as 'other_name'`, or write over the "
            help_ += "package with `--in-place` where an earlier run made the file"
            self.found.append(
                Diagnostic(codes.ALREADY_CONTAINED, message, contained.span, help=help_)
            )
            return
        library = self.libraries[generated.generation.library]
        name = file.rpartition("/")[2]
        node = PackagedNode(
            contained.name,
            name.removesuffix(library.target.language.suffix),
            text,
            generated.generation.node,
            library.target.language,
            library.target.name,
            contained.span,
        )
        keys, unknown = self._keys(node, library)
        self.found += unknown
        changed = add_node(self.source, self.texts, contained.name, file, keys)
        self._take(changed, contained.span)
        if self._is_in_place(file):
            for each in generated.files.output_files():
                self._move(each)

    def _keys(
        self, node: PackagedNode, library: Library
    ) -> tuple[list[str], tuple[Diagnostic, ...]]:
        """Return what a node needs to run, as a new package would say it."""
        spec = PackageSpec(
            self.source.name,
            self.source.ros_version,
            nodes=(node,),
            packages=_packages(library),
            build_type=BuildType.AMENT_PYTHON,
        )
        dependencies, unknown = dependencies_of(spec)
        return [each.key for each in dependencies if each.tag == "exec_depend"], unknown

    def _take(self, changed: Changed, span: Span) -> bool:
        self.found += [
            each if each.file is not None or each.span is not None else each._replace(span=span)
            for each in changed.diagnostics
        ]
        if changed.texts is not None:
            self.texts = changed.texts
        return changed.texts is not None

    def _is_in_place(self, file: str) -> bool:
        """Tell whether a file is written where the package is."""
        there = os.path.realpath(self.output / self.source.name / file)
        return self.in_place or there == os.path.realpath(self.source.folder / file)

    def _move(self, file: OutputFile) -> None:
        """Write a node's file where the package is."""
        inner = file.name.removeprefix(f"{self.source.name}/")
        path = self.source.folder / inner
        self.moved.append(file.name)
        self.written.append(
            replace(file, path=path, entry=file.name, merged_from=None, layers=None)
        )

    def files(self) -> list[OutputFile]:
        """Return the files that were there and are changed."""
        found = []
        for name, text in self.texts.items():
            before = self.source.texts[name]
            if text == before:
                continue
            is_over = self._is_in_place(name)
            found.append(
                OutputFile(
                    f"{self.source.name}/{name}",
                    text,
                    is_executable=False,
                    merged_from=before if is_over else None,
                    path=self.source.folder / name if is_over else None,
                )
            )
        return found


def _packages(library: Library) -> frozenset[str]:
    return frozenset(each for kind in InterfaceKind for each in library.catalog.packages(kind))
