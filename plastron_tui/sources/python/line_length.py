"""How long the lines of a file may be, by the settings of the linters and formatters around it."""

from __future__ import annotations

import os
import re
from itertools import takewhile
from pathlib import Path

from plastron_tui.regular_files import read_regular

ROS_2 = 99
"""What ament_flake8 allows: https://docs.ros.org, "Code style and language versions"."""

ROS_1 = 79
"""What PEP 8 allows; http://wiki.ros.org/PyStyleGuide goes by it, and few files do."""

BLACK = 88
"""What black breaks lines for where nobody says more."""

_LARGEST = 64 * 1024
_FILES = (
    ".flake8",
    "ament_flake8.ini",
    "setup.cfg",
    "tox.ini",
    ".pycodestyle",
    "pyproject.toml",
    "ruff.toml",
    ".ruff.toml",
    ".pylintrc",
    "pylintrc",
)
# What checks a length goes before what lines are broken for, and pylint last.
_TABLES = (
    "flake8",
    "pycodestyle",
    "pep8",
    "tool.flake8",
    "tool.pycodestyle",
    "tool.ruff.lint.pycodestyle",
    "tool.ruff",
    "tool.black",
    "tool.pylint.format",
    "tool.pylint.main",
    "format",
    "master",
    "main",
)
_HEAD = re.compile(r"""\s*\[([\w."' -]+)\]\s*(?:#.*)?$""")
_QUOTES = str.maketrans("", "", "\"' ")
_ENTRY = re.compile(r"\s*(?:max[-_])?line[-_]length\s*[=:]\s*(\d{2,3})\b")

_MOST_FOLDERS = 12


def find_line_length(file: Path) -> int | None:
    """Return what the settings around a file allow, None where none of them says it.

    They are read as text and never run; what cannot be read says nothing.
    """
    for folder in map(os.fspath, _folders(file)):
        for name in _FILES:
            path = os.path.join(folder, name)  # noqa: PTH118
            # Hardly any is there: to ask costs less than to fail.
            if not os.path.lexists(path):
                continue
            try:
                text = read_regular(path, _LARGEST).decode("utf-8", "replace")
            except (OSError, ValueError):
                continue
            if (found := said_line_length(text, name)) is not None:
                return found
    return None


def said_line_length(text: str, name: str) -> int | None:
    """Return the length that the text of a settings file says; ruff's goes before black's."""
    above = "tool.ruff" if name.endswith("ruff.toml") else ""
    table, found = above, dict[str, int]()
    for line in text.splitlines():
        if (head := _HEAD.match(line)) is not None:
            table = ".".join(filter(None, (above, head[1].translate(_QUOTES).lower())))
            if table == "tool.black":
                found[table] = BLACK
        elif (entry := _ENTRY.match(line)) is not None:
            found[table] = int(entry[1])
    return next((found[each] for each in _TABLES if each in found), None)


def _folders(file: Path) -> list[Path]:
    """Return the folders from a file's up to its repository, or else to the home folder."""
    home = Path(os.path.expanduser("~"))  # noqa: PTH111 (never raises)
    folders = [*takewhile(lambda each: each != home, file.absolute().parents)][:_MOST_FOLDERS]
    roots = [number for number, each in enumerate(folders) if os.path.lexists(each / ".git")]
    return folders[: roots[-1] + 1 if roots else None]
