"""Putting nodes and launch files into a package that exists, and taking them out."""

from __future__ import annotations

from collections.abc import Callable, Collection, Container, Iterable, Mapping
from typing import NamedTuple

from plastron_tui.diagnostics import Diagnostic, codes
from plastron_tui.model.package_source import PackageSource
from plastron_tui.sources.build_files import Edited

from .plugin_classes import plugin_refusals
from .reading import CMAKE_LISTS, PACKAGE_XML, SETUP_CFG, SETUP_PY, named_elsewhere

_REMOVABLE = ("exec_depend", "run_depend", "depend")
_NONE: Mapping[str, tuple[str, ...]] = {}


class Changed(NamedTuple):
    """A package after a change, or why there is none.

    Attributes:
        texts: what its files hold, None where the change is refused.
        diagnostics: why it is refused.
        added: the dependencies that it did not have for all that they are there for, each with
            the elements that say so.
        found: the packages that its build did not find, and commands for all targets that it
            did not have.
    """

    texts: dict[str, bytes] | None
    diagnostics: tuple[Diagnostic, ...] = ()
    added: Mapping[str, tuple[str, ...]] = _NONE
    found: tuple[str, ...] = ()


class Needs(NamedTuple):
    """What is known of the dependencies of an executable that goes.

    Attributes:
        of: returns what a text needs to run, by key, each with its modules.
        added: the dependencies that came with it, each with whether a file named it before, which
            the package lived with; None where nothing tells.
        others_added: the files of other nodes that came so.
        found: the packages that the build finds since it came, and commands for all targets;
            None where nothing tells.
        tags: the elements that came with it, by dependency; of one that is not in it any may go.
    """

    of: Callable[[bytes], Mapping[str, Iterable[str]]]
    added: Mapping[str, bool] | None = None
    others_added: Container[str] = ()
    found: Collection[str] | None = None
    tags: Mapping[str, Collection[str]] = _NONE


def add_node(
    source: PackageSource,
    texts: Mapping[str, bytes],
    executable: str,
    file: str,
    keys: Iterable[str],
) -> Changed:
    """Let a package install a node, and depend on what it needs.

    Args:
        source: the package.
        texts: what its files hold by now.
        executable: what one starts the node by; with CMake it is the name of the file.
        file: the node's file, by its path in the package.
        keys: the packages and rosdep keys that the node needs to run.
    """
    if source.build_type == "ament_python":
        from plastron_tui.sources.setup_py.configuration import add_script
        from plastron_tui.sources.setup_py.scripts import add_console_script

        target = f"{source.module_of(file)}:main"
        built = source.script_file
        add = add_script if built == SETUP_CFG else add_console_script
        edited = add(texts[built], source.folder / built, executable, target)
    else:
        from plastron_tui.sources.cmake.programs import add_program

        built = CMAKE_LISTS
        edited = add_program(texts[built], source.folder / built, file)
    after = with_edit(texts, built, edited)
    return after if after.texts is None else add_dependencies(source, after.texts, keys)


def add_launch(
    source: PackageSource, texts: Mapping[str, bytes], file: str, keys: Iterable[str]
) -> Changed:
    """Let a package install a launch file, and depend on what it starts.

    Args:
        source: the package.
        texts: what its files hold by now.
        file: the launch file, by its path in the package.
        keys: the packages of what it starts.
    """
    if source.build_type == "ament_python":
        from plastron_tui.sources.setup_py.data_files import add_data_file

        path = source.folder / SETUP_PY
        after = with_edit(
            texts, SETUP_PY, add_data_file(texts[SETUP_PY], path, _folder(file), file)
        )
    else:
        from plastron_tui.sources.cmake.shares import add_shared

        path = source.folder / CMAKE_LISTS
        after = with_edit(texts, CMAKE_LISTS, add_shared(texts[CMAKE_LISTS], path, file))
    return after if after.texts is None else add_dependencies(source, after.texts, keys)


def remove_launch(
    source: PackageSource,
    texts: Mapping[str, bytes],
    file: str,
    keys: Iterable[str],
    *,
    is_installed_elsewhere: bool,
) -> Changed:
    """Let a package install a launch file no more, nor depend on what only that needed.

    Its file stays.

    Args:
        source: the package.
        texts: what its files hold by now.
        file: the launch file, by its path in the package.
        keys: the dependencies that came with it; one that another file names stays.
        is_installed_elsewhere: whether what installs it was there before, and stays.
    """
    after = Changed(dict(texts))
    if source.build_type == "ament_python":
        from plastron_tui.sources.setup_py.data_files import remove_data_file

        path = source.folder / SETUP_PY
        if not is_installed_elsewhere:
            edited = remove_data_file(texts[SETUP_PY], path, _folder(file), file)
            after = with_edit(texts, SETUP_PY, edited)
    elif not is_installed_elsewhere:
        from plastron_tui.sources.cmake.shares import remove_shared

        path = source.folder / CMAKE_LISTS
        top = file.partition("/")[0]
        is_shared = any(each.startswith(f"{top}/") for each in source.names - {file})
        edited = remove_shared(texts[CMAKE_LISTS], path, file, keep_folder=is_shared)
        after = with_edit(texts, CMAKE_LISTS, edited)
    if after.texts is None or not source.is_whole:
        return after
    others = {name: each for name, each in after.texts.items() if name not in (file, PACKAGE_XML)}
    gone = [key for key in keys if not any(named_elsewhere(others, (key,)))]
    return remove_dependencies(source, after.texts, gone)


def _folder(file: str) -> str:
    """Return the folder below `share/PACKAGE` that a file goes to: the one that it is in."""
    return file.rpartition("/")[0]


def remove_executable(
    source: PackageSource,
    texts: Mapping[str, bytes],
    executable: str,
    needs: Needs,
    *,
    is_installed_elsewhere: bool = False,
) -> Changed:
    """Let a package install an executable no more, nor depend on what only that needed.

    Its file stays.

    Args:
        source: the package.
        texts: what its files hold by now.
        executable: what one starts it by.
        needs: what is known of its dependencies.
        is_installed_elsewhere: whether what installs it was there before, and stays.
    """
    known = source.executables[executable]
    refused = tuple(plugin_refusals(source, texts, known.file)) if known.file else ()
    if refused:
        return Changed(None, refused[:1])
    after = Changed(dict(texts))
    if not is_installed_elsewhere:
        after = _uninstalled(source, texts, executable)
    if after.texts is None or known.file is None or not source.is_whole:
        return after
    if known.file not in after.texts:
        return after
    gone = _needed_no_more(after.texts, known.file, needs)
    return remove_dependencies(source, after.texts, gone, came=needs.tags)


def _needed_no_more(texts: Mapping[str, bytes], file: str, needs: Needs) -> list[str]:
    """Return the dependencies of a file that goes, as far as no other file names them.

    A file names one by its name, or by that of a module that it brings.
    """
    others = {name: each for name, each in texts.items() if name not in (file, PACKAGE_XML)}
    nodes = {name: each for name, each in others.items() if name in needs.others_added}
    gone = []
    for key, modules in needs.of(texts[file]).items():
        if needs.added is not None and key not in needs.added:
            continue
        judged = nodes if needs.added is not None and needs.added[key] else others
        if not any(named_elsewhere(judged, (key, *modules))):
            gone.append(key)
    return gone


def _uninstalled(source: PackageSource, texts: Mapping[str, bytes], executable: str) -> Changed:
    """Take an executable out of the file that makes it one."""
    known = source.executables[executable]
    path = source.folder / known.where
    if known.where == SETUP_PY:
        from plastron_tui.sources.setup_py.scripts import remove_console_script

        edited = remove_console_script(texts[SETUP_PY], path, executable)
    elif known.where == SETUP_CFG:
        from plastron_tui.sources.setup_py.configuration import remove_script

        edited = remove_script(texts[SETUP_CFG], path, executable)
    elif known.file is None:
        message = f"line {known.line} of `{known.where}` builds `{executable}` from other files"
        return Changed(None, (Diagnostic(codes.EDIT_REFUSED, message, file=path),))
    else:
        from plastron_tui.sources.cmake.programs import remove_program

        edited = remove_program(texts[CMAKE_LISTS], path, known.file)
    after = with_edit(texts, known.where, edited)
    if after.texts is None:
        return after
    if after.texts[known.where] == texts[known.where]:
        message = f"line {known.line} of `{known.where}` installs `{executable}`"
        message += " by a pattern or in a branch"
        return Changed(None, (Diagnostic(codes.COMPUTED_BUILD_FILE, message, file=path),))
    return after


def with_edit(texts: Mapping[str, bytes], name: str, edited: Edited) -> Changed:
    """Return a package with another text of one of its files."""
    if edited.text is None:
        return Changed(None, edited.diagnostics)
    return Changed({**texts, name: edited.text}, edited.diagnostics)


def add_dependencies(
    source: PackageSource,
    texts: Mapping[str, bytes],
    keys: Iterable[str],
    needs: Iterable[str] = ("exec",),
) -> Changed:
    """Let a package depend on others, as far as it does not yet.

    Args:
        source: the package.
        texts: what its files hold by now.
        keys: packages and rosdep keys.
        needs: what they are there for, as REP 149 has it.
    """
    from plastron_tui.sources.xml.dependencies import add_dependency
    from plastron_tui.sources.xml.package_xml import read_package

    package, found = read_package(texts[PACKAGE_XML], source.folder / PACKAGE_XML)
    if package is None:
        return Changed(None, found)
    added: dict[str, tuple[str, ...]] = {}
    for key in keys:
        if key == source.name:
            continue
        edit = add_dependency(package, key, needs, source.ros_version)
        if edit.package is None:
            return Changed(None, edit.diagnostics)
        package = edit.package
        if edit.tags:
            added[key] = edit.tags
    return Changed({**texts, PACKAGE_XML: package.document.text}, (), added)


def remove_dependencies(
    source: PackageSource,
    texts: Mapping[str, bytes],
    keys: Iterable[str],
    tags: Collection[str] = _REMOVABLE,
    needs: Iterable[str] | None = None,
    came: Mapping[str, Collection[str]] = _NONE,
) -> Changed:
    """Let a package depend on others no more.

    Args:
        source: the package.
        texts: what its files hold by now.
        keys: packages and rosdep keys.
        tags: those of the elements that may go.
        needs: what they were there for; only what that added goes where it shows.
        came: the tags of those elements that came with what goes, by dependency, where that is
            known: no others go.
    """
    from plastron_tui.sources.xml.dependencies import add_dependency, remove_dependency
    from plastron_tui.sources.xml.package_xml import read_package

    package, found = read_package(texts[PACKAGE_XML], source.folder / PACKAGE_XML)
    if package is None:
        return Changed(None, found)
    for key in reversed(list(keys)):
        known = came.get(key)
        edit = remove_dependency(package, key, source.ros_version, tags if known is None else known)
        if edit.package is None:
            return Changed(None, edit.diagnostics)
        is_open = needs is not None and known is None
        ways = [edit.tags, *((one,) for one in edit.tags)] if is_open else []
        for way in ways:
            less = remove_dependency(package, key, source.ros_version, way)
            if less.package is not None and needs is not None:
                again = add_dependency(less.package, key, needs, source.ros_version).package
                if again is not None and again.document.text == package.document.text:
                    edit = less
                    break
        assert edit.package is not None, "both were made"
        package = edit.package
    return Changed({**texts, PACKAGE_XML: package.document.text})
