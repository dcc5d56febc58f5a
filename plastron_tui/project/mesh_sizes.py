"""How large the meshes are that robots have: found in the project and in installed packages."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from itertools import islice
from pathlib import Path
from typing import TYPE_CHECKING

from plastron_tui.regular_files import Stamp, stamp_of
from plastron_tui.ros.robots.description import Description, Mesh, Vector

if TYPE_CHECKING:
    from plastron_tui.boundary import Boundary
    from plastron_tui.runtime.meshes import Bounds, Patience
    from plastron_tui.sources.urdf.reach import Place, Reach

_MOST = 2_000
_MOST_DRAWN = 200
_MOST_FOLDERS = 16
_NAMED = re.compile(rb'\bmesh +(?:uri *= *)?"([^"\\\n]+)"')


@dataclass(slots=True)
class KnownMeshes:
    """What was measured, for what comes later.

    Attributes:
        bounds: the boxes around meshes, by their files as they were then.
        reach: where files are looked for, None where nobody has asked yet.
    """

    bounds: dict[tuple[Path, Stamp], Bounds] = field(default_factory=dict)
    reach: Reach | None = None


class MeshSizes:
    """Measures meshes by their URIs.

    A path that is no whole one starts from a folder with a robot's file, or from the program's.
    """

    def __init__(
        self,
        folder: Path,
        boundary: Boundary,
        environ: Mapping[str, str],
        known: KnownMeshes,
        program: bytes = b"",
    ) -> None:
        """Set where meshes are looked for.

        Args:
            folder: the program's folder.
            boundary: the project.
            environ: the environment variables that say which ROS is sourced.
            known: what earlier ones have measured.
            program: the program; the meshes that it seems to name are measured with the first.
        """
        self._folders = [folder.absolute()]
        self._boundary = boundary
        self._environ = environ
        self._known = known
        self._is_reach_new = False
        self._patience: Patience | None = None
        self._program = program

    def add_folder(self, folder: Path) -> None:
        """Look for meshes beside a robot's file, too, and there first."""
        folder = folder.absolute()
        if folder not in self._folders and len(self._folders) < _MOST_FOLDERS:
            self._folders.insert(0, folder)

    def bounds(self, uri: str) -> tuple[Vector, Vector] | None:
        """Return the lowest and the highest corner of a mesh, None where nobody knows them.

        They are in metres where the file says what its unit is, else in its lengths.
        """
        found = self._measured([uri, *self._expected()])[uri]
        return None if found.reason else (found.least, found.most)

    def _expected(self) -> Iterator[str]:
        """Yield once what may be asked for next: a process for each mesh takes longest to start."""
        program, self._program = self._program, b""
        for each in islice(_NAMED.finditer(program), _MOST_DRAWN):
            yield each.group(1).decode(errors="replace")

    def outermost(self, robot: Description) -> dict[str, tuple[Vector, ...]]:
        """Return points of a robot's meshes whose hulls are about theirs, as far as known.

        They are the lowest and the highest corner where no more is known. All are measured at
        once, as that is quicker.
        """
        shapes = (
            body.shape
            for link in robot.links.values()
            for body in (*link.visuals, *link.collisions)
        )
        uris = dict.fromkeys(each.uri for each in shapes if isinstance(each, Mesh))
        measured = self._measured(list(islice(uris, _MOST_DRAWN)))
        return {
            uri: each.points or (each.least, each.most)
            for uri, each in measured.items()
            if not each.reason
        }

    def problem(self, uri: str) -> tuple[str, str | None]:
        """Say why nobody knows how large a mesh is, "" where that is known, and what to do."""
        from plastron_tui.runtime.meshes import REMEDY

        found = self._measured([uri])[uri]
        return found.reason, REMEDY if found.is_unable else None

    def _measured(self, uris: list[str]) -> dict[str, Bounds]:
        from plastron_tui.runtime.meshes import Bounds, Patience, measure

        self._patience = self._patience or Patience()
        places = {uri: self._place(uri) for uri in uris}
        stamps = {each.path: stamp_of(each.path) for each in places.values() if each.path}
        known = self._known.bounds
        found = {
            path: known[path, stamp]
            for path, stamp in stamps.items()
            if stamp is not None and (path, stamp) in known
        }
        new = [path for path in stamps if path not in found]
        for path, bounds in zip(new, measure(new, self._patience), strict=True):
            found[path] = bounds
            stamp = stamps[path]
            # What measures them may be installed meanwhile, and the next time has time again.
            if stamp is not None and not (bounds.is_unable or bounds.is_late):
                if len(known) >= _MOST:
                    known.clear()
                known[path, stamp] = bounds
        return {
            uri: Bounds(reason=f"it {place.problem}") if place.path is None else found[place.path]
            for uri, place in places.items()
        }

    def _place(self, uri: str) -> Place:
        """Return where a mesh is; packages are looked for anew where they are not known."""
        place = self._find(uri)
        if place.path is None and not self._is_reach_new:
            self._known.reach = None
            place = self._find(uri)
        return place

    def _find(self, uri: str) -> Place:
        if self._known.reach is None:
            from plastron_tui.sources.urdf.reach import find_reach

            # Packages beside the robot's file go before others of their names.
            beside = self._folders[0] / "robot.urdf"
            self._known.reach = find_reach(self._boundary, beside, self._environ)
            self._is_reach_new = True
        reach = self._known.reach
        places = [reach.find(uri, folder) for folder in self._folders]
        return next((each for each in places if each.path is not None), None) or (
            self._to_be_copied(uri, reach) or places[0]
        )

    def _to_be_copied(self, uri: str, reach: Reach) -> Place | None:
        """Return where a mesh of a package is that the program is yet to make, None for none."""
        from plastron_tui.sources.urdf.reach import package_of

        package = package_of(uri)
        if package is None or not package[1] or package[1].startswith("/"):
            return None
        there = reach.package(package[0])
        if there is not None and not self._boundary.contains(there):
            return None
        places = (reach.find(package[1], folder) for folder in self._folders)
        return next((each for each in places if each.path is not None), None)
