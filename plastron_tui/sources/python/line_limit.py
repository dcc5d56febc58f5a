"""How long a line that an edit writes may be: as settings say it, or as the file's others are."""

from __future__ import annotations

import re
from collections import Counter, defaultdict
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from itertools import pairwise

from .line_length import ROS_1, ROS_2

# PEP 8, black, and what teams agree on.
_USUAL = (ROS_1, 88, 100, 120)
# So many lines may be longer than what a file keeps to.
_FEW = 2
# So many calls that would fit on a line tell that a file keeps to less.
_SEVERAL = 2
_MOST_ROWS = 12
# A line that a word more makes too long is left as it is where nobody said what is too long.
_WORD = 12

_SUBJECT = re.compile(r"(?:async\s+)?(?:(def|class|from|import)\b|[^#'\"(]*?\b(\w+)\()")
# What is said in so many letters does not tell how long a line of code may be.
_PROSE = re.compile(r"""(["'])(?=(?:(?!\1).)*\s)(?:(?!\1).){40,}\1|\s#\s""")
_TRIPLE = re.compile(r"\"{3}|'{3}")
_OPEN, _CLOSED = re.compile(r"[(\[{]"), re.compile(r"[)\]}]")


@dataclass(frozen=True, slots=True)
class LineLimit:
    """How long the lines of a file may be.

    Attributes:
        length: what the settings around the file say, or what it keeps to.
        slack: how much more a line may have that was there, and of which a word changed.
        longest: by what a line calls or defines, how long it may be as the file has others.
    """

    length: int
    slack: int = 0
    longest: Mapping[str, int] = field(default_factory=dict)

    def allows(self, line: str) -> bool:
        """Whether a line is short enough, or as long as others of the file that do the same."""
        return len(line) <= max(self.length, self.longest.get(_subject(line), 0))

    def allows_instead(self, line: str, old: str) -> bool:
        """Whether a line may stand for an old one, by the length of both."""
        return len(old) > self.length or len(line) <= self.length + self.slack


def line_limit(text: bytes, library: str, said: int | None) -> LineLimit:
    """Find out how long the lines of a file may be.

    Args:
        text: the file.
        library: its client library.
        said: what the settings around it say, None where they say nothing.
    """
    if said is not None:
        return LineLimit(said)
    lines = text.decode("utf-8", "replace").splitlines()
    code, prose = list(_code(lines)), list(_prose(lines))
    allowed = ROS_2 if library == "rclpy" else ROS_1
    lengths = sorted(map(len, code), reverse=True)
    longest = next(iter(lengths[_FEW:]), 0)
    length = next((each for each in (allowed, *_USUAL) if longest <= each >= allowed), _USUAL[-1])
    if longest <= allowed:
        length = _kept_to(code, prose, allowed)
    # A file whose longest line nearly has that length is kept to it.
    least = 0 if length == ROS_2 else length - _WORD
    is_checked = length == allowed and least < lengths[0] <= length if lengths else False
    return LineLimit(length, 0 if is_checked else _WORD, _longest(code, length))


def _code(lines: list[str]) -> Iterator[str]:
    """Yield the lines of a text that a comment, a docstring or a long string is not all of."""
    is_prose = False
    for line in lines:
        is_begun = len(_TRIPLE.findall(line)) % 2 == 1
        if not (is_prose or is_begun or line.lstrip().startswith("#") or _PROSE.search(line)):
            yield line.rstrip()
        is_prose = is_prose != is_begun


def _prose(lines: list[str]) -> Iterator[str]:
    """Yield the lines below the first import that comments, or texts of several lines, are."""
    is_text = is_below = False
    for line in lines:
        is_below = is_below or line.startswith(("import ", "from "))
        is_end = len(_TRIPLE.findall(line)) % 2 == 1
        if is_below and (is_text or line.lstrip().startswith("#")):
            yield line.rstrip()
        is_text = is_text != is_end


def _kept_to(code: list[str], prose: list[str], allowed: int) -> int:
    """Return the limit below the allowed one for which a file breaks what would fit, if any."""
    longest, widest = (max(map(len, each), default=0) for each in (code, prose))
    calls = [len(each) for each in _rejoined(code)]
    # What is filled ends where the next word would not fit.
    words = [len(above) + 1 + len(_first(below)) for above, below in pairwise(prose)]
    for each in _USUAL:
        is_filled = widest <= each and _lie_between(words, each, allowed)
        if longest <= each < allowed and (is_filled or _lie_between(calls, each, allowed)):
            return each
    return allowed


def _first(line: str) -> str:
    """Return the first word of a line of prose."""
    return next(iter(line.strip("# \t").split()), "")


def _lie_between(lengths: list[int], least: int, most: int) -> bool:
    return sum(least < each <= most for each in lengths) >= _SEVERAL


def _rejoined(code: list[str]) -> Iterator[str]:
    """Yield each statement that brackets break, on one line."""
    for at, first in enumerate(code):
        whole = first
        for line in code[at + 1 : at + _MOST_ROWS] if _is_open(first) else ():
            if "#" in whole:
                break
            part = line.strip()
            if _CLOSED.match(part):
                whole = whole.removesuffix(",") + part
            else:
                whole += part if whole[-1:] in "([{" else f" {part}"
            if not _is_open(whole):
                yield whole
                break


def _longest(code: list[str], limit: int) -> dict[str, int]:
    """Return how long lines of a subject may be where most of them are too long, not broken."""
    broken = Counter(_subject(line) for line in code if _is_open(line))
    found = defaultdict[str, list[int]](list)
    for line in code:
        if len(line) > limit and not _is_open(line):
            found[_subject(line)].append(len(line))
    return {
        subject: max(lengths) + _WORD
        for subject, lengths in found.items()
        if subject and len(lengths) >= broken[subject]
    }


def _is_open(line: str) -> bool:
    return len(_OPEN.findall(line)) > len(_CLOSED.findall(line))


def _subject(line: str) -> str:
    """Return what a line defines or calls first: `def`, `import`, `create_timer`, "" for none."""
    found = _SUBJECT.match(line.lstrip())
    return (found[1] or found[2]) if found is not None else ""
