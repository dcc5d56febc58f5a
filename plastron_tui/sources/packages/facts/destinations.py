"""Where `install` puts things (`install` of CMake's manual)."""

from __future__ import annotations

from plastron_tui.sources.cmake.facts import INSTALL_WORDS, destination_of
from plastron_tui.sources.cmake.reader import Call, CMakeLists

UNKNOWN = "?"
"""A folder that is computed."""

_KINDS = frozenset({"ARCHIVE", "LIBRARY", "RUNTIME", "OBJECTS", "FRAMEWORK", "BUNDLE", "INCLUDES",
                    "PUBLIC_HEADER", "PRIVATE_HEADER", "RESOURCE"})  # fmt: skip


def set_destination(lists: CMakeLists, call: Call) -> str:
    """Return the folder of files that a call installs, from the install prefix."""
    where = destination_of(lists, call)
    return UNKNOWN if "${" in where else where


def program_destination(lists: CMakeLists, call: Call) -> str:
    """Return the folder that a call installs programs to, from the install prefix.

    `RUNTIME DESTINATION` is theirs, and a `DESTINATION` before all kinds is that of each. Without
    one it is `bin`.
    """
    kind = ""
    found: dict[str, str] = {}
    values = call.items
    for at, item in enumerate(values):
        if item.argument.is_quoted:
            continue
        if item.value in _KINDS:
            kind = item.value
        elif item.value == "DESTINATION" and at + 1 < len(values):
            # What stands behind the word alone is the folder.
            alone = call._replace(items=(*values[at : at + 2],))
            found[kind] = set_destination(lists, alone)
    return found.get("RUNTIME", found.get("", "bin"))


__all__ = ["INSTALL_WORDS", "UNKNOWN", "program_destination", "set_destination"]
