"""Putting a node into a package that exists and has to build it.

Sources: the wiki pages "nodelet" and "pluginlib/PluginFormat": package.xml names the files that
describe the classes of a package's libraries, in an `<export>` for the package that loads them.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, NamedTuple

from plastron_tui.model.package_source import PackageSource

from .changing import Changed, add_dependencies, remove_dependencies, with_edit
from .nodelets import NODELET, PREFIX, export_description
from .reading import CMAKE_LISTS, PACKAGE_XML

if TYPE_CHECKING:
    from plastron_tui.sources.cmake.targets import NewTarget
    from plastron_tui.sources.xml.plugins import PluginClass

_USUAL_FILE = "nodelet_plugins.xml"
_NEEDS = ("build", "exec")


def add_built_node(
    source: PackageSource,
    texts: Mapping[str, bytes],
    target: NewTarget,
    keys: Iterable[str],
    plugin: PluginClass | None = None,
) -> Changed:
    """Let a package build a node, and depend on what it is built with.

    Args:
        source: the package.
        texts: what its files hold by now.
        target: the node, as CMake knows it.
        keys: the packages and rosdep keys that it is built with, and runs with.
        plugin: what a file of the package tells of its class, in ROS 1; None for a program.
    """
    from plastron_tui.sources.cmake.dependencies import found_packages
    from plastron_tui.sources.cmake.removals import commands_for_all
    from plastron_tui.sources.cmake.targets import add_target

    after = Changed(dict(texts))
    if plugin is not None:
        described = _described(source, texts, target, plugin)
        after, target = described.changed, target._replace(plugins_file=described.file)
    if after.texts is None:
        return after
    path, before = source.folder / CMAKE_LISTS, after.texts[CMAKE_LISTS]
    after = with_edit(after.texts, CMAKE_LISTS, add_target(before, path, target))
    if after.texts is None:
        return after
    now, then = (
        found_packages(text, path) | commands_for_all(text, path)
        for text in (after.texts[CMAKE_LISTS], before)
    )
    found = tuple(sorted(now - then))
    return add_dependencies(source, after.texts, keys, _NEEDS)._replace(found=found)


def add_needs(
    source: PackageSource,
    texts: Mapping[str, bytes],
    file: str,
    packages: Sequence[str],
    linked: Sequence[str],
) -> Changed:
    """Let a package build a node that it has with more packages, and depend on them.

    Args:
        source: the package.
        texts: what its files hold by now.
        file: the node's main file, by its path in the package.
        packages: what the node is built with besides.
        linked: what each of them is linked to by, in ROS 2.
    """
    from plastron_tui.sources.cmake.dependencies import found_packages
    from plastron_tui.sources.cmake.linking import add_packages

    if CMAKE_LISTS not in texts:
        return Changed(dict(texts))
    path = source.folder / CMAKE_LISTS
    before = found_packages(texts[CMAKE_LISTS], path)
    after = with_edit(
        texts, CMAKE_LISTS, add_packages(texts[CMAKE_LISTS], path, file, packages, linked)
    )
    if after.texts is None:
        return after
    found = found_packages(after.texts[CMAKE_LISTS], path) - before
    return add_dependencies(source, after.texts, packages, _NEEDS)._replace(found=tuple(found))


class Came(NamedTuple):
    """How a package came to be needed with a node.

    Attributes:
        package: the package.
        linked: what the node is linked to by, in ROS 2.
        is_linked: whether the node was not linked to it before.
        is_found: whether the build did not find it before.
        tags: the elements that package.xml did not have before.
    """

    package: str
    linked: str
    is_linked: bool
    is_found: bool
    tags: tuple[str, ...]


def came_with(
    source: PackageSource,
    texts: Mapping[str, bytes],
    after: Changed,
    packages: Sequence[str],
    linked: Sequence[str],
) -> Iterator[Came]:
    """Yield how packages came to be needed, of which `add_needs` made a package.

    Args:
        source: the package.
        texts: what its files held.
        after: what `add_needs` made of it.
        packages: what the node is built with besides.
        linked: what each of them is linked to by, in ROS 2.
    """
    from plastron_tui.sources.cmake.linking import is_linked

    if after.texts is None or CMAKE_LISTS not in texts:
        return
    path = source.folder / CMAKE_LISTS
    for name, target in zip(packages, linked, strict=True):
        was, now = (
            is_linked(each[CMAKE_LISTS], path, name, target) for each in (texts, after.texts)
        )
        tags = after.added.get(name, ())
        is_new = (now > was, name in after.found)
        if any(is_new) or tags:
            yield Came(name, target, *is_new, tags)


def remove_needs(
    source: PackageSource, texts: Mapping[str, bytes], file: str, came: Sequence[Came]
) -> Changed:
    """Let a package build a node without packages that came with what the node has no more.

    Args:
        source: the package.
        texts: what its files hold by now.
        file: the node's main file, by its path in the package.
        came: how they came.
    """
    from plastron_tui.sources.cmake.linking import remove_packages

    if CMAKE_LISTS not in texts:
        return Changed(dict(texts))
    path = source.folder / CMAKE_LISTS
    gone = [(x.package, x.linked, x.is_linked, x.is_found) for x in came]
    edited = remove_packages(texts[CMAKE_LISTS], path, file, gone)
    after = with_edit(texts, CMAKE_LISTS, edited)
    for each in reversed(came):
        if after.texts is not None:
            after = remove_dependencies(source, after.texts, [each.package], each.tags, _NEEDS)
    return after


class _Described(NamedTuple):
    """A package that describes a plugin, and the file that does."""

    changed: Changed
    file: str = ""


def _described(
    source: PackageSource, texts: Mapping[str, bytes], target: NewTarget, plugin: PluginClass
) -> _Described:
    """Describe a class in a file that can have it, or else in a new one."""
    from plastron_tui.sources.cmake.reader import read_cmake
    from plastron_tui.sources.cmake.targets import target_of
    from plastron_tui.sources.xml.package_xml import read_package
    from plastron_tui.sources.xml.plugins import add_class, read_plugins

    lists, found = read_cmake(texts[CMAKE_LISTS], source.folder / CMAKE_LISTS)
    if lists is None:
        return _Described(Changed(None, found))
    package, found = read_package(texts[PACKAGE_XML], source.folder / PACKAGE_XML)
    if package is None:
        return _Described(Changed(None, found))
    library = f"lib/lib{target_of(lists, target)}".replace("${PROJECT_NAME}", lists.name or "")
    exported = [
        (each.get("plugin") or "").removeprefix(PREFIX)
        for export in package.document.root.named("export")
        for each in export.named(NODELET)
    ]
    for file in (each for each in exported if each in texts):
        plugins, _ = read_plugins(texts[file], source.folder / file)
        if plugins is None:
            continue
        for known in plugins.libraries:
            # One that was described before stays as it is.
            if any(each.type == plugin.type for each, _ in known.classes):
                return _Described(Changed(dict(texts)), file)
        edit = add_class(plugins, library, plugin)
        if edit.plugins is not None:
            changed = {**texts, file: edit.plugins.document.text}
            return _Described(Changed(changed), file)
    if _describes_alone(texts.get(_USUAL_FILE), plugin):
        # It was left when the node was taken out before.
        return _new_file(source, texts, _USUAL_FILE, library, plugin)
    is_free = _USUAL_FILE not in source.names
    file = _USUAL_FILE if is_free else f"{target.stem}_{_USUAL_FILE}"
    return _new_file(source, texts, file, library, plugin)


def _describes_alone(text: bytes | None, plugin: PluginClass) -> bool:
    from plastron_tui.sources.xml.plugins import read_plugins

    plugins = None if text is None else read_plugins(text).plugins
    classes = [] if plugins is None else [x for each in plugins.libraries for x, _ in each.classes]
    return [each.type for each in classes] == [plugin.type]


def _new_file(
    source: PackageSource, texts: Mapping[str, bytes], file: str, library: str, plugin: PluginClass
) -> _Described:
    from plastron_tui.sources.xml.package_xml import read_package
    from plastron_tui.sources.xml.plugins import add_class, read_plugins

    path = source.folder / PACKAGE_XML
    package, found = read_package(texts[PACKAGE_XML], path)
    empty = b"<class_libraries>\n</class_libraries>\n"
    plugins, _ = read_plugins(empty, source.folder / file)
    if package is None or plugins is None:
        return _Described(Changed(None, found))
    made = add_class(plugins, library, plugin)
    if made.plugins is None:
        return _Described(Changed(None, made.diagnostics))
    edit = export_description(package.document, file)
    if edit.document is None:
        return _Described(Changed(None, edit.diagnostics))
    changed = {**texts, PACKAGE_XML: edit.document.text, file: made.plugins.document.text}
    return _Described(Changed(changed), file)
