"""Every code that a diagnostic can have.

The list is the source of `docs/diagnostics.md`. An example of a mistake is a whole program,
so that a test can run it: `bad` gives exactly this code, `good` gives nothing.
"""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Code:
    """A kind of mistake: its stable name, what it means, and how it is made and mended.

    `bad` and `good` are programs; a mistake that no program shows (a file that cannot be
    read, say) has neither, and says in `summary` what to do.
    """

    name: str
    summary: str
    bad: str = ""
    good: str = ""


CODES: dict[str, Code] = {}
