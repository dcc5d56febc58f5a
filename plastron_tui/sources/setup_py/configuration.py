"""The console scripts of a setup.cfg, and what a pyproject.toml says in their place.

From the pages "Configuring setuptools using setup.cfg files" and "Configuring setuptools using
pyproject.toml files" of the setuptools documentation, and its code: what `setup` is called with
counts before the setup.cfg, and the scripts of `[project]` before both, unless `dynamic` names
them.
"""

from __future__ import annotations

import configparser
import sys
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import NamedTuple

from plastron_tui.diagnostics import Diagnostic, Span, codes
from plastron_tui.sources.build_files import (
    Edited,
    RefusedError,
    check_text,
    edited,
    refusal,
    take_back,
)
from plastron_tui.sources.splices import Splice, apply, indent_of, newline_of

from .items import sorted_index
from .reader import CONSOLE_SCRIPTS, ConsoleScript
from .scripts import has_script

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

_SECTION = "options.entry_points"
_INDENT = b"    "


class _Line(NamedTuple):
    """A line, with its end: where it is in bytes, and what it says without blanks around it."""

    start: int
    end: int
    said: str
    is_inner: bool


class _Scripts(NamedTuple):
    """Where the console scripts of a file stand.

    Attributes:
        header: the line that begins their section.
        key: the line with their key, None where there is none.
        scripts: each of them, over its text without the line's end.
    """

    header: _Line
    key: _Line | None
    scripts: tuple[ConsoleScript, ...]


def read_scripts(text: bytes, path: Path) -> tuple[ConsoleScript, ...] | None:
    """Return the console scripts of a setup.cfg, None where it has no section for entry points.

    Raises:
        RefusedError: it has a syntax error, or takes them from another file.
    """
    found = _find(text, path)
    return None if found is None else found.scripts


def add_script(text: bytes, path: Path, name: str, target: str) -> Edited:
    """Make a function an executable of the package, below the other console scripts."""
    return edited(_add, text, path, name, target)


def remove_script(text: bytes, path: Path, name: str) -> Edited:
    """Take an executable out; one that was added before leaves the bytes that were there."""
    return edited(_remove, text, path, name)


def check_project(text: bytes, path: Path) -> None:
    """Refuse a pyproject.toml whose `[project]` says which scripts there are.

    Raises:
        RefusedError: it does.
    """
    check_text(text, path)
    try:
        project = tomllib.loads(text.decode()).get("project")
    except (tomllib.TOMLDecodeError, RecursionError):
        message = f"`{path.name}` has a syntax error"
        raise RefusedError(Diagnostic(codes.BROKEN_BUILD_FILE, message, file=path)) from None
    dynamic = project.get("dynamic") if isinstance(project, dict) else None
    is_open = isinstance(dynamic, list) and ("scripts" in dynamic or "entry-points" in dynamic)
    if project is not None and not is_open:
        why = (
            "says which scripts there are, from version 61 of setuptools on, and `setup.py` before"
        )
        remedy = 'let `setup.py` say it in all of them: `dynamic = ["scripts"]` below `[project]`'
        raise refusal(text, path, _project_line(text), why, codes.COMPUTED_BUILD_FILE, remedy)


def _project_line(text: bytes) -> tuple[int, int]:
    """Return the line that begins `[project]`, in whichever way of TOML it is written."""
    is_top = True
    for line in _lines(text):
        is_header = line.said.startswith("[")
        is_top = is_top and not is_header
        said = line.said.lstrip("[ \t\"'")
        sign = said[7:].lstrip(" \t\"'")[:1]
        if said.startswith("project") and (is_header or is_top) and sign in ("]", ".", "="):
            return line.start, line.end
    return 0, 0


def _lines(text: bytes) -> Iterator[_Line]:
    at = 3 if text.startswith(b"\xef\xbb\xbf") else 0
    for line in text[at:].splitlines(keepends=True):
        yield _Line(at, at + len(line), line.decode().strip(), line[:1] in (b" ", b"\t"))
        at += len(line)


def _values(text: bytes, path: Path) -> dict[str, dict[str, str]]:
    """Return the sections of a file as setuptools reads them."""
    check_text(text, path)
    parser = configparser.RawConfigParser()
    parser.optionxform = str  # type: ignore[assignment,method-assign]
    try:
        parser.read_string(text.decode("utf-8-sig"))
    except configparser.Error:
        message = f"`{path.name}` has a syntax error"
        raise RefusedError(Diagnostic(codes.BROKEN_BUILD_FILE, message, file=path)) from None
    return {each: dict(parser.items(each)) for each in parser.sections()}


def _find(text: bytes, path: Path) -> _Scripts | None:
    values = _values(text, path)
    lines = [each for each in _lines(text) if each.said[:1] not in ("#", ";", "")]
    if "entry_points" in values.get("options", {}):
        line = next(each for each in lines if each.said.startswith("entry_points"))
        raise refusal(text, path, (line.start, line.end), "takes the entry points from elsewhere")
    if _SECTION not in values:
        return None
    start = next(at for at, each in enumerate(lines) if each.said.startswith(f"[{_SECTION}]"))
    header, key, scripts = lines[start], None, list[ConsoleScript]()
    for line in lines[start + 1 :]:
        if not line.is_inner:
            if line.said.startswith("[") or key is not None:
                break
            name, sign, value = line.said.partition("=")
            if sign and name.strip() == CONSOLE_SCRIPTS:
                key = line
                if value.strip():
                    scripts.append(_script(text, line, value.strip()))
        elif key is not None:
            scripts.append(_script(text, line, line.said))
    given = values[_SECTION].get(CONSOLE_SCRIPTS)
    told = None if given is None else [each.strip() for each in given.splitlines() if each.strip()]
    said = [text[each.span.start : each.span.end].decode() for each in scripts]
    if (None if key is None else said) != told or any(not each.target for each in scripts):
        why = "begins entry points in a form that is not followed"
        raise refusal(text, path, (header.start, header.end), why)
    return _Scripts(header, key, tuple(scripts))


def _script(text: bytes, line: _Line, said: str) -> ConsoleScript:
    name, _, target = said.partition("=")
    start = text.index(said.encode(), line.start)
    if not line.is_inner:
        start = text.rindex(said.encode(), line.start, line.end)
    return ConsoleScript(name.strip(), target.strip(), Span(start, start + len(said.encode())))


def _add(text: bytes, path: Path, name: str, target: str) -> bytes:
    found = _find(text, path)
    written = f"{name} = {target}"
    if found is None or not written.isprintable() or any(each in name for each in "=#;[] "):
        message = f"`{written}` cannot be written as an entry point of `{path.name}`"
        raise RefusedError(Diagnostic(codes.EDIT_REFUSED, message, file=path))
    if has_script(found.scripts, name, target, text, path):
        return text
    after = apply(text, _addition(text, found, name, target))
    if not _is_right(after, text, path, {name: target}, set()):
        message = f"adding `{name}` would change more of `{path.name}` than that"
        raise RefusedError(Diagnostic(codes.EDIT_REFUSED, message, file=path))
    return after


def _addition(text: bytes, found: _Scripts, name: str, target: str) -> list[Splice]:
    end = newline_of(text)
    if not found.scripts and found.key is not None:
        # Beside the key, so that it differs from what is written where there was no key.
        at = found.key.start + len(text[found.key.start : found.key.end].rstrip())
        return [Splice(at, at, f" {name} = {target}".encode())]
    if not found.scripts:
        line = found.header
        new = f"{CONSOLE_SCRIPTS} =".encode() + end + _INDENT + f"{name} = {target}".encode()
        if text[line.start : line.end].endswith(b"\n"):
            return [Splice(line.end, line.end, new + end)]
        return [Splice(line.end, line.end, end + new)]
    said = text[found.scripts[-1].span.start : found.scripts[-1].span.end]
    sign = " = " if b" = " in said else "="
    new = f"{name}{sign}{target}".encode()
    inner = [each for each in found.scripts if found.key and each.span.start >= found.key.end]
    indent = indent_of(text, inner[-1].span.start) if inner else _INDENT
    index = sorted_index([each.name for each in found.scripts], name)
    if index < len(found.scripts) and found.scripts[index] in inner:
        at = found.scripts[index].span.start
        return [Splice(at, at, new + end + indent)]
    at = found.scripts[-1].span.end
    return [Splice(at, at, end + indent + new)]


def _remove(text: bytes, path: Path, name: str) -> bytes:
    found = _find(text, path)
    script = next((each for each in found.scripts if each.name == name), None) if found else None
    if found is None or found.key is None or script is None:
        return text
    key = found.key

    def add(each: bytes) -> bytes | None:
        return add_script(each, path, name, script.target).text

    line = next(each for each in _lines(text) if each.start <= script.span.start < each.end)
    ways = [[Splice(script.span.start - 1, script.span.end)], [Splice(*script.span)]]
    if line.is_inner:
        ways = [[Splice(line.start, line.end)]]
        if line.end == len(text) and not text.endswith(b"\n"):
            width = 2 if text[line.start - 2 : line.start] == b"\r\n" else 1
            ways = [[Splice(line.start - width, line.end)]]
    whole = [] if len(found.scripts) > 1 else _whole(text, key, line)
    gone = {name}
    after = take_back(
        text,
        (apply(text, each) for each in ways),
        add,
        lambda each: _is_right(each, text, path, {}, gone),
        exact=(apply(text, each) for each in whole),
    )
    if after is None:
        raise refusal(text, path, script.span, f"says `{name}` in a form that is not followed")
    return after


def _whole(text: bytes, key: _Line, line: _Line) -> Sequence[list[Splice]]:
    """Return the ways to take the key out with its only script."""
    ways = [[Splice(key.start, line.end)]]
    if line.end == len(text) and not text.endswith(b"\n"):
        width = 2 if text[key.start - 2 : key.start] == b"\r\n" else 1
        ways.append([Splice(key.start - width, line.end)])
    return ways


def _is_right(
    after: bytes, before: bytes, path: Path, more: dict[str, str], less: set[str]
) -> bool:
    """Whether a changed text has these scripts more and less, and says nothing else otherwise."""
    try:
        found, old = _find(after, path), _find(before, path)
        values, olds = _values(after, path), _values(before, path)
    except RefusedError:
        return False
    if found is None or old is None:
        return False
    for each in (values, olds):
        each[_SECTION].pop(CONSOLE_SCRIPTS, None)
    expected = {each.name: each.target for each in old.scripts if each.name not in less} | more
    is_same = values == olds and len(found.scripts) == len(expected)
    return is_same and {each.name: each.target for each in found.scripts} == expected
