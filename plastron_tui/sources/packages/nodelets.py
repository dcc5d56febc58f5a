"""The nodelets of a package: which plugin descriptions name them, and which targets they are in.

Sources: the wiki pages "nodelet" and "pluginlib/PluginFormat".
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from plastron_tui.model.package_source import InstalledExecutable
from plastron_tui.sources.splices import line_number

from .reading import CMAKE_LISTS, PACKAGE_XML

if TYPE_CHECKING:
    from plastron_tui.sources.cmake.reader import CMakeLists
    from plastron_tui.sources.xml.document import XmlDocument
    from plastron_tui.sources.xml.edits import XmlEdit
    from plastron_tui.sources.xml.plugins import PluginClass

NODELET = "nodelet"
"""The package that loads nodelets, and the tag of package.xml that is for it."""

NODELET_BASE = "nodelet::Nodelet"


PREFIX = "${prefix}/"
"""The folder of a package, in what its package.xml exports."""


def export_description(document: XmlDocument, file: str) -> XmlEdit:
    """Let a package.xml tell a nodelet manager of a plugin description.

    Args:
        document: the package.xml.
        file: the description, by its path in the package.
    """
    from plastron_tui.sources.xml.edits import insert_last
    from plastron_tui.sources.xml.new_element import NewElement

    tag = NewElement(NODELET, (("plugin", f"{PREFIX}{file}"),))
    exports = document.root.named("export")
    if exports:
        return insert_last(document, exports[-1], tag)
    return insert_last(document, document.root, NewElement("export", children=(tag,)))


class Described(NamedTuple):
    """A nodelet of a plugin description.

    Attributes:
        file: the description, by its path in the package.
        library: the name of its library, without what the system puts around it.
        plugin: its class.
        others: the other classes of the file.
    """

    file: str
    library: str
    plugin: PluginClass
    others: tuple[PluginClass, ...]


def described_nodelets(texts: Mapping[str, bytes], folder: Path) -> Iterator[Described]:
    """Yield the nodelets that the plugin descriptions of a package name."""
    from plastron_tui.sources.xml.plugins import read_plugins

    for name, text in sorted(texts.items()):
        if not name.endswith(".xml") or name == PACKAGE_XML or b"<class" not in text:
            continue
        plugins, _ = read_plugins(text, folder / name)
        if plugins is None:
            continue
        classes = [each for library in plugins.libraries for each, _ in library.classes]
        for library in plugins.libraries:
            stem = library.path.rpartition("/")[2].removesuffix(".so").removeprefix("lib")
            for each, _ in library.classes:
                if each.base == NODELET_BASE:
                    others = tuple(x for x in classes if x != each)
                    yield Described(name, stem, each, others)


def nodelets(
    texts: Mapping[str, bytes], folder: Path, lists: CMakeLists
) -> dict[str, InstalledExecutable]:
    """Return the nodelets that a package builds, by what a manager loads them by."""
    from plastron_tui.sources.cmake.facts import sources_of, targets

    built = {each.what: each for each in targets(lists)}
    found = {}
    for each in described_nodelets(texts, folder):
        target = built.get(each.library)
        if target is None:
            continue
        line = line_number(lists.listing.text, target.call.command.start)
        sources = tuple(sources_of(target))
        found[each.plugin.name] = InstalledExecutable(
            None, CMAKE_LISTS, line, sources=sources, built=target.what
        )
    return found
