"""Definitions of types that no build takes, and what keeps those from being built that it does."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from typing import NamedTuple

from plastron_tui.diagnostics import Span
from plastron_tui.diagnostics.suggest import nearest
from plastron_tui.model.package_facts import DefinitionMistake, Place
from plastron_tui.ros.name_slips import is_slip
from plastron_tui.sources.cmake.facts import (
    CATKIN_INTERFACES,
    MESSAGE_WORDS,
    Entry,
    dependencies,
    interface_dependencies,
    interfaces,
)
from plastron_tui.sources.cmake.reader import Call
from plastron_tui.sources.packages.reading import CMAKE_LISTS, PACKAGE_XML
from plastron_tui.sources.xml.package_data import PackageXml

from .cmake_lists import Lists
from .texts import PackageTexts

_DEFINITION = re.compile(r"(?:msg/[^/]+\.msg|srv/[^/]+\.srv|action/[^/]+\.action)")
_FIELD = re.compile(
    rb"^[ \t]*(?P<package>[a-zA-Z][a-zA-Z0-9_]*)/(?:msg/)?(?P<name>[A-Za-z0-9_]+)"
    rb"(?:\[[^\]\n]*\])?[ \t]+[A-Za-z]",
    re.M,
)
_GROUP = "rosidl_interface_packages"
_GENERATORS = {1: "message_generation", 2: "rosidl_default_generators"}


class FieldOf(NamedTuple):
    """The first field of a definition whose type is of another package."""

    package: str
    span: Span


def own_definitions(texts: PackageTexts) -> tuple[str, ...]:
    """Return the definitions that lie where a package has its own."""
    return tuple(each for each in texts.names if _DEFINITION.fullmatch(each))


def fields_of(texts: PackageTexts, lists: Lists) -> Iterator[tuple[str, FieldOf]]:
    """Yield the types of other packages that the definitions are made of which are built."""
    if lists.lists is None:
        return
    entries = list(interfaces(lists.lists))
    for file in own_definitions(texts):
        if any(each.has(file) for each in entries):
            for match in _FIELD.finditer(texts.get(file) or b""):
                yield file, FieldOf(match["package"].decode(), Span(*match.span("package")))


def definition_mistakes(
    texts: PackageTexts, package: PackageXml, lists: Lists
) -> Iterator[DefinitionMistake]:
    """Yield what keeps the types of a package from being built."""
    own = own_definitions(texts)
    if texts.source.build_type == "ament_python":
        if own:
            message = f"`ament_python` builds no types, so `{_type(own[0])}` is not there"
            help_ = "move the definitions to a package of `ament_cmake`"
            yield DefinitionMistake(message, _start(texts, own[0]), help_)
        return
    if lists.lists is None:
        return
    entries = list(interfaces(lists.lists))
    yield from _missing(texts, entries)
    yield from _unlisted(texts, lists, own, entries)
    if entries:
        yield from _unready(texts, package, lists, entries)


def _type(file: str) -> str:
    return file.rpartition("/")[2].rpartition(".")[0]


def _start(texts: PackageTexts, file: str) -> Place:
    """Return the first line of a definition that says something."""
    text = texts.get(file) or b""
    at = 0
    for line in text.splitlines(keepends=True):
        said = line.strip()
        if said and not said.startswith(b"#"):
            start = at + len(line) - len(line.lstrip())
            return Place(file, Span(start, start + len(said)))
        at += len(line)
    return Place(file, Span(0, 0))


def _missing(texts: PackageTexts, entries: list[Entry]) -> Iterator[DefinitionMistake]:
    """Yield what the build takes and is not there."""
    for each in entries:
        if each.item.is_pattern or "$" in each.what or each.what in texts.source.names:
            continue
        if not each.what.endswith((".msg", ".srv", ".action")) or not each.is_plain:
            continue
        if each.what.startswith("/") or ":" in each.what or ".." in each.what:
            continue
        near = nearest(each.what, own_definitions(texts)) or ""
        said = each.item.argument.value
        remedy = ""
        if near and each.item.is_own and said.endswith(each.what):
            remedy = said.removesuffix(each.what) + near
        elif near and each.item.is_own and near.endswith(f"/{near.rpartition('/')[2]}"):
            remedy = near.rpartition("/")[2] if "/" not in said else ""
        others = [one.what for one in entries]
        if near in others or not is_slip(each.what, near):
            remedy = ""
        if remedy and each.item.argument.is_quoted:
            remedy = f'"{remedy}"'
        yield DefinitionMistake(
            f"there is no `{each.what}`",
            _place(each),
            f"did you mean `{near}`?" if near else "take it out, or write the definition",
            remedy,
        )


def _place(entry: Entry) -> Place:
    argument = entry.item.argument
    return Place(CMAKE_LISTS, Span(argument.start, argument.end))


def _unlisted(
    texts: PackageTexts, lists: Lists, own: tuple[str, ...], entries: list[Entry]
) -> Iterator[DefinitionMistake]:
    """Yield the definitions that no build takes."""
    assert lists.lists is not None
    cmake = lists.lists
    calls = cmake.named("rosidl_generate_interfaces", *CATKIN_INTERFACES.values())
    is_open = any(
        not call.is_whole
        or call.conditions
        or any("$" in each.value for each in call.items)
        or any(each.is_pattern for each in call.items)
        for call in calls
    )
    if is_open or (lists.is_open and not calls):
        return
    whole = set()
    for folder, name in CATKIN_INTERFACES.items():
        for call in cmake.named(name):
            if not call.section("FILES", MESSAGE_WORDS):
                given = call.section("DIRECTORY", MESSAGE_WORDS)
                whole.add(given[0].value if given else folder)
    text = texts.source.texts[CMAKE_LISTS]
    left = [
        each
        for each in own
        if _type(each).isidentifier()
        and not any(entry.has(each) for entry in entries)
        and each.partition("/")[0] not in whole
    ]
    if not calls and left:
        if b"rosidl" in _code(text) or b"genmsg" in _code(text):
            return
        message = f"no command of `CMakeLists.txt` builds `{_type(left[0])}`"
        if len(left) > 1:
            message += f", nor {len(left) - 1} more definitions"
        call_name = _call_name(texts, left[0])
        help_ = f"call `{call_name}` with it, or take the file out"
        yield DefinitionMistake(message, _start(texts, left[0]), help_)
        return
    taken_out = _commented(lists, calls)
    for each in left:
        name = _call_name(texts, each)
        other = next((call for call in calls if call.command.name == name), None)
        place = None if other is None else Place(CMAKE_LISTS, Span(*other.command.span))
        yield DefinitionMistake(
            f"no command of `CMakeLists.txt` builds `{_type(each)}`",
            _start(texts, each),
            f"add it to `{name}`",
            other=place,
            type=_type(each),
            is_taken_out=each.rpartition("/")[2].encode() in taken_out,
        )


def _commented(lists: Lists, calls: Sequence[Call]) -> frozenset[bytes]:
    """Return the words of the comments within calls: who writes a name there has taken it out."""
    assert lists.lists is not None
    listing = lists.lists.listing
    return frozenset(
        word.rpartition(b"/")[2].strip(b"\"'")
        for start, end in listing.comments
        if any(call.command.start < start < call.command.end for call in calls)
        for word in listing.text[start:end].replace(b"#", b" ").split()
    )


def _code(text: bytes) -> bytes:
    return b"\n".join(line.partition(b"#")[0] for line in text.splitlines())


def _call_name(texts: PackageTexts, file: str) -> str:
    if texts.source.ros_version == 1:
        return CATKIN_INTERFACES[file.partition("/")[0]]
    return "rosidl_generate_interfaces"


def _unready(
    texts: PackageTexts, package: PackageXml, lists: Lists, entries: list[Entry]
) -> Iterator[DefinitionMistake]:
    """Yield what a package lacks that builds types."""
    assert lists.lists is not None
    version = texts.source.ros_version
    call = entries[0].call
    place = Place(CMAKE_LISTS, Span(*call.command.span))
    found = [each.what for each in dependencies(lists.lists)]
    generator = _GENERATORS[version]
    # `catkin_simple` and `ament_cmake_auto` find what package.xml declares.
    is_auto = any(each in ("catkin_simple", "ament_cmake_auto") for each in found)
    is_found = generator in found or "rosidl_cmake" in found or is_auto
    if not is_found and not lists.is_open and not {"genmsg", "actionlib_msgs"} & {*found}:
        is_computed = any("$" in each for each in found)
        if not is_computed:
            message = f"`{call.command.spelled}` is a command of `{generator}`, which is not found"
            how = f"find_package({generator} REQUIRED)"
            if version == 1:
                how = f"find_package(catkin REQUIRED COMPONENTS {generator})"
            yield DefinitionMistake(message, place, f"write `{how}` before")
    if version == 1:
        if not lists.lists.named("generate_messages") and not lists.is_open and not is_auto:
            message = "no `generate_messages` builds the types"
            yield DefinitionMistake(message, place, "write `generate_messages` behind")
        yield from _unnamed(texts, lists, "generate_messages")
        return
    members = {one.name for one in package.groups if one.tag == "member_of_group"}
    skips = any(each.value == "SKIP_GROUP_MEMBERSHIP_CHECK" for each in call.items)
    if _GROUP not in members and not skips:
        root = package.document.root
        yield DefinitionMistake(
            f"a package that builds types is a member of the group `{_GROUP}`",
            Place(PACKAGE_XML, root.named("name")[0].value_span(package.document.text)),
            f"write `<member_of_group>{_GROUP}</member_of_group>`",
            other=place,
        )
    yield from _unnamed(texts, lists, "rosidl_generate_interfaces")


def _unnamed(texts: PackageTexts, lists: Lists, name: str) -> Iterator[DefinitionMistake]:
    """Yield types of other packages of which the build is not told."""
    assert lists.lists is not None
    calls = lists.lists.named(name)
    if not calls or any(not call.is_whole or call.conditions for call in calls):
        return
    given = {each.what for each in interface_dependencies(lists.lists)}
    if any("$" in each for each in given):
        return
    seen = {texts.source.name, *given}
    for file, field in fields_of(texts, lists):
        if field.package in seen:
            continue
        seen.add(field.package)
        yield DefinitionMistake(
            f"`{name}` is not told of `{field.package}`, whose types this is made of",
            Place(file, field.span),
            f"write `{field.package}` behind `DEPENDENCIES`",
            other=Place(CMAKE_LISTS, Span(*calls[-1].command.span)),
            package=field.package,
            named=tuple(sorted(given)),
        )
