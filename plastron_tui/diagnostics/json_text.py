"""JSON that every reader takes."""

from __future__ import annotations

import json
import re
from typing import Any

# A backslash that is escaped, a pair that stands for one character, and half of a pair.
_HALF = re.compile(r"(\\\\|\\ud[89ab][0-9a-f]{2}\\ud[c-f][0-9a-f]{2})|\\ud[89a-f][0-9a-f]{2}")


def json_text(data: Any, indent: int | None = 2) -> str:
    r"""Return data as JSON; a byte of a file's name that is not UTF-8 is told as in text: `\udcff`.

    Python keeps such a byte as half of a surrogate pair, which is no character (RFC 8259, 8.2): the
    JSON has six characters instead. Two names that are told apart stay so.
    """
    text = json.dumps(data, indent=indent)
    return _HALF.sub(lambda found: found[1] or rf"\{found[0]}", text)
