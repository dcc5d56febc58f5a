"""The names that changes take out of files, whatever language these are in."""

from __future__ import annotations

import re

from plastron_tui.diagnostics import Span
from plastron_tui.model.source import Change, Remove, Rename, Update

_NAME_PART = re.compile(rb"[/_~]")


def gone_name(change: Change) -> tuple[str | None, Span | None]:
    """Return the name that a change takes out, and where a statement says so; None for none."""
    match change:
        case Remove() | Rename():
            return change.name, change.span
        case Update() if change.name != change.endpoint.name:
            return change.name, change.span
    return None, None


def is_surely_name(said: bytes, bare: str, around: bytes) -> bool:
    """Tell whether a word of a file is a name of ROS, and not a plain word that is like one.

    Args:
        said: the word with the `/` or `~` before it.
        bare: the name without them.
        around: what the file says around it, such as `the topic scan` of a comment.
    """
    return bool(_NAME_PART.search(said) or _called(bare).search(around))


def _called(name: str) -> re.Pattern[bytes]:
    """Return what finds `topic scan`, `'scan' topic` and `scan service`."""
    noun, bare = rb"(?:topic|service|action)\b", re.escape(name.encode())
    pattern = rb"(?i:%s)[\s:=]*['\"`]?%s\b|\b%s['\"`]?\s+(?i:%s)" % (noun, bare, bare, noun)
    return re.compile(pattern)
