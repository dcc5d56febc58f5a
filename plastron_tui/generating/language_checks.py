"""What a language says of the texts of a set of files, taken together."""

from __future__ import annotations

from typing import TYPE_CHECKING

from plastron_tui.model.source import FileSet

if TYPE_CHECKING:
    from plastron_tui.sources.base import Language


def is_worse(language: Language, files: FileSet, *others: FileSet) -> bool:
    """Tell whether a file breaks the rules of its language, which in none of the others it does.

    The main files are compared with each other, the others by their names.
    """
    main = [each.main for each in others]
    if language.is_worse(files.main, *main):
        return True
    for name, text in files.texts[1:]:
        same = [found for each in others if (found := each.get(name)) is not None]
        if language.is_worse(text, *same):
            return True
    return False


def definitions(language: Language, files: FileSet, name: str) -> int:
    """Count the functions of a name that files define; 0 as well where that is not known."""
    return sum(language.definitions(text, name) for _, text in files.texts)


def mentions(language: Language, files: FileSet, name: str) -> bool:
    """Tell whether the code of files has a name."""
    return any(language.mentions(text, name) for _, text in files.texts)
