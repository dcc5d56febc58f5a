"""The one object that the command line and the studio both drive.

A session holds a program and gives, at any moment, what follows from it: statements, workspace,
diagnostics, files. Each is made when it is first asked for, and again after an edit.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from copy import copy
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING

from plastron_tui.diagnostics import Diagnostic, LineIndex, has_errors
from plastron_tui.language.document import Document
from plastron_tui.output.own_files import has_leftovers
from plastron_tui.project.options import Options as Options
from plastron_tui.project.program_file import lines_of

if TYPE_CHECKING:
    # What a program means is found out when its text is there to see: the studio starts sooner.
    from plastron_tui.boundary import Boundary
    from plastron_tui.generating.generation import Generated
    from plastron_tui.language import Program
    from plastron_tui.language.incremental_lowering import Lowered
    from plastron_tui.model.checkpoint import Learnt
    from plastron_tui.model.context import Setting
    from plastron_tui.model.interpreter import Interpretation
    from plastron_tui.model.own_types import OwnInterfaces
    from plastron_tui.model.source import FileSet
    from plastron_tui.model.workspace import Generation, Node, Workspace
    from plastron_tui.output.plan import FilePlan
    from plastron_tui.project.configuration import Configuration
    from plastron_tui.project.loader import FilesRead, NodeLoader
    from plastron_tui.project.planner import Planner
    from plastron_tui.project.robot_files import RobotFiles
    from plastron_tui.project.ros_choice import RosChoice
    from plastron_tui.project.settings import Project
    from plastron_tui.ros import parameters
    from plastron_tui.ros.catalog import Catalog
    from plastron_tui.ros.parameter_values import NodeParameters
    from plastron_tui.runtime.parameters import SetResult
    from plastron_tui.targets.packages.spec import RenderedPackage


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
        self._program: Program | None = None
        self._earlier: Lowered | None = None
        self._learnt: Learnt | None = None
        self._interpretation: Interpretation | None = None
        self._type_problems: tuple[Diagnostic, ...] = ()

    @cached_property
    def _configuration(self) -> Configuration:
        from plastron_tui.project.configuration import Configuration

        folder = (self._begun or Path.cwd()) if self.path is None else self.path.absolute().parent
        return Configuration(folder, self.options, self._environ)

    @property
    def folder(self) -> Path:
        """The program's folder."""
        return self._configuration.folder

    @property
    def boundary(self) -> Boundary:
        """How far the program's project reaches."""
        return self._configuration.boundary

    @property
    def project(self) -> Project:
        """What the project file says."""
        return self._configuration.project

    @property
    def project_problems(self) -> tuple[Diagnostic, ...]:
        """What is wrong with the project file."""
        return self._configuration.project_problems

    @property
    def ros(self) -> RosChoice:
        """The ROS of a node that names none, and why it is that one."""
        return self._configuration.ros

    @property
    def library(self) -> str:
        """The client library of a node that names none."""
        return self.ros.library

    @property
    def output(self) -> Path:
        """The output folder."""
        return self._configuration.output

    def catalog(self, ros_version: int) -> Catalog:
        """Return the interface types of a generation of ROS, the program's own among them."""
        catalog = self._configuration.catalog(ros_version)
        own = self._own_types(ros_version)
        return catalog.with_own(own) if own else catalog

    @property
    def type_problems(self) -> tuple[Diagnostic, ...]:
        """What is wrong with the definitions that the program asks for, or has asked for."""
        # A file that is made asks for more: a port for the types of the other ROS.
        is_known = self._interpretation is not None
        return self._type_problems if is_known else self._configuration.type_problems()

    def snapshot(self) -> Session:
        """Return a session of the program as it is now, for another thread.

        What a session reads once (the project file, interface types, targets) both share; it is
        the other thread's as long as it works.
        """
        _ = self.ros, self._files
        other = copy(self)
        other.document = self.document.snapshot()
        return other

    def anew(self) -> Session:
        """Return a session of the program as it is now that shares nothing with this one."""
        text = self.document.text
        return Session(text, self.path, self.options, self._environ, self._begun)

    def edit(self, start: int, old_end: int, new: bytes) -> None:
        """Replace the bytes from `start` to `old_end` of the program."""
        self.document.edit(start, old_end, new)
        self._program = None
        self._interpretation = None

    def learn_from(self, earlier: Session) -> None:
        """Let what an earlier snapshot of the same program has found out help with this one."""
        if earlier._program is not None:
            from plastron_tui.language.incremental_lowering import Lowered

            self._earlier = Lowered(earlier.document.text, earlier._program)
        if earlier._interpretation is not None and earlier._configuration is self._configuration:
            self._learnt = earlier._interpretation.learnt

    def trust_changed(self) -> None:
        """Read the project file anew when it is asked next: the user trusts the project, or not."""
        self._configuration = self._configuration.anew()
        self._learnt = None
        self._files.starts.clear()  # what a file was made from may be read by now
        self._files.packages.clear()
        self._interpretation = None

    def files_changed(self) -> None:
        """Run the program anew when it is asked next: files that it loads were written."""
        self._interpretation = None

    @property
    def program(self) -> Program:
        """The program's statements."""
        if self._program is None:
            from plastron_tui.language.incremental_lowering import lower_edited

            self._program = lower_edited(self.document, self._earlier)
            self._earlier = None
        return self._program

    def interpret(self, pulse: Callable[[], None] | None = None) -> Interpretation:
        """Return what the program means; what `pulse` raises, now and then, ends the search."""
        if self._interpretation is None:
            from plastron_tui.model.interpreter import interpret

            loader = self._new_loader()
            setting = self._new_setting(loader)
            self._configuration.leave_type_problems()
            self._interpretation = interpret(self.program, setting, self._learnt, pulse)
            versions = self._interpretation.workspace.ros_versions(setting.ros_version)
            self._type_problems = self._configuration.type_problems(versions)
            self._learnt = None
            loader.forget_others()
        return self._interpretation

    @cached_property
    def _files(self) -> FilesRead:
        from plastron_tui.project.loader import FilesRead

        return FilesRead()

    @property
    def setting(self) -> Setting:
        """What the program is interpreted in, as it is now; it asks this session alone."""
        # Not kept here: it would be a cycle, and the collector works seldom.
        return self._new_setting(self._new_loader())

    def _new_loader(self) -> NodeLoader:
        from plastron_tui.project.loader import NodeLoader

        program = self._name, self.document.text
        # What a program may not lead to, it does not let be written to either.
        if has_leftovers(self.output) and self.boundary.allows(self.output):
            self._files.settle(self.output)
        places = self.folder, self.output, self.boundary
        return NodeLoader(*places, self._rendered, *program, self._files)

    def _new_setting(self, loader: NodeLoader) -> Setting:
        from plastron_tui.project.program_setting import Written, new_setting

        program = Written(self.path, self.document.text)
        return new_setting(self._configuration, loader, program, self._files)

    @property
    def robots(self) -> RobotFiles:
        """What reads the robots' files that the program names."""
        from plastron_tui.project.program_setting import Written, robot_files

        program = Written(self.path, self.document.text)
        return robot_files(self._configuration, program, self._files)

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
        from plastron_tui.project.start_checks import start_problems
        from plastron_tui.project.written_twice import written_twice

        meaning = self.interpret().diagnostics  # which reads the types
        whole = [each for problems in self._files.problems.values() for each in problems]
        if not has_errors(meaning):
            whole += start_problems(self.workspace, self.generate, self.output, self.library)
            whole += written_twice(self.workspace, self.plan)
        return (*self.project_problems, *meaning, *whole, *self.type_problems)

    def lines(self, file: Path | None) -> LineIndex | None:
        """Return the lines of a file that a diagnostic is about; None is the program."""
        return self.document.lines if file in (None, self.path) else lines_of(file)

    def generated(self) -> tuple[Generated, ...]:
        """Make the files that the program asks for."""
        return self._planner(self.workspace.generations).generated()

    def generate(self, generation: Generation) -> Generated:
        """Make the file of one `generate_node`."""
        return self._planner(self.workspace.generations).generate(generation)

    def placed(self) -> tuple[Generation, ...]:
        """Return what is generated, each node in the package that it has to be in."""
        return self._planner(self.workspace.generations).placed

    def plan(self, *, has_copies: bool = True) -> tuple[FilePlan, tuple[Diagnostic, ...]]:
        """Compare the files that the program asks for with the disk.

        The diagnostics say why a file is missing from the plan; a plan that has errors is not
        to be written.

        Args:
            has_copies: whether it has what the program leaves as it is in loaded packages.
        """
        planner = self._planner(self.workspace.generations)
        return planner.plan(self.generated(), has_copies=has_copies)

    def own_packages(self, nodes: Sequence[Node], ros_version: int) -> dict[str, RenderedPackage]:
        """Return the packages of the program's own types that nodes use, those needed first.

        Args:
            nodes: the nodes.
            ros_version: the generation of ROS that they are for.
        """
        if not self.workspace.types:
            return {}
        from plastron_tui.generating.loaded_types import types_of_run
        from plastron_tui.generating.own_definitions import (
            own_definitions,
            rendered_definitions,
            used_packages,
        )

        own = own_definitions(types_of_run(self.workspace, ros_version), ros_version)
        distribution = self.catalog(ros_version).distribution
        return {
            package: rendered_definitions(package, own, ros_version, distribution)
            for package in used_packages(nodes, own)
        }

    def params(self) -> tuple[tuple[NodeParameters, ...], tuple[Diagnostic, ...]]:
        """Return what the program's parameter file has for the nodes that run, and its mistakes."""
        from plastron_tui.project.run_setup import find_params

        path = self.params_path
        return ((), ()) if path is None else find_params(path, self.boundary)

    @property
    def params_path(self) -> Path | None:
        """The program's parameter file, which need not be there; None for one without a file."""
        from plastron_tui.generating.params_file import params_path

        return None if self.path is None else params_path(self.output, self.path)

    def set_parameter(
        self,
        node: str,
        name: str,
        value: parameters.Setting,
        *,
        namespace: str = "",
        master_uri: str | None = None,
    ) -> SetResult:
        """Change a parameter of a node of the program that runs on this machine.

        It takes some seconds, and is to be called beside whatever shows them.

        Args:
            node: the node, by its name or its variable.
            name: the parameter.
            value: the new value; `plastron_tui.ros.parameter_values.parse_value` types a text.
            namespace: the namespace that the node runs in, such as `/robot1`.
            master_uri: the master of a ROS 1 node; None for the usual one.
        """
        from plastron_tui.runtime.environment import find_environments
        from plastron_tui.runtime.parameters import SetResult, SetStatus, set_parameter
        from plastron_tui.targets import ros_version

        nodes = self.workspace.nodes
        by_name = (each for each in nodes.values() if each.name == node)
        found = nodes.get(node) or next(by_name, None)
        if found is None:
            return SetResult(SetStatus.ABSENT, f"the program has no node `{node}`")
        version = ros_version(found.library or self.library)
        environment, diagnostics = find_environments(self._environ).choose(version)
        if environment is None:
            return SetResult(SetStatus.ABSENT, diagnostics[0].message)
        return set_parameter(
            environment,
            f"{namespace}/{found.name}",
            name,
            value,
            master_uri=master_uri,
            environ=self._environ,
        )

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
            is_preview: whether the plan is only looked at, as `Planner.plan` has it.
            generations: all that the program generates, for these; None for what it says.
        """
        asked = self.workspace.generations if generations is None else generations
        return self._planner(asked).plan(made, is_preview=is_preview)

    def _rendered(self, generation: Generation) -> tuple[Path, FileSet, str] | None:
        return self._planner(()).rendered(generation)

    def _planner(self, generations: Sequence[Generation]) -> Planner:
        from plastron_tui.output.manifest import digest
        from plastron_tui.output.patch_stack import Author
        from plastron_tui.project.planner import Planner

        author = Author(self._name, digest(self.document.text), self.folder)
        manifest = self._files.manifest
        known = None if self._interpretation is None else self._interpretation.workspace
        return Planner(self._configuration, author, manifest, generations, self._own_types, known)

    def _own_types(self, ros_version: int) -> OwnInterfaces:
        known = self._interpretation
        return {} if known is None else known.own_types.get(ros_version, {})
