"""What the command line sets for a program."""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple


class Options(NamedTuple):
    """What the command line sets; what it leaves open the project file or the environment says.

    Attributes:
        target: the client library of a node that names none.
        output: the output folder.
        in_place: whether a loaded node is written over the file that it came from.
        force: whether a created node is written anew where its file was changed by hand.
        distribution: the distribution whose types count, for nodes of its generation of ROS.
        is_writing: whether files are to be written: what is not trusted is then an error.
        tells_absent: whether a type is told of whose package the ROS of this machine lacks.
    """

    target: str | None = None
    output: Path | None = None
    in_place: bool = False
    force: bool = False
    distribution: str | None = None
    is_writing: bool = False
    tells_absent: bool = False
