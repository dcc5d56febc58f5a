"""The lines of an edit, and where they go."""

from __future__ import annotations

import re
from dataclasses import dataclass, field

from plastron_tui.diagnostics import Diagnostic
from plastron_tui.model.source import EndpointKind, SourceEndpoint

from .analysis import Analysis
from .conventions import Conventions
from .function_place import FunctionPlace
from .splices import Splice

# What is around docstrings.
_SINGLE, _DOUBLE = b"'''", b'"""'
_WORD = re.compile(r"\w+")

Key = tuple[EndpointKind, str | None, str, str]


def key_of(endpoint: SourceEndpoint) -> Key:
    """Return what makes two endpoints of a node equal."""
    name = endpoint.name if endpoint.name is not None else endpoint.expression
    return (endpoint.kind, name, str(endpoint.type), endpoint.callback or "")


@dataclass(slots=True)
class Writer:
    """Collects the splices of one change, in the file's line endings and indents.

    Attributes:
        endpoints: what a reader must find in addition, once the splices are applied.
        names: the names that the change brings into the file.
        words: all words of what is inserted.
        has_imports: whether imports are among the splices.
        notes: what is to be told of the change.
    """

    analysis: Analysis
    conventions: Conventions
    splices: list[Splice] = field(default_factory=list)
    endpoints: list[Key] = field(default_factory=list)
    names: set[str] = field(default_factory=set)
    words: set[str] = field(default_factory=set)
    has_imports: bool = False
    notes: list[Diagnostic] = field(default_factory=list)

    def lines(self, offset: int, indent: str, lines: list[str]) -> None:
        """Insert lines at the start of a line; a tab in front of one is a level of indent."""
        newline = self.conventions.newline
        text = self.analysis.syntax.text
        written = "".join(self._indented(indent, line) + newline for line in lines)
        self.words.update(_WORD.findall(written))
        if offset == len(text) and text and not text.endswith(b"\n"):
            written = newline + written[: -len(newline)]
        self.splices.append(Splice(offset, offset, self.analysis.syntax.encode(written)))

    def function(self, place: FunctionPlace, lines: list[str]) -> None:
        """Insert a function with the blank lines around it."""
        text = self.analysis.syntax.text
        if text.count(_SINGLE) > text.count(_DOUBLE):
            lines = [line.replace(_DOUBLE.decode(), _SINGLE.decode()) for line in lines]
        above = [""] * place.before + [place.ruler] * bool(place.ruler)
        self.lines(place.offset, place.indent, [*above, *lines, *[""] * place.after])

    def _indented(self, indent: str, line: str) -> str:
        body = line.lstrip("\t")
        levels = len(line) - len(body)
        return indent + self.conventions.indent * levels + body if body else ""
