"""Warnings of what an edit replaces, though somebody wrote it by hand, in whatever language."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import NamedTuple

from plastron_tui.diagnostics import Diagnostic, codes, listed
from plastron_tui.model.kinds import Endpoint, EndpointKind, Publication, Publisher, kind_of
from plastron_tui.model.source import SourceEndpoint, Update
from plastron_tui.ros.interfaces import InterfaceName

Said = tuple[SourceEndpoint, list[str]]
"""An endpoint, and what its call says besides name, type and callback."""


class _Gone(NamedTuple):
    kind: EndpointKind
    type: InterfaceName | None
    name: str
    options: list[str]


class Exchange:
    """What goes in an edit and what comes, which seems to take its place."""

    def __init__(self) -> None:
        self._gone: list[_Gone] = []
        self._new: list[Endpoint] = []

    def take(self, said: Said, name: str) -> None:
        """Note a call that is taken out, of an endpoint that a statement calls by a name."""
        endpoint, options = said
        self._gone.append(_Gone(endpoint.kind, endpoint.type, name, options))

    def add(self, endpoint: Endpoint) -> None:
        """Note an endpoint that is written."""
        self._new.append(endpoint)

    def notes(self, after: Iterable[Said]) -> Iterator[Diagnostic]:
        """Yield what the calls that went said, and those that came do not."""
        left = list(after) if self._gone and self._new else []
        for gone in self._gone:
            new = self._instead(gone)
            kept = {
                option
                for endpoint, options in left
                if new is not None and (endpoint.kind, endpoint.name) == (gone.kind, new.name)
                for option in options
            }
            lost = [f"`{option}`" for option in gone.options if option not in kept]
            if new is not None and lost:
                message = f"{', '.join(lost)} of `{gone.name}` is not kept for `{new.name}`"
                yield written_anew(message, new, gone.name)

    def _instead(self, gone: _Gone) -> Endpoint | None:
        of_kind = [each for each in self._new if kind_of(type(each)) is gone.kind]
        alike = [each for each in of_kind if each.type == gone.type]
        is_one = len({each.name for each in self._gone if each.kind is gone.kind}) == 1
        return next(iter(alike or (of_kind if is_one and len(of_kind) == 1 else ())), None)


def written_anew(message: str, endpoint: Endpoint, old: str) -> Diagnostic:
    """Return the warning that something of an endpoint goes, and what keeps it."""
    help_ = f"{_renames(endpoint, old)} keeps it" if old != endpoint.name else None
    return Diagnostic(codes.WRITTEN_ANEW, message, endpoint.span, help=help_)


def no_longer_sends(said: Iterable[str], new: Endpoint, old: str) -> Iterator[Diagnostic]:
    """Yield a warning of what an endpoint sent, and the node works out.

    Args:
        said: the source of it.
        new: what sends something else.
        old: the name of what sent.
    """
    gone = list(dict.fromkeys(f"`{' '.join(each.split())}`" for each in said))
    if gone:
        message = f"`{new.name}` no longer sends {listed(gone)}, which the node works out"
        yield written_anew(message, new, old)


def no_longer_decides(lines: Sequence[str], new: Publisher, old: str) -> Iterator[Diagnostic]:
    """Yield a warning of lines that sent something at their time, and do so no longer.

    Args:
        lines: the numbers of the lines.
        new: what sends instead.
        old: the name of what sent.
    """
    if not lines or not new.publications:
        return
    often = " and ".join(
        dict.fromkeys(_often(each) for each in new.publications if not each.is_rate_open)
    )
    numbers = listed(lines)
    is_one = len(lines) == 1
    who = f"line {numbers} no longer decides" if is_one else f"lines {numbers} no longer decide"
    message = f"{who} when `{new.name}` is sent"
    yield written_anew(message + (f": that is {often}" if often else ""), new, old)


def _often(sent: Publication) -> str:
    if sent.reaction is not None:
        return f"for each message of `{sent.reaction.topic}`"
    if sent.parameter is not None:
        return f"as often as `{sent.parameter.removeprefix('~/')}` says"
    return f"{sent.rate:g} times a second" if sent.rate else "once"


def or_renames(refusal: Diagnostic, change: Update) -> Diagnostic:
    """Let a refusal offer to change the name and nothing else, where that is what differs."""
    if refusal.code is not codes.ENDPOINT_IN_USE or change.name == change.endpoint.name:
        return refusal
    said = _renames(change.endpoint, change.name)
    return refusal._replace(help=f"{refusal.help}, or keep them: {said}")


def _renames(endpoint: Endpoint, old: str) -> str:
    noun = kind_of(type(endpoint)).facts.named
    return f"`renames {noun} '{old}' to '{endpoint.name}'`"
