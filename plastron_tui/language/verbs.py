"""Words that stand where a verb is to stand, and the verbs that they are like."""

from __future__ import annotations

from .keywords import VERBS
from .undoing import nearest_keyword

_BEGINNINGS = ("no_longer_has_", "has_")
_ENDING_VERBS = ("no_longer_", "stop_")
_REMOVING = frozenset({"remove", "delete", "drop", "clear", "unset"})
_ENDING = _REMOVING | {"not", "no", "longer", "stop"}
_SAYING_NOTHING = frozenset({"has", "have", "add", "set", "new", "create", "make", "with", "to"})


def nearest_verb(word: str) -> str | None:
    """Return the verb that a word is a slip of the pen for, None where it is none.

    What is `has_wheel` is not `has_field`: where the beginning is right, it says nothing.
    """
    for beginning in _BEGINNINGS:
        if word.startswith(beginning):
            ends = [each.removeprefix(beginning) for each in VERBS if each.startswith(beginning)]
            end = nearest_keyword(word.removeprefix(beginning), ends)
            return None if end is None else beginning + end
    found = nearest_keyword(word, VERBS)
    if found is None or (_is_ending(word) and not found.startswith(_ENDING_VERBS)):
        return None
    return found


def _is_ending(word: str) -> bool:
    return not _ENDING.isdisjoint(word.split("_"))


def kindred_verbs(word: str) -> tuple[str, ...]:
    """Return the verbs that speak of what a word of several parts speaks of: `remove_link`.

    Where none does, they are those that begin as it does: `has_camera`, `remove`.
    """
    parts = word.split("_")
    about = {each.removesuffix("s") for each in parts} - _ENDING - _SAYING_NOTHING
    found = [
        verb
        for verb in VERBS
        if len(parts) > 1
        and about & {each.removesuffix("s") for each in verb.split("_")}
        and _is_ending(word) == verb.startswith(_ENDING_VERBS)
    ]
    beginning = "no_longer_" if parts[0] in _REMOVING else f"{parts[0]}_"
    return tuple(found or [each for each in VERBS if each.startswith(beginning)])
