"""The conditions of package.xml, as REP 149 has them: `$ROS_VERSION == 2 and $X != "y"`."""

from __future__ import annotations

from collections.abc import Mapping
from enum import Enum
from typing import Final

_OPERATORS = ("==", "!=", "<=", ">=", "<", ">")
_WORD = frozenset("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-")
_DEEPEST = 50


class Unknown(Enum):
    """What a condition is where it asks for a variable that has no known value."""

    UNKNOWN = "unknown"


UNKNOWN: Final = Unknown.UNKNOWN


def holds(condition: str | None, variables: Mapping[str, str]) -> bool | Unknown | None:
    """Tell whether a condition holds, None where it is not one.

    Values are compared as texts.

    Args:
        condition: what the attribute says; None, where there is none, holds.
        variables: the known variables, without `$`.
    """
    if condition is None:
        return True
    tokens = _tokens(condition)
    if tokens is None:
        return None
    parser = _Parser(tokens, variables)
    try:
        found = parser.either()
    except _NoConditionError:
        return None
    return found if parser.is_done else None


def mentions(condition: str, variable: str) -> bool:
    """Tell whether a condition asks for a variable."""
    return f"${variable}" in (_tokens(condition) or ())


class _NoConditionError(Exception):
    """The text is no condition."""


def _tokens(text: str) -> list[str] | None:
    """Cut a condition; a literal in quotes keeps the first of them."""
    found: list[str] = []
    at = 0
    while at < len(text):
        mark = text[at]
        operator = next((one for one in _OPERATORS if text.startswith(one, at)), None)
        end = at + 1
        if mark.isspace():
            at = end
            continue
        if operator is not None:
            end = at + len(operator)
        elif mark in "\"'":
            end = text.find(mark, at + 1) + 1
            if not end:
                return None
        elif mark in _WORD or mark == "$":
            while end < len(text) and text[end] in _WORD and (mark != "$" or text[end] != "-"):
                end += 1
            if text[at:end] == "$":
                return None
        elif mark not in "()":
            return None
        found.append(text[at:end])
        at = end
    return found


class _Parser:
    """`or` binds weaker than `and`; a comparison stands in no other one."""

    def __init__(self, tokens: list[str], variables: Mapping[str, str]) -> None:
        self._tokens, self._variables = tokens, variables
        self._at = 0
        self._depth = 0

    @property
    def is_done(self) -> bool:
        return self._at == len(self._tokens)

    def either(self) -> bool | Unknown:
        parts = [self._both()]
        while self._takes("or"):
            parts.append(self._both())
        if True in parts:
            return True
        return UNKNOWN if UNKNOWN in parts else False

    def _both(self) -> bool | Unknown:
        parts = [self._term()]
        while self._takes("and"):
            parts.append(self._term())
        if False in parts:
            return False
        return UNKNOWN if UNKNOWN in parts else True

    def _term(self) -> bool | Unknown:
        if not self._takes("("):
            return self._comparison()
        self._depth += 1
        if self._depth > _DEEPEST:
            raise _NoConditionError
        found = self.either()
        if not self._takes(")"):
            raise _NoConditionError
        self._depth -= 1
        return found

    def _comparison(self) -> bool | Unknown:
        left, operator, right = self._value(), self._next(), self._value()
        if operator not in _OPERATORS:
            raise _NoConditionError
        if left is None or right is None:
            return UNKNOWN
        return {
            "==": left == right,
            "!=": left != right,
            "<=": left <= right,
            ">=": left >= right,
            "<": left < right,
            ">": left > right,
        }[operator]

    def _value(self) -> str | None:
        token = self._next()
        if token[0] == "$":
            return self._variables.get(token[1:])
        if token[0] in "\"'":
            return token[1:-1]
        if token[0] not in _WORD:
            raise _NoConditionError
        return token

    def _next(self) -> str:
        if self.is_done:
            raise _NoConditionError
        self._at += 1
        return self._tokens[self._at - 1]

    def _takes(self, token: str) -> bool:
        if self.is_done or self._tokens[self._at] != token:
            return False
        self._at += 1
        return True
