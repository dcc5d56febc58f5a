"""What completion offers: names of a program, types of a distribution, words of the language."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from itertools import islice
from pathlib import PurePath
from typing import TYPE_CHECKING

from plastron_tui.language import SlotKind
from plastron_tui.language.expectations import Expectation
from plastron_tui.language.keywords import BY_KEYWORD
from plastron_tui.model.kinds import INTERFACES
from plastron_tui.ros.interfaces import Field, InterfaceKind
from plastron_tui.session import Session
from plastron_tui.targets import LIBRARIES, languages, ros_version

from .vocabulary import Vocabulary

if TYPE_CHECKING:
    from plastron_tui.model.types import TypeResolver
    from plastron_tui.ros.catalog import Catalog

MOST_OFFERED = 200
_MOST_FIELDS = 12
_MOST_BY_PURPOSE = 20
_LEAST_PURPOSE = 4
"""Letters from which on a type is looked for by what it is for."""


@dataclass(frozen=True, slots=True)
class Candidate:
    """Something that completion offers.

    `text` is what is written, `after` what follows it where the line ends there, `detail` what is
    said beside it.
    """

    text: str
    detail: str = ""
    after: str = ""


def candidates(expected: Expectation, vocabulary: Vocabulary, session: Session) -> list[Candidate]:
    """Return what may stand at a place, what fits its prefix best first."""
    prefix = expected.prefix.lstrip("'\"")
    found = _ranked(_offered(expected, vocabulary, session), prefix)
    return list(islice(found, MOST_OFFERED))


def candidates_by_purpose(
    expected: Expectation, vocabulary: Vocabulary, session: Session
) -> list[Candidate]:
    """Return the types that are for what was typed, such as `veloc`, the best first.

    The first time it reads all types that there are: it is for when somebody asks.
    """
    kind = INTERFACES.get(expected.slot.kind) if expected.slot is not None else None
    if kind is None or len(expected.prefix) < _LEAST_PURPOSE:
        return []
    from plastron_tui.ros.search import search_types

    catalog = _catalog(expected, vocabulary, session)
    found = search_types(catalog, kind, expected.prefix, is_lenient=False)
    return [Candidate(each.written, each.line) for each in found[:_MOST_BY_PURPOSE]]


def _ranked(found: Iterable[Candidate], prefix: str) -> Iterator[Candidate]:
    if not prefix:
        yield from found
        return
    folded = prefix.lower()
    ranks: tuple[list[Candidate], ...] = ([], [], [])
    for candidate in found:
        text = candidate.text.lstrip("'")
        lower = text.lower()
        if text.startswith(prefix):
            ranks[0].append(candidate)
        elif lower.startswith(folded) or f"/{folded}" in lower:
            ranks[1].append(candidate)
        elif folded in lower:
            ranks[2].append(candidate)
    for rank in ranks:
        yield from rank


def _offered(
    expected: Expectation, vocabulary: Vocabulary, session: Session
) -> Iterator[Candidate]:
    slot = expected.slot
    if slot is not None:
        yield from _of_slot(slot.kind, expected, vocabulary, session)
    for word in expected.keywords:
        declaration = BY_KEYWORD.get(word)
        yield Candidate(word, declaration.summary if declaration is not None else "")


def _of_slot(
    kind: SlotKind, expected: Expectation, vocabulary: Vocabulary, session: Session
) -> Iterator[Candidate]:
    match kind:
        case SlotKind.NODE:
            yield from (Candidate(*entry) for entry in vocabulary.nodes.items())
        case SlotKind.MESSAGE:
            yield from (Candidate(*entry) for entry in vocabulary.messages.items())
        case SlotKind.NEW_NODE | SlotKind.NEW_MESSAGE:
            yield from _variable(expected, vocabulary)
        case SlotKind.TOPIC:
            yield from _graph_names(expected, vocabulary, vocabulary.topics, "message_type")
        case SlotKind.SERVICE:
            yield from _graph_names(expected, vocabulary, vocabulary.services, "service_type")
        case SlotKind.MESSAGE_TYPE | SlotKind.SERVICE_TYPE:
            yield from _types(expected, vocabulary, session, INTERFACES[kind])
        case SlotKind.NAMED:
            yield from (Candidate(word) for word in vocabulary.renamable(_node_of(expected)))
        case SlotKind.OLD_NAME:
            names = vocabulary.named(_node_of(expected), expected.filled.get("what", ""))
            yield from (Candidate(f"'{name}'", "", " to") for name in names)
        case SlotKind.NEW_NAME:
            yield from _other_names(expected, vocabulary)
        case SlotKind.LIBRARY:
            yield from (Candidate(name, f"ROS {ros_version(name)}") for name in LIBRARIES)
        case SlotKind.FILE:
            yield from _files(session)
        case SlotKind.INPUT:
            yield from _values(expected, vocabulary, session)


def _variable(expected: Expectation, vocabulary: Vocabulary) -> Iterator[Candidate]:
    """Offer a node's own name as its variable."""
    name = expected.filled.get("name") or expected.filled.get("source") or ""
    name = PurePath(name.strip("'")).stem
    taken = name in vocabulary.nodes or name in vocabulary.messages
    if name.isidentifier() and name[0].isalpha() and not taken:
        yield Candidate(name)


def _graph_names(
    expected: Expectation, vocabulary: Vocabulary, names: Mapping[str, str], word: str
) -> Iterator[Candidate]:
    declaration = expected.declaration
    keyword = declaration.keyword if declaration is not None else ""
    used = list(vocabulary.endpoints(expected.filled.get("node", ""), keyword))
    if used:
        yield from (Candidate(f"'{name}'", names.get(name, "")) for name in used)
        return
    wants_type = declaration is not None and word in declaration.elements
    message = vocabulary.messages.get(expected.filled.get("message", ""))
    # Those of the type that the message has come first.
    for name, type_ in sorted(names.items(), key=lambda entry: entry[1] != message):
        after = f" of {word} {type_}" if wants_type and type_ else ""
        yield Candidate(f"'{name}'", type_, after)


def _node_of(expected: Expectation) -> str:
    """Return the variable of the node that a statement is about, as far as it is written."""
    return expected.filled.get("node", "")


def _other_names(expected: Expectation, vocabulary: Vocabulary) -> Iterator[Candidate]:
    """Offer the names at which others may be met, but for those that the node has itself."""
    what = expected.filled.get("what", "")
    known = {"topic": vocabulary.topics, "service": vocabulary.services}.get(what, {})
    own = vocabulary.named(_node_of(expected), what)
    yield from (Candidate(f"'{name}'", type_) for name, type_ in known.items() if name not in own)


def _catalog(expected: Expectation, vocabulary: Vocabulary, session: Session) -> Catalog:
    library = vocabulary.library(expected.filled.get("node", "")) or session.library
    return session.catalog(ros_version(library))


def _types(
    expected: Expectation, vocabulary: Vocabulary, session: Session, kind: InterfaceKind
) -> Iterator[Candidate]:
    catalog = _catalog(expected, vocabulary, session)
    filled = expected.filled
    first = (
        vocabulary.topics.get(filled.get("topic", "").strip("'"))
        or vocabulary.services.get(filled.get("service", "").strip("'"))
        or vocabulary.messages.get(filled.get("message", ""))
    )
    fields = described_type(first, kind, catalog) if first else ""
    if first and fields:
        yield Candidate(first, fields)
    qualified = "/" in expected.prefix
    for name in catalog.names(kind):
        alone = not qualified and len(catalog.candidates(name.name, kind)) == 1
        text = name.name if alone and catalog.candidates(name.name, kind)[0] == name else str(name)
        if text != first:
            yield Candidate(text, "")


def _resolver(catalog: Catalog) -> TypeResolver:
    from plastron_tui.model.types import TypeResolver

    return TypeResolver(catalog)


def described_type(text: str, kind: InterfaceKind, catalog: Catalog) -> str:
    """Return the fields of a type, for what is shown beside it; empty for one that is unknown."""
    found = _resolver(catalog).resolve(text, kind)
    fields = getattr(found, "fields", None)
    if fields is None:
        return ""
    shown = ", ".join(f"{field.name}: {field.type}" for field in fields[:_MOST_FIELDS])
    more = ", …" if len(fields) > _MOST_FIELDS else ""
    return shown + more or "no fields"


def detail_of(
    candidate: Candidate, expected: Expectation, vocabulary: Vocabulary, session: Session
) -> str:
    """Return what is said beside a candidate; the fields of a type are looked up only when seen."""
    kind = INTERFACES.get(expected.slot.kind) if expected.slot is not None else None
    if candidate.detail or kind is None:
        return candidate.detail
    return described_type(candidate.text, kind, _catalog(expected, vocabulary, session))


def _files(session: Session) -> Iterator[Candidate]:
    """Offer the node files of the output folder and of the program's folder."""
    suffixes = {suffix for each in languages() for suffix in each.suffixes}
    seen: set[str] = set()
    for folder in (session.output, session.folder):
        try:
            found = (path for path in folder.iterdir() if path.suffix in suffixes)
            names = sorted(path.name for path in islice(found, MOST_OFFERED))
        except OSError:
            continue
        for name in names:
            stem = PurePath(name).stem
            if stem not in seen:
                seen.add(stem)
                text = stem if stem.isidentifier() and stem[0].isalpha() else f"'{name}'"
                yield Candidate(text, f"in {folder.name}")


def _values(expected: Expectation, vocabulary: Vocabulary, session: Session) -> Iterator[Candidate]:
    place, declaration = expected.values, expected.declaration
    if place is None or place.is_text or declaration is None:
        return
    catalog = _catalog(expected, vocabulary, session)
    is_message = SlotKind.MESSAGE_TYPE in (slot.kind for slot in declaration.slots)
    kind = InterfaceKind.MESSAGE if is_message else InterfaceKind.SERVICE
    found = _resolver(catalog).resolve(expected.filled.get("type", ""), kind)
    fields: tuple[Field, ...] | None = getattr(found, "fields", None)
    is_array = False
    for key in place.path:
        if is_array and isinstance(key, int):
            # An element of the array, which has the fields that are known already.
            is_array = False
            continue
        field = _field(fields, key, catalog)
        is_array = field is not None and field.type.is_array
        fields = _fields_in(field, catalog)
    if fields is None:
        return
    if place.name is not None or place.is_list:
        field = _field(fields, place.name, catalog) if place.name is not None else None
        if field is not None and field.type.name == "bool":
            yield from (Candidate("True"), Candidate("False"))
        return
    *parents, _ = expected.prefix.split(".")
    if parents:
        fields = _fields_in(_field(fields, ".".join(parents), catalog), catalog) or ()
    elif not place.used and [field.type.name for field in fields[place.index :][:1]] == ["bool"]:
        yield from (Candidate("True"), Candidate("False"))
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
