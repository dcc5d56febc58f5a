"""Files that only Python 2 runs."""

from __future__ import annotations

import re

from plastron_tui.model.code_facts import FieldValue, ValueKind
from plastron_tui.sources.python.analysis import Analysis

_GONE = re.compile(
    rb"(?<![\w.])(?:basestring|execfile|raw_input|unichr|unicode|xrange)\s*\("
    rb"|\.(?:has_key|iteritems|iterkeys|itervalues)\("
)
_MADE_UP = re.compile(rb"\b(?:basestring|raw_input|unichr|unicode|xrange)\s*=(?!=)|\bimport six\b")
_FIRST_LINE = re.compile(rb"#!.*\bpython2(?:\.\d)?\b")


def is_python2(analysis: Analysis) -> bool:
    """Tell whether a file calls what Python 3 has not, or names Python 2 in its first line."""
    text = analysis.syntax.text
    if _FIRST_LINE.match(text):
        return True
    return _GONE.search(text) is not None and _MADE_UP.search(text) is None


def has_float(value: FieldValue) -> bool:
    """Tell whether a field gets a number of floating point.

    The `struct` of Python 2, by which rospy packs messages, takes one for an integer, with no more
    than a warning.
    """
    return ValueKind.FLOAT in (value.kind, *value.elements)
