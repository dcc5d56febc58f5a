"""Making many changes in a file: one after the other, or in one go where they are alike."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from typing import NamedTuple

from plastron_tui.diagnostics import Diagnostic, codes
from plastron_tui.model.kinds import (
    Client,
    Endpoint,
    Parameter,
    Publisher,
    Service,
    Subscription,
    Timer,
    callback_of,
    is_sending,
)
from plastron_tui.model.source import Add, Change, Remove, Rename, Update
from plastron_tui.ros.catalog import Catalog
from plastron_tui.ros.interfaces import InterfaceName
from plastron_tui.sources.written_anew import Exchange, or_renames

from .adding import plan_addition
from .aligning import realigned
from .analysis import Analysis
from .by_hand import refuse_answer, refuse_by_hand
from .creation import Removal
from .dialect import Dialect
from .existing_callbacks import NotCallableError
from .found_endpoints import Found, endpoints_of, respell
from .imports import unused_imports
from .lost import options_of, said_by
from .messages import CannotAddError
from .nodes import group, labels_of, part_of
from .other_updates import is_as_asked, plan_other
from .qos_arguments import has_policies
from .refusals import RefusedError, in_use, not_named, not_there, refuse_passes
from .removal import find_sites
from .removal_plan import plan_removal
from .renaming import NotNamedError, plan_names
from .replacing import NotInPlaceError
from .sent_before import lost_of_site
from .shared_analysis import analyze_again
from .splices import apply, delete_statements
from .updating import plan_update
from .writing import Writer, key_of

# With fewer additions to come it does not pay to find out whether they may be made in one go.
_MANY = 16

_MOST_WORK = 16 * 1024 * 1024
"""The most bytes that the changes of a file read, each of which reads the file as it then is."""


class _Manner(NamedTuple):
    """What additions have in common that may be written alike."""

    kind: type[Endpoint]
    type: InterfaceName | None
    has_callback: bool
    messages: int


def _manner(endpoint: Endpoint) -> _Manner:
    callback, messages = None, 0
    match endpoint:
        case Publisher():
            messages = len(endpoint.publications)
        case Client():
            messages = len(endpoint.requests)
        case Subscription() | Service():
            callback = endpoint.callback
    return _Manner(type(endpoint), endpoint.type, callback is not None, messages)


@dataclass(slots=True)
class Edits:
    """Changes on their way into a file.

    A change is planned for the file as the one before left it, which is analyzed anew each time.
    Hundreds of additions that are alike take one analysis together: where two in a row give the
    same text either way, so do those that follow, as long as none needs an import, a place of its
    own, or a name that another one has brought.

    Attributes:
        analysis: the file as it is now.
        expected: the endpoints that a reader must find in it.
        notes: warnings: what may no longer fit.
    """

    analysis: Analysis
    catalog: Catalog
    dialect: Dialect
    expected: Found
    notes: list[Diagnostic] = field(default_factory=list)
    _reads: int = 0
    _work: int = 0
    _alike: set[_Manner] = field(default_factory=set)
    _last: tuple[Analysis, Writer] | None = None
    _exchange: Exchange = field(default_factory=Exchange)

    def make(self, changes: Sequence[Change]) -> None:
        """Make changes, in their order, but what is sent for a message once something hears that.

        Raises:
            CannotAddError: there is no place for an endpoint, or its type is not known.
            RefusedError: an endpoint is in use, or the changes take too long.
            UnicodeEncodeError: the file's encoding has not what is to be written.
        """
        renames = [change for change in changes if isinstance(change, Rename)]
        if renames:
            self._rename(renames)
        changes, at = sorted(changes, key=_reacts), 0
        while at < len(changes):
            change = changes[at]
            if isinstance(change, Add):
                at += self._add(change, changes[at + 1 :])
                continue
            self._last = None
            at += 1
            if isinstance(change, Remove):
                self._remove(change)
            elif isinstance(change, Update):
                self._update(change)
        self.notes += self._exchange.notes(said_by(self.analysis))

    def _rename(self, changes: Sequence[Rename]) -> None:
        """Give endpoints other names, all at once."""
        before, wanted = self.analysis, {}
        for change in changes:
            sites = find_sites(part_of(before, change.node), change)
            if not sites:
                raise not_there(self.analysis, change)
            wanted.update(dict.fromkeys(sites, change.to))
        try:
            renaming = plan_names(before, wanted)
        except NotNamedError as error:
            for change in changes:
                refuse_passes(change, [each for each in wanted if each is error.site])
            raise not_named(error.site, changes) from None
        labels = labels_of(before)
        for site, name in zip(renaming.lost, renaming.names, strict=True):
            kind, _, type_, callback = key_of(site.endpoint)
            label = labels.get(site, "")
            self.expected.subtract([(label, key_of(site.endpoint))])
            self.expected[label, (kind, name, type_, callback)] += 1
        self._read(before.syntax.text)
        splices = realigned(before.syntax, renaming.splices)
        self.analysis = analyze_again(before, apply(before.syntax.text, splices))
        respell(self.expected, before, self.analysis)

    def _remove(self, change: Remove) -> None:
        sites = find_sites(part_of(self.analysis, change.node), change)
        if not sites:
            raise not_there(self.analysis, change)
        refuse_passes(change, sites)
        for site in sites:
            self._exchange.take((site.endpoint, options_of(self.analysis, site)), change.name)
        removal = plan_removal(self.analysis, sites)
        if removal.lines:
            raise in_use(change, removal)
        self._take_out(removal)

    def _take_out(self, removal: Removal) -> None:
        labels = labels_of(self.analysis)
        self.expected.subtract(
            (labels.get(site, ""), key_of(site.endpoint)) for site in removal.sites
        )
        text = apply(self.analysis.syntax.text, removal.splices)
        self._read(text)
        self.analysis = analyze_again(self.analysis, text)

    def _add(self, change: Add, following: Sequence[Change] = ()) -> int:
        """Make an addition, and those that follow it and are alike; return how many."""
        writers = self._planned(change, following)
        text = _applied(self.analysis, writers)
        if len(following) >= _MANY:
            self._compare(change, text)
        self._last = (self.analysis, writers[0]) if len(writers) == 1 else None
        label = self._label(change)
        for writer in writers:
            self.expected.update((label, key) for key in writer.endpoints)
            self.notes += writer.notes
        self._exchange.add(change.endpoint)
        self._read(text)
        self.analysis = analyze_again(self.analysis, text)
        return len(writers)

    def _update(self, change: Update) -> None:
        """Change an endpoint in place; take it out and write it anew where that cannot be."""
        before, expected = self.analysis, self.expected.copy()
        if self._differs_in_name_alone(change):
            is_same = change.endpoint.name == change.name
            if is_same or self._has_renamed(change):
                return
        refuse_passes(change, find_sites(part_of(self.analysis, change.node), change))
        refuse_by_hand(change.endpoint)
        refuse_answer(change.endpoint)
        try:
            if isinstance(change.endpoint, Parameter | Timer):
                self._update_calls(change)
            else:
                self._update_in_place(change)
        except NotCallableError:
            raise
        except (CannotAddError, NotInPlaceError):
            self.analysis, self.expected = before, expected
            remove, add = change.apart
            sites = find_sites(part_of(before, change.node), change)
            try:
                self._remove(remove)
            except RefusedError as refusal:
                raise RefusedError(or_renames(refusal.diagnostic, change)) from None
            self._add(add)
            if isinstance(new := change.endpoint, Publisher) and is_sending(new):
                for site in sites:
                    self.notes += lost_of_site(before, site, new, change.name, self.catalog.find)

    def _differs_in_name_alone(self, change: Update) -> bool:
        """Whether all call sites of an endpoint are as it shall be, but for the name at most."""
        endpoint, callback = change.endpoint, callback_of(change.endpoint)
        sites = find_sites(part_of(self.analysis, change.node), change)
        is_more = is_sending(endpoint) or isinstance(endpoint, Parameter | Timer)
        if isinstance(endpoint, Service) and endpoint.answer is not None:
            is_more = True
        version = self.analysis.library.ros_version
        return (
            bool(sites)
            and not is_more
            and all(has_policies(endpoint, site.endpoint.qos, version) for site in sites)
            and all(site.endpoint.type == endpoint.type for site in sites)
            and all(callback in (None, site.endpoint.callback) for site in sites)
        )

    def _has_renamed(self, change: Update) -> bool:
        """Change the name alone, and tell whether that could be done."""
        rename = Rename(change.kind, change.name, change.endpoint.name, change.span, change.node)
        try:
            self._rename([rename])
        except RefusedError:
            return False
        return True

    def _update_in_place(self, change: Update) -> None:
        """Change each call site of an endpoint; those that call another function go.

        Of several that a statement takes out, the one whose callback another names is meant.
        """
        callback = callback_of(change.endpoint)
        sites = find_sites(part_of(self.analysis, change.node), change)
        kept = [site for site in sites if site.endpoint.callback == callback]
        if callback is not None and len(sites) > 1:
            removal = plan_removal(self.analysis, [each for each in sites if each not in kept])
            if len(kept) != 1 or removal.lines:
                raise NotInPlaceError
            self._take_out(removal)
        for _ in sites if callback is None and sites else [change]:
            self._update_site(change)

    def _update_calls(self, change: Update) -> None:
        """Change what the calls say of a parameter, or of a timer."""
        before = self.analysis
        sites = find_sites(part_of(before, change.node), change)
        plan = plan_other(before, sites, change, self.catalog, self.dialect)
        text = apply(before.syntax.text, plan.all_splices())
        self._read(text)
        after = analyze_again(before, text)
        found = find_sites(part_of(after, change.node), change)
        expected = self.expected.copy()
        for analysis, each, count in ((before, sites, -1), (after, found, 1)):
            labels = labels_of(analysis)
            for site in each:
                expected[labels.get(site, ""), key_of(site.endpoint)] += count
        is_worse = after.syntax.errors > before.syntax.errors
        if is_worse or len(found) != len(sites) or endpoints_of(after) != +expected:
            raise NotInPlaceError
        if not is_as_asked(after, found, change):
            raise NotInPlaceError
        self.analysis, self.expected = after, expected
        self.notes += plan.notes

    def _update_site(self, change: Update) -> None:
        before = self.analysis
        node = part_of(before, change.node)
        sites = find_sites(node, change)
        # Of several under one name, some may have the new type already.
        left = [each for each in sites if each.endpoint.type != change.endpoint.type] or sites
        if not left or (len(sites) > 1 and is_sending(change.endpoint)):
            raise NotInPlaceError
        update = plan_update(before, left[0], change, self.catalog, self.dialect)
        labels = labels_of(before)
        label = labels.get(update.site, "")
        self.expected.subtract(
            (labels.get(site, ""), key_of(site.endpoint)) for site in update.lost
        )
        self.expected.update((label, key) for key in update.added.writer.endpoints)
        text = apply(before.syntax.text, realigned(before.syntax, update.all_splices()))
        self._read(text)
        after = analyze_again(before, text)
        imports, names = unused_imports(after, [], update.freed())
        if imports or names:
            text = apply(text, [*delete_statements(text, imports), *names])
            self._read(text)
            after = analyze_again(before, text)
        is_worse = after.syntax.errors > before.syntax.errors
        if is_worse or endpoints_of(after) != +self.expected:
            raise NotInPlaceError
        self.analysis = after
        if update.is_silent:
            self._add(Add(change.endpoint, change.node))
        self.notes += update.notes

    def _label(self, change: Add) -> str:
        """Return the label of the node that a change is for."""
        if change.node is not None:
            return change.node
        nodes = group(self.analysis)
        return nodes[0].label if nodes else ""

    def _planned(self, change: Add, following: Sequence[Change]) -> list[Writer]:
        """Plan an addition, and those after it that can be made with it."""
        first = self._plan(self.analysis, change)
        writers = [first]
        if first.has_imports or _manner(change.endpoint) not in self._alike:
            return writers
        words = set(first.words)
        for other in following:
            if not isinstance(other, Add) or other.node != change.node:
                break
            if _manner(other.endpoint) not in self._alike:
                break
            try:
                writer = self._plan(self.analysis, other)
            except (CannotAddError, UnicodeEncodeError):
                break
            is_alike = not writer.has_imports and _places(writer) == _places(first)
            if not is_alike or not words.isdisjoint(writer.names):
                break
            words |= writer.words
            writers.append(writer)
        return writers

    def _compare(self, change: Add, text: bytes) -> None:
        """Find out whether an addition and the one before can be made in one go."""
        manner = _manner(change.endpoint)
        if self._last is None or manner in self._alike:
            return
        before, last = self._last
        try:
            both = _applied(before, (last, self._plan(before, change)))
        except (CannotAddError, UnicodeEncodeError):
            return
        if both == text:
            self._alike.add(manner)

    def _plan(self, analysis: Analysis, change: Add) -> Writer:
        self._read(analysis.syntax.text)
        node = part_of(analysis, change.node)
        return plan_addition(analysis, node, change.endpoint, self.catalog, self.dialect)

    def _read(self, text: bytes) -> None:
        """Count what is read; few changes may be made in a file of any size."""
        self._reads += 1
        self._work += len(text)
        if self._reads > 2 * _MANY and self._work > _MOST_WORK:
            message = "the file is too large for so many changes, each of which reads it anew"
            remedy = "let several nodes have them, or make some of the changes by hand"
            raise RefusedError(Diagnostic(codes.EDIT_REFUSED, message, help=remedy))


def _reacts(change: Change) -> bool:
    """Whether a change sends something for messages, which something has to hear before."""
    sent = getattr(getattr(change, "endpoint", None), "publications", ())
    return any(each.reaction is not None for each in sent)


def _applied(analysis: Analysis, writers: Iterable[Writer]) -> bytes:
    splices = (splice for writer in writers for splice in writer.splices)
    return apply(analysis.syntax.text, splices)


def _places(writer: Writer) -> list[tuple[int, int]]:
    return [(splice.start, splice.end) for splice in writer.splices]
