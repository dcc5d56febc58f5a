"""From the files of a folder to the facts that rules look at."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property, partial
from itertools import chain
from pathlib import Path
from typing import TypeVar

from plastron_tui.diagnostics import Diagnostic
from plastron_tui.lint.namesakes import nearest
from plastron_tui.lint.tree import LaunchFacts, PackageFacts, SourceTree, UnitFacts
from plastron_tui.ros.catalog import Catalog
from plastron_tui.ros.launch_names import launch_language
from plastron_tui.ros.launch_resolution import resolve
from plastron_tui.ros.launch_started import Opened, Started
from plastron_tui.ros.launch_text import Scope
from plastron_tui.ros.parameter_blocks import ParameterBlock
from plastron_tui.sources.grammars import bounding
from plastron_tui.sources.launch.xml_reader import LaunchRead
from plastron_tui.sources.still_disk import still_disk
from plastron_tui.sources.workspace_modules import Modules, modules_in, workspace_of

from .cache import FactCache, packed, unpacked
from .commented import commented_files
from .fingerprints import Digest, Reads, digest_of_names, noted
from .kept_diagnostics import diagnostics_of
from .launch_files import content_of, read_launch_file
from .listing import Listing, files_around, list_files, mark_of
from .packages import read_package, runnable
from .parameter_files import is_parameter_file, read_parameter_file, setting_places, unstarted
from .pool import Died, Pool
from .same_names import by_name, namesakes_of, same_names
from .started_places import started_places
from .tests_of_packages import is_test
from .unbuilt import is_ported, read_unbuilt, unbuilt_units
from .units import UnitAnswer, UnitRead, failure, read_unit

_USUAL = {1: "noetic", 2: "jazzy"}
"""The distribution whose types count where nothing else is said, by generation of ROS."""

T = TypeVar("T")

Progress = Callable[[int, int], None]
"""Is told how much of how much is done."""

_HEADERS = (".hpp", ".h")
_SOURCES = (".py", ".cpp", ".cc", ".cxx")
_FEWEST_AT_ONCE = 8


@bounding()
def read_tree(
    paths: Sequence[Path],
    cache: FactCache | None = None,
    workers: int | None = None,
    listing: Listing | None = None,
    progress: Progress | None = None,
) -> SourceTree:
    """Read the packages, nodes and launch files below folders; nothing of them is run.

    Args:
        paths: the folders, or files.
        cache: what was read before, by default that of the user; it is left as of this run.
        workers: how many processes read at the same time, by default one a core.
        listing: the files below the folders, where somebody has listed them.
        progress: is told how many files of nodes are read, and of how many.
    """
    whole = [Path(os.path.realpath(each)) for each in paths]
    listing = list_files(whole) if listing is None else listing
    cache = FactCache(listing.root, None, whole) if cache is None else cache
    cache.begin()
    reading = _Reading(listing, cache, progress)
    with still_disk(), workspace_of(reading.modules), Pool(read_unit, workers) as pool:
        units = tuple(reading.units(pool))
    packages = by_name(reading.packages)
    namesakes = namesakes_of(reading.packages)
    launches = tuple(reading.launches(packages, namesakes))
    parameters = dict(reading.parameter_files())
    named = dict(setting_places(launches, reading.unstarted))
    commented = tuple(commented_files(listing.files, reading.package_of, cache))
    others = (*reading.unstarted, *reading.unstarted_ros1)
    places = dict(started_places(launches, others, packages))
    cache.save()
    catalogs = {
        version: Catalog(distribution, type_folders=(listing.root,))
        for version, distribution in _USUAL.items()
    }
    return SourceTree(
        listing.root,
        packages,
        units,
        launches,
        catalogs,
        parameter_files=parameters,
        unstarted=tuple(reading.unstarted),
        unstarted_ros1=tuple(reading.unstarted_ros1),
        setting_places=named,
        started_places=places,
        is_whole=listing.is_whole and not reading.problems,
        problems=tuple((Path(path), why) for path, why in reading.problems),
        wrong=(*reading.wrong, *same_names(reading.packages, listing.root)),
        files=listing.files,
        commented=commented,
        namesakes=namesakes,
    )


@dataclass
class _Reading:
    """Reads what a listing has, each file only where it has changed."""

    listing: Listing
    cache: FactCache
    progress: Progress | None = None
    problems: list[tuple[str, str]] = field(default_factory=list)
    unstarted: list[Started] = field(default_factory=list)
    unstarted_ros1: list[Started] = field(default_factory=list)
    wrong: list[Diagnostic] = field(default_factory=list)
    _owners: dict[str, str] = field(default_factory=dict)

    def units(self, pool: Pool[UnitAnswer]) -> Iterator[UnitFacts]:
        """Yield what the files of nodes say.

        A header is read with the sources that include it, and by itself only where none does that
        makes a node.
        """
        sources = (each for each in self.listing.files if each.endswith(_SOURCES))
        found = dict(self._read_units(pool, chain(sources, self._programs())))
        parts = {part for each in found.values() for part in each.parts}
        headers = (each for each in self.listing.files if each.endswith(_HEADERS))
        found.update(self._read_units(pool, (each for each in headers if each not in parts)))
        folders = {str(each.folder): each.name for each in self.packages}
        builds = {str(each.folder): each.build for each in self.packages}
        ported = {str(each.folder) for each in self.packages if is_ported(each)}
        unbuilt = self._unbuilt(found)
        below = len(os.fspath(self.listing.root))
        for path in sorted(found):
            folder, facts = self.package_of(path), found[path].facts
            assert facts is not None
            is_left = facts.ros_version == 1 and folder in ported
            yield facts._replace(
                package=folders.get(folder, ""),
                is_test=is_test(path[below:], folder[below:], builds.get(folder)),
                is_unbuilt=is_left or path in unbuilt,
            )

    def _read_units(
        self, pool: Pool[UnitAnswer], paths: Iterable[str]
    ) -> Iterator[tuple[str, UnitRead]]:
        """Yield those of some files that have nodes, from the cache or from the disk."""
        missed: dict[str, list[str]] = {}
        for path in paths:
            if launch_language(path):
                continue
            known = self.cache.get(self._unit_key(path))
            if known is None:
                missed.setdefault(self.package_of(path), []).append(path)
            elif known[0] is not None:
                yield from self._taken(path, known[0])
        total = sum(map(len, missed.values()))
        for done, answer in enumerate(pool.map(_groups(missed.values(), pool.count)), 1):
            if self.progress is not None:
                self.progress(done, total)
            if isinstance(answer, Died):
                self.problems.append((answer.value, "the process that reads it is ended"))
            elif answer.problem:
                self.problems.append((answer.path, answer.problem))
            else:
                self.cache.put(self._unit_key(answer.path), answer.reads, answer.data)
                read: UnitRead | None = unpacked(answer.data)
                if read is not None:
                    yield from self._taken(answer.path, read)

    def _taken(self, path: str, read: UnitRead) -> Iterator[tuple[str, UnitRead]]:
        """Yield a file with nodes, and note what is wrong with it."""
        self.wrong += diagnostics_of(read.wrong)
        if read.facts is not None:
            yield path, read

    def _programs(self) -> Iterator[str]:
        """Yield the files of packages without a suffix that may be run: scripts may be among them.

        Their first line tells, see `language_of`.
        """
        for folder, names in self._files.items():
            bare = (each for each in names if "." not in each.rpartition("/")[2])
            yield from (f"{folder}/{each}" for each in sorted(runnable(folder, bare)))

    def _unbuilt(self, found: Mapping[str, UnitRead]) -> frozenset[str]:
        """Return the files of nodes that no build takes, so that nobody runs what they say."""

        def read(package: str, sources: frozenset[str]) -> frozenset[str]:
            names = self._files[package]
            names_of_both = self._names[package] + digest_of_names(iter(sources))
            reading = partial(read_unbuilt, package, names, sources)
            return self._once("unbuilt", package, reading, names_of_both) or frozenset()

        inner = frozenset(self.listing.inner)
        has_packages = bool(self.listing.packages)
        return unbuilt_units(
            found, self.package_of, inner=inner, has_packages=has_packages, read=read
        )

    def _unit_key(self, path: str) -> str:
        modules = self._names_of_modules if not path.endswith((*_HEADERS, *_SOURCES[1:])) else b""
        return _key("unit", path, self._names[self.package_of(path)] + modules)

    @cached_property
    def modules(self) -> Modules:
        """The Python modules of the packages, with the folders that have them."""
        inits = (each for each in self.listing.files if each.endswith("/__init__.py"))
        return modules_in(self.listing.packages, inits)

    @cached_property
    def _names_of_modules(self) -> Digest:
        """Return what tells which modules a package finds in others."""
        return digest_of_names(chain.from_iterable(self.modules.items()))

    @cached_property
    def packages(self) -> tuple[PackageFacts, ...]:
        """The packages."""
        return tuple(self._read_packages())

    def _read_packages(self) -> Iterator[PackageFacts]:
        for folder in self.listing.packages:
            names = self._files[folder]
            # A link to a program is one as well, where nodes are started from the workspace.
            links = (each[len(folder) + 1 :] for each in self._left_out.get(folder, ()))
            programs = runnable(folder, chain(names, links))
            read = partial(read_package, folder, names, programs)
            marks = digest_of_names(iter(programs))
            found = self._once("package", folder, read, self._names[folder] + marks)
            if found is None:
                continue
            self.wrong += diagnostics_of(found.wrong)
            if found.facts is not None:
                # Neither catkin nor colcon looks for packages within packages.
                is_inner = self.package_of(folder) != ""
                yield found.facts._replace(build=None) if is_inner else found.facts

    def _once(
        self, what: str, path: str, read: Callable[[], T | None], names: Digest = b""
    ) -> T | None:
        """Return what is read of a file, or was before; None where it cannot be read.

        Args:
            what: what is read.
            path: the file or folder.
            read: reads it.
            names: what tells which files there are that it may ask for.
        """
        key = _key(what, path, names)
        known: tuple[T | None] | None = self.cache.get(key)
        if known is None:
            reads = Reads({}, {})
            try:
                with noted(reads):
                    known = (read(),)
            except Exception as error:
                self.problems.append((path, failure(error)))
                return None
            self.cache.put(key, reads, packed(known[0]))
        return known[0]

    def launches(
        self,
        packages: Mapping[str, PackageFacts],
        namesakes: Mapping[str, Mapping[Path, PackageFacts]],
    ) -> Iterator[LaunchFacts]:
        """Yield what each launch file starts that no other one includes."""
        reads = {path: self._launch(path) for path in self.listing.files if launch_language(path)}
        included: set[str] = set()
        folders = {name: str(each.folder) for name, each in packages.items()}

        def folder_of(name: str, file: str) -> str | None:
            several = namesakes.get(name)
            if several is None:
                return folders.get(name)
            found = nearest(several, Path(file))
            return None if found is None else str(found)

        def opened(name: str) -> Opened:
            included.add(os.path.realpath(name))
            return read_of(name)

        def read_of(name: str) -> Opened:
            path = os.path.realpath(name)
            read = reads.get(path)
            if read is None or read.launch is None:
                return Opened(None, 2, "", "it is no launch file of the workspace")
            return Opened(read.launch, read.format.ros_version, os.path.dirname(path))

        found = []
        for path, read in reads.items():
            if read is not None and read.launch is not None:
                found_in = partial(folder_of, file=path)
                scope = Scope({}, {}, os.path.dirname(path), found_in, content_of)
                resolved = resolve(read.launch, read.format.ros_version, scope, path, opened)
                found.append(LaunchFacts(Path(path), resolved, read.format.ros_version))
                version = read.format.ros_version
                rest = unstarted(read.launch, version, scope, path, read_of, resolved)
                (self.unstarted if version == 2 else self.unstarted_ros1).extend(rest)
        yield from (each for each in found if str(each.path) not in included)

    def parameter_files(self) -> Iterator[tuple[Path, tuple[ParameterBlock, ...]]]:
        """Yield the parameter files of ROS 2 with what they say."""
        for path in filter(is_parameter_file, self.listing.files):
            found = self._once("parameters", path, partial(read_parameter_file, path))
            if found is not None:
                self.wrong += diagnostics_of(found.wrong)
                if found.blocks:
                    yield Path(path), found.blocks

    def _launch(self, path: str) -> LaunchRead | None:
        found = self._once("launch", path, partial(read_launch_file, path))
        if found is None:
            return None
        self.wrong += diagnostics_of(found.wrong)
        return found.read

    def package_of(self, path: str) -> str:
        """Return the folder of the package that a file is in, "" for none."""
        folder = os.path.dirname(path)
        if folder not in self._owners:
            above = os.path.dirname(folder)
            is_end = folder in self._package_set or above == folder
            owner = folder if folder in self._package_set else ""
            self._owners[folder] = owner if is_end else self.package_of(folder)
        return self._owners[folder]

    @cached_property
    def _package_set(self) -> frozenset[str]:
        return frozenset(self.listing.packages)

    @cached_property
    def _files(self) -> dict[str, frozenset[str]]:
        """Return the files of each package, by their paths in it."""
        found: dict[str, set[str]] = {each: set() for each in self.listing.packages}
        inner = tuple(f"{each}{os.sep}" for each in self.listing.inner)
        for path in self.listing.files:
            folder = self.package_of(path)
            if folder and not path.startswith(inner):
                found[folder].add(path[len(folder) + 1 :])
        return {folder: frozenset(names) for folder, names in found.items()}

    @cached_property
    def _names(self) -> dict[str, Digest]:
        """Return what tells which files a package has: one more may be what a name leads to.

        What is in no package may look for files anywhere, and in a package around all folders.
        """
        marks = {folder: map(mark_of, paths) for folder, paths in self._left_out.items()}
        found = {
            folder: digest_of_names(chain(names, marks.get(folder, ())))
            for folder, names in self._files.items()
        }
        everywhere = chain(map(mark_of, self.listing.left_out), files_around(self.listing.root))
        found[""] = digest_of_names(chain(self.listing.files, everywhere))
        return found

    @cached_property
    def _left_out(self) -> dict[str, list[str]]:
        """Return the links and files of each package that do not count."""
        found: dict[str, list[str]] = {}
        for path in self.listing.left_out:
            found.setdefault(self.package_of(path), []).append(path)
        return found


def _groups(packages: Iterable[list[str]], workers: int) -> Iterator[list[str]]:
    """Yield files, those of a package together, yet so that all workers have something to do."""
    waiting = list(packages)
    most = max(_FEWEST_AT_ONCE, sum(map(len, waiting)) // (workers * 4))
    for paths in sorted(waiting, key=len, reverse=True):
        for start in range(0, len(paths), most):
            yield paths[start : start + most]


def _key(what: str, path: str, names: Digest) -> str:
    return f"{what} {path} {names.hex()}"
