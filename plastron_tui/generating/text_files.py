"""Files that a program makes as a whole, of packages say, brought together with handwork.

What such a file was made as is remembered with it: where it was changed by hand since, lines are
merged three ways, and what both sides changed is a conflict.
"""

from __future__ import annotations

import os
from collections.abc import Collection, Iterable, Mapping
from dataclasses import replace
from pathlib import Path
from typing import NamedTuple

from plastron_tui.diagnostics import Diagnostic, Severity, codes
from plastron_tui.model.package_source import PackageSource
from plastron_tui.output.manifest import Manifest
from plastron_tui.output.merge3 import Merge, MergedText, merge_lines
from plastron_tui.output.plan import OutputFile
from plastron_tui.sources.packages.reading import CMAKE_LISTS, PACKAGE_XML
from plastron_tui.targets.packages.spec import PackageFile

from .user_edits import kept_handwork, of_other_program, on_disk, unmergeable

_TEXT = "text"
_LISTS = (PACKAGE_XML, CMAKE_LISTS)
"""The files that nodes of several programs, and of hands, are entered in."""

SAME_LINES = "the program changed the same lines"
"""Why lines cannot be merged."""

_NOWHERE_ELSE: Mapping[str, Path] = {}
_BY_LINES: Mapping[str, Merge] = {}


def entry_of(path: Path, output: Path) -> str:
    """Return what the manifest of an output folder calls a file that is elsewhere."""
    return os.path.relpath(path, output).replace(os.sep, "/")


class Folder(NamedTuple):
    """Where files are written, and what is known of what is there.

    Attributes:
        output: the output folder.
        manifest: what is remembered of its files.
        program: the name of the program's file, "" where it has none.
        force: whether files are written anew, whatever was changed by hand.
    """

    output: Path
    manifest: Manifest
    program: str
    force: bool = False


def text_files(
    files: Mapping[str, PackageFile],
    folder: Folder,
    places: Mapping[str, Path] = _NOWHERE_ELSE,
    merges: Mapping[str, Merge] = _BY_LINES,
) -> tuple[list[OutputFile], list[Diagnostic]]:
    """Return files as they are to be written, and what is to be said of handwork in them.

    Args:
        files: what the program makes, by the path in the output folder.
        folder: where they go.
        places: the folders that packages are written into instead, by their names.
        merges: how those are merged that need not go by lines, by the path in the output folder.
    """
    made: list[OutputFile] = []
    notes: list[Diagnostic] = []
    for name, file in files.items():
        place = places.get(name.partition("/")[0])
        entry = name if place is None else entry_of(place / name, folder.output)
        output, found = _text_file(entry, file, folder, merges.get(name))
        if place is not None:
            output = replace(output, name=name, path=place / name, entry=entry, seen=())
        made.append(output)
        notes += found
    return made, notes


def left_files(
    written: Iterable[OutputFile], folder: Folder, own: Collection[str] = ()
) -> list[Diagnostic]:
    """Tell the files of packages that an earlier run of the program wrote, and this one does not.

    Such are those of a node or a launch file that has another name now, and those of a node that
    was in no package then. Of a package that has another name itself all are told in one.

    Args:
        written: the files of this run that are in the output folder.
        folder: where they go.
        own: the packages of the program. What stays of one that is written elsewhere, where it
            was loaded, is no rest.
    """
    files = list(written)
    names = {each.name for each in files}
    packaged = {_node_of(each.base or {}) for each in files if "/" in each.name} - {None}
    packages = {name.partition("/")[0] for name in names if "/" in name}
    elsewhere = {os.pardir, *own} - packages
    told: dict[str, Diagnostic] = {}
    for name, base in folder.manifest.bases.items():
        package = name.partition("/")[0]
        is_left = package not in elsewhere if "/" in name else _node_of(base) in packaged
        if name in names or not is_left or base.get("program") != folder.program:
            continue
        if on_disk(folder.output / name) is not None:
            # The folders of a package that the output folder is are none.
            is_package = package not in packages and f"{package}/{PACKAGE_XML}" in folder.manifest
            left = package if is_package else name
            told[left] = _left(left, folder.output, is_package=is_package)
    return list(told.values())


def _left(left: str, output: Path, *, is_package: bool) -> Diagnostic:
    what = f"the package `{left}`" if is_package else f"`{left}`"
    remedy = "remove it by hand if nothing else needs it"
    return Diagnostic(
        codes.FILE_STAYS,
        f"{what} is of an earlier run of the program, and stays where it is",
        file=output / left,
        help=f"{remedy}: it is built with the others" if is_package else remedy,
        severity=Severity.WARNING,
    )


def _node_of(base: Mapping[str, object]) -> str | None:
    """Return the name of the node that a file was made for, None for a file of another kind."""
    node = base.get("node")
    return node if isinstance(node, str) else None


def _text_file(
    name: str, file: PackageFile, folder: Folder, merge: Merge | None
) -> tuple[OutputFile, list[Diagnostic]]:
    path, manifest = folder.output / name, folder.manifest
    text = file.text.decode("utf-8", "replace")
    base = {"program": folder.program, _TEXT: text}
    seen = ((folder.output, manifest),)
    new = OutputFile(name, file.text, file.is_executable, base=base, seen=seen)
    present = on_disk(path)
    if present in (None, file.text) or name not in manifest:
        return new, []
    known = manifest.bases.get(name, {})
    owner = known.get("program")
    if isinstance(owner, str) and owner and folder.program and owner != folder.program:
        return replace(new, problem=of_other_program(path, owner)), []
    if folder.force or manifest.has(name, present):
        return new, []
    before = known.get(_TEXT)
    merged = MergedText(None, SAME_LINES)
    if isinstance(before, str):
        merged = _merged(path, (before.encode(), file.text, present), merge)
    if merged.text is None:
        return replace(new, problem=unmergeable(path, merged.reason)), []
    kept = OutputFile(
        name,
        merged.text,
        file.is_executable,
        merged_from=present,
        has_handwork=True,
        base=base,
        seen=seen,
    )
    is_news = before != text
    return kept, [kept_handwork(path, path.name)] if is_news else []


def _merged(path: Path, texts: tuple[bytes, bytes, bytes], merge: Merge | None) -> MergedText:
    """Bring a file's handwork and its program together: what it was made as, is now, and holds."""
    before, _, present = texts
    if before.strip() and not present.strip():
        return MergedText(None, "nothing is left of it")
    found = None if merge is None else merge(path, *texts)
    if found is not None:
        return found
    return MergedText(merge_lines(*texts, is_list=path.name in _LISTS), SAME_LINES)


def changed_files(source: PackageSource, texts: Mapping[str, bytes]) -> list[OutputFile]:
    """Return the files of a package that have other texts now, to be written where they are."""
    return [
        OutputFile(
            f"{source.name}/{name}",
            text,
            is_executable=False,
            merged_from=source.texts.get(name),
            path=source.folder / name,
        )
        for name, text in texts.items()
        if text != source.texts.get(name)
    ]
