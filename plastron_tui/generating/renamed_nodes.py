"""Nodes of a loaded package that the program calls otherwise now than when it put them there."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from plastron_tui.model.workspace import Node

from .text_files import entry_of

if TYPE_CHECKING:
    from plastron_tui.diagnostics import Span
    from plastron_tui.model.package_source import PackageSource
    from plastron_tui.model.packages import Package
    from plastron_tui.output.manifest import Base, Manifest

    from .generation import Generated


def renamed_nodes(
    package: Package, made: Sequence[Generated], output: Path, manifest: Manifest
) -> dict[str, Span]:
    """Return the names by which a package knows nodes that have another name now.

    A node was renamed where the program puts one more node of a client library into the package
    in place, and leaves out one that it has put there before, with its build.

    Args:
        package: the package, which was loaded.
        made: the files of the nodes that the program generates.
        output: the output folder.
        manifest: what is remembered of its files.
    """
    source = package.source
    assert source is not None, "the package was loaded"
    by_variable = {each.generation.node.variable: each for each in made}
    now: dict[str, tuple[Base, Span]] = {}
    for variable, contained in package.contents.items():
        generated = by_variable.get(variable)
        files = None if generated is None else generated.files
        if isinstance(contained.item, Node) and files is not None and files.base is not None:
            inner = files.name.removeprefix(f"{source.name}/")
            now[inner] = files.base, contained.span
    before = dict(_remembered(source, output, manifest))
    found: dict[str, Span] = {}
    for file, (base, span) in now.items():
        kind = base.get("library"), base.get("program")
        left = [
            name
            for name, known in before.items()
            if name not in now and (known.get("library"), known.get("program")) == kind
            if any(_installed(source, name))
        ]
        if not any(_installed(source, file)) and len(left) == 1:
            found.update((name, span) for name in _installed(source, left[0]))
    return found


def _remembered(
    source: PackageSource, output: Path, manifest: Manifest
) -> Iterator[tuple[str, Base]]:
    """Yield the main files of nodes that the package began to build with, and what there was."""
    folder = f"{entry_of(source.folder, output)}/"
    for entry, base in manifest.bases.items():
        if entry.startswith(folder) and base.get("installed") is True and "node" in base:
            yield entry.removeprefix(folder), base


def _installed(source: PackageSource, file: str) -> Iterator[str]:
    """Yield the names by which a package installs a file, or what is built of it."""
    known: Mapping[str, object] = {**source.executables, **source.plugins}
    for name in known:
        each = source.installed(name)
        if file in (each.file, *each.sources):
            yield name
