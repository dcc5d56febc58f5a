"""Patches of C++ nodes as tables: what a change is to take out of their files and put in."""

from __future__ import annotations

from difflib import ndiff
from pathlib import Path

from plastron_tui.diagnostics import Diagnostic
from plastron_tui.model.source import Change, FileSet, SourceUnit
from plastron_tui.ros.catalog import Catalog
from plastron_tui.sources import find_language
from plastron_tui.sources.cpp.editing.editor import edit_cpp

CATALOGS = {1: Catalog("noetic"), 2: Catalog("jazzy")}
LIBRARIES = {"roscpp": 1, "nodelet": 1, "rclcpp": 2, "component": 2}


def sides(patch: str) -> tuple[FileSet, FileSet]:
    """Return the files before and after a patch.

    A line of it begins with a blank, or with `-` or `+` where it goes or comes. A line
    `=== x.hpp` begins another file; the first one is the source.
    """
    names = ["{}.cpp"]
    texts: list[tuple[list[str], list[str]]] = [([], [])]
    for line in patch.removeprefix("\n").splitlines(keepends=True):
        if line.startswith("=== "):
            names.append(line[4:].strip())
            texts.append(([], []))
            continue
        assert line[0] in " -+\n", line
        for at, own in enumerate("-+"):
            if line[0] in (own, " "):
                texts[-1][at].append(line[1:])
            elif line[0] == "\n":
                texts[-1][at].append(line)
    files = [
        FileSet(tuple((n, "".join(t[at]).encode()) for n, t in zip(names, texts, strict=True)))
        for at in (0, 1)
    ]
    return files[0], files[1]


def read(files: FileSet) -> SourceUnit:
    """Read the nodes of files."""
    source = find_language("cpp").read(Path("x.cpp"), files).source
    assert source is not None
    return source


def edit(files: FileSet, *changes: Change) -> tuple[FileSet | None, tuple[Diagnostic, ...]]:
    """Change files; return what they are then, None for a refusal, and what is told."""
    source = read(files)
    rendered = edit_cpp(source, changes, CATALOGS[LIBRARIES[source.library]])
    return rendered.files, rendered.diagnostics


def shown(files: FileSet | None) -> str:
    """Return the texts of files, one after the other."""
    assert files is not None
    return "\n".join(f"=== {name}\n{text.decode()}" for name, text in files.texts)


def check(patch: str, *changes: Change) -> tuple[Diagnostic, ...]:
    """Hold what changes do to files against a patch, and return what is told."""
    before, after = sides(patch)
    files, told = edit(before, *changes)
    assert files is not None, [each.message for each in told]
    wanted, found = shown(after), shown(files)
    assert found == wanted, "\n" + "\n".join(ndiff(wanted.split("\n"), found.split("\n")))
    return told


def refusal(text: str, *changes: Change) -> str:
    """Return why changes are refused."""
    before, _ = sides(text)
    files, told = edit(before, *changes)
    assert files is None
    return "\n".join(f"{each.code}: {each.message}" for each in told)
