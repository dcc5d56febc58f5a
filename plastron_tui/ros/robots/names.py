"""The names of robots, links and joints, and of their files."""

from __future__ import annotations

import re

_NAME = re.compile(r"[A-Za-z_][\w.-]*", re.ASCII)

NAME_RULE = "a name has letters, digits, `_`, `-` and dots, and starts with a letter or `_`"
"""What `is_name` asks for, for a person."""

FILE_ENDINGS = (".urdf", ".xacro")
"""What the names of robots' files end in."""


def is_name(text: str) -> bool:
    """Tell whether all tools take a name: letters, digits, `_`, `-` and dots, no digit first."""
    return _NAME.fullmatch(text) is not None
