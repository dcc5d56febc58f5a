"""Building a node no more: its target, all that is said of it, and what nothing else needs.

Sources: the documentation of the commands that CMake, catkin, ament_cmake and rclcpp_components
have for targets; each that names a target which is not made is an error when a package is built.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Container, Iterable, Iterator, Sequence
from functools import partial
from itertools import combinations, pairwise
from pathlib import Path
from typing import NamedTuple

from plastron_tui.diagnostics import codes
from plastron_tui.sources.build_files import Edited, RefusedError, refusal
from plastron_tui.sources.splices import Splice, apply, line_end, line_start

from .arguments import argument_removals, begins_line, command_removals
from .changing import change
from .dependencies import remove_dependency
from .facts import INSTALL_WORDS, executable_of, facts, sources_of, targets
from .reader import Call, CMakeLists, interpret, read_cmake
from .syntax import Argument, Block, Command, Statement, parse_cmake
from .targets import OF_TARGETS, NewTarget, add_target
from .variables import Item, reference_of

FOR_ALL = ("enable_language", "include_directories", "rosidl_get_typesupport_target")
"""The commands above all targets that a first one may bring."""

_MAKING = frozenset({"add_executable", "add_library", "ament_auto_add_executable"})
_ABOUT = re.compile(rf"{'|'.join(OF_TARGETS)}|rosidl_target_interfaces|target_\w+")
# These may have words that are called like a target without meaning it.
_UNRELATED = re.compile(
    r"project|find_package|message|set|list|unset|option|cmake_\w+|include_directories|"
    r"rosidl_g\w+|generate_\w+|add_(message|service|action)_files|ament_python_\w+|catkin_python_\w+"
)
_REGISTERING = re.compile(r"rclcpp_components_register_nodes?")
# What tells other packages of libraries, which are then none.
_EXPORTING = ("catkin_package", "ament_export_libraries")
_EXPORT_WORDS = frozenset(
    {"INCLUDE_DIRS", "LIBRARIES", "CATKIN_DEPENDS", "DEPENDS", "CFG_EXTRAS", "EXPORTED_TARGETS"}
)
_TYPE_SUPPORT = "cpp_typesupport_target"


class _Gone(NamedTuple):
    """What goes with a target: whole commands, and single arguments of others."""

    commands: frozenset[int]
    arguments: tuple[tuple[Command, Argument], ...]


def remove_target(
    text: bytes,
    path: Path,
    name: str,
    packages: Sequence[str] = (),
    commands: Container[str] | None = None,
) -> Edited:
    """Build and install a target no more.

    What was written for it alone goes where adding it again writes that too.

    Args:
        text: what is in the CMakeLists.txt.
        path: the CMakeLists.txt.
        name: the target.
        packages: the packages that no source needs any more; found no more, unless a command
            names one of them.
        commands: those of `FOR_ALL` that came with the target; None where nothing tells, and they
            go with the last target.
    """
    built = None

    def without(lists: CMakeLists) -> bytes:
        nonlocal built
        built = _as_new(lists, name)
        return _without(lists, name)

    edited = change(text, path, without)
    if edited.text is None:
        return edited
    after = edited.text
    gone = []
    for package in reversed(packages):
        less = remove_dependency(after, path, package)
        if less.text is not None and less.text != after and not names_package(less.text, package):
            after = less.text
            gone.append(package)
    if built is not None:
        again = built._replace(packages=tuple(reversed(gone)))
        return change(after, path, partial(_without_extras, before=text, new=again, came=commands))
    return Edited(after)


def commands_for_all(text: bytes, path: Path) -> frozenset[str]:
    """Return those of `FOR_ALL` that a CMakeLists.txt has; none of one that cannot be read."""
    lists, _ = read_cmake(text, path)
    return frozenset(() if lists is None else (x.command.name for x in lists.named(*FOR_ALL)))


def names_package(text: bytes, package: str) -> bool:
    """Tell whether a CMakeLists.txt names a package, one of its targets, variables or commands."""
    name = re.escape(package.encode())
    words = rb"(?<!\w)%b(?!\w)|(?<!\w)%b_[A-Z]|(?im:^\s*%b_\w+\s*\()" % (name, name, name)
    return re.search(words, re.sub(rb"#[^\n]*", b"", text)) is not None


def _without(lists: CMakeLists, name: str) -> bytes:
    """Return the text without a target.

    Raises:
        RefusedError: it is not certain what that is.
    """
    gone = _gone(lists, name)
    listing = lists.listing
    splices: list[Splice] = []
    for command, argument in gone.arguments:
        splices += next(iter(argument_removals(listing, command, argument)))
    for group in _groups(lists, gone.commands):
        splices.append(_removal(lists, group))
    after = apply(listing.text, splices)
    _check(lists, after, name, gone)
    return after


def _check(lists: CMakeLists, after: bytes, name: str, gone: _Gone) -> None:
    """Refuse a text that says other things besides than it did."""
    listing = lists.listing
    expected = facts(lists)
    expected.subtract({("target", name, "", ()): 1})
    try:
        read = interpret(parse_cmake(after, listing.path))
    except RefusedError:
        read = None
    left = None if read is None else Counter(each.words for each in read.listing.commands())
    parts = {command.start for command, _ in gone.arguments}
    stay = Counter(
        each.words
        for each in listing.commands()
        if each.start not in gone.commands and each.start not in parts
    )
    is_same = left is not None and not (stay - left) - _conditions(lists, gone.commands)
    if read is None or not is_same or facts(read) != +expected:
        why = f"builds `{name}`, and more would change than that"
        raise refusal(listing.text, listing.path, _made(lists, name).command.span, why)


def _conditions(lists: CMakeLists, gone: frozenset[int]) -> Counter[tuple[str, ...]]:
    """Return the first lines of the blocks that go as a whole."""
    found: Counter[tuple[str, ...]] = Counter()
    for group in _groups(lists, gone):
        for each in group:
            for branch in each.branches if isinstance(each, Block) else ():
                found[branch.opening.words] += 1
    return found


def _made(lists: CMakeLists, name: str) -> Call:
    """Return the call that makes a target, which runs once whatever is true."""
    found = [x for x in lists.calls if x.command.name in _MAKING and x.items[:1]]
    found = [each for each in found if each.items[0].value == name]
    if len(found) == 1 and found[0].is_plain:
        return found[0]
    listing = lists.listing
    span = found[0].command.span if found else (0, 0)
    raise refusal(listing.text, listing.path, span, f"builds `{name}` in a branch or a loop")


def _gone(lists: CMakeLists, name: str) -> _Gone:
    listing = lists.listing
    made = _made(lists, name)
    commands: set[int] = set()
    parts: list[tuple[Command, Argument]] = []
    registered = [
        each
        for each in lists.calls
        if _REGISTERING.fullmatch(each.command.name) and each.items[:1]
        if each.items[0].value == name
    ]
    if len(registered) > 1:
        why = f"makes more than one component of `{name}`"
        raise refusal(listing.text, listing.path, registered[1].command.span, why)
    for call in lists.calls:
        items = _named(call, name)
        if not items:
            _check_unnamed(lists, call, name)
            continue
        others, is_about = _others(call, name)
        is_exported = call.command.name == "install" and any(
            each.value == "EXPORT" for each in call.items
        )
        if not is_about or call.is_repeated or (is_exported and not others):
            why = f"names `{name}` too" if not is_exported else f"exports `{name}`"
            code, remedy = codes.EDIT_REFUSED, "take it out there first"
            raise refusal(listing.text, listing.path, call.command.span, why, code, remedy)
        if not others:
            commands.add(call.command.start)
            continue
        for item in items:
            if not item.is_own or reference_of(item.argument) is not None:
                span = call.command.span
                raise refusal(listing.text, listing.path, span, f"computes `{name}`")
            parts.append((item.command, item.argument))
    commands.add(made.command.start)
    return _Gone(frozenset(commands), tuple(dict.fromkeys(parts)))


def _named(call: Call, name: str) -> list[Item]:
    """Return the values of a command that are a target; none of one that means something else."""
    if _UNRELATED.fullmatch(call.command.name):
        return []
    found = [each for each in call.items if each.value == name]
    if call.command.name == "catkin_package":
        given = call.section("LIBRARIES", _EXPORT_WORDS)
        return [each for each in given if each.value == name]
    if call.command.name == "install" and call.items[0].value != "TARGETS":
        return []
    return found


def _check_unnamed(lists: CMakeLists, call: Call, name: str) -> None:
    """Refuse a command that names a target within a word, as `$<TARGET_FILE:name>` does."""
    inner = re.compile(rf"\$<TARGET_\w+:{re.escape(name)}[>,]")
    if any(inner.search(each.value) for each in call.items):
        listing = lists.listing
        raise refusal(listing.text, listing.path, call.command.span, f"names `{name}` too")


def _others(call: Call, name: str) -> tuple[list[str], bool]:
    """Return what a command says its words of besides a target, and whether it is of targets."""
    command = call.command
    values = [each.value for each in call.items]
    if command.name == "install":
        given = [each.value for each in call.section("TARGETS", INSTALL_WORDS)]
        return [each for each in given if each != name], True
    if command.name == "set_target_properties" and "PROPERTIES" in values:
        given = values[: values.index("PROPERTIES")]
        return [each for each in given if each != name], name in given
    if command.name in _EXPORTING:
        # A call of catkin_package that is left with nothing still says that there is a package.
        is_needed = [command.name] if command.name == "catkin_package" else []
        return [each for each in values if each != name] or is_needed, True
    is_about = _ABOUT.fullmatch(command.name) is not None or command.name in _MAKING
    return [], is_about and values[0] == name and name not in values[1:]


def _groups(lists: CMakeLists, gone: frozenset[int]) -> Iterator[list[Statement]]:
    """Yield the statements that go, together where nothing but line ends is between them."""

    def is_gone(each: Statement) -> bool:
        if isinstance(each, Command):
            return each.start in gone
        inner = [one for branch in each.branches for one in branch.statements]
        return bool(inner) and all(map(is_gone, inner)) and each.kind == "if"

    text = lists.listing.text

    def within(statements: Iterable[Statement]) -> Iterator[list[Statement]]:
        group: list[Statement] = []
        for each in statements:
            is_next = not group or re.fullmatch(
                rb"[ \t]*\r?\n[ \t]*", text[group[-1].end : each.start]
            )
            if group and not (is_gone(each) and is_next):
                yield group
                group = []
            if is_gone(each):
                group.append(each)
            elif isinstance(each, Block):
                for branch in each.branches:
                    yield from within(branch.statements)
        if group:
            yield group

    return within(lists.listing.statements)


def _removal(lists: CMakeLists, group: Sequence[Statement]) -> Splice:
    """Return how commands are taken out: with the blank line above, as they were put in."""
    text = lists.listing.text
    start, end = line_start(text, group[0].start), line_end(text, group[-1].end)
    rest = text[group[-1].end : end].strip()
    if not begins_line(text, group[0].start) or (rest and not rest.startswith(b"#")):
        span = (group[0].start, group[-1].end)
        raise refusal(text, lists.listing.path, span, "has something else in its line")
    previous = line_start(text, max(start - 1, 0))
    above = text[previous:start].strip()
    if end == len(text) and not text.endswith(b"\n") and start:
        # What ends without a line ending is to end so again.
        start = previous if not above else start
        return Splice(start - (2 if text[start - 2 : start] == b"\r\n" else 1), end)
    if start > previous and not above:
        return Splice(previous, end)
    following = line_end(text, end)
    if not start and not text[end:following].strip():
        return Splice(start, following)
    return Splice(start, end)


def _as_new(lists: CMakeLists, name: str) -> NewTarget | None:
    """Return a target as one would add it, None where nobody would so."""
    built = next((each for each in targets(lists) if each.what == name), None)
    sources = [] if built is None else sources_of(built)
    if built is None or len(sources) != 1:
        return None
    about = [x for x in lists.calls if x.items and x.items[0].value == name]
    linked = [
        item.value
        for each in about
        if each.command.name == "target_link_libraries"
        for item in each.items[1:]
        if item.value != "PUBLIC"
    ]
    own = f"${{{_TYPE_SUPPORT}}}"
    included = [y.value for x in lists.named("include_directories") for y in x.items]
    included += [
        item.value
        for x in about
        if x.command.name == "target_include_directories"
        for item in x.items
    ]
    folders = {each.rpartition("/")[2].rstrip(">") for each in included}
    headers = "include" if "include" in folders else ""
    plugin, executable = None, executable_of(lists, built)
    for each in about:
        if _REGISTERING.fullmatch(each.command.name):
            given = [item.value for item in each.items]
            plugin = next((b for a, b in pairwise(given) if a == "PLUGIN"), "")
            executable = next((b for a, b in pairwise(given) if a == "EXECUTABLE"), "")
    if plugin is None and built.call.command.name == "add_library":
        plugin = name
    others = tuple(each for each in linked if each != own)
    return NewTarget(executable, sources[0], headers, (), others, plugin, own in linked)


def _without_extras(
    lists: CMakeLists, before: bytes, new: NewTarget, came: Container[str] | None
) -> bytes:
    """Take out what was written above all targets for one alone.

    Only where adding the target writes the same bytes again.
    """
    listing = lists.listing
    if came is None and list(targets(lists)):
        return listing.text
    names = [each for each in FOR_ALL if came is None or each in came]
    found = [x for x in listing.statements if isinstance(x, Command) and x.name in names]
    path = listing.path
    for count in range(min(len(found), 3), 0, -1):
        for some in combinations(found, count):
            splices = [list(command_removals(listing, each)) for each in some]
            for at in range(max(map(len, splices))):
                ways = [each[min(at, len(each) - 1)] for each in splices if each]
                after = apply(listing.text, [y for x in ways for y in x])
                if add_target(after, path, new).text == before:
                    return after
    return listing.text
