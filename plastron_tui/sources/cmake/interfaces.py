"""Making types of definition files: `msg/Speed.msg`, `srv/Go.srv`, `action/Dock.action`."""

from __future__ import annotations

from collections import Counter
from pathlib import Path

from plastron_tui.diagnostics import codes
from plastron_tui.sources.build_files import Edited, refusal
from plastron_tui.sources.splices import Splice

from .arguments import insert_argument, insert_first, insert_words
from .changing import Facts, applied, build_type_of, change, into_list, removed, word_of
from .facts import (
    CATKIN,
    CATKIN_INTERFACES,
    INTERFACE_WORDS,
    MESSAGE_WORDS,
    interface_dependencies,
    interfaces,
)
from .places import insert_after, insert_before_end, written_call
from .reader import CMakeLists, read_cmake
from .syntax import Command

_GENERATING = {False: "rosidl_generate_interfaces", True: "generate_messages"}


def add_interface(text: bytes, path: Path, file: str) -> Edited:
    """Make a type of a definition file; nothing changes where it is made already.

    Args:
        text: what is in the CMakeLists.txt.
        path: the CMakeLists.txt.
        file: the file by its path from the package's folder, such as `msg/Speed.msg`.
    """
    return change(text, path, lambda lists: _add(lists, file))


def remove_interface(text: bytes, path: Path, file: str) -> Edited:
    """Make no type of a definition file any more."""
    return change(text, path, lambda lists: _remove(lists, file))


def add_interface_dependency(text: bytes, path: Path, name: str) -> Edited:
    """Name a package whose types the package's own are made of.

    Types have to be made already, unless `catkin` is: `generate_messages` is added for it.
    """
    return change(text, path, lambda lists: _add_dependency(lists, name))


def remove_interface_dependency(text: bytes, path: Path, name: str) -> Edited:
    """Name a package no more whose types the package's own are made of."""
    return change(text, path, lambda lists: _remove_dependency(lists, name))


def builds_types(text: bytes, path: Path) -> bool:
    """Tell whether a file makes types already; one that cannot be read makes none."""
    lists, _ = read_cmake(text, path)
    return lists is not None and any(each.is_plain for each in interfaces(lists))


def add_generating(text: bytes, path: Path) -> Edited:
    """Call `generate_messages`, without which catkin makes no types; nothing changes with one."""
    return change(text, path, _add_generating)


def export_runtime(text: bytes, path: Path) -> Edited:
    """Let what uses the types of an ament package have what they need to run."""
    return change(text, path, _export_runtime)


def check_module(text: bytes, path: Path) -> Edited:
    """Refuse types beside a Python module of the package's name: theirs has the same name.

    Both make the module of that name (rosidl_generator_py, ament_cmake_python); a file that makes
    types already is let be.
    """
    return change(text, path, _check_module)


def _add_generating(lists: CMakeLists) -> bytes:
    calls = lists.named(_GENERATING[True])
    listing = lists.listing
    if any(each.is_plain for each in calls):
        return listing.text
    _check_unconditional(lists, _GENERATING[True])
    call = written_call(listing, _GENERATING[True], "", [])
    return applied(lists, _before_generating(lists, call), Counter(), "generating messages")


def _check_unconditional(lists: CMakeLists, name: str) -> None:
    """Refuse to write a call anew that stands under a condition."""
    listing = lists.listing
    for each in lists.named(name):
        why = f"calls `{name}` under a condition"
        raise refusal(listing.text, listing.path, each.command.span, why)


def _export_runtime(lists: CMakeLists) -> bytes:
    name, runtime = "ament_export_dependencies", "rosidl_default_runtime"
    if any(item.value == runtime for call in lists.named(name) for item in call.items):
        return lists.listing.text
    call = written_call(lists.listing, name, runtime, [])
    return applied(lists, insert_before_end(lists, call), Counter(), f"exporting `{runtime}`")


def _check_module(lists: CMakeLists) -> bytes:
    listing = lists.listing
    if not any(each.is_plain for each in interfaces(lists)):
        for call in lists.named("ament_python_install_package"):
            if call.items and call.items[0].value in (lists.name, "${PROJECT_NAME}"):
                why = f"installs a Python module `{lists.name}`, as the types would be"
                remedy = "leave the package out where the type is made: it gets one of its own then"
                span = call.command.span
                raise refusal(listing.text, listing.path, span, why, codes.EDIT_REFUSED, remedy)
    return listing.text


def _add(lists: CMakeLists, file: str) -> bytes:
    is_catkin = build_type_of(lists) == CATKIN
    if any(each.has(file) for each in interfaces(lists) if each.is_plain):
        return lists.listing.text
    splices = _add_catkin(lists, file) if is_catkin else _add_ament(lists, file)
    more: Facts = Counter({("interface", file, "", ()): 1})
    return applied(lists, splices, more, f"making a type of `{file}`")


def _add_ament(lists: CMakeLists, file: str) -> list[Splice]:
    listing = lists.listing
    calls = [each for each in lists.named(_GENERATING[False]) if each.is_plain and each.items]
    if not calls:
        _check_unconditional(lists, _GENERATING[False])
        first = "${PROJECT_NAME}"
        call = written_call(listing, _GENERATING[False], first, [f'"{file}"'])
        return insert_before_end(lists, call)
    call_ = calls[-1]
    items = call_.section("", INTERFACE_WORDS)[1:]
    if not items:
        return insert_words(call_.items[0].argument, f'"{file}"')
    splices = into_list(lists, call_, items, file)
    if splices is None:
        raise refusal(listing.text, listing.path, call_.command.span, "computes its types")
    return splices


def _add_catkin(lists: CMakeLists, file: str) -> list[Splice]:
    listing = lists.listing
    folder, _, name = file.partition("/")
    if folder not in CATKIN_INTERFACES:
        why = f"begins a file for catkin, where types are not made of `{file}`"
        raise refusal(listing.text, listing.path, (0, 0), why, codes.EDIT_REFUSED)
    command = CATKIN_INTERFACES[folder]
    for call in reversed(lists.named(command)):
        given = call.section("DIRECTORY", MESSAGE_WORDS)
        if not call.is_plain or (given and given[0].value != folder):
            continue
        items = call.section("FILES", MESSAGE_WORDS)
        word = word_of(call.command, "FILES")
        splices = None
        if items:
            splices = into_list(lists, call, items, name)
        elif word is not None:
            splices = insert_first(listing, call.command, word, name)
        if splices is None:
            span = call.command.span
            raise refusal(listing.text, listing.path, span, "computes its types")
        return splices
    written = written_call(listing, command, "FILES", [name])
    return _before_generating(lists, written)


def _before_generating(lists: CMakeLists, call: bytes) -> list[Splice]:
    """Insert a call that has to stand before `generate_messages` and `catkin_package`."""
    listing = lists.listing
    commands = [each for each in listing.statements if isinstance(each, Command)]
    later = [each for each in commands if each.name in ("generate_messages", "catkin_package")]
    names = ("find_package", *CATKIN_INTERFACES.values(), "catkin_python_setup", "project")
    earlier = [each for each in commands if each.name in names]
    if later:
        earlier = [each for each in earlier if each.start < later[0].start]
    return insert_after(listing, earlier[-1], call, blank=True)


def _remove(lists: CMakeLists, file: str) -> bytes:
    found = [each for each in interfaces(lists) if each.is_plain and each.what == file]
    if not found:
        return lists.listing.text
    entry = found[-1]
    path = lists.listing.path
    is_ament = entry.call.command.name == _GENERATING[False]
    section = ("", INTERFACE_WORDS) if is_ament else ("FILES", MESSAGE_WORDS)
    alone = len(entry.call.section(*section)) == (2 if is_ament else 1)
    alone = alone and entry.item.command is entry.call.command

    def add(each: bytes) -> bytes | None:
        return add_interface(each, path, file).text

    less: Facts = Counter({("interface", file, "", ()): 1})
    return removed(lists, entry, less, add, alone)


def _add_dependency(lists: CMakeLists, name: str) -> bytes:
    listing = lists.listing
    is_catkin = build_type_of(lists) == CATKIN
    if any(each.what == name for each in interface_dependencies(lists)):
        return listing.text
    calls = [each for each in lists.named(_GENERATING[is_catkin]) if each.is_plain]
    splices: list[Splice] | None
    if not calls:
        _check_unconditional(lists, _GENERATING[is_catkin])
    if not calls and is_catkin:
        call = written_call(listing, "generate_messages", "DEPENDENCIES", [name])
        splices = _before_generating(lists, call)
    elif not calls:
        why = "begins a file that makes no types"
        raise refusal(listing.text, listing.path, (0, 0), why, codes.EDIT_REFUSED)
    else:
        command = calls[-1].command
        items = calls[-1].section("DEPENDENCIES", INTERFACE_WORDS)
        word = word_of(command, "DEPENDENCIES")
        if items:
            splices = into_list(lists, calls[-1], items, name)
        elif word is not None:
            splices = insert_first(listing, command, word, name)
        else:
            splices = _new_section(lists, command, f"DEPENDENCIES {name}")
        if splices is None:
            raise refusal(listing.text, listing.path, command.span, "computes `DEPENDENCIES`")
    more: Facts = Counter({("interface dependency", name, "", ()): 1})
    return applied(lists, splices, more, f"adding `{name}` to the dependencies")


def _new_section(lists: CMakeLists, command: Command, words: str) -> list[Splice] | None:
    """Insert words as the last arguments of a call, on a line of their own where others have."""
    if not command.arguments:
        return [Splice(command.opening, command.opening, words.encode())]
    return insert_argument(lists.listing, command, command.arguments[-1:], words)


def _remove_dependency(lists: CMakeLists, name: str) -> bytes:
    found = [each for each in interface_dependencies(lists) if each.what == name]
    if not found:
        return lists.listing.text
    entry = found[-1]
    path = lists.listing.path
    less: Facts = Counter({("interface dependency", name, "", ()): 1})

    def add(each: bytes) -> bytes | None:
        return add_interface_dependency(each, path, name).text

    return removed(lists, entry, less, add, False, is_made=True)
