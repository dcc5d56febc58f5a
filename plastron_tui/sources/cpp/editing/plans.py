"""What one change does to the files of a unit."""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field

from plastron_tui.diagnostics import Diagnostic
from plastron_tui.model.source import FileSet
from plastron_tui.sources.splices import Splice, apply, line_number

from ..analysis import Site
from ..scopes import CppFile
from .refusals import RefusedError
from .units import Key

_LITERAL = re.compile(r'"(?:[^"\\\n]|\\.)*"')
_WIDE = re.compile(r"[^\x00-\x7f]")


@dataclass(slots=True)
class Plan:
    """What a change does.

    Attributes:
        splices: what it replaces, by the name of the file in the set; "" is the main file.
        lost: the call sites that go, or become others.
        added: the endpoints that a reader must find in addition.
        notes: what is to be told of it.
    """

    splices: defaultdict[str, list[Splice]] = field(default_factory=lambda: defaultdict(list))
    lost: list[Site] = field(default_factory=list)
    added: list[tuple[str, Key]] = field(default_factory=list)
    notes: list[Diagnostic] = field(default_factory=list)

    def replace(self, file: CppFile, start: int, end: int, text: str = "") -> None:
        """Replace a part of a file.

        Raises:
            RefusedError: the file is one of another node, which is only looked into.
        """
        if file.is_beside:
            line = line_number(file.syntax.text, start)
            message = f"line {line} of `{file.name}`, a file of another node, has a part of it"
            raise RefusedError(message, None, "change that file first")
        encoded = _in_utf8(file, text).encode(file.syntax.encoding)
        self.splices[file.name].append(Splice(start, end, encoded))


def _in_utf8(file: CppFile, text: str) -> str:
    """Return a text whose new strings are UTF-8, as messages are, in a file of another encoding.

    The bytes of a string are those of the file; others are written as octal escapes.
    """
    encoding, before = file.syntax.encoding, file.syntax.text
    if encoding == "utf-8" or text.isascii():
        return text

    def escaped(found: re.Match[str]) -> str:
        is_copied = found[0].encode(encoding, "replace") in before
        return found[0] if is_copied else _WIDE.sub(_octal, found[0])

    return _LITERAL.sub(escaped, text)


def _octal(found: re.Match[str]) -> str:
    return "".join(f"\\{byte:03o}" for byte in found[0].encode())


def with_splices(files: FileSet, splices: Mapping[str, Iterable[Splice]]) -> FileSet:
    """Return a set of files with splices applied.

    Raises:
        RefusedError: one is for a file that is not of the set.
    """
    for name, each in splices.items():
        own = name or files.names[0]
        text = files.get(own)
        if text is None:
            message = f"`{name}`, a file of another node, has a part of it"
            raise RefusedError(message, None, "change that file first")
        files = files.with_text(own, apply(text, each))
    return files
