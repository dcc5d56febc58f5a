"""The files that a node becomes, with what is known of what they replace."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path, PurePath

from plastron_tui.diagnostics import Diagnostic
from plastron_tui.model.source import FileSet, place_of
from plastron_tui.output.manifest import Base, Manifest
from plastron_tui.output.patch_stack import Layers
from plastron_tui.output.plan import OutputFile


@dataclass(frozen=True, slots=True)
class NodeFiles:
    """The files of one node that are wanted; `OutputFile` explains what is not here.

    Attributes:
        name: the main file's name.
        files: what the files shall hold.
        is_executable: whether the main file gets the executable bit.
        merged_from: what the files hold now, where their texts were derived from that.
        path: where to write the main file instead of the output folder.
        has_handwork: whether the files keep what was written by hand.
        base: what the program has.
        problem: why the handwork that is there cannot be merged.
        layers: what programs made of the files.
        seen: the manifests that the files were made with, each with its folder.
    """

    name: str
    files: FileSet
    is_executable: bool = True
    merged_from: FileSet | None = None
    path: Path | None = None
    has_handwork: bool = False
    base: Base | None = None
    problem: Diagnostic | None = None
    layers: Layers | None = None
    seen: tuple[tuple[Path, Manifest], ...] = ()

    def output_files(self) -> Iterator[OutputFile]:
        """Yield the files, the main one first: with it is remembered what there is of the node."""
        first, *others = self.files.texts
        # By this a later run knows whose a file is that it no longer writes.
        part = None if self.base is None else {"program": self.base.get("program")}
        yield OutputFile(
            self.name,
            first[1],
            self.is_executable,
            None if self.merged_from is None else self.merged_from.main,
            self.path,
            self.has_handwork,
            self.base,
            self.problem,
            self.layers,
            self.seen,
        )
        for name, text in others:
            yield OutputFile(
                # What is written elsewhere may lie above the main file.
                name_of(self.name, name if self.path is None else name.replace("../", "")),
                text,
                is_executable=False,
                merged_from=None if self.merged_from is None else self.merged_from.get(name),
                path=None if self.path is None else place_of(self.path, name),
                has_handwork=self.has_handwork,
                base=part,
                problem=self.problem,
                seen=self.seen,
            )


def name_of(main: str, name: str) -> str:
    """Return what a file of a set is called in the folder of the set's main file."""
    return place_of(PurePath(main), name).as_posix()


def are_recorded(manifest: Manifest, main: str, files: FileSet | None) -> bool:
    """Tell whether Plastron wrote exactly these files."""
    if files is None:
        return False
    (_, text), *others = files.texts
    return manifest.has(main, text) and all(
        manifest.has(name_of(main, name), text) for name, text in others
    )
