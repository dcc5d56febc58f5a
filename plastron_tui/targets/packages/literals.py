"""Texts as the files of a package write them."""

from __future__ import annotations

from textwrap import wrap

LONGEST_LINE = 99
"""How long a line may be by ament_flake8 and ament_lint_cmake's neighbours (ROS 2 code style)."""


def python_string(text: str) -> str:
    """Return a string literal in single quotes, or in double ones where that saves escapes."""
    quote = '"' if "'" in text and '"' not in text else "'"
    escaped = text.replace("\\", "\\\\").replace(quote, f"\\{quote}")
    return f"{quote}{escaped}{quote}"


def python_argument(name: str, text: str, indent: int) -> str:
    """Return a keyword argument with a string, over several lines where one is too long."""
    line = f"{name}={python_string(text)},"
    if indent + len(line) <= LONGEST_LINE:
        return line
    # White space that is cut off a line is that of the next one.
    parts = wrap(text, 80, drop_whitespace=False, break_on_hyphens=False, replace_whitespace=False)
    margin = " " * indent
    inner = "".join(f"{margin}    {python_string(part)}\n" for part in parts)
    return f"{name}=(\n{inner}{margin}),"
