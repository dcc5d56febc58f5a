"""What stands before each line that a run prints, and what a line of the run itself says."""

from __future__ import annotations

import re
from typing import NamedTuple

OWN_NAME = "plastron"
"""What the run itself is called, where nodes have their names."""
SIGN = " | "
"""What stands between a name, with blanks behind it, and what was printed."""

_END = re.compile(
    rf"{OWN_NAME} *\| (?P<node>\S+) (?P<how>(?:was ended by|died with|never started).*|finished)",
    re.DOTALL,
)


class Ended(NamedTuple):
    """What a line of a run says of a node that has ended though nobody asked it to.

    Attributes:
        node: what its lines are labelled with.
        how: in words: `finished`, `was ended by SIGKILL`, …
    """

    node: str
    how: str

    @property
    def is_failure(self) -> bool:
        """Whether it ended badly."""
        return self.how != "finished"


def ended_node(line: str) -> Ended | None:
    """Return which node a line of `plastron run` says to have ended, and how (see `Console`)."""
    found = _END.fullmatch(line)
    return None if found is None else Ended(found["node"], found["how"])


def split_label(line: str) -> tuple[str, str]:
    """Return the label of a line with the sign behind it, "" where it has none, and the rest.

    A name has no blank in it, but what a build prints as a table has.
    """
    name, sign, rest = line.partition(SIGN)
    if not sign or " " in name.rstrip():
        return "", line
    return name + sign, rest


def is_own(line: str) -> bool:
    """Tell whether the run itself says something: how a node has ended, say."""
    label, _ = split_label(line)
    return label.removesuffix(SIGN).rstrip() == OWN_NAME
