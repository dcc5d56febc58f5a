"""Installing what lies beside the code, launch files and configuration, in `share/PACKAGE`."""

from __future__ import annotations

from collections import Counter
from pathlib import Path

from plastron_tui.sources.build_files import Edited, refusal
from plastron_tui.sources.splices import Splice

from .changing import Facts, applied, build_type_of, change, into_list, removed
from .facts import CATKIN, INSTALL_WORDS, Entry, covers, destination_of, shared
from .places import insert_installation, written_call
from .reader import CMakeLists


def add_shared(text: bytes, path: Path, file: str) -> Edited:
    """Install the folder of a file, so that it is found at its path below `share/PACKAGE`.

    Nothing changes where what is installed covers the file.

    Args:
        text: what is in the CMakeLists.txt.
        path: the CMakeLists.txt.
        file: the file by its path from the package's folder, such as `launch/x.launch.xml`.
    """
    return change(text, path, lambda lists: _add(lists, file))


def remove_shared(text: bytes, path: Path, file: str) -> Edited:
    """Install the folder of a file no more; what names other files besides is left as it is."""
    return change(text, path, lambda lists: _remove(lists, file))


def _folder(file: str) -> str:
    return file.partition("/")[0]


def _fact(lists: CMakeLists, what: str) -> Facts:
    return Counter({("shared", what, f"share/{lists.name}", ()): 1})


def _add(lists: CMakeLists, file: str) -> bytes:
    is_catkin = build_type_of(lists) == CATKIN
    folder, share = _folder(file), f"share/{lists.name}"
    where = f"{share}/{file}".rpartition("/")[0]
    listing = lists.listing
    found = [each for each in shared(lists) if each.is_plain]
    if any(covers(each, file, where) for each in found):
        return listing.text
    if any(each.what.rstrip("/") == folder for each in found):
        entry = next(each for each in found if each.what.rstrip("/") == folder)
        why = f"installs `{folder}`, and leaves out `{file}` or puts it somewhere else"
        raise refusal(listing.text, listing.path, entry.call.command.span, why)
    splices = _into_call(lists, folder)
    if splices is None:
        to = "${CATKIN_PACKAGE_SHARE_DESTINATION}" if is_catkin else "share/${PROJECT_NAME}"
        call = written_call(listing, "install", "DIRECTORY", [folder, f"DESTINATION {to}"])
        splices = insert_installation(lists, call)
    return applied(lists, splices, _fact(lists, folder), f"installing `{folder}`")


def _into_call(lists: CMakeLists, folder: str) -> list[Splice] | None:
    """Insert a folder beside others that go to `share/PACKAGE` whole."""
    for call in reversed(lists.named("install", "ament_auto_package")):
        if not call.is_plain:
            continue
        if call.command.name == "install":
            items = call.section("DIRECTORY", INSTALL_WORDS)
            is_there = destination_of(lists, call) == f"share/{lists.name}"
            words = {each.value for each in call.items}
            is_whole = not words & {"FILES_MATCHING", "PATTERN", "REGEX"}
        else:
            items = call.section("INSTALL_TO_SHARE", {"INSTALL_TO_SHARE", "INSTALL_TO_PATH"})
            is_there = is_whole = True
        if not items or not is_there or not is_whole:
            continue
        # Of a folder that ends in `/`, what is in it is installed, not the folder.
        if any(each.value.endswith("/") for each in items):
            continue
        splices = into_list(lists, call, items, folder)
        if splices is not None:
            return splices
    return None


def _remove(lists: CMakeLists, file: str) -> bytes:
    folder, share = _folder(file), f"share/{lists.name}"
    found = [
        each
        for each in shared(lists)
        if each.is_plain and each.what == folder and each.destination == share
    ]
    if not found:
        return lists.listing.text
    entry = found[-1]
    path = lists.listing.path

    def add(each: bytes) -> bytes | None:
        return add_shared(each, path, file).text

    return removed(lists, entry, _fact(lists, folder), add, _is_alone(entry))


def _is_alone(entry: Entry) -> bool:
    section = entry.call.section("DIRECTORY", INSTALL_WORDS)
    return entry.call.command.name == "install" and len(section) == 1
