"""The files that findings are about: their texts, and their comments about rules."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator
from pathlib import Path

from plastron_tui.diagnostics import Diagnostic, Edit, Fix, LineIndex, Span, codes
from plastron_tui.lint import Found, Rule
from plastron_tui.lint.rule import RULES, rule_of
from plastron_tui.lint.suppression import Comment, FileComments, named_rules, unknown_codes
from plastron_tui.model.source import LARGEST_FILE
from plastron_tui.regular_files import read_regular
from plastron_tui.sources.splices import line_start


class FileTexts:
    """What files hold, each read once, and which of their comments something was found for."""

    def __init__(self) -> None:
        self._texts: dict[Path, bytes | None] = {}
        self._indexes: dict[Path, LineIndex | None] = {}
        self._comments: dict[Path, FileComments | None] = {}

    def text(self, file: Path) -> bytes | None:
        """Return what a file holds, None where it cannot be read."""
        if file not in self._texts:
            self._texts[file] = _read(file)
        return self._texts[file]

    def lines(self, file: Path | None) -> LineIndex | None:
        """Return the lines of a file, None where it cannot be read."""
        if file is None:
            return None
        if file not in self._indexes:
            text = self.text(file)
            self._indexes[file] = None if text is None else LineIndex(text)
        return self._indexes[file]

    def is_meant(self, found: Found) -> bool:
        """Tell whether a comment says that what breaks a rule is meant."""
        file = found.diagnostic.file
        comments = None if file is None else self._comments_of(file)
        return comments is not None and comments.mean(found.rule, found.diagnostic.span)

    def unused(self, files: Iterable[str], rules: Collection[Rule]) -> Iterator[Found]:
        """Yield the codes of comments that nothing breaks in their lines, or that no rule has.

        Args:
            files: the files that may have such comments.
            rules: the rules that are followed: of others nobody knows.
        """
        for path in map(Path, files):
            text, comments = self.text(path), self._comments_of(path)
            if text is not None and comments is not None:
                for comment in comments.all:
                    if comment.codes:
                        left = [rule for rule in rules if (comment, rule) not in comments.used]
                        yield from _unused_in(path, text, comment, left)

    def _comments_of(self, file: Path) -> FileComments | None:
        if file not in self._comments:
            text, lines = self.text(file), self.lines(file)
            self._comments[file] = (
                None if text is None or lines is None else FileComments(file, text, lines)
            )
        return self._comments[file]


def _unused_in(
    path: Path, text: bytes, comment: Comment, rules: Collection[Rule]
) -> Iterator[Found]:
    """Yield the codes of a comment that no rule has, or whose rules nothing breaks in its lines."""
    unused = [
        (span, f"nothing breaks `{rule.code}` ({rule.name}) here")
        for rule, span in named_rules(comment, RULES.values())
        if rule in rules
    ]
    unused += [
        (span, f"there is no rule `{code}`")
        for code, span in unknown_codes(comment, RULES.values())
    ]
    fix = None
    if len(unused) == len(comment.codes or ()) and _is_whole(text, comment):
        fix = Fix("take the comment away", (Edit(_with_blanks(text, comment.around), ""),))
    for span, message in unused:
        remedy = "take the code, or the comment, away"
        found = Diagnostic(codes.UNUSED_NOQA, message, span, path, remedy, fix)
        yield Found(rule_of(codes.UNUSED_NOQA), found)


def _with_blanks(text: bytes, comment: Span) -> Span:
    """Return a comment with the blanks around it, where they end the line: elsewhere they count."""
    start, end = comment
    while text[end : end + 1] in (b" ", b"\t"):
        end += 1
    if text[end : end + 1] not in (b"", b"\r", b"\n"):
        return comment
    while start and text[start - 1 : start] in (b" ", b"\t"):
        start -= 1
    return Span(start, end)


def _read(file: Path) -> bytes | None:
    try:
        return read_regular(file, LARGEST_FILE)
    except (OSError, ValueError):
        return None


def _is_whole(text: bytes, comment: Comment) -> bool:
    """Tell whether a comment says nothing but which rules are meant to be broken."""
    around = comment.around
    before = text[around.start : comment.span.start].strip(b"/ \t")
    after = text[comment.span.end : around.end].removesuffix(b"-->").strip()
    line = text[line_start(text, around.start) : around.start].strip()
    is_pair = text.startswith(b"NOLINTBEGIN", comment.span.start)
    # A backslash that ends a line means more than one with a comment behind it.
    return not (before or after or is_pair or not line or line.endswith(b"\\"))
