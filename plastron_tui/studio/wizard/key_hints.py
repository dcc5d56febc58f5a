"""The keys of a page, drawn as in the studio's line of keys."""

from __future__ import annotations

from textual.content import Content

_GAP = "  "
"""What stands between two keys."""


def drawn_keys(words: str) -> Content:
    """Return keys with their colours.

    Args:
        words: `Enter next  ↑↓ choice`: keys are written large, or with arrows, and come before
            the small words that say what they do.
    """
    parts: list[str | tuple[str, str]] = []
    for number, each in enumerate(words.split(_GAP)):
        said = each.split(" ")
        end = next((at for at, word in enumerate(said) if word[:1].islower()), len(said))
        keys, does = " ".join(said[:end]), " ".join(said[end:])
        parts.append(_GAP if number else "")
        parts.append((keys, "bold $text-accent"))
        parts.append(f" {does[:1].upper()}{does[1:]}" if does else "")
    return Content.assemble(*(part for part in parts if part))
