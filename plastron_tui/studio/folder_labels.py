"""How the studio names folders and what was not saved in them."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from pathlib import Path

from plastron_tui.diagnostics.terminal import visible

from .journal import Kept

_WIDTH = 60
_MOST_NAMED = 3


def shown_folder(folder: Path, width: int = _WIDTH) -> str:
    """Return a folder as a person reads it: from the home folder on; of a long one the end."""
    with suppress(ValueError, RuntimeError):
        folder = Path("~") / folder.relative_to(Path.home())
    text = visible(str(folder))
    return text if len(text) <= width else f"…{text[1 - width :]}"


def shown_name(kept: Kept) -> str:
    """Return what a program that was not saved is called."""
    return "a new program" if kept.path is None else visible(kept.path.name)


def shown_place(kept: Kept) -> str:
    """Return where a program that was not saved is, or was begun; "" where that is not known."""
    if kept.path is not None:
        return f"in {shown_folder(kept.path.parent)}"
    return "" if kept.folder is None else f"begun in {shown_folder(kept.folder)}"


def not_saved(kept: Sequence[Kept]) -> str:
    """Return lines that name what was not saved, and where."""
    lines = [f"{shown_name(each)} {shown_place(each)}".rstrip() for each in kept[:_MOST_NAMED]]
    if len(kept) > _MOST_NAMED:
        lines.append(f"… and {len(kept) - _MOST_NAMED} more")
    return "\n".join(["not saved when the studio ended:", *lines])
