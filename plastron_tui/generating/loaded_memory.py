"""What is remembered of the files that programs put into a package that exists."""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from .text_files import entry_of

if TYPE_CHECKING:
    from plastron_tui.model.package_source import PackageSource
    from plastron_tui.output.manifest import Manifest

DEPENDS = "depends"
"""The dependencies that came with a node's file, as the manifest remembers them."""


TAGS = "tags"
"""The elements of package.xml that came with a node's file, by dependency."""

FOUND = "found"
"""The packages that the build finds since a node's file came."""

INSTALLED = "installed"
"""Whether it was with a node's or a launch file that the package began to install it."""


@dataclass(frozen=True)
class FileMemory:
    """What is remembered of the files of a package.

    Attributes:
        source: the package.
        output: the output folder.
        manifest: what is remembered of its files.
        in_place: whether files are written where the package is.
    """

    source: PackageSource
    output: Path
    manifest: Manifest
    in_place: bool

    def remembered(self, file: str, what: str) -> object:
        """Return what the manifest has of a file, None where nothing tells."""
        for name in (self.entry(file), f"{self.source.name}/{file}"):
            if what in self.manifest.bases.get(name, {}):
                return self.manifest.bases[name][what]
        return None

    def is_in_place(self, file: str) -> bool:
        """Tell whether a file is written where the package is."""
        there = os.path.realpath(self.output / self.source.name / file)
        return self.in_place or there == os.path.realpath(self.source.folder / file)

    def is_own(self, file: str) -> bool:
        """Tell whether an earlier run wrote a file, where this one would write over it."""
        return self.is_in_place(file) and self.entry(file) in self.manifest

    def entry(self, file: str) -> str:
        """Return what the manifest calls a file that is written where the package is."""
        return entry_of(self.source.folder / file, self.output)

    def added(self, file: str) -> Mapping[str, bool] | None:
        """Return the dependencies that came with a file, None where nothing tells.

        Each with whether other files of the package named it then.
        """
        known = self.remembered(file, DEPENDS)
        if not isinstance(known, dict):
            return None
        return {key: value is True for key, value in known.items()}

    def tags(self, file: str | None) -> dict[str, tuple[str, ...]]:
        """Return the elements that came with a file, by dependency, as far as that is told."""
        known = None if file is None else self.remembered(file, TAGS)
        found = known.items() if isinstance(known, dict) else ()
        return {key: tuple(map(str, tags)) for key, tags in found if isinstance(tags, list)}

    def found(self, file: str | None) -> frozenset[str] | None:
        """Return the packages that the build finds since a file came, None where nothing tells."""
        known = None if file is None else self.remembered(file, FOUND)
        return frozenset(map(str, known)) if isinstance(known, list) else None
