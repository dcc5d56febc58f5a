"""What rules have found before, where nothing has changed that they looked at.

All files are known by then that were read for it, whatever for, and where there could be others
(`Listing`). So a workspace that nobody has edited is told of without reading what is known of it.
"""

from __future__ import annotations

import os
from collections.abc import Iterable
from itertools import chain
from typing import Any

from plastron_tui.diagnostics import Diagnostic
from plastron_tui.diagnostics.codes import CODES
from plastron_tui.lint import Found
from plastron_tui.lint.rule import RULES, rule_of

from .cache import FactCache, packed
from .fingerprints import Digest, Reads, digest, digest_of_names
from .listing import Listing, files_around, mark_of
from .packages import runnable


class FoundBefore:
    """What was found the last time, in the user's cache beside what is known of files."""

    def __init__(self, facts: FactCache, listing: Listing, said: str) -> None:
        """Read what was found.

        Args:
            facts: what is known of the files.
            listing: the files of the workspace.
            said: what was said of rules.
        """
        self._facts = facts
        self._cache = facts.beside("found")
        self._cache.begin()
        self._key = digest(said.encode("utf-8", "surrogatepass"), _names(listing)).hex()

    def get(self) -> tuple[Found, ...] | None:
        """Return what was found, None where something else may be found now."""
        known = self._cache.get(self._key)
        if known is None or not all(code in RULES or code in CODES for code, *_ in known[0]):
            return None
        # What is known of the files is not read, so nobody else marks it.
        self._cache.touch()
        self._facts.touch()
        return tuple(_found(each) for each in known[0])

    def needs(self) -> dict[str, Digest | None]:
        """Return what each file held that it was found in, or that was kept for the next run."""
        return self._cache.needs()

    def keep(self, found: Iterable[Found], reads: Reads) -> None:
        """Leave to the next run what was found.

        Args:
            found: what was found.
            reads: what was read by rules, and to resolve what launch files start.
        """
        needs = self._facts.needs() | reads.digests
        seen = self._facts.files.seen | reads.seen
        data = packed([(str(each.diagnostic.code), *each.diagnostic[1:]) for each in found])
        self._cache.put(self._key, Reads(needs, seen), data)
        self._cache.save()


def _names(listing: Listing) -> bytes:
    """Return what tells which files there are, and which of them are programs."""
    below = len(os.fspath(listing.root)) + 1
    programs = runnable(os.fspath(listing.root), (path[below:] for path in listing.files))
    left_out = chain(map(mark_of, listing.left_out), files_around(listing.root))
    return digest(*map(digest_of_names, (listing.files, left_out, programs)))


def _found(parts: tuple[Any, ...]) -> Found:
    code = parts[0]
    rule = RULES[code] if code in RULES else rule_of(CODES[code])
    return Found(rule, Diagnostic(rule.code, *parts[1:]))
