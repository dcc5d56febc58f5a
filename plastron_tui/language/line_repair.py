"""The fix of a line: what makes it a statement, where exactly one small change does.

What may have been meant is tried with the grammar itself. A fix that would leave a mistake on its
line is none, but for a word that is put right where the line merely is not all there yet. A wrong
fix is worse than none: what a statement would say otherwise than the line did (`repair_certainty`)
is not offered.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cached_property, lru_cache

from plastron_tui.diagnostics import Diagnostic, Edit, Fix, Span, codes

from .declaration import Declaration
from .grammar import new_parser
from .keywords import WORDS
from .line_mistakes import LineMistake, first_mistake
from .lowering import is_right
from .mistake_place import shown
from .repair_certainty import has_known_words, is_certain, keeps_undoing
from .repair_steps import MARKS, SIGNS, Likelihood, Step, steps
from .sentence_match import intended, match_sentence
from .tokens import UNCLOSED_STRING, UNKNOWN, Token, text_at, tokens_of

_LONGEST = 400
"""Bytes of a line that is tried with changes: a trial takes the time that the grammar takes."""

_UNREADABLE = frozenset({UNKNOWN, UNCLOSED_STRING})
"""What no change of words mends."""
_GOING_ON = SIGNS | {".", ",", "="}
"""What a line does not end with that is all there."""

_MOST_STEPS = 3
"""How many changes a fix may consist of."""
_MOST_TRIALS = 250
"""How many texts the grammar is asked about for one line."""
_MOST_EXPLAINED = 10
"""How many of the texts that a line may become are explained, to find their next mistake."""
_MOST_LINES = 4
"""How many texts, those that are right the farthest, are changed again in the next step."""


def fixed(
    source: bytes, tokens: Sequence[Token], mistake: LineMistake, *, is_tried: bool
) -> Diagnostic:
    """Return the mistake of a line with the fix that leaves none there, if there is one.

    Args:
        source: the program.
        tokens: those of the line.
        mistake: the first mistake of it.
        is_tried: whether changes are tried, where the mistake has no fix of its own that does.
    """
    found, remedy = mistake.diagnostic._replace(fix=None), mistake.diagnostic.fix
    start, end = tokens[0].start, tokens[-1].end
    line = source[start:end]
    unrepaired = found
    if b"\n" in line or b"/*" in line:
        return mistake.diagnostic
    if remedy is not None:
        if any(edit.span.start < start or edit.span.end > end for edit in remedy.edits):
            return mistake.diagnostic
        made = _Trial(_edited(line, remedy.edits, start))
        is_kept = keeps_undoing(tokens, made.tokens) and has_known_words(made.tokens)
        is_typed = _is_begun(tokens, mistake) and not is_spelling(mistake)
        if is_kept and made.is_right and not is_typed:
            return mistake.diagnostic
        # Of a line that is still being typed, what is written so far is put right.
        if is_kept and is_spelling(mistake) and made.is_unfinished:
            unrepaired = mistake.diagnostic
    if not is_tried or len(line) > _LONGEST or not _may_be_repaired(tokens, mistake):
        return unrepaired
    right = repaired(line)
    return unrepaired if right is None else _with_fix(found, source, _fix(line, right, start))


def is_spelling(mistake: LineMistake) -> bool:
    """Tell whether the remedy of a mistake is to write one word of the language for another."""
    fix = mistake.diagnostic.fix
    if fix is None or len(fix.edits) != 1 or fix.edits[0].span != mistake.diagnostic.span:
        return False
    return fix.edits[0].text in WORDS


def _may_be_repaired(tokens: Sequence[Token], mistake: LineMistake) -> bool:
    """Tell whether the grammar may guess; what variable is meant for a keyword, nobody knows."""
    if any(each.kind in _UNREADABLE and each.text not in MARKS | SIGNS for each in tokens):
        return False
    if tokens[-1].text in _GOING_ON or _is_begun(tokens, mistake):
        return False
    is_twice = text_at(tokens, mistake.at) == text_at(tokens, mistake.at - 1)
    return mistake.diagnostic.code != codes.KEYWORD_AS_VARIABLE or is_twice


def _is_begun(tokens: Sequence[Token], mistake: LineMistake) -> bool:
    """Tell whether the last word of a line may be one of the language that is still being typed."""
    last, wanted = tokens[-1].text, mistake.wanted
    if mistake.at < len(tokens) - 1 or (wanted is not None and wanted.is_quoted):
        return False
    return last not in WORDS and any(word.startswith(last) for word in WORDS)


def _with_fix(found: Diagnostic, source: bytes, fix: Fix) -> Diagnostic:
    """Return a mistake with its fix; where that says more than was known, it is explained by it."""
    ((span, text),) = fix.edits
    if found.code == codes.KEYWORD_AS_VARIABLE:
        return found._replace(help=fix.title, fix=fix)
    if found.code != codes.UNKNOWN_STATEMENT:
        return found._replace(fix=fix)
    found = found._replace(help=f"did you mean `{shown(text.strip())}`?", fix=fix)
    gone = source[span.start : span.end].decode("utf-8", "replace")
    if not gone or b" " in source[span.start : span.end]:
        return found
    return found._replace(message=f"`{shown(gone)}` starts no statement", span=span)


@lru_cache(maxsize=256)
def repaired(line: bytes) -> bytes | None:
    """Return the statement that a line was to be, None where none or several may be meant."""
    going_on = [_Trial(line)]
    tokens = going_on[0].tokens
    seen = {line}
    for _ in range(_MOST_STEPS):
        right: dict[bytes, Likelihood] = {}
        farther: list[_Trial] = []
        for trial in going_on:
            made_of_it: list[_Trial] = []
            for text, likelihood in trial.changed():
                if text in right:
                    right[text] = min(likelihood, right[text])
                if text in seen or len(seen) > _MOST_TRIALS:
                    continue
                seen.add(text)
                made = _Trial(text, likelihood)
                if made.is_right:
                    if is_certain(tokens, made.tokens):
                        right[text] = likelihood
                elif not right and trial.may_lead_to(made):
                    made_of_it.append(made)
            made_of_it.sort(key=lambda each: each.unmatched)
            farther += (each for each in made_of_it[:_MOST_EXPLAINED] if each.left < trial.left)
        if right:
            best = min(right.values())
            likeliest = [text for text, likelihood in right.items() if likelihood is best]
            return likeliest[0] if len(likeliest) == 1 else None
        going_on = sorted(farther, key=lambda each: each.left)[:_MOST_LINES]
    return None


class _Trial:
    """A line as it may have been meant."""

    def __init__(self, line: bytes, likelihood: Likelihood = Likelihood.PLAIN) -> None:
        self._line = line
        self._likelihood = likelihood
        self._root = new_parser().parse(line).root_node
        self.is_right = is_right(self._root, line)

    @cached_property
    def tokens(self) -> tuple[Token, ...]:
        """The words of the line."""
        return tuple(tokens_of(self._line, self._root.children))

    @cached_property
    def _mistake(self) -> LineMistake:
        return first_mistake(self._line, self.tokens, self._declaration)

    @cached_property
    def _declaration(self) -> Declaration | None:
        return intended(self.tokens)

    def may_lead_to(self, made: _Trial) -> bool:
        """Tell whether another change may follow the one that this line was made into a trial by.

        A statement that is merely guessed has to be right at once.
        """
        is_guessed = self._declaration is None and made._likelihood is not Likelihood.PLAIN
        # In values the mistake is behind what matches, and what is written makes them longer.
        most = max(self.left, self.unmatched + len(made._line) - len(self._line))
        return not is_guessed and made.unmatched <= most

    @cached_property
    def unmatched(self) -> int:
        """How many bytes are behind what matches the sentence; what is in its slots may be wrong.

        It is found far sooner than the first mistake is.
        """
        if self._declaration is None:
            return len(self._line)
        end = match_sentence(self._declaration, self.tokens).end
        return 0 if end == len(self.tokens) else len(self._line) - self.tokens[end].start

    @property
    def is_unfinished(self) -> bool:
        """Whether the line is right up to its end."""
        return self._mistake.at == len(self.tokens)

    @property
    def left(self) -> int:
        """How many bytes of the line are from its first mistake on."""
        at = self._mistake.at
        return 0 if at == len(self.tokens) else len(self._line) - self.tokens[at].start

    def changed(self) -> Iterator[tuple[bytes, Likelihood]]:
        """Yield what the line may be with one change at its first mistake."""
        mistake = self._mistake
        if mistake.diagnostic.fix is not None:
            text = _edited(self._line, mistake.diagnostic.fix.edits, 0)
            yield text, max(self._likelihood, Likelihood.POSSIBLE)
        is_spelt = is_spelling(mistake) and self._declaration is not None
        for step in steps(self.tokens, mistake):
            if is_spelt and (not step.text or step.first == step.end):
                # What is near a word of the sentence is no value.
                continue
            yield self._with(step), max(self._likelihood, step.likelihood)

    def _with(self, step: Step) -> bytes:
        """Return the line after a step, with one space around what is written."""
        tokens, line = self.tokens, self._line
        before = line[: tokens[step.first - 1].end] if step.first else b""
        after = line[tokens[step.end].start :] if step.end < len(tokens) else b""
        text = step.text.encode()
        made = before + text if step.joins else _joined(before, text)
        return made + after if step.joins == "both" else _joined(made, after)


def _joined(before: bytes, after: bytes) -> bytes:
    return before + b" " + after if before and after else before + after


def _edited(line: bytes, edits: Sequence[Edit], start: int) -> bytes:
    """Return a line that begins at a place of the program with edits of the program made."""
    for edit in sorted(edits, key=lambda each: each.span, reverse=True):
        first, end = edit.span.moved(-start)
        line = line[:first] + edit.text.encode() + line[end:]
    return line


def _fix(line: bytes, right: bytes, start: int) -> Fix:
    """Return the edit that makes a line another one, in whole words."""
    least = min(len(line), len(right))
    first = next((at for at in range(least) if line[at] != right[at]), least)
    while _is_in_word(line, first) or _is_in_word(right, first):
        first -= 1
    most = least - first
    same = next((at for at in range(most) if line[~at] != right[~at]), most)
    while _is_in_word(line, len(line) - same) or _is_in_word(right, len(right) - same):
        same -= 1
    gone, text = line[first : len(line) - same], right[first : len(right) - same].decode()
    span = Span(start + first, start + first + len(gone))
    title = f"write `{shown(text.strip())}`"
    if not text.strip():
        title = f"take `{shown(gone.decode().strip())}` away"
    elif not gone and same and text.strip() != ",":
        title += " before it"
    return Fix(title, (Edit(span, text),))


def _is_in_word(line: bytes, at: int) -> bool:
    """Tell whether a place is within a word, where no edit should begin or end."""
    return 0 < at < len(line) and _is_of_word(line[at - 1]) and _is_of_word(line[at])


def _is_of_word(byte: int) -> bool:
    return byte >= 0x80 or byte == ord("_") or chr(byte).isalnum()
