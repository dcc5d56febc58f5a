"""Files that exist, whoever wrote them: the languages that node files are written in.

A language is loaded when it is first asked for; it imports its parser only to read a file.
"""

from __future__ import annotations

from functools import cache
from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from .base import Language

_OWN = {
    "python": "plastron_tui.sources.python.language:Python",
    "cpp": "plastron_tui.sources.cpp.language:Cpp",
}


@cache
def find_language(name: str) -> Language:
    """Return one of Plastron's own languages.

    Raises:
        KeyError: there is none of that name.
    """
    module, attribute = _OWN[name].split(":")
    language: Language = getattr(import_module(module), attribute)()
    return language


def own_languages() -> tuple[Language, ...]:
    """Return Plastron's own languages, those that it writes first."""
    return tuple(map(find_language, _OWN))
