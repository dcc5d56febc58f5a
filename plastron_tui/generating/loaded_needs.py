"""What the files of nodes in a package that exists need of other packages."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING

from plastron_tui.ros.interfaces import InterfaceKind
from plastron_tui.ros.package_keys import key_of_header, key_of_module
from plastron_tui.sources import find_language, own_languages

if TYPE_CHECKING:
    from plastron_tui.model.package_source import PackageSource

    from .apply_changes import Library


def known_packages(library: Library) -> frozenset[str]:
    """Return the packages with interface types that a client library knows."""
    return frozenset(each for kind in InterfaceKind for each in library.catalog.packages(kind))


def needs_in(
    source: PackageSource, libraries: Mapping[str, Library], file: str | None
) -> Callable[[bytes], Mapping[str, Sequence[str]]]:
    """Return what tells the needs of a node's text, by key, each with its modules.

    Args:
        source: the package.
        libraries: the client libraries, by name.
        file: the node's file, whose language the text is in; None for that of scripts.
    """
    version = source.ros_version
    known: frozenset[str] = frozenset()
    for library in libraries.values():
        if library.target.ros_version == version:
            known = known_packages(library)
    named = (each for each in own_languages() if file and file.endswith(each.suffixes))
    language = next(named, find_language("python"))
    sign, key_of = ("/", key_of_header) if language.is_built else (".", key_of_module)

    def needs(text: bytes) -> Mapping[str, Sequence[str]]:
        found: dict[str, list[str]] = {}
        for name in sorted(language.imports(text)):
            first = name.partition(sign)[0]
            key = key_of(name, version, known)
            if key is not None and first != source.name:
                found.setdefault(key, []).append(first)
        return found

    return needs
