"""Installing a script where `rosrun` and `ros2 run` look for it: `lib/PACKAGE`."""

from __future__ import annotations

from collections import Counter
from pathlib import Path

from plastron_tui.sources.build_files import Edited
from plastron_tui.sources.splices import Splice

from .changing import Facts, applied, build_type_of, change, into_list, removed
from .facts import (
    CATKIN,
    INSTALL_WORDS,
    Entry,
    destination_of,
    installs_always,
    programs,
    words_of,
)
from .places import insert_installation, written_call
from .reader import Call, CMakeLists

# With these a call installs every script that it names under its own name, executable.
_PLAIN_WORDS = frozenset({"PROGRAMS", "DESTINATION", "COMPONENT"})


def add_program(text: bytes, path: Path, script: str) -> Edited:
    """Install a script; nothing changes where it is installed already.

    Args:
        text: what is in the CMakeLists.txt.
        path: the CMakeLists.txt.
        script: the script, by its path from the package's folder.
    """
    return change(text, path, lambda lists: _add(lists, script))


def remove_program(text: bytes, path: Path, script: str) -> Edited:
    """Install a script no more; one that was added before leaves the bytes that were there."""
    return change(text, path, lambda lists: _remove(lists, script))


def _named(lists: CMakeLists, script: str) -> list[Entry]:
    """Return what installs a script there, under whatever name, in whatever configuration."""
    where = f"lib/{lists.name}"
    found = [each for each in programs(lists) if each.destination == where]
    return [each for each in found if each.is_plain and each.has(script)]


def _is_installed(lists: CMakeLists, script: str) -> bool:
    """Whether a script is surely installed under its own name, to be run."""
    name = script.rpartition("/")[2]
    found = [
        each.call
        for each in _named(lists, script)
        if installs_always(each.call) and _renamed(each.call) in ("", name)
    ]
    # Of two calls that write one file the last one counts.
    return bool(found) and _may_run(found[-1])


def _may_run(call: Call) -> bool:
    """Whether the permissions that a call gives let its owner run what it installs."""
    given = {each.value for each in call.section("PERMISSIONS", INSTALL_WORDS)}
    return not given or given >= {"OWNER_READ", "OWNER_EXECUTE"}


def _renamed(call: Call) -> str:
    """Return the name that a call gives what it installs, "" for its own."""
    return next((each.value for each in call.section("RENAME", INSTALL_WORDS)), "")


def _fact(lists: CMakeLists, script: str) -> Facts:
    return Counter({("program", script, f"lib/{lists.name}", ()): 1})


def _add(lists: CMakeLists, script: str) -> bytes:
    is_catkin = build_type_of(lists) == CATKIN
    if _is_installed(lists, script):
        return lists.listing.text
    more = _fact(lists, script)
    splices = _into_call(lists, script)
    if splices is None:
        splices = _new_call(lists, script, is_catkin)
    return applied(lists, splices, more, f"installing `{script}`")


def _into_call(lists: CMakeLists, script: str) -> list[Splice] | None:
    """Insert a script into the last call that installs scripts there.

    What installs it otherwise comes before, as the last one counts.
    """
    calls = lists.named("catkin_install_python") or lists.named("install")
    others = max((each.call.command.end for each in _named(lists, script)), default=0)
    for call in reversed(calls):
        if call.command.start < others:
            continue
        items = call.section("PROGRAMS", INSTALL_WORDS)
        is_there = call.is_plain and destination_of(lists, call) == f"lib/{lists.name}"
        if not items or not is_there or not words_of(call) <= _PLAIN_WORDS:
            continue
        last = items[-1].value
        folder = last[: len(last) - len(last.split("}/")[-1])] if last.startswith("${") else ""
        splices = into_list(lists, call, items, folder + script)
        if splices is not None:
            return splices
    return None


def _new_call(lists: CMakeLists, script: str, is_catkin: bool) -> list[Splice]:
    name = "catkin_install_python" if is_catkin and script.endswith(".py") else "install"
    where = "${CATKIN_PACKAGE_BIN_DESTINATION}" if is_catkin else "lib/${PROJECT_NAME}"
    lines = [script, f"DESTINATION {where}"]
    return insert_installation(lists, written_call(lists.listing, name, "PROGRAMS", lines))


def _remove(lists: CMakeLists, script: str) -> bytes:
    found = [each for each in _named(lists, script) if each.what == script]
    if not found:
        return lists.listing.text
    plain = [each for each in found if words_of(each.call) <= _PLAIN_WORDS]
    entry = (plain or found)[-1]
    path = lists.listing.path
    alone = len(entry.call.section("PROGRAMS", INSTALL_WORDS)) == 1
    alone = alone and entry.item.command is entry.call.command

    def add(each: bytes) -> bytes | None:
        return add_program(each, path, script).text

    return removed(lists, entry, _fact(lists, script), add, alone)
