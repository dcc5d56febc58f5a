"""Find an interface type by its name, or by what it is for."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from weakref import WeakKeyDictionary

from plastron_tui.diagnostics.suggest import nearest

from .catalog import Catalog
from .catalog.data import purposes
from .interfaces import Field, Interface, InterfaceKind, InterfaceName

_WORD = re.compile(r"[a-z]+|[0-9]+")
_PART = re.compile(r"[A-Z]+(?![a-z])|[A-Z]?[a-z]+|[0-9]+")
# Words that say nothing about a type.
_FILLERS = frozenset(
    (
        *("a", "an", "the", "of", "to", "in", "on", "for", "and", "or", "is", "it", "its", "my"),
        *("with", "by", "from", "at", "as", "be", "this", "that", "some", "any"),
    )
)
_SUFFIXES = ("Action", "ActionFeedback", "ActionGoal", "ActionResult", "Feedback", "Goal", "Result")
# What definitions say in the place of a description.
_NO_DESCRIPTION = re.compile(
    r"originally provided as an example|deprecated|todo|^see\b|please look|^time/frame",
    re.IGNORECASE,
)
_LONGEST_LINE = 100
_COMMON = 60
"""So many of the described types count more than the rest, the first the most."""


@dataclass(frozen=True, slots=True)
class FoundType:
    """A type that a search found.

    Attributes:
        name: its full name.
        written: the shortest way in which a program names it: without the package where no other
            package has a type of the name.
        line: one line about it, for people; not empty.
        fields: the names and types of its fields; of a service those of the request, of an
            action those of the goal.
        answer: of a service the names and types of the response, of an action those of the
            result; empty for a message.
    """

    name: InterfaceName
    written: str
    line: str
    fields: tuple[tuple[str, str], ...]
    answer: tuple[tuple[str, str], ...] = ()

    @property
    def package(self) -> str:
        """The package that it comes from."""
        return self.name.package


@dataclass(frozen=True, slots=True)
class _Entry:
    """A type and the words that lead to it, each with how much it counts."""

    found: FoundType
    name: str
    full_name: str
    weights: Mapping[str, int]
    place: tuple[int, str]


@cache
def _known(kind: InterfaceKind) -> Mapping[InterfaceName, tuple[int, str, str]]:
    """Return of each type that is described: its place, its line, the words that lead to it."""
    known = {}
    for place, (full_name, text) in enumerate(purposes()[kind.value].items()):
        line, _, words = text.partition(" | ")
        known[InterfaceName(*full_name.split("/"))] = (place, line, words)
    return known


_ENTRIES: WeakKeyDictionary[Catalog, dict[InterfaceKind, Sequence[_Entry]]] = WeakKeyDictionary()


def search_types(
    catalog: Catalog, kind: InterfaceKind, query: str, *, is_lenient: bool = True
) -> list[FoundType]:
    """Return the types that a query may mean, the best first.

    Every word of the query has to lead to a type: as the start of a word of its name, of what
    it is for, of a field's name. An empty query leads to all of them, the most common first.

    Args:
        catalog: the types of a distribution; the first search reads all of them.
        kind: messages, services or actions.
        query: a name, a part of one, or words of purpose, such as `distance` or `on/off`.
        is_lenient: where nothing is found, look for what most of the words lead to, and for the
            nearest known words.
    """
    entries = _entries(catalog, kind)
    name = query.strip().lower().replace(f"/{kind.value}/", "/")
    words = _words(query)
    scored = _ranked(entries, name, words)
    if not scored and is_lenient and words:
        vocabulary = sorted({word for entry in entries for word in entry.weights})
        near = [nearest(word, vocabulary) or word for word in words]
        scored = _ranked(entries, name, near) or _ranked(entries, name, near, least=1)
    return [entry.found for entry in scored]


def _words(text: str) -> list[str]:
    words = list(dict.fromkeys(_WORD.findall(text.lower())))
    # `on` is a filler, unless it is all there is.
    return [word for word in words if word not in _FILLERS] or words


def _ranked(
    entries: Sequence[_Entry], name: str, words: Sequence[str], least: int | None = None
) -> list[_Entry]:
    """Return the entries that enough of the words lead to, the best first."""
    needed = len(words) if least is None else least
    scored = []
    for entry in entries:
        scores = [_score(entry.weights, word) for word in words]
        by_name = _name_score(entry, name)
        if by_name or sum(score > 0 for score in scores) >= needed:
            common = max(0, _COMMON - entry.place[0])
            scored.append((-by_name - sum(scores) - common, entry.place, entry))
    scored.sort(key=lambda each: each[:2])
    return [entry for _, _, entry in scored]


def _name_score(entry: _Entry, name: str) -> int:
    if not name:
        return 0
    if name in (entry.name, entry.full_name):
        return 1000
    is_start = entry.full_name.startswith(name) or entry.name.startswith(name)
    return 10 if is_start or (len(name) > 2 and name in entry.full_name) else 0


def _score(weights: Mapping[str, int], word: str) -> int:
    """Return how much a word leads to a type: 0 for not at all."""
    exact = weights.get(word, 0) or (weights.get(word[:-1], 0) if word[-1:] == "s" else 0)
    if exact:
        return 2 * exact
    return max((weight for known, weight in weights.items() if known.startswith(word)), default=0)


def _entries(catalog: Catalog, kind: InterfaceKind) -> Sequence[_Entry]:
    by_kind = _ENTRIES.setdefault(catalog, {})
    if kind not in by_kind:
        actions = frozenset(catalog.names(InterfaceKind.ACTION))
        by_kind[kind] = [
            _entry(catalog, interface, actions)
            for interface in (catalog.find(name, kind) for name in catalog.names(kind))
            if interface is not None
        ]
    return by_kind[kind]


def _entry(catalog: Catalog, interface: Interface, actions: frozenset[InterfaceName]) -> _Entry:
    name, kind = interface.name, interface.kind
    place, line, purpose = _known(kind).get(name, (len(_known(kind)), "", ""))
    is_alone = len(catalog.candidates(name.name, kind)) == 1
    answer = () if kind is InterfaceKind.MESSAGE else interface.response.fields
    found = FoundType(
        name,
        name.name if is_alone else str(name),
        line or _line(interface, actions),
        _pairs(interface.fields),
        _pairs(answer),
    )
    weights: dict[str, int] = {}
    for weight, words in (
        (5, name.package.split("_")),
        (10, [field.name.lower() for field in (*interface.fields, *answer)]),
        (25, purpose.split()),
        (35 if line else 15, _WORD.findall(found.line.lower())),
        (40, [part.lower() for part in _PART.findall(name.name)]),
    ):
        weights.update((word, weight) for word in words if word not in ("msgs", "srvs"))
    # Of the words of purpose, the first are the nearest.
    for place_of_word, word in enumerate(purpose.split()[:8]):
        weights[word] = max(weights[word], 34 - place_of_word)
    return _Entry(found, name.name.lower(), str(name).lower(), weights, (place, str(name)))


def _pairs(fields: Sequence[Field]) -> tuple[tuple[str, str], ...]:
    return tuple((field.name, str(field.type)) for field in fields)


def _line(interface: Interface, actions: frozenset[InterfaceName]) -> str:
    """Make a line about a type of which nobody wrote what it is for."""
    for action in _stems(interface.name):
        if action in actions:
            return f"A part of the action {action.name}"
    comment = interface.comment.strip()
    if comment and not _NO_DESCRIPTION.search(comment):
        return comment if len(comment) <= _LONGEST_LINE else comment[: _LONGEST_LINE - 1] + "…"
    names = [field.name for field in interface.fields]
    if not names:
        return "Nothing but the call itself" if len(interface.sections) > 1 else "Nothing within"
    return f"Holds {', '.join(names[:6])}{' and more' if len(names) > 6 else ''}"


def _stems(name: InterfaceName) -> Iterator[InterfaceName]:
    for suffix in _SUFFIXES:
        if name.name.endswith(suffix):
            yield InterfaceName(name.package, name.name.removesuffix(suffix))
