"""Where a new command belongs in a CMakeLists.txt, and how it is written there."""

from __future__ import annotations

from typing import NamedTuple

from plastron_tui.diagnostics import codes
from plastron_tui.sources.build_files import refusal
from plastron_tui.sources.splices import Splice, indent_of, line_end, line_start, newline_of

from .arguments import begins_line
from .facts import CATKIN, build_type
from .reader import CMakeLists
from .syntax import Argument, Block, Command, Listing, Statement

_INSTALLING = frozenset(
    {
        "ament_python_install_module",
        "ament_python_install_package",
        "catkin_install_python",
        "install",
    }
)
_CATKIN_TESTS = ("add_rostest", "catkin_add_", "roslaunch_add_")


class Layout(NamedTuple):
    """How a file writes calls over several lines.

    Attributes:
        indent: what begins the lines of arguments.
        is_closed_apart: whether the closing parenthesis has a line of its own.
        is_upper: whether commands are in capitals.
    """

    indent: str = "  "
    is_closed_apart: bool = True
    is_upper: bool = False


def layout_of(listing: Listing) -> Layout:
    """Learn how a file writes calls from its last one over several lines, best of `install`."""
    long = [
        each
        for each in listing.statements
        if isinstance(each, Command)
        and _line_arguments(listing, each)
        and not indent_of(listing.text, each.start)
    ]
    installing = [each for each in long if each.name in _INSTALLING]
    commands = [each.spelled for each in listing.commands()]
    is_upper = sum(map(str.isupper, commands)) * 2 > len(commands)
    if not long:
        return Layout(is_upper=is_upper)
    model = (installing or long)[-1]
    first = _line_arguments(listing, model)[0]
    indent = indent_of(listing.text, first.start).decode()
    return Layout(indent or "  ", begins_line(listing.text, model.closing), is_upper)


def _line_arguments(listing: Listing, command: Command) -> list[Argument]:
    return [each for each in command.arguments if begins_line(listing.text, each.start)]


def written_call(listing: Listing, name: str, first: str, lines: list[str]) -> bytes:
    """Write a call with its first words beside its name, the other lines below, as a file does."""
    layout = layout_of(listing)
    end = newline_of(listing.text).decode()
    name = name.upper() if layout.is_upper else name
    body = "".join(f"{end}{layout.indent}{line}" for line in lines)
    closing = f"{end})" if layout.is_closed_apart and lines else ")"
    return f"{name}({first}{body}{closing}".encode()


def insert_after(listing: Listing, statement: Statement, call: bytes, blank: bool) -> list[Splice]:
    """Insert a call below a statement, with a blank line between or without."""
    text, end = listing.text, newline_of(listing.text)
    at = line_end(text, statement.end)
    space = end if blank else b""
    if text[statement.end : at].endswith(b"\n"):
        return [Splice(at, at, space + call + end)]
    return [Splice(at, at, end + space + call)]


def insert_installation(lists: CMakeLists, call: bytes) -> list[Splice]:
    """Insert a call of `install` where such calls stand, or else where they belong.

    With catkin that is below `catkin_package`, which sets where things are installed (its
    documentation).

    Raises:
        RefusedError: the package is a metapackage, which has nothing to install (REP 127).
    """
    listing = lists.listing
    for made in lists.named("catkin_metapackage"):
        why = "makes it a metapackage, which installs nothing"
        remedy = "put it into another package"
        span = made.command.span
        raise refusal(listing.text, listing.path, span, why, codes.EDIT_REFUSED, remedy)
    commands = [each for each in listing.statements if isinstance(each, Command)]
    installing = [each for each in commands if each.name in _INSTALLING]
    if installing:
        splices = insert_after(listing, installing[-1], call, blank=True)
    else:
        splices = insert_before_end(lists, call)
    for each in reversed(commands):
        if each.name == "catkin_package" and splices[0].start < each.end:
            return insert_after(listing, each, call, blank=True)
    return splices


def insert_before_end(lists: CMakeLists, call: bytes) -> list[Splice]:
    """Insert a call before what ends a package: tests, exports, `ament_package`."""
    listing = lists.listing
    text, end = listing.text, newline_of(listing.text)
    at = _section_end(listing)
    if at is None:
        anchor = next((each for each in listing.statements if _is_end(lists, each)), None)
        at = None if anchor is None else _over_comments(listing, anchor.start)
    if at is not None:
        before = text[:at].rstrip(b" \t")
        is_apart = not before.strip() or before.endswith((b"\n\n", b"\n\r\n"))
        return [Splice(at, at, call + end + (end if is_apart else b""))]
    content = len(text.rstrip())
    at = line_end(text, content)
    if text[content:at].endswith(b"\n"):
        return [Splice(at, at, end + call + end)]
    return [Splice(at, at, end + end + call)]


def _is_end(lists: CMakeLists, statement: Statement) -> bool:
    if isinstance(statement, Block):
        if statement.kind != "if":
            return False
        words = {each.value for each in statement.branches[0].opening.arguments}
        return bool(words & {"BUILD_TESTING", "CATKIN_ENABLE_TESTING"})
    if build_type(lists) == CATKIN:
        return statement.name.startswith(_CATKIN_TESTS)
    return statement.name.startswith("ament_export_") or statement.name in (
        "ament_package",
        "ament_auto_package",
    )


def _over_comments(listing: Listing, start: int) -> int:
    """Return where the comments begin that stand right above a statement."""
    text = listing.text
    at = line_start(text, start)
    lines = {line_start(text, each[0]): each for each in listing.comments}
    while at > 0:
        previous = line_start(text, at - 1)
        is_line = previous in lines or text[previous:at].lstrip().startswith(b"#")
        if previous >= at or not is_line or not text[previous:at].strip().startswith(b"#"):
            break
        at = previous
    return at


def _section_end(listing: Listing) -> int | None:
    """Return where the section ends that a heading `## Install ##` begins, None without one."""
    text = listing.text
    is_in = False
    for start, end in listing.comments:
        said = text[start:end].strip(b"# \t\r\n")
        if not is_in:
            is_in = said.lower() == b"install" and text[start:end].rstrip().endswith(b"#")
            heading = line_end(text, end)
        elif not said and start != heading and begins_line(text, start):
            return line_start(text, start)
    return None
