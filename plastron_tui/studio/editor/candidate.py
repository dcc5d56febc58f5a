"""Something that completion offers."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Candidate:
    """Something that completion offers.

    `text` is what is written, `after` what follows it where the line ends there, `detail` what is
    said beside it.
    """

    text: str
    detail: str = ""
    after: str = ""
