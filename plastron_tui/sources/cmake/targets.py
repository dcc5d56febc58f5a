"""Building a node from its source: a program, or a library that another process loads.

Sources: the wiki page "catkin/CMakeLists.txt" and catkin's how-to pages on executables and
libraries; for ROS 2 the "ament_cmake user documentation" and that of rclcpp_components.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path
from typing import NamedTuple

from plastron_tui.diagnostics import Diagnostic, codes
from plastron_tui.sources.build_files import Edited, RefusedError, matches, refusal
from plastron_tui.sources.splices import Splice

from .changing import Facts, applied, build_type_of, change
from .dependencies import add_dependency
from .facts import CATKIN, sources_of, targets
from .places import insert_after, insert_before_end, insert_installation, written_call
from .reader import CMakeLists, in_package
from .shares import add_shared
from .syntax import Command

_PREFIX = "${PROJECT_NAME}"
_COMPILED = "CXX"
_HEADERS = "${catkin_INCLUDE_DIRS}"
_OWN_TYPES = "cpp_typesupport_target"
_NONE: Facts = Counter()

OF_TARGETS = (
    "add_dependencies",
    "add_executable",
    "add_library",
    "ament_target_dependencies",
    "rclcpp_components_register_node",
    "rclcpp_components_register_nodes",
    "set_target_properties",
    "target_compile_features",
    "target_compile_options",
    "target_include_directories",
    "target_link_libraries",
)
"""The commands about targets, below which a new one belongs."""

_BUILDING = (
    "add_executable",
    "add_library",
    "ament_auto_add_executable",
    "ament_auto_add_library",
    "cs_add_executable",
    "cs_add_library",
)
"""The commands that build something of sources: those of CMake, ament_cmake_auto, catkin_simple."""

# What stands before the first target.
_BEFORE_TARGETS = (
    "catkin_package",
    "include_directories",
    "rosidl_generate_interfaces",
    "rosidl_get_typesupport_target",
)


class NewTarget(NamedTuple):
    """A node that is to be built.

    Attributes:
        executable: what one starts it by.
        source: its source, by its path from the package's folder.
        headers: the folder of its headers, by its path in the package; "" for none.
        packages: the packages that it is built with.
        linked: their targets that it is linked to, in ROS 2.
        plugin: the class that it is loaded as, None for a program.
        has_own_types: whether it uses types of its own package.
        plugins_file: the description of plugins that has to be installed, "" for none.
    """

    executable: str
    source: str
    headers: str
    packages: tuple[str, ...]
    linked: tuple[str, ...]
    plugin: str | None = None
    has_own_types: bool = False
    plugins_file: str = ""

    @property
    def stem(self) -> str:
        """The name of its source, without an ending."""
        return self.source.rpartition("/")[2].rpartition(".")[0]


_Step = Callable[[CMakeLists], bytes]


def add_target(text: bytes, path: Path, new: NewTarget) -> Edited:
    """Build a node, and install it; nothing changes where its source is built already.

    Args:
        text: what is in the CMakeLists.txt.
        path: the CMakeLists.txt.
        new: the node.
    """
    edited = change(text, path, partial(_unpatterned, source=new.source))
    if edited.text is None:
        return edited
    for name in new.packages:
        edited = add_dependency(text, path, name)
        if edited.text is None:
            return edited
        text = edited.text
    for step in _steps(new):
        edited = change(text, path, step)
        if edited.text is None:
            return edited
        text = edited.text
    return add_shared(text, path, new.plugins_file) if new.plugins_file else Edited(text)


def target_of(lists: CMakeLists, new: NewTarget) -> str:
    """Return the name of a node's target as it is written, like those of the file.

    All packages that catkin_make builds are one build, in which a name counts once; libraries of
    several packages may be in one folder.
    """
    is_catkin = build_type_of(lists) == CATKIN
    if not is_catkin:
        is_plain = new.plugin is None and new.stem != lists.name
        return new.stem if is_plain else f"{_PREFIX}_{new.stem}"
    there = [_first_word(lists, each.call.command) for each in targets(lists)]
    is_plain = bool(there) and not any(_PREFIX in each for each in there)
    return new.stem if is_plain else f"{_PREFIX}_{new.stem}"


def _first_word(lists: CMakeLists, command: Command) -> str:
    if not command.arguments:
        return ""
    first = command.arguments[0]
    return lists.listing.text[first.start : first.end].decode().strip('"')


def _steps(new: NewTarget) -> Iterator[_Step]:
    """Yield what writes a command each; the first ones stand before all targets."""
    yield partial(_with_language, new=new)
    yield partial(_with_headers, new=new)
    yield partial(_with_own_types, new=new)
    yield partial(_with_target, new=new)
    for each in (_renamed, _compiled, _headed, _ordered, _linked, _registered):
        yield partial(_below, new=new, words_of=each)
    yield partial(_installed, new=new)


def _is_built(lists: CMakeLists, new: NewTarget) -> bool:
    return any(new.source in sources_of(each) for each in targets(lists))


def _with_language(lists: CMakeLists, new: NewTarget) -> bytes:
    """Let a project compile that has said that it does not (`project` of CMake)."""
    del new
    listing = lists.listing
    found = [each for each in listing.statements if isinstance(each, Command)]
    project = next((each for each in found if each.name == "project"), None)
    values = [] if project is None else [each.value for each in project.arguments]
    is_limited = "NONE" in values or "LANGUAGES" in values
    # They may stand behind the name, without a word before them.
    is_limited = is_limited or "C" in values[1:]
    if project is None or not is_limited or _COMPILED in values or lists.named("enable_language"):
        return listing.text
    call = written_call(listing, "enable_language", _COMPILED, [])
    after = insert_after(listing, project, call, blank=False)
    return applied(lists, after, _NONE, "compiling")


def _with_headers(lists: CMakeLists, new: NewTarget) -> bytes:
    """Let catkin's nodes find headers: those of packages, and those of their own."""
    text = lists.listing.text
    if build_type_of(lists) != CATKIN or _is_built(lists, new):
        return text
    there = {each.value for call in lists.named("include_directories") for each in call.items}
    there |= {_first_word(lists, each.command) for each in lists.named("include_directories")}
    written = text.replace(b" ", b"")
    words = [new.headers] if new.headers and new.headers not in there else []
    words += [] if _HEADERS.encode() in written else [_HEADERS]
    if not words:
        return text
    call = written_call(lists.listing, "include_directories", " ".join(words), [])
    return applied(lists, _before_targets(lists, call), _NONE, "finding headers")


def _with_own_types(lists: CMakeLists, new: NewTarget) -> bytes:
    """Let nodes of ROS 2 be linked to the types of their own package."""
    text = lists.listing.text
    is_there = bool(lists.named("rosidl_get_typesupport_target"))
    if not new.has_own_types or build_type_of(lists) == CATKIN or is_there:
        return text
    words = f"{_OWN_TYPES} ${{PROJECT_NAME}} rosidl_typesupport_cpp"
    call = written_call(lists.listing, "rosidl_get_typesupport_target", words, [])
    return applied(lists, _before_targets(lists, call), _NONE, "finding its types")


def _with_target(lists: CMakeLists, new: NewTarget) -> bytes:
    listing = lists.listing
    if _is_built(lists, new):
        return listing.text
    written = target_of(lists, new)
    name = written.replace(_PREFIX, lists.name or "")
    if any(each.what == name for each in targets(lists)):
        message = f"`{listing.path.name}` has another target `{name}` already"
        raise RefusedError(Diagnostic(codes.EDIT_REFUSED, message, file=listing.path))
    verb = "add_executable" if new.plugin is None else "add_library"
    kind = "" if new.plugin is None or build_type_of(lists) == CATKIN else "SHARED "
    call = written_call(listing, verb, f"{written} {kind}{new.source}", [])
    more: Facts = Counter({("target", name, "", ()): 1})
    return applied(lists, _beside_targets(lists, call), more, f"building `{new.source}`")


def _unpatterned(lists: CMakeLists, source: str) -> bytes:
    """Refuse a source that another target takes for one of its own, of two `main`s one too many.

    Raises:
        RefusedError: a target is built of all files like it.
    """
    found = [x for x in lists.named("file") if x.items and x.items[0].value.startswith("GLOB")]
    names = {x.items[1].value for x in found if any(_is_like(source, y.value) for y in x.items[2:])}
    folder = source.rpartition("/")[0]
    for call in lists.named("aux_source_directory"):
        if len(call.items) > 1 and in_package(call.items[0].value).rstrip("/") == folder:
            names.add(call.items[1].value)
    for call in lists.named(*_BUILDING):
        loops = [each for each in call.conditions if each.lower().startswith("foreach")]
        words = re.findall(r"[\w-]+", " ".join((*(x.value for x in call.items), *loops)))
        if names & {*words} or any(x.is_pattern and _is_like(source, x.value) for x in call.items):
            why = f"builds all files that are like `{source}`"
            span = call.command.start, call.command.end
            help_ = "name its sources one by one there"
            raise refusal(lists.listing.text, lists.listing.path, span, why, remedy=help_)
    return lists.listing.text


def _is_like(source: str, pattern: str) -> bool:
    return matches(source, in_package(pattern))


def _beside_targets(lists: CMakeLists, call: bytes) -> list[Splice]:
    """Insert a call below all that is said of targets, or else where the first one belongs."""
    listing = lists.listing
    commands = [each for each in listing.statements if isinstance(each, Command)]
    found = [each for each in commands if each.name in OF_TARGETS]
    if found:
        return insert_after(listing, found[-1], call, blank=True)
    return _before_targets(lists, call)


def _before_targets(lists: CMakeLists, call: bytes) -> list[Splice]:
    """Insert a call above the first target, below what has to be said before."""
    listing = lists.listing
    commands = [each for each in listing.statements if isinstance(each, Command)]
    before = [each for each in commands if each.name in (*_BEFORE_TARGETS, "find_package")]
    if before:
        return insert_after(listing, before[-1], call, blank=True)
    return insert_before_end(lists, call)


def _below(
    lists: CMakeLists,
    new: NewTarget,
    words_of: Callable[[CMakeLists, NewTarget], tuple[str, str, list[str]] | None],
) -> bytes:
    """Write one more command about the node's target, below those that there are."""
    listing = lists.listing
    said = words_of(lists, new)
    built = next((x for x in targets(lists) if new.source in sources_of(x)), None)
    if said is None or built is None:
        return listing.text
    verb, first, lines = said
    target = _first_word(lists, built.call.command)
    about = [
        each
        for each in listing.statements
        if isinstance(each, Command) and _first_word(lists, each) == target
    ]
    # What is installed, which is written last, was there before.
    if not about or any(each.name == verb for each in about) or _is_installed(lists, new):
        return listing.text
    call = written_call(listing, verb, f"{target} {first}".rstrip(), lines)
    after = insert_after(listing, about[-1], call, blank=False)
    return applied(lists, after, _NONE, f"building `{new.source}`")


def _is_installed(lists: CMakeLists, new: NewTarget) -> bool:
    built = next((each for each in targets(lists) if new.source in sources_of(each)), None)
    installing = [each for each in lists.named("install") if each.items]
    return built is not None and any(
        each.items[0].value == "TARGETS" and built.what in [item.value for item in each.items]
        for each in installing
    )


def _renamed(lists: CMakeLists, new: NewTarget) -> tuple[str, str, list[str]] | None:
    if new.plugin is not None or target_of(lists, new) == new.executable:
        return None
    words = f"PROPERTIES OUTPUT_NAME {new.executable}"
    words += ' PREFIX ""' if build_type_of(lists) == CATKIN else ""
    return "set_target_properties", words, []


def _compiled(lists: CMakeLists, _: NewTarget) -> tuple[str, str, list[str]] | None:
    if build_type_of(lists) == CATKIN:
        return None
    return "target_compile_features", "PUBLIC cxx_std_17", []


def _headed(lists: CMakeLists, new: NewTarget) -> tuple[str, str, list[str]] | None:
    if build_type_of(lists) == CATKIN or not new.headers:
        return None
    return (
        "target_include_directories",
        "PUBLIC",
        [
            f"$<BUILD_INTERFACE:${{CMAKE_CURRENT_SOURCE_DIR}}/{new.headers}>",
            "$<INSTALL_INTERFACE:include/${PROJECT_NAME}>",
        ],
    )


def _ordered(lists: CMakeLists, _: NewTarget) -> tuple[str, str, list[str]] | None:
    if build_type_of(lists) != CATKIN:
        return None
    words = "${${PROJECT_NAME}_EXPORTED_TARGETS} ${catkin_EXPORTED_TARGETS}"
    return "add_dependencies", words, []


def _linked(lists: CMakeLists, new: NewTarget) -> tuple[str, str, list[str]] | None:
    if build_type_of(lists) == CATKIN:
        return "target_link_libraries", "${catkin_LIBRARIES}", []
    own = [f"${{{_OWN_TYPES}}}"] if new.has_own_types else []
    return "target_link_libraries", "PUBLIC", [*new.linked, *own]


def _registered(lists: CMakeLists, new: NewTarget) -> tuple[str, str, list[str]] | None:
    if build_type_of(lists) == CATKIN or new.plugin is None:
        return None
    lines = [f'PLUGIN "{new.plugin}"', f"EXECUTABLE {new.executable}"]
    return "rclcpp_components_register_node", "", lines


def _installed(lists: CMakeLists, new: NewTarget) -> bytes:
    listing = lists.listing
    built = next((each for each in targets(lists) if new.source in sources_of(each)), None)
    if built is None or _is_installed(lists, new):
        return listing.text
    target = _first_word(lists, built.call.command)
    is_catkin = build_type_of(lists) == CATKIN
    if new.plugin is None:
        where = "${CATKIN_PACKAGE_BIN_DESTINATION}" if is_catkin else "lib/${PROJECT_NAME}"
        lines = [f"{'RUNTIME ' if is_catkin else ''}DESTINATION {where}"]
    else:
        library = "${CATKIN_PACKAGE_LIB_DESTINATION}" if is_catkin else "lib"
        program = "${CATKIN_GLOBAL_BIN_DESTINATION}" if is_catkin else "bin"
        lines = [f"{word} DESTINATION {library}" for word in ("ARCHIVE", "LIBRARY")]
        lines.append(f"RUNTIME DESTINATION {program}")
    call = written_call(listing, "install", f"TARGETS {target}", lines)
    return applied(lists, insert_installation(lists, call), _NONE, f"installing `{new.source}`")
