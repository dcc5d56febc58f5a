"""Finding and replacing in a text."""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    # Imported when something is looked for. Unlike Python's own it can be told to give up.
    import regex

MOST_MATCHES = 20_000

TIME_LIMIT = 0.25
"""Seconds after which a search gives up: an expression may need longer than anybody lives."""


@dataclass(frozen=True, slots=True)
class Found:
    """What a search found: the places in bytes, the matches, or why there are none."""

    spans: list[tuple[int, int]] = field(default_factory=list)
    matches: list[regex.Match[str]] = field(default_factory=list)
    problem: str = ""


@dataclass
class Search:
    """What is looked for, and where a text has it, in bytes.

    `problem` says what is wrong with a regular expression.
    """

    pattern: regex.Pattern[str] | None = None
    is_regex: bool = False
    problem: str = ""
    spans: list[tuple[int, int]] = field(default_factory=list)
    _matches: list[regex.Match[str]] = field(default_factory=list)

    @classmethod
    def make(cls, what: str, *, is_regex: bool, is_case_sensitive: bool) -> Search:
        """Prepare a search; nothing is found for an empty or a wrong pattern."""
        if not what:
            return cls()
        import regex

        flags = regex.MULTILINE | (0 if is_case_sensitive else regex.IGNORECASE)
        try:
            return cls(regex.compile(what if is_regex else regex.escape(what), flags), is_regex)
        except (regex.error, RecursionError, OverflowError) as error:
            return cls(problem=str(error))

    def run(self, text: bytes) -> None:
        """Find all matches now, as `find` does."""
        self.take(self.find(text))

    def take(self, found: Found) -> None:
        """Let what was found be what there is."""
        self.spans, self._matches = found.spans, found.matches
        if found.problem:
            self.pattern, self.problem = None, found.problem

    def find(self, text: bytes, is_stale: Callable[[], bool] = lambda: False) -> Found:
        """Return all matches, up to `MOST_MATCHES`; none where that takes longer than `TIME_LIMIT`.

        To an expression a line ends in a newline, whatever ends the lines of the text.

        Args:
            text: the text.
            is_stale: tells, now and then, that nobody wants to know any more.
        """
        if self.pattern is None:
            return Found()
        try:
            return _find(self.pattern, text, is_stale)
        except TimeoutError:
            return Found(problem="that expression takes too long")
        except MemoryError:
            return Found(problem="that expression takes too much memory")

    def within(self, start: int, end: int) -> list[tuple[int, int]]:
        """Return the matches that touch a range."""
        last = bisect_right(self.spans, (end, 0))
        first = bisect_left(self.spans, (start, 0))
        return self.spans[max(0, first - 1) : last]

    def step(self, offset: int, by: int) -> tuple[int, int] | None:
        """Return the match after an offset, or before it, around the text's end if need be."""
        if not self.spans:
            return None
        if by > 0:
            return self.spans[bisect_left(self.spans, (offset, 0)) % len(self.spans)]
        return self.spans[bisect_left(self.spans, (offset, 0)) - 1]

    def replaced(self, span: tuple[int, int], template: str) -> str:
        """Return what comes in a match's place; a regular expression's groups are filled in.

        Raises:
            ValueError: the template names a group that is not there.
        """
        at = bisect_left(self.spans, span)
        if not self.is_regex or at >= len(self.spans) or self.spans[at] != span:
            return template
        import regex

        try:
            return self._matches[at].expand(template)
        except (regex.error, IndexError) as error:
            raise ValueError(str(error)) from error


def _find(pattern: regex.Pattern[str], text: bytes, is_stale: Callable[[], bool]) -> Found:
    plain = text.replace(b"\r\n", b"\n")
    returns = _returns(text) if len(plain) < len(text) else []
    written = plain.decode("utf-8", "replace")
    is_ascii = len(written) == len(plain)
    at_char = at_byte = 0
    found = Found()
    for match in pattern.finditer(written, concurrent=True, timeout=TIME_LIMIT):
        start, end = match.span()
        if not is_ascii:
            at_byte += len(written[at_char:start].encode())
            at_char = start
            start, end = at_byte, at_byte + len(match.group().encode())
        if returns:
            start, end = (at + bisect_left(returns, at) for at in (start, end))
        found.spans.append((start, end))
        found.matches.append(match)
        if len(found.spans) >= MOST_MATCHES or is_stale():
            break
    return found


def _returns(text: bytes) -> list[int]:
    """Return the places of the newlines that follow a carriage return, in a text without those."""
    places: list[int] = []
    at = text.find(b"\r\n")
    while at >= 0:
        places.append(at - len(places))
        at = text.find(b"\r\n", at + 2)
    return places
