"""The files that a robot's description names, for the package that contains it.

Meshes, and what xacro includes, are copied into the package, so that what is generated runs by
itself: they stand to the description as they stood where it comes from. What other packages have
stays there, and is depended on.
"""

from __future__ import annotations

import os
import re
from collections.abc import Collection, Iterator
from enum import Enum, auto
from functools import cached_property
from itertools import islice
from pathlib import Path
from posixpath import normpath
from typing import TYPE_CHECKING, NamedTuple
from urllib.parse import unquote

from plastron_tui.diagnostics import Diagnostic, Span, codes
from plastron_tui.generating.package_parts import Companion, Companions
from plastron_tui.model.robots import Robot
from plastron_tui.regular_files import read_regular
from plastron_tui.ros.robots.description import Mesh
from plastron_tui.runtime.meshes import KINDS
from plastron_tui.sources.launch.around import is_plain, own_package
from plastron_tui.sources.urdf.macros import read_includes
from plastron_tui.sources.urdf.reach import package_of
from plastron_tui.sources.xml.document import XmlDocument, read_xml
from plastron_tui.sources.xml.outline import MOST_BYTES
from plastron_tui.targets.packages.rendering import URDF_FOLDER

from .package_copy import MOST_BYTES as MOST_COPIED

if TYPE_CHECKING:
    from .configuration import Configuration

_MOST_NAMES = 1_000
_MOST_FILES = 200
_MOST_TOLD = 5
_MOST_AROUND = 100
_MESHES = frozenset(
    (*KINDS, ".stlb", ".mesh", ".ply", ".off", ".glb", ".gltf", ".fbx", ".3ds", ".wrl")
)
"""What the files end in that RViz, Gazebo or MoveIt take for a mesh."""

_IMAGES = (".png", ".jpg", ".jpeg", ".bmp", ".tga", ".dds", ".tif", ".tiff", ".gif", ".hdr")
_BESIDE = frozenset((".mtl", ".bin", *_IMAGES))
"""What the files end in that a mesh may name: materials, buffers and images."""

_HERE = "$(dirname)/"
_FILE = "file://"
_COMPUTED = ("${", "$(")
_PATTERN = frozenset("*?[")

_REFERENCES = {
    ".dae": re.compile(rb"<init_from>([^<>]{1,300})</init_from>"),
    ".obj": re.compile(rb"^mtllib[ \t]{1,20}([^\r\n]{1,300})", re.MULTILINE),
    ".gltf": re.compile(rb'"uri"\s{0,20}:\s{0,20}"([^"]{1,300})"'),
    # Bounded, so that no line takes longer the longer it is.
    ".mtl": re.compile(
        rb"^[ \t]{0,20}map_\w{1,40}[ \t]{1,20}(?:[^\r\n]{0,300}[ \t])?(\S{1,300})[ \t]{0,20}\r?$",
        re.MULTILINE,
    ),
}
"""Where meshes name other files.

COLLADA 1.4.1, `init_from`; Wavefront OBJ and MTL; glTF 2.0, `uri`.
"""


class _Left(Exception):  # noqa: N818 - control flow, from a name to what is told of it
    """Why a package does not get a file, and what to do."""

    def __init__(self, reason: str, remedy: str) -> None:
        self.reason, self.remedy = reason, remedy


class _Kind(Enum):
    """What a file is named as."""

    MESH = auto()
    INCLUDED = auto()
    OPENED = auto()
    """Read while macros were expanded, which happens in a trusted folder alone."""


class _Named(NamedTuple):
    """A file that a description names: how, what as, and where a relative path starts from."""

    name: str
    folder: Path
    kind: _Kind


class CompanionFinder:
    """Finds what the descriptions of robots name, within the project."""

    def __init__(self, configuration: Configuration) -> None:
        """Set where files are looked for: in the project, beyond which nothing is copied."""
        self._configuration = configuration

    def __call__(self, robot: Robot, package: str, span: Span) -> Companions:
        """Return what a robot needs in a package.

        Args:
            robot: the robot, which is not in the package yet.
            package: the package's name.
            span: the statement that puts it there.
        """
        search = _Search(robot, package, self._configuration)
        files: dict[str, Companion] = {}
        told: dict[str, Diagnostic] = {}
        for each in search.names():
            found = search.found(each)
            if isinstance(found, Companion):
                new = [found] if found.path in files else [found, *search.around(found)]
                refused = [left for one in new if (left := _put(files, one)) is not None]
                found = refused[0] if refused else None
            if found is not None:
                told.setdefault(each.name, _told(robot, each.name, found, span))
        notes = list(told.values())
        if len(notes) > _MOST_TOLD + 1:
            notes[_MOST_TOLD:] = [_told_more(robot, len(notes) - _MOST_TOLD, span)]
        return Companions(tuple(files.values()), frozenset(search.packages), tuple(notes))


def _put(files: dict[str, Companion], new: Companion) -> _Left | None:
    """Add a file to those of a package; return why it does not get it."""
    there = files.get(new.path)
    if there is None and len(files) >= _MOST_FILES:
        return _Left(f"does not get: it has {_MOST_FILES} files", "put it there by hand")
    if there not in (None, new):
        return _Left(f"does not get: it has another `{new.path}`", "rename one of them")
    files[new.path] = new
    return None


class _Search:
    def __init__(self, robot: Robot, package: str, configuration: Configuration) -> None:
        source = robot.source
        self._robot, self._package, self._boundary = robot, package, configuration.boundary
        self._program = configuration.folder.absolute()
        self._base = self._program if source is None else source.path.absolute().parent
        self._there = configuration.output / package
        self.packages: set[str] = set()

    def names(self) -> Iterator[_Named]:
        """Yield what the description names: meshes, and what its macros were made of."""
        seen: set[_Named] = set()
        for each in self._all_names():
            if len(seen) >= _MOST_NAMES:
                return
            if each not in seen:
                seen.add(each)
                yield each

    def _all_names(self) -> Iterator[_Named]:
        for link in self._robot.shown.links.values():
            for body in (*link.visuals, *link.collisions):
                if isinstance(body.shape, Mesh):
                    yield _Named(body.shape.uri, self._base, _Kind.MESH)
        source = self._robot.source
        if source is None or source.macros is None:
            return
        is_known = source.expanded is not None
        waiting = [(source.text, self._base)]
        files: set[Path] = set()
        while waiting and len(files) < _MOST_FILES:
            text, folder = waiting.pop()
            document = read_xml(text).document
            if document is None:
                continue
            for name, kind in _named_in(document, has_meshes=not is_known):
                is_computed = _PATTERN.intersection(name) or any(x in name for x in _COMPUTED)
                if is_known and is_computed and package_of(name) is None:
                    # What that comes to is among the files that were opened.
                    continue
                yield _Named(name, folder, kind)
                path = None if kind is _Kind.MESH else self._beside(name, folder)
                if path is not None and path not in files and os.path.isfile(path):  # noqa: PTH113
                    files.add(path)
                    waiting += _read(path)
        for path in source.opened if is_known else ():
            inner = os.path.relpath(path, self._base)
            is_near = inner.count(os.pardir) < 2 and os.path.isfile(path)  # noqa: PTH113
            if is_near and self._boundary.contains(Path(os.path.realpath(path))):
                yield _Named(inner, self._base, _Kind.OPENED)

    @cached_property
    def _roots(self) -> tuple[Path, ...]:
        """The folders that may be the package's, before it is made."""
        own = own_package(self._base / "robot.urdf")
        found = (own, self._base.parent, self._base, self._program)
        return tuple(dict.fromkeys(each for each in found if each is not None))

    def found(self, named: _Named) -> Companion | _Left | None:
        """Return the file that a name leads to, or why the package does not get it.

        None stands for one that another package has.
        """
        try:
            return self._companion(named)
        except _Left as left:
            return left

    def around(self, mesh: Companion) -> Iterator[Companion]:
        """Yield the materials and images that a mesh names, as far as they are there."""
        waiting = [mesh]
        seen = {mesh.path}
        while waiting and len(seen) < _MOST_AROUND:
            each = waiting.pop()
            pattern = _REFERENCES.get(os.path.splitext(each.path)[1].lower())  # noqa: PTH122
            if pattern is None or each.file is None:
                continue
            for text, folder in _read(each.file, MOST_COPIED):
                for found in islice(pattern.finditer(text), _MOST_AROUND):
                    name = unquote(found.group(1).decode("utf-8", "replace")).strip()
                    inner = normpath(f"{each.path}/../{name}")
                    path = self._beside(name, folder)
                    if path is None or inner in seen:
                        continue
                    try:
                        other = Companion(_checked(inner), self._allowed(path, _BESIDE))
                    except _Left:
                        # In a mesh, names of what is in it stand in the same places.
                        continue
                    seen.add(inner)
                    waiting.append(other)
                    yield other

    def _companion(self, named: _Named) -> Companion | None:
        name = named.name
        package = package_of(name)
        if package is not None and package[0] != self._package:
            if is_plain(package[0]) and not _is_computed(package[0]):
                self.packages.add(package[0])
            return None
        if package is not None:
            return self._own(package[1], named.kind)
        if "://" in name and not name.startswith(_FILE):
            return None
        path = self._beside(name, named.folder)
        if path is None:
            by_hand = f"put it there by hand, where `{URDF_FOLDER}` has the description"
            if _is_computed(name) or _PATTERN.intersection(name):
                raise _Left("cannot get: which file it is, macros say", by_hand)
            raise _Left("does not get: it is a place on this machine", "name it from the package")
        inner = normpath(f"{URDF_FOLDER}/{_slashes(os.path.relpath(path, self._base))}")
        return Companion(_checked(inner), self._of_kind(path, named.kind))

    def _own(self, inner: str, kind: _Kind) -> Companion:
        """Return a file of the package itself, which is not made yet, or was by an earlier run."""
        if _is_computed(inner):
            raise _Left("cannot get: which file it is, macros say", "put it there by hand")
        inner = _checked(normpath(inner or "."))
        for root in self._roots:
            if os.path.isfile(root / inner):  # noqa: PTH113
                return Companion(inner, self._of_kind(root / inner, kind))
        if (self._there / inner).is_file():
            return Companion(inner, None)
        raise _Left("does not get: it is not there", f"put it at `{inner}` beside the program")

    def _beside(self, name: str, folder: Path) -> Path | None:
        """Return where a path without a package leads, None where nobody knows, or it is whole."""
        name = name.removeprefix(_HERE)
        is_whole = name.startswith((_FILE, "/", "~")) or "://" in name
        if is_whole or "\0" in name or _is_computed(name) or _PATTERN.intersection(name):
            return None
        return Path(os.path.normpath(folder / name))

    def _of_kind(self, path: Path, kind: _Kind) -> Path:
        """Return a file that may be copied as what it is named as.

        A description may come from somebody else; what it names as a mesh is no reason to hand on
        any file of the project.
        """
        allowed = self._allowed(path, _MESHES if kind is _Kind.MESH else None)
        if kind is _Kind.INCLUDED and not any(read_xml(text).document for text, _ in _read(path)):
            raise _Left("does not get: it is no XML that can be read", "name the right file")
        return allowed

    def _allowed(self, path: Path, endings: Collection[str] | None) -> Path:
        if not os.path.isfile(path):  # noqa: PTH113 - a path that is too long is not there
            raise _Left("does not get: it is not there", "put it there")
        real = Path(os.path.realpath(path))
        if not self._boundary.contains(real):
            raise _Left("does not get: it is outside of the project", "copy it into the project")
        if endings is not None and any(x.suffix.lower() not in endings for x in (path, real)):
            kinds = ", ".join(f"`{each}`" for each in sorted(endings))
            raise _Left("does not get: it ends as no mesh does", f"meshes end in {kinds}")
        return path


def _checked(inner: str) -> str:
    """Return a path in the package, where its files are in folders.

    Raises:
        _Left: it is none.
    """
    first, _, rest = inner.partition("/")
    if not rest or first in ("", os.pardir, ".") or not inner.isprintable() or "\\" in inner:
        raise _Left("does not get: it would be in no folder of it", "keep it nearer to the robot")
    return inner


def _named_in(document: XmlDocument, *, has_meshes: bool) -> Iterator[tuple[str, _Kind]]:
    """Yield what the text of a file with macros names, in the places that are certain."""
    for include, _ in read_includes(document):
        if include.is_certain and not include.is_optional:
            yield include.file, _Kind.INCLUDED
    for element in document.root.walk() if has_meshes else ():
        if element.name == "mesh" and (name := element.get("filename")):
            yield name, _Kind.MESH


def _read(path: Path, most: int = MOST_BYTES) -> Iterator[tuple[bytes, Path]]:
    """Yield what a file holds, and its folder, where it can be read."""
    try:
        yield read_regular(path, most), path.parent
    except OSError:
        return


def _is_computed(name: str) -> bool:
    return any(each in name for each in _COMPUTED)


def _slashes(path: str) -> str:
    return path.replace(os.sep, "/")


def _told_more(robot: Robot, count: int, span: Span) -> Diagnostic:
    message = f"`{_file_of(robot)}` names {count} more files that the package does not get"
    return Diagnostic(
        codes.NOT_COPIED, message, span, help="see to those that are told, and generate again"
    )


def _file_of(robot: Robot) -> str:
    return f"{robot.stem}.urdf" if robot.source is None else robot.source.path.name


def _told(robot: Robot, name: str, left: _Left, span: Span) -> Diagnostic:
    message = f"`{_file_of(robot)}` names `{name}`, which the package {left.reason}"
    return Diagnostic(codes.NOT_COPIED, message, span, help=left.remedy)
