"""What of a file takes far longer to read than its size tells."""

from __future__ import annotations

import re

# Bytes times lines; the largest files of ROS packages have a hundredth.
_MOST_WORK = 200_000_000
MOST_CLASSES = 1_000
"""The most classes of a file: each may derive from each of the others."""

# A line matches in one way only: of two, a run too short would be tried in all mixtures.
_COMMENTS = re.compile(rb"^(?:[ \t\f]*(?:#[^\n]*|\r?)\n){64,}", re.MULTILINE)


def is_readable(text: bytes) -> bool:
    """Tell whether a text is one that may be parsed: no data, and no run of comments too long."""
    return b"\x00" not in text and comment_run(text) is None


def comment_run(text: bytes) -> int | None:
    """Return the line of a run of comments that is too long to parse, None where there is none.

    The scanner of tree-sitter-python looks for the end of a run anew at each of its lines, which
    takes the square of the run's length.
    """
    if text.count(b"\n") * len(text) <= _MOST_WORK:
        return None
    for run in _COMMENTS.finditer(text):
        lines = run[0].count(b"#")
        if lines * len(run[0]) > _MOST_WORK:
            return text.count(b"\n", 0, run.start()) + 1
    return None
