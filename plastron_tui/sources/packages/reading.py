"""What a package is made of, from the texts of its files."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING, NamedTuple

from plastron_tui.diagnostics import Diagnostic, codes
from plastron_tui.diagnostics.severity import Severity
from plastron_tui.model.package_source import InstalledExecutable, LoadedPackage, PackageSource
from plastron_tui.ros.launch_names import launch_language
from plastron_tui.sources.build_files import RefusedError
from plastron_tui.sources.splices import line_number
from plastron_tui.sources.xml.package_xml import read_package

if TYPE_CHECKING:
    from plastron_tui.sources.cmake.reader import CMakeLists
    from plastron_tui.sources.setup_py.reader import ConsoleScript, SetupFile

PACKAGE_XML, SETUP_PY, SETUP_CFG, PYPROJECT, CMAKE_LISTS = (
    "package.xml",
    "setup.py",
    "setup.cfg",
    "pyproject.toml",
    "CMakeLists.txt",
)

_SCRIPT_FOLDERS = ("scripts", "nodes", "script", "bin", "src")
_PYTHON_ROOTS = ("", "src")


class PackageFiles(NamedTuple):
    """The files of a package, by their paths from its folder, with slashes.

    Attributes:
        folder: where it is.
        names: all that is there.
        texts: what those hold that may say something of others.
        is_whole: whether all of those were read.
    """

    folder: Path
    names: frozenset[str]
    texts: Mapping[str, bytes]
    is_whole: bool = True


def read_package_files(files: PackageFiles, ros_version: int) -> LoadedPackage:
    """Read a package; nothing of it is run.

    Args:
        files: its files.
        ros_version: what a package counts for that is for both generations of ROS.
    """
    path = files.folder / PACKAGE_XML
    package, found = read_package(files.texts[PACKAGE_XML], path)
    errors = tuple(each for each in found if each.severity is Severity.ERROR)
    if package is None or errors:
        return LoadedPackage(None, errors or found)
    types = {version: package.build_type({"ROS_VERSION": str(version)}) for version in (1, 2)}
    if types[1] == types[2]:
        ros_version = 1 if types[1] == "catkin" else 2
    build_type = types[ros_version]
    try:
        if build_type == "ament_python":
            parts = _python_parts(files)
        elif build_type in ("catkin", "ament_cmake"):
            parts = _cmake_parts(files)
        else:
            message = f"packages that `{build_type}` builds are not changed"
            refused = Diagnostic(codes.EDIT_REFUSED, message, file=path)
            return LoadedPackage(None, (refused,))
    except RefusedError as error:
        return LoadedPackage(None, (error.diagnostic,))
    return LoadedPackage(
        PackageSource(
            files.folder,
            package.name,
            ros_version,
            build_type,
            files.texts,
            parts.executables,
            parts.node_folder,
            parts.python_root,
            tuple(sorted(name for name in files.names if launch_language(name))),
            files.is_whole,
            parts.script_file,
            files.names,
            parts.plugins,
        )
    )


class _Parts(NamedTuple):
    executables: dict[str, InstalledExecutable]
    node_folder: str | None
    python_root: str = ""
    script_file: str = SETUP_PY
    plugins: Mapping[str, InstalledExecutable] = MappingProxyType({})


def _text(files: PackageFiles, name: str) -> bytes:
    text = files.texts.get(name)
    if text is None:
        message = f"the package has no `{name}`, which its build type wants"
        raise RefusedError(
            Diagnostic(codes.BROKEN_BUILD_FILE, message, file=files.folder / PACKAGE_XML)
        )
    return text


def _python_parts(files: PackageFiles) -> _Parts:
    from plastron_tui.sources.setup_py.reader import read_setup

    text, path = _text(files, SETUP_PY), files.folder / SETUP_PY
    setup, found = read_setup(text, path)
    if setup is None:
        raise RefusedError(found[0])
    scripts, where = _scripts(files, setup)
    modules = [each.target.partition(":")[0].replace(".", "/") for each in scripts]
    packages = [*(setup.packages or ()), *(setup.finder.find(files.names) if setup.finder else ())]
    names = [*modules, *(each.replace(".", "/") for each in packages), setup.name or ""]
    roots = _PYTHON_ROOTS if setup.root is None else (setup.root,)
    root = next((root for root in roots for name in names if _file(files, root, name)), roots[0])
    executables = {
        each.name: InstalledExecutable(
            _file(files, root, module),
            where,
            line_number(files.texts[where], each.span.start),
            each.target,
        )
        for each, module in zip(scripts, modules, strict=True)
    }
    folders = _usual_folders(each.file for each in executables.values())
    folders += [
        f"{root}/{name.replace('.', '/')}".strip("/") for name in (setup.name, *packages) if name
    ]
    folder = next((each for each in folders if f"{each}/__init__.py" in files.names), None)
    return _Parts(executables, folder, root, where)


def finds_scripts(source: PackageSource) -> bool:
    """Tell whether `ros2 run` finds the scripts of a package, as far as nothing speaks against it.

    A setup.cfg names `lib/PACKAGE` for them, or setup.py does.
    """
    words = (b"install_scripts", b"install-scripts")
    texts = [source.texts.get(each, b"") for each in (SETUP_CFG, SETUP_PY)]
    named = any(word in text for word in words for text in texts)
    return source.build_type != "ament_python" or named


def _file(files: PackageFiles, root: str, name: str) -> str | None:
    """Return the file that a module is, as far as it is there."""
    path = f"{root}/{name}".strip("/")
    return next(
        (each for each in (f"{path}.py", f"{path}/__init__.py") if each in files.names), None
    )


def _scripts(files: PackageFiles, setup: SetupFile) -> tuple[tuple[ConsoleScript, ...], str]:
    """Return the console scripts, and the file that says them."""
    from plastron_tui.sources.setup_py.configuration import check_project, read_scripts
    from plastron_tui.sources.setup_py.reader import has_entry_points

    if (project := files.texts.get(PYPROJECT)) is not None:
        check_project(project, files.folder / PYPROJECT)
    text = files.texts.get(SETUP_CFG)
    if text is None or has_entry_points(files.texts[SETUP_PY], files.folder / SETUP_PY):
        return setup.console_scripts, SETUP_PY
    scripts = read_scripts(text, files.folder / SETUP_CFG)
    return (setup.console_scripts, SETUP_PY) if scripts is None else (scripts, SETUP_CFG)


def _cmake_parts(files: PackageFiles) -> _Parts:
    from plastron_tui.sources.cmake.changing import build_type_of
    from plastron_tui.sources.cmake.shared_reading import read_shared

    from .nodelets import nodelets

    text, path = _text(files, CMAKE_LISTS), files.folder / CMAKE_LISTS
    lists, found = read_shared(text, path)
    if lists is None:
        raise RefusedError(found[0])
    build_type_of(lists)
    executables = cmake_executables(lists, files.names)
    folders = _usual_folders(each.file for each in executables.values())
    folders += [each for each in _SCRIPT_FOLDERS[:-1] if _has_folder(files, each)]
    folder = folders[0] if folders else _SCRIPT_FOLDERS[0]
    return _Parts(executables, folder, plugins=nodelets(files.texts, files.folder, lists))


def cmake_executables(lists: CMakeLists, names: frozenset[str]) -> dict[str, InstalledExecutable]:
    """Return what a CMakeLists.txt makes for people to start, by what they start it by.

    Args:
        lists: the file.
        names: the files of the package.
    """
    from plastron_tui.sources.cmake.facts import (
        component_class,
        component_sources,
        executable_of,
        programs,
        registered_components,
        sources_of,
        targets,
    )

    text = lists.listing.text
    executables: dict[str, InstalledExecutable] = {}
    for target in targets(lists):
        if target.call.command.name != "add_library":
            line = line_number(text, target.call.command.start)
            sources = tuple(sources_of(target))
            name = executable_of(lists, target)
            executables[name] = InstalledExecutable(
                None, CMAKE_LISTS, line, sources=sources, built=target.what
            )
    for each in registered_components(lists):
        line = line_number(text, each.call.command.start)
        executables[each.what] = InstalledExecutable(
            None,
            CMAKE_LISTS,
            line,
            sources=tuple(component_sources(lists, each)),
            built=each.call.items[0].value,
            loaded=component_class(each),
        )
    for entry in programs(lists):
        if entry.destination != f"lib/{lists.name}":
            continue
        line = line_number(text, entry.call.command.start)
        words = [each.value for each in entry.call.items]
        for file in filter(entry.has, names) if entry.item.is_pattern else (entry.what,):
            name = file.rpartition("/")[2]
            if "RENAME" in words[:-1]:
                name = words[words.index("RENAME") + 1]
            executables[name] = InstalledExecutable(file, CMAKE_LISTS, line)
    return executables


def _usual_folders(paths: Iterable[str | None]) -> list[str]:
    """Return the folders of files, those with most of them first."""
    found = Counter(path.rpartition("/")[0] for path in paths if path is not None)
    return [folder for folder, _ in found.most_common()]


def _has_folder(files: PackageFiles, folder: str) -> bool:
    return any(name.startswith(f"{folder}/") for name in files.names)


def named_elsewhere(texts: Mapping[str, bytes], words: Iterable[str]) -> Iterator[str]:
    """Return the files that have one of some words in them, wherever it stands."""
    wanted = [word.encode() for word in words]
    for name, text in texts.items():
        if any(word in text for word in wanted):
            yield name
