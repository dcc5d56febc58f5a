"""What is said about a code."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Code:
    """A kind of mistake: its stable name, what it means, and how it is made and mended.

    `bad` and `good` are programs, so that a test can run them: `bad` gives exactly this code,
    `good` gives nothing. A mistake that no program shows (a file that cannot be read, say) has
    neither, and says in `summary` what to do.
    """

    name: str
    summary: str
    bad: str = ""
    good: str = ""
