"""What reading and changing a package's build files have in common: CMakeLists.txt, setup.py."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from fnmatch import fnmatchcase
from pathlib import Path
from typing import NamedTuple, ParamSpec

from plastron_tui.diagnostics import Code, Diagnostic, Span, codes

from .splices import line_number

LARGEST = 500_000
"""In bytes: far more than any build file that people write, and what parses within a second."""


_Given = ParamSpec("_Given")


class Edited(NamedTuple):
    """A changed build file, or why there is none (`text` is then None)."""

    text: bytes | None
    diagnostics: tuple[Diagnostic, ...] = ()


class RefusedError(Exception):
    """A build file that cannot be read or changed."""

    def __init__(self, diagnostic: Diagnostic) -> None:
        super().__init__(diagnostic.message)
        self.diagnostic = diagnostic


def edited(change: Callable[_Given, bytes], *args: _Given.args, **kwargs: _Given.kwargs) -> Edited:
    """Return what a change makes of a build file, or why it is refused."""
    try:
        return Edited(change(*args, **kwargs))
    except RefusedError as refused:
        return Edited(None, (refused.diagnostic,))


def refusal(
    text: bytes,
    path: Path,
    span: tuple[int, int],
    why: str,
    code: Code = codes.COMPUTED_BUILD_FILE,
    remedy: str | None = None,
) -> RefusedError:
    """Return why a file is not changed; the message names the line of the span.

    Args:
        text: what is in the file.
        path: the file.
        span: the bytes that are in the way.
        why: what is said of that line, such as "computes `entry_points`".
        code: the kind of mistake.
        remedy: what to do about it.
    """
    message = f"line {line_number(text, span[0])} of `{path.name}` {why}"
    return RefusedError(Diagnostic(code, message, Span(*span), path, help=remedy))


def check_text(text: bytes, path: Path) -> None:
    """Refuse what is no text, or too large.

    Raises:
        RefusedError: it is.
    """
    if len(text) > LARGEST:
        message = f"`{path.name}` has more than {LARGEST // 1000} kB"
        raise RefusedError(Diagnostic(codes.FILE_TOO_LARGE, message, file=path))
    try:
        text.decode()
    except UnicodeDecodeError as error:
        span = Span(error.start, error.end)
        message = f"line {line_number(text, error.start)} of `{path.name}` is not UTF-8"
        raise RefusedError(Diagnostic(codes.UNREADABLE_FILE, message, span, path)) from None
    if (at := text.find(b"\0")) >= 0:
        message = f"line {line_number(text, at)} of `{path.name}` has a NUL byte"
        raise RefusedError(Diagnostic(codes.UNREADABLE_FILE, message, Span(at, at + 1), path))


def take_back(
    text: bytes,
    candidates: Iterable[bytes],
    add: Callable[[bytes], bytes | None],
    is_right: Callable[[bytes], bool],
    exact: Iterable[bytes] = (),
) -> bytes | None:
    """Return the text that an addition made this one from, or else the first that is right.

    So removing what was added leaves the bytes that were there before, blank lines included.

    Args:
        text: what is in the file.
        candidates: texts without what is to be removed.
        add: what adds it again, None where it cannot.
        is_right: whether a text reads as it is to, and parses.
        exact: texts that lack more besides, and count only where the addition writes that too.
    """
    for each in exact:
        if is_right(each) and add(each) == text:
            return each
    right = [each for each in candidates if is_right(each)]
    return next((each for each in right if add(each) == text), right[0] if right else None)


def matches(file: str, pattern: str) -> bool:
    """Tell whether a pattern has a file: a `*` stands for a part of one name."""
    names, parts = file.split("/"), pattern.removeprefix("./").split("/")
    return len(names) == len(parts) and all(
        fnmatchcase(name, part) and not (name.startswith(".") and not part.startswith("."))
        for name, part in zip(names, parts, strict=True)
    )
