"""What is wrong with messages: their fields, and the values that these get."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from plastron_tui.diagnostics import Code, Diagnostic, Edit, Fix, Severity, Span, guess, listed
from plastron_tui.lint.dependencies import TYPE_ENDINGS
from plastron_tui.lint.message_fields import PYTHON, Messages, Missing, described, units_of
from plastron_tui.lint.message_values import (
    element_out_of_range,
    family_of,
    is_refused,
    kind_of,
    words,
)
from plastron_tui.lint.rule import rule
from plastron_tui.lint.tree import SourceTree, UnitFacts
from plastron_tui.model.code_facts import (
    ITEM,
    Built,
    FieldUse,
    FieldValue,
    MessageField,
    MessageType,
    Part,
    ValueKind,
)
from plastron_tui.ros.interfaces import FieldType
from plastron_tui.ros.name_slips import is_slip
from plastron_tui.ros.primitives import PRIMITIVES

from .message_examples import driver, sender

_MOST_NAMES = 12
_OF_TIMES = frozenset({"to_sec", "to_nsec", "to_time", "is_zero"})


@rule(
    "RM201",
    "unknown-field",
    "A field is read or written that the message does not have.",
    why="Python says so only when it comes to the line: an `AttributeError`, for a keyword of a "
    "constructor an `AssertionError`; in newer releases rclpy says nothing of such a keyword, "
    "and the value is lost. C++ does not compile. What a variable may be besides, a field that "
    "another release has, and a type that is not known are not told.",
    bad={"driver.py": driver(field="linear.w")},
    good={"driver.py": driver(field="linear.x")},
)
def unknown_field(tree: SourceTree, code: Code) -> Iterator[Diagnostic]:
    """Find fields that messages do not have."""
    for unit, messages in units_of(tree):
        seen: set[tuple[str, Span]] = set()
        for use in unit.code.fields:
            found = _missing(messages, use)
            if found is None or (use.file, found[1]) in seen:
                continue
            seen.add((use.file, found[1]))
            yield _told(code, unit, use.file, *found, use.path)
        for built in unit.code.built:
            yield from _unknown_keywords(code, unit, messages, built)


def _missing(messages: Messages, use: FieldUse) -> tuple[Missing, Span] | None:
    """Return the name of a path that leads nowhere, whichever of its messages it is."""
    found = messages.missing(MessageField(use.type, use.path))
    if found is None or any(messages.missing(each) is None for each in use.others):
        return None
    index = found.position - (len(use.path) - len(use.spans))
    return (found, use.spans[index]) if index >= 0 else None


def _told(
    code: Code, unit: UnitFacts, file: str, found: Missing, span: Span, path: Sequence[str]
) -> Diagnostic:
    name = path[found.position]
    if found.field:
        message = f"`{found.field}` is {found.owner}, which has no `{name}`"
    else:
        message = f"{found.owner} has no {_word(name)} `{name}`"
    remedy, fix = guess(name, found.names, span)
    if not any(_is_meant(name, each) for each in found.names):
        # What is near may be another thing.
        fix = None
        if found.deeper:
            # What is behind an element has a path of its own.
            before = path[: found.position]
            start = max((at for at, each in enumerate(before, 1) if each == ITEM), default=0)
            remedy = f"did you mean `{'.'.join((*before[start:], *found.deeper))}`?"
        elif not any(_is_near(name, each) for each in found.names):
            remedy = None
    elif any(name.rstrip("s") == each.rstrip("s") != "" for each in found.names):
        # One of a list is no list.
        fix = None
    if found.other is not None:
        what = "constant" if found.is_constant else "field"
        message = f"`{name}` is a {what} of {described(found.other)}, not of its {_part(found)}"
        remedy, fix = f"the definition has it in the part of the {found.other.part.value}", None
    elif name in _OF_TIMES:
        remedy, fix = "a time that has it is `rclpy.time.Time.from_msg(…)`", None
    elif name == "seq" and "Header" in found.owner:
        remedy, fix = "ROS 2 does not number messages", None
    elif remedy is None and 0 < len(found.names) <= _MOST_NAMES:
        remedy = f"it has {listed(f'`{each}`' for each in found.names)}"
    elif remedy is None and found.owner.startswith("a list"):
        remedy = f"take an element of it: `{found.field}[0]`"
    return Diagnostic(code, message, span, unit.file(file), remedy, fix)


def _word(name: str) -> str:
    return "constant" if name.isupper() and len(name) > 1 else "field"


def _part(found: Missing) -> str:
    return found.owner.removeprefix("the ").partition(" ")[0]


def _is_near(name: str, other: str) -> bool:
    """Whether one of two names is a part of the other, as `frame` is of `frame_id`."""
    shorter, longer = sorted((name.lower(), other.lower()), key=len)
    return len(shorter) > 2 and shorter in longer


def _is_meant(name: str, other: str) -> bool:
    """Whether a name can only be another one with a slip."""
    return name.lower() == other.lower() or is_slip(name, other)


def _unknown_keywords(
    code: Code, unit: UnitFacts, messages: Messages, built: Built
) -> Iterator[Diagnostic]:
    for name, span in built.keywords:
        if name == "check_fields" and messages.version == 2:
            continue
        found = messages.missing(MessageField(built.type, (name,)))
        if found is not None:
            # A keyword has no path.
            yield _told(code, unit, built.file, found._replace(deeper=()), span, (name,))


@rule(
    "RM202",
    "wrong-value-kind",
    "A field gets a value of a kind that it does not hold.",
    why="rclpy checks the value when the field gets it, or, since Jazzy and unless it is asked to, "
    "sends what the value is not; rospy fails when the message is sent. None for a field that is "
    "a message, a message in the place of its `data`, and `get_clock().now()` without `.to_msg()` "
    "belong here. What tests do is theirs; a value that may be of several kinds is not told.",
    bad={"sender.py": sender(value="42")},
    good={"sender.py": sender(value="'42'")},
)
def wrong_value_kind(tree: SourceTree, code: Code) -> Iterator[Diagnostic]:
    """Find values that fields do not hold."""
    for unit, messages in units_of(tree):
        for value in _given(unit, messages):
            places = [messages.place(each) for each in _places(value)]
            place = places[0]
            if place is None or not all(
                each is not None and is_refused(messages, each, value) for each in places
            ):
                continue
            is_time = value.kind is ValueKind.TIME and messages.version == 2
            is_message = kind_of(place, messages.version) is ValueKind.MESSAGE
            is_unsent = is_time and is_message
            yield Diagnostic(
                code,
                _refusal(messages, place, value),
                value.span,
                unit.file(value.file),
                "`.to_msg()` makes a message of it" if is_unsent else None,
                _behind(value.span, ".to_msg()") if is_unsent else None,
            )


def _refusal(messages: Messages, place: FieldType | MessageType, value: FieldValue) -> str:
    given = _elements_words(messages, value)
    wrong = element_out_of_range(messages, place, value)
    if wrong is not None:
        given = f"a list with `{wrong}`"
    if not value.path and value.type.part is Part.RESPONSE:
        given = "a list or a tuple" if value.kind is ValueKind.LIST else given
        return f"the service answers with {given}, and not with {described(value.type)}"
    if not value.path:
        return f"what is sent here is {given}, and has to be {_type_words(messages, place)}"
    return f"{_field_words(messages, value)} is {_type_words(messages, place)}, and gets {given}"


def _type_words(messages: Messages, place: FieldType | MessageType) -> str:
    """Return what a field is, with its limits where it has some."""
    if not isinstance(place, FieldType):
        return described(place)
    name = place.element.name if place.is_array else place.name
    primitive = PRIMITIVES[messages.version].get(name)
    limits = primitive.range_text if primitive is not None else ""
    return f"`{place}` ({limits})" if limits else f"`{place}`"


def _given(unit: UnitFacts, messages: Messages) -> Iterator[FieldValue]:
    """Yield the values that fields get: of those without a name none arrives in rclpy."""
    for value in () if unit.is_test else unit.code.values:
        if messages.version == 1 or not value.path or not value.path[0].startswith("#"):
            yield value


def _places(value: FieldValue) -> tuple[MessageField, ...]:
    return (MessageField(value.type, value.path), *value.others)


def _field_words(messages: Messages, value: FieldValue) -> str:
    """Return which field gets a value, in words."""
    names = [each for each in value.path if each != ITEM]
    last = value.path[-1]
    if last.startswith("#"):
        names = [messages.fields(value.type)[int(last[1:])].name]
    if not names:
        return f"an element of {described(value.type)}"
    field = f"`{'.'.join(names)}` of {described(value.type)}"
    return f"an element of {field}" if last == ITEM else f"field {field}"


def _elements_words(messages: Messages, value: FieldValue) -> str:
    told = words(messages, value)
    if value.kind is ValueKind.INT and value.text:
        return f"`{value.text}`"
    if value.kind is not ValueKind.LIST or not value.elements:
        return told
    kinds = dict.fromkeys(each.value for each in value.elements)
    return f"a list of {listed(f'`{each}`' for each in kinds)}"


def _behind(span: Span, text: str) -> Fix:
    return Fix(f"write `{text}` behind it", (Edit(Span(span.end, span.end), text),))


@rule(
    "RM203",
    "int-in-float-field",
    "A field of floating point gets an integer in rclpy.",
    why="Up to Iron rclpy raises an `AssertionError`. Since Jazzy it does not look, and sends what "
    "the bytes of the object are as a number: `x=1` arrives as 5e-324. A list of integers for a "
    "list is refused up to Iron alone, and a warning. rospy and C++ convert integers; what tests "
    "do is theirs.",
    bad={"driver.py": driver(value="1")},
    good={"driver.py": driver(value="1.0")},
)
def int_in_float_field(tree: SourceTree, code: Code) -> Iterator[Diagnostic]:
    """Find integers in fields of floating point."""
    for unit, messages in units_of(tree, "rclpy"):
        for value in _given(unit, messages):
            places = [messages.place(each) for each in _places(value)]
            if not all(_is_int_in_float(messages, each, value) for each in places):
                continue
            remedy, fix = _as_float(value)
            yield Diagnostic(
                code,
                f"{_field_words(messages, value)} is `{places[0]}`, and gets "
                f"{_elements_words(messages, value)}",
                value.span,
                unit.file(value.file),
                remedy,
                fix,
                severity=Severity.WARNING if value.kind is ValueKind.LIST else None,
            )


def _is_int_in_float(messages: Messages, place: object, value: FieldValue) -> bool:
    if not isinstance(place, FieldType) or place.message is not None:
        return False
    if family_of(place.name, messages.version) != "float" or is_refused(messages, place, value):
        return False
    if place.is_array:
        return value.kind is ValueKind.LIST and ValueKind.INT in value.elements
    if value.kind is ValueKind.MESSAGE and value.source is not None:
        source = messages.place(value.source)
        return source is not None and kind_of(source, messages.version) is ValueKind.INT
    return value.kind is ValueKind.INT


def _as_float(value: FieldValue) -> tuple[str, Fix | None]:
    """Return how a value becomes one of floating point."""
    if value.kind is ValueKind.LIST:
        count = value.elements.count(ValueKind.INT)
        edits = tuple(Edit(Span(each.end, each.end), ".0") for each in value.items)
        is_whole = len(edits) == count
        return "write `0.0` for `0`", Fix("write `.0` behind", edits) if is_whole else None
    if value.text.removeprefix("-").isdecimal():
        text = f"{value.text}.0"
        return f"write `{text}`", Fix(f"write `{text}`", (Edit(value.span, text),))
    start, end = value.span
    edits = (Edit(Span(start, start), "float("), Edit(Span(end, end), ")"))
    return "`float(…)` makes one of it", Fix("write `float(…)` around it", edits)


@rule(
    "RM204",
    "positional-constructor",
    "A message is constructed of values without names that it does not take so.",
    why="In rclpy a constructor of a message takes keywords only: a `TypeError`. In rospy it takes "
    "the values of all fields in their order, or keywords, and not both. `--fix` writes the names "
    "where no value is one that its field does not hold.",
    bad={"sender.py": sender(construct="String('hello')")},
    good={"sender.py": sender(construct="String(data='hello')")},
)
def positional_constructor(tree: SourceTree, code: Code) -> Iterator[Diagnostic]:
    """Find messages that are constructed of values without names."""
    for unit, messages in units_of(tree, *sorted(PYTHON)):
        for built in () if unit.is_test else unit.code.built:
            section = messages.section(built.type)
            fields = () if section is None else section.fields
            is_named = messages.version == 2 and built.type.name.package.endswith(TYPE_ENDINGS)
            if not built.positional or (section is None and not is_named):
                continue
            names = [each.name for each in fields]
            if messages.version == 2:
                what = f"{described(built.type)} takes values by name only in rclpy"
            elif built.keywords:
                what = f"{described(built.type)} takes values by name, or all in order, not both"
            elif built.positional != len(names):
                what = (
                    f"{described(built.type)} takes {len(names)} values in order, and gets "
                    f"{built.positional}"
                )
            else:
                continue
            remedy, fix = "write the name before each" if names else None, None
            if built.places and _fit(unit, messages, built):
                fix = _named(built, names)
            elif 0 < len(names) <= _MOST_NAMES:
                remedy = f"its fields are {listed(f'`{x.type} {x.name}`' for x in fields)}"
            yield Diagnostic(code, what, built.span, unit.file(built.file), remedy, fix)


def _fit(unit: UnitFacts, messages: Messages, built: Built) -> bool:
    """Tell whether the values may stand in the fields whose turn it is."""
    for value in unit.code.values:
        is_here = value.file == built.file and value.span.start in built.places
        if is_here and value.type == built.type:
            place = messages.place(MessageField(value.type, value.path))
            if place is not None and is_refused(messages, place, value):
                return False
            if messages.version == 2 and _is_int_in_float(messages, place, value):
                return False
    return True


def _named(built: Built, names: Sequence[str]) -> Fix | None:
    """Return the remedy that writes the names of the fields before the values."""
    given = names[: built.positional]
    is_clear = len(given) == built.positional == len(built.places)
    if not is_clear or any(name in given for name, _ in built.keywords):
        return None
    edits = tuple(
        Edit(Span(place, place), f"{name}=")
        for name, place in zip(given, built.places, strict=True)
    )
    return Fix("write the names", edits)
