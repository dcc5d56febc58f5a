"""What a package installs for people to start in ways that its nodes are not changed by.

From the documentation of setuptools (`scripts`, `data_files`), and that of
`ament_python_install_package`: it installs the console scripts of a `setup.cfg` to the folder that
`SCRIPTS_DESTINATION` names.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import NamedTuple

from plastron_tui.model.package_source import InstalledExecutable, PackageSource
from plastron_tui.sources.build_files import RefusedError
from plastron_tui.sources.cmake.definitions import ReadFile
from plastron_tui.sources.cmake.following import follow
from plastron_tui.sources.cmake.reader import Call, CMakeLists
from plastron_tui.sources.cmake.shared_reading import read_shared
from plastron_tui.sources.setup_py.configuration import read_scripts
from plastron_tui.sources.setup_py.reader import SetupFile, read_setup
from plastron_tui.sources.splices import line_number

from .reading import CMAKE_LISTS, SETUP_CFG, SETUP_PY, cmake_executables, finds_scripts


class Installed(NamedTuple):
    """What is installed where nodes are looked for.

    Attributes:
        programs: what it is, by what it is started by.
        is_whole: whether that is all, besides the executables of the package.
    """

    programs: Mapping[str, InstalledExecutable]
    is_whole: bool = True


def further_programs(source: PackageSource, read: ReadFile) -> Installed:
    """Return the scripts of a setup.py, and what CMake makes in functions, and by a setup.cfg.

    Args:
        source: the package.
        read: returns what a file of it holds, None where it cannot be read.
    """
    if source.build_type == "ament_python":
        setup, _ = read_setup(source.texts[SETUP_PY], source.folder / SETUP_PY)
        return Installed({} if setup is None else dict(_of_setup(source, setup)))
    if CMAKE_LISTS not in source.texts:
        return Installed({})
    lists, _ = read_shared(source.texts[CMAKE_LISTS], source.folder / CMAKE_LISTS)
    if lists is None:
        return Installed({})
    followed = follow(lists, lambda name: read(name) if name in source.names else None)
    made = {} if followed is lists else cmake_executables(followed, source.names)
    installed = _of_cmake(source, followed)
    return installed._replace(programs={**made, **installed.programs})


def _of_setup(source: PackageSource, setup: SetupFile) -> Iterator[tuple[str, InstalledExecutable]]:
    data = [each for each in setup.data_files if each.destination == f"lib/{source.name}"]
    has_folder = finds_scripts(source)
    for file in sorted(source.names):
        line = next((line_number(source.texts[SETUP_PY], x.span.start) for x in data
                     if x.covers(file)), 0)  # fmt: skip
        if line or (has_folder and setup.is_script(file)):
            yield file.rpartition("/")[2], InstalledExecutable(file, SETUP_PY, line or 1)


def _of_cmake(source: PackageSource, lists: CMakeLists) -> Installed:
    programs: dict[str, InstalledExecutable] = {}
    is_whole = True
    if source.build_type != "ament_cmake":
        return Installed(programs)
    for call in lists.named("ament_python_install_package"):
        values = [each.value for each in call.items]
        where = _behind(call, "SCRIPTS_DESTINATION")
        if "SCRIPTS_DESTINATION" not in values or SETUP_CFG not in source.names:
            continue
        known = _console_scripts(source, values[0], _behind(call, "PACKAGE_DIR") or values[0])
        if known is None or "SETUP_CFG" in values or call.conditions or "${" in where:
            is_whole = False
        elif where.removeprefix("/") == f"lib/{lists.name}":
            programs.update(known)
    return Installed(programs, is_whole)


def _behind(call: Call, word: str) -> str:
    """Return what stands behind a word of a call, "" where it has not the word."""
    values = [each.value for each in call.items]
    if word not in values[:-1]:
        return ""
    value = values[values.index(word) + 1]
    for folder in ("${CMAKE_CURRENT_SOURCE_DIR}/", "${CMAKE_INSTALL_PREFIX}/"):
        value = value.removeprefix(folder)
    return value.rstrip("/")


def _console_scripts(
    source: PackageSource, package: str, folder: str
) -> dict[str, InstalledExecutable] | None:
    """Return the console scripts of a setup.cfg, None where they are not known.

    Args:
        source: the package.
        package: the Python package that is installed.
        folder: the folder that it is in.
    """
    text = source.texts.get(SETUP_CFG)
    if text is None:
        return None
    try:
        scripts = read_scripts(text, source.folder / SETUP_CFG) or ()
    except RefusedError:
        return None
    found = {}
    for each in scripts:
        module = each.target.partition(":")[0].strip()
        inner = module.removeprefix(f"{package}.").replace(".", "/")
        file = f"{folder}/{inner}.py" if module.startswith(f"{package}.") else None
        line = line_number(text, each.span.start)
        there = file if file in source.names else None
        found[each.name] = InstalledExecutable(there, SETUP_CFG, line, each.target)
    return found
