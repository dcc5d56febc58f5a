"""Common slips of the pen: what a line's first mistake looks like, and what was meant.

Each slip is a function in `_SLIPS`: it looks at the place of a mistake, and either recognises it
and says what to write, or returns None. What none recognises keeps the diagnostic that it has.
"""

from __future__ import annotations

import re
from collections.abc import Callable

from plastron_tui.diagnostics import Diagnostic, Edit, Fix, Span, codes

from .declaration import Form, SlotKind
from .field_mistakes import FIELD_SLIPS
from .keywords import BY_KEYWORD, FIRST_WORDS, KEYWORDS, VERBS
from .limit_mistakes import bounds
from .mistake_place import Place, mended, unquoted
from .number_mistakes import LEFT_OUT
from .robot_mistakes import ROBOT_SLIPS
from .tokens import QUOTED_KINDS, UNKNOWN, WORD_KINDS, is_glued, text_at
from .value_mistakes import VALUE_SLIPS
from .variable_mistakes import variable_left_out

_WORD = re.compile(r"[A-Za-z][A-Za-z0-9_]*")
_TYPE = re.compile(r"[A-Za-z]\w*(/(msg/|srv/)?[A-Za-z]\w*)?", re.ASCII)

_NUMBER = re.compile(r"[+-]?\d+(\.\d*)?")

# Opening quotes of word processors, with those that close them, and the straight ones.
_QUOTES = {"‘": ("’", "'"), "’": ("’", "'"), "“": ("”", '"'), "”": ("”", '"'), "„": ("“”", '"')}

_MOST_PARTS = max(word.count("_") for word in KEYWORDS) + 1
"""How many words the longest keyword is made of."""

_FOR_WHOM = "write first whose messages it is for: `for_each 'TOPIC_NAME'`"

# What a word is made of where only one of these numbers begins it.
_PREFIXES = {SlotKind.NEW_MESSAGE: "message", SlotKind.MESSAGE: "message", SlotKind.FUNCTION: "on"}


def recognised(place: Place, found: Diagnostic) -> Diagnostic:
    """Return what a mistake is, where it is a common slip; else the diagnostic as it was."""
    for slip in _SLIPS:
        better = slip(place, found)
        if better is not None:
            return better
    return found


def completed(place: Place, found: Diagnostic) -> Diagnostic:
    """Return what a line lacks that ends too early, where it is a common slip.

    Args:
        place: the place behind the last word.
        found: what is wrong so far.
    """
    slips = (*LEFT_OUT, variable_left_out)
    return next(filter(None, (slip(place, found) for slip in slips)), found)


def _comment(place: Place, found: Diagnostic) -> Diagnostic | None:
    start = place.token.start
    mark = "#" if place.token.text[0] == "#" else "--"
    following = place.source[start : start + 3].decode("utf-8", "replace")
    if place.token.kind != UNKNOWN or not following.startswith(mark) or following[2:].isdigit():
        return None
    return mended(found, "a comment starts with `//`", Span(start, start + len(mark)), "//")


def _quotes(place: Place, found: Diagnostic) -> Diagnostic | None:
    token = place.token
    if token.kind != UNKNOWN or token.text[0] not in _QUOTES:
        return None
    closing, straight = _QUOTES[token.text[0]]
    wanted = place.wanted
    if wanted is not None and wanted.form in (Form.QUOTED, Form.FILE):
        straight = "'"
    start = token.start + len(token.text[0].encode())
    line = place.source[start : place.tokens[-1].end].decode("utf-8", "replace")
    text = re.match(f"[^{closing}{straight}\\\\]*(?=[{closing}{straight}])", line)
    what = "quotes are straight"
    if text is None:
        return found._replace(message=what, help=f"write {straight}")
    span = Span(token.start, start + len(text[0].encode()))
    end = span.end + len(line[text.end()].encode())
    right = f"{straight}{text[0]}{straight}"
    return found._replace(
        code=codes.SYNTAX_ERROR,
        message=what,
        span=Span(token.start, end),
        help=f"write {right}",
        fix=Fix("write straight quotes", (Edit(Span(token.start, end), right),)),
    )


def _unclosed(place: Place, found: Diagnostic) -> Diagnostic | None:
    """Find where a quote is to be closed: a name is one word, a text goes on to the line's end."""
    if found.code != codes.UNCLOSED_QUOTE or found.span is None:
        return None
    quote, start = place.token.text[0], found.span.end
    line = place.source[start:].partition(b"\n")[0].decode("utf-8", "replace").rstrip()
    length = len(line)
    if quote == "'":
        is_file = place.wanted is not None and place.wanted.form is Form.FILE
        word = re.match(r"[^\s']+" if is_file else r"[\w/~{}]+", line)
        if word is None:
            return None
        length = word.end()
    elif line.endswith("\\"):
        return None
    end = start + len(line[:length].encode())
    return found._replace(fix=Fix(f"close it with {quote}", (Edit(Span(end, end), quote),)))


def _closed_late(place: Place, found: Diagnostic) -> Diagnostic | None:
    """Recognise `'a of … 'b'`, where the next name's quote closes the one that is open."""
    before, declaration = place.before, place.declaration
    if before is None or declaration is None or before.kind not in QUOTED_KINDS:
        return None
    name, *rest = before.text[1:-1].split(" ")
    parts = (declaration.elements, *(clause.elements for clause in declaration.clauses))
    if not name or not rest or not any(rest[0] in each for each in parts):
        return None
    end = before.start + 1 + len(name.encode())
    return found._replace(
        code=codes.UNCLOSED_QUOTE,
        message="the quote is closed too late: '",
        span=Span(before.start, before.start + 1),
        help="close it with '",
        fix=Fix("close it with '", (Edit(Span(end, end), "'"),)),
    )


def _mark(place: Place, found: Diagnostic) -> Diagnostic | None:
    """Recognise marks that other languages want, and this one does not."""
    token, before = place.token, place.tokens[place.at - 1]
    if token.text == ";":
        if place.at + 1 < len(place.tokens):
            help_ = "write each statement on a line of its own"
            return found._replace(message="a statement ends with its line", help=help_, fix=None)
        return mended(found, "a statement ends with its line, without a `;`", token.span, "")
    if token.text == "%" and place.at and before.kind == "number":
        span = Span(before.start, token.end)
        return mended(found, "a number has no unit", span, before.text)
    is_call = token.text == "(" and text_at(place.tokens, place.at + 1) == ")"
    if is_call and is_glued(place.tokens, place.at):
        span = Span(token.start, place.tokens[place.at + 1].end)
        return mended(found, "a function is given by its name alone", span, "")
    if token.text == "\N{NO-BREAK SPACE}":
        return found._replace(
            message="this is a no-break space, not a plain one",
            help="write a plain space",
            fix=Fix("write a plain space", (Edit(token.span, " "),)),
        )
    return None


def _path(place: Place, found: Diagnostic) -> Diagnostic | None:
    """Recognise `urdf/rover.urdf` without its quotes."""
    wanted = place.wanted
    if wanted is None or not wanted.is_quoted or place.token.kind not in WORD_KINDS:
        return None
    first, last = place.run("./-")
    text = place.written(first, last)
    if not {*text} & {".", "/"}:
        return None
    return unquoted(f"expected {wanted.words}", place.span(first, last), text)


def _hyphen(place: Place, found: Diagnostic) -> Diagnostic | None:
    """Recognise `my-node`."""
    first, last = place.run("-")
    word = "".join(token.text for token in place.tokens[first:last])
    right = word.replace("-", "_")
    if "-" not in word or not _WORD.fullmatch(right) or right.endswith("_"):
        return None
    span = Span(place.tokens[first].start, place.tokens[last - 1].end)
    return mended(found, "a word has letters, digits and `_`, and no `-`", span, right)


def _number_first(place: Place, found: Diagnostic) -> Diagnostic | None:
    """Recognise `1a` where a variable is wanted."""
    wanted = place.wanted
    if wanted is None or not (wanted.is_variable or wanted is SlotKind.FUNCTION):
        return None
    first, last = place.run("")
    word = "".join(token.text for token in place.tokens[first:last])
    right = f"{_PREFIXES.get(wanted, 'node')}_{word}"
    if not word[0].isdigit() or not _WORD.fullmatch(right):
        return None
    span = Span(place.token.start, place.tokens[last - 1].end)
    what = "function" if wanted is SlotKind.FUNCTION else "variable"
    return mended(found, f"a {what} starts with a letter", span, right)


def _type_of_python(place: Place, found: Diagnostic) -> Diagnostic | None:
    """Recognise `geometry_msgs.msg.Twist`, and the same with `::`."""
    first, last = place.run(".:/")
    wanted = place.slots.get(first)
    if wanted is None or wanted.form is not Form.TYPE:
        return None
    word = "".join(token.text for token in place.tokens[first:last])
    parts = [part for part in re.split(r"[.:/]+", word) if part not in ("msg", "srv")]
    if len(parts) != 2 or not all(map(_WORD.fullmatch, parts)) or not set(word) & {".", ":"}:
        return None
    span = Span(place.tokens[first].start, place.tokens[last - 1].end)
    return mended(found, "a type is written with `/`", span, "/".join(parts))


def _quoted(place: Place, found: Diagnostic) -> Diagnostic | None:
    """Recognise quotes around what has none."""
    token, wanted = place.token, place.wanted
    if wanted is None or (token.kind not in QUOTED_KINDS and token.kind != "string"):
        return None
    text = token.text[1:-1]
    if wanted.form is Form.RATE:
        right = f"parameter '{text}'"
        return mended(found, "a rate has the word `parameter` before the name", token.span, right)
    if wanted.form is Form.TEXT:
        return mended(found, "a text is in double quotes", token.span, f'"{text}"')
    if wanted.form is Form.FILE:
        right = f"'{text}'"
        return found._replace(
            message="a path is in single quotes",
            help=f"write {right}",
            fix=Fix("put it in single quotes", (Edit(token.span, right),)),
        )
    if wanted.form in (Form.QUOTED, Form.VALUES, Form.VECTOR):
        return None
    pattern = {Form.TYPE: _TYPE, Form.NUMBER: _NUMBER}.get(wanted.form, _WORD)
    if pattern.fullmatch(text) and text not in KEYWORDS:
        what = wanted.words.partition(",")[0]
        verb = "have" if wanted.form is Form.QOS else "has"
        return mended(found, f"{what} {verb} no quotes", token.span, text)
    if wanted is SlotKind.MESSAGE:
        return found._replace(help="make a message first, with `create_message`, and name it here")
    return None


def _swapped(place: Place, found: Diagnostic) -> Diagnostic | None:
    """Recognise a keyword that comes second where it comes first, or first where second."""
    tokens = place.tokens
    first, second = text_at(tokens, 0), text_at(tokens, 1)
    if place.at != 0 or not place.is_name(1 if first in VERBS else 0):
        return None
    is_late = second in FIRST_WORDS and _takes(second, 0, SlotKind.NODE) and not place.is_name(2)
    is_early = first in VERBS and (place.is_name(2) or not _takes(first, 1, SlotKind.MESSAGE))
    if not is_late and not is_early:
        return None
    keyword = second if is_late else first
    where = "first, before" if is_late else "second, after"
    owner = BY_KEYWORD[keyword].slots[0].kind.words.replace(" of a ", " of the ")
    message = f"`{keyword}` comes {where} {owner}"
    span = Span(tokens[0].start, tokens[1].end)
    return mended(found, message, span, f"{second} {first}")


def _point(place: Place, found: Diagnostic) -> Diagnostic | None:
    """Recognise `rover.has_link 'base'`."""
    tokens = place.tokens
    is_point = text_at(tokens, 1) == "." and text_at(tokens, 2) in VERBS
    if place.at != 0 or not is_point or not place.is_name(0):
        return None
    verb = tokens[2].text
    span = Span(tokens[0].end, tokens[2].start)
    what = f"no point stands before `{verb}`"
    return mended(found, what, span, " ")._replace(help=f"write `{tokens[0].text} {verb}`")


def _takes(keyword: str, index: int, kind: SlotKind) -> bool:
    """Tell whether a statement has a slot of a kind at a place among its slots."""
    return BY_KEYWORD[keyword].slots[index].kind is kind


def _two_words(place: Place, found: Diagnostic) -> Diagnostic | None:
    """Recognise `for each`, and a verb of several words."""
    tokens = place.tokens
    for first in (place.at, place.at + 1) if place.at == 0 else (place.at,):
        for end in range(first + _MOST_PARTS, first + 1, -1):
            words = [token.text for token in tokens[first:end]]
            right = "_".join(words)
            if len(words) == end - first and right in KEYWORDS:
                span = Span(tokens[first].start, tokens[end - 1].end)
                return mended(found, f"`{right}` is written as one word", span, right)
    return None


def _clause(place: Place, found: Diagnostic) -> Diagnostic | None:
    """Recognise `if` for `when`, `when` without `for_each`, and `qos` without `with`."""
    declaration, text = place.declaration, place.token.text
    if declaration is None or found.code != codes.SYNTAX_ERROR:
        return None
    clauses = {clause.elements[:2] for clause in declaration.clauses}
    words = [token.text for token in place.tokens[: place.at]]
    if text == "qos" and ("with", "qos") in clauses and text not in words:
        return mended(found, "`qos` has the word `with` before it", place.token.span, "with qos")
    if text not in ("if", "when") or "when" in words:
        return None
    if all(clause.keyword != "when" for clause in declaration.clauses):
        return None
    if "for_each" not in words:
        what = f"`{text}` stands behind `for_each` and a topic"
        return found._replace(message=what, help=_FOR_WHOM)
    if text == "if":
        return mended(found, "a condition begins with `when`", place.token.span, "when")
    return None


_SLIPS: tuple[Callable[[Place, Diagnostic], Diagnostic | None], ...] = (
    *ROBOT_SLIPS,
    _comment,
    _quotes,
    _unclosed,
    _closed_late,
    _mark,
    _path,
    _hyphen,
    _number_first,
    _type_of_python,
    _quoted,
    _swapped,
    _point,
    _two_words,
    variable_left_out,
    bounds,
    *VALUE_SLIPS,
    *FIELD_SLIPS,
    _clause,
)
