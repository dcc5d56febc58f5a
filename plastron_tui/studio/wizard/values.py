"""The values of a message or a request as a form: one entry for each field.

What is entered becomes the text that a program has after the word `input`.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace

from plastron_tui.language.sentence import quoted
from plastron_tui.model.times import BUILTIN_TIMES
from plastron_tui.ros.catalog import Catalog
from plastron_tui.ros.field_meanings import Meaning, meaning_of
from plastron_tui.ros.interfaces import (
    Constant,
    Field,
    FieldType,
    Interface,
    InterfaceKind,
    InterfaceName,
    Section,
)
from plastron_tui.ros.primitives import check_scalar, primitive

Path = tuple[str, ...]
Python = type[bool] | type[int] | type[float] | type[str]

MOST_FIELDS = 200
"""The most entries of a form; a message with more of them is written by hand."""

_DEEPEST = 8
_HEADER = InterfaceName("std_msgs", "Header")
NUMBER = re.compile(r"[+-]?(\d+(\.\d*)?|\.\d+)([eE][+-]?\d+)?", re.ASCII)
_TEXT = re.compile(r'"(?:[^"\\]|\\.)*"')
_LONGEST_SHOWN = 40
_PIECE = re.compile(r'\s*("(?:[^"\\]|\\.)*"|(?:[^\s,]+(?:\s+[^\s,]+)*)?)\s*(?:,|$)')
_ORIGIN = r"(parameter '[^']+'|received(\.[A-Za-z]\w*)+(\[\d+\])?)"
_COMPUTED = re.compile(rf"{_ORIGIN}(\s*[-+*/]\s*({NUMBER.pattern}|{_ORIGIN}))*", re.ASCII)
_SPEEDS = frozenset({"m/s", "rad/s"})
_TRUE = frozenset({"true", "yes", "on", "1"})
_FALSE = frozenset({"false", "no", "off", "0"})


@dataclass(frozen=True, slots=True)
class Entry:
    """A field that gets a value.

    Attributes:
        path: the names of the field and of those around it.
        type: its type.
        python: what its values are in Python: `bool`, `int`, `float`, `str`; None for a message
            in an array.
        note: its type, range and default in a few words.
        comment: what the definition says about it.
        constants: the constants of the message that it may be meant to hold.
        default: its value where none is entered, in words.
        meaning: its unit and what it is, where that is known.
    """

    path: Path
    type: FieldType
    python: Python | None
    note: str
    comment: str = ""
    constants: tuple[Constant, ...] = ()
    default: str = ""
    meaning: Meaning | None = None

    @property
    def name(self) -> str:
        """The path as a program writes it."""
        return ".".join(self.path)

    @property
    def is_time(self) -> bool:
        """Whether it is a time or a duration, in seconds or in parts."""
        return self.python is float and self.type.name.lower() in ("time", "duration")

    @property
    def is_switch(self) -> bool:
        """Whether it is either true or false."""
        return self.python is bool and not self.type.is_array


@dataclass(frozen=True, slots=True)
class Heading:
    """A message within the message: its entries follow. Or a part that needs no entry."""

    path: Path
    note: str


def entries_of(
    interface: Interface, catalog: Catalog, section: Section | None = None
) -> list[Entry | Heading]:
    """Return the form of a section: of a message, or of a request or a goal where none is named."""
    section = section or interface.sections[0]
    is_message = interface.kind is InterfaceKind.MESSAGE
    found: list[Entry | Heading] = []
    for each in _entries(section, (), catalog, is_message):
        if isinstance(each, Entry):
            meaning = meaning_of(catalog, interface, each.path, section)
            each = replace(each, meaning=meaning)
        found.append(each)
        if len(found) == MOST_FIELDS:
            found.append(Heading(("…",), "more fields: give them their values in the editor"))
            break
    return found


def first_value(entry: Entry, *, is_stop: bool = False) -> str:
    """Return a value of a field that shows something, "" where none is known.

    Args:
        entry: the field.
        is_stop: whether it is sent where something is too near: nothing moves then.
    """
    meaning = entry.meaning
    if meaning is None or not meaning.first:
        return ""
    return "0.0" if is_stop and meaning.unit in _SPEEDS else meaning.first


def _entries(
    section: Section, around: Path, catalog: Catalog, is_sent: bool
) -> Iterator[Entry | Heading]:
    for field in section.fields:
        path = (*around, field.name)
        message = field.type.message
        if message is None or field.type.is_array or message in BUILTIN_TIMES:
            yield _entry(field, path, section.constants, catalog.ros_version)
            continue
        nested = catalog.find(message, InterfaceKind.MESSAGE)
        if nested is None or len(path) > _DEEPEST:
            continue
        if is_sent and not around and field.name == "header" and message == _HEADER:
            yield Heading(path, "time and number are filled in when it is sent")
            for inner in nested.fields:
                if inner.name == "frame_id":
                    where = (*path, inner.name)
                    yield _entry(inner, where, (), catalog.ros_version)
            continue
        yield Heading(path, str(field.type))
        yield from _entries(nested.sections[0], path, catalog, is_sent)


_LARGE = 2**32
"""Of what holds more than this, nobody has to know how much."""


def _entry(field: Field, path: Path, constants: tuple[Constant, ...], ros_version: int) -> Entry:
    type_ = field.type
    if type_.package is not None:
        is_time = not type_.is_array
        note = f"{type_}, in seconds" if is_time else f"{type_}: (…), (…)"
        kind = float if is_time else None
        return Entry(path, type_, kind, note, field.comment, (), _default(type_, kind))
    known = primitive(type_.name, ros_version)
    assert known is not None, type_
    parts = [str(type_) + (", in seconds" if known.parts else "")]
    if type_.is_array:
        parts.append("values with commas between")
    elif known.low is not None and known.high is not None and known.high > _LARGE:
        parts.append("a whole number")
    elif known.low is not None:
        parts[0] += f" {known.low}…{known.high}"
    if field.default is not None:
        parts.append(f"{_shown(field.default)} without a value")
    fitting = () if type_.is_array else _fitting(field, constants, known.kind)
    default = _default(type_, known.kind) if field.default is None else _shown(field.default)
    return Entry(path, type_, known.kind, ", ".join(parts), field.comment, fitting, default)


def _default(type_: FieldType, kind: Python | None) -> str:
    if type_.is_array:
        return "none" if type_.length is None else f"{type_.length} zeros"
    return {bool: "False", int: "0", float: "0.0", str: ""}.get(kind or str, "")


def _fitting(field: Field, constants: tuple[Constant, ...], kind: type) -> tuple[Constant, ...]:
    """Return the constants that a field may be meant to hold: those of its own type."""
    same = tuple(constant for constant in constants if constant.type == field.type.name)
    if kind is bool:
        return ()
    prefixed = tuple(
        each for each in same if each.name.lower().startswith(field.name.lower().rstrip("s"))
    )
    return prefixed or same


def _shown(value: object) -> str:
    if isinstance(value, tuple):
        return f"[{', '.join(map(_shown, value))}]"
    return f'"{value}"' if isinstance(value, str) else str(value)


def written(entry: Entry, text: str) -> str:
    """Return what was entered as a program writes it; what fits no field is left as it is."""
    if is_computed(text):
        return text.strip()
    if entry.python is None:
        inner = text.strip()
        return inner if inner.startswith("[") else f"[{inner}]"
    if not entry.type.is_array:
        return _scalar(entry, text)
    inner = text.strip()
    if inner.startswith("[") and inner.endswith("]"):
        inner = inner[1:-1]
    return f"[{', '.join(_scalar(entry, piece, is_item=True) for piece in pieces(inner))}]"


def pieces(text: str) -> list[str]:
    """Split a list at its commas; a comma within double quotes is a part of its text."""
    if not text.strip():
        return []
    found, at = [], 0
    while at <= len(text):
        match = _PIECE.match(text, at)
        if match is None:
            return [piece.strip() for piece in text.split(",")]
        found.append(match[1])
        if match.end() == len(text):
            return [*found, ""] if text[match.end(1) :].strip() == "," else found
        at = match.end()
    return found


def is_computed(text: str) -> bool:
    """Tell whether a value is computed when it is sent: of a parameter, or of what is received."""
    return _COMPUTED.fullmatch(text.strip()) is not None


def _scalar(entry: Entry, text: str, *, is_item: bool = False) -> str:
    if is_computed(text):
        return text.strip()
    if entry.python is str:
        is_quoted = is_item and len(text) > 1 and text[0] == text[-1] == '"'
        return text if is_quoted else quoted(text)
    plain = text.strip()
    if entry.python is bool:
        low = plain.lower()
        return "True" if low in _TRUE else "False" if low in _FALSE else plain
    return plain


def problem_of(entry: Entry, text: str, ros_version: int, others: str = "") -> str | None:
    """Tell why what was entered does not fit its field, None where it does, as far as is known.

    Of messages within an array only the parentheses are looked at here, and nothing of what is
    computed when it is sent: the statement says that.

    Args:
        entry: the field.
        text: what was entered.
        ros_version: the generation of ROS.
        others: an example of what else could stand there, "" where nothing could.
    """
    if is_computed(text):
        return None
    if entry.python is None:
        return _parentheses_problem(text)
    if not entry.type.is_array:
        return _scalar_problem(entry, text, ros_version, others)
    inner = text.strip().removeprefix("[").removesuffix("]")
    found = pieces(inner)
    for number, piece in enumerate(found, 1):
        problem = _scalar_problem(entry, piece, ros_version, others)
        if problem is not None:
            words = inner.replace(",", " ").split()
            if entry.python is not str and not any(
                _scalar_problem(entry, each, ros_version, others) for each in words
            ):
                return f"put commas between: {', '.join(words)}"
            shown = f"`{piece}`, " if 0 < len(piece) <= _LONGEST_SHOWN else ""
            return f"{shown}value {number} of the list: {problem}"
    count, type_ = len(found), entry.type
    if type_.length is not None and count != type_.length:
        return f"`{entry.path[-1]}` has {type_.length} values, not {count}"
    if type_.bound is not None and count > type_.bound:
        return f"`{entry.path[-1]}` has at most {type_.bound} values, not {count}"
    return None


def _parentheses_problem(text: str) -> str | None:
    """Tell why a text is no list of messages, each in parentheses."""
    inner = text.strip()
    if inner.startswith("["):
        inner = inner.removeprefix("[").removesuffix("]").strip()
    depth = 0
    for character in _TEXT.sub("", inner):
        depth += {"(": 1, ")": -1}.get(character, 0)
        if depth < 0:
            return "there is one `)` more than `(`"
        if depth == 0 and character not in "), ":
            shown = inner if len(inner) <= _LONGEST_SHOWN and "(" not in inner else "field=value"
            return f"write each message in parentheses, with commas between: ({shown}), (…)"
    return "a `)` is missing at the end" if depth else None


def _scalar_problem(entry: Entry, text: str, ros_version: int, others: str) -> str | None:
    plain = text.strip()
    value: bool | int | float | str
    if is_computed(plain):
        return None
    if entry.python is bool:
        if plain.lower() not in _TRUE | _FALSE:
            return "it is either True or False"
        return None
    if entry.python is str:
        value = text
    elif NUMBER.fullmatch(plain) is None:
        if entry.is_time and plain.startswith("("):
            return None  # its parts
        what = "a whole number" if entry.python is int else "a number"
        example = _example(entry, ros_version) + (f", or {others}" if others else "")
        return f"{entry.path[-1]} takes {what}, such as {example}"
    else:
        value = _number(plain)
    if entry.type.package is not None:
        return None
    bound = entry.type.string_bound
    return check_scalar(entry.type.name, value, ros_version, string_bound=bound)


def _number(text: str) -> int | float:
    try:
        return int(text)
    except ValueError:
        return float(text)


def _example(entry: Entry, ros_version: int) -> str:
    if entry.python is float:
        return "0.5"
    known = primitive(entry.type.name, ros_version)
    return "5" if known is None or known.high is None else f"5 ({known.low} to {known.high})"


def input_text(form: list[Entry | Heading], given: Mapping[Path, str]) -> tuple[str, list[Entry]]:
    """Return the text after `input`, and the entries that stand in it, in order.

    A field that nothing was entered for keeps its default. Where all fields are plain values and
    each has one, the values go in order; else by name.
    """
    entries = [each for each in form if isinstance(each, Entry)]
    used = [
        entry for entry in entries if given.get(entry.path, "").strip() or _is_space(entry, given)
    ]
    if not used:
        return "none", []
    values = [written(entry, given[entry.path]) for entry in used]
    is_flat = all(len(entry.path) == 1 for entry in entries) and len(form) == len(entries)
    if is_flat and len(used) == len(entries):
        return ", ".join(values), used
    named = (f"{entry.name}={value}" for entry, value in zip(used, values, strict=True))
    return ", ".join(named), used


def _is_space(entry: Entry, given: Mapping[Path, str]) -> bool:
    """Tell whether a text of spaces was entered: it is a text."""
    return entry.python is str and not entry.type.is_array and bool(given.get(entry.path))
