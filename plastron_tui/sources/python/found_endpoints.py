"""The endpoints that a reader finds in a file, by which an edit is held against what it was for."""

from __future__ import annotations

from collections import Counter

from .analysis import Analysis
from .nodes import labels_of
from .writing import Key, key_of

Found = Counter[tuple[str, Key]]
"""The endpoints of a file, each with the label of its node."""


def endpoints_of(analysis: Analysis) -> Found:
    """Return the endpoints of a file."""
    labels = labels_of(analysis)
    return Counter((labels.get(site, ""), key_of(site.endpoint)) for site in analysis.sites)


def respell(expected: Found, before: Analysis, after: Analysis) -> None:
    """Expect the endpoints that go by an expression as they are spelled now.

    A parameter that has another name may be named in their expressions.
    """
    spelled, respelled = _by_expression(before), _by_expression(after)
    if _without_expressions(spelled) == _without_expressions(respelled):
        expected.subtract(spelled)
        expected.update(respelled)


def _by_expression(analysis: Analysis) -> Found:
    labels = labels_of(analysis)
    sites = (each for each in analysis.sites if each.endpoint.name is None)
    return Counter((labels.get(each, ""), key_of(each.endpoint)) for each in sites)


def _without_expressions(found: Found) -> Found:
    return Counter((label, (key[0], None, *key[2:])) for label, key in found.elements())
