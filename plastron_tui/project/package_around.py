"""The packages of nodes that have to be built: the one around them, or one of the program's own."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from functools import cached_property, partial
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from plastron_tui.diagnostics import Diagnostic, Severity
from plastron_tui.generating.own_package import Around, OwnPackages
from plastron_tui.model.package_source import LoadedPackage, PackageSource
from plastron_tui.model.workspace import Generation, Workspace
from plastron_tui.output.plan import OutputFile
from plastron_tui.sources.packages.reading import PACKAGE_XML
from plastron_tui.targets import LIBRARIES
from plastron_tui.targets.packages.spec import interfaces_name

from .configuration import Configuration
from .package_reader import PackageReader

if TYPE_CHECKING:
    from plastron_tui.boundary import Boundary
    from plastron_tui.generating.apply_changes import Library
    from plastron_tui.generating.generation import Generated
    from plastron_tui.output.manifest import Manifest
    from plastron_tui.targets.base import Target


class FoundPackage(NamedTuple):
    """A package that was found, and what reading it gave."""

    folder: Path
    read: LoadedPackage


def find_package_around(
    output: Path, boundary: Boundary, manifest: Manifest, ros_version: int, program: str = ""
) -> FoundPackage | None:
    """Return the package that an output folder is, or is in; None where there is none.

    Args:
        output: the output folder, which need not be there.
        boundary: the program's project; a package beyond it is somebody else's.
        manifest: what is remembered of the output folder: a package that the program wrote there
            is none that was there before.
        ros_version: what a package counts for that is for both generations of ROS.
        program: the name of the program's file: its nodes join the package of another program.
    """
    output = Path.cwd() / output
    for folder in (output, *output.parents):
        if not boundary.allows(folder):
            return None
        if (folder / PACKAGE_XML).is_file():
            if folder == output and _is_own(manifest, program):
                return None
            read = PackageReader(folder, boundary, {})
            return FoundPackage(folder, read(str(folder), ros_version))
    return None


def _is_own(manifest: Manifest, program: str) -> bool:
    """Tell whether the package that an output folder is may be one that the program wrote."""
    owner = manifest.bases.get(PACKAGE_XML, {}).get("program")
    is_others = isinstance(owner, str) and owner and program and owner != program
    return PACKAGE_XML in manifest and not is_others


class FilesAround(NamedTuple):
    """The files of a package around nodes, as they change, and what there is to say."""

    files: list[OutputFile]
    diagnostics: list[Diagnostic]


class BuiltPlaces:
    """Where the nodes of a program are that have to be built."""

    def __init__(
        self,
        configuration: Configuration,
        program: str,
        asked: Sequence[Generation],
        workspace: Workspace | None,
        library_of: Callable[[str], Library | None],
        manifest: Manifest,
    ) -> None:
        """Set what the places follow from.

        Args:
            configuration: what holds for the program.
            program: the name of its file.
            asked: all that it generates.
            workspace: what it built, None while it is interpreted.
            library_of: gives a client library by its name, None for one that nothing writes.
            manifest: what is remembered of the output folder.
        """
        self._configuration = configuration
        self._workspace = workspace
        self._library_of = library_of
        self._manifest = manifest
        self._program = program
        self._own = OwnPackages(
            program,
            asked,
            workspace,
            partial(_target_of, library_of),
            in_place=configuration.options.in_place,
            around=self._around,
            is_other=partial(self._is_other, frozenset(each.library for each in asked)),
        )

    def _is_other(self, libraries: frozenset[str], name: str) -> bool:
        """Tell whether the program has another package of a name, or ROS one of types."""
        workspace = self._workspace
        if workspace is not None:
            made = {each.package.name for each in workspace.written_packages}
            types = (x for each in workspace.types.values() for x in each.definitions.values())
            made |= {each.interface.name.package for each in types}
            if name in made or name in {interfaces_name(each) for each in made}:
                return True
        found = (self._library_of(each) for each in libraries)
        return any(each is not None and each.catalog.has_package(name) for each in found)

    def placed(self, generation: Generation) -> Generation:
        """Return what is asked for, with the package that the node has to be in."""
        return self._own.placed(generation)

    def all_placed(self, generations: Sequence[Generation]) -> tuple[Generation, ...]:
        """Return all that is asked for, each with the package that the node has to be in."""
        if not self._own.are_any:
            return tuple(generations)
        return tuple([self._own.placed(each) for each in generations])

    def files_around(self, made: Sequence[Generated]) -> FilesAround:
        """Return the files of the package around that change for the nodes in it."""
        homes = [(each.generation, each.generation.node.home) for each in made]
        inside = [each for each, home in homes if home is not None and home.above]
        if self._found is None or not inside:
            return FilesAround([], [])
        source = self._found.read.source
        if source is None:
            told = [each._replace(span=inside[0].span) for each in self._found.read.diagnostics]
            return FilesAround([], told)
        from plastron_tui.generating.package_around import package_files_around

        libraries = {name: found for name in LIBRARIES if (found := self._library_of(name))}
        output = self._configuration.output
        return FilesAround(*package_files_around(source, made, libraries, output))

    def files_needed(self, made: Sequence[Generated]) -> FilesAround:
        """Return what the packages of nodes that are changed in place come to need for them.

        What the program loads as a package is changed there, and is left out here.
        """
        from plastron_tui.generating.built_in_place import changed_in_place, needed_files
        from plastron_tui.output.manifest import Manifest

        libraries = {name: known for name in LIBRARIES if (known := self._library_of(name))}
        packages = () if self._workspace is None else self._workspace.written_packages
        sources = (each.package.source for each in packages)
        loaded = {os.path.realpath(x.folder) for x in sources if x is not None}
        found: list[Diagnostic] = []
        nodes: dict[Path, list[tuple[Generated, Path]]] = {}
        read: dict[Path, PackageSource] = {}
        boundary = self._configuration.boundary
        for each, path in changed_in_place(made, libraries, self._manifest):
            version = libraries[each.generation.library].target.ros_version
            # Whatever was written there before, the package is there.
            around = find_package_around(path.parent, boundary, Manifest(), version)
            if around is None or os.path.realpath(around.folder) in loaded:
                continue
            if around.read.source is None:
                # The node is right all the same, and its package is to be mended first.
                warning = Severity.WARNING
                found += (x._replace(severity=warning) for x in around.read.diagnostics)
                continue
            read[around.folder] = around.read.source
            nodes.setdefault(around.folder, []).append((each, path))
        files: list[OutputFile] = []
        for folder, source in read.items():
            output, manifest = self._configuration.output, self._manifest
            changed, notes = needed_files(source, nodes[folder], libraries, output, manifest)
            files += changed
            found += notes
        return FilesAround(files, found)

    def _around(self) -> Around | None:
        if self._found is None:
            return None
        folder, read = self._found
        above = os.path.relpath(folder, self._configuration.output)
        name = folder.name if read.source is None else read.source.name
        return Around(name, above.replace(os.sep, "/"))

    @cached_property
    def _found(self) -> FoundPackage | None:
        configuration = self._configuration
        output, boundary = configuration.output, configuration.boundary
        version = configuration.ros.ros_version
        return find_package_around(output, boundary, self._manifest, version, self._program)


def _target_of(library_of: Callable[[str], Library | None], name: str) -> Target | None:
    library = library_of(name)
    return None if library is None else library.target
