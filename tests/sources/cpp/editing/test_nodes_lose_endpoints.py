"""Each endpoint of each node in C++ of tests/nodes, taken out, or renamed."""

from __future__ import annotations

import re
from collections import Counter
from pathlib import Path

import pytest
from patches import CATALOGS, LIBRARIES

from plastron_tui.diagnostics import Span
from plastron_tui.model.source import EndpointKind, Remove, Rename, SourceUnit
from plastron_tui.sources.cpp.editing.editor import edit_cpp
from plastron_tui.sources.cpp.syntax import parse
from plastron_tui.targets import files_of, read_source

pytestmark = pytest.mark.long

NODES = Path(__file__).parents[3] / "nodes"
SOURCES = sorted(path for library in LIBRARIES for path in (NODES / library).rglob("*.cpp"))
_WRITTEN = re.compile(rb"\{\}|\(void\)|/\*\s*(?=\w+\s*\*/)|(?<=\w)\s*\*/")
"""What a removal may write: an empty body, and a parameter that nothing uses in a comment."""

Key = tuple[EndpointKind, str | None, str, str | None]


def _read(path: Path) -> bytes | None:
    return path.read_bytes() if path.is_file() else None


def _found(source: SourceUnit) -> Counter[Key]:
    """Return what there is; what a default gave its name may have that for sure afterwards."""
    found = source.endpoints
    return Counter(
        (each.kind, each.label or each.default, str(each.type), each.callback) for each in found
    )


def _is_within(part: bytes, whole: bytes) -> bool:
    """Tell whether a text is another one with pieces taken out."""
    rest = iter(whole)
    return all(each in rest for each in part if each not in b" \t\r\n")


def _sources() -> list[tuple[Path, SourceUnit]]:
    found = []
    for path in SOURCES:
        source = read_source(path, files_of(path, path.read_bytes(), _read)).source
        if source is not None:
            found.append((path, source))
    return found


def _named(source: SourceUnit) -> list[tuple[str | None, EndpointKind, str]]:
    several = len(source.nodes) > 1
    found = (
        (node.label if several else None, each.kind, each.label)
        for node in source.nodes
        for each in node.endpoints
        if each.label is not None and each.kind.facts.editing is not None
    )
    return list(dict.fromkeys(found))  # type: ignore[arg-type]


def test_what_is_taken_out_is_gone_and_nothing_else_or_it_says_why_not() -> None:
    taken = 0
    for path, source in _sources():
        before = _found(source)
        for label, kind, name in _named(source):
            change = Remove(kind, name, Span(0, 1), label)
            done = edit_cpp(source, [change], CATALOGS[LIBRARIES[source.library]])
            where = f"{path.relative_to(NODES)}: {kind.word} {name}"
            if done.files is None:
                (told,) = done.diagnostics
                assert told.help and told.span, (where, told.message)
                continue
            taken += 1
            for (file, old), (_, new) in zip(source.files.texts, done.files.texts, strict=True):
                assert parse(new).errors <= parse(old).errors, (where, file)
                if kind is not EndpointKind.PARAMETER:
                    assert _is_within(_WRITTEN.sub(b"", new), old), (where, file)
            again = read_source(source.path, done.files).source
            left = Counter() if again is None else _found(again)
            gone = Counter({k: n for k, n in before.items() if k[:2] == (kind, name)})
            idle = before - left - gone
            assert all(key[0] is EndpointKind.TIMER for key in idle), (where, idle)
            if kind is not EndpointKind.PARAMETER:
                assert not left - before, (where, left - before)
    assert taken > 300


def test_what_is_renamed_is_renamed_back_to_the_byte_or_to_a_literal() -> None:
    for path, source in _sources():
        version = LIBRARIES[source.library]
        for label, kind, name in _named(source)[::3]:
            if kind is EndpointKind.TIMER or kind.facts.named == "parameter":
                continue
            if not name.isascii():
                continue  # No statement can say it.
            start = "~/" if name.startswith("~") else "/" if name.startswith("/") else ""
            there = Rename(kind, name, f"{start}plastron_name", Span(0, 1), label)
            done = edit_cpp(source, [there], CATALOGS[version])
            where = f"{path.relative_to(NODES)}: {kind.word} {name}"
            if done.files is None:
                assert all(each.help and each.span for each in done.diagnostics), where
                continue
            again = read_source(source.path, done.files).source
            assert again is not None, where
            back = Rename(kind, there.to, name, Span(0, 1), label)
            restored = edit_cpp(again, [back], CATALOGS[version])
            assert restored.files is not None, (where, restored.diagnostics)
            last = read_source(source.path, restored.files).source
            assert last is not None and _found(last) == _found(source), where
