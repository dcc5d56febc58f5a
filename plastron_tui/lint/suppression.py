"""Comments that say of a line that what breaks a rule there is meant.

`# noqa: RG101` in Python, YAML and CMake; `// NOLINT(RG101)` in C++, `NOLINTNEXTLINE` for the line
below, `NOLINTBEGIN` and `NOLINTEND` for the lines between; `<!-- noqa: RK501 -->` in XML, in a line
of its own for the tag below; `// noqa: RG101` in programs. Without codes a comment is about all
rules, those of other linters too.
"""

from __future__ import annotations

import re
from bisect import bisect_right
from collections import defaultdict
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import NamedTuple

from plastron_tui.diagnostics import LineIndex, Span
from plastron_tui.sources.splices import line_start

from .comment_syntax import CommentStyle, comment_spans, style_of, tag_behind
from .rule import Group, Rule

_WORD_TEXT = rb"(?:[A-Za-z]\w*(?:-\w+)*|\*)"
_CODES = _WORD_TEXT + rb"(?:[ \t]*[, \t][ \t]*" + _WORD_TEXT + rb")*"
_NOQA = re.compile(
    rb"(?:\#|//|<!--)[ \t]*noqa(?![\w-])(?P<colon>[ \t]*:[ \t]*(?P<codes>" + _CODES + rb")?)?", re.I
)
_NOLINT = re.compile(
    rb"\bNOLINT(?P<kind>NEXTLINE|BEGIN|END)?(?![\w-])(?P<colon>\((?P<codes>[^)\r\n]*)\))?"
)
_WORD = re.compile(_WORD_TEXT)
_SIGN = re.compile(rb"noqa|NOLINT", re.I)
_NAME = re.compile(rb"\bR[A-Z][0-9]{3}|[a-z]-[a-z]", re.I)
_CODE = re.compile(r"[A-Z]+[0-9]+")
_OURS = re.compile(rf"(?:{'|'.join(each.value for each in Group)})[0-9]{{3}}", re.I)


class Comment(NamedTuple):
    """A comment about rules.

    Attributes:
        span: from its sign to its last code.
        first: the first line that it is about.
        last: the last one.
        codes: what it names, each with its place; None where it is about all rules.
        around: the whole comment, of which it may be a part.
    """

    span: Span
    first: int
    last: int
    codes: tuple[tuple[str, Span], ...] | None
    around: Span

    def is_about(self, rule: Rule) -> bool:
        """Tell whether it names a rule, or all of them."""
        return self.codes is None or any(_means(word, rule) for word, _ in self.codes)

    def covers(self, lines: LineIndex, span: Span) -> bool:
        """Tell whether a place begins or ends in a line that it is about."""
        return any(self.first <= each <= self.last for each in ends_of(lines, span))


def ends_of(lines: LineIndex, span: Span) -> tuple[int, int]:
    """Return the lines in which a place begins and ends."""
    return lines.line_at(span.start), lines.line_at(max(span.start, span.end - 1))


def may_have_comments(text: bytes) -> bool:
    """Tell whether a text has such comments at all."""
    return b"NOLINT" in text or b"noqa" in text or b"noqa" in text.lower()


def may_name_rules(text: bytes) -> bool:
    """Tell whether a comment of a text may name a rule, by its code or its name."""
    return may_have_comments(text) and any(
        _NAME.search(line, sign.end()) is not None
        for line in text.split(b"\n")
        if (sign := _SIGN.search(line)) is not None
    )


def comments_of(file: Path, text: bytes, lines: LineIndex) -> tuple[Comment, ...]:
    """Return the comments of a file about rules, in the order in which they begin or end lines."""
    style = style_of(file, text) if may_have_comments(text) else None
    if style is None:
        return ()
    real = comment_spans(style, text)
    if style is CommentStyle.CPP:
        return tuple(_nolints(_within(real, _NOLINT.finditer(text)), lines))
    found = _within(real, _NOQA.finditer(text))
    return tuple(_noqa(match, around, style, text, lines) for match, around in found)


def _within(
    real: tuple[Span, ...], found: Iterable[re.Match[bytes]]
) -> Iterator[tuple[re.Match[bytes], Span]]:
    """Yield what is within comments, each with the whole comment."""
    starts = [each.start for each in real]
    for each in found:
        at = bisect_right(starts, each.start()) - 1
        if at >= 0 and each.end() <= real[at].end:
            yield each, real[at]


class FileComments:
    """The comments of a file about rules, and which of them something was found for.

    Attributes:
        all: the comments.
        used: those that said of what breaks a rule that it is meant.
    """

    def __init__(self, file: Path, text: bytes, lines: LineIndex) -> None:
        """Find them in a text."""
        self._lines = lines
        self.all = comments_of(file, text, lines)
        self.used: set[tuple[Comment, Rule]] = set()
        self._in_line: dict[int, list[Comment]] = defaultdict(list)
        for each in self.all:
            if each.first == each.last:
                self._in_line[each.first].append(each)
        self._wide = [each for each in self.all if each.first != each.last]
        self._known: dict[tuple[int, Rule], bool] = {}

    def mean(self, rule: Rule, span: Span | None) -> bool:
        """Tell whether they say that what breaks a rule at a place is meant."""
        if span is None or not self.all:
            return False
        # The comments of both lines are used.
        first, last = [self._mean(rule, line) for line in ends_of(self._lines, span)]
        return first or last

    def _mean(self, rule: Rule, line: int) -> bool:
        key = line, rule
        if key not in self._known:
            here = [each for each in self._wide if each.first <= line <= each.last]
            about = [each for each in (*self._in_line[line], *here) if each.is_about(rule)]
            self.used.update((each, rule) for each in about)
            self._known[key] = bool(about)
        return self._known[key]


def _nolints(
    matches: Iterable[tuple[re.Match[bytes], Span]], lines: LineIndex
) -> Iterator[Comment]:
    """Yield the comments of C++; one that begins lines counts where another one ends them."""
    begun: dict[tuple[str, ...], Comment] = {}
    for found, around in matches:
        line = lines.line_at(found.start())
        named = None if found["colon"] is None else tuple(_codes(found))
        words = tuple(word for word, _ in named or ())
        match found["kind"]:
            case b"BEGIN":
                begun[words] = Comment(Span(*found.span()), line, line, named, around)
            case b"END":
                if (begin := begun.pop(words, None)) is not None:
                    yield begin._replace(last=line)
            case b"NEXTLINE":
                yield Comment(Span(*found.span()), line + 1, line + 1, named, around)
            case _:
                yield Comment(Span(*found.span()), line, line, named, around)


def _noqa(
    match: re.Match[bytes], around: Span, style: CommentStyle, text: bytes, lines: LineIndex
) -> Comment:
    first = last = lines.line_at(match.start())
    if style is CommentStyle.XML:
        first, last = _lines_in_xml(around, text, lines, first)
    codes = None if match["colon"] is None else tuple(_codes(match))
    return Comment(Span(*match.span()), first, last, codes, around)


def _codes(match: re.Match[bytes]) -> Iterator[tuple[str, Span]]:
    start = match.start("codes")
    for word in _WORD.finditer(match["codes"] or b""):
        yield word[0].decode(), Span(start + word.start(), start + word.end())


def _lines_in_xml(comment: Span, text: bytes, lines: LineIndex, line: int) -> tuple[int, int]:
    """Return the lines that a comment of XML is about: its own, or those of the tag below."""
    tag = tag_behind(text, comment.end)
    before = text[line_start(text, comment.start) : comment.start]
    if before.strip() or tag is None or b"\n" not in text[comment.end : tag.start]:
        return line, line
    return lines.line_at(tag.start), lines.line_at(tag.end - 1)


def _means(word: str, rule: Rule) -> bool:
    """Tell whether a word of a comment means a rule; words of prose may stand behind the codes."""
    if word == "*" or word == rule.name or word.upper() == rule.code:
        return True
    return len(word) > 1 and word.isupper() and rule.code.startswith(word)


def named_rules(comment: Comment, rules: Iterable[Rule]) -> list[tuple[Rule, Span]]:
    """Return the rules that a comment names one by one, by code or by name."""
    return [
        (rule, span)
        for word, span in comment.codes or ()
        for rule in rules
        if word.upper() == rule.code or word == rule.name
    ]


def unknown_codes(comment: Comment, rules: Iterable[Rule]) -> list[tuple[str, Span]]:
    """Return the words of a comment that look like codes of rules, and are none's."""
    known = {str(rule.code) for rule in rules}
    return [
        (word.upper(), span)
        for word, span in comment.codes or ()
        if _OURS.fullmatch(word) and word.upper() not in known
    ]


def with_codes(comment: Comment, codes: str, style: CommentStyle) -> tuple[int, str]:
    """Return where more codes go into a comment that names some, and how they are written there."""
    known = [span for word, span in comment.codes or () if _CODE.fullmatch(word)]
    if known:
        return known[-1].end, f", {codes}"
    end = comment.span.end - 1 if style is CommentStyle.CPP else comment.span.end
    return end, f", {codes}" if comment.codes else codes
