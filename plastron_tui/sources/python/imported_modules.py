"""What a Python text needs of others: the modules that it imports, but for Python's own."""

from __future__ import annotations

import sys

from .syntax import parse

# What Python had, and newer ones have no more: a text that imports it is for an older one.
_OLDER = frozenset(
    {
        "asynchat", "asyncore", "audioop", "cgi", "cgitb", "crypt", "distutils", "formatter", "imp",
        "nntplib", "parser", "pipes", "smtpd", "sndhdr", "spwd", "symbol", "telnetlib", "uu",
        "xdrlib",
        # Python 2, as nodes of ROS 1 may still try it first.
        "ConfigParser", "Queue", "StringIO", "Tkinter", "__builtin__", "cPickle", "cStringIO",
        "commands", "httplib", "thread", "urllib2", "urlparse",
    }
)  # fmt: skip

_STANDARD = sys.stdlib_module_names | _OLDER


def imported_modules(text: bytes) -> frozenset[str]:
    """Return the full names of the modules that a text imports and Python does not bring.

    Relative imports are of the text's own package, and no part of it.
    """
    syntax = parse(text)
    found = syntax.captures("imports").get("module", [])
    names = {"".join(syntax.slice(node).split()) for node in found}
    return frozenset(name for name in names if name.partition(".")[0] not in _STANDARD)
