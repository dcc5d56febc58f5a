"""What nodes that were loaded, and have to be built, come to need of their packages.

A file that is changed in place may name types of packages that its own package does not find yet:
its CMakeLists.txt and package.xml get them. What a program loads as a package is changed there.
"""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from plastron_tui.diagnostics import Diagnostic, has_errors
from plastron_tui.model.source import FileSet
from plastron_tui.output.plan import OutputFile
from plastron_tui.ros.package_keys import is_ros_package, key_of_header
from plastron_tui.sources.packages import add_needs
from plastron_tui.targets.packages.built import linked_of

from .loaded_needs import known_packages
from .text_files import changed_files

if TYPE_CHECKING:
    from plastron_tui.model.package_source import PackageSource
    from plastron_tui.sources.base import Language

    from .apply_changes import Library
    from .generation import Generated


def changed_in_place(
    made: Sequence[Generated], libraries: Mapping[str, Library]
) -> Iterator[tuple[Generated, Path]]:
    """Yield the loaded nodes that are built, and come to need something, with their paths.

    Those are written over what they came from.
    """
    for each in made:
        source = each.generation.node.source
        library = libraries.get(each.generation.library)
        if source is None or library is None or each.files is None or each.files.path is None:
            continue
        if library.target.language.is_built and new_packages(each, library):
            yield each, each.files.path


def new_packages(generated: Generated, library: Library) -> list[str]:
    """Return the packages whose headers a loaded node includes that it did not before."""
    loaded, files = generated.generation.node.source, generated.files
    assert loaded is not None, "it was loaded"
    assert files is not None, "it is written"
    language, version = library.target.language, library.target.ros_version
    known = known_packages(library)
    start = loaded.origin.files if loaded.origin is not None else loaded.files
    new = _headers(language, files.files) - _headers(language, start)
    keys = {key_of_header(header, version, known) for header in new}
    return sorted(x for x in keys if x is not None and is_ros_package(x, version, known))


def needed_files(
    source: PackageSource,
    nodes: Sequence[tuple[Generated, Path]],
    libraries: Mapping[str, Library],
) -> tuple[list[OutputFile], list[Diagnostic]]:
    """Return the files of a package that change for what its nodes come to need.

    Args:
        source: the package.
        nodes: its nodes that change, with their main files.
        libraries: the client libraries, by name.
    """
    texts: dict[str, bytes] = dict(source.texts)
    found: list[Diagnostic] = []
    for each, path in nodes:
        library = libraries[each.generation.library]
        if library.target.ros_version != source.ros_version:
            continue
        packages = [x for x in new_packages(each, library) if x != source.name]
        if not packages:
            continue
        file = os.path.relpath(path, source.folder).replace(os.sep, "/")
        linked = [linked_of((x,))[0] for x in packages]
        changed = add_needs(source, texts, file, packages, linked)
        span = each.generation.span
        found += (x if x.file or x.span else x._replace(span=span) for x in changed.diagnostics)
        texts = texts if changed.texts is None else dict(changed.texts)
    if has_errors(found):
        return [], found
    return changed_files(source, texts), found


def _headers(language: Language, files: FileSet) -> frozenset[str]:
    return frozenset().union(*(language.imports(text) for _, text in files.texts))
