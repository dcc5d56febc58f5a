"""What completion offers among values: fields, parameters, and parts of what is received."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

from plastron_tui.language import SlotKind
from plastron_tui.language.expectations import Expectation, ValuePlace
from plastron_tui.language.open_values import ARITHMETIC
from plastron_tui.model.kinds import INTERFACES, Parameter
from plastron_tui.model.kinds.computed import fits
from plastron_tui.model.kinds.received import what_of
from plastron_tui.ros.interfaces import Field, FieldType, Interface, InterfaceKind

from .candidate import Candidate
from .vocabulary import Vocabulary

if TYPE_CHECKING:
    from plastron_tui.model.types import TypeResolver
    from plastron_tui.ros.catalog import Catalog

_RECEIVED = "received."
_OPERATORS = frozenset({"<", "=", ">"})
_BEFORE_VALUE = frozenset({"=", ",", "(", "["})
_TRUTH = (Candidate("True"), Candidate("False"))
_DEEPEST = 4


def resolver(catalog: Catalog) -> TypeResolver:
    """Return what looks types up."""
    from plastron_tui.model.types import TypeResolver

    return TypeResolver(catalog)


def rates(expected: Expectation, vocabulary: Vocabulary) -> Iterator[Candidate]:
    """Offer the parameters of the node that say how often, which are numbers."""
    own = vocabulary.parameters(expected.filled.get("node", ""))
    numbers = [
        name for name, each in own.items() if each.holds is not None and each.holds.is_number
    ]
    yield from _parameters(numbers, expected.written, " hz")


def _parameters(
    names: Iterable[str], written: Sequence[str], after: str = ""
) -> Iterator[Candidate]:
    before = "" if written[-1:] == ("parameter",) else "parameter "
    for name in names:
        yield Candidate(f"{before}'{name}'", "", after)


def default_values(expected: Expectation) -> Iterator[Candidate]:
    """Offer what a parameter may hold where that is either this or that."""
    is_first = not expected.written or expected.written[-1] in _BEFORE_VALUE
    if is_first and expected.filled.get("type", "").startswith("bool"):
        yield from _TRUTH


def conditions(
    expected: Expectation, vocabulary: Vocabulary, catalog: Catalog
) -> Iterator[Candidate]:
    """Offer the parts of a condition: whether of a list any or all, a field, and an operator."""
    written, filled = expected.written, expected.filled
    last = written[-1] if written else ""
    if not _OPERATORS.isdisjoint(written):
        return
    if last.startswith(_RECEIVED) or last == "]":
        yield from map(Candidate, sorted(_OPERATORS))
        return
    if not written:
        yield Candidate("any", "one element of a list at least", " ")
        yield Candidate("all", "every element of a list", " ")
    subscription = vocabulary.heard(filled.get("node", "")).get(
        filled.get("trigger", "").strip("'")
    )
    if subscription is None or subscription.type is None:
        return
    found = catalog.find(subscription.type, InterfaceKind.MESSAGE)
    fields = () if found is None else found.fields
    is_list = last in ("any", "all")
    for each in _received(fields, expected.prefix, catalog):
        if each.field.type.is_array is is_list or each.field.type.message is not None:
            yield each.candidate


class Part:
    """A field of what is received, by its whole path."""

    def __init__(self, path: str, field: Field) -> None:
        self.path = path
        self.field = field
        is_whole = field.type.message is not None and not field.type.is_array
        self.candidate = Candidate(path, str(field.type), "." if is_whole else "")


def _received(fields: Sequence[Field], prefix: str, catalog: Catalog) -> Iterator[Part]:
    """Yield the fields that go on from what is written."""
    _, *parents, _ = prefix.split(".") if prefix.startswith(_RECEIVED) else ("", "")
    inner: Sequence[Field] = fields
    if parents:
        inner = _fields_in(_field(tuple(fields), ".".join(parents), catalog), catalog) or ()
    start = "".join(f"{parent}." for parent in parents)
    for field in inner:
        yield Part(f"{_RECEIVED}{start}{field.name}", field)


def all_received(fields: Sequence[Field], catalog: Catalog) -> Iterator[Part]:
    """Yield the fields of what is received, each before those that are in it, the header last."""

    def within(prefix: str) -> Iterator[Part]:
        for part in sorted(_received(fields, prefix, catalog), key=_is_header):
            yield part
            if part.candidate.after and part.path.count(".") < _DEEPEST:
                yield from within(f"{part.path}.")

    yield from within("")


def _is_header(part: Part) -> bool:
    return part.field.type.package == "std_msgs" and part.field.type.name == "Header"


def fitting(
    type_: FieldType, parameters: Mapping[str, Parameter], heard: Sequence[Field], catalog: Catalog
) -> Iterator[Candidate]:
    """Offer the parameters, and the parts of what is received, that a field can be as they are.

    What holds the same kind of values comes before what can be turned into it.

    Args:
        type_: the type of the field.
        parameters: those of the node, by the names that programs write.
        heard: the fields of what is received then.
        catalog: the types.
    """
    version = catalog.ros_version
    for name, each in parameters.items():
        if each.holds is not None and fits(type_, each, version):
            yield Candidate(f"parameter '{name}'", each.holds.value)
    kind = what_of(type_, version).kind

    def is_turned(part: Part) -> bool:
        return what_of(part.field.type, version).kind != kind

    for part in sorted(all_received(heard, catalog), key=is_turned):
        given = part.field.type
        if fits(type_, given, version):
            yield Candidate(part.path, str(given))
        elif given.is_array and fits(type_, given.element, version):
            yield Candidate(f"{part.path}[0]", f"the first of {given}")


def _heard_fields(
    expected: Expectation, vocabulary: Vocabulary, catalog: Catalog
) -> Iterator[Field]:
    """Yield the fields of all that what is written may be received with."""
    slot, filled = expected.slot, expected.filled
    found: list[object] = []
    if slot is not None and slot.kind is SlotKind.ANSWER:
        found = [resolver(catalog).resolve(filled.get("type", ""), InterfaceKind.SERVICE)]
    elif "variable" in filled:
        types = vocabulary.heard_with(filled["variable"])
        found = [catalog.find(type_, InterfaceKind.MESSAGE) for type_ in types]
    yield from fields_of(found)


def fields_of(found: Iterable[object]) -> Iterable[Field]:
    """Return the fields of all types among what was found, one of each name."""
    fields = [field for each in found if isinstance(each, Interface) for field in each.fields]
    return {field.name: field for field in fields}.values()


def values(expected: Expectation, vocabulary: Vocabulary, catalog: Catalog) -> Iterator[Candidate]:
    """Offer names of fields, and what can be a value."""
    place = expected.values
    if place is None or place.is_text:
        return
    written = expected.written
    if written and written[-1] == "parameter":
        yield from _parameters(_all_parameters(expected, vocabulary), written)
        return
    is_operand = _is_operand(written)
    if written and written[-1] not in _BEFORE_VALUE and not is_operand:
        return
    heard = list(_heard_fields(expected, vocabulary, catalog))
    if expected.prefix.startswith(_RECEIVED):
        yield from (each.candidate for each in _received(heard, expected.prefix, catalog))
        return
    if is_operand:
        if heard:
            yield Candidate("received", "what arrives", ".")
            yield from _parameters(_all_parameters(expected, vocabulary), written)
        return
    fields = _fields_at(place, _own_fields(expected, catalog), catalog)
    if fields is None:
        return
    yield from _of_fields(place, fields, expected.prefix, catalog)
    # Where a name may come, few want anything else.
    is_value = place.name is not None or place.is_list or expected.prefix
    if is_value and "." not in expected.prefix:
        yield from _parameters(_all_parameters(expected, vocabulary), written)
        if heard:
            yield Candidate("received", "what arrives", ".")


def _is_operand(written: Sequence[str]) -> bool:
    """Tell whether something that is calculated with comes next."""
    *_, before, last = ("", "", *written)
    is_origin = before.startswith(_RECEIVED) or before[:1] == "'" or before == "]"
    return last in ARITHMETIC and (is_origin or before.replace(".", "").isdigit())


def _all_parameters(expected: Expectation, vocabulary: Vocabulary) -> Iterable[str]:
    """Return the parameters of the node; where none is named, as with a message, of all nodes."""
    return vocabulary.parameters(expected.filled.get("node"))


def _own_fields(expected: Expectation, catalog: Catalog) -> tuple[Field, ...] | None:
    """Return the fields that get the values, None where the type is not known."""
    if expected.declaration is None or expected.slot is None:
        return None
    kinds = (INTERFACES.get(slot.kind) for slot in expected.declaration.slots)
    kind = next((each for each in kinds if each is not None), InterfaceKind.MESSAGE)
    found = resolver(catalog).resolve(expected.filled.get("type", ""), kind)
    if not isinstance(found, Interface):
        return None
    return found.response.fields if expected.slot.kind is SlotKind.ANSWER else found.fields


def _fields_at(
    place: ValuePlace, fields: tuple[Field, ...] | None, catalog: Catalog
) -> tuple[Field, ...] | None:
    """Return the fields of the message within the message that a place is in."""
    is_array = False
    for key in place.path:
        if is_array and isinstance(key, int):
            # An element of the array, which has the fields that are known already.
            is_array = False
            continue
        field = _field(fields, key, catalog)
        is_array = field is not None and field.type.is_array
        fields = _fields_in(field, catalog)
    return fields


def _of_fields(
    place: ValuePlace, fields: tuple[Field, ...], prefix: str, catalog: Catalog
) -> Iterator[Candidate]:
    if place.name is not None or place.is_list:
        field = _field(fields, place.name, catalog) if place.name is not None else None
        if field is not None and field.type.name == "bool":
            yield from _TRUTH
        return
    *parents, _ = prefix.split(".")
    if parents:
        fields = _fields_in(_field(fields, ".".join(parents), catalog), catalog) or ()
    elif not place.used and [field.type.name for field in fields[place.index :][:1]] == ["bool"]:
        yield from _TRUTH
    start = "".join(f"{parent}." for parent in parents)
    for field in fields:
        if start + field.name not in place.used:
            yield Candidate(f"{start}{field.name}", str(field.type), "=")


def _field(
    fields: tuple[Field, ...] | None, key: str | int | None, catalog: Catalog
) -> Field | None:
    if fields is None or key is None:
        return None
    if isinstance(key, int):
        return fields[key] if key < len(fields) else None
    found: Field | None = None
    for name in key.split("."):
        found = next((field for field in fields or () if field.name == name), None)
        fields = _fields_in(found, catalog)
    return found


def _fields_in(field: Field | None, catalog: Catalog) -> tuple[Field, ...] | None:
    message = field.type.message if field is not None else None
    found = catalog.find(message, InterfaceKind.MESSAGE) if message is not None else None
    return found.fields if found is not None else None
