"""Common slips of the pen in the words of sentences about robots, and what was meant."""

from __future__ import annotations

import re
from collections.abc import Callable

from plastron_tui.diagnostics import Diagnostic, Span, write

from .declaration import SlotKind
from .limit_mistakes import FIRST_CLAUSE, LIMIT_SLIPS
from .mistake_place import Place, mended
from .number_mistakes import NUMBER_SLIPS
from .statements.robots import HasJoint, HasLink, LimitsJoint
from .tokens import QUOTED_KINDS, UNKNOWN, WORD_KINDS, is_glued, token_at
from .written_numbers import span_from, written_from

_COLOR_CODE = re.compile(rb"#[0-9a-fA-F]{3,8}\b")
_URI = re.compile(r"[\w.+~$-]+(?::/)?(?:/[\w.+~$-]+)+|[\w-]+\.\w+")
_ONE_WORD = "a colour is one word"
_JOINERS = frozenset({",", "and", "with", "of", "&", "its"})
_MOST_URI = 300
_SHAPES = ("box", "cylinder", "sphere", "mesh")
_SIGNS = {"x": "1, 0, 0", "y": "0, 1, 0", "z": "0, 0, 1"}

_CLAUSE_WORDS = {
    **dict.fromkeys(("mass", "weight", "weighs", "kg"), "weighing"),
    **dict.fromkeys(("color", "colour", "colored", "coloured", "paint", "material"), "painted"),
    **dict.fromkeys(("rotated", "rotation", "rpy", "orientation", "rotate", "facing"), "turned"),
    **dict.fromkeys(("position", "xyz", "placed", "origin", "located"), "at"),
    **dict.fromkeys(("geometry", "form", "formed", "shape", "size"), "shaped"),
    **dict.fromkeys(("mimic", "mimics", "following", "follows"), "mimicking"),
}
"""What others call what a clause says, and the word that it begins with."""

_LIMITING = frozenset(
    {"between", "limit", "limits", "limited", "effort", "velocity", "damping", "friction"}
)


def color(place: Place, found: Diagnostic) -> Diagnostic | None:
    """Recognise `#ff8800` without its quotes, and `light blue`."""
    token = place.token
    if place.wanted is SlotKind.COLOR:
        code = _COLOR_CODE.match(place.source, token.start)
        if token.kind == UNKNOWN and code is not None:
            right = f'"{code[0].decode()}"'
            return mended(found, "a code is in double quotes", Span(*code.span()), right)
        if token.kind in QUOTED_KINDS and token.text.startswith("'#"):
            right = f'"{token.text[1:-1]}"'
            return mended(found, "a code is in double quotes", token.span, right)
    before, declaration = place.before, place.declaration
    if before is None or declaration is None or not place.is_name(place.at):
        return None
    if place.slots.get(place.at - 1) is not SlotKind.COLOR or before.kind not in WORD_KINDS:
        return None
    if token.text in {each.keyword for each in declaration.clauses} or token.text in _CLAUSE_WORDS:
        return None
    if before.text not in ("light", "dark"):
        return found._replace(message=f"unexpected `{token.text}`", help=_ONE_WORD, fix=None)
    right = f"{before.text}_{token.text}".replace("grey", "gray")
    return mended(found, _ONE_WORD, place.span(place.at - 1, place.at + 1), right)


def second_color(place: Place, found: Diagnostic) -> Diagnostic | None:
    """Say that a link has one colour, at `painted red, green` and `painted red and green`."""
    before = place.slots.get(place.at - 1)
    is_joined = before is SlotKind.COLOR and place.token.text in (",", "and", "/")
    word = place.text(place.at + 1)
    if not is_joined or not place.is_name(place.at + 1) or word in _CLAUSE_WORDS:
        return None
    help_ = "a link has one colour; another part may have another"
    return found._replace(span=place.span(place.at, place.at + 2), help=help_, fix=None)


def axis(place: Place, found: Diagnostic) -> Diagnostic | None:
    """Recognise `with axis z`, and `axis 0, 0, 1` without its `with`."""
    at, text = place.at, place.token.text
    if place.declaration is None or place.declaration.type is not HasJoint:
        return None
    if text == "axis" and at >= FIRST_CLAUSE and place.text(at - 1) != "with":
        return mended(found, "`axis` has the word `with` before it", place.token.span, "with axis")
    if place.wanted is not SlotKind.AXIS:
        return None
    letter = place.text(at + 1) if text in ("-", "+") else text
    numbers = _SIGNS.get(letter.lower())
    if numbers is None:
        return None
    right = numbers.replace("1", "-1") if text == "-" else numbers
    span = place.span(at, at + 1 + (letter != text))
    return mended(found, "an axis is three numbers: x, y and z", span, right)


def shape(place: Place, found: Diagnostic) -> Diagnostic | None:
    """Recognise `box, 1, 2, 3`, `sphere radius 0.1`, and a mesh without quotes."""
    at = place.at
    if place.within is not SlotKind.SIZE:
        return None
    first = max(index for index in place.slots if index <= at)
    token = place.token
    text = written_from(place, place.tokens[first])
    uri = _URI.match(text) if place.text(first - 1) == "mesh" else None
    if uri is not None and len(uri[0]) < _MOST_URI:
        span = span_from(place.tokens[first], uri[0])
        return mended(found, "a mesh is named in double quotes", span, f'"{uri[0]}"')
    if at == first and token.text == ",":
        return mended(found, "no comma stands behind the shape", token.span, "")
    clauses = {each.keyword for each in place.declaration.clauses} if place.declaration else set()
    if token.text in _SHAPES:
        help_ = f"it is {', '.join(f'`{each}`' for each in _SHAPES[:-1])} or `{_SHAPES[-1]}`"
        what = f"`{place.text(first - 1)}` is no shape"
        where = place.span(first - 1, first)
        return found._replace(message=what, span=where, help=help_, fix=None)
    is_name = place.is_name(at) and token.text not in clauses
    is_first = at == first or place.text(at - 1) == ","
    following = token_at(place.tokens, at + 1)
    if is_name and is_first and following is not None and following.kind == "number":
        right = f"{token.text}={following.text}"
        span = place.span(at, at + 2)
        return mended(found, "a `=` stands between a name and its value", span, right)
    return None


def clause_word(place: Place, found: Diagnostic) -> Diagnostic | None:
    """Recognise `mass 5` for `weighing 5`, and what stands between two clauses."""
    declaration, at = place.declaration, place.at
    if declaration is None or declaration.type not in (HasLink, HasJoint) or at < FIRST_CLAUSE:
        return None
    written = {token.text for token in place.tokens[:at]}
    left = {each.keyword for each in declaration.clauses} - written
    joiner = at if place.token.text in _JOINERS else None
    word = place.text(at + (joiner is not None))
    if joiner is None and place.text(at - 1) in _JOINERS:
        joiner = at - 1
    right = word if word in left else _CLAUSE_WORDS.get(word, "")
    if right not in left or right == word == place.token.text:
        return None
    end = at + 1 + (joiner == at)
    span = place.span(at if joiner is None else joiner, end)
    start = span.start
    if joiner is not None and joiner > 0 and is_glued(place.tokens, joiner):
        right = f" {right}"
    if word in left:
        what = f"nothing stands between two clauses, not even `{place.text(joiner or at)}`"
    else:
        what = f"this clause begins with `{right.strip()}`"
    return mended(found, what, Span(start, span.end), right)._replace(
        help=f"write `{right.strip()}`"
    )


def times(place: Place, found: Diagnostic) -> Diagnostic | None:
    """Recognise `mimicking 'other' by -1` and `* -1`."""
    at = place.at
    is_behind = place.text(at - 2) == "mimicking" and place.token.text in ("by", "*", "x", "with")
    if not is_behind or at + 1 >= len(place.tokens) or place.tokens[at + 1].kind != "number":
        return None
    return mended(found, "how far it moves is said with `times`", place.token.span, "times")


def limits_of_joint(place: Place, found: Diagnostic) -> Diagnostic | None:
    """Recognise limits in the sentence that makes a joint."""
    if place.declaration is None or place.declaration.type is not HasJoint:
        return None
    if place.token.text not in _LIMITING or place.at < FIRST_CLAUSE:
        return None
    is_quoted = [token.kind in QUOTED_KINDS for token in place.tokens[place.at + 1 : place.at + 4]]
    if is_quoted == [True, False, True] and place.text(place.at + 2) == "and":
        parent, child = place.text(place.at + 1), place.text(place.at + 3)
        span = place.span(place.at, place.at + 4)
        return mended(
            found, "a joint goes from one link to another", span, f"from {parent} to {child}"
        )
    name = place.tokens[2].text if place.tokens[2].kind in QUOTED_KINDS else "'JOINT'"
    robot = place.tokens[0].text
    help_ = f"limits have a line of their own: `{robot} limits_joint {name} between …`"
    return found._replace(help=help_, fix=None)


def pair_word(place: Place, found: Diagnostic) -> Diagnostic | None:
    """Say what stands with what, where effort and velocity, or damping and friction, do not."""
    if place.declaration is None or place.declaration.type is not LimitsJoint:
        return None
    text = place.token.text
    if text in ("velocity", "speed", "torque", "force"):
        return found._replace(help="write `with effort N and velocity V`", fix=None)
    if text == "friction":
        return found._replace(help="write `with damping D and friction F`", fix=None)
    return None


def type_word(place: Place, found: Diagnostic) -> Diagnostic | None:
    """Recognise `of type fixed`, `of fixed`, `fixed`, and `type fixed`."""
    if place.declaration is None or place.declaration.type is not HasJoint:
        return None
    token = place.token
    is_first = place.at == FIRST_CLAUSE and place.is_name(place.at)
    what = "how a joint moves stands behind `of joint_type`"
    if is_first and (token.text in _TYPES or place.text(place.at + 1) == "from"):
        return mended(found, what, token.span, f"of joint_type {token.text}")
    if token.text in ("type", "joint_type") and place.text(place.at - 1) != "of":
        return mended(found, what, token.span, "of joint_type")
    if place.text(place.at - 1) != "of" or not place.is_name(place.at):
        return None
    if token.text != "type" and place.text(place.at + 1) != "from":
        return None
    right = "joint_type" if token.text == "type" else f"joint_type {token.text}"
    return found._replace(help=f"write `{right}`", fix=write(right, token.span))


def bare_shape(place: Place, found: Diagnostic) -> Diagnostic | None:
    """Recognise `has_link 'a' box 1, 2, 3`, `with box`, and `is a box`."""
    at = place.at
    if place.declaration is None or place.declaration.type is not HasLink or at != FIRST_CLAUSE:
        return None
    first = next((i for i in range(at, at + 4) if place.text(i) in _SHAPES), None)
    if first is None or any(place.text(i) not in _BEFORE_SHAPES for i in range(at, first)):
        return None
    right = f"shaped {place.text(first)}"
    return mended(found, "a shape stands behind `shaped`", place.span(at, first + 1), right)


def ends(place: Place, found: Diagnostic) -> Diagnostic | None:
    """Recognise `to 'b' from 'a'`, `'a' to 'b'` and `from 'a' 'b'`."""
    at = place.at
    if place.declaration is None or place.declaration.type is not HasJoint:
        return None
    if at >= FIRST_CLAUSE and place.token.kind in QUOTED_KINDS:
        word = "to" if place.text(at - 2) == "from" else "from"
        if word == "to" or place.text(at + 1) == "to":
            right = f"{word} {place.token.text}"
            return mended(found, "a joint goes from one link to another", place.token.span, right)
    if (place.token.text, place.text(at + 2)) != ("to", "from") or at + 3 >= len(place.tokens):
        return None
    right = f"from {place.text(at + 3)} to {place.text(at + 1)}"
    return mended(found, "the link that holds stands first", place.span(at, at + 4), right)


def nothing(place: Place, found: Diagnostic) -> Diagnostic | None:
    """Recognise `mimicking nothing`, and what is said of it besides."""
    token = place.token
    if place.wanted is SlotKind.FOLLOWED and token.text in ("nothing", "null", "None", "no"):
        return mended(found, "what follows no joint is `mimicking none`", token.span, "none")
    if token.text == "times" and place.text(place.at - 1) == "none":
        what = "what follows no joint moves by no factor"
        span = place.span(place.at, min(place.at + 2, len(place.tokens)))
        return mended(found, what, span, "")._replace(help="take it away")
    return None


def no_limits(place: Place, found: Diagnostic) -> Diagnostic | None:
    """Recognise what is to take limits away."""
    tokens = place.tokens
    is_ending = place.text(1) in _UNLIMITING
    is_limits = place.declaration is not None and place.declaration.type is LimitsJoint
    if not is_ending and not (is_limits and place.token.text in ("none", "nothing")):
        return None
    name = next((each.text for each in tokens if each.kind in QUOTED_KINDS), "'JOINT'")
    help_ = f"limits go with the type: `{tokens[0].text} has_joint {name} of joint_type continuous`"
    if is_ending:
        what = f"no statement takes limits away, not even `{place.text(1)}`"
        return found._replace(message=what, span=tokens[1].span, help=help_, fix=None)
    what = "limits are not taken away: `revolute` and `prismatic` need them"
    return found._replace(message=what, help=help_, fix=None)


_UNLIMITING = frozenset(
    {"no_longer_limits_joint", "no_longer_limits", "unlimits_joint", "forgets_limits"}
)
"""What somebody writes who wants to take limits away."""

_BEFORE_SHAPES = frozenset({"is", "of", "with", "as", "like", "a", "shape", "="})
"""What somebody writes before a shape who does not know `shaped`."""

_TYPES = frozenset({"revolute", "continuous", "prismatic", "fixed", "floating", "planar"})


ROBOT_SLIPS: tuple[Callable[[Place, Diagnostic], Diagnostic | None], ...] = (
    no_limits,
    nothing,
    color,
    second_color,
    axis,
    *NUMBER_SLIPS,
    *LIMIT_SLIPS,
    shape,
    times,
    limits_of_joint,
    pair_word,
    ends,
    bare_shape,
    type_word,
    clause_word,
)
