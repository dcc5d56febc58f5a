"""What replaces the parts of an endpoint that differ, while all else about it stays."""

from __future__ import annotations

from dataclasses import dataclass, field

from tree_sitter import Node

from plastron_tui.model.source import Update
from plastron_tui.ros.catalog import Catalog

from ..analysis import Analysis, Site
from ..scopes import CppFile
from .clang_format import ClangFormat
from .plans import Plan


class NotInPlaceError(Exception):
    """An endpoint that has to be taken out and written anew."""


class OtherCodeError(NotInPlaceError):
    """A callback that cannot do with messages of another type.

    Attributes:
        lack: what that type has not of what it uses, "" for nothing that is known.
    """

    def __init__(self, lack: str = "") -> None:
        super().__init__()
        self.lack = lack


@dataclass(slots=True)
class Replacement:
    """A change of one call site on its way.

    Attributes:
        analysis: what is known of the files.
        site: the call site.
        change: what is asked for.
        catalog: the interface types.
        plan: what it does.
        settings: what the settings around the files say of their layout.
        old: the name that the endpoint had before, for what is told.
    """

    analysis: Analysis
    site: Site
    change: Update
    catalog: Catalog
    plan: Plan
    settings: ClangFormat = field(default_factory=ClangFormat)
    old: str = ""
    _put: set[tuple[str, int]] = field(default_factory=set)

    def put(self, file: CppFile, node: Node, text: str) -> None:
        """Write something else for a node."""
        self.put_between(file, node.start_byte, node.end_byte, text)

    def put_between(self, file: CppFile, start: int, end: int, text: str) -> None:
        """Write something else between two offsets, once.

        Raises:
            NotInPlaceError: the file is another node's.
        """
        if file.is_beside:
            raise NotInPlaceError
        is_same = file.syntax.between(start, end) == text
        if not is_same and (file.name, start) not in self._put:
            self._put.add((file.name, start))
            self.plan.replace(file, start, end, text)
