"""Words that take back, and the nearest word of the language that takes back as much."""

from __future__ import annotations

from collections.abc import Iterable

from plastron_tui.diagnostics.suggest import nearest

UNDOING_PARTS = frozenset(
    {"no", "not", "non", "never", "nothing", "longer", "without", "lacks", "lack", "un"}
    | {"stop", "stops", "stopped", "remove", "removes", "delete", "deletes", "drop", "drops"}
    | {"kill", "kills", "destroy", "destroys", "exclude", "excludes", "unset", "clear", "close"}
    | {"dont", "don", "doesnt", "isnt", "hasnt", "havent", "cannot", "except", "unless", "had"}
)
"""Parts of words, in lower case, that say that something is no more, or is not."""

_LIKE_UNDOING = ("under", "until", "unit", "uniq", "univ")
"""What begins with `un` and takes nothing back."""

_OTHER_UNITS = {"hz": ("khz", "mhz", "ghz")}
"""What is near to a word and a thousandfold of it."""

_LEAST_LETTERS = 3
"""Letters of a word that is taken for a word two letters longer, or more."""


def is_undoing(word: str) -> bool:
    """Tell whether a word takes back, or says that something is not: `has_no_link`, `unload`."""
    parts = word.lower().split("_")
    return not UNDOING_PARTS.isdisjoint(parts) or any(
        part.startswith("un") and not part.startswith(_LIKE_UNDOING) for part in parts
    )


def nearest_keyword(word: str, names: Iterable[str]) -> str | None:
    """Return the word of the language closest to one, None where none is or it turns the meaning.

    For what takes back only what takes back is meant, and for other words nothing that does. The
    beginning of a word is meant for no other word, and that of several words for none of them.
    """
    names = tuple(names)
    if begun := [name for name in names if name.startswith(word)]:
        shortest = min(begun, key=len)
        return shortest if all(name.startswith(shortest) for name in begun) else None
    undoes = is_undoing(word)
    names = tuple(
        name
        for name in names
        if is_undoing(name) == undoes
        and word.lower() not in _OTHER_UNITS.get(name, ())
        and (len(word) >= _LEAST_LETTERS or len(name) <= len(word) + 1)
    )
    found = nearest(word, names)
    if found is None:
        return None
    # The last part tells most: `drop_robot` is not `drop_type`, nor `generate_all` a launch file.
    (head, _, last), (written, _, end) = found.rpartition("_"), word.rpartition("_")
    is_same_but_last = bool(head) and head == written
    return found if not (undoes or is_same_but_last) or nearest(end, [last]) else None
