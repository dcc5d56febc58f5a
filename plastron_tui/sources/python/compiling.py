"""Whether a text is Python, which no import and no tree is needed for."""

from __future__ import annotations

import ast
import warnings
from typing import NamedTuple

from plastron_tui.sources.text_memo import remembered


class NotPython(NamedTuple):
    """Why a text is no Python 3, and in which line, counted from 1, where Python says it."""

    reason: str
    line: int | None = None


@remembered
def syntax_error(text: bytes) -> NotPython | None:
    """Return why a text is no Python 3, None where it is."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            ast.parse(text)
    except SyntaxError as error:
        return NotPython(f"{error.msg.lower()} (line {error.lineno})", error.lineno)
    # A NUL, a text that is nested too deeply: made to break readers.
    except (ValueError, RecursionError, MemoryError) as error:
        return NotPython(str(error).lower() or type(error).__name__)
    return None
