"""Rules of style sheets, which each studio that a test starts would else parse anew."""

from __future__ import annotations

from typing import Any

from textual.css.model import RuleSet
from textual.css.stylesheet import CSSLocation, Stylesheet

_parse_rules = Stylesheet._parse_rules
_parsed: dict[tuple[Any, ...], list[RuleSet]] = {}


def parse_rules_once(
    stylesheet: Stylesheet,
    css: str,
    read_from: CSSLocation,
    is_default_rules: bool = False,
    tie_breaker: int = 0,
    scope: str = "",
) -> list[RuleSet]:
    """Parse rules, unless another style sheet with the same variables has."""
    source = (css, read_from, is_default_rules, tie_breaker, scope)
    key = (frozenset(stylesheet._variables.items()), *source)
    if key not in _parsed:
        _parsed[key] = _parse_rules(stylesheet, *source)
    return _parsed[key]
