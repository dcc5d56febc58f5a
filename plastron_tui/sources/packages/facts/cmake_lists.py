"""What a CMakeLists.txt builds and installs, as far as that is sure."""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from typing import NamedTuple

from plastron_tui.diagnostics import Span
from plastron_tui.model.package_facts import How, Place, Target
from plastron_tui.sources.build_files import matches
from plastron_tui.sources.cmake.definitions import MODULES, is_for_tests
from plastron_tui.sources.cmake.facts import (
    INSTALL_WORDS,
    Entry,
    covers,
    executable_of,
    exported,
    registered_components,
    sources_of,
    targets,
)
from plastron_tui.sources.cmake.following import follow
from plastron_tui.sources.cmake.reader import Call, CMakeLists, in_package
from plastron_tui.sources.cmake.shared_reading import read_shared
from plastron_tui.sources.packages.reading import CMAKE_LISTS

from .destinations import UNKNOWN, program_destination, set_destination
from .texts import PackageTexts

_KNOWN = (
    "add_action_files", "add_compile_", "add_custom_", "add_definitions", "add_dependencies",
    "add_executable", "add_launch_test", "add_library", "add_link_options", "add_message_files",
    "add_rostest", "add_service_files", "add_test", "ament_", "aux_source_directory",
    "break", "catkin_", "cmake_", "configure_", "continue", "cuda_", "doxygen_", "enable_",
    "execute_process", "export", "fetchcontent_", "file", "find_", "generate_", "get_", "gtest_",
    "include", "install", "link_", "list", "mark_as_advanced", "math", "message", "nav2_package",
    "nvcc", "option", "pkg_", "pluginlib_", "project", "pybind11_", "qt4_", "qt5_", "qt_",
    "rclcpp_components_", "return", "roslaunch_", "roslint_", "rosidl_", "separate_arguments",
    "set", "source_group", "string", "target_", "unset", "variable_watch",
)  # fmt: skip
_PROGRAMS = ("PROGRAMS", INSTALL_WORDS)
_FOLDERS = ("CATKIN_", "CMAKE_INSTALL_")
_NO_SCRIPTS = ("CODE", "SCRIPT")
_PROGRAM_COMMANDS = ("add_executable", "ament_auto_add_executable")
_WORD = re.compile(rb"[A-Za-z_][\w.-]*")
_HEADERS = (".h", ".hh", ".hpp", ".hxx")
_FINDING = ("ament_auto_find_build_dependencies", "catkin_simple", "find_package")
_EXPORTS = ("ament_export_dependencies", "ament_export_targets")


class Install(NamedTuple):
    """How a script is installed, and what says so.

    Attributes:
        how: as what.
        place: what says so.
        where: the folder, from the install prefix.
    """

    how: How
    place: Place
    where: str


@dataclass(frozen=True)
class Lists:
    """What is known of a CMakeLists.txt; of a package without one, nothing.

    Attributes:
        lists: the file, None where it is not read.
        installs: scripts that are installed, the last call that names each.
        is_open: whether more may be installed than is known.
        targets: the programs.
        built: the sources of programs and libraries that are built in any case.
        exported: the packages that are handed on.
        is_settled: whether all programs are known.
        words: what is given to commands that are not known; None where names are computed.
        python_folders: the folders that are installed as Python packages.
        installs_nodes: whether something is installed where nodes are looked for.
        hands_headers_on: whether others may include its headers, as far as it is known.
    """

    lists: CMakeLists | None = None
    installs: Mapping[str, Install] = field(default_factory=dict)
    is_open: bool = False
    targets: tuple[Target, ...] = ()
    built: tuple[str, ...] = ()
    exported: frozenset[str] = frozenset()
    is_settled: bool = False
    words: frozenset[str] | None = None
    python_folders: tuple[str, ...] = ()
    installs_nodes: bool = False
    hands_headers_on: bool = True

    @property
    def programs(self) -> frozenset[str]:
        """The scripts that are installed for people to start."""
        return frozenset(
            name for name, each in self.installs.items() if not each.where.startswith("share/")
        )

    @property
    def placed(self) -> frozenset[str]:
        """The names of the files that are installed where nodes are looked for, however."""
        where = f"lib/{self.lists.name}" if self.lists is not None else ""
        return frozenset(
            name.rpartition("/")[2]
            for name, each in self.installs.items()
            if each.where == where or each.how is How.UNKNOWN
        )


def read_lists(texts: PackageTexts) -> Lists:
    """Return what is known of a package's CMakeLists.txt."""
    source = texts.source
    lists, _ = read_shared(source.texts[CMAKE_LISTS], source.folder / CMAKE_LISTS)
    if lists is None:
        return Lists(is_open=True)
    lists = follow(lists, lambda name: texts.get(name) if name in source.names else None)
    unknown = [each for each in lists.calls if not _is_known(each)]
    blocks = lists.opaque
    is_computed = _has_open_names(lists) or _has_open_programs(lists)
    is_open = bool(unknown or blocks) or any(map(_installs_more, lists.calls))
    installs = dict(_installs(lists, source.names))
    programs = tuple(_targets(lists, is_open))
    where = f"lib/{lists.name}"
    return Lists(
        lists=lists,
        installs=installs,
        is_open=is_open,
        targets=programs,
        built=tuple(dict.fromkeys(_sources(lists, source.names))),
        exported=frozenset(_exported(lists)),
        is_settled=not unknown and not blocks and not is_computed,
        words=None if is_computed else frozenset(x.value for call in unknown for x in call.items),
        python_folders=tuple(_python_folders(lists)),
        installs_nodes=any(each.is_installed for each in programs)
        or any(each.where == where for each in installs.values()),
        hands_headers_on=is_open or any(map(_hands_headers_on, lists.calls)),
    )


def finds_declared(lists: Lists) -> bool:
    """Tell whether CMake looks for whatever package.xml declares, without naming it."""
    return lists.lists is not None and any(
        call.command.name == "ament_auto_find_build_dependencies" and not call.items
        for call in lists.lists.calls
    )


def _hands_headers_on(call: Call) -> bool:
    """Tell whether a command installs headers, or says to others where they are."""
    if call.command.name == "ament_auto_package":
        return True
    is_one = call.command.name.startswith(("ament_export_", "catkin_package", "install"))
    return is_one and any(
        each.value != "INCLUDE_DIRS"
        and ("include" in each.value.lower() or each.value.endswith(_HEADERS))
        for each in call.items
    )


def _is_known(call: Call) -> bool:
    """Tell whether a command is one that makes no program by itself, or one that is read."""
    name = call.command.name
    if call.is_followed or is_for_tests(call.conditions):
        return True
    if name == "include":
        file = call.items[0].value if call.items else ""
        return file.startswith(MODULES) and not file.endswith(".cmake")
    if name.endswith("_executable") and name not in _PROGRAM_COMMANDS:
        return False
    return name.startswith(_KNOWN)


def _installs_more(call: Call) -> bool:
    """Tell whether a call installs what is not known."""
    values = [each.value for each in call.items]
    if call.command.name == "ament_python_install_package":
        return "SCRIPTS_DESTINATION" in values
    if call.command.name not in ("install", "catkin_install_python"):
        return False
    if not values:
        return not call.is_whole
    return values[0] in _NO_SCRIPTS or values[0].startswith("${")


def _has_open_names(lists: CMakeLists) -> bool:
    """Tell whether programs are built whose names are not known."""
    return (
        any("${" in executable_of(lists, each) + each.what for each in targets(lists))
        or any("${" in each.what for each in registered_components(lists))
        or any(x.value == "OUTPUT_NAME" for call in lists.named("set_property") for x in call.items)
    )


def _has_open_programs(lists: CMakeLists) -> bool:
    """Tell whether programs are installed whose names are not known."""
    return any(
        _is_open(call) or any("${" in each.value for each in call.section(*_PROGRAMS))
        for call in lists.named("install", "catkin_install_python")
        if call.section(*_PROGRAMS)
    )


def _is_open(call: Call) -> bool:
    """Tell whether a call is given a list that may have more than is known, a folder apart."""
    return any(not name.startswith(_FOLDERS) for name in call.open_lists)


def _place(span: tuple[int, int]) -> Place:
    return Place(CMAKE_LISTS, Span(*span))


def _installs(lists: CMakeLists, names: frozenset[str]) -> Iterator[tuple[str, Install]]:
    """Yield the scripts that calls install, those of later calls later."""
    for call in lists.named("install", "catkin_install_python"):
        where = set_destination(lists, call)
        kept = {each.value for each in call.items}
        for kind in ("PROGRAMS", "FILES"):
            how = How.PYTHON if call.command.name == "catkin_install_python" else How.PROGRAM
            if kind == "FILES" and not kept & {"OWNER_EXECUTE", "WORLD_EXECUTE"}:
                how = How.PLAIN
            if call.conditions or "CONFIGURATIONS" in kept or where == UNKNOWN:
                how = How.UNKNOWN
            for item in call.section(kind, INSTALL_WORDS):
                place = _place((item.argument.start, item.argument.end))
                path = in_package(item.value)
                found = [path]
                if item.is_pattern or "${" in path:
                    stem = path.rpartition("/")[2]
                    found = [each for each in names if _fits(each, path, item.is_pattern, stem)]
                for each in found:
                    yield each, Install(how, place, where)
        yield from _folders(lists, call, where, kept, names)


def _fits(name: str, path: str, is_pattern: bool, stem: str) -> bool:
    """Tell whether what a call installs may be a file, where it is a pattern, or computed."""
    if is_pattern:
        return matches(name, path)
    return name.rpartition("/")[2] == stem or "${" in stem


def _folders(
    lists: CMakeLists, call: Call, where: str, kept: set[str], names: frozenset[str]
) -> Iterator[tuple[str, Install]]:
    for item in call.section("DIRECTORY", INSTALL_WORDS):
        entry = Entry(in_package(item.value), item, call, where)
        how = How.PLAIN
        if "USE_SOURCE_PERMISSIONS" in kept:
            how = How.KEPT
        elif "FILE_PERMISSIONS" in kept or "PERMISSIONS" in kept:
            how = How.PROGRAM if kept & {"OWNER_EXECUTE", "WORLD_EXECUTE"} else How.PLAIN
        if call.conditions or where == UNKNOWN or "${" in entry.what:
            how = How.UNKNOWN
        place = _place((item.argument.start, item.argument.end))
        inner = entry.what.rstrip("/")
        for each in names:
            is_within = inner in ("", ".") or each.startswith(f"{inner}/") or "${" in inner
            if not (each.endswith(".py") or "." not in each.rpartition("/")[2]) or not is_within:
                continue
            # `lib/PACKAGE/scripts/x.py` is not where a node is looked for.
            is_there = how is How.UNKNOWN or covers(entry, each, where)
            if is_there or where.startswith("share/"):
                yield each, Install(how, place, where)


def _targets(lists: CMakeLists, is_open: bool) -> Iterator[Target]:
    """Yield the programs that are built in any case, and whether nodes are looked for there."""
    auto = bool(lists.named("ament_auto_package"))
    open_targets = any(
        _is_open(call) or any("${" in x.value for x in call.section("TARGETS", INSTALL_WORDS))
        for call in lists.named("install")
        if any(each.value == "TARGETS" for each in call.items)
    )
    installing = defaultdict(list)
    for call in lists.named("install"):
        for each in call.section("TARGETS", INSTALL_WORDS):
            installing[each.value].append(call)
    for target in targets(lists):
        if target.call.command.name == "add_library" or target.call.conditions:
            continue
        name = target.what
        found = installing[name]
        wheres = {program_destination(lists, call) for call in found}
        item = target.call.items[0]
        place = _place((item.argument.start, item.argument.end))
        sources = tuple(sources_of(target))
        is_auto = auto and target.call.command.name == "ament_auto_add_executable"
        if f"lib/{lists.name}" in wheres or is_auto:
            yield Target(executable_of(lists, target), sources, place, True)
        elif is_open or open_targets or UNKNOWN in wheres or "${" in name or not item.is_own:
            yield Target(executable_of(lists, target), sources, place, None)
        else:
            where = _place(found[-1].command.span) if found else None
            yield Target(executable_of(lists, target), sources, place, False, where)


def _sources(lists: CMakeLists, names: frozenset[str]) -> Iterator[str]:
    """Yield the sources of what is built in any case, those of patterns too."""
    for target in targets(lists):
        for item in () if target.call.conditions else target.call.items[1:]:
            path = in_package(item.value)
            if item.is_pattern:
                yield from (each for each in names if matches(each, path))
            elif "${" not in path:
                yield path


def _exported(lists: CMakeLists) -> Iterator[str]:
    yield from (each.what for each in exported(lists))
    for call in lists.named(*_EXPORTS):
        yield from (each.value for each in call.items)
    if lists.named("ament_auto_package"):
        yield "*"


def _python_folders(lists: CMakeLists) -> Iterator[str]:
    for call in lists.named("ament_python_install_package"):
        values = [each.value for each in call.items]
        if "PACKAGE_DIR" in values[:-1]:
            yield in_package(values[values.index("PACKAGE_DIR") + 1]).rstrip("/")
        elif values:
            yield values[0]


def cmake_words(texts: PackageTexts, lists: Lists) -> frozenset[str]:
    """Return the words of all that CMake may read, of a package whose programs are not all known.

    The names of files are among them: many make a program of each.
    """
    if lists.is_settled:
        return frozenset()
    found = {each.partition(".")[0] for each in texts.bases}
    for name in texts.names:
        if name.endswith((CMAKE_LISTS, ".cmake")):
            found.update(each.decode() for each in _WORD.findall(texts.get(name) or b""))
    return frozenset(found)


def found_packages(lists: Lists) -> dict[str, Place]:
    """Return the packages that CMake looks for, each with the first place that says so."""
    calls = () if lists.lists is None else lists.lists.named(*_FINDING)
    found: dict[str, Place] = {}
    for call in calls:
        for item in call.items:
            found.setdefault(item.value, _place((item.argument.start, item.argument.end)))
    return found


def linked_packages(lists: Lists, names: Iterable[str]) -> frozenset[str]:
    """Return the packages among some that commands name which do more than look for them."""
    words = {
        item.value
        for call in (() if lists.lists is None else lists.lists.calls)
        if call.command.name not in (*_FINDING, "list", "message", "project", "set")
        for item in call.items
    }
    return frozenset(
        name
        for name in names
        if name in words
        or any(each.startswith((f"{name}::", f"{name}_gen", f"${{{name}_")) for each in words)
    )
