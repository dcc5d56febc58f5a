"""From the call sites of a file to its nodes."""

from __future__ import annotations

import re
from pathlib import Path

from plastron_tui.diagnostics import Code, Diagnostic, codes
from plastron_tui.model.source import FileSet, SourceUnit
from plastron_tui.sources.base import ReadResult
from plastron_tui.sources.not_text import not_utf_8

from .calls import LIBRARIES, ClientLibrary
from .nodes import group
from .reading_cost import MOST_CLASSES, comment_run
from .shared_analysis import analyze, package_names
from .syntax import parse

MOST_BYTES = 4_000_000
"""Beyond this size a file is data, not a node that a person wrote."""

_IMPORT = re.compile(rb"\b(?:import|from)\b")
_ROSPY_ONLY = rb"^[ \t]*(import|from)[ \t]+(message_filters|actionlib)\b"
# Part of a node whose class another file brings together may not import the library.
_CREATION = re.compile(rb"\.create_(lifecycle_)?(publisher|subscription|service|client)\s*\(")


def read_python(path: Path, files: FileSet, library: str | None = None) -> ReadResult:
    """Read the nodes of a Python file, the main one of a set.

    Without a `library` the imports of the file decide. A file that uses no client library is
    a diagnostic, not an exception.
    """
    text = files.main
    if len(text) > MOST_BYTES:
        return _refuse(path, codes.FILE_TOO_LARGE, "the file is larger than 4 MB and is not read")
    if b"\x00" in text and (found := not_utf_8(text, path)) is not None:
        return ReadResult(None, (found,))
    candidates = [LIBRARIES[library]] if library in LIBRARIES else _imported(text)
    is_guess = not candidates and _CREATION.search(text) is not None
    if not candidates and not is_guess:
        return _refuse(path, codes.NO_NODE, "the file imports neither rospy nor rclpy")
    long_run = comment_run(text)
    if long_run is not None:
        problem = f"the comments from line {long_run} on are too many to be read"
        return _refuse(path, codes.FILE_TOO_LARGE, problem)
    if _has_too_many_classes(text):
        problem = f"the file has more than {MOST_CLASSES} classes, and is not read"
        return _refuse(path, codes.FILE_TOO_LARGE, problem)
    analyses = [
        analyze(text, candidate, package_names(path, candidate))
        for candidate in candidates or [LIBRARIES["rclpy"]]
    ]
    if is_guess and all(site.endpoint.type is None for site in analyses[0].sites):
        return _refuse(path, codes.NO_NODE, "the file imports neither rospy nor rclpy")
    best = max(analyses, key=lambda analysis: (len(analysis.sites), len(analysis.nodes)))
    source = SourceUnit(path, files, best.library.module, group(best))
    return ReadResult(source, beside=() if best.package is None else best.package.paths)


def _has_too_many_classes(text: bytes) -> bool:
    # Where the word is not as often in the text, the tree need not be asked.
    return (
        text.count(b"class") > MOST_CLASSES
        and len(parse(text).captures("structure").get("class", [])) > MOST_CLASSES
    )


def _refuse(path: Path, code: Code, message: str) -> ReadResult:
    return ReadResult(None, (Diagnostic(code, message, file=path),))


def _imported(text: bytes) -> list[ClientLibrary]:
    """Return the client libraries that a file imports."""
    found = [library for name, library in LIBRARIES.items() if _imports(text, name.encode())]
    if not found and re.search(rb"^[ \t]*from[ \t]+[\w.]+[ \t]+import[ \t]+\*", text, re.M):
        # A module of one's own may bring the library along.
        found = [
            library
            for name, library in LIBRARIES.items()
            if re.search(rb"^[^#\n]*\b" + name.encode() + rb"\.\w", text, re.M)
        ]
    if not found and re.search(_ROSPY_ONLY, text, re.M):
        found = [LIBRARIES["rospy"]]
    return found


def _imports(text: bytes, name: bytes) -> bool:
    """Tell whether a line imports a module, or from it; what follows a `#` does not count."""
    if name not in text:
        return False
    word = re.compile(rb"\b" + name + rb"\b")
    for line in text.split(b"\n"):
        if name in line:
            code = line.partition(b"#")[0]
            start = _IMPORT.search(code)
            # One search after the other takes no more than the line's length.
            if start is not None and word.search(code, start.end()):
                return True
    return False
