"""Values that rospy puts into fields by itself, written as rclpy takes them: named, and typed."""

from __future__ import annotations

from collections.abc import Sequence
from keyword import iskeyword

from tree_sitter import Node

from plastron_tui.ros.interfaces import Field, FieldType, InterfaceKind, InterfaceName
from plastron_tui.sources.python import literals
from plastron_tui.sources.python.splices import Splice
from plastron_tui.sources.python.syntax import parts_of

from .kinds import LIST, MESSAGE, PLAIN, REAL, is_plain, kind_of, some_plain
from .message_types import constructed, typed
from .port_state import Work
from .types import new_field, target_type

Fields = dict[str, FieldType | None]
"""The fields of a message by name, in the order of ROS 1; None for one that ROS 2 lacks."""

Given = list[tuple[str | None, Node]]
"""What is given for fields, with the names where the source says them."""


def fields_of(work: Work, type_: InterfaceName, kind: InterfaceKind, side: str) -> Fields | None:
    """Return the fields of a message or of a service's side, None where nobody knows the type."""
    target, _ = target_type(work, type_, kind)
    new = work.catalog.find(target, kind) if target is not None else None
    if new is None:
        return None
    old = work.before.find(type_, kind) or new
    index = int(side == "Response")
    types = {each.name: each.type for each in new.sections[index].fields}
    listed: Sequence[Field] = old.sections[index].fields
    there = new.sections[index]
    return {each.name: types.get(new_field(each.name, there) or "") for each in listed}


def write_fields(
    work: Work, given: Given, fields: Fields, *, is_sure: bool = True
) -> list[Splice] | None:
    """Name each value's field, and make it of the type that the field has.

    Args:
        work: the file.
        given: the values.
        fields: the fields.
        is_sure: whether a value of which nothing is known is made sure of; a message that
            the file makes by keywords itself stays as it is there.

    Returns:
        what to insert; None where a value may not be what the field takes, or their number is
        not that of the fields, which rospy refuses as well.
    """
    splices: list[Splice] = []
    if not given:
        return splices
    is_named = [name is not None for name, _ in given]
    if any(is_named) != all(is_named) or (not all(is_named) and len(given) != len(fields)):
        return None
    for (name, value), field in zip(given, [*fields, *[""] * len(given)], strict=False):
        type_ = fields.get(name or field)
        # A field may be called `lambda`, which no call can name.
        if type_ is None or (name is None and iskeyword(field)):
            return None
        # A field of ROS 2 has small letters only.
        prefix = f"{field.lower()}=" if name is None else ""
        found = write_value(work, value, type_, prefix, is_sure)
        if found is None:
            return None
        splices += found
    return splices


def write_value(
    work: Work, value: Node, type_: FieldType, prefix: str = "", is_sure: bool = False
) -> list[Splice] | None:
    """Make a value of the type that a field has; None where it may not be what it takes."""
    is_open = not is_sure and not some_plain(work, value) and value.type not in ("list", "tuple")
    is_open = is_open and not is_unchecked(type_)
    found = _AS_IT_IS if is_open else _value(work, value, type_)
    if found is None:
        return None if is_sure else []
    before, inside, behind = found
    encode = work.analysis.syntax.encode
    return [
        Splice(value.start_byte, value.start_byte, encode(prefix + before)),
        *inside,
        Splice(value.end_byte, value.end_byte, encode(behind)),
    ]


def is_unchecked(type_: FieldType) -> bool:
    """Tell whether rclpy reads whatever a field holds as the memory of a `float` or a `bool`.

    Source: the `convert_from_py` of `rosidl_generator_py`; a setter checks only where
    `ROS_PYTHON_CHECK_FIELDS` is set.
    """
    return type_.package is None and (type_.name == "bool" or type_.name.startswith("float"))


_Written = tuple[str, list[Splice], str]
"""What goes before a value, what changes inside of it, and what goes behind it."""

_AS_IT_IS: _Written = ("", [], "")


def _value(work: Work, value: Node, type_: FieldType) -> _Written | None:
    """Write a value as rclpy asserts that a field has it, None where nobody can be sure."""
    if type_.is_array:
        return _array(work, value, type_)
    kind = kind_of(work, value)
    if type_.package is not None:
        is_now = value.id in work.done
        return _AS_IT_IS if is_now or not is_plain(kind) else None
    if kind == MESSAGE:
        return None
    if type_.name == "byte":
        return _octet(work, value)
    if type_.name.startswith("float"):
        return _float(work, value, kind)
    if type_.name == "bool":
        return _AS_IT_IS if kind == "bool" else _wrapped("bool", kind)
    if type_.name in ("string", "wstring"):
        return _AS_IT_IS if kind in ("str", None, PLAIN) else None
    return _AS_IT_IS if kind not in ("str", "float", REAL, "bytes", "dict", LIST) else None


def _wrapped(function: str, kind: str | None) -> _Written | None:
    return None if kind in ("str", "bytes", "dict", LIST) else (f"{function}(", [], ")")


def _float(work: Work, value: Node, kind: str | None) -> _Written | None:
    """Write a number as a `float`: by its point where it is a literal, else by a call."""
    if kind == "float":
        return _AS_IT_IS
    digits = value
    if value.type == "unary_operator":
        digits = value.child_by_field_name("argument") or value
    if digits.type == "integer" and work.slice(digits).isdigit():
        return "", [], ".0"
    return _wrapped("float", kind)


def _octet(work: Work, value: Node) -> _Written | None:
    if value.type != "integer" or not work.slice(value).isdigit():
        return None
    encode = work.analysis.syntax.encode
    octet = literals.octet(int(work.slice(value)))
    return "", [Splice(value.start_byte, value.end_byte, encode(octet))], ""


def _array(work: Work, value: Node, type_: FieldType) -> _Written | None:
    """Write the elements of a list; what is no literal is left where its elements may be right."""
    kind = kind_of(work, value)
    if typed(work, value) == type_:
        return _AS_IT_IS
    element = type_._replace(is_array=False, length=None, bound=None)
    if value.type in ("list", "tuple"):
        inside: list[Splice] = []
        encode = work.analysis.syntax.encode
        for each in parts_of(value):
            found = None if "splat" in each.type else _value(work, each, element)
            if found is None:
                return None
            inside.append(Splice(each.start_byte, each.start_byte, encode(found[0])))
            inside += found[1]
            inside.append(Splice(each.end_byte, each.end_byte, encode(found[2])))
        return "", inside, ""
    if type_.name.startswith("float") and kind in (None, LIST, PLAIN, REAL):
        return _each_a_float(work, value)
    is_exact = type_.package is not None or type_.name in ("string", "uint8", "char")
    is_integer = type_.name.startswith(("int", "uint"))
    return _AS_IT_IS if kind in (None, LIST, "bytes") and (is_exact or is_integer) else None


def _each_a_float(work: Work, values: Node) -> _Written:
    """Write a list of values as one of `float`s."""
    made = values.child_by_field_name("body") if values.type == "list_comprehension" else None
    if made is None:
        return "[float(each) for each in ", [], "]"
    encode = work.analysis.syntax.encode
    found = _float(work, made, kind_of(work, made)) or _AS_IT_IS
    start, end = made.start_byte, made.end_byte
    inside = [Splice(start, start, encode(found[0])), *found[1], Splice(end, end, encode(found[2]))]
    return "", inside, ""


def is_real_elsewhere(work: Work, target: Node) -> bool:
    """Tell whether the file puts a number with a point into a field of a message nobody knows."""
    part, made = target.child_by_field_name("attribute"), _classes(work, target)
    if part is None or not made:
        return False
    for each in work.analysis.captures.get("assignment", []):
        left, right = each.child_by_field_name("left"), each.child_by_field_name("right")
        name = left.child_by_field_name("attribute") if left is not None else None
        is_field = name is not None and work.slice(name) == work.slice(part)
        is_real = is_field and kind_of(work, right) == "float"
        if left is not None and is_real and _classes(work, left) == made:
            return True
    return False


def _classes(work: Work, target: Node) -> set[InterfaceName]:
    """Return the messages that what holds a field is made as."""
    holder = target.child_by_field_name("object")
    found = set()
    for each in work.bindings(holder) if holder is not None else ():
        callee = each.value.child_by_field_name("function") if each.value is not None else None
        made = constructed(work, callee) if callee is not None else None
        if made is None:
            return set()
        found.add(made[0])
    return found
