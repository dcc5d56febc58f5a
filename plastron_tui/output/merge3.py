"""Merging the lines of texts that come from one.

Lines are bytes and end at a line feed, so that text in any encoding comes through exactly.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from difflib import SequenceMatcher
from pathlib import Path
from typing import NamedTuple

from plastron_tui.model.source import FileSet

_MOST_LINES = 5_000
"""Texts that differ over more lines are not compared: the time grows with their square."""

_Lines = list[bytes]


class MergedText(NamedTuple):
    """What comes of a text that two sides changed; None with the reason."""

    text: bytes | None
    reason: str = ""


Merge = Callable[[Path, bytes, bytes, bytes], MergedText | None]
"""Merges otherwise than by lines: what a text says, thing by thing.

It gets the file's path, the text, and what became of that: by the program, and by hand. It returns
None where one of them cannot be read."""


class _Chunk(NamedTuple):
    """Lines that follow each other in each of the three texts."""

    base: _Lines
    ours: _Lines
    theirs: _Lines

    def merged(self) -> _Lines | None:
        """Return the lines with what either side changed, None where both did, and differently."""
        if self.theirs in (self.base, self.ours):
            return self.ours
        return self.theirs if self.ours == self.base else None

    def side_by_side(self) -> _Lines | None:
        """Return the lines where one side changed the first of them, and the other the rest.

        Lines of theirs may also stand around those that are ours instead of all. What is ours has
        to be other lines instead of some: next to lines that go, or that are new, what is theirs
        may have been written for them.
        """
        base, ours, theirs = self
        for cut in range(len(base) + 1):
            head, tail = base[:cut], base[cut:]
            if head and ours[len(ours) - len(tail) :] == tail and theirs[:cut] == head:
                mine, other = ours[: len(ours) - len(tail)], theirs[cut:]
                if mine and other:
                    return mine + other
            if tail and theirs[len(theirs) - len(tail) :] == tail and ours[:cut] == head:
                other, mine = theirs[: len(theirs) - len(tail)], ours[cut:]
                if mine and other:
                    return other + mine
        starts = range(len(theirs) - len(base) + 1) if base and ours else ()
        at = next((at for at in starts if theirs[at : at + len(base)] == base), None)
        return self._below() if at is None else theirs[:at] + ours + theirs[at + len(base) :]

    def listed(self) -> _Lines | None:
        """Return the lines that both sides added where nothing was, each of them once.

        Each has to stand for itself: one that opens or closes a bracket or a tag does not.
        """
        if self.base or not all(map(_is_whole, (*self.ours, *self.theirs))):
            return None
        return [*self.theirs, *(line for line in self.ours if line not in self.theirs)]

    def beside(self) -> _Lines | None:
        """Return the lines where ours are new ones above or below what is theirs instead.

        What both have added at one place stands in the order in which it came to be.
        """
        base, ours, theirs = self
        if not base:
            return ours + theirs
        if ours[: len(base)] == base:
            return theirs + ours[len(base) :]
        if ours[len(ours) - len(base) :] == base:
            return ours[: len(ours) - len(base)] + theirs
        return None

    def _below(self) -> _Lines | None:
        """Return the lines where one side changed a block's last, and the other wrote below it."""
        base = self.base
        for block, other in ((self.ours, self.theirs), (self.theirs, self.ours)):
            new = [line for line in other[len(base) :] if line.strip()]
            is_below = other[: len(base)] == base and bool(new) and not _is_indented(new[0])
            if is_below and all(_is_indented(line) for line in base + block if line.strip()):
                return block + other[len(base) :]
        return None


def _is_whole(line: bytes) -> bool:
    tags, closing = line.count(b"<"), line.count(b"</")
    is_closed = tags == 2 * closing or (tags == 1 and line.rstrip().endswith(b"/>"))
    return is_closed and line.count(b"(") == line.count(b")")


def _is_indented(line: bytes) -> bool:
    return line.startswith((b" ", b"\t"))


class _Match(NamedTuple):
    """Lines of the base, from `start` to `end`, that another text has from `other` on."""

    start: int
    end: int
    other: int


def merge_files(
    base: FileSet,
    ours: FileSet,
    theirs: FileSet,
    *,
    side_by_side: bool = False,
    restores: bool = False,
) -> FileSet | None:
    """Return files with the changes of both sides, None where they touch the same lines.

    See `merge_lines` for what else may stand where.
    A file that one side does not have stays out only where the other left it as it was.
    """
    merged = []
    for name in dict.fromkeys((*ours.names, *theirs.names)):
        before, mine, other = (each.get(name) for each in (base, ours, theirs))
        text: bytes | None
        if mine == other or other == before:
            text = mine
        elif mine == before:
            text = other
        elif before is None or mine is None or other is None:
            return None
        else:
            text = merge_lines(before, mine, other, side_by_side=side_by_side, restores=restores)
            if text is None:
                return None
        if text is not None:
            merged.append((name, text))
    return FileSet(tuple(merged)) if merged else None


def replay_files(base: FileSet, changed: FileSet, onto: FileSet) -> FileSet:
    """Make the changes from `base` to `changed` in other files, as far as they fit there.

    The main files belong together, whatever they are called; the others by their names.
    """
    main = replay(base.main, changed.main, onto.main)
    replayed = onto.with_main(main)
    for name, text in onto.texts[1:]:
        before, now = base.get(name), changed.get(name)
        if before is not None and now is not None:
            replayed = replayed.with_text(name, replay(before, now, text))
    return replayed


def merge_lines(
    base: bytes,
    ours: bytes,
    theirs: bytes,
    *,
    side_by_side: bool = False,
    is_list: bool = False,
    restores: bool = False,
) -> bytes | None:
    """Return a text with the changes of both sides, None where they touch the same lines.

    Lines that follow each other count as the same, unless they may stand `side_by_side`. In a
    text that `is_list`, as build files are, both sides may add entries at one place. What ours
    `restores` stood there before, and may stand next to any line of theirs.
    """
    merged: _Lines = []
    for chunk in _chunks(base, ours, theirs):
        lines = chunk.merged()
        if lines is None and side_by_side:
            lines = chunk.side_by_side()
        if lines is None and is_list:
            lines = chunk.listed()
        if lines is None and restores:
            lines = chunk.beside()
        if lines is None:
            return None
        merged += lines
    return b"".join(merged)


def replay(base: bytes, changed: bytes, onto: bytes) -> bytes:
    """Make the changes from `base` to `changed` in another text, as far as they fit there.

    What was changed in lines that `onto` does not have is left out, and what was added below one.
    """
    lines, new, target = split_lines(base), split_lines(changed), split_lines(onto)
    places = {
        match.start + i: match.other + i
        for match in _matches(lines, target)
        for i in range(match.end - match.start)
    }
    merged: _Lines = []
    done = 0
    for start, end, first, last in changed_lines(lines, new):
        at = places.get(start) if start < end else places.get(start - 1, -1 if not start else None)
        is_there = all(places.get(i) == (at or 0) + i - start for i in range(start, end))
        if at is None or not is_there:
            continue
        cut = at if start < end else at + 1
        merged += target[done:cut] + new[first:last]
        done = cut + end - start
    return b"".join(merged + target[done:])


def changed_lines(base: _Lines, other: _Lines) -> Iterator[tuple[int, int, int, int]]:
    """Yield what differs: the lines from start to end of the base, and those of the other."""
    done = at = 0
    for start, end, first in [*_matches(base, other), _Match(len(base), len(base), len(other))]:
        if done < start or at < first:
            yield done, start, at, first
        done, at = end, first + end - start


def _chunks(base: bytes, ours: bytes, theirs: bytes) -> Iterator[_Chunk]:
    """Cut three texts where all of them have the same lines."""
    lines = [split_lines(text) for text in (base, ours, theirs)]
    at = [0, 0, 0]
    ends = [len(each) for each in lines]
    for start, end, mine, other in [
        *_common(_matches(lines[0], lines[1]), _matches(lines[0], lines[2])),
        (ends[0], ends[0], ends[1], ends[2]),
    ]:
        yield _Chunk(lines[0][at[0] : start], lines[1][at[1] : mine], lines[2][at[2] : other])
        same = lines[0][start:end]
        yield _Chunk(same, same, same)
        at = [end, mine + end - start, other + end - start]


def split_lines(text: bytes) -> _Lines:
    """Split a text at line feeds only."""
    lines = [line + b"\n" for line in text.split(b"\n")]
    last = lines.pop()[:-1]
    return [*lines, last] if last else lines


def _common(ours: list[_Match], theirs: list[_Match]) -> Iterator[tuple[int, int, int, int]]:
    """Yield the lines of the base that both others have: start, end, and where they are there."""
    i = j = 0
    while i < len(ours) and j < len(theirs):
        one, two = ours[i], theirs[j]
        start, end = max(one.start, two.start), min(one.end, two.end)
        if start < end:
            yield start, end, one.other + start - one.start, two.other + start - two.start
        if one.end < two.end:
            i += 1
        else:
            j += 1


def _matches(base: _Lines, other: _Lines) -> list[_Match]:
    """Return the lines that two texts have in common, in their order."""
    shorter = min(len(base), len(other))
    head = next((i for i in range(shorter) if base[i] != other[i]), shorter)
    rest = shorter - head
    tail = next((i for i in range(rest) if base[-1 - i] != other[-1 - i]), rest)
    inner, changed = base[head : len(base) - tail], other[head : len(other) - tail]
    found = [_Match(0, head, 0)] if head else []
    if max(len(inner), len(changed)) <= _MOST_LINES:
        blocks = SequenceMatcher(None, inner, changed, autojunk=False).get_matching_blocks()
        found += [_Match(head + a, head + a + size, head + b) for a, b, size in blocks if size]
    if tail:
        found.append(_Match(len(base) - tail, len(base), len(other) - tail))
    return found
