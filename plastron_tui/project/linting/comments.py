"""The files that findings are about: their texts, and their comments about rules."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator
from pathlib import Path

from plastron_tui.diagnostics import Diagnostic, Edit, Fix, LineIndex, Span, codes
from plastron_tui.lint import Found, Rule
from plastron_tui.lint.comment_syntax import comment_spans, style_of
from plastron_tui.lint.rule import RULES, rule_of
from plastron_tui.lint.suppression import (
    Comment,
    comments_of,
    named_rules,
)
from plastron_tui.model.source import LARGEST_FILE
from plastron_tui.regular_files import read_regular


class FileTexts:
    """What files hold, each read once, and which of their comments something was found for."""

    def __init__(self) -> None:
        self._texts: dict[Path, bytes | None] = {}
        self._indexes: dict[Path, LineIndex | None] = {}
        self._comments: dict[Path, tuple[Comment, ...]] = {}
        self._used: set[tuple[Path, Comment, Rule]] = set()

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
        file, span = found.diagnostic.file, found.diagnostic.span
        lines = self.lines(file)
        if file is None or span is None or lines is None:
            return False
        about = [
            each
            for each in self._comments_of(file)
            if each.covers(lines, span) and each.is_about(found.rule)
        ]
        self._used.update((file, each, found.rule) for each in about)
        return bool(about)

    def unused(self, files: Iterable[str], rules: Collection[Rule]) -> Iterator[Found]:
        """Yield the codes of comments that nothing breaks in their lines.

        Args:
            files: the files that may have such comments.
            rules: the rules that are followed: of others nobody knows.
        """
        for path in map(Path, files):
            style = style_of(path)
            text = self.text(path)
            if style is None or text is None:
                continue
            spans = list(comment_spans(style, text))
            for comment in self._comments_of(path):
                around = next((x for x in spans if x.start <= comment.span.start < x.end), None)
                if around is not None:
                    yield from self._unused_in(path, text, comment, around, rules)

    def _unused_in(
        self, path: Path, text: bytes, comment: Comment, around: Span, rules: Collection[Rule]
    ) -> Iterator[Found]:
        unused = [
            (rule, span)
            for rule, span in named_rules(comment, tuple(RULES.values()))
            if rule in rules and (path, comment, rule) not in self._used
        ]
        fix = None
        if len(unused) == len(comment.codes or ()) and _is_whole(text, comment, around):
            blanks = text[: around.start]
            start = len(blanks.rstrip(b" \t"))
            fix = Fix("take the comment away", (Edit(Span(start, around.end), ""),))
        for rule, span in unused:
            message = f"nothing breaks `{rule.code}` ({rule.name}) here"
            remedy = "take the code, or the comment, away"
            found = Diagnostic(codes.UNUSED_NOQA, message, span, path, remedy, fix)
            yield Found(rule_of(codes.UNUSED_NOQA), found)

    def _comments_of(self, file: Path) -> tuple[Comment, ...]:
        if file not in self._comments:
            text, lines = self.text(file), self.lines(file)
            self._comments[file] = (
                () if text is None or lines is None else comments_of(file, text, lines)
            )
        return self._comments[file]


def _read(file: Path) -> bytes | None:
    try:
        return read_regular(file, LARGEST_FILE)
    except (OSError, ValueError):
        return None


def _is_whole(text: bytes, comment: Comment, around: Span) -> bool:
    """Tell whether a comment says nothing but which rules are meant to be broken."""
    before = text[around.start : comment.span.start].strip(b"/ \t")
    after = text[comment.span.end : around.end].removesuffix(b"-->").strip()
    is_alone = not text[text.rfind(b"\n", 0, around.start) + 1 : around.start].strip()
    return not before and not after and not is_alone
