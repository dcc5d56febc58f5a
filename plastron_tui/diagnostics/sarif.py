"""Diagnostics as SARIF 2.1.0, the format that code hosts and editors take from analysers.

Source: OASIS, "Static Analysis Results Interchange Format (SARIF) Version 2.1.0", sections 3.14
(run), 3.27 (result), 3.30 (region; columns count Unicode code points, from 1), 3.55 (fix).
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any, NamedTuple
from urllib.parse import quote

from .code import Code
from .data import Diagnostic, Span
from .lines import LineIndex
from .render import Lines
from .severity import Severity

SCHEMA = "https://json.schemastore.org/sarif-2.1.0.json"
_LEVELS = {Severity.ERROR: "error", Severity.WARNING: "warning", Severity.NOTE: "note"}


class RuleText(NamedTuple):
    """What people call a rule, and what happens where it is broken."""

    name: str
    why: str


def as_sarif(
    diagnostics: Iterable[Diagnostic],
    lines: Lines,
    root: Path,
    version: str,
    rules: Mapping[Code, RuleText],
) -> dict[str, Any]:
    """Return diagnostics as the data of a SARIF log.

    Args:
        diagnostics: the diagnostics.
        lines: gives the lines of a file.
        root: the folder that paths are told from.
        version: the version of this program.
        rules: the rules that were followed.
    """
    found = tuple(diagnostics)
    others = {x.code: RuleText(str(x.code), x.code.summary) for x in found if x.code not in rules}
    known = {**rules, **others}
    listed = sorted(known)
    places = {code: at for at, code in enumerate(listed)}
    results = [_result(each, lines, root, places) for each in found]
    driver = {
        "name": "plastron lint",
        "semanticVersion": version,
        "rules": [_rule(code, known[code]) for code in listed],
    }
    run = {
        "tool": {"driver": driver},
        "columnKind": "unicodeCodePoints",
        "originalUriBaseIds": {"ROOT": {"uri": f"file://{_quoted(root).rstrip('/')}/"}},
        "results": results,
    }
    return {"$schema": SCHEMA, "version": "2.1.0", "runs": [run]}


def _rule(code: Code, rule: RuleText) -> dict[str, Any]:
    return {
        "id": str(code),
        "name": rule.name,
        "shortDescription": {"text": code.summary},
        "fullDescription": {"text": rule.why},
        "help": {"text": rule.why},
        "defaultConfiguration": {"level": _LEVELS[code.severity]},
    }


def _result(
    found: Diagnostic, lines: Lines, root: Path, places: Mapping[Code, int]
) -> dict[str, Any]:
    text = found.message if found.help is None else f"{found.message}; {found.help}"
    result: dict[str, Any] = {
        "ruleId": str(found.code),
        "level": _LEVELS[found.severity],
        "message": {"text": text},
    }
    result["ruleIndex"] = places[found.code]
    if found.file is None:
        return result
    index = lines(found.file)
    result["locations"] = [{"physicalLocation": _physical(found.file, root, found.span, index)}]
    related = [
        {
            "id": number,
            "message": {"text": label.message},
            "physicalLocation": _physical(
                label.file or found.file, root, label.span, lines(label.file or found.file)
            ),
        }
        for number, label in enumerate(found.labels, 1)
    ]
    if related:
        result["relatedLocations"] = related
    if found.fix is not None and index is not None:
        change = {
            "artifactLocation": _artifact(found.file, root),
            "replacements": [
                {
                    "deletedRegion": _region(edit.span, index),
                    "insertedContent": {"text": edit.text},
                }
                for edit in found.fix.edits
            ],
        }
        result["fixes"] = [{"description": {"text": found.fix.title}, "artifactChanges": [change]}]
    return result


def _physical(file: Path, root: Path, span: Span | None, index: LineIndex | None) -> dict[str, Any]:
    place: dict[str, Any] = {"artifactLocation": _artifact(file, root)}
    if span is not None and index is not None:
        place["region"] = _region(span, index)
    return place


def _artifact(file: Path, root: Path) -> dict[str, str]:
    if file.is_relative_to(root):
        return {"uri": _quoted(file.relative_to(root)), "uriBaseId": "ROOT"}
    return {"uri": f"file://{_quoted(file)}"}


def _quoted(path: Path) -> str:
    """Return a path as it stands in a URI, byte by byte: a name need not be UTF-8."""
    return quote(os.fsencode(path))


def _region(span: Span, index: LineIndex) -> dict[str, int]:
    start, end = index.position(span.start), index.position(span.end)
    return {
        "startLine": start.line,
        "startColumn": start.column,
        "endLine": end.line,
        "endColumn": end.column,
    }
