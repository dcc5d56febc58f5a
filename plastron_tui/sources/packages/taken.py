"""Which sources of C++ a package builds, as far as its files of CMake can say.

What is not understood counts as built: a word that may be the name of a source takes it, whatever
the command is that has the word, and a command that nobody knows may build anything.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path
from posixpath import normpath

from plastron_tui.sources.build_files import RefusedError
from plastron_tui.sources.cmake.syntax import Block, Command, Listing, Statement, parse_cmake

SOURCES = (".cpp", ".cc", ".cxx")
_LISTS = "CMakeLists.txt"
_TOKEN = re.compile(r"(?:[\w./+*?@~-]|\$\{[^{}]*\})+")
_VARIABLE = re.compile(r"\$\{([^{}]*)\}")
_PIECE = re.compile(r"\$\{[^{}]*\}|\*|\?|[^$*?]+|\$")
_OWN_FOLDER = "CMAKE_CURRENT_SOURCE_DIR", "CMAKE_CURRENT_LIST_DIR"
_LISTING = frozenset({"add_subdirectory", "subdirs", "add_all_subdirectories"})
_BUILDING = frozenset(
    {"add_compile_definitions", "add_compile_options", "add_custom_command", "add_custom_target",
     "add_definitions", "add_dependencies", "add_executable", "add_library", "add_link_options",
     "add_subdirectory", "add_test", "add_message_files", "add_service_files", "add_action_files",
     "aux_source_directory"}
)  # fmt: skip
_KNOWN = (
    "ament_", "break", "catkin_", "cmake_", "configure_", "continue", "cs_", "cuda_", "define_",
    "doxygen_", "else", "enable_", "end", "execute_process", "export", "fetchcontent_", "file",
    "find_", "foreach", "function", "generate_", "get_", "gtest_", "if", "include", "install",
    "link_", "list", "macro", "mark_as_advanced", "math", "message", "option", "pkg_",
    "pluginlib_", "project", "pybind11_", "qt4_", "qt5_", "qt6_", "qt_", "rclcpp_components_",
    "remove_definitions", "return", "ros1_", "roslaunch_", "roslint_", "rosidl_", "rosbuild_",
    "separate_arguments", "set", "source_group", "string", "target_", "try_", "unset",
    "variable_watch", "while",
)  # fmt: skip
"""How the commands begin that are no way to build a source whose name they do not have."""


def unbuilt_sources(texts: Mapping[str, bytes], sources: Iterable[str]) -> frozenset[str]:
    """Return those of a package's sources that no command of CMake can mean.

    All paths are from the package's folder, with slashes.

    Args:
        texts: its files of CMake: each `CMakeLists.txt`, and what has the ending `.cmake`.
        sources: the sources that are asked for.
    """
    if _LISTS not in texts:
        return frozenset()
    try:
        listings = {name: parse_cmake(text, Path(name)) for name, text in texts.items()}
    except RefusedError:
        return frozenset()
    taken = _Taken(_reached(listings))
    return frozenset(each for each in sources if not taken.has(each))


def _reached(listings: Mapping[str, Listing]) -> dict[str, Listing]:
    """Return the files that CMake may read: a folder that none of them names is not built."""
    found = {name: each for name, each in listings.items() if _base(name) != _LISTS}
    waiting = [_LISTS, *found]
    while waiting:
        name = waiting.pop()
        found[name] = listings[name]
        for command in listings[name].commands():
            if command.name in _LISTING and command.arguments:
                said = command.arguments[0].value
                if command.name != "add_subdirectory" or "$" in said or name.endswith(".cmake"):
                    return dict(listings)
                inner = normpath(f"{_folder(name)}/{said}/{_LISTS}").removeprefix("/")
                if inner in listings and inner not in found:
                    waiting.append(inner)
    return found


class _Taken:
    """The words of a package's files of CMake that may be the names of its sources."""

    def __init__(self, listings: Mapping[str, Listing]) -> None:
        self._folders = tuple(_folder(name) for name in listings if _base(name) == _LISTS)
        self._words: set[str] = set()
        self._stems: set[str] = set()
        self._patterns: set[str] = set()
        self._takes_all = False
        own = {each for listing in listings.values() for each in _defined(listing.statements)}
        project = _project(listings[_LISTS])
        for name, listing in listings.items():
            for command in listing.commands():
                self._read(command, _folder(name), project, own)
        self._whole = [re.compile(each) for each in sorted(self._patterns)]

    def has(self, source: str) -> bool:
        """Tell whether a source may be built."""
        stem = source.rpartition(".")[0]
        if self._takes_all or _base(stem) in self._stems or source in self._words:
            return True
        names = [name for folder in self._folders for name in _below(folder, source)]
        # CMake finds a source whose ending is left out as well.
        return any(
            name in self._words
            or name.rpartition(".")[0] in self._words
            or any(each.fullmatch(name) for each in self._whole)
            for name in names
        )

    def _read(self, command: Command, folder: str, project: str, own: set[str]) -> None:
        values = [each.value.replace("${PROJECT_NAME}", project) for each in command.arguments]
        name = command.name
        if name not in own and name not in _BUILDING and not name.startswith(_KNOWN):
            self._stems.update(_base(token) for value in values for token in _TOKEN.findall(value))
            self._takes_all |= not any(values)
        if name == "include" and any(".." in each for each in values):
            self._takes_all = True
        if name == "aux_source_directory":
            values = ["GLOB", *(f"{each}/*" for each in values[:1])]
        elif name.startswith("ament_auto_add_") and "DIRECTORY" in values:
            values += [f"{each}/*" for each in values[values.index("DIRECTORY") + 1 :]]
        kind = values[0] if values and name in ("file", "aux_source_directory") else ""
        for value in values:
            for token in _TOKEN.findall(value):
                self._take(token, folder, kind)

    def _take(self, token: str, folder: str, kind: str) -> None:
        first = _VARIABLE.match(token)
        if first is not None and first[1] in _OWN_FOLDER:
            token = token[first.end() :].lstrip("/")
        if "$" in token or "*" in token or "?" in token:
            if token.endswith(SOURCES) or "*" in token or "?" in token:
                self._patterns.update(_patterns(token, folder, kind))
            return
        self._words.add(token.removeprefix("./"))
        if token.endswith(SOURCES):
            self._words.add(normpath(f"{folder}/{token}").removeprefix("/"))
        if token.endswith(SOURCES) and kind == "GLOB_RECURSE":
            self._patterns.update(_patterns(token, folder, kind))


def _folder(name: str) -> str:
    return name.rpartition("/")[0]


def _base(name: str) -> str:
    return name.rpartition("/")[2]


def _below(folder: str, source: str) -> Iterator[str]:
    """Yield the path of a source from a folder that it is in."""
    if not folder or source.startswith(f"{folder}/"):
        yield source[len(folder) :].removeprefix("/")


def _defined(statements: tuple[Statement, ...]) -> Iterator[str]:
    """Yield the names of the functions and macros that a file defines."""
    for each in statements:
        if isinstance(each, Block):
            for branch in each.branches:
                if each.kind in ("function", "macro") and branch.opening.arguments:
                    yield branch.opening.arguments[0].value.lower()
                yield from _defined(branch.statements)


def _project(listing: Listing) -> str:
    for command in listing.commands():
        if command.name == "project" and command.arguments:
            return command.arguments[0].value
    return "${PROJECT_NAME}"


def _patterns(token: str, folder: str, kind: str) -> Iterator[str]:
    """Yield what matches the paths that a word may stand for, from any folder that is built."""
    star = "[^/]*" if kind == "GLOB" else ".*"
    pieces = [
        ".*" if each.startswith("$") else {"*": star, "?": "."}.get(each, re.escape(each))
        for each in _PIECE.findall(token.removeprefix("./"))
    ]
    found = "".join(pieces)
    if kind == "GLOB_RECURSE":
        above, slash, base = found.rpartition("/")
        found = f"{above}{slash}(?:.*/)?{base}"
    if found.startswith((".*/", "/")):
        found = f"(?:.*/)?{found.removeprefix('.*').removeprefix('/')}"
    yield found
    if folder and "\\.\\." in found:
        yield ".*"
