"""What a program is interpreted in: client libraries, interface types, files to load."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, NamedTuple

from plastron_tui.diagnostics import Diagnostic
from plastron_tui.ros.catalog import Catalog

from .libraries import Libraries

if TYPE_CHECKING:
    from .source import SourceUnit
    from .workspace import Generation


class LoadRequest(NamedTuple):
    """What a `load` asks for: a file by its bare name, or by a path from the program's folder.

    `generated` is what the program has asked to generate so far: a program may load what it
    generates.
    """

    source: str
    is_path: bool
    generated: tuple[Generation, ...]


class Loaded(NamedTuple):
    """What a reader made of a request.

    `source` is None when it could not read the file; `right` is then what a program writes to
    load the file that may be meant.
    """

    source: SourceUnit | None
    diagnostics: tuple[Diagnostic, ...] = ()
    right: str | None = None


Reader = Callable[[LoadRequest], Loaded]


class Setting(NamedTuple):
    """What a program is interpreted in.

    Attributes:
        library: the client library of a node that names none.
        libraries: the client libraries that there are.
        catalog: gives the interface types for a generation of ROS.
        read: reads the files that the program loads.
        is_chosen: whether somebody chose `library`; otherwise it is what there is on this machine.
    """

    library: str
    libraries: Libraries
    catalog: Callable[[int], Catalog]
    read: Reader
    is_chosen: bool = True

    def ros_version(self, library: str | None) -> int:
        """Return the generation of ROS of a client library; of the program's for one unknown."""
        if library is None or library not in self.libraries:
            library = self.library
        return self.libraries[library].ros_version
