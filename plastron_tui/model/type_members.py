"""From the fields of a statement to the members of a definition, in one generation of ROS."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, NamedTuple

from plastron_tui.diagnostics import Diagnostic, Span, codes, write
from plastron_tui.language.definitions import FieldText
from plastron_tui.language.inputs import InputValue, ListValue, Literal
from plastron_tui.ros.definition_members import (
    MemberMistake,
    MemberPart,
    Value,
    check_member_name,
    make_member,
)
from plastron_tui.ros.interfaces import (
    Constant,
    Field,
    Interface,
    InterfaceKind,
    InterfaceName,
    Scalar,
    Section,
)
from plastron_tui.ros.primitives import meant_primitive, other_word, primitive

from .mistake import Mistake
from .types import TypeProblem

if TYPE_CHECKING:
    from plastron_tui.language.declaration import Statement

    from .types import TypeResolver

_FIELDS = {MemberPart.NAME: "name", MemberPart.VALUE: "value"}
"""The grammar's field of a part of a member; the others are parts of its type."""


class Naming(NamedTuple):
    """What the names of types in a definition mean.

    Attributes:
        version: the generation of ROS.
        package: the package of the definition.
        resolver: looks types up.
        own: the type itself, of which it can have no field.
        is_broken: tells whether a type that is not known was to be made by a broken statement.
        explain: returns what to say of a type that is not known.
    """

    version: int
    package: str
    resolver: TypeResolver
    own: str
    is_broken: Callable[[str, TypeProblem], bool]
    explain: Callable[[str, InterfaceKind, TypeProblem], TypeProblem]

    def full(self, type_text: str) -> str | TypeProblem:
        """Return a type as a definition of the package has it: with its package, if another's.

        Raises:
            Mistake: the type is not there because of an earlier mistake.
        """
        base, bracket, array = type_text.partition("[")
        name, bound, length = base.partition("<=")
        if primitive(name, self.version) is not None or (name, self.version) == ("Header", 1):
            return type_text
        if name in (self.own, f"{self.package}/{self.own}"):
            return TypeProblem(codes.CIRCULAR_TYPE, f"`{self.own}` contains itself", None)
        found = self.resolver.resolve(name, InterfaceKind.MESSAGE)
        if isinstance(found, TypeProblem):
            if self.is_broken(name, found):
                raise Mistake
            explained = self.explain(name, InterfaceKind.MESSAGE, found)
            if explained is not found:
                return explained
            right = meant_primitive(name, self.version)
            is_slip = right is not None and found.code == codes.UNKNOWN_TYPE
            remedy = f"did you mean `{right}`?"
            return found._replace(help=remedy, right=right) if is_slip else found
        own = found.name.package == self.package
        shown = found.name.name if own else str(found.name)
        return f"{shown}{bound}{length}{bracket}{array}"


def section_of(
    statement: Statement, fields: Sequence[FieldText], naming: Naming
) -> Section | list[Diagnostic]:
    """Return what some fields of a statement make of a definition, or all that is wrong.

    Raises:
        Mistake: nothing is wrong but that types are not there because of an earlier mistake.
    """
    members: list[Field | Constant] = []
    wrong: list[Diagnostic] = []
    names: set[str] = set()
    is_broken = False
    for each in fields:
        try:
            found = _member(statement, each, naming)
        except Mistake:
            is_broken = True
            continue
        if isinstance(found, list):
            wrong += found
        elif found.name in names:
            message = f"`{found.name}` is there twice"
            wrong.append(Diagnostic(codes.BAD_FIELD, message, _span(statement, each, "name")))
        else:
            members.append(found)
            names.add(found.name)
    if wrong:
        return wrong
    if is_broken:
        raise Mistake
    return Section(
        tuple(each for each in members if isinstance(each, Field)),
        tuple(each for each in members if isinstance(each, Constant)),
    )


def _member(
    statement: Statement, each: FieldText, naming: Naming
) -> Field | Constant | list[Diagnostic]:
    try:
        value = None if each.value is None else _plain(each.value)
    except Mistake:
        message = "a definition holds numbers, texts and lists of them"
        return [Diagnostic(codes.BAD_FIELD, message, _span(statement, each, "value"))]
    unsure = None if naming.version == 1 else changed_by_builders(value)
    if unsure is not None:
        return [Diagnostic(codes.BAD_FIELD, unsure, _span(statement, each, "value"))]
    type_text = naming.full(each.type)
    if isinstance(type_text, TypeProblem):
        swapped = _swapped(statement, each, naming, type_text)
        if swapped is not None:
            return [swapped]
        where = _span(statement, each, "type")
        base = where._replace(end=where.start + len(base_of(each.type)))
        fix = None if type_text.right is None else write(type_text.right, base)
        wrong = Diagnostic(
            type_text.code,
            type_text.message,
            where,
            help=type_text.help,
            fix=fix,
            labels=type_text.labels,
        )
        name = check_member_name(each.name, each.operator == "=", naming.version)
        return [wrong] if name is None else [wrong, _told(statement, each, name)]
    right = _default(each) if naming.version == 2 else None
    made = make_member(
        type_text, each.name, value, each.operator == "=", naming.version, naming.package
    )
    if not isinstance(made, list):
        return made
    told = [_told(statement, each, found) for found in made]
    if right is None or made[0].part is not MemberPart.NAME:
        return told
    return [told[0]._replace(help=with_default(told[0].help, right)), *told[1:]]


def _default(each: FieldText) -> str | None:
    """Return a field with a default value, where a constant is written whose name is a field's."""
    value = each.syntax.child_by_field_name("value")
    if each.operator != "=" or value is None or value.text is None or not is_field_name(each.name):
        return None
    return f"{each.type} {each.name} default {value.text.decode()}"


def is_field_name(name: str) -> bool:
    """Tell whether ROS 2 takes a name for that of a field."""
    return check_member_name(name, is_constant=False, ros_version=2) is None


def with_default(remedy: str | None, field: str | None) -> str | None:
    """Return what to write for a constant, or for the field that was meant."""
    if remedy is None or field is None:
        return remedy
    return f"{remedy}; or, for a field that starts from this value: `{field}`"


def _swapped(
    statement: Statement, each: FieldText, naming: Naming, problem: TypeProblem
) -> Diagnostic | None:
    """Tell where a field has its name before its type: `left float64`."""
    if problem.code != codes.UNKNOWN_TYPE:
        return None
    type_text = type_before(each.type, each.name, naming)
    if type_text is None:
        return None
    where = Span(_span(statement, each, "type").start, _span(statement, each, "name").end)
    fix = write(f"{type_text} {each.type}", where)
    return Diagnostic(codes.BAD_FIELD, TYPE_FIRST, where, help=fix.title, fix=fix)


TYPE_FIRST = "the type of a field comes before its name"


def type_before(first: str, second: str, naming: Naming) -> str | None:
    """Return the type that stands where a name does, None where none stands there.

    Args:
        first: what is written for the type, and is none.
        second: what is written for the name.
        naming: what types mean.
    """
    if check_member_name(first, is_constant=False, ros_version=naming.version) is not None:
        return None
    is_type = primitive(second, naming.version) is not None or isinstance(
        naming.resolver.resolve(second, InterfaceKind.MESSAGE), Interface
    )
    return second if is_type else other_word(second)


def base_of(type_text: str) -> str:
    """Return what a type names, without bound and brackets."""
    return type_text.partition("[")[0].partition("<=")[0]


def _told(statement: Statement, each: FieldText, found: MemberMistake) -> Diagnostic:
    where = _span(statement, each, _FIELDS.get(found.part, "type"))
    return Diagnostic(codes.BAD_FIELD, found.message, where, help=found.help)


def _plain(value: InputValue) -> Value:
    """Return a value as a definition can hold it.

    Raises:
        Mistake: it is computed, or a list in a list.
    """
    if isinstance(value, ListValue):
        return tuple(_scalar(item) for item in value.items)
    return _scalar(value)


def _scalar(value: InputValue) -> Scalar:
    if not isinstance(value, Literal):
        raise Mistake
    return value.value


def changed_by_builders(value: Value | None) -> str | None:
    """Tell why the builders of ROS 2 would not keep a value, None where they do.

    Source: rosidl_adapter writes it into IDL, where rosidl_parser decodes escapes once more; a
    list of texts is read there as ASCII.
    """
    values = value if isinstance(value, tuple) else (value,)
    texts = [each for each in values if isinstance(each, str)]
    if any("\\" in each for each in texts):
        return "a text in a definition of ROS 2 does not keep a backslash"
    if isinstance(value, tuple) and any('"' in each and "'" in each for each in texts):
        return "a list of texts in a definition of ROS 2 does not keep quotes of both kinds"
    if isinstance(value, tuple) and any(
        each[:1] in "'\"" and each[:1] == each[-1:] for each in texts if each
    ):
        return "a list of texts in a definition of ROS 2 does not keep the quotes around a text"
    if isinstance(value, tuple) and not all(each.isascii() for each in texts):
        return "a list of texts in a definition of ROS 2 is ASCII alone"
    return None


def _span(statement: Statement, each: FieldText, part: str) -> Span:
    node = each.syntax.child_by_field_name(part) or each.syntax
    return Span(node.start_byte, node.end_byte).moved(statement.shift)


def members_of(section: Section) -> dict[str, Field | Constant]:
    """Return the fields and constants of a section by name, without what is said of them."""
    fields: list[Field | Constant] = [each._replace(comment="") for each in section.fields]
    return {each.name: each for each in (*fields, *section.constants)}


def nested_names(section: Section) -> set[InterfaceName]:
    """Return the messages that a section has for fields."""
    return {each.type.message for each in section.fields if each.type.message is not None}
