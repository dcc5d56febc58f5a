"""Adding an argument to a command, and taking one out, in the style of its neighbours."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from plastron_tui.sources.splices import Splice, indent_of, line_end, line_start, newline_of

from .syntax import Argument, Command, Listing

_LONGEST_LINE = 100
# Words that mean nothing without an argument behind them.
_OPTIONAL_SECTIONS = frozenset({"CATKIN_DEPENDS", "COMPONENTS", "DEPENDENCIES", "LIBRARIES"})


def begins_line(text: bytes, start: int) -> bool:
    """Whether nothing but blanks is before an offset in its line."""
    return not text[line_start(text, start) : start].strip()


def insert_argument(
    listing: Listing, command: Command, siblings: Sequence[Argument], value: str
) -> list[Splice]:
    """Insert an argument among its siblings: in its place where they are sorted, else last.

    Args:
        listing: the file.
        command: the command that gets it.
        siblings: the arguments of its kind; of the last of them its place is learnt. What is
            before them, where there are none.
        value: what is written.
    """
    text = listing.text
    last = siblings[-1]
    new = value.encode()
    later = _sorted_before(siblings, value)
    if later is not None:
        if begins_line(text, later.start):
            at = line_start(text, later.start)
            indent = indent_of(text, later.start)
            return [Splice(at, at, indent + new + newline_of(text))]
        return [Splice(later.start, later.start, new + b" ")]
    if not begins_line(text, last.start):
        start = line_start(text, last.end)
        is_long = len(text[start : last.end] + b" " + new) > _LONGEST_LINE
        column = b"  " + indent_of(text, command.start)
        space = newline_of(text) + column if is_long else b" "
        return [Splice(last.end, last.end, space + new)]
    indent = indent_of(text, last.start)
    rest = text[last.end : line_end(text, last.end)].strip()
    if command.closing > line_end(text, last.end) - 1 and (not rest or rest.startswith(b"#")):
        at = line_end(text, last.end)
        return [Splice(at, at, indent + new + newline_of(text))]
    return [Splice(last.end, last.end, newline_of(text) + indent + new)]


def insert_words(argument: Argument, words: str) -> list[Splice]:
    """Insert words behind an argument, in its line."""
    return [Splice(argument.end, argument.end, b" " + words.encode())]


def insert_first(listing: Listing, command: Command, word: Argument, value: str) -> list[Splice]:
    """Insert the first argument of a section that is empty, on the line below its word."""
    text = listing.text
    is_first = begins_line(text, word.start)
    indent = indent_of(text, word.start) if is_first else indent_of(text, command.start) + b"  "
    return [Splice(word.end, word.end, newline_of(text) + indent + value.encode())]


def _sorted_before(siblings: Sequence[Argument], value: str) -> Argument | None:
    """Return the first sibling that belongs after a value, where they are sorted."""
    written = [each.value for each in siblings]
    bare = value.strip('"')
    if len(written) < 2 or written != sorted(written):
        return None
    return next((each for each in siblings if each.value > bare), None)


def argument_removals(
    listing: Listing, command: Command, argument: Argument
) -> Iterator[list[Splice]]:
    """Return the ways to take an argument out, the tidiest first.

    Where it is the only one of its section, the word that opens the section goes with it.
    """
    at = command.arguments.index(argument)
    following = command.arguments[at + 1 :]
    is_last = not following or following[0].value.isupper()
    if at and is_last and command.arguments[at - 1].value in _OPTIONAL_SECTIONS:
        yield from _removals(listing.text, command, at - 1, at)
    yield from _removals(listing.text, command, at, at)


def _removals(text: bytes, command: Command, first: int, last: int) -> Iterator[list[Splice]]:
    arguments = command.arguments
    from_, to = arguments[first].start, arguments[last].end
    start, end = line_start(text, from_), line_end(text, to)
    rest = text[to:end].strip()
    if begins_line(text, from_) and (not rest or rest.startswith(b"#")):
        yield [Splice(start, end)]
    before = arguments[first - 1].end if first else command.opening
    if not text[before:from_].strip():
        yield [Splice(before, to)]
    if last + 1 < len(arguments):
        after = arguments[last + 1].start
        if not text[to:after].strip():
            yield [Splice(from_, after)]
    yield [Splice(from_, to)]


def command_removals(listing: Listing, command: Command) -> Iterator[list[Splice]]:
    """Return the ways to take a command out, with the blank line before or after it, or none."""
    text = listing.text
    start, end = line_start(text, command.start), line_end(text, command.end)
    if not begins_line(text, command.start):
        return
    rest = text[command.end : end].strip()
    if rest and not rest.startswith(b"#"):
        return
    previous = line_start(text, max(start - 1, 0))
    has_before = start > previous and not text[previous:start].strip()
    has_after = end < len(text) and not text[end : line_end(text, end)].strip()
    if has_after and (has_before or start == 0):
        yield [Splice(start, line_end(text, end))]
    if has_before:
        yield [Splice(previous, end)]
    if has_after:
        yield [Splice(start, line_end(text, end))]
    yield [Splice(start, end)]
    if end == len(text) and not text.endswith(b"\n"):
        # What ends without a line ending is to end so again.
        width = 2 if text[start - 2 : start] == b"\r\n" else 1
        before = previous if has_before else start
        yield [Splice(before - width, end)]
        yield [Splice(start - width, end)]
