"""The pages of the wizard, and what they show."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum, auto
from typing import NamedTuple

from plastron_tui.session import Session

from .extra import Extra
from .filling import Filled, filled_of
from .form import Form
from .program_trial import Finding, Outcome


class PageKind(Enum):
    """What is asked on a page."""

    START = auto()
    PURPOSE = auto()
    AWAY = auto()
    RECIPES = auto()
    FORM = auto()
    REVIEW = auto()


@dataclass(frozen=True, slots=True)
class Page:
    """A page; `form` is the form that it shows."""

    kind: PageKind
    form: Form | None = None


@dataclass(frozen=True, slots=True)
class Look:
    """All that follows from what was entered so far.

    Attributes:
        filled: the forms that are on the way, filled.
        outcome: the program with their statements; None where nothing is asked for yet.
        problems: what is wrong, what the slots know first.
        node: the variable of the node that it is about.
        robot: the variable of the robot that it is about.
        part: the link or the joint that it is about.
        can_generate: whether the node could be generated along with it.
        extras: what else can follow.
        before: the program without what is wanted, but with what that is wanted of.
        driving: the numbers of the lines that drive whatever arrives, and can give way.
    """

    filled: tuple[Filled, ...] = ()
    outcome: Outcome | None = None
    problems: tuple[Finding, ...] = ()
    node: str | None = None
    can_generate: bool = False
    extras: tuple[Extra, ...] = ()
    robot: str | None = None
    part: str = ""
    before: Session | None = None
    driving: tuple[int, ...] = ()

    def of(self, form: Form) -> Filled | None:
        """Return a form as it is filled."""
        return filled_of(form, self.filled)


class Heard(NamedTuple):
    """A topic that a node listens to."""

    node: str
    topic: str
