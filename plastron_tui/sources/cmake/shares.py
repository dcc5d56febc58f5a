"""Installing what lies beside the code, launch files and configuration, in `share/PACKAGE`."""

from __future__ import annotations

from collections import Counter
from pathlib import Path

from plastron_tui.sources.build_files import Edited, refusal
from plastron_tui.sources.splices import Splice

from .changing import Facts, applied, build_type_of, change, into_list, removed
from .facts import (
    CATKIN,
    INSTALL_WORDS,
    Entry,
    covers,
    destination_of,
    installs_always,
    shared,
    words_of,
)
from .places import insert_installation, written_call
from .reader import CMakeLists

_PLAIN_WORDS = frozenset({"DESTINATION", "COMPONENT", "USE_SOURCE_PERMISSIONS"})


def add_shared(text: bytes, path: Path, file: str) -> Edited:
    """Install the folder of a file, so that it is found at its path below `share/PACKAGE`.

    A file that is in no folder is installed by itself.

    Nothing changes where what is installed covers the file.

    Args:
        text: what is in the CMakeLists.txt.
        path: the CMakeLists.txt.
        file: the file by its path from the package's folder, such as `launch/x.launch.xml`.
    """
    return change(text, path, lambda lists: _add(lists, file))


def remove_shared(text: bytes, path: Path, file: str, *, keep_folder: bool = False) -> Edited:
    """Install a file no more, nor its folder, as far as one of both is named.

    Args:
        text: what is in the CMakeLists.txt.
        path: the CMakeLists.txt.
        file: the file by its path from the package's folder.
        keep_folder: whether its folder has other files, and stays installed.
    """
    return change(text, path, lambda lists: _remove(lists, file, keep_folder))


def _installable(file: str) -> tuple[str, str]:
    """Return the word of `install` for a file, and what stands behind it: its first folder."""
    folder, sign, _ = file.partition("/")
    return ("DIRECTORY", folder) if sign else ("FILES", file)


def _fact(what: str, destination: str) -> Facts:
    return Counter({("shared", what, destination, ()): 1})


def _add(lists: CMakeLists, file: str) -> bytes:
    is_catkin = build_type_of(lists) == CATKIN
    (kind, what), share = _installable(file), f"share/{lists.name}"
    where = f"{share}/{file}".rpartition("/")[0]
    listing = lists.listing
    found = [each for each in shared(lists) if each.is_plain]
    sure = [x for x in found if installs_always(x.call) and "RENAME" not in words_of(x.call)]
    if any(covers(each, file, where) for each in sure):
        return listing.text
    entry = next((each for each in found if each.what.rstrip("/") == what), None)
    if entry is not None:
        why = f"installs `{what}`, and leaves out `{file}` or puts it somewhere else"
        if what == file:
            why = f"installs `{file}` in a way of its own"
        raise refusal(listing.text, listing.path, entry.call.command.span, why)
    splices = _into_call(lists, kind, what)
    if splices is None:
        to = "${CATKIN_PACKAGE_SHARE_DESTINATION}" if is_catkin else "share/${PROJECT_NAME}"
        call = written_call(listing, "install", kind, [what, f"DESTINATION {to}"])
        splices = insert_installation(lists, call)
    return applied(lists, splices, _fact(what, share), f"installing `{what}`")


def _into_call(lists: CMakeLists, kind: str, what: str) -> list[Splice] | None:
    """Insert a file or a folder beside others that go to `share/PACKAGE` whole."""
    for call in reversed(lists.named("install", "ament_auto_package")):
        if not call.is_plain:
            continue
        if call.command.name == "install":
            items = call.section(kind, INSTALL_WORDS)
            is_there = destination_of(lists, call) == f"share/{lists.name}"
            is_whole = words_of(call) <= {kind, *_PLAIN_WORDS}
        else:
            items = call.section("INSTALL_TO_SHARE", {"INSTALL_TO_SHARE", "INSTALL_TO_PATH"})
            is_there = is_whole = True
        if not items or not is_there or not is_whole:
            continue
        # Of a folder that ends in `/`, what is in it is installed, not the folder.
        if any(each.value.endswith("/") for each in items):
            continue
        splices = into_list(lists, call, items, what)
        if splices is not None:
            return splices
    return None


def _remove(lists: CMakeLists, file: str, keep_folder: bool) -> bytes:
    _, what = _installable(file)
    share = f"share/{lists.name}"
    named = [each for each in shared(lists) if each.is_plain and each.destination]
    found = [each for each in named if each.what == file and _is_below(each, share)]
    if not found and not keep_folder:
        found = [each for each in named if each.what == what and each.destination == share]
    if not found:
        return lists.listing.text
    entry = found[-1]
    path = lists.listing.path

    def add(each: bytes) -> bytes | None:
        return add_shared(each, path, file).text

    return removed(lists, entry, _fact(entry.what, entry.destination), add, _is_alone(entry))


def _is_below(entry: Entry, folder: str) -> bool:
    return f"{entry.destination}/".startswith(f"{folder}/")


def _is_alone(entry: Entry) -> bool:
    named = [
        each for kind in ("FILES", "DIRECTORY") for each in entry.call.section(kind, INSTALL_WORDS)
    ]
    return entry.call.command.name == "install" and len(named) == 1
