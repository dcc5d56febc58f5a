"""Writing a statement: its sentence, with texts in its slots."""

from __future__ import annotations

from collections.abc import Mapping

from .declaration import Clause, Declaration, Element, Slot, SlotKind

NOTHING = "\0none"
"""What stands for the word `none` in the place of a name, which may be that word as well."""


def sentence(declaration: Declaration, texts: Mapping[str, str]) -> str:
    """Return a statement in one line, as it is declared; `texts` has what is in its slots.

    Names and paths are given without their quotes. A clause is left out when nothing is in its
    slots.
    """
    words: list[str] = []

    def put(element: Element) -> None:
        match element:
            case Slot(name=name, kind=kind):
                words.append(_quoted(kind, texts.get(name, "")))
            case Clause(elements=parts, slots=slots):
                if all(texts.get(slot.name) for slot in slots):
                    for part in parts:
                        put(part)
            case word:
                words.append(word)

    for element in declaration.elements:
        put(element)
    return " ".join(words)


def _quoted(kind: SlotKind, text: str) -> str:
    if text == NOTHING:
        return "none"
    if kind.is_quoted or (kind is SlotKind.FILE and not is_module(text)):
        return f"'{text}'"
    return text


def quoted(text: str) -> str:
    """Return a text as a program writes it."""
    escapes = {'"': '\\"', "\\": "\\\\", "\n": "\\n", "\t": "\\t"}
    return '"' + "".join(escapes.get(char) or _plain(char) for char in text) + '"'


def _plain(character: str) -> str:
    if character.isprintable() or character == " ":
        return character
    units = character.encode("utf-16-be", "surrogatepass").hex()
    return "".join(f"\\u{units[at : at + 4]}" for at in range(0, len(units), 4))


def is_module(text: str) -> bool:
    """Tell whether a file is named without quotes: by a bare name."""
    from .keywords import KEYWORDS

    return text.isidentifier() and text.isascii() and text not in KEYWORDS
