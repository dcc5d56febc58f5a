"""Keys that somebody wants for actions: which of them count, and what is said of the others."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import NamedTuple

from .key_display import key_name
from .key_names import Arrival, another_key, arrival, arrives_as, read_keys, shown_keys, types_text

EVERYWHERE = "everywhere"
"""The place of what the main screen does, whatever has the focus."""
EDITOR = "editor"
FIND = "find"
"""The line in the editor that asks what to find; it takes text as the editor does."""
_OF_TEXT = frozenset({EVERYWHERE, EDITOR, FIND})
"""Where a letter is written, and starts nothing."""


@dataclass(frozen=True, slots=True)
class KeyOwner:
    """Something that has keys, or that keys can be given to.

    Attributes:
        id: its name in the configuration file; "" where that cannot give it others.
        title: what it is called.
        places: what has to have the focus: the editor, its line that finds, a panel by its name, or
            `EVERYWHERE`.
        keys: its keys from the start, in Textual's notation.
    """

    id: str
    title: str
    places: frozenset[str]
    keys: tuple[str, ...]

    @property
    def name(self) -> str:
        """Return what it is called in a message."""
        return f"`{self.id}`" if self.id else f"\u201c{self.title}\u201d"


class Wish(NamedTuple):
    """The keys that somebody wants for an action, as written, and the line where that is."""

    action: str
    texts: tuple[str, ...]
    line: int


class Said(NamedTuple):
    """What is to be said of a line of the configuration file."""

    line: int
    words: str


@dataclass(slots=True)
class Bound:
    """The keys that actions other than the default ones have.

    Attributes:
        keys: keys by the id of an action, by commas; "" for an action that lost its last one.
        problems: what is said of the wishes.
    """

    keys: dict[str, str] = field(default_factory=dict)
    problems: list[Said] = field(default_factory=list)


def bind(wishes: Sequence[Wish], owners: Sequence[KeyOwner]) -> Bound:
    """Give keys to actions as wished, where they are keys; a wish goes before what is built in."""
    by_id = _by_id(owners)
    bound = Bound()
    given: dict[str, tuple[str, ...]] = {}
    lines = {wish.action: wish.line for wish in wishes}
    for wish in wishes:
        owner = by_id[wish.action]
        wanted, said = _readable(owner, wish, _taken(owners, given))
        for key in list(wanted):
            rivals = [by_id[each] for each, has in given.items() if key in has]
            rival = next((each for each in rivals if each.places & owner.places), None)
            if rival is not None:
                wanted.remove(key)
                line = lines[rival.id]
                said.append(f"`{key_name(key)}` is the key of {rival.name} in line {line} already")
        bound.problems += [Said(wish.line, words) for words in said]
        if wanted:
            given[wish.action] = tuple(wanted)
    bound.keys = {action: ",".join(keys) for action, keys in given.items()}
    others = [*by_id.values(), *(owner for owner in owners if not owner.id)]
    for action, keys in given.items():
        for words in dict.fromkeys(_effects(by_id[action], keys, others, given, bound.keys)):
            bound.problems.append(Said(lines[action], words))
    bound.problems.sort(key=lambda said: said.line)
    return bound


def _by_id(owners: Sequence[KeyOwner]) -> dict[str, KeyOwner]:
    """Return who can be given keys; several panels can have the same, each with keys of its own."""
    found: dict[str, KeyOwner] = {}
    for owner in owners:
        if not owner.id:
            continue
        other = found.get(owner.id)
        if other is not None:
            keys = tuple(dict.fromkeys((*other.keys, *owner.keys)))
            owner = KeyOwner(owner.id, owner.title, owner.places | other.places, keys)
        found[owner.id] = owner
    return found


def _taken(owners: Sequence[KeyOwner], given: Mapping[str, Sequence[str]]) -> set[str]:
    return {key for owner in owners for key in (*owner.keys, *given.get(owner.id, ()))}


def _readable(owner: KeyOwner, wish: Wish, taken: set[str]) -> tuple[list[str], list[str]]:
    """Return the keys of a wish that can be had, and what is said of the others."""
    written = read_keys(wish.texts)
    keys: list[str] = []
    said = [f"{problem} (for `{owner.id}`)" for problem in written.problems]
    come = [key for key in written.keys if arrival(key) is Arrival.ALWAYS]
    for key in written.keys:
        how = arrival(key)
        shown, instead = key_name(key), f"`{key_name(another_key(key, taken))}` comes through"
        if how is Arrival.AS_ANOTHER:
            said.append(f"`{shown}` reaches the studio as {arrives_as(key)}; {instead}")
        elif owner.places & _OF_TEXT and types_text(key):
            said.append(f"`{shown}` writes into the text; {instead}")
        else:
            keys.append(key)
            if how is Arrival.NEVER and not come:
                said.append(f"no terminal sends `{shown}`; {instead}")
            elif how is Arrival.SOMETIMES and not come:
                said.append(f"few terminals send `{shown}`; {instead}")
    return keys, said


def _effects(
    owner: KeyOwner,
    keys: Sequence[str],
    owners: Sequence[KeyOwner],
    given: Mapping[str, tuple[str, ...]],
    bound: dict[str, str],
) -> Iterator[str]:
    """Take keys from those that had them, and say so; say where a key does something else."""
    for other in owners:
        if other.id == owner.id:
            continue
        has = given.get(other.id, other.keys)
        both = [key for key in keys if key in has]
        if not both:
            continue
        words = shown_keys(both)
        if other.places & owner.places:
            left = [key for key in has if key not in both]
            if other.id:
                before = bound.get(other.id)
                left = left if before is None else [k for k in before.split(",") if k in left]
                bound[other.id] = ",".join(left)
            now = f"has {shown_keys(left)} left" if left else "has no key now"
            yield f"{words} was the key of {other.name}, which {now}"
        elif EVERYWHERE in owner.places:
            news = [key for key in both if not _is_in_two_places(key, other, owners)]
            if news:
                yield f"{shown_keys(news)} stays the key of {other.name} {_while_in(other)}"
        elif EVERYWHERE in other.places:
            yield f"{words} is the key of {other.name} too, which it is not {_while_in(owner)}"


def _is_in_two_places(key: str, owner: KeyOwner, owners: Sequence[KeyOwner]) -> bool:
    """Tell whether a key of an owner does something else outside of its place from the start."""
    return key in owner.keys and any(
        key in each.keys and EVERYWHERE in each.places for each in owners
    )


def _while_in(owner: KeyOwner) -> str:
    if EDITOR in owner.places:
        return "in the editor"
    if FIND in owner.places:
        return "in the line that finds"
    names = sorted(owner.places)
    return f"in the panel {names[0]}" if len(names) == 1 else "in panels"
