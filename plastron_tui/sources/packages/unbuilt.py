"""Taking a node out of a package that builds it."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

from plastron_tui.diagnostics import Diagnostic, codes

from .changing import Changed, Needs, remove_dependencies, with_edit
from .nodelets import NODELET, PREFIX, Described, described_nodelets, export_description
from .reading import CMAKE_LISTS, PACKAGE_XML

if TYPE_CHECKING:
    from plastron_tui.model.package_source import InstalledExecutable, PackageSource

_REMOVABLE = ("exec_depend", "run_depend", "build_depend", "build_export_depend", "depend")


def remove_built_node(
    source: PackageSource,
    texts: Mapping[str, bytes],
    name: str,
    needs: Needs,
    *,
    is_built_elsewhere: bool = False,
) -> Changed:
    """Let a package build a node no more, nor depend on what only that needed.

    Its files stay.

    Args:
        source: the package.
        texts: what its files hold by now.
        name: what starts or loads it.
        needs: what is known of its dependencies.
        is_built_elsewhere: whether what builds it was there before, and stays.
    """
    from plastron_tui.sources.cmake.removals import names_package, remove_target

    known = source.installed(name)
    files = own_files(source, texts, known)
    free = _needed_no_more(texts, files, needs) if source.is_whole and files else {}
    found = [key for key in free if needs.found is None or key in needs.found]
    gone = [key for key, may_go in free.items() if may_go]
    after = Changed(dict(texts))
    if not is_built_elsewhere:
        after = _undescribed(source, texts, name, known)
        if after.texts is None:
            return after
        path = source.folder / CMAKE_LISTS
        edited = remove_target(after.texts[CMAKE_LISTS], path, known.built, found, needs.found)
        after = with_edit(after.texts, CMAKE_LISTS, edited)
    if after.texts is None:
        return after
    lists = after.texts[CMAKE_LISTS]
    before = needs.added or {}
    gone = [key for key in gone if before.get(key) or not names_package(lists, key)]
    needed = ("build", "exec")
    return remove_dependencies(source, after.texts, gone, _REMOVABLE, needed, needs.tags)


def own_files(
    source: PackageSource, texts: Mapping[str, bytes], known: InstalledExecutable
) -> tuple[str, ...]:
    """Return the files that a node alone is built of, with the headers of its sources.

    A header belongs to a source that is called as it, where no other file names it.
    """
    others = [x for x in (*source.executables.values(), *source.plugins.values()) if x != known]
    shared = {file for each in others if each.built != known.built for file in each.sources}
    sources = [file for file in known.sources if file in texts and file not in shared]
    found = list(sources)
    for file in sources:
        stem = file.rpartition("/")[2].rpartition(".")[0]
        for each in texts:
            base = each.rpartition("/")[2]
            is_alike = base.rpartition(".")[0] == stem and base.rpartition(".")[2][:1] == "h"
            if is_alike and not any(
                _names(text, base) for x, text in texts.items() if x not in (each, file)
            ):
                found.append(each)
    return tuple(dict.fromkeys(found))


def _names(text: bytes, word: str) -> bool:
    wanted = word.encode()
    # Searching for the plain word first is some ten times faster.
    return wanted in text and re.search(rb"(?<!\w)%b(?!\w)" % re.escape(wanted), text) is not None


def _needed_no_more(
    texts: Mapping[str, bytes], files: Sequence[str], needs: Needs
) -> dict[str, bool]:
    """Return what only a node needs, each with whether package.xml may lack it then.

    CMakeLists.txt is left out: it is asked when the node is out of it.
    """
    left_out = {*files, PACKAGE_XML, CMAKE_LISTS}
    # What loads a class is named by its description too, which goes.
    others = {
        name: text
        for name, text in texts.items()
        if name not in left_out and not name.endswith("plugins.xml")
    }
    nodes = {name: text for name, text in others.items() if name in needs.others_added}
    wanted = {key for file in files for key in needs.of(texts[file])}
    wanted |= {*(needs.added or ()), *(needs.found or ())}
    gone = {}
    for key in sorted(wanted):
        judged = nodes if needs.added is not None and needs.added.get(key) else others
        if not any(_names(text, key) for text in judged.values()):
            gone[key] = needs.added is None or key in needs.added
    return gone


def _undescribed(
    source: PackageSource, texts: Mapping[str, bytes], name: str, known: InstalledExecutable
) -> Changed:
    """Take the description of a nodelet away; nothing changes for what is none."""
    if name not in source.plugins:
        return Changed(dict(texts))
    found = list(described_nodelets(texts, source.folder))
    beside = [x.plugin.name for x in found if x.plugin.name != name and x.library == known.built]
    if beside:
        message = f"line {known.line} of `{known.where}` builds `{beside[0]}` with `{name}`"
        return Changed(None, (Diagnostic(codes.EDIT_REFUSED, message),))
    after = Changed(dict(texts))
    for each in found:
        if each.plugin.name != name or after.texts is None:
            continue
        after = _without_class(source, after.texts, each)
    return after


def _without_class(source: PackageSource, texts: dict[str, bytes], each: Described) -> Changed:
    from plastron_tui.sources.cmake.shares import remove_shared
    from plastron_tui.sources.xml.plugins import read_plugins, remove_class

    if each.others:
        plugins, found = read_plugins(texts[each.file], source.folder / each.file)
        if plugins is None:
            return Changed(None, found)
        edit = remove_class(plugins, each.plugin.name, each.plugin.base)
        if edit.plugins is None:
            return Changed(None, edit.diagnostics)
        return Changed({**texts, each.file: edit.plugins.document.text})
    # A description of nothing else stays, as the file of the node does, and nothing reads it.
    path = source.folder / CMAKE_LISTS
    is_alone = not any(x.startswith(f"{each.file.partition('/')[0]}/") for x in source.names)
    edited = remove_shared(texts[CMAKE_LISTS], path, each.file, keep_folder=not is_alone)
    after = with_edit(texts, CMAKE_LISTS, edited)
    return after if after.texts is None else _unexported(source, after.texts, each.file)


def _unexported(source: PackageSource, texts: dict[str, bytes], file: str) -> Changed:
    """Take away what tells a manager of a file, and the `<export>` that has nothing else."""
    from plastron_tui.sources.xml.edits import remove_element
    from plastron_tui.sources.xml.package_xml import read_package

    package, found = read_package(texts[PACKAGE_XML], source.folder / PACKAGE_XML)
    if package is None:
        return Changed(None, found)
    for export in package.document.root.named("export"):
        for each in export.named(NODELET):
            if (each.get("plugin") or "").removeprefix(PREFIX) != file:
                continue
            ways = [
                remove_element(package.document, export),
                remove_element(package.document, each),
                remove_element(package.document, each, closes=False),
            ]
            plain = ways[1]
            for edit in ways:
                if edit.document is None:
                    continue
                again = export_description(edit.document, file).document
                if again is not None and again.text == package.document.text:
                    return Changed({**texts, PACKAGE_XML: edit.document.text})
            if plain.document is None:
                return Changed(None, plain.diagnostics)
            return Changed({**texts, PACKAGE_XML: plain.document.text})
    return Changed(texts)


def staying(source: PackageSource, name: str) -> Iterator[str]:
    """Yield the files of a node that goes, by their paths in the package."""
    known = source.installed(name)
    yield from own_files(source, source.texts, known)
    for each in described_nodelets(source.texts, source.folder):
        if each.plugin.name == name and not each.others:
            yield each.file
