"""Where the parts of a loaded robot stand in its file."""

from __future__ import annotations

from collections.abc import Mapping
from functools import lru_cache
from typing import TYPE_CHECKING

from plastron_tui.diagnostics import LineIndex
from plastron_tui.sources.urdf.reader import read_urdf

from .entry import Subject

if TYPE_CHECKING:
    from plastron_tui.model.robots import RobotSource

Lines = Mapping[tuple[Subject, str], int]


def place_of(source: RobotSource, subject: Subject, name: str) -> str:
    """Return the file of a part, with its line where the file says the part outright."""
    file = source.path.name
    if source.origin is not None:
        # The file holds what the program wrote into it, which has other lines.
        return file
    line = _lines_of(source.text).get((subject, name))
    return file if line is None else f"{file}, line {line}"


@lru_cache(maxsize=4)
def _lines_of(text: bytes) -> Lines:
    """Return the lines on which the links and joints of a file begin."""
    places = read_urdf(text).places
    index = LineIndex(text)
    found = {(Subject.LINK, name): each for name, each in places.links.items()}
    found |= {(Subject.JOINT, name): each for name, each in places.joints.items()}
    return {key: index.position(each.span.start).line for key, each in found.items()}
