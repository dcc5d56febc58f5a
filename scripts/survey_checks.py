"""What must hold of an edited node, checked without the code that edits.

Python's own parser, `difflib` and ruff say whether a text is still sound; of Plastron only the
reader is used, to see which endpoints there are.
"""

from __future__ import annotations

import ast
import difflib
import json
import re
import subprocess
import sys
import warnings
from collections import Counter
from collections.abc import Iterator, Sequence
from functools import cached_property
from pathlib import Path

from plastron_tui.model.kinds import Client, Publisher, Subscription, kind_of
from plastron_tui.model.source import Add, Change, EndpointKind, Remove, Rename, SourceUnit
from plastron_tui.sources.python.syntax import parse

Key = tuple[EndpointKind, str, str, str]

# What an added endpoint calls on its node.
_NODE_METHODS = frozenset(
    {"create_publisher", "create_subscription", "create_service", "create_client"}
    | {"create_timer", "get_logger", "get_clock"}
)
# An undefined name, an unused import, a name that is bound twice without a use between.
_RULES = "F821,F401,F811"


class Text:
    """A node's text, and what is known of it."""

    def __init__(self, source: SourceUnit) -> None:
        self.source = source

    @cached_property
    def errors(self) -> int:
        """In how many places the text does not parse."""
        return parse(self.source.files.main).errors

    @cached_property
    def module(self) -> ast.Module | None:
        """The syntax tree of a text that is Python 3."""
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                return ast.parse(self.source.files.main)
        except (SyntaxError, ValueError, RecursionError):
            return None

    @cached_property
    def keys(self) -> Counter[Key]:
        """The endpoints, by what is said of them."""
        return Counter(
            (e.kind, e.name if e.name is not None else e.expression, str(e.type), e.callback or "")
            for node in self.source.nodes
            for e in node.endpoints
        )

    @cached_property
    def missing_attributes(self) -> set[str]:
        """The attributes of `self` that are read, and that no line of the file sets."""
        if self.module is None:
            return set()
        own = [
            each
            for each in ast.walk(self.module)
            if isinstance(each, ast.Attribute)
            and isinstance(each.value, ast.Name)
            and each.value.id == "self"
        ]
        used = {each.attr for each in own if isinstance(each.ctx, ast.Load)}
        functions = (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef)
        defined = {each.name for each in ast.walk(self.module) if isinstance(each, functions)}
        defined |= {each.attr for each in own if not isinstance(each.ctx, ast.Load)}
        return used - defined


def check(before: Text, after: Text, change: Change) -> Iterator[str]:
    """Yield what a change should not have done."""
    if after.errors > before.errors:
        yield f"parses worse: {before.errors} errors before, {after.errors} after"
    if before.module is not None and after.module is None:
        yield "is no Python 3 any more"
    missing = after.missing_attributes - before.missing_attributes
    if missing := {name for name in missing if name not in _NODE_METHODS}:
        yield f"leaves attributes that nothing sets: {', '.join(sorted(missing))}"
    if isinstance(change, Add):
        yield from _check_addition(before, after, change)
    elif isinstance(change, Remove):
        yield from _check_removal(before, after, change)
    elif isinstance(change, Rename):
        yield from _check_rename(before, after, change)


def _check_rename(before: Text, after: Text, change: Rename) -> Iterator[str]:
    old = (change.kind, change.name)
    expected = Counter(
        {(key[0], change.to, *key[2:]) if key[:2] == old else key: n
         for key, n in before.keys.items()}
    )  # fmt: skip
    if expected != after.keys:
        yield f"has {_listed(after.keys - expected)} instead of {_listed(expected - after.keys)}"
    texts = [each.source.files.main.splitlines() for each in (before, after)]
    if len(texts[0]) != len(texts[1]):
        yield "changes the number of lines"
    # rospy writes a private name without the stroke.
    written = {change.to.encode(), change.to.replace("~/", "~").encode()}
    for was, now in zip(*texts, strict=False):
        if was != now and not any(name in now for name in written):
            yield f"changes {was!r} to {now!r}"


def _check_addition(before: Text, after: Text, change: Add) -> Iterator[str]:
    more, fewer = after.keys - before.keys, before.keys - after.keys
    if fewer:
        yield f"loses endpoints: {_listed(fewer)}"
    timers = [key for key in more.elements() if key[0] is EndpointKind.TIMER]
    added = [key for key in more.elements() if key[0] is not EndpointKind.TIMER]
    endpoint = change.endpoint
    name = endpoint.name
    expected = (kind_of(type(endpoint)), name, str(endpoint.type))
    if [key[:3] for key in added] != [expected]:
        yield f"adds {_listed(more)} instead of {name}"
    # A message is sent, and a request is made, in a timer of its own where the file has no loop.
    if len(timers) > (1 if isinstance(endpoint, (Publisher, Client)) else 0):
        yield f"adds timers: {_listed(more)}"
    asked = endpoint.callback if isinstance(endpoint, Subscription) else None
    if asked is not None and any(key[3] != asked for key in added):
        yield f"does not call {asked}"
    for old, new in _replaced(before.source.files.main, after.source.files.main):
        if not _is_within(old, new):
            yield f"changes {old!r} to {new!r}"


def _check_removal(before: Text, after: Text, change: Remove) -> Iterator[str]:
    expected = Counter(
        {key: n for key, n in before.keys.items() if key[:2] != (change.kind, change.name)}
    )
    # An endpoint whose name is not known keeps its expression, which may be the same text.
    unknown = sum(
        1
        for node in before.source.nodes
        for e in node.of_kind(change.kind)
        if e.name is None and e.expression == change.name
    )
    lost = Counter(
        {key: n for key, n in (expected - after.keys).items() if not _is_gone_timer(key, after)}
    )
    if (lost or after.keys - expected) and not unknown:
        yield f"loses {_listed(lost)}, adds {_listed(after.keys - expected)}"
    words = _words(before, change) | {
        key[3].encode() for key in expected - after.keys if _is_gone_timer(key, after)
    }
    for old, new in _replaced(before.source.files.main, after.source.files.main):
        if not _is_within(new.replace(b"pass", b""), old):
            yield f"changes {old!r} to {new!r}"
        elif old.strip() and not any(word in old for word in words):
            yield from () if _is_gone_local(old, after) else (f"takes {old!r}",)


def _is_gone_local(lines: bytes, after: Text) -> bool:
    """Whether lines only gave values to, or filled, what is nowhere any more."""
    text = after.source.files.main
    for line in filter(bytes.strip, lines.splitlines()):
        own = re.match(rb"\s+self\.(\w+)\s*=", line)
        assigned = own or re.match(rb"\s+(\w+)[\w.]*\s*[=(]", line)
        before = rb"\b" if own else rb"(?<![.\w])"
        if assigned is None or re.search(rb"%s%s\b" % (before, assigned[1]), text):
            return False
    return True


def _is_gone_timer(key: Key, after: Text) -> bool:
    """Whether a timer went with its callback, which did nothing but publish."""
    is_there = re.search(rb"\b%s\b" % key[3].encode(), after.source.files.main)
    return key[0] is EndpointKind.TIMER and bool(key[3]) and not is_there


def _words(text: Text, change: Remove) -> set[bytes]:
    """Return what a piece of text that goes with an endpoint must hold one of."""
    found = {change.name.encode(), change.name.rpartition(".")[2].encode(), b"import"}
    for node in text.source.nodes:
        for endpoint in node.of_kind(change.kind):
            if endpoint.name != change.name or endpoint.span is None:
                continue
            found.add(text.source.files.main[endpoint.span.start : endpoint.span.end])
            found.add((endpoint.callback or change.name).encode())
            if endpoint.type is not None:
                found.add(endpoint.type.name.encode())
            line = text.source.files.main.rfind(b"\n", 0, endpoint.span.start) + 1
            assigned = text.source.files.main[line : endpoint.span.start]
            found |= {word for word in re.findall(rb"\w+", assigned) if word != b"self"}
    return found


def _listed(keys: Counter[Key]) -> str:
    return "; ".join(f"{key[0].value} {key[1]} {key[2]} {key[3]}" for key in keys.elements()) or "-"


def _replaced(before: bytes, after: bytes) -> Iterator[tuple[bytes, bytes]]:
    """Yield the lines that differ: what they were, and what they are."""
    one, other = before.splitlines(keepends=True), after.splitlines(keepends=True)
    matcher = difflib.SequenceMatcher(None, one, other, autojunk=False)
    for tag, start, end, new_start, new_end in matcher.get_opcodes():
        if tag != "equal":
            yield b"".join(one[start:end]), b"".join(other[new_start:new_end])


def _is_within(part: bytes, whole: bytes) -> bool:
    """Whether a text is another one with pieces taken out."""
    rest = iter(whole)
    return all(byte in rest for byte in part if byte not in b"\r\n")


def names_at_fault(results: Sequence[tuple[str, bytes, bytes]], folder: Path) -> Iterator[str]:
    """Yield the edits after which ruff finds names that are not bound, or imports without use."""
    texts: dict[bytes, str] = {}
    for _, before, after in results:
        for text in (before, after):
            texts.setdefault(text, f"t{len(texts)}.py")
    for text, name in texts.items():
        (folder / name).write_bytes(text)
    found = _ruff(folder)
    for what, before, after in results:
        old, new = found[texts[before]], found[texts[after]]
        if "" in old:
            continue  # not Python 3, for ruff
        tried = _tried_imports(before)
        worse = [each for each in (new - old).elements() if _is_fault(each, what, tried)]
        if worse:
            yield f"{what}: {', '.join(worse)}"


def _is_fault(finding: str, what: str, tried: set[str]) -> bool:
    """Whether a finding is an edit's fault.

    A removal takes no import but the type's, and not that where the file tries the import.
    """
    if "remove" not in what or finding.startswith("F821"):
        return True
    found = re.search(r"`(?:[\w.]+\.(?:msg|srv)\.)(\w+)`", finding)
    return found is not None and found[1] not in tried


def _tried_imports(text: bytes) -> set[str]:
    """Return the names that a module imports in a `try` or an `if`."""
    found: set[str] = set()
    for statement in ast.parse(text).body:
        if isinstance(statement, (ast.Try, ast.If)):
            for each in ast.walk(statement):
                if isinstance(each, (ast.Import, ast.ImportFrom)):
                    found |= {alias.asname or alias.name for alias in each.names}
    return found


def _ruff(folder: Path) -> dict[str, Counter[str]]:
    command = [sys.executable, "-m", "ruff", "check", "--isolated", "--no-cache", "--quiet"]
    command += ["--target-version", "py312", "--select", _RULES, "--ignore-noqa"]
    command += ["--output-format", "json", "--exit-zero", str(folder)]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    found: dict[str, Counter[str]] = {file.name: Counter() for file in folder.iterdir()}
    for each in json.loads(done.stdout or "[]"):
        code = each["code"] or ""
        message = "" if code in ("", "invalid-syntax") else f"{code} {each['message']}"
        message = re.sub(r"(on|from) line \d+", "elsewhere", message)
        found[Path(each["filename"]).name][message] += 1
    return found
