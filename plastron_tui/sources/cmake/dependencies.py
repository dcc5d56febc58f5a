"""Finding the packages that a package needs when it is built."""

from __future__ import annotations

from collections import Counter
from pathlib import Path

from plastron_tui.sources.build_files import Edited, refusal
from plastron_tui.sources.splices import Splice

from .arguments import insert_first, insert_words
from .changing import Facts, applied, build_type_of, change, into_list, removed, word_of
from .facts import CATKIN, Entry, components, dependencies, exported
from .places import insert_after, layout_of
from .reader import Call, CMakeLists, read_cmake
from .syntax import Command

# These find what package.xml depends on.
_ALL = ("ament_auto_find_build_dependencies", "catkin_simple")


def add_dependency(text: bytes, path: Path, name: str) -> Edited:
    """Find a package: among catkin's components, or by a `find_package` of its own for ament.

    Nothing changes where it is found already, or all that package.xml depends on is.
    """
    return change(text, path, lambda lists: _add(lists, name))


def remove_dependency(text: bytes, path: Path, name: str) -> Edited:
    """Find a package no more."""
    return change(text, path, lambda lists: _remove(lists, name))


def found_packages(text: bytes, path: Path) -> frozenset[str]:
    """Return the packages that a CMakeLists.txt surely finds; none of one that cannot be read."""
    lists, _ = read_cmake(text, path)
    found = () if lists is None else dependencies(lists)
    return frozenset(each.what for each in found if each.is_plain)


def add_exported(text: bytes, path: Path, name: str) -> Edited:
    """Name a package in `CATKIN_DEPENDS` of `catkin_package`, for who uses this one."""
    return change(text, path, lambda lists: _add_exported(lists, name))


def remove_exported(text: bytes, path: Path, name: str) -> Edited:
    """Take a package out of `CATKIN_DEPENDS`."""
    return change(text, path, lambda lists: _remove_exported(lists, name))


def _found(lists: CMakeLists, name: str) -> list[Entry]:
    return [each for each in dependencies(lists) if each.what == name and each.is_plain]


def _fact(name: str) -> Facts:
    return Counter({("dependency", name, "", ()): 1})


def _finds_all(lists: CMakeLists) -> bool:
    simple = any(each.what == _ALL[1] for each in dependencies(lists))
    return simple or bool(lists.named(_ALL[0]))


def _add(lists: CMakeLists, name: str) -> bytes:
    is_catkin = build_type_of(lists) == CATKIN
    if _found(lists, name) or _finds_all(lists):
        return lists.listing.text
    splices = _add_component(lists, name) if is_catkin else _add_find(lists, name)
    return applied(lists, splices, _fact(name), f"finding `{name}`")


def _add_component(lists: CMakeLists, name: str) -> list[Splice]:
    """Add a component to the last call that finds catkin with components, or else to the first."""
    calls = [
        each
        for each in lists.named("find_package")
        if each.is_plain and each.items and each.items[0].value == "catkin"
    ]
    listing = lists.listing
    for call in reversed(calls):
        items = [each.item for each in components(call)]
        if not items:
            continue
        splices = into_list(lists, call, items, name)
        if splices is None:
            raise refusal(
                listing.text, listing.path, call.command.span, "computes catkin's components"
            )
        return splices
    if not calls:
        call = next(
            each
            for each in lists.named("find_package")
            if each.items and each.items[0].value == "catkin"
        )
        why = "finds catkin under a condition"
        raise refusal(listing.text, listing.path, call.command.span, why)
    return _new_components(lists, calls[0], name)


def _new_components(lists: CMakeLists, call: Call, name: str) -> list[Splice]:
    command = call.command
    word = word_of(command, "COMPONENTS")
    if word is not None:
        return insert_first(lists.listing, command, word, name)
    last = command.arguments[-1]
    return insert_words(last, f"COMPONENTS {name}")


def _add_find(lists: CMakeLists, name: str) -> list[Splice]:
    """Add a `find_package` below the last one, in its place where they are sorted."""
    listing = lists.listing
    layout = layout_of(listing)
    found = [
        each
        for each in listing.statements
        if isinstance(each, Command) and each.name == "find_package" and each.arguments
    ]
    spelled = found[-1].spelled if found else "FIND_PACKAGE" if layout.is_upper else "find_package"
    call = f"{spelled}({name} REQUIRED)".encode()
    if not found:
        anchors = [each for each in listing.statements if isinstance(each, Command)]
        project = next((each for each in anchors if each.name == "project"), None)
        anchor = project or anchors[0]
        return insert_after(listing, anchor, call, blank=True)
    others = [each for each in found if not each.arguments[0].value.startswith("ament_cmake")]
    names = [each.arguments[0].value for each in others]
    after = found[-1]
    if len(names) > 1 and names == sorted(names):
        before = [each for each in others if each.arguments[0].value < name]
        first = found.index(others[0])
        after = before[-1] if before else found[first - 1] if first else after
    return insert_after(listing, after, call, blank=False)


def _remove(lists: CMakeLists, name: str) -> bytes:
    found = _found(lists, name)
    if not found:
        return lists.listing.text
    entry = found[-1]
    path = lists.listing.path
    alone = entry.call.items[0] is entry.item and not list(components(entry.call))

    def add(each: bytes) -> bytes | None:
        return add_dependency(each, path, name).text

    return removed(lists, entry, _fact(name), add, alone)


def _add_exported(lists: CMakeLists, name: str) -> bytes:
    listing = lists.listing
    if any(each.what == name for each in exported(lists)):
        return listing.text
    calls = [each for each in lists.named("catkin_package") if each.is_plain]
    if not calls:
        why = "begins a file that calls no `catkin_package`"
        raise refusal(listing.text, listing.path, (0, 0), why)
    call = calls[-1]
    items = [each.item for each in exported(lists) if each.call is call]
    word = word_of(call.command, "CATKIN_DEPENDS")
    if items:
        splices = into_list(lists, call, items, name)
    elif word is not None:
        splices = insert_first(listing, call.command, word, name)
    elif call.command.arguments:
        splices = insert_words(call.command.arguments[-1], f"CATKIN_DEPENDS {name}")
    else:
        at = call.command.opening
        splices = [Splice(at, at, f"CATKIN_DEPENDS {name}".encode())]
    if splices is None:
        raise refusal(listing.text, listing.path, call.command.span, "computes `CATKIN_DEPENDS`")
    more: Facts = Counter({("exported", name, "", ()): 1})
    return applied(lists, splices, more, f"exporting `{name}`")


def _remove_exported(lists: CMakeLists, name: str) -> bytes:
    found = [each for each in exported(lists) if each.what == name]
    if not found:
        return lists.listing.text
    path = lists.listing.path

    def add(each: bytes) -> bytes | None:
        return add_exported(each, path, name).text

    less: Facts = Counter({("exported", name, "", ()): 1})
    return removed(lists, found[-1], less, add, False)
