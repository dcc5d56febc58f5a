"""How a file writes things: its line ending, indent, quotes, and how it names what it holds."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass

from tree_sitter import Node

from plastron_tui.model.source import EndpointKind

from . import literals, naming
from .analysis import Analysis, Site
from .splices import line_end, line_start

# What stands for a kind of endpoint in the names of variables, the usual one first.
_WORDS = {
    EndpointKind.PUBLISHER: ("pub", "publisher"),
    EndpointKind.SUBSCRIPTION: ("sub", "subscriber", "subscription"),
    EndpointKind.SERVICE: ("srv", "service", "server"),
    EndpointKind.CLIENT: ("client", "cli", "proxy", "srv", "service"),
    EndpointKind.ACTION_SERVER: ("server", "action_server"),
    EndpointKind.ACTION_CLIENT: ("client", "action_client"),
    EndpointKind.TIMER: ("timer",),
}
_USUAL = {
    EndpointKind.PUBLISHER: "pub",
    EndpointKind.SUBSCRIPTION: "sub",
    EndpointKind.SERVICE: "service",
    EndpointKind.CLIENT: "client",
    EndpointKind.ACTION_SERVER: "server",
    EndpointKind.ACTION_CLIENT: "client",
    EndpointKind.TIMER: "timer",
}
_BEFORE = frozenset({"on", "handle", "process"})
_CALLBACK_WORDS = ("callback", "cb", "handler", "handle", "on", "process", "received")

# Blank lines are looked for in so many bytes.
_NEAR = 200

_CAMEL = re.compile(r"_*[a-z]+[a-z0-9]*[A-Z]\w*")

# A text on one line; comments and docstrings, which are written otherwise, are no group.
_STRING = re.compile(
    rb"""#[^\n]*|\"{3}[\s\S]*?\"{3}|'{3}[\s\S]*?'{3}"""
    rb"""|(?P<quote>["'])(?:(?!(?P=quote))[^\\\n]|\\.)*(?P=quote)"""
)
_BLOCK = re.compile(rb"^([ \t]*)[^\s#][^\n]*:[ \t]*\r?\n\1([ \t]+)[^\s#]", re.M)


@dataclass(frozen=True, slots=True)
class Naming:
    """A manner of naming: what stands before and after the words of a topic."""

    before: str
    after: str
    is_camel: bool = False

    def name(self, ros_name: str) -> str:
        """Return the name of something that belongs to a ROS name."""
        text = naming.words(ros_name)
        if self.is_camel:
            parts = text.split("_")
            first = parts[0] if not self.before.strip("_") else parts[0].capitalize()
            text = first + "".join(part.capitalize() for part in parts[1:])
        return f"{self.before}{text}{self.after}"


@dataclass(frozen=True, slots=True)
class Conventions:
    """How a file is written."""

    newline: str
    indent: str
    quote: str
    blank_lines: int

    def string(self, value: str) -> str:
        """Write a string in the file's quotes, where that takes no more escapes."""
        text = literals.string(value)
        body = text[1:-1]
        if text[0] != self.quote and '"' not in body and "'" not in body:
            return f"{self.quote}{body}{self.quote}"
        return text


def conventions_of(analysis: Analysis) -> Conventions:
    """Find out how a file is written."""
    text = analysis.syntax.text
    windows = text.count(b"\r\n")
    newline = "\r\n" if windows and windows * 2 >= text.count(b"\n") else "\n"
    quotes = Counter(
        text[node.start_byte : node.start_byte + 1]
        for site in analysis.sites
        for node in (*site.arguments.positional, *site.arguments.keywords.values())
        if node.type == "string"
    )
    if not quotes:
        quotes = Counter(found["quote"] for found in _STRING.finditer(text) if found["quote"])
    quote = "'" if quotes[b"'"] > quotes[b'"'] else '"'
    return Conventions(newline, _indent(analysis), quote, _blank_lines(analysis))


def _indent(analysis: Analysis) -> str:
    """Return one level of indent, as the first bodies of the file have it."""
    found: Counter[str] = Counter()
    for scope in analysis.scopes.all[:40]:
        block = scope.node.child_by_field_name("body")
        if scope.kind not in ("class", "function") or block is None:
            continue
        if block.start_point.row == scope.node.start_point.row:
            continue
        inner = leading_space(analysis, block)
        outer = leading_space(analysis, scope.node)
        if inner.startswith(outer) and len(inner) > len(outer):
            found[inner[len(outer) :]] += 1
    if found:
        return found.most_common(1)[0][0]
    return block_indent(analysis.syntax.text)


def block_indent(text: bytes) -> str:
    """Return one level of indent, as most blocks of a text have it."""
    found = Counter(each[2] for each in _BLOCK.finditer(text))
    return found.most_common(1)[0][0].decode() if found else "    "


def leading_space(analysis: Analysis, node: Node) -> str:
    """Return the white space before a node's line, up to its first character."""
    text = analysis.syntax.text
    start = line_start(text, node.start_byte)
    line = text[start : node.start_byte]
    return line[: len(line) - len(line.lstrip())].decode("ascii", "replace")


def _blank_lines(analysis: Analysis) -> int:
    """Return how many blank lines part the definitions at the top of the file from the others."""
    tops = [
        child
        for child in analysis.syntax.root.named_children
        if child.type in ("function_definition", "class_definition", "decorated_definition")
    ]
    text = analysis.syntax.text
    starts = (line_start(text, node.start_byte) for node in tops)
    ends = (line_end(text, node.end_byte) for node in tops)
    above = (text[max(start - _NEAR, 0) : start] for start in starts)
    below = (text[end : end + _NEAR] for end in ends)
    found = [_blank_before(each.splitlines()[::-1]) for each in above]
    found += [_blank_before(each.splitlines()) for each in below]
    parted = Counter(blank for blank in found if blank in (1, 2))
    return max(parted, key=lambda blank: (parted[blank], blank), default=2)


def _blank_before(lines: list[bytes]) -> int:
    """Return how many blank lines stand before the first that has something, 0 for none."""
    return next((number for number, line in enumerate(lines) if line.strip()), 0)


def variable_naming(analysis: Analysis, kind: EndpointKind) -> Naming:
    """Return how the file names the variables that hold endpoints of a kind."""
    for wanted in (kind, *(each for each in _WORDS if each is not kind)):
        for site in reversed(analysis.sites):
            if site.endpoint.kind is not wanted or (name := target_name(analysis, site)) is None:
                continue
            found = _split(name.rpartition(".")[2], _WORDS[wanted])
            if found is not None:
                before, word, after, is_camel = found
                if wanted is not kind:
                    word = _like(word, kind)
                return _joined(before, word, after, is_camel)
    held = [name for scope in analysis.scopes.classes() for name in scope.attributes]
    return Naming(_private(held), f"_{_USUAL[kind]}")


def _private(names: Sequence[str]) -> str:
    """Return the underscore that most of some names begin with, "" where they do not."""
    private = sum(name.startswith("_") for name in names)
    return "_" if private > 1 and private * 2 > len(names) else ""


def method_naming(analysis: Analysis, word: str) -> Naming:
    """Return how the file would name a function that only ROS calls, and that a word begins."""
    functions = [scope.name for scope in analysis.scopes.all if scope.kind == "function"]
    camel = sum(_CAMEL.fullmatch(name) is not None for name in functions)
    is_camel = camel > sum("_" in name.strip("_") for name in functions)
    word = f"{_method_prefix(analysis)}{word}"
    return Naming(word if is_camel else f"{word}_", "", is_camel)


def _method_prefix(analysis: Analysis) -> str:
    called = [site.endpoint.callback for site in analysis.sites if site.endpoint.callback]
    methods = [
        scope.name
        for scope in analysis.scopes.all
        if scope.self_name and not scope.name.startswith("__")
    ]
    return _private(called) if len(called) > 1 else _private(methods)


def _like(word: str, kind: EndpointKind) -> str:
    """Return the word of another kind that goes with one: `subscriber` with `publisher`."""
    usual = _USUAL[kind]
    if kind in (EndpointKind.PUBLISHER, EndpointKind.SUBSCRIPTION, EndpointKind.SERVICE):
        usual = _WORDS[kind][len(word) > len("proxy")]
    return usual.capitalize() if word[:1].isupper() else usual


def _joined(before: str, word: str, after: str, is_camel: bool) -> Naming:
    """Put a kind's word where the file has it: before the topic's words, or behind them."""
    leading = before[: len(before) - len(before.lstrip("_"))]
    trailing = "_" if after == "_" else ""
    is_alone = not before.strip("_") and not after.strip("_")
    if is_alone and word.lower() in _BEFORE:
        return Naming(f"{leading}{word}_", "")
    if before.strip("_") or not after.strip("_"):
        if is_camel:
            return Naming(leading, word[:1].upper() + word[1:] + trailing, True)
        return Naming(leading, f"_{word}{trailing}")
    return Naming(f"{leading}{word}" + ("" if is_camel else "_"), "", is_camel)


def _split(name: str, words: tuple[str, ...]) -> tuple[str, str, str, bool] | None:
    """Split a name around a word: what stands before, the word, what stands behind."""
    for word in sorted(words, key=len, reverse=True):
        for found in re.finditer(word, name, re.IGNORECASE):
            before, after = name[: found.start()], name[found.end() :]
            if before and before[-1].isalpha() and not found[0][0].isupper():
                continue
            if after and after[0].isalpha() and not after[0].isupper():
                continue
            is_camel = (bool(before.strip("_")) and found[0][0].isupper()) or (
                bool(after) and after[0].isupper()
            )
            return before, found[0], after, is_camel
    return None


def callback_naming(analysis: Analysis, kind: EndpointKind) -> Naming:
    """Return how the file names the callbacks of endpoints of a kind."""
    for site in reversed(analysis.sites):
        name = site.endpoint.callback
        if site.endpoint.kind is kind and name is not None:
            found = _split(name, _CALLBACK_WORDS)
            if found is not None:
                return _joined(*found)
    for site in reversed(analysis.sites):
        found = _split(site.endpoint.callback or "", ("callback", "cb"))
        if found is not None:
            return _joined(*found)
    return method_naming(analysis, "handle" if kind is EndpointKind.SERVICE else "on")


def target_name(analysis: Analysis, site: Site) -> str | None:
    """Return the variable that a call site is assigned to, as the source has it."""
    parent = site.call.parent
    if parent is None or parent.type != "assignment":
        return None
    target = parent.child_by_field_name("left")
    if target is None or target.type not in ("identifier", "attribute"):
        return None
    return analysis.syntax.slice(target)
