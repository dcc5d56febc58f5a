"""The files that a file with macros includes, looked at before anything is expanded."""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple

from plastron_tui.diagnostics import Diagnostic, codes
from plastron_tui.diagnostics.severity import Severity
from plastron_tui.regular_files import read_regular, reason
from plastron_tui.ros.robots.macros import Include
from plastron_tui.sources.xml.document import Element, XmlDocument, read_xml
from plastron_tui.sources.xml.outline import MOST_BYTES

from .macros import read_includes
from .reach import Reach

_MOST_FILES = 200
_MOST_INCLUDES = 2_000
_MOST_PROBLEMS = 20
_MOST_BYTES = 16_000_000
_PATTERN = frozenset("*?[")


class Included(NamedTuple):
    """What was found of the files that a file includes.

    Attributes:
        files: those that were looked at.
        diagnostics: what is in the way of expanding.
    """

    files: tuple[Path, ...]
    diagnostics: tuple[Diagnostic, ...] = ()


def check_includes(document: XmlDocument, path: Path, reach: Reach) -> Included:
    """Tell which includes cannot be followed, or lead too far, each where it stands.

    Those in macros and conditions may never be reached, and those whose path is computed are
    known only then: expanding judges them.

    Args:
        document: the file.
        path: where it is.
        reach: how far it may lead.
    """
    found: list[Diagnostic] = []
    seen: dict[Path, None] = {path.resolve(): None}
    waiting = [(document, path)]
    left, count = _MOST_BYTES, 0
    while waiting:
        inner, file = waiting.pop()
        for include, element in read_includes(inner):
            count += 1
            if count > _MOST_INCLUDES or len(found) >= _MOST_PROBLEMS:
                return Included(tuple(seen), tuple(found))
            if not include.is_certain or _PATTERN.intersection(include.file):
                continue
            place = reach.find(include.file, file.parent)
            if place.path is None:
                is_fine = place.is_computed or (include.is_optional and place.is_absent)
                if not is_fine:
                    found.append(_problem(include, element, file, place.problem, place.remedy))
                continue
            real = place.path.resolve()
            if real in seen or len(seen) >= _MOST_FILES or left <= 0:
                continue
            seen[real] = None
            try:
                text = read_regular(place.path, MOST_BYTES)
            except OSError as error:
                found.append(_problem(include, element, file, f"cannot be read: {reason(error)}"))
                continue
            left -= len(text)
            read = read_xml(text, place.path)
            # The file that includes it can be changed all the same.
            found += (each._replace(severity=Severity.WARNING) for each in read.diagnostics)
            if read.document is not None:
                waiting.append((read.document, place.path))
    return Included(tuple(seen), tuple(found))


def _problem(
    include: Include, element: Element, file: Path, problem: str, remedy: str | None = None
) -> Diagnostic:
    attribute = element.attribute("filename")
    span = element.name_span if attribute is None else attribute.value_span
    message = f"the macros are not expanded: `{include.file}` {problem}"
    return Diagnostic(codes.NOT_EXPANDED, message, span, file, remedy)
