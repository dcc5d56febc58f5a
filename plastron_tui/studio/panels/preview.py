"""The files that nodes and packages become, with what writing them would change."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path, PurePosixPath
from typing import TYPE_CHECKING

from plastron_tui.diagnostics import Diagnostic, Span
from plastron_tui.model.source import FileSet, place_of
from plastron_tui.model.workspace import Generation, Home, Workspace
from plastron_tui.output.plan import FilePlan, FileState, PlannedFile

from .diff_lines import difference, planned_diff
from .preview_lines import lines_of_statements
from .source_lines import coloured
from .styles import Lines

if TYPE_CHECKING:
    from plastron_tui.model.robots import Robot

    from ..analysis import Analysis, PartMemo


@dataclass(frozen=True)
class Preview:
    """A file that a node becomes.

    Attributes:
        name: the file's name.
        path: where it would be written.
        state: what writing would do to it; None for a node that is not generated yet.
        lines: its text, coloured.
        diff: what would change in it, None where there is nothing to compare with; empty where
            the file stays as it was loaded.
        origin: the file that `diff` compares with, where that is another one; "" for the same.
        problems: why there is no text.
        size: how large it will be, in bytes.
        is_main: whether it is the file of a node that the others belong to.
        statement_lines: the lines, from 1, that statements of the program become.
    """

    name: str
    path: Path | None
    state: FileState | None
    lines: Lines
    diff: Lines | None
    problems: tuple[Diagnostic, ...]
    size: int = 0
    is_main: bool = False
    origin: str = ""
    statement_lines: Mapping[Span, int] = field(default_factory=dict)

    def line_at(self, offset: int) -> int | None:
        """Return the line that the statement at an offset of the program becomes."""
        found = (line for span, line in self.statement_lines.items() if offset in span)
        return next(found, None)


def previews_of(analysis: Analysis, variable: str) -> tuple[Preview, ...]:
    """Return the files of a node: those that it is generated as, or else would be.

    Where it has to be built, and no statement makes a package for that, what builds it follows.
    Of a package, a launch file, a robot or a type, those that are written of it.
    """
    node = analysis.workspace.nodes.get(variable)
    if node is None:
        return tuple(_written(analysis, variable))
    asked = {
        generation.library: generation
        for generation in analysis.workspace.generations
        if generation.node.variable == variable
    }
    if asked:
        return tuple(
            preview
            for generation in asked.values()
            for preview in (
                *_previews(analysis, generation, True),
                *_building(analysis, generation),
            )
        )
    library = node.source.library if node.source is not None else node.library
    generation = Generation(node, library or analysis.session.library, node.span)
    return tuple(_previews(analysis, generation, False))


def _written(analysis: Analysis, variable: str) -> Iterator[Preview]:
    """Yield what the plan has of a package, a launch file, a robot or a type."""
    is_meant = files_meant(analysis.workspace, variable)
    if is_meant is None:
        return
    plan, problems = _plan(analysis)
    files = [file for file in plan.files if is_meant(PurePosixPath(file.name))]
    for file in files:
        yield _preview(analysis.memo, file, file.state, _disk_diff(file), problems)
    robot = analysis.workspace.robots.get(variable)
    if not files and robot is not None:
        yield _robot(robot)
    elif not files:
        yield Preview(f"{variable}: nothing is written yet", None, None, (), None, problems)


def _robot(robot: Robot) -> Preview:
    """Return what the file of a robot would hold."""
    from plastron_tui.generating.robot_files import robot_text

    made = robot_text(robot)
    source, path = robot.source, Path(made.name)
    if made.text is None:
        return Preview(made.name, None, None, (), None, made.diagnostics)
    diff = None if source is None else difference(source.text, made.text, path)
    lines = coloured(made.text.decode("utf-8", "replace"), path)
    return Preview(made.name, path, None, lines, diff or None, made.diagnostics, len(made.text))


def _plan(analysis: Analysis) -> tuple[FilePlan, tuple[Diagnostic, ...]]:
    """Return all that the program writes, but for what it only copies."""
    return analysis.once("plan", lambda: analysis.session.plan(has_copies=False))


def _building(analysis: Analysis, generation: Generation) -> Iterator[Preview]:
    """Yield the files that build a node, of the package that no statement has made."""
    home = analysis.session.generate(generation).generation.node.home
    if home is None or not home.is_own:
        return
    plan, problems = _plan(analysis)
    launches = [files_meant(analysis.workspace, name) for name in analysis.workspace.launches]
    for file in plan.files:
        path = PurePosixPath(file.name)
        is_launch = any(is_meant is not None and is_meant(path) for is_meant in launches)
        if path.parent == _folder(home) and not is_launch:
            yield _preview(analysis.memo, file, file.state, _disk_diff(file), problems)


def _folder(home: Home) -> PurePosixPath:
    """Return the folder that a plan gives the files which build a node."""
    is_there = home.above is not None
    return PurePosixPath(home.package if is_there or not home.is_output else ".")


def files_meant(workspace: Workspace, variable: str) -> Callable[[PurePosixPath], bool] | None:
    """Return what tells the files of something from others, by their paths in the plan."""
    package = workspace.packages.get(variable)
    if package is not None:
        folders = {package.name, f"{package.name}_interfaces"}
        return lambda path: path.parts[0] in folders
    launch = workspace.launches.get(variable)
    if launch is not None:
        return lambda path: path.name.partition(".")[0] in (launch.name, f"{launch.name}_launch")
    robot = workspace.robots.get(variable)
    if robot is not None:
        name = f"{robot.stem}.urdf" if robot.source is None else robot.source.path.name
        return lambda path: path.name == name
    if variable in workspace.types:
        name = variable.rpartition("/")[2]
        return lambda path: path.stem == name and path.suffix in (".msg", ".srv", ".action")
    return None


def _disk_diff(file: PlannedFile) -> Lines | None:
    if file.before is None or file.state is FileState.IDENTICAL:
        return None
    return planned_diff(file)


def _preview(
    memo: PartMemo,
    file: PlannedFile,
    state: FileState | None,
    diff: Lines | None,
    problems: tuple[Diagnostic, ...],
    *,
    is_main: bool = False,
    origin: str = "",
) -> Preview:
    # Most edits leave the files as they are.
    lines = memo.once(
        ("coloured", file.path, file.text),
        lambda: coloured(file.text.decode("utf-8", "replace"), file.path),
    )
    size = len(file.text)
    return Preview(file.name, file.path, state, lines, diff, problems, size, is_main, origin)


def _previews(analysis: Analysis, generation: Generation, is_asked: bool) -> Iterator[Preview]:
    session = analysis.session
    made = session.generate(generation)
    if made.files is None:
        yield Preview(generation.node.name, None, None, (), None, made.diagnostics, is_main=True)
        return
    plan, problems = session.plan_of([made], is_preview=True)
    if not plan.files:
        yield Preview(made.files.name, None, None, (), None, problems, is_main=True)
    source = generation.node.source
    is_own = source is not None and source.library == generation.library
    loaded = {} if source is None or not is_own else dict(source.files.texts)
    names = made.files.files.names
    texts = tuple((name, file.text) for file, name in zip(plan.files, names, strict=False))
    lines = (
        lines_of_statements(plan.files[0].path, FileSet(texts), generation.node, analysis.memo)
        if texts
        else {}
    )
    for file, name in zip(plan.files, names, strict=False):
        diff, origin = _disk_diff(file), ""
        if diff is None and name in loaded:
            diff = difference(loaded[name], file.text, file.path)
            origin = place_of(source.path, name).name if source is not None else ""
        state = file.state if is_asked else None
        is_main = name == names[0]
        found = made.diagnostics
        preview = _preview(analysis.memo, file, state, diff, found, is_main=is_main, origin=origin)
        yield replace(preview, statement_lines=lines.get(name, {}))
