"""What completion offers: names of a program, types of a distribution, words of the language."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import chain, islice
from pathlib import PurePath
from typing import TYPE_CHECKING, NamedTuple

from plastron_tui.language import SlotKind
from plastron_tui.language.expectations import Expectation
from plastron_tui.language.keywords import BY_KEYWORD
from plastron_tui.language.statements import Subscribe
from plastron_tui.model.kinds import INTERFACES
from plastron_tui.model.packages import BUILT_FOLDER
from plastron_tui.model.rename import RENAMED
from plastron_tui.ros.common_types import most_common_first, types_for
from plastron_tui.ros.interfaces import Interface, InterfaceKind, InterfaceName
from plastron_tui.ros.parameters import ParameterType
from plastron_tui.ros.qos_agreement import words_to_hear
from plastron_tui.ros.qos_words import offered_words
from plastron_tui.ros.robots.names import FILE_ENDINGS
from plastron_tui.session import Session
from plastron_tui.targets import LIBRARIES, languages, ros_version

from ..folder_files import found_files, path_text
from .candidate import Candidate
from .packaging_completion import OFFERS
from .value_completion import conditions, default_values, rates, resolver, values
from .vocabulary import Vocabulary

if TYPE_CHECKING:
    from plastron_tui.model.libraries import ClientLibrary
    from plastron_tui.ros.catalog import Catalog

MOST_OFFERED = 200
_MOST_FIELDS = 12
_MOST_BY_PURPOSE = 20
_LEAST_PURPOSE = 4
"""Letters from which on a type is looked for by what it is for."""

_MEETINGS = {
    SlotKind.TOPIC: (InterfaceKind.MESSAGE, "message_type"),
    SlotKind.SERVICE: (InterfaceKind.SERVICE, "service_type"),
    SlotKind.ACTION: (InterfaceKind.ACTION, "action_type"),
}
"""What meets by a name, and the word before its type."""

_MET = ("topic", "service", "action")
"""The slots that have such a name."""


def candidates(expected: Expectation, vocabulary: Vocabulary, session: Session) -> list[Candidate]:
    """Return what may stand at a place, what fits its prefix best first."""
    prefix = expected.prefix.lstrip("'\"")
    found = _offered(expected, vocabulary, session)
    meant: Sequence[_Meant] = ()
    # Names of types begin with a capital: a small word may be one of purpose.
    if prefix.islower() and prefix.isalpha():
        meant = _for_purpose(expected, vocabulary, session)
    ranked = _ranked(found, prefix, meant) if prefix else found
    return list(islice(ranked, MOST_OFFERED))


class _Meant(NamedTuple):
    """A type that serves a purpose, and whether all of its word is written."""

    candidate: Candidate
    is_whole: bool


def _for_purpose(
    expected: Expectation, vocabulary: Vocabulary, session: Session
) -> Sequence[_Meant]:
    """Return the types that are for what was typed, such as `speed`, as their lines have it."""
    kind = None if expected.slot is None else INTERFACES.get(expected.slot.kind)
    if kind is None:
        return ()
    catalog = _catalog(expected, vocabulary, session)
    found = types_for(expected.prefix, catalog.names(kind), kind)[:_MOST_BY_PURPOSE]
    return [
        _Meant(Candidate(_written(each.name, catalog, kind), each.line), each.is_whole)
        for each in found
    ]


def _ranked(
    found: Iterable[Candidate], prefix: str, meant: Sequence[_Meant]
) -> Iterator[Candidate]:
    """Yield what fits a prefix: what is called so, is meant for it, begins so, or has it within."""
    folded = prefix.lower()
    same: list[Candidate] = []
    ranks: tuple[list[Candidate], ...] = ([], [], [])
    for candidate in found:
        text = candidate.text.lstrip("'")
        lower = text.lower()
        if lower.rpartition("/")[2] == folded:
            same.append(candidate)
        elif text.startswith(prefix):
            ranks[0].append(candidate)
        elif lower.startswith(folded) or f"/{folded}" in lower:
            ranks[1].append(candidate)
        elif folded in lower:
            ranks[2].append(candidate)
    whole = [each.candidate for each in meant if each.is_whole]
    begun = [each.candidate for each in meant if not each.is_whole]
    seen: set[str] = set()
    for candidate in chain(same, whole, ranks[0], ranks[1], begun, ranks[2]):
        if candidate.text not in seen:
            seen.add(candidate.text)
            yield candidate


def _written(name: InterfaceName, catalog: Catalog, kind: InterfaceKind) -> str:
    """Return the shortest way in which a program names a type."""
    return name.name if catalog.candidates(name.name, kind) == (name,) else str(name)


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


def _offered(
    expected: Expectation, vocabulary: Vocabulary, session: Session
) -> Iterator[Candidate]:
    slot = expected.slot
    if slot is not None:
        yield from _of_slot(slot.kind, expected, vocabulary, session)
    for word in _fitting_first(expected, vocabulary, session):
        declaration = BY_KEYWORD.get(word)
        yield Candidate(word, declaration.summary if declaration is not None else "")


def _fitting_first(
    expected: Expectation, vocabulary: Vocabulary, session: Session
) -> Sequence[str]:
    """Return the words of the language, behind a variable those that go with it."""
    text, start = session.document.text, expected.span.start
    before = text[text.rfind(b"\n", 0, start) + 1 : start].strip()
    kind = vocabulary.kind_of(before.decode("utf-8", "replace")) if before else None
    if kind is None or expected.declaration is not None:
        return expected.keywords
    return [word for word in expected.keywords if _is_about(word, kind)] or expected.keywords


def _is_about(word: str, kind: SlotKind) -> bool:
    declaration = BY_KEYWORD.get(word)
    return declaration is not None and declaration.slots[0].kind is kind


def _of_slot(
    kind: SlotKind, expected: Expectation, vocabulary: Vocabulary, session: Session
) -> Iterator[Candidate]:
    match kind:
        case SlotKind.NODE:
            yield from (Candidate(*entry) for entry in vocabulary.nodes.items())
        case SlotKind.MESSAGE:
            yield from (Candidate(*entry) for entry in vocabulary.messages.items())
        case _ if kind in OFFERS:
            yield from OFFERS[kind](expected, vocabulary)
        case _ if kind.makes and kind.is_variable:
            yield from _variable(expected, vocabulary)
        case SlotKind.TOPIC | SlotKind.SERVICE | SlotKind.ACTION:
            yield from _graph_names(kind, expected, vocabulary, session)
        case SlotKind.TRIGGER:
            heard = vocabulary.heard(_node_of(expected))
            yield from (
                Candidate(f"'{name}'", str(each.type or "")) for name, each in heard.items()
            )
        case SlotKind.PARAMETER:
            yield from (
                Candidate(f"'{name.removeprefix('~/')}'") for name in _ended(expected, vocabulary)
            )
        case SlotKind.TIMER:
            yield from (Candidate(name) for name in _ended(expected, vocabulary))
        case SlotKind.MESSAGE_TYPE | SlotKind.SERVICE_TYPE | SlotKind.ACTION_TYPE:
            yield from _types(expected, vocabulary, session, INTERFACES[kind])
        case SlotKind.PARAMETER_TYPE:
            yield from (Candidate(each.value, "", " with default ") for each in ParameterType)
        case SlotKind.DEFAULT:
            yield from default_values(expected)
        case SlotKind.RATE:
            yield from rates(expected, vocabulary)
        case SlotKind.QOS:
            yield from _qos_words(expected, vocabulary, session)
        case SlotKind.NAMED:
            yield from (Candidate(word) for word in vocabulary.renamable(_node_of(expected)))
        case SlotKind.OLD_NAME:
            names = vocabulary.named(_node_of(expected), expected.filled.get("what", ""))
            yield from (Candidate(f"'{name}'", "", " to") for name in names)
        case SlotKind.NEW_NAME:
            yield from _other_names(expected, vocabulary)
        case SlotKind.LIBRARY:
            yield from (Candidate(each.name, _library(each)) for each in LIBRARIES.values())
        case SlotKind.FILE:
            yield from _files(session)
        case SlotKind.ROBOT_FILE:
            folder = session.folder
            found = found_files(FILE_ENDINGS, folder, levels=1)
            yield from (Candidate(f"'{path_text(path, folder)}'") for path in found)
        case SlotKind.INPUT | SlotKind.ANSWER:
            yield from values(expected, vocabulary, _catalog(expected, vocabulary, session))
        case SlotKind.CONDITION:
            yield from conditions(expected, vocabulary, _catalog(expected, vocabulary, session))


def _variable(expected: Expectation, vocabulary: Vocabulary) -> Iterator[Candidate]:
    """Offer a node's own name as its variable."""
    name = expected.filled.get("name") or expected.filled.get("source") or ""
    name = PurePath(name.strip("'")).name.partition(".")[0]
    taken = any(name in each for each in vocabulary.variables)
    if name.isidentifier() and name[0].isalpha() and not taken:
        yield Candidate(name)


def _ended(expected: Expectation, vocabulary: Vocabulary) -> list[str]:
    """Return what a statement that takes something away from a node may name."""
    keyword = expected.declaration.keyword if expected.declaration is not None else ""
    return list(vocabulary.endpoints(_node_of(expected), keyword))


def _graph_names(
    kind: SlotKind, expected: Expectation, vocabulary: Vocabulary, session: Session
) -> Iterator[Candidate]:
    interface, word = _MEETINGS[kind]
    names = vocabulary.meetings(interface)
    used = _ended(expected, vocabulary)
    if used:
        yield from (Candidate(f"'{name}'", names.get(name, "")) for name in used)
        return
    declaration = expected.declaration
    wants_type = declaration is not None and word in declaration.elements
    message = vocabulary.messages.get(expected.filled.get("message", ""))
    # Those of the type that the message has come first.
    for name, type_ in sorted(names.items(), key=lambda entry: entry[1] != message):
        after = f" of {word} {type_}" if wants_type and type_ else ""
        if after and declaration is not None and declaration.type is Subscribe:
            after += _qos_to_hear(name, expected, vocabulary, session)
        yield Candidate(f"'{name}'", type_, after)


def _qos_to_hear(name: str, expected: Expectation, vocabulary: Vocabulary, session: Session) -> str:
    """Return the clause without which a subscription hears no publisher of a topic."""
    library = vocabulary.library(_node_of(expected)) or session.library
    words = words_to_hear(vocabulary.offered(name)) if ros_version(library) == 2 else ""
    return f" with qos {words}" if words else ""


def _qos_words(
    expected: Expectation, vocabulary: Vocabulary, session: Session
) -> Iterator[Candidate]:
    """Offer the words of quality of service that go with those that are there."""
    written = expected.written
    if written and written[-1] != ",":
        return
    catalog = _catalog(expected, vocabulary, session)
    found = resolver(catalog).resolve(expected.filled.get("type", ""), InterfaceKind.MESSAGE)
    type_ = found.name if isinstance(found, Interface) else None
    for word in offered_words(written, catalog.ros_version, type_):
        yield Candidate(word.word, word.summary, " " if word.number else "")


def _node_of(expected: Expectation) -> str:
    """Return the variable of the node that a statement is about, as far as it is written."""
    return expected.filled.get("node", "")


def _other_names(expected: Expectation, vocabulary: Vocabulary) -> Iterator[Candidate]:
    """Offer the names at which others may be met, but for those that the node has itself."""
    what = expected.filled.get("what", "")
    interface = next((kind.facts.interface for kind in RENAMED.get(what, ())), None)
    known = vocabulary.meetings(interface)
    own = vocabulary.named(_node_of(expected), what)
    yield from (Candidate(f"'{name}'", type_) for name, type_ in known.items() if name not in own)


def _catalog(expected: Expectation, vocabulary: Vocabulary, session: Session) -> Catalog:
    library = vocabulary.library(_node_of(expected)) or session.library
    return vocabulary.with_own_types(session.catalog(ros_version(library)))


def _types(
    expected: Expectation, vocabulary: Vocabulary, session: Session, kind: InterfaceKind
) -> Iterator[Candidate]:
    catalog = _catalog(expected, vocabulary, session)
    filled = expected.filled
    name = next((filled[word] for word in _MET if word in filled), "")
    first = vocabulary.meetings(kind).get(name.strip("'")) or vocabulary.messages.get(
        filled.get("message", "")
    )
    fields = described_type(first, kind, catalog) if first else ""
    if first and fields:
        yield Candidate(first, fields)
    # Those of the program's own come before the hundreds of the distribution.
    own = [each for each in vocabulary.types if each != first and _is_of(each, kind, catalog)]
    yield from (Candidate(each, vocabulary.types[each]) for each in own)
    qualified = "/" in expected.prefix
    for each in most_common_first(catalog.names(kind), kind):
        text = str(each) if qualified else _written(each, catalog, kind)
        if text != first and text not in own:
            yield Candidate(text, "")


def _is_of(text: str, kind: InterfaceKind, catalog: Catalog) -> bool:
    return isinstance(resolver(catalog).resolve(text, kind), Interface)


def described_type(text: str, kind: InterfaceKind, catalog: Catalog) -> str:
    """Return the fields of a type, for what is shown beside it; empty for one that is unknown."""
    found = resolver(catalog).resolve(text, kind)
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
    catalog = _catalog(expected, vocabulary, session)
    said = described_type(candidate.text, kind, catalog)
    absent, found = session.setting.absent, resolver(catalog).resolve(candidate.text, kind)
    if absent is None or not isinstance(found, Interface):
        return said
    is_here = absent(catalog.ros_version, found.name.package) is None
    return said if is_here else f"not installed here; {said}"


def _library(library: ClientLibrary) -> str:
    """Return what a client library is for, in a few words."""
    what = library.purpose.partition(":")[0].partition(",")[0]
    return ", ".join(filter(None, (f"{library.language}, ROS {library.ros_version}", what)))


def _files(session: Session) -> Iterator[Candidate]:
    """Offer the node files of the output folder and of the program's folder."""
    suffixes = {suffix for each in languages() for suffix in each.suffixes}
    seen: set[str] = set()
    for folder in (session.output, session.output / BUILT_FOLDER, session.folder):
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
