"""What a file logs by, and how it puts values into what it logs."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator
from enum import Enum

from tree_sitter import Node

from .analysis import Analysis
from .insertion_point import Place
from .syntax import parts_of

# What the methods of loggers are called for a level, and those that classes have around them.
_LEVELS = {
    "info": ("info", "loginfo", "log_info"),
    "error": ("error", "logerr", "logerror", "log_err", "log_error"),
}
_OF_LOGGER = re.compile(r"debug|info|warn|warning|error|fatal|critical|exception")
_OF_OBJECT = re.compile(r"_*log_?(debug|info|warn|warning|err|error|fatal)")
_LOGGER = re.compile(r"_*(\w+_)?log(ger)?_?", re.IGNORECASE)


class Filling(Enum):
    """How a value gets into a text: `f'{a}'`, `'%s' % a`, `'{}'.format(a)`, `('%s', a)`."""

    INTERPOLATED = "f{quote}{label}: {{{value}}}{quote}"
    PERCENT = "{quote}{label}: %s{quote} % {value}"
    FORMAT = "{quote}{label}: {{}}{quote}.format({value})"
    ARGUMENT = "{quote}{label}: %s{quote}, {value}"

    def fill(self, quote: str, label: str, value: str) -> str:
        """Return the arguments of a call that logs a value behind a label."""
        return self.value.format(quote=quote, label=label, value=value)


def own_logger(analysis: Analysis, place: Place, level: str) -> str:
    """Return what the code of a place logs by, "" where that is what its library has.

    Args:
        analysis: the file.
        place: what is seen there is an object's attribute, or a name of the module.
        level: `info` or `error`.
    """
    found: Counter[tuple[str, bool]] = Counter()
    for call, callee in _calls(analysis):
        receiver, _, name = callee.rpartition(".")
        is_own = _is_seen(analysis, place, call, receiver)
        if is_own and _OF_OBJECT.fullmatch(name) and receiver == place.self_name:
            found[receiver, True] += 1
        elif _OF_LOGGER.fullmatch(name):
            is_own = is_own and _LOGGER.fullmatch(receiver.rpartition(".")[2]) is not None
            found[receiver if is_own else "", False] += 1
        elif receiver == "rospy" and _OF_OBJECT.fullmatch(name):
            found["", False] += 1
    receiver, is_object = found.most_common(1)[0][0] if found else ("", False)
    if not receiver:
        return ""
    if not is_object:
        return f"{receiver}.{level}"
    written = {callee for _, callee in _calls(analysis)}
    names = (f"{receiver}.{prefix}{name}" for name in _LEVELS[level][1:] for prefix in ("", "_"))
    return next((name for name in names if name in written), "")


def filling_of(analysis: Analysis, usual: Filling) -> Filling:
    """Return how most of a file's logs have their values; the usual way where none has more."""
    found = Counter(
        filling
        for call, callee in _calls(analysis)
        if _OF_LOGGER.fullmatch(callee.rpartition(".")[2])
        or _OF_OBJECT.fullmatch(callee.rpartition(".")[2])
        if (filling := _filling(analysis, call)) is not None
    )
    return max([usual, *found], key=lambda each: found[each])


def prints(analysis: Analysis) -> bool:
    """Whether a file prints what it tells."""
    return any(callee == "print" for _, callee in _calls(analysis))


def _calls(analysis: Analysis) -> Iterator[tuple[Node, str]]:
    """Yield the calls of a file, each with the source of what it calls."""
    for call in analysis.captures.get("call", []):
        callee = call.child_by_field_name("function")
        if callee is not None:
            yield call, analysis.syntax.slice(callee)


def _is_seen(analysis: Analysis, place: Place, call: Node, receiver: str) -> bool:
    """Whether what a call logs by is one thing with what the code of a place sees by that name."""
    root = receiver.partition(".")[0]
    scope = analysis.scopes.at(call.start_byte)
    if root and root == place.self_name:
        return scope.enclosing("class") is place.owner
    found = scope.lookup(root)
    return found is not None and found[0] is analysis.scopes.module


def _filling(analysis: Analysis, call: Node) -> Filling | None:
    """Return how a call puts a value into a text, None where it does not."""
    given = parts_of(call.child_by_field_name("arguments"))
    text = given[0] if given else None
    if text is None:
        return None
    if text.type == "binary_operator":
        left = text.child_by_field_name("left")
        is_text = left is not None and left.type in ("string", "concatenated_string")
        operator = text.child_by_field_name("operator")
        is_percent = operator is not None and operator.type == "%"
        return Filling.PERCENT if is_text and is_percent else None
    if text.type == "call":
        return Filling.FORMAT if analysis.syntax.called_name(text) == "format" else None
    if text.type == "string" and any(each.type == "interpolation" for each in text.children):
        return Filling.INTERPOLATED
    return Filling.ARGUMENT if text.type == "string" and len(given) > 1 else None
