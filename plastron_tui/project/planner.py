"""The files that a program asks for: made, and compared with the disk."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import cached_property, partial
from pathlib import Path, PurePath
from typing import TYPE_CHECKING
from weakref import proxy

from plastron_tui.diagnostics import Diagnostic, Span, codes, either, has_errors
from plastron_tui.project.configuration import Configuration
from plastron_tui.targets import LIBRARIES

if TYPE_CHECKING:
    # To check a program takes no more of this than what nothing can write.
    from plastron_tui.generating.apply_changes import Library
    from plastron_tui.generating.destination import Writing
    from plastron_tui.generating.file_names import FileNames
    from plastron_tui.generating.generation import Generated
    from plastron_tui.generating.program_packages import ProgramPackages
    from plastron_tui.model.own_types import OwnInterfaces
    from plastron_tui.model.packages import Package
    from plastron_tui.model.source import FileSet
    from plastron_tui.model.workspace import Generation, Workspace
    from plastron_tui.output.manifest import Manifest, Reading
    from plastron_tui.output.patch_stack import Author
    from plastron_tui.output.plan import FilePlan, OutputFile

    from .package_around import BuiltPlaces


class Planner:
    """Makes the files of the nodes that a program generates."""

    def __init__(
        self,
        configuration: Configuration,
        author: Author,
        manifest: Callable[[Path], Reading],
        generations: Sequence[Generation] = (),
        own_types: Callable[[int], OwnInterfaces] = lambda _: {},
        workspace: Workspace | None = None,
    ) -> None:
        """Set what the files follow from.

        Args:
            configuration: what holds for the program.
            author: the program.
            manifest: reads a folder's manifest.
            generations: all that the program generates.
            own_types: gives the program's own interface types in a generation of ROS.
            workspace: what the program built, None while it is interpreted.
        """
        self._workspace = workspace
        self._own_types = own_types
        self._libraries: dict[str, Library | None] = {}
        self._configuration = configuration
        self._author = author
        self._manifest = manifest
        self._written = frozenset((each.node.name, each.library) for each in generations)
        self._asked = generations

    @cached_property
    def _places(self) -> BuiltPlaces:
        from .package_around import BuiltPlaces

        configuration, name = self._configuration, self._author.name
        known, _ = self._manifest(configuration.output)
        # Of two that hold each other, only the cycle collector would free any.
        of = partial(Planner._library, proxy(self))
        return BuiltPlaces(configuration, name, self._asked, self._workspace, of, known)

    @cached_property
    def placed(self) -> tuple[Generation, ...]:
        """All that is generated, each in the package that it has to be in."""
        return self._places.all_placed(self._asked)

    def generated(self) -> tuple[Generated, ...]:
        """Make the files of all that is generated.

        Of two `generate_node` of one variable the last counts; and a file that the program
        generates, loads and generates again is made as it is at the end.
        """
        from plastron_tui.generating.generation import Manifests, last_of_each

        manifests = Manifests(self._manifest)
        last = {(each.node.variable, each.library): each for each in self.placed}
        made = [self._generate(each, manifests, tuple(last.values())) for each in last.values()]
        kept = last_of_each(made, self._configuration.output)
        if manifests.problems and kept:
            found = (*manifests.problems, *kept[0].diagnostics)
            kept[0] = replace(kept[0], diagnostics=found)
        return tuple(kept)

    def generate(self, generation: Generation) -> Generated:
        """Make the file of one `generate_node`."""
        from plastron_tui.generating.generation import Manifests

        placed = self._places.placed(generation)
        return self._generate(placed, Manifests(self._manifest), self.placed)

    def rendered(self, generation: Generation) -> tuple[Path, FileSet, str] | None:
        """Return the files that an earlier `generate_node` makes, for a `load` that follows it.

        The last is the stem of the main file where the node is not written yet.
        """
        from plastron_tui.output.manifest import Manifest

        generation = self._places.placed(generation)
        made = self._generate(generation, lambda _: Manifest())
        path = made.path(self._configuration.output)
        if made.files is None or path is None:
            return None
        library = self._library(generation.library)
        node, new = generation.node, path.stem
        if node.source is None and library is not None:
            new = PurePath(self._names(lambda _: Manifest()).of(node, library.target)).stem
        return path, made.files.files, new

    def _library(self, name: str) -> Library | None:
        """Return what writes nodes for a client library, which knows the program's own types."""
        if name not in self._libraries:
            library = self._configuration.library(name)
            own = {} if library is None else self._own_types(library.target.ros_version)
            if library is not None and own:
                library = library._replace(catalog=library.catalog.with_own(own))
            self._libraries[name] = library
        return self._libraries[name]

    def _generate(
        self,
        generation: Generation,
        manifests: Callable[[Path], Manifest],
        generations: Sequence[Generation] = (),
    ) -> Generated:
        from plastron_tui.generating.generation import Generated, generate, nodes_of_file

        library = self._library(generation.library)
        if library is None:
            return Generated(generation, None, (_unsupported(generation),))
        source = generation.node.source
        own = None if source is None else self._library(source.library)
        nodes = nodes_of_file(generation, generations)
        return generate(generation, library, self._writing(manifests), own=own, nodes=nodes)

    def _writing(self, manifests: Callable[[Path], Manifest]) -> Writing:
        from plastron_tui.generating.destination import Writing

        return Writing(
            self._configuration.output,
            manifests,
            self._author,
            self._names(lambda folder: self._manifest(folder)[0]),
            self._configuration.options.in_place,
            self._configuration.options.force,
        )

    def _names(self, manifest: Callable[[Path], Manifest]) -> FileNames:
        from plastron_tui.generating.file_names import FileNames

        configuration = self._configuration
        is_plain = configuration.project.file_names == "plain"
        name = self._author.name
        return FileNames(configuration.output, manifest, name, is_plain, self._written)

    def plan(
        self,
        made: Sequence[Generated],
        *,
        is_preview: bool = False,
        has_copies: bool = True,
    ) -> tuple[FilePlan, tuple[Diagnostic, ...]]:
        """Compare the files of nodes with the disk; the diagnostics say why one is missing.

        Args:
            made: the files of nodes.
            is_preview: whether the plan is only looked at: where the project is not trusted, it
                is made without what that stands against, and without the files of the program as
                a whole.
            has_copies: whether it has the files too that the program leaves as they are in the
                packages that it loads.
        """
        from plastron_tui.generating.program_files import ProgramFiles, program_files
        from plastron_tui.output.plan import FilePlan, make_plan

        configuration, output = self._configuration, self._configuration.output
        manifest, _ = self._manifest(output)
        common = ProgramFiles()
        if not is_preview:
            names = self._names(lambda _: manifest)
            common = program_files(self.placed, self._library, names, manifest)
        # Of two nodes of one file both say what is to be said of it.
        told = dict.fromkeys(found for generated in made for found in generated.diagnostics)
        found = [*told, *common.diagnostics]
        if not is_preview:
            found += configuration.refusals
        params = None if is_preview else self._params(manifest)
        if configuration.output_problem is not None:
            return FilePlan(output, ()), (*found, configuration.output_problem)
        has_copies = has_copies and not is_preview
        whole, notes = self._whole(made, manifest, has_copies=has_copies)
        found += notes
        if configuration.options.in_place:
            needed = self._places.files_needed(made)
            whole += needed.files
            found += (*needed.diagnostics, *self._leading_out(needed.files))
        sets = (generated.files for generated in made if generated.files is not None)
        files = [file for each in (*sets, *common.files) for file in each.output_files()]
        if params is not None:
            files.append(params)
        files, refused = self._with_loaded([*files, *whole], made, manifest, has_copies=has_copies)
        found += refused
        if self._workspace is not None and has_copies and not has_errors(found):
            found += self._left(files, manifest)
        plan, problems = make_plan(output, files, manifest, within=configuration.writes_within)
        return plan, (*found, *problems)

    def _left(self, files: Sequence[OutputFile], manifest: Manifest) -> list[Diagnostic]:
        """Tell the files of packages that the program has written, and writes no longer."""
        written = [each for each in files if each.path is None]
        names = (*manifest.bases, *(each.name for each in written))
        # Without a name a program is not known again.
        if not self._author.name or not any("/" in each for each in names):
            return []
        from plastron_tui.generating.text_files import Folder, left_files

        folder = Folder(self._configuration.output, manifest, self._author.name)
        made = () if self._workspace is None else self._workspace.written_packages
        own = {each.package.name for each in made}
        # Where only some nodes are asked for, the package of the others is no rest either.
        homes = (each.node.home for each in self.placed)
        own |= {home.package for home in homes if home is not None and home.is_own}
        return left_files(written, folder, own)

    def _whole(
        self, made: Sequence[Generated], manifest: Manifest, *, has_copies: bool
    ) -> tuple[list[OutputFile], list[Diagnostic]]:
        """Make the packages, definitions and launch files of the program."""
        workspace = self._workspace
        has_own = any(x.node.home is not None and x.node.home.is_own for x in self.placed)
        if workspace is None or not (workspace.has_more_than_nodes or has_own):
            return [], []
        from plastron_tui.generating.loaded_types import places_beside
        from plastron_tui.generating.own_definitions import loaded_definitions
        from plastron_tui.generating.text_files import Folder, text_files
        from plastron_tui.project.package_copy import copied_files, copy_setting

        configuration = self._configuration
        packages = self._packages(workspace, made, manifest)
        made_of = packages.made()
        around = self._places.files_around(made)
        in_place, force = configuration.options.in_place, configuration.options.force
        folder = Folder(configuration.output, manifest, self._author.name, force)
        writing = self._writing(lambda folder: self._manifest(folder)[0])
        launches, refused = packages.launches.loaded(folder, writing)
        robots, unchanged = packages.robots.loaded(folder, writing)
        places = places_beside(workspace, configuration.boundary) if in_place else {}
        files, notes = text_files(made_of.files, folder, places, made_of.merges)
        notes += self._leading_out(files)
        types = workspace.types.values() if workspace.is_written else ()
        files += loaded_definitions(types, in_place=in_place)
        if has_copies:
            setting = copy_setting(configuration, manifest, self._author.name)
            copied = copied_files(made_of.copies, setting)
            files, notes = [*files, *copied.files], [*notes, *copied.diagnostics]
        found = [*made_of.diagnostics, *notes, *refused, *unchanged, *around.diagnostics]
        found += self._leading_out(around.files)
        return [*files, *launches, *robots, *around.files], found

    def _packages(
        self, workspace: Workspace, made: Sequence[Generated], manifest: Manifest
    ) -> ProgramPackages:
        from plastron_tui.generating.program_packages import ProgramPackages
        from plastron_tui.generating.text_files import entry_of

        from .robot_companions import CompanionFinder

        configuration = self._configuration
        return ProgramPackages(
            workspace,
            made,
            self._library,
            configuration.ros.library,
            lambda path: entry_of(path, configuration.output) in manifest,
            generations=self.placed,
            python_launch=configuration.project.launch == "python",
            companions=CompanionFinder(configuration),
        )

    def _with_loaded(
        self,
        files: list[OutputFile],
        made: Sequence[Generated],
        manifest: Manifest,
        *,
        has_copies: bool,
    ) -> tuple[list[OutputFile], tuple[Diagnostic, ...]]:
        """Add the files of the packages that the program loads, as it changes them."""
        workspace = self._workspace
        loaded = {
            each.package.variable: each.package
            for each in (() if workspace is None else workspace.written_packages)
            if each.package.source is not None
        }
        if workspace is None or not loaded:
            return files, ()
        from plastron_tui.generating.loaded_notes import still_started
        from plastron_tui.generating.loaded_package import loaded_package_files
        from plastron_tui.generating.loaded_types import types_of

        libraries = {name: found for name in LIBRARIES if (found := self._library(name))}
        told: tuple[Diagnostic, ...] = ()
        for package in loaded.values():
            output, in_place = self._configuration.output, self._configuration.options.in_place
            parts, problems = self._packages(workspace, made, manifest).of_loaded(package)
            told += problems
            if has_errors(problems):
                continue
            assert package.source is not None
            types = types_of(workspace, package.name, package.source.ros_version)
            changed = loaded_package_files(
                package, made, libraries, output, manifest, parts, types, in_place=in_place
            )
            files = [each for each in files if each.name not in changed.nodes]
            files += changed.files
            told += changed.diagnostics
            told += tuple(self._leading_out(changed.files, package.span))
            known = self._changed_alone(files, made)
            told += tuple(still_started(package, files, known))
            if has_copies and not in_place and not has_errors(changed.diagnostics):
                files, notes = self._with_copies(package, files, known, manifest)
                told += notes
        return files, told

    def _leading_out(
        self, files: Sequence[OutputFile], span: Span | None = None
    ) -> Iterator[Diagnostic]:
        """Refuse to write into folders of a package that are links out of the project."""
        boundary = self._configuration.boundary
        for each in files:
            if each.path is not None and not boundary.allows(each.path):
                message = f"`{each.name}` would be {boundary.place_of(each.path)}"
                yield Diagnostic(codes.OUTSIDE_PROJECT, message, span, help=boundary.remedy)

    def _changed_alone(
        self, files: Sequence[OutputFile], made: Sequence[Generated]
    ) -> dict[str, bytes]:
        """Return what becomes of files that the program loads by themselves, by their real paths.

        Where a package has such a file, the copy of the package has it as it becomes.
        """
        assert self._workspace is not None
        by_name = {each.name: each.text for each in files}
        launches = (each.launch.source for each in self._workspace.written_launches)
        robots = (each.robot.source for each in self._workspace.written_robots)
        paths = [each.path for each in (*launches, *robots) if each is not None]
        found = [(path, by_name.get(path.name)) for path in paths]
        for each in made:
            source = each.generation.node.source
            is_ported = source is not None and source.library != each.generation.library
            if source is not None and each.files is not None and not is_ported:
                found.append((source.path, each.files.files.main))
        return {os.path.realpath(path): text for path, text in found if text is not None}

    def _with_copies(
        self,
        package: Package,
        files: list[OutputFile],
        known: Mapping[str, bytes],
        manifest: Manifest,
    ) -> tuple[list[OutputFile], tuple[Diagnostic, ...]]:
        """Add the other files of a package, of which the output folder gets the changed ones."""
        from .package_copy import copy_setting, with_copies

        setting = copy_setting(self._configuration, manifest, self._author.name)
        copied = with_copies(package, files, known, setting)
        return list(copied.files), copied.diagnostics

    def _params(self, manifest: Manifest) -> OutputFile | None:
        """Make the parameter file of all that is generated, where the project reaches so far."""
        from plastron_tui.generating.params_file import params_output, params_path

        configuration, name = self._configuration, self._author.name
        path = params_path(configuration.output, Path(name))
        if not name or not configuration.boundary.allows(path):
            return None
        last = {each.node.variable: each.node for each in self.placed}
        return params_output(last.values(), path, configuration.output, manifest)


def _unsupported(generation: Generation) -> Diagnostic:
    return Diagnostic(
        codes.UNSUPPORTED_TARGET,
        f"plastron cannot generate `{generation.library}`",
        generation.span,
        help=f"use {either(LIBRARIES)}",
    )
