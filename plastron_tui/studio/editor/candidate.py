"""Something that completion offers."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, TypeAlias

if TYPE_CHECKING:
    from plastron_tui.language.expectations import Expectation

    from .vocabulary import Vocabulary


@dataclass(frozen=True, slots=True)
class Candidate:
    """Something that completion offers.

    `text` is what is written, `after` what follows it where the line ends there, `detail` what is
    said beside it, `swatch` the colour that it stands for, as `#3060ff`.
    """

    text: str
    detail: str = ""
    after: str = ""
    swatch: str = ""


Offer: TypeAlias = "Callable[[Expectation, Vocabulary], Iterator[Candidate]]"
"""Yields what may fill a slot at a place."""
