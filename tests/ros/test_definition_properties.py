"""Random definitions are written, read back, and read by the builders of ROS as they are meant."""

from __future__ import annotations

import contextlib
import io
from collections.abc import Callable
from importlib import import_module
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from machine import examples, skip_or_fail

from plastron_tui.model.type_members import changed_by_builders
from plastron_tui.ros.definition import parse_definition
from plastron_tui.ros.definition_edits import add_member, remove_member, replace_member
from plastron_tui.ros.definition_members import make_member
from plastron_tui.ros.definition_text import format_definition, member_line
from plastron_tui.ros.interfaces import (
    Constant,
    Field,
    Interface,
    InterfaceKind,
    InterfaceName,
    Section,
)
from plastron_tui.ros.primitives import PRIMITIVES

NAME = InterfaceName("own", "Thing")
Member = Field | Constant

_TEXTS = st.one_of(
    st.text(st.characters(exclude_characters="\t", exclude_categories=["Cs"]), max_size=8),
    st.text("'\"ab ,[]#=%{}@", max_size=8),
    st.text("a\x0b\x1c\x85\u2028", max_size=3),
    st.text("a\xa0\u3000\x7f\x01é日😀", max_size=5),
)
_COMMENTS = st.sampled_from(["", " # it's", "# [m/s]", '  # "x" = 1', "   #"])


def _values(name: str, version: int) -> st.SearchStrategy[Any]:
    known = PRIMITIVES[version][name]
    if known.kind is bool:
        return st.booleans()
    if known.kind is int:
        return st.integers(known.low, known.high) | st.sampled_from([known.low, known.high])
    if known.kind is str:
        return _TEXTS
    width = 32 if name == "float32" else 64
    return st.floats(allow_nan=False, allow_infinity=False, width=width)  # type: ignore[arg-type]


@st.composite
def _member(draw: st.DrawFn, number: int, version: int) -> Member | None:
    """Draw a member that a program may make, or None for one that it may not."""
    name = draw(st.sampled_from([*sorted(PRIMITIVES[version]), "string", "string"]))
    is_scalar = not PRIMITIVES[version][name].parts
    if is_scalar and draw(st.booleans()):
        return _made(name, f"C{number}", draw(_values(name, version)), version, is_constant=True)
    arrays = ["", "", "[]", "[2]", "[<=3]"] if version == 2 else ["", "[]", "[2]"]
    array = draw(st.sampled_from(arrays))
    bound = draw(st.sampled_from(["", "<=5"])) if version == 2 and "string" in name else ""
    value: Any = None
    if version == 2 and draw(st.booleans()):
        value = draw(_values(name, version))
        if array:
            least, most = (2, 2) if array == "[2]" else (0, 3)
            lists = st.lists(_values(name, version), min_size=least, max_size=most)
            value = tuple(draw(lists))
    return _made(f"{name}{bound}{array}", f"f{number}", value, version, is_constant=False)


def _made(type_: str, name: str, value: Any, version: int, *, is_constant: bool) -> Member | None:
    if version == 2 and changed_by_builders(value) is not None:
        return None
    made = make_member(type_, name, value, is_constant, version, NAME.package)
    return None if isinstance(made, list) else made


@st.composite
def _interfaces(draw: st.DrawFn, version: int) -> Interface:
    members = [draw(_member(number, version)) for number in range(draw(st.integers(1, 4)))]
    fields = tuple(each for each in members if isinstance(each, Field))
    constants = tuple(each for each in members if isinstance(each, Constant))
    return Interface(NAME, InterfaceKind.MESSAGE, (Section(fields, constants),))


def _meant(interface: Interface) -> list[tuple[str, str, object]]:
    [section] = interface.sections
    return [
        *((each.name, str(each.type), each.default) for each in section.fields),
        *((each.name, each.type, each.value) for each in section.constants),
    ]


def _read(text: str | bytes, version: int) -> Interface | None:
    return parse_definition(text, NAME, InterfaceKind.MESSAGE, version).interface


@given(st.data(), st.sampled_from([1, 2]))
@settings(max_examples=examples(240))
def test_what_is_written_is_read_back(data: st.DataObject, version: int) -> None:
    interface = data.draw(_interfaces(version))
    assert _read(format_definition(interface, version), version) == interface


@given(st.data(), st.sampled_from([1, 2]), st.sampled_from(["\n", "\r\n"]), st.booleans())
@settings(max_examples=examples(120))
def test_a_member_comes_and_goes_and_every_other_byte_stays(
    data: st.DataObject, version: int, newline: str, has_end: bool
) -> None:
    interface = data.draw(_interfaces(version))
    lines = [
        line
        if "=" in line and version == 1
        else f"{line.replace(' ', data.draw(st.sampled_from([' ', '   '])), 1)}"
        f"{data.draw(_COMMENTS)}"
        for line in format_definition(interface, version).splitlines()
    ]
    text = (newline.join(lines) + (newline if has_end else "")).encode()
    before = _read(text, version)
    assert before is not None
    added = data.draw(_member(9, version))
    if added is None:
        return
    more = add_member(text, member_line(added, version))
    after = _read(more, version)
    assert after is not None
    new = [each for each in _meant(after) if each not in _meant(before)]
    assert [each[0] for each in new] == [added.name]
    line = member_line(added, version)
    again = replace_member(more, added.name, line, ros_version=version)
    assert _read(again, version) == after
    assert remove_member(more, added.name) == text


def _by_rosidl(text: str) -> list[tuple[str, str, object]]:
    from rosidl_adapter.msg import convert_msg_to_idl
    from rosidl_adapter.parser import parse_message_string
    from rosidl_parser import definition
    from rosidl_parser.parser import parse_idl_file

    with TemporaryDirectory() as made, contextlib.redirect_stdout(io.StringIO()):
        folder = Path(made)
        (folder / "msg").mkdir()
        (folder / "msg" / "Thing.msg").write_bytes(text.encode())
        spec = parse_message_string(NAME.package, NAME.name, text)
        idl = convert_msg_to_idl(folder, NAME.package, Path("msg/Thing.msg"), folder / "out")
        found = parse_idl_file(definition.IdlLocator(folder, idl.relative_to(folder)))
    [message] = found.content.get_elements_of_type(definition.Message)
    default = {
        each.name: each.get_annotation_value("default")["value"]
        for each in message.structure.members
        if each.has_annotation("default")
    }
    for each in spec.fields:
        if not isinstance(each.default_value, list):
            assert default.get(each.name) == each.default_value
    values = {each.name: each.value for each in message.constants}
    return [
        *(
            (
                each.name,
                str(each.type),
                tuple(each.default_value)
                if isinstance(each.default_value, list)
                else each.default_value,
            )
            for each in spec.fields
        ),
        *((each.name, each.type, values[each.name]) for each in spec.constants),
    ]


def _by_genmsg(text: str) -> list[tuple[str, str, object]]:
    loader = import_module("genmsg.msg_loader")
    spec = loader.load_msg_from_string(loader.MsgContext.create_default(), text, str(NAME))
    return [
        *((name, type_, None) for name, type_ in zip(spec.names, spec.types, strict=True)),
        *((each.name, each.type, each.val) for each in spec.constants),
    ]


BUILDERS: list[tuple[int, Callable[[str], list[tuple[str, str, object]]], int]] = [
    (1, _by_genmsg, 2_000),
    (2, _by_rosidl, 300),
]


@pytest.mark.parametrize(("version", "read", "number"), BUILDERS, ids=["genmsg", "rosidl"])
@pytest.mark.long
def test_builders_read_what_is_meant(
    version: int,
    read: Callable[[str], list[tuple[str, str, object]]],
    number: int,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    if version == 1 and Path("/usr/lib/python3/dist-packages/genmsg").is_dir():
        monkeypatch.syspath_prepend("/usr/lib/python3/dist-packages")
    try:
        read("")
    except ImportError:
        skip_or_fail(f"the builders of ROS {version} are not installed")

    @given(_interfaces(version))
    @settings(max_examples=number, deadline=None)
    def check(interface: Interface) -> None:
        text = format_definition(interface, version).lstrip("\n")
        assert repr(read(text)) == repr(_meant(interface)), text

    check()
