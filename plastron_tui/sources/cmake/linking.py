"""Building a node that is there with one more package.

Sources: the "ament_cmake user documentation" (`ament_target_dependencies`,
`target_link_libraries`), and catkin's how-to on executables: with catkin, a component is enough.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from functools import partial
from pathlib import Path

from plastron_tui.sources.build_files import Edited
from plastron_tui.sources.splices import Splice

from .arguments import insert_argument, insert_words
from .changing import Facts, applied, build_type_of, change, into_list, removed
from .dependencies import add_dependency, remove_dependency
from .facts import CATKIN, Entry, sources_of, targets
from .places import insert_after, written_call
from .reader import Call, CMakeLists, read_cmake
from .removals import names_package
from .variables import reference_of

_NONE: Facts = Counter()
_WORDS = frozenset({"PUBLIC", "PRIVATE", "INTERFACE", "SYSTEM"})


def add_packages(
    text: bytes, path: Path, source: str, packages: Sequence[str], linked: Sequence[str]
) -> Edited:
    """Find packages, and build a node with them.

    Args:
        text: what is in the CMakeLists.txt.
        path: the CMakeLists.txt.
        source: the node's source, by its path from the package's folder.
        packages: the packages.
        linked: what each of them is linked to by, in ROS 2.
    """
    for name in packages:
        edited = add_dependency(text, path, name)
        if edited.text is None:
            return edited
        text = edited.text
    for name, target in zip(packages, linked, strict=True):
        edited = change(text, path, partial(_link, source=source, package=name, target=target))
        if edited.text is None:
            return edited
        text = edited.text
    return Edited(text)


def is_linked(text: bytes, path: Path, package: str, target: str) -> int:
    """Return how often a CMakeLists.txt says that something is linked to a package."""
    lists, _ = read_cmake(text, path)
    calls = (
        () if lists is None else lists.named("ament_target_dependencies", "target_link_libraries")
    )
    return sum(item.value in (package, target) for call in calls for item in call.items[1:])


def remove_packages(
    text: bytes, path: Path, source: str, came: Sequence[tuple[str, str, bool, bool]]
) -> Edited:
    """Build a node without packages that it came to need, and find those no more.

    Args:
        text: what is in the CMakeLists.txt.
        path: the CMakeLists.txt.
        source: the node's source, by its path from the package's folder.
        came: each package with what it is linked to by, whether the node was linked to it, and
            whether it was found for the node.
    """
    for name, target, is_linked, _ in reversed(came):
        if is_linked:
            edited = change(
                text, path, partial(_unlink, source=source, package=name, target=target)
            )
            if edited.text is None:
                return edited
            text = edited.text
    for name, _, _, is_found in reversed(came):
        less = remove_dependency(text, path, name) if is_found else Edited(text)
        if less.text is None:
            return less
        if less.text == text or not names_package(less.text, name):
            text = less.text
    return Edited(text)


def _unlink(lists: CMakeLists, source: str, package: str, target: str) -> bytes:
    """Build a node without a package, as it was before it was built with it."""
    text, path = lists.listing.text, lists.listing.path
    built = next((each for each in targets(lists) if source in sources_of(each)), None)
    if built is None:
        return text

    def link(each: bytes) -> bytes | None:
        again = partial(_link, source=source, package=package, target=target)
        return change(each, path, again).text

    for verb, value in (("ament_target_dependencies", package), ("target_link_libraries", target)):
        for call in (x for x in lists.named(verb) if _is_of(x, built) and not x.conditions):
            item = next((x for x in call.items[1:] if x.value == value), None)
            if item is not None:
                others = {x.value for x in call.items[1:]} - _WORDS - {value}
                entry = Entry(value, item, call)
                return removed(lists, entry, _NONE, link, not others)
    return text


def _link(lists: CMakeLists, source: str, package: str, target: str) -> bytes:
    """Build a node with a package, in the manner in which it is built with its others."""
    text = lists.listing.text
    built = next((each for each in targets(lists) if source in sources_of(each)), None)
    if built is None or build_type_of(lists) == CATKIN:
        return text
    what = f"building `{source}`"
    for verb, value in (("ament_target_dependencies", package), ("target_link_libraries", target)):
        calls = [each for each in lists.named(verb) if _is_of(each, built) and not each.conditions]
        if not calls:
            continue
        items = [each for call in calls for each in call.items[1:]]
        names = {each.value for each in items}
        if value in names or f"{package}::{package}" in names or package in names:
            return text
        call = calls[-1]
        own = [each for each in call.items[1:] if each.value not in _WORDS]
        splices = into_list(lists, call, own, value) if own else None
        if splices is None:
            # What it is built with is all in variables of others: a word of its own behind them.
            last = call.command.arguments[-1]
            splices = (
                insert_words(last, value)
                if reference_of(last) is not None
                else insert_argument(lists.listing, call.command, [last], value)
            )
        return applied(lists, splices, _NONE, what)
    return applied(lists, _new_call(lists, built, target), _NONE, what)


def _is_of(call: Call, built: Entry) -> bool:
    return bool(call.items) and call.items[0].value == built.what


def _new_call(lists: CMakeLists, built: Entry, target: str) -> list[Splice]:
    """Link a target that is linked to nothing yet."""
    first = built.call.command.arguments[0]
    name = lists.listing.text[first.start : first.end].decode()
    call = written_call(lists.listing, "target_link_libraries", f"{name} PUBLIC {target}", [])
    return insert_after(lists.listing, built.call.command, call, blank=False)
