"""The names of robots, links and joints."""

from __future__ import annotations

import re

_NAME = re.compile(r"[A-Za-z_][\w.-]*", re.ASCII)


def is_name(text: str) -> bool:
    """Tell whether all tools take a name: letters, digits, `_`, `-` and dots, no digit first."""
    return _NAME.fullmatch(text) is not None
