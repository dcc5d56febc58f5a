"""What the `.clang-format` around a file says of its layout.

Source: the page "Clang-Format Style Options" of clang's documentation.
"""

from __future__ import annotations

import re
from contextlib import suppress
from pathlib import Path
from typing import NamedTuple

from plastron_tui.regular_files import read_regular

_NAMES = (".clang-format", "_clang-format")
_MOST_ABOVE = 6
_LARGEST = 64 * 1024
_OPTION = re.compile(r"^(\w+):[ \t]*['\"]?(\w+)", re.MULTILINE)
_BROKEN = frozenset({"Allman", "GNU", "Linux", "Mozilla", "Stroustrup", "WebKit", "Whitesmiths"})
_NO_LIMIT = 120


class ClangFormat(NamedTuple):
    """Settings; what none says is None.

    Attributes:
        width: the longest line.
        indent: one level of indent.
        is_broken: whether the brace of a function has a line of its own.
        reference: how `const T & x` is written.
        continuation: what a line that goes on with another begins with, behind its indent.
        is_aligned: whether arguments that do not fit stand below the first.
    """

    width: int | None = None
    indent: str | None = None
    is_broken: bool | None = None
    reference: str | None = None
    continuation: str | None = None
    is_aligned: bool | None = None


_BASED = {
    "Google": ClangFormat(80, "  ", False, "& ", "    ", True),
    "LLVM": ClangFormat(80, "  ", False, " &", "    ", True),
    "Chromium": ClangFormat(80, "  ", False, "& ", "    ", True),
    "Mozilla": ClangFormat(80, "  ", True, "& ", "  ", True),
    "WebKit": ClangFormat(_NO_LIMIT, "    ", True, "& ", "    ", False),
    "Microsoft": ClangFormat(120, "    ", True, " &", "    ", True),
}


def clang_format_of(path: Path) -> ClangFormat:
    """Return the settings that are nearest above a file; none where it has none.

    What a project says outside of its repository is not looked for.
    """
    for folder in list(path.absolute().parents)[:_MOST_ABOVE]:
        for name in _NAMES:
            with suppress(OSError, ValueError):
                return parse_clang_format(read_regular(folder / name, _LARGEST))
        if (folder / ".git").exists():
            break
    return ClangFormat()


def parse_clang_format(text: bytes) -> ClangFormat:
    """Return what a file of settings says for C++; what it says for other languages is left."""
    parts = re.split(r"^---[ \t]*$", text.decode("utf-8", "replace"), flags=re.MULTILINE)
    said: dict[str, str] = {}
    for part in parts:
        options = dict(_OPTION.findall(part))
        if options.get("Language", "Cpp") == "Cpp":
            said.update(options)
    found = _BASED.get(said.get("BasedOnStyle", ""), ClangFormat())
    if (limit := said.get("ColumnLimit", "")).isdigit():
        found = found._replace(width=int(limit) or _NO_LIMIT)
    if (width := said.get("IndentWidth", "")).isdigit():
        found = found._replace(indent=" " * min(int(width), 8))
    if said.get("UseTab", "Never") in ("Always", "ForIndentation", "true"):
        found = found._replace(indent="\t")
    if "BreakBeforeBraces" in said and said["BreakBeforeBraces"] != "Custom":
        found = found._replace(is_broken=said["BreakBeforeBraces"] in _BROKEN)
    if (width := said.get("ContinuationIndentWidth", "")).isdigit():
        found = found._replace(continuation=" " * min(int(width), 16))
    if "AlignAfterOpenBracket" in said:
        found = found._replace(is_aligned=said["AlignAfterOpenBracket"] in ("Align", "true"))
    aligned = {"Left": "& ", "Right": " &", "Middle": " & "}
    if said.get("PointerAlignment") in aligned:
        found = found._replace(reference=aligned[said["PointerAlignment"]])
    return found
