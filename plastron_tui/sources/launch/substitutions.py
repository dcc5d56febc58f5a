"""Substitutions as they are written in XML and YAML.

Sources: `roslaunch.substitution_args` for ROS 1; `launch/frontend/grammar.lark` for ROS 2.
"""

from __future__ import annotations

from plastron_tui.ros.launch_text import Kind, Substitution, Text, text

_DEEPEST = 20
_KINDS = {
    1: {
        "arg": Kind.ARGUMENT,
        "find": Kind.PACKAGE,
        "env": Kind.ENVIRONMENT,
        "optenv": Kind.ENVIRONMENT,
        "dirname": Kind.FOLDER,
    },
    2: {
        "var": Kind.ARGUMENT,
        "find-pkg-share": Kind.PACKAGE,
        "env": Kind.ENVIRONMENT,
        "dirname": Kind.FOLDER,
        "file-content": Kind.CONTENT,
        "command": Kind.COMMAND,
    },
}


def parse_text(source: str, ros_version: int) -> Text:
    """Read a text; what is no substitution that is known is one of `Kind.OTHER`."""
    if "$(" not in source and (ros_version == 1 or "\\" not in source):
        return text(source)
    return _Parser(source, ros_version).text()


def write_text(of: Text, ros_version: int) -> str | None:
    """Return how a text is written, None where this generation of ROS has no words for it."""
    found = [_written(part, ros_version) for part in of.parts]
    known = [part for part in found if part is not None]
    return "".join(known) if len(known) == len(found) else None


def escaped(literal: str, ros_version: int) -> str | None:
    """Return how a literal is written, None where it would be taken for a substitution."""
    if ros_version == 1:
        return None if "$(" in literal else literal
    return literal.replace("\\", "\\\\").replace("$(", "\\$(")


def _written(part: str | Substitution, ros_version: int) -> str | None:
    if isinstance(part, str):
        return escaped(part, ros_version)
    if part.kind is Kind.OTHER:
        return f"$({part.argument})"
    if part.kind is Kind.FOLDER:
        return "$(dirname)"
    words = [_argument(part.argument, ros_version)]
    kinds = _KINDS[ros_version].items()
    word = next((word for word, kind in kinds if kind is part.kind), None)
    if word is None:
        return None
    if part.default is not None:
        words.append(_argument(part.default, ros_version))
        word = "optenv" if ros_version == 1 else word
    known = [each for each in words if each is not None]
    return f"$({word} {' '.join(known)})" if len(known) == len(words) else None


def _argument(of: Text, ros_version: int) -> str | None:
    if ros_version == 1:
        literal = of.literal
        return None if literal is None or ")" in literal else literal
    found = write_text(of, 2)
    plain = "".join(part for part in of.parts if isinstance(part, str))
    if found is not None and any(mark in plain for mark in " ()'\""):
        quote = '"' if of.literal is not None else "'"
        return quote + found.replace(quote, "\\" + quote) + quote
    return found or "''"


class _Parser:
    """Goes over a text once."""

    def __init__(self, source: str, ros_version: int) -> None:
        self._source, self._version = source, ros_version
        self._at = 0
        self._depth = 0

    def text(self) -> Text:
        found: list[str | Substitution] = []
        while self._at < len(self._source):
            if self._source.startswith("$(", self._at):
                found.append(self._substitution())
            else:
                found.append(self._character())
        return text(*found)

    def _character(self) -> str:
        mark = self._source[self._at]
        self._at += 1
        if mark == "\\" and self._version == 2 and self._at < len(self._source):
            mark = self._source[self._at]
            self._at += 1
        return mark

    def _substitution(self) -> Substitution:
        start = self._at
        end = self._end(start)
        if end is None:
            self._at = len(self._source)
            return Substitution(Kind.OTHER, text(self._source[start + 2 :]))
        inner = self._source[start + 2 : end]
        word, _, rest = inner.strip().partition(" ")
        kind = _KINDS[self._version].get(word, Kind.OTHER)
        if self._version == 1:
            self._at = end + 1
            return _ros1(kind, word, rest.strip(), inner)
        found = self._arguments(start + 2 + len(word)) if kind is not Kind.OTHER else None
        least, most = (0, 0) if kind is Kind.FOLDER else (1, 2 if kind is Kind.ENVIRONMENT else 1)
        self._at = end + 1
        if found is None or not least <= len(found) <= most:
            return Substitution(Kind.OTHER, text(inner))
        default = found[1] if len(found) > 1 else None
        return Substitution(kind, found[0] if found else text(), default)

    def _end(self, start: int) -> int | None:
        """Return where the parenthesis is that closes a substitution."""
        depth = 0
        quote = ""
        at = start + 1
        while at < len(self._source):
            mark = self._source[at]
            if mark == "\\" and self._version == 2:
                at += 1
            elif quote:
                quote = "" if mark == quote else quote
            elif mark in "'\"" and self._version == 2 and self._source[at - 1] in " (":
                quote = mark
            elif mark == "(":
                depth += 1
            elif mark == ")":
                depth -= 1
                if not depth:
                    return at
            at += 1
        return None

    def _arguments(self, at: int) -> list[Text] | None:
        """Return the words behind the name of a substitution, None where it is nested too deep."""
        self._depth += 1
        if self._depth > _DEEPEST:
            return None
        self._at = at
        words: list[Text] = []
        while self._at < len(self._source) and self._source[self._at] == " ":
            while self._source.startswith(" ", self._at):
                self._at += 1
            if not self._source.startswith(")", self._at):
                words.append(self._word())
        is_whole = self._source.startswith(")", self._at)
        self._depth -= 1
        return words if is_whole else None

    def _word(self) -> Text:
        quote = self._source[self._at]
        stop = quote if quote in "'\"" else " )"
        self._at += quote in "'\""
        found: list[str | Substitution] = []
        while self._at < len(self._source) and self._source[self._at] not in stop:
            if self._source.startswith("$(", self._at):
                found.append(self._substitution())
            else:
                found.append(self._character())
        self._at += quote in "'\""
        return text(*found)


def _ros1(kind: Kind, word: str, rest: str, inner: str) -> Substitution:
    if kind is Kind.FOLDER:
        return Substitution(kind, text())
    if kind is Kind.OTHER or not rest:
        return Substitution(Kind.OTHER, text(inner))
    if word == "optenv":
        name, _, default = rest.partition(" ")
        return Substitution(kind, text(name), text(default))
    if " " in rest:
        return Substitution(Kind.OTHER, text(inner))
    return Substitution(kind, text(rest))
