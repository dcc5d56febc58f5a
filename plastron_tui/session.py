"""The one object that the command line and the studio both drive.

A session holds a program and gives, at any moment, what follows from it: statements, workspace,
diagnostics, files. Each is made when it is first asked for, and again after an edit.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Mapping, Sequence
from copy import copy
from dataclasses import replace
from functools import cached_property, partial
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from plastron_tui.boundary import DEFAULT_OUTPUT, Boundary, find_boundary
from plastron_tui.diagnostics import Diagnostic, LineIndex, codes
from plastron_tui.language import Document, Program
from plastron_tui.language.relowering import Lowered, lower_edited
from plastron_tui.model.libraries import written_libraries
from plastron_tui.output.names import has_leftovers
from plastron_tui.program_file import lines_of
from plastron_tui.project import TRUST_CODES, Project, as_error, find_project, outside_output
from plastron_tui.ros_choice import RosChoice, Said, Why, choose_distribution, choose_ros
from plastron_tui.targets import LIBRARIES, has_target

if TYPE_CHECKING:
    # What a program means is found out when its text is there to see: the studio starts sooner.
    from plastron_tui.generating.adaptation import Library
    from plastron_tui.generating.generation import Generated
    from plastron_tui.loader import FilesRead, NodeLoader
    from plastron_tui.model.fitting import Fitter
    from plastron_tui.model.interpreter import Interpretation
    from plastron_tui.model.setting import Setting
    from plastron_tui.model.source import FileSet
    from plastron_tui.model.workspace import Generation, Workspace
    from plastron_tui.output.manifest import Manifest
    from plastron_tui.output.plan import FilePlan
    from plastron_tui.ros.catalog import Catalog


class Options(NamedTuple):
    """What the command line sets; what it leaves open the project file or the environment says.

    Attributes:
        target: the client library of a node that names none.
        output: the output folder.
        in_place: whether a loaded node is written over the file that it came from.
        force: whether a created node is written anew where its file was changed by hand.
        distribution: the distribution whose types count, for nodes of its generation of ROS.
        is_writing: whether files are to be written: what is not trusted is then an error.
    """

    target: str | None = None
    output: Path | None = None
    in_place: bool = False
    force: bool = False
    distribution: str | None = None
    is_writing: bool = False


def _unsupported(generation: Generation) -> Diagnostic:
    return Diagnostic(
        codes.UNSUPPORTED_TARGET,
        f"plastron cannot generate `{generation.library}` yet",
        generation.span,
        help=f"use {' or '.join(written_libraries(LIBRARIES))}",
    )


class Session:
    """A program, and all that follows from it."""

    def __init__(
        self,
        text: bytes = b"",
        path: Path | None = None,
        options: Options | None = None,
        environ: Mapping[str, str] = os.environ,
        begun: Path | None = None,
    ) -> None:
        """Start a session with a program's text; nothing is parsed twice, or before it is asked.

        Args:
            text: the program, as UTF-8.
            path: the program's file, None for one that has none yet.
            options: what the command line sets.
            environ: the environment variables that say which ROS is sourced.
            begun: the folder of a program without a file; None for the working folder.
        """
        self.path = path
        self.options = options or Options()
        self.document = Document(text)
        self._environ = environ
        self._begun = begun
        self._catalogs: dict[int, Catalog] = {}
        self._libraries: dict[str, Library | None] = {}
        self._program: Program | None = None
        self._earlier: Lowered | None = None
        self._fitters: Mapping[int, Fitter] = {}
        self._interpretation: Interpretation | None = None

    @cached_property
    def folder(self) -> Path:
        """The program's folder."""
        if self.path is None:
            return self._begun or Path.cwd()
        return self.path.absolute().parent

    @cached_property
    def boundary(self) -> Boundary:
        """How far the program's project reaches."""
        named = () if self.options.output is None else (self.options.output.absolute(),)
        return replace(find_boundary(self.folder), named=named)

    @cached_property
    def _project(self) -> tuple[Project, tuple[Diagnostic, ...]]:
        overruled = () if self.options.output is None else ("output",)
        return find_project(self.boundary, LIBRARIES, overruled)

    @property
    def project(self) -> Project:
        """What the project file says."""
        return self._project[0]

    @cached_property
    def ros(self) -> RosChoice:
        """The ROS of a node that names none, and why it is that one."""
        return choose_ros(self._said, LIBRARIES, self._environ)

    @property
    def library(self) -> str:
        """The client library of a node that names none."""
        return self.ros.library

    @property
    def _said(self) -> tuple[Said, ...]:
        options, project = self.options, self.project
        return (
            Said(Why.OPTION, options.target, options.distribution),
            Said(Why.PROJECT, project.target, project.distribution),
        )

    @property
    def output(self) -> Path:
        """The output folder."""
        return self.options.output or self.project.output or self.folder / DEFAULT_OUTPUT

    def catalog(self, ros_version: int) -> Catalog:
        """Return the interface types of a generation of ROS."""
        catalog = self._catalogs.get(ros_version)
        if catalog is None:
            catalog = self._catalogs[ros_version] = self._new_catalog(ros_version)
        return catalog

    def _new_catalog(self, ros_version: int) -> Catalog:
        from plastron_tui.project import outside_definition
        from plastron_tui.ros.catalog import Catalog, installed_folders

        distribution = choose_distribution(ros_version, self._said, self._environ)
        own = self.project.types or (self.folder,)
        installed = installed_folders(self._environ, ros_version)
        refusal = partial(outside_definition, folders=own, boundary=self.boundary)
        return Catalog(distribution, own, installed, refusal)

    def snapshot(self) -> Session:
        """Return a session of the program as it is now, for another thread.

        What a session reads once (the project file, interface types, targets) both share; it is
        the other thread's as long as it works.
        """
        _ = self.folder, self.ros, self._files
        other = copy(self)
        other.document = self.document.snapshot()
        return other

    def edit(self, start: int, old_end: int, new: bytes) -> None:
        """Replace the bytes from `start` to `old_end` of the program."""
        self.document.edit(start, old_end, new)
        self._program = None
        self._interpretation = None

    def learn_from(self, earlier: Session) -> None:
        """Let what an earlier snapshot of the same program has found out help with this one."""
        if earlier._program is not None:
            self._earlier = Lowered(earlier.document.text, earlier._program)
        if earlier._interpretation is not None and earlier._project is self._project:
            self._fitters = earlier._interpretation.fitters

    def trust_changed(self) -> None:
        """Read the project file anew when it is asked next: the user trusts the project, or not."""
        for name in ("_project", "ros"):
            self.__dict__.pop(name, None)
        self._catalogs, self._libraries, self._fitters = {}, {}, {}
        self._files.starts.clear()  # what a file was made from may be read by now
        self._interpretation = None

    def files_changed(self) -> None:
        """Run the program anew when it is asked next: files that it loads were written."""
        self._interpretation = None

    @property
    def program(self) -> Program:
        """The program's statements."""
        if self._program is None:
            self._program = lower_edited(self.document, self._earlier)
            self._earlier = None
        return self._program

    def interpret(self, pulse: Callable[[], None] | None = None) -> Interpretation:
        """Return what the program means; what `pulse` raises, now and then, ends the search."""
        if self._interpretation is None:
            from plastron_tui.model.interpreter import interpret

            loader = self._new_loader()
            setting = self._new_setting(loader)
            self._interpretation = interpret(self.program, setting, self._fitters, pulse)
            self._fitters = {}
            loader.forget_others()
        return self._interpretation

    @cached_property
    def _files(self) -> FilesRead:
        from plastron_tui.loader import FilesRead

        return FilesRead()

    @property
    def setting(self) -> Setting:
        """What the program is interpreted in, as it is now; it asks this session alone."""
        # Not kept here: it would be a cycle, and the collector works seldom.
        return self._new_setting(self._new_loader())

    def _new_loader(self) -> NodeLoader:
        from plastron_tui.loader import NodeLoader

        program = self._name, self.document.text
        # What a program may not lead to, it does not let be written to either.
        if has_leftovers(self.output) and self.boundary.allows(self.output):
            self._files.settle(self.output)
        places = self.folder, self.output, self.boundary
        return NodeLoader(*places, self._rendered, *program, self._files)

    def _new_setting(self, loader: NodeLoader) -> Setting:
        from plastron_tui.model.setting import Setting

        return Setting(self.library, LIBRARIES, self.catalog, loader, self.ros.is_chosen)

    @property
    def _name(self) -> str:
        """The name of the program's file, "" where it has none."""
        return "" if self.path is None else self.path.name

    @property
    def workspace(self) -> Workspace:
        """What the program builds."""
        return self.interpret().workspace

    @property
    def diagnostics(self) -> tuple[Diagnostic, ...]:
        """All that is wrong with the program, its project file, and the types that it uses."""
        # The types are read when the program is interpreted.
        meaning = self.interpret().diagnostics
        left = self._files.problems.values()
        found = (*meaning, *self._unwritten(), *(each for problems in left for each in problems))
        return (*self.project_problems, *found, *self.type_problems)

    def _unwritten(self) -> Iterator[Diagnostic]:
        """Yield a diagnostic for each node whose client library nothing here can write."""
        generations = self.workspace.generations
        libraries = {generation.library for generation in generations}
        missing = {library for library in libraries if not has_target(library)}
        for generation in generations if missing else ():
            if generation.library in missing:
                yield _unsupported(generation)

    @property
    def project_problems(self) -> tuple[Diagnostic, ...]:
        """What is wrong with the project file."""
        found = self._project[1]
        return tuple(map(as_error, found)) if self.options.is_writing else found

    @property
    def type_problems(self) -> tuple[Diagnostic, ...]:
        """What is wrong with the definitions that were read so far."""
        problems = (found for catalog in self._catalogs.values() for found in catalog.problems)
        # The catalogs of both generations of ROS may have asked for one definition.
        return tuple(dict.fromkeys(problems))

    def lines(self, file: Path | None) -> LineIndex | None:
        """Return the lines of a file that a diagnostic is about; None is the program."""
        if file is None or file == self.path:
            return self.document.lines
        return lines_of(file)

    def generated(self) -> tuple[Generated, ...]:
        """Make the files that the program asks for.

        Of two `generate_node` of one variable the last counts; and a file that the program
        generates, loads and generates again is made as it is at the end.
        """
        from plastron_tui.generating.generation import Manifests, last_of_each

        manifests = Manifests(self._files.manifest)
        last = {(each.node.variable, each.library): each for each in self.workspace.generations}
        made = [self._generate(each, manifests, tuple(last.values())) for each in last.values()]
        kept = last_of_each(made, self.output)
        if manifests.problems and kept:
            found = (*manifests.problems, *kept[0].diagnostics)
            kept[0] = replace(kept[0], diagnostics=found)
        return tuple(kept)

    def generate(self, generation: Generation) -> Generated:
        """Make the file of one `generate_node`."""
        from plastron_tui.generating.generation import Manifests

        manifests = Manifests(self._files.manifest)
        return self._generate(generation, manifests, self.workspace.generations)

    def _generate(
        self,
        generation: Generation,
        manifests: Callable[[Path], Manifest],
        generations: Sequence[Generation] = (),
    ) -> Generated:
        from plastron_tui.generating.generation import Generated, generate, nodes_of_file
        from plastron_tui.generating.place import Writing
        from plastron_tui.output.layers import Author
        from plastron_tui.output.manifest import digest

        library = self._library(generation.library)
        if library is None:
            return Generated(generation, None, (_unsupported(generation),))
        source = generation.node.source
        own = None if source is None else self._library(source.library)
        author = Author(self._name, digest(self.document.text), self.folder)
        in_place, force = self.options.in_place, self.options.force
        writing = Writing(self.output, manifests, author, in_place, force)
        nodes = nodes_of_file(generation, generations)
        return generate(generation, library, writing, own=own, nodes=nodes)

    def _rendered(self, generation: Generation) -> tuple[Path, FileSet] | None:
        """Return the files that an earlier `generate_node` makes, for a `load` that follows it."""
        from plastron_tui.output.manifest import Manifest

        made = self._generate(generation, lambda _: Manifest())
        path = made.path(self.output)
        return None if made.files is None or path is None else (path, made.files.files)

    def _library(self, name: str) -> Library | None:
        if name not in self._libraries:
            from plastron_tui.generating.adaptation import Library
            from plastron_tui.targets import find_target

            target = find_target(name, self.project.templates)
            self._libraries[name] = (
                None if target is None else Library(target, self.catalog(target.ros_version))
            )
        return self._libraries[name]

    def plan(self) -> tuple[FilePlan, tuple[Diagnostic, ...]]:
        """Compare the files that the program asks for with the disk.

        The diagnostics say why a file is missing from the plan; a plan that has errors is not
        to be written.
        """
        return self.plan_of(self.generated())

    def plan_of(
        self,
        made: Sequence[Generated],
        *,
        is_preview: bool = False,
        generations: Sequence[Generation] | None = None,
    ) -> tuple[FilePlan, tuple[Diagnostic, ...]]:
        """Compare files with the disk, as `plan` does for all that the program asks for.

        Args:
            made: the files of nodes.
            is_preview: whether the plan is only looked at: where the project is not trusted, it
                is made without what that stands against, and without the files of the program as
                a whole.
            generations: all that the program generates, for these; None for what it says.
        """
        from plastron_tui.generating.program_files import ProgramFiles, program_files
        from plastron_tui.output.plan import FilePlan, make_plan

        manifest, _ = self._files.manifest(self.output)
        common = ProgramFiles()
        if not is_preview:
            asked = self.workspace.generations if generations is None else generations
            common = program_files(asked, self._library, self.output, manifest)
        # Of two nodes of one file both say what is to be said of it.
        told = dict.fromkeys(found for generated in made for found in generated.diagnostics)
        found = [*told, *common.diagnostics]
        refusals = [as_error(each) for each in self._project[1] if each.code in TRUST_CODES]
        if not is_preview:
            found += refusals
        is_named = self.options.output is not None
        if not (is_named or self.boundary.allows(self.output)):
            return FilePlan(self.output, ()), (*found, outside_output(self.output, self.boundary))
        sets = (generated.files for generated in made if generated.files is not None)
        files = [file for each in (*sets, *common.files) for file in each.output_files()]
        is_free = is_named or self.project.output is not None or self.boundary.is_trusted
        within = None if is_free else self.folder
        plan, problems = make_plan(self.output, files, manifest, within=within)
        return plan, (*found, *problems)
