"""What nodes that were loaded, and have to be built, come to need of their packages.

A file that is changed in place may name types of packages that its own package does not find yet:
its CMakeLists.txt and package.xml get them, and lose them again when the node needs them no more.
The manifest remembers what came so, with package.xml: what was there before stays.
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from plastron_tui.diagnostics import Diagnostic, has_errors
from plastron_tui.model.source import FileSet
from plastron_tui.output.manifest import Manifest
from plastron_tui.output.plan import OutputFile
from plastron_tui.ros.package_keys import is_ros_package, key_of_header
from plastron_tui.sources.packages import (
    PACKAGE_XML,
    Came,
    Changed,
    add_needs,
    came_with,
    named_elsewhere,
    remove_needs,
)
from plastron_tui.sources.packages.reading import CMAKE_LISTS
from plastron_tui.targets.packages.built import linked_of

from .loaded_needs import known_packages
from .text_files import changed_files, entry_of

if TYPE_CHECKING:
    from plastron_tui.model.package_source import PackageSource
    from plastron_tui.sources.base import Language

    from .apply_changes import Library
    from .generation import Generated

_NEEDS = "needs"
"""The packages that came with the nodes of a package, by the file of the node."""

Memory = Mapping[str, Sequence[Came]]
"""What came with the nodes of a package, by their main files."""


class Needed(NamedTuple):
    """A package with what its nodes come to need.

    Attributes:
        texts: what its files hold.
        memory: what came with its nodes.
        diagnostics: what there is to say; where something is refused, nothing has changed.
    """

    texts: Mapping[str, bytes]
    memory: Memory
    diagnostics: tuple[Diagnostic, ...] = ()


def changed_in_place(
    made: Sequence[Generated], libraries: Mapping[str, Library], manifest: Manifest
) -> Iterator[tuple[Generated, Path]]:
    """Yield the loaded nodes that are built, and may come to need something, with their paths.

    Those are written over what they came from. One that needs less may be among them where the
    manifest has what came with a node.
    """
    is_remembered = any(_NEEDS in base for base in manifest.bases.values())
    for each in made:
        source = each.generation.node.source
        library = libraries.get(each.generation.library)
        if source is None or library is None or each.files is None or each.files.path is None:
            continue
        if library.target.language.is_built and (is_remembered or new_packages(each, library)):
            yield each, each.files.path


def loaded_from(
    source: PackageSource, made: Sequence[Generated], libraries: Mapping[str, Library]
) -> Iterator[tuple[Generated, Path]]:
    """Yield the nodes that are built, and were loaded from files of a package, with their paths."""
    folder = os.path.realpath(source.folder)
    for each in made:
        loaded, library = each.generation.node.source, libraries.get(each.generation.library)
        if loaded is None or library is None or each.files is None:
            continue
        if not library.target.language.is_built:
            continue
        inner = os.path.relpath(os.path.realpath(loaded.path), folder)
        if inner.replace(os.sep, "/") in source.texts:
            yield each, source.folder / inner


def new_packages(generated: Generated, library: Library) -> list[str]:
    """Return the packages whose headers a loaded node includes that it did not before."""
    loaded, files = generated.generation.node.source, generated.files
    assert loaded is not None, "it was loaded"
    assert files is not None, "it is written"
    language = library.target.language
    start = loaded.origin.files if loaded.origin is not None else loaded.files
    new = _headers(language, files.files) - _headers(language, start)
    return _packages(new, library)


def _packages(headers: Iterable[str], library: Library) -> list[str]:
    version, known = library.target.ros_version, known_packages(library)
    keys = {key_of_header(header, version, known) for header in headers}
    return sorted(x for x in keys if x is not None and is_ros_package(x, version, known))


def remembered(source: PackageSource, output: Path, manifest: Manifest) -> Memory:
    """Return what came with the nodes of a package, as far as the manifest tells."""
    base = manifest.bases.get(entry_of(source.folder / PACKAGE_XML, output), {})
    found = base.get(_NEEDS)
    nodes = found.items() if isinstance(found, dict) else ()
    return {file: list(_came(each)) for file, each in nodes if isinstance(each, dict)}


def _came(packages: Mapping[object, object]) -> Iterator[Came]:
    for package, how in packages.items():
        match how:
            case {"linked": bool(linked), "found": bool(found), "tags": [*tags]}:
                name = str(package)
                yield Came(name, linked_of((name,))[0], linked, found, tuple(map(str, tags)))


def with_needs(
    source: PackageSource,
    texts: Mapping[str, bytes],
    nodes: Sequence[tuple[Generated, Path]],
    libraries: Mapping[str, Library],
    memory: Memory,
) -> Needed:
    """Return a package with what its nodes need, and without what came and they need no more.

    Args:
        source: the package.
        texts: what its files hold by now.
        nodes: its nodes that change, with their main files.
        libraries: the client libraries, by name.
        memory: what came with its nodes before.
    """
    found: list[Diagnostic] = []
    known, before = dict(memory), texts
    for each, path in nodes:
        library = libraries[each.generation.library]
        if library.target.ros_version != source.ros_version or each.files is None:
            continue
        file = os.path.relpath(path, source.folder).replace(os.sep, "/")
        wanted = [x for x in new_packages(each, library) if x != source.name]
        all_of = _packages(_headers(library.target.language, each.files.files), library)
        others, needs = _others(source, nodes, each), {*wanted, *all_of}
        came = known.get(file, ())
        idle = [
            x
            for x in came
            if x.package not in needs and not any(named_elsewhere(others, (x.package,)))
        ]
        changed = remove_needs(source, texts, file, idle) if idle else Changed(dict(texts))
        left = [x for x in came if x not in idle]
        if changed.texts is not None and wanted:
            start = changed.texts
            linked = [linked_of((x,))[0] for x in wanted]
            changed = add_needs(source, start, file, wanted, linked)
            had = {x.package for x in left}
            left += [x for x in came_with(source, start, changed, wanted, linked)
                     if x.package not in had]  # fmt: skip
        span = each.generation.span
        found += (x if x.file or x.span else x._replace(span=span) for x in changed.diagnostics)
        if changed.texts is not None:
            texts = dict(changed.texts)
            known[file] = left
    if has_errors(found):
        return Needed(before, memory, tuple(found))
    return Needed(texts, {file: each for file, each in known.items() if each}, tuple(found))


def _others(
    source: PackageSource, nodes: Sequence[tuple[Generated, Path]], but: Generated
) -> dict[str, bytes]:
    """Return what the files of a package hold, as its nodes change, but for those of one node."""
    found = dict(source.texts)
    for each, path in nodes:
        for name, text in each.files.files.texts if each.files is not None else ():
            file = path.parent / name.replace("{}", path.stem)
            inner = os.path.relpath(file, source.folder).replace(os.sep, "/")
            found[inner] = text
            if each is but:
                del found[inner]
    lists = (PACKAGE_XML, CMAKE_LISTS)
    return {name: text for name, text in found.items() if name not in lists}


def needed_files(
    source: PackageSource,
    nodes: Sequence[tuple[Generated, Path]],
    libraries: Mapping[str, Library],
    output: Path,
    manifest: Manifest,
) -> tuple[list[OutputFile], list[Diagnostic]]:
    """Return the files of a package that change for what its nodes come to need.

    Args:
        source: the package.
        nodes: its nodes that change, with their main files.
        libraries: the client libraries, by name.
        output: the output folder.
        manifest: what is remembered of its files.
    """
    memory = remembered(source, output, manifest)
    needed = with_needs(source, source.texts, nodes, libraries, memory)
    files = changed_files(source, needed.texts)
    return remember(files, source, needed.memory, memory, output), list(needed.diagnostics)


def remember(
    files: Sequence[OutputFile],
    source: PackageSource,
    memory: Memory,
    before: Memory,
    output: Path,
) -> list[OutputFile]:
    """Return the files of a package that change, with what the manifest is to remember.

    Args:
        files: the files.
        source: the package.
        memory: what came with its nodes.
        before: what is remembered of that.
        output: the output folder.
    """
    from dataclasses import replace

    if {k: list(x) for k, x in memory.items()} == {k: list(x) for k, x in before.items()}:
        return list(files)
    path, name = source.folder / PACKAGE_XML, f"{source.name}/{PACKAGE_XML}"
    own = next((each for each in files if each.name == name), None)
    if own is None:
        text = source.texts[PACKAGE_XML]
        own = OutputFile(name, text, is_executable=False, merged_from=text, path=path)
    how = {
        file: {
            x.package: {"linked": x.is_linked, "found": x.is_found, "tags": list(x.tags)}
            for x in each
        }
        for file, each in memory.items()
    }
    own = replace(own, base={_NEEDS: how}, entry=entry_of(path, output))
    return [*(each for each in files if each.name != name), own]


def _headers(language: Language, files: FileSet) -> frozenset[str]:
    return frozenset().union(*(language.imports(text) for _, text in files.texts))
