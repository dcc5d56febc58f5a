"""Finding and reading the files that a program loads."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple, TypeAlias

from plastron_tui.diagnostics import Code, Diagnostic, codes
from plastron_tui.diagnostics.suggest import nearest
from plastron_tui.model.context import Loaded, LoadRequest
from plastron_tui.model.packages import BUILT_FOLDER
from plastron_tui.model.source import LARGEST_FILE
from plastron_tui.model.workspace import Generation
from plastron_tui.output.own_files import MANIFEST, is_own_name, settled
from plastron_tui.regular_files import Stamp, read_regular, reason, stamp_of
from plastron_tui.sources.still_disk import read_once

from .missing_files import missing
from .robot_files import KnownRobots

if TYPE_CHECKING:
    from plastron_tui.boundary import Boundary
    from plastron_tui.model.source import FileSet, Origin, SourceUnit
    from plastron_tui.output.manifest import Reading
    from plastron_tui.output.patch_stack import Author

    from .package_reader import KnownPackages

_MOST_FOLDERS = 64
"""How many manifests are remembered; a program writes to one folder, and loads from a few."""

_MOST_TURNS = 100
"""How often a program may generate a file and load it again: each time it is read as a whole."""

Rendered: TypeAlias = "tuple[Path, FileSet, str]"
_Made: TypeAlias = tuple[tuple[str, str], Loaded]


Stamps: TypeAlias = dict[Path, Stamp | None]
"""The stamps of files, by their paths; None for one that was not there."""


@dataclass(frozen=True, slots=True)
class FilesRead:
    """What was made of files until now, for loaders to come.

    Attributes:
        nodes: what was read from a file, with the stamps then of all that was read, by its path.
        starts: what a program started from when it wrote a file, by that file's path.
        manifests: what is remembered of the files of a folder, with the stamp of its file.
        problems: what was found of writes to a folder that were interrupted.
        packages: what was read of packages.
        robots: what was found out about robots' files.
    """

    nodes: dict[Path, tuple[Stamps, Loaded]] = field(default_factory=dict)
    starts: dict[Path, _Known] = field(default_factory=dict)
    manifests: dict[Path, tuple[Stamp, Reading]] = field(default_factory=dict)
    problems: dict[Path, tuple[Diagnostic, ...]] = field(default_factory=dict)
    packages: KnownPackages = field(default_factory=dict)
    robots: KnownRobots = field(default_factory=KnownRobots)

    def settle(self, folder: Path) -> None:
        """Finish what a process that was killed had begun to write to a folder."""
        # What was finished stays told, what could not be only until it can.
        done = [note for note in self.problems.pop(folder, ()) if not is_own_name(note.file)]
        if notes := (*done, *(note for note in settled(folder) if note not in done)):
            self.problems[folder] = notes

    def manifest(self, folder: Path) -> Reading:
        """Return a folder's manifest as it is now; it is read where it has changed."""
        from plastron_tui.output.manifest import NAME, load_manifest

        stamp = stamp_of(folder / NAME)
        known = self.manifests.get(folder)
        if known is not None and known[0] == stamp:
            return known[1]
        found = load_manifest(folder)
        # One that cannot be read may be readable later, and no stamp tells.
        if stamp is not None and not found[1]:
            if len(self.manifests) >= _MOST_FOLDERS:
                self.manifests.clear()
            self.manifests[folder] = stamp, found
        return found

    def keep(self, paths: set[Path]) -> None:
        """Forget all files but these: what a program no longer loads it seldom loads again."""
        for known in (self.nodes, self.starts):
            # As a list at once: another thread may read a file meanwhile.
            for path in list(known):
                if path not in paths:
                    known.pop(path, None)


class NodeLoader:
    """Reads node files for one interpretation of a program, each file only once.

    A bare name is looked for in what the program generates, in the output folder and the folder
    of nodes there that are built, in the program's folder and in the working folder; a path is
    relative to the program's folder. What is found outside of the project is not read unless the
    project is trusted.

    A file that the program itself made on an earlier run stands for what the program started
    from then, with what was changed by hand since.
    """

    def __init__(
        self,
        folder: Path,
        output: Path,
        boundary: Boundary,
        rendered: Callable[[Generation], Rendered | None],
        program: str = "",
        text: bytes = b"",
        files: FilesRead | None = None,
    ) -> None:
        """Set where files are looked for.

        Args:
            folder: the program's folder.
            output: the output folder.
            boundary: the project, which no `load` leaves unless it is trusted.
            rendered: makes the files of an earlier `generate_node` of the program; the last is the
                stem of the main file where the node is not written yet.
            program: the name of the program's file, "" where it has none.
            text: the program.
            files: what earlier loaders have read.
        """
        self._folder = folder
        self._output = output
        self._boundary = boundary
        self._rendered = rendered
        self._program = program
        self._text = text
        self._files = files or FilesRead()
        self._loaded: set[Path] = set()
        # By the object, which is kept beside: nodes have no hash.
        self._made: dict[int, tuple[Generation, _Made | None]] = {}

    def __call__(self, request: LoadRequest) -> Loaded:
        """Read the file that a `load` asks for."""
        if "\0" in request.source:
            return _failed(codes.FILE_NOT_FOUND, "a path holds no NUL character")
        if not request.is_path:
            for loaded in self._generated(request):
                return loaded
        candidates = list(self._candidates(request))
        for index, path in enumerate(candidates):
            # The functions of `os.path` take a path that is too long for one that is not there.
            is_there = request.is_path or os.path.lexists(path)
            if is_there and not self._boundary.allows(path):
                return _outside(request, path, self._boundary)
            if self._boundary.allows(path.parent):
                self._files.settle(path.parent)
            if os.path.isdir(path):  # noqa: PTH112
                return _failed(codes.UNREADABLE_FILE, f"`{path.name}` is a folder")
            if os.path.isfile(path):  # noqa: PTH113
                return self._in_front(path, candidates[index + 1 :])
        return self._not_found(request)

    def forget_others(self) -> None:
        """Forget what earlier loaders have read of files that this one was not asked for."""
        self._files.keep(self._loaded)

    def _in_front(self, path: Path, others: Sequence[Path]) -> Loaded:
        """Read a file; warn where it hides another, and nothing tells whose it is."""
        loaded = self._read_once(path)
        there = (other for other in others if os.path.isfile(other))  # noqa: PTH113
        others = [other for other in there if not self._is_written(other)]
        if not others or loaded.source is None or path.parent != self._output:
            return loaded
        manifest, _ = self._files.manifest(path.parent)
        if path.name in manifest or path.name in manifest.layers:
            return loaded
        warning = Diagnostic(
            codes.HIDDEN_FILE,
            f"`{path.name}` is the one of the output folder, and hides `{others[0]}`",
            help=f"remove `{path}` if an earlier run wrote it, or load the other by its path",
        )
        return loaded._replace(diagnostics=(*loaded.diagnostics, warning))

    def _is_written(self, path: Path) -> bool:
        """Tell whether a file is among those that are built, and an earlier run wrote it."""
        if path.parent != self._output / BUILT_FOLDER:
            return False
        known, _ = self._files.manifest(path.parent)
        made, _ = self._files.manifest(self._output)
        return path.name in known.layers or f"{BUILT_FOLDER}/{path.name}" in made

    def _generated(self, request: LoadRequest) -> Iterator[Loaded]:
        for generation in reversed(request.generated):
            node, source = generation.node, generation.node.source
            # Rendering costs more than asking for the name: a node's name starts its file's.
            if request.source.startswith(node.name if source is None else source.path.stem):
                made = self._made_by(generation)
                if made is not None and request.source in made[0]:
                    yield made[1]

    def _made_by(self, generation: Generation) -> _Made | None:
        """Return what a `load` may call the file of a `generate_node`, and what it gets."""
        key = id(generation)
        if key not in self._made:
            self._made[key] = generation, self._make(generation)
        return self._made[key][1]

    def _make(self, generation: Generation) -> _Made | None:
        rendered, source = self._rendered(generation), generation.node.source
        if rendered is None:
            return None
        path, files, new = rendered
        names = (path.stem, new)
        if source is None:
            return names, read_node(path, files)
        origin = _chained(source)
        if origin.turns > _MOST_TURNS:
            reason = f"the program generates and loads it more than {_MOST_TURNS} times in turn"
            return names, _failed(codes.UNREADABLE_FILE, f"`{path.name}` is not read: {reason}")
        return names, _with_origin(read_node(path, files), origin)

    def _candidates(self, request: LoadRequest) -> Iterator[Path]:
        if request.is_path:
            yield self._folder / os.path.expanduser(request.source)  # noqa: PTH111
            return
        built = self._output / BUILT_FOLDER
        for folder in dict.fromkeys((self._output, built, self._folder, Path.cwd())):
            for suffix in _suffixes():
                yield folder / f"{request.source}{suffix}"

    def _read_once(self, path: Path) -> Loaded:
        self._loaded.add(path)
        try:
            status = path.stat()
            if status.st_size > LARGEST_FILE:
                limit = LARGEST_FILE // (1024 * 1024)
                message = f"`{path.name}` is larger than {limit} MB, which no node is"
                return _failed(codes.UNREADABLE_FILE, message)
            started = self._started(path)
            if started is not None:
                return started
            known = self._files.nodes.get(path)
            if known is None or any(stamp_of(each) != stamp for each, stamp in known[0].items()):
                stamps: Stamps = {path: stamp_of(path)}
                files = with_others(path, read_regular(path, LARGEST_FILE), stamps)
                known = stamps, read_node(path, files, stamps)
                self._files.nodes[path] = known
            return known[1]
        except OSError as error:
            return _failed(codes.UNREADABLE_FILE, f"`{path.name}` cannot be read: {reason(error)}")

    def _started(self, path: Path) -> Loaded | None:
        """Read what the program started from when it wrote a file, None where it did not."""
        manifest = Path(os.path.realpath(path)).parent / MANIFEST
        if not self._program or not manifest.is_file():
            return None
        known = self._files.starts.get(path)
        if known is not None and known.is_current(self._author):
            return known.loaded
        from plastron_tui.generating.restore_base import find_start
        from plastron_tui.model.source import place_of

        manifests, may_read = self._files.manifest, self._boundary.allows
        start = find_start(path, self._author, lambda folder: manifests(folder)[0], may_read)
        files = [path, manifest]
        loaded = None
        stamps: Stamps = {}
        if start is not None:
            files += [start.path.parent / MANIFEST]
            for main in (start.path, path):
                files += [place_of(main, name) for name in start.files.names]
            loaded = _with_origin(read_node(start.path, start.files, stamps), start.origin)
        stamps.update({file: stamp_of(file) for file in files})
        self._files.starts[path] = _Known(loaded, self._author, stamps)
        return loaded

    @cached_property
    def _author(self) -> Author:
        from plastron_tui.output.manifest import digest
        from plastron_tui.output.patch_stack import Author

        return Author(self._program, digest(self._text), self._folder)

    def _not_found(self, request: LoadRequest) -> Loaded:
        if request.is_path:
            path = self._folder / request.source
            suffixes = set(_suffixes())
            near = missing(request.source, path, lambda each: each.suffix in suffixes)
            return _not_there(
                f"no file `{request.source}` beside the program",
                near.remedy,
                None if near.name is None or "'" in near.name else f"'{near.name}'",
            )
        folders = (self._output, self._output / BUILT_FOLDER, self._folder)
        known = {name for folder in folders for name in _names(folder)}
        name = nearest(request.source, sorted(known))
        names = " or ".join(f"`{request.source}{suffix}`" for suffix in _suffixes())
        return _not_there(
            f"no file {names} in the output folder, the program's folder or the working folder",
            None if name is None else f"did you mean `{name}`?",
            name if name is not None and name.isidentifier() and name.isascii() else None,
        )


class _Known(NamedTuple):
    """What was made of files for a program, and each file's stamp then."""

    loaded: Loaded | None
    author: Author
    stamps: Stamps

    def is_current(self, author: Author) -> bool:
        """Tell whether it is what would be made of the files now."""
        return author == self.author and all(
            stamp_of(path) == stamp for path, stamp in self.stamps.items()
        )


def read_node(path: Path, files: FileSet, stamps: Stamps | None = None) -> Loaded:
    """Read the files of a node.

    Args:
        path: the main file.
        files: what they hold.
        stamps: gets the stamps of what else was read.
    """
    from plastron_tui.targets import read_source

    result = read_source(path, files)
    if stamps is not None:
        stamps.update({each: stamp_of(each) for each in result.beside})
    return Loaded(result.source, result.diagnostics)


def with_others(path: Path, text: bytes, stamps: Stamps | None = None) -> FileSet:
    """Return a file's text with those of the files that belong to it, as far as they are there.

    Args:
        path: the file.
        text: what it holds.
        stamps: gets the stamps of the others, as they were before they were read.
    """
    from plastron_tui.targets import files_of

    def read(other: Path) -> bytes | None:
        if stamps is not None:
            stamps[other] = stamp_of(other)
        with suppress(OSError):
            return read_once(other, LARGEST_FILE)
        return None

    return files_of(path, text, read)


def _with_origin(loaded: Loaded, origin: Origin) -> Loaded:
    source = loaded.source
    return loaded if source is None else loaded._replace(source=source._replace(origin=origin))


def _chained(source: SourceUnit) -> Origin:
    from plastron_tui.generating.restore_base import chained

    return chained(source)


def _suffixes() -> Iterator[str]:
    """Yield the suffixes that a `load` of a bare name stands for, one a language."""
    from plastron_tui.targets import languages

    return (language.suffix for language in languages())


def _names(folder: Path) -> list[str]:
    try:
        suffixes = set(_suffixes())
        files = [file for file in folder.iterdir() if file.suffix in suffixes]
    except OSError:
        return []
    return sorted(file.stem for file in files)


def _failed(code: Code, message: str, remedy: str | None = None) -> Loaded:
    return Loaded(None, (Diagnostic(code, message, help=remedy),))


def _outside(request: LoadRequest, path: Path, boundary: Boundary) -> Loaded:
    """Say that a path leads out of the project, whether or not anything is there."""
    where = "" if request.is_path else f" is `{path}`, which"
    message = f"`{request.source}`{where} is {boundary.place_of(path)}"
    return _failed(codes.OUTSIDE_PROJECT, message, boundary.remedy)


def _not_there(message: str, remedy: str | None, right: str | None) -> Loaded:
    """Say that no file has a name, what may help, and how the one that may be meant is written."""
    return Loaded(None, (Diagnostic(codes.FILE_NOT_FOUND, message, help=remedy),), right)
