"""Warnings of what an edit leaves behind in a file, in whatever language that is."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from plastron_tui.diagnostics import Diagnostic, Span, codes, listed
from plastron_tui.model.source import Change, EndpointKind, Remove, SourceEndpoint, Update

# A warning names so many readers of each variable.
_MOST_READERS = 2


def taking(changes: Sequence[Change]) -> list[Remove | Update]:
    """Return the changes that take something out."""
    return [change for change in changes if isinstance(change, Remove | Update)]


def _span_of(changes: Sequence[Change]) -> Span | None:
    """Return the statement that takes something out, None where several do."""
    spans = [change.span for change in taking(changes)]
    return spans[0] if len(spans) == 1 else None


def idle(found: Sequence[str], changes: Sequence[Change]) -> Diagnostic | None:
    """Return a warning of what still runs, and does nothing any more; None for nothing."""
    if not found:
        return None
    message = f"nothing is left to do for {listed(found)}"
    help_ = "remove it by hand if nothing needs it"
    return Diagnostic(codes.IDLE_CODE, message, _span_of(changes), help=help_)


def no_longer_set(
    readers: Iterable[tuple[str, Sequence[str]]], span: Span | None
) -> Diagnostic | None:
    """Return a warning of variables that nothing sets any more, None where there are none.

    Args:
        readers: the name of each, and who reads it in which line.
        span: the statement that took out what set them.
    """
    told = [f"`{name}` ({_few(each)})" for name, each in readers if each]
    if not told:
        return None
    message = f"no longer set: {listed(told)}"
    help_ = "set it elsewhere, or remove by hand what reads it"
    return Diagnostic(codes.STILL_READ, message, span, help=help_)


def _few(readers: Sequence[str]) -> str:
    """Return the first readers, and how many there are besides."""
    shown, more = readers[:_MOST_READERS], len(readers) - _MOST_READERS
    return "; ".join([*shown, f"{more} more"] if more > 0 else shown)


def unread(
    before: Iterable[SourceEndpoint], after: Iterable[SourceEndpoint], changes: Sequence[Change]
) -> Diagnostic | None:
    """Return a warning that names the parameters which a file does not read any more.

    Args:
        before: the endpoints of the file as it was.
        after: those of the file as it is.
        changes: what was asked for.
    """
    left = set(_parameters(after))
    named = {each.name for each in taking(changes) if each.kind is EndpointKind.PARAMETER}
    gone = [each for each in _parameters(before) if each not in left and each not in named]
    if not gone or not taking(changes):
        return None
    message = f"no longer read: {listed(f'`{each}`' for each in dict.fromkeys(gone))}"
    them = "it" if len(set(gone)) == 1 else "them"
    help_ = f"take {them} out of launch files and settings too"
    return Diagnostic(codes.UNREAD_PARAMETER, message, _span_of(changes), help=help_)


def _parameters(endpoints: Iterable[SourceEndpoint]) -> list[str]:
    return [
        each.name or each.expression for each in endpoints if each.kind is EndpointKind.PARAMETER
    ]
