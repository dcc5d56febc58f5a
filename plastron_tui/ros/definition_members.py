"""The rules for one member of a definition: a field, or a constant.

`make_member` is what both a line of a definition file and a statement of a program go through;
a mistake says which part of the member is wrong, and the caller knows where that part stands.
Sources: as in `definition`; what the builders take is that of `genmsg` and `rosidl_adapter`.
"""

from __future__ import annotations

import math
import re
from enum import Enum
from typing import NamedTuple

from .interfaces import Constant, Field, FieldType, InterfaceKind, Scalar
from .primitives import check_scalar, meant_primitive, primitive
from .reserved_words import is_python_word, reserved_by, taken_by

Value = Scalar | tuple[Scalar, ...]

TYPE_PATTERN = (
    r"(?P<type>[A-Za-z][A-Za-z0-9_/]*)(?P<bound><=(?P<chars>[0-9]{1,9}))?"
    r"(?P<array>\[(?P<bounded><=)?(?P<size>[0-9]{0,9})\])?"
)
"""A type as a definition has it: what is named, a string's bound, and the array."""

_TYPE = re.compile(TYPE_PATTERN, re.ASCII)
_FIELD_NAME = {
    1: re.compile(r"[A-Za-z][A-Za-z0-9_]*"),
    2: re.compile(r"[a-z][a-z0-9]*(?:_[a-z0-9]+)*"),
}
_CONSTANT_NAME = {1: _FIELD_NAME[1], 2: re.compile(r"[A-Z][A-Z0-9]*(?:_[A-Z0-9]+)*")}
_MESSAGE_NAME = {1: _FIELD_NAME[1], 2: re.compile(r"[A-Z][A-Za-z0-9]*")}
_PACKAGE_NAME = {1: _FIELD_NAME[1], 2: _FIELD_NAME[2]}
_NAME_RULE = {
    1: "letters, digits and `_`, a letter first",
    2: "lower-case letters, digits and single `_`, a letter first",
}


_LINE_ENDS = "\x0b\x0c\x1c\x1d\x1e\x85\u2028\u2029"
"""What ends a line besides a newline where `rosidl_adapter` splits a definition."""


_OF_ACTION = (
    "Action",
    "ActionGoal",
    "ActionResult",
    "ActionFeedback",
    "Goal",
    "Result",
    "Feedback",
)


class MemberPart(str, Enum):
    """The parts of a member that can be wrong."""

    TYPE = "type"
    BOUND = "bound"
    ARRAY = "array"
    NAME = "name"
    VALUE = "value"


class MemberMistake(NamedTuple):
    """What is wrong with one part of a member; `help` says what to write."""

    part: MemberPart
    message: str
    help: str | None = None


def make_member(
    type_text: str,
    name: str,
    value: Value | None,
    is_constant: bool,
    ros_version: int,
    package: str,
    *,
    is_new: bool = True,
) -> Field | Constant | list[MemberMistake]:
    """Return the member, or what is wrong with it: one mistake for each part at most.

    Args:
        type_text: the type as a definition has it, such as `string<=10[]`.
        name: the member's name.
        value: a constant's value, or a field's default; None without one.
        is_constant: whether it is a constant.
        ros_version: 1 or 2.
        package: the package of the definition, to which a bare type belongs.
        is_new: whether it is to be built in all languages, so that no word of one may name it.
    """
    mistakes: list[MemberMistake] = []
    wrong_type = constant_type(type_text, ros_version) if is_constant else None
    read = wrong_type or field_type(type_text, ros_version, package)
    if isinstance(read, MemberMistake):
        mistakes.append(read)
    wrong_name = check_member_name(name, is_constant, ros_version, is_new=is_new)
    if wrong_name is not None:
        mistakes.append(wrong_name)
    if isinstance(read, FieldType):
        wrong_value = check_value(read, value, is_constant, ros_version)
        if wrong_value is not None:
            mistakes.append(wrong_value)
    if mistakes or isinstance(read, MemberMistake):
        return mistakes
    if not is_constant:
        return Field(name, read, value)
    assert value is not None and not isinstance(value, tuple)  # or it was a mistake
    return Constant(name, read.name, value)


def check_member_name(
    name: str, is_constant: bool, ros_version: int, *, is_new: bool = True
) -> MemberMistake | None:
    """Return what is wrong with the name of a field or constant, None when nothing is.

    Only a new one is held against the words of languages: ROS itself takes others, and who builds
    them for one language alone never meets the words of another.
    """
    rules = _CONSTANT_NAME if is_constant else _FIELD_NAME
    message = f"`{name}` cannot name a {'constant' if is_constant else 'field'}"
    if rules[ros_version].fullmatch(name) is None:
        rule = _NAME_RULE[ros_version]
        if is_constant and ros_version == 2:
            rule = rule.replace("lower", "upper")
        return MemberMistake(MemberPart.NAME, message, f"use {rule}")
    language = reserved_by(name, ros_version) if is_new else None
    if language is not None:
        message = f"{message}: it is a word of {language}, which is generated from definitions"
        return MemberMistake(MemberPart.NAME, message, f"write `{name}_value`, or another name")
    taken = taken_by(name, ros_version) if is_new else None
    if taken is not None:
        return MemberMistake(MemberPart.NAME, f"{message}: it is {taken}", "take another name")
    return None


def check_type_name(name: str, ros_version: int) -> str | None:
    """Tell why a message, service or action cannot have this name, None when it can."""
    if _MESSAGE_NAME[ros_version].fullmatch(name) is None:
        if ros_version == 1:
            return f"`{name}` cannot name a type: it has {_NAME_RULE[1]}"
        return f"`{name}` cannot name a type: it has letters and digits, a capital letter first"
    if primitive(name, ros_version) is not None or (name == "Header" and ros_version == 1):
        return f"`{name}` is a type of its own in definitions"
    if is_python_word(name) or reserved_by(name, ros_version) is not None:
        return f"`{name}` is a word of a language that is generated from definitions"
    return None


def check_type_package(name: str, ros_version: int) -> str | None:
    """Tell why no package of types can have this name, None when one can."""
    if _PACKAGE_NAME[ros_version].fullmatch(name) is None:
        return f"`{name}` cannot name a package: it has {_NAME_RULE[ros_version]}"
    language = "Python" if is_python_word(name) else reserved_by(name, ros_version)
    if language is not None:
        return f"`{name}` cannot name a package of types: it is a word of {language}"
    return None


LONGEST_TYPE_NAME = 200
"""The longest name of a type, in characters, with a `_` before each word.

Files are called by it, of which file systems take names of 255 bytes: rosidl makes
`detail/NAME__rosidl_typesupport_introspection_cpp.hpp`.
"""

_LONGEST_OF_ROS_1 = 200
"""The most characters of a package and a type of ROS 1.

genmsg makes the target `_PACKAGE_generate_messages_check_deps_NAME`, which CMake makes a folder
for; actionlib_msgs has 14 characters more.
"""


def check_type_length(package: str, name: str, kind: InterfaceKind, ros_version: int) -> str | None:
    """Tell why files cannot be called by a type, None when they can."""
    if len(name) > LONGEST_TYPE_NAME:
        return f"the name of a type has at most {LONGEST_TYPE_NAME} characters, not {len(name)}"
    if ros_version == 1:
        count = len(package) + len(name)
        if count <= _LONGEST_OF_ROS_1:
            return None
        return (
            f"a type and its package have at most {_LONGEST_OF_ROS_1} characters in ROS 1, not "
            f"{count}"
        )
    stem = max(len(each.rpartition("/")[2]) for each in generated_stems(name, kind, 2))
    if stem <= LONGEST_TYPE_NAME:
        return None
    return (
        f"files of this type are called by its words, with a `_` between two of them: they have "
        f"at most {LONGEST_TYPE_NAME} characters, not {stem}"
    )


def generated_stems(name: str, kind: InterfaceKind, ros_version: int) -> frozenset[str]:
    """Return what the files are called that are generated for a type, with their folder.

    Source: in ROS 2 rosidl_pycommon, which puts a `_` where a word begins: `http_server` for
    `HTTPServer`; in ROS 1 actionlib_msgs, which makes messages of an action.
    """
    if ros_version == 1:
        is_action = kind is InterfaceKind.ACTION
        names = [f"{name}{ending}" for ending in _OF_ACTION] if is_action else [name]
        folder = InterfaceKind.MESSAGE.value if is_action else kind.value
        return frozenset(f"{folder}/{each}" for each in names)
    spread = re.sub("(.)([A-Z][a-z]+)", r"\1_\2", name)
    stem = re.sub("([a-z0-9])([A-Z])", r"\1_\2", spread).lower()
    return frozenset((f"{kind.value}/{stem}",))


def constant_type(text: str, ros_version: int) -> MemberMistake | None:
    """Return why a type is none for a constant, None when it is one."""
    match = _TYPE.fullmatch(text)
    known = primitive(match["type"], ros_version) if match else None
    if match is None or (known and not (known.parts or match["array"] or match["bound"])):
        return None
    message = "a constant is of a primitive type"
    if known is None or known.parts:
        return MemberMistake(MemberPart.TYPE, message)
    return MemberMistake(MemberPart.ARRAY if match["array"] else MemberPart.BOUND, message)


def field_type(text: str, ros_version: int, package: str) -> FieldType | MemberMistake:
    """Read the type of a field, as a definition in a package has it."""
    match = _TYPE.fullmatch(text)
    if match is None:
        return MemberMistake(MemberPart.TYPE, f"`{text[:60]}` is no type of ROS {ros_version}")
    size = int(match["size"]) if match["size"] else None
    chars = int(match["chars"]) if match["chars"] else None
    wrong = _check_sizes(match, size, chars, ros_version)
    if wrong is not None:
        return wrong
    named = _named_type(match["type"], ros_version, package)
    if isinstance(named, MemberMistake):
        return named
    name, owner = named
    if chars is not None and name not in ("string", "wstring"):
        return MemberMistake(MemberPart.BOUND, "only a string has a bound of characters")
    return FieldType(
        name,
        owner,
        is_array=match["array"] is not None,
        length=None if match["bounded"] else size,
        bound=size if match["bounded"] else None,
        string_bound=chars,
    )


def _check_sizes(
    match: re.Match[str], size: int | None, chars: int | None, ros_version: int
) -> MemberMistake | None:
    if match["bounded"] and size is None:
        return MemberMistake(MemberPart.ARRAY, "the bound of this sequence is missing")
    if ros_version == 1:
        if chars is not None:
            return MemberMistake(MemberPart.BOUND, "ROS 1 has no bounded types")
        if match["bounded"]:
            return MemberMistake(MemberPart.ARRAY, "ROS 1 has no bounded types", "write `[]`")
        return None
    if size == 0:
        return MemberMistake(MemberPart.ARRAY, "an array of ROS 2 has room for one element or more")
    if chars == 0:
        return MemberMistake(MemberPart.BOUND, "a string of ROS 2 has room for one character")
    return None


def _named_type(
    written: str, ros_version: int, package: str
) -> tuple[str, str | None] | MemberMistake:
    """Return the name and package of the type, without what makes it an array."""
    if primitive(written, ros_version) is not None:
        return written, None
    if written == "Header" and ros_version == 1:
        return "Header", "std_msgs"
    *packages, name = written.split("/")
    owner = packages[0] if packages else package
    is_message = (
        len(packages) < 2
        and _MESSAGE_NAME[ros_version].fullmatch(name)
        and (not packages or _PACKAGE_NAME[ros_version].fullmatch(owner))
        and name not in ("time", "duration", "wstring")
    )
    if is_message:
        return name, owner
    message = f"`{written}` is no type of ROS {ros_version}"
    return MemberMistake(MemberPart.TYPE, message, _type_help(written, ros_version))


def _type_help(written: str, ros_version: int) -> str | None:
    if ros_version == 2 and written in ("time", "duration"):
        return f"write `builtin_interfaces/{written.capitalize()}`"
    if written == "wstring":
        return "write `string`"
    package, _, name = written.partition("/msg/")
    if name:
        return f"write `{package}/{name}`"
    meant = meant_primitive(written, ros_version)
    return None if meant is None else f"did you mean `{meant}`?"


def check_value(
    type_: FieldType, value: Value | None, is_constant: bool, ros_version: int
) -> MemberMistake | None:
    """Return what is wrong with a constant's value or a field's default, None when nothing is."""
    message: str | None = None
    if value is None:
        message = "a constant has a value" if is_constant else None
    elif not is_constant and ros_version == 1:
        message = "a field of ROS 1 has no default value"
    elif type_.package is not None:
        message = "only a field of a primitive type has a default value"
    elif isinstance(value, tuple) != type_.is_array:
        list_text = "the default value of an array is a list in brackets"
        message = list_text if type_.is_array else f"a list is not a value of `{type_}`"
    else:
        message = _check_elements(type_, value, is_constant, ros_version)
    return None if message is None else MemberMistake(MemberPart.VALUE, message)


def _check_elements(
    type_: FieldType, value: Value, is_constant: bool, ros_version: int
) -> str | None:
    elements = value if isinstance(value, tuple) else (value,)
    for element in elements:
        problem = check_scalar(type_.name, element, ros_version, type_.string_bound)
        problem = problem or _check_tabs(type_, element)
        problem = problem or _check_text(element, is_constant, ros_version)
        if problem is not None:
            return problem
    if isinstance(value, tuple):
        most = type_.bound if type_.length is None else type_.length
        is_short = type_.length is not None and len(value) < type_.length
        if is_short or (most is not None and len(value) > most):
            return f"{len(value)} elements do not fit `{type_}`"
    return None


def _check_tabs(type_: FieldType, value: Scalar) -> str | None:
    """Tell where a text is too long for its bound as `rosidl_adapter` counts: before escapes."""
    if type_.string_bound is None or not isinstance(value, str):
        return None
    tabs = value.count("\t")
    count = len(value) + tabs
    if not tabs or count <= type_.string_bound:
        return None
    return f"{count} characters do not fit `{type_}`: builders count a tab as two, `\\t`"


def _check_text(value: Scalar, is_constant: bool, ros_version: int) -> str | None:
    """Tell why a definition cannot hold a value that its type can, None when it can."""
    if isinstance(value, float) and not math.isfinite(value):
        return "a definition has no infinity and no nan"
    if not isinstance(value, str):
        return None
    if "\n" in value or "\r" in value:
        return "a value stands on one line of a definition"
    if ros_version == 1:
        is_cut = value != value.strip()
        return "ROS 1 drops the space around the string of a constant" if is_cut else None
    if any(each in _LINE_ENDS for each in value):
        return "ROS 2 takes a character of this text for the end of a line"
    if "#" in value:
        return "in a ROS 2 definition `#` starts a comment, in quotes too"
    if "=" in value and not is_constant:
        return "ROS 2 takes a line with `=` for a constant, so that a default has none"
    return None
