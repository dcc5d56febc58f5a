"""What an XML file means, as Expat reads it, or why it is not well-formed."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import NamedTuple
from xml.parsers import expat

from plastron_tui.diagnostics import Diagnostic, Span, codes

from .broken import why_broken

DEEPEST = 200
"""The most elements within each other."""

MOST_BYTES = 4 * 1024**2
"""The most bytes of a file."""


@dataclass(slots=True)
class Outlined:
    """An element as Expat tells it.

    Attributes:
        start: where its `<` is.
        parent: its place in the list of all elements, None for the root.
        pieces: the characters before its first child, between its children, and so on.
    """

    name: str
    start: int
    parent: int | None
    attributes: tuple[tuple[str, str], ...]
    pieces: list[list[str]] = field(default_factory=lambda: [[]])


class Outline(NamedTuple):
    """The elements of a file in the order of their starts, and what stands between them."""

    elements: tuple[Outlined, ...]
    comments: tuple[Span, ...]
    instructions: tuple[Span, ...]


class OutlineResult(NamedTuple):
    """An outline, or why there is none."""

    outline: Outline | None
    diagnostics: tuple[Diagnostic, ...] = ()


class _UnsupportedError(Exception):
    """What Plastron does not read."""

    def __init__(self, diagnostic: Diagnostic) -> None:
        self.diagnostic = diagnostic


def read_outline(text: bytes, file: Path | None) -> OutlineResult:
    """Read an XML file with Expat.

    Args:
        text: what the file holds.
        file: the file, for diagnostics.
    """
    if len(text) > MOST_BYTES:
        message = f"the file is larger than {MOST_BYTES // 1024**2} MB"
        return OutlineResult(None, (Diagnostic(codes.FILE_TOO_LARGE, message, file=file),))
    if text.startswith((b"\xff\xfe", b"\xfe\xff")):
        return OutlineResult(None, (_unsupported("the file is not in UTF-8", None, file),))
    builder = _Builder(text, file)
    try:
        builder.parser.Parse(text, True)
    except _UnsupportedError as error:
        return OutlineResult(None, (error.diagnostic,))
    except expat.ExpatError as error:
        offset = max(builder.parser.ErrorByteIndex, 0)
        opened = [(element.name, element.start) for element in builder.open_elements]
        return OutlineResult(None, (why_broken(text, error.code, offset, opened, file),))
    except (LookupError, ValueError):
        # An encoding of a name that Python does not know, or one of several bytes a character.
        return OutlineResult(None, (_unsupported("the file is not in UTF-8", None, file),))
    outline = Outline(tuple(builder.elements), tuple(builder.comments), tuple(builder.instructions))
    return OutlineResult(outline)


def _unsupported(message: str, span: Span | None, file: Path | None) -> Diagnostic:
    return Diagnostic(codes.UNSUPPORTED_XML, message, span, file)


class _Builder:
    """Expat's handlers, and what they have heard."""

    def __init__(self, text: bytes, file: Path | None) -> None:
        self.text, self.file = text, file
        self.elements: list[Outlined] = []
        self.comments: list[Span] = []
        self.instructions: list[Span] = []
        self._open: list[int] = []
        self._is_ascii = text.isascii()
        # Names stay as they are written: there are launch files with undeclared prefixes.
        self.parser = parser = expat.ParserCreate()
        parser.ordered_attributes = True
        parser.buffer_text = True
        parser.XmlDeclHandler = self._declaration
        parser.StartDoctypeDeclHandler = self._doctype
        parser.StartElementHandler = self._start
        parser.EndElementHandler = self._end
        parser.CharacterDataHandler = self._characters
        parser.CommentHandler = self._between(self.comments, b"-->")
        parser.ProcessingInstructionHandler = self._between(self.instructions, b"?>")
        parser.SkippedEntityHandler = self._skipped

    @property
    def open_elements(self) -> list[Outlined]:
        """The elements that are not closed yet, the outermost first."""
        return [self.elements[at] for at in self._open]

    def _declaration(self, version: str, encoding: str | None, standalone: int) -> None:
        del version, standalone
        if encoding is None or encoding.lower() in ("utf-8", "utf8") or self._is_ascii:
            return
        found = self.text.find(encoding.encode("utf-8", "replace"))
        span = Span(found, found + len(encoding)) if found >= 0 else None
        raise _UnsupportedError(
            _unsupported(f"the file says that it is in {encoding}, not in UTF-8", span, self.file)
        )

    def _doctype(self, name: str, system: str | None, public: str | None, has_own: int) -> None:
        del name, system, public
        if has_own:
            start = self.text.find(b"<!DOCTYPE")
            span = Span(start, start + len(b"<!DOCTYPE")) if start >= 0 else None
            message = "the document type has declarations of its own, which are not read"
            raise _UnsupportedError(_unsupported(message, span, self.file))

    def _start(self, name: str, attributes: list[str]) -> None:
        start = self.parser.CurrentByteIndex
        if len(self._open) >= DEEPEST:
            message = f"more than {DEEPEST} elements are within each other"
            raise _UnsupportedError(_unsupported(message, Span(start, start + 1), self.file))
        parent = self._open[-1] if self._open else None
        if parent is not None:
            self.elements[parent].pieces.append([])
        self._open.append(len(self.elements))
        pairs = tuple(zip(attributes[::2], attributes[1::2], strict=True))
        self.elements.append(Outlined(name, start, parent, pairs))

    def _end(self, name: str) -> None:
        del name
        self._open.pop()

    def _characters(self, text: str) -> None:
        self.elements[self._open[-1]].pieces[-1].append(text)

    def _between(self, found: list[Span], end: bytes) -> Callable[..., None]:
        """Return the handler of what goes on until `end`."""

        def hear(*_: str) -> None:
            start = self.parser.CurrentByteIndex
            found.append(Span(start, self.text.index(end, start) + len(end)))

        return hear

    def _skipped(self, name: str, is_parameter: bool) -> None:
        del is_parameter
        message = f"`&{name};` is declared elsewhere, which is not read"
        raise _UnsupportedError(_unsupported(message, None, self.file))
