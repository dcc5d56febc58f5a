"""What is known of a program when something is said about a word of it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from plastron_tui.diagnostics import Diagnostic
from plastron_tui.language import Program
from plastron_tui.model.workspace import Workspace
from plastron_tui.targets import ros_version

from ..editor.vocabulary import Vocabulary

if TYPE_CHECKING:
    from plastron_tui.model.workspace import Node
    from plastron_tui.ros.catalog import Catalog
    from plastron_tui.session import Session


@dataclass(frozen=True)
class Known:
    """A text, and what it meant when it was last understood.

    Attributes:
        session: has the text as it is, and the types of a distribution.
        program: the statements.
        workspace: what they build.
        diagnostics: what is wrong with the text as it is; none where that is not known.
    """

    session: Session
    program: Program
    workspace: Workspace
    diagnostics: tuple[Diagnostic, ...] = ()

    def library_of(self, node: Node) -> str:
        """Return the client library that a node is written for."""
        made = (
            each.library
            for each in self.workspace.generations
            if each.node.variable == node.variable
        )
        return node.library or next(made, None) or self.session.library

    def catalog(self, variable: str = "") -> Catalog:
        """Return the types that a node may use, with those of the program's own."""
        vocabulary = Vocabulary(self.program, self.workspace)
        library = vocabulary.library(variable) or self.session.library
        return vocabulary.with_own_types(self.session.catalog(ros_version(library)))
