"""The headers that a text includes."""

from __future__ import annotations

import re

_INCLUDE = re.compile(rb"""^[ \t]*#[ \t]*include[ \t]*[<"]([\w.+-]+/[\w./+-]+)[>"]""", re.MULTILINE)

# Folders of headers that come with a compiler and the C library of a system.
_OF_SYSTEM = frozenset(
    {"arpa", "asm", "bits", "experimental", "linux", "net", "netinet", "sys", "..", "."}
)


def included(text: bytes) -> frozenset[str]:
    """Return the headers that a text includes from folders, as `std_msgs/msg/string.hpp`.

    Those of the language and of the system are left out.
    """
    found = (each.decode("ascii", "replace") for each in _INCLUDE.findall(text))
    return frozenset(each for each in found if each.partition("/")[0] not in _OF_SYSTEM)
