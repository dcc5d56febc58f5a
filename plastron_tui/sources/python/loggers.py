"""What a file logs by, and how it puts values into what it logs."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator
from enum import Enum

from tree_sitter import Node

from .analysis import Analysis
from .place import Place
from .syntax import parts_of

# What the levels are called in the names of methods.
_LEVELS = {"info": ("info",), "error": ("error", "err")}
_OF_LOGGER = re.compile(r"debug|info|warn|warning|error|fatal|critical|exception")
# `rospy.loginfo`, and what classes have around a logger: `self.loginfo`, `self.info_msg`.
_OF_OBJECT = re.compile(r"(_*(?:log_?)?)(debug|info|warn|warning|err|error|fatal)((?:_?msg)?)")
_LOGGER = re.compile(r"(\w*_)?log(ger)?_?", re.IGNORECASE)


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
    found: Counter[tuple[str, ...]] = Counter()
    written = set()
    for call, callee in _calls(analysis):
        receiver, _, name = callee.rpartition(".")
        of_object = _OF_OBJECT.fullmatch(name)
        if of_object is not None and receiver == place.self_name and _tells(call):
            if _is_seen(analysis, place, call, receiver):
                found[f"{receiver}.{of_object[1]}", of_object[3]] += 1
                written.add(callee)
        elif _OF_LOGGER.fullmatch(name):
            is_logger = _LOGGER.fullmatch(receiver.rpartition(".")[2]) is not None
            is_own = is_logger and _is_seen(analysis, place, call, receiver)
            found[(f"{receiver}.",) if is_own else ()] += 1
        elif receiver == "rospy" and of_object is not None:
            found[()] += 1
    match found.most_common(1):
        case [((before, after), _)]:
            names = (f"{before}{each}{after}" for each in _LEVELS[level])
            return next((name for name in names if name in written), "")
        case [((before,), _)]:
            return f"{before}{level}"
    return ""


def filling_of(analysis: Analysis, usual: Filling, logger: str) -> Filling:
    """Return how most of a file's logs have their values; the usual way where none has more.

    Args:
        analysis: the file.
        usual: the usual way.
        logger: what is called; what a logger of the file's own takes, its other calls tell.
    """
    receiver = logger.rpartition(".")[0]
    found = Counter(
        filling
        for call, callee in _calls(analysis)
        if any(each.fullmatch(callee.rpartition(".")[2]) for each in (_OF_LOGGER, _OF_OBJECT))
        if (filling := _filling(analysis, call)) is not None
        if filling is not Filling.ARGUMENT or callee.rpartition(".")[0] == receiver
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


def _tells(call: Node) -> bool:
    """Whether what a call is given first is a text."""
    given = parts_of(call.child_by_field_name("arguments"))
    return bool(given) and given[0].type in ("string", "concatenated_string", "binary_operator")


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
    is_given = len(given) > 1 and given[1].type != "keyword_argument"
    return Filling.ARGUMENT if text.type == "string" and is_given else None
