"""Editing a unit: each change by splices, and the whole checked before it is handed out."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence

from plastron_tui.diagnostics import Diagnostic, codes
from plastron_tui.model.kinds import Publisher, is_sending
from plastron_tui.model.source import (
    Add,
    Change,
    EndpointKind,
    Remove,
    Rename,
    SourceUnit,
    Update,
)
from plastron_tui.ros.catalog import Catalog, moved
from plastron_tui.sources.base import Rendered
from plastron_tui.sources.left_behind import unread
from plastron_tui.sources.written_anew import Exchange, or_renames

from ..analysis import Analysis
from ..beside import sources_beside
from ..nodes import group
from ..scopes import CppFile
from ..structure import outline
from ..syntax import parse
from .addition import plan_addition
from .clang_format import clang_format_of
from .guessed_names import tell_guessed_names
from .idle_code import tell_idle
from .keeps_running import never_called
from .lost import lost_sending, options_of
from .plans import Plan, with_splices
from .refusals import RefusedError, refuse_parts
from .removal import plan_removal, plan_silence
from .renaming import plan_renames
from .replacing import NotInPlaceError
from .still_named import tell_still_named
from .still_read import tell_still_read
from .uncalled import tell_uncalled, uncalled_functions, uncalled_lambdas
from .units import Found, analyze_files, endpoints_of, outlines_of, sites_of
from .updating import plan_update
from .used_elsewhere import used_elsewhere


def edit_cpp(source: SourceUnit, changes: Sequence[Change], catalog: Catalog) -> Rendered:
    """Change the files of a unit; what no change asks for stays byte for byte.

    The result was read again: each file parses no worse, and all of them hold exactly the
    endpoints that were asked for. Otherwise there are no files, and a diagnostic says why.

    Args:
        source: the files, and what was read of them.
        changes: what is asked for.
        catalog: the interface types.
    """
    if not changes:
        return Rendered(source.files)
    used = {
        (each.kind.facts.interface, each.type)
        for each in source.endpoints
        if each.type is not None and moved(each.type, catalog.ros_version) is None
    }
    catalog = catalog.with_undefined((kind, name) for kind, name in used if kind is not None)
    where = changes[0].endpoint.span if isinstance(changes[0], Add) else changes[0].span
    edits = _Edits(source, catalog)
    edits.notes += tell_guessed_names(edits.before, changes)
    try:
        edits.make(changes)
    except RefusedError as refusal:
        return Rendered(None, (refusal.diagnostic,))
    except UnicodeEncodeError as error:
        character = error.object[error.start]
        message = f"`{source.path.name}` is in {error.encoding}, which has no `{character}`"
        help_ = "save the file in UTF-8 first"
        found = Diagnostic(codes.EDIT_REFUSED, message, where, help=help_)
        return Rendered(None, (found,))
    problem = edits.problem()
    if problem is not None:
        message = f"the change of `{source.path.name}` would {problem}"
        help_ = "make this change in the file by hand"
        return Rendered(None, (Diagnostic(codes.EDIT_REFUSED, message, where, help=help_),))
    before, after = edits.before, edits.analysis
    silent = never_called(before, after, where)
    if silent is not None:
        return Rendered(None, (silent,))
    use = used_elsewhere(source.path, before, after)
    if use is not None:
        refused = Diagnostic(codes.ENDPOINT_IN_USE, use, where, help="change that file first")
        return Rendered(None, (refused,))
    uncalled = uncalled_functions(before, after)
    edits.notes += tell_uncalled([*uncalled, *uncalled_lambdas(before, after)], changes)
    edits.notes += tell_still_read(before, after, changes, uncalled)
    edits.notes += tell_idle(before, after, changes)
    parameters = unread(
        (site.endpoint for site in before.sites), (site.endpoint for site in after.sites), changes
    )
    edits.notes += [] if parameters is None else [parameters]
    edits.notes += tell_still_named(edits.analysis, changes)
    return Rendered(edits.files, tuple(edits.notes))


class _Edits:
    """Changes on their way into the files; each is planned for what the one before left.

    Attributes:
        files: the files as they are now.
        analysis: what is known of them.
        before: what was known of them as they were.
        expected: the endpoints that a reader must find in them.
        notes: warnings: what may no longer fit.
    """

    def __init__(self, source: SourceUnit, catalog: Catalog) -> None:
        self._source = source
        self._catalog = catalog
        self._settings = clang_format_of(source.path)
        self.files = source.files
        outlines = outlines_of(source.files)
        self._beside, _ = sources_beside(source.path, outlines)
        self.before = analyze_files(outlines, source.library, self._beside)
        self.analysis = self.before
        self.expected: Found = endpoints_of(self.analysis)
        self.notes: list[Diagnostic] = []
        self._exchange = Exchange()

    def make(self, changes: Sequence[Change]) -> None:
        """Make changes: all renames at once, then the others in their order.

        Raises:
            RefusedError: one cannot be made.
            UnicodeEncodeError: a file's encoding has not what is to be written.
        """
        renames = [change for change in changes if isinstance(change, Rename)]
        if renames:
            self._apply(plan_renames(self.analysis, renames))
        removals = [change for change in changes if isinstance(change, Remove)]
        for change in changes:
            if isinstance(change, Add):
                self._add(change)
            elif isinstance(change, Remove):
                self._remove(change, [each for each in removals if each is not change])
            elif isinstance(change, Update):
                self._update(change)
        said = ((site.endpoint, options_of(site)) for site in self.analysis.sites)
        self.notes += self._exchange.notes(said)

    def _remove(self, change: Remove, others: Sequence[Remove] = ()) -> None:
        """Take an endpoint out, unless it went with another one that one statement made too."""
        sites = sites_of(self.analysis, change)
        if not sites and sites_of(self.before, change):
            return
        for site in sites:
            self._exchange.take((site.endpoint, options_of(site)), change.name)
        self._apply(plan_removal(self.analysis, change, others))

    def _update(self, asked: Update) -> None:
        """Change an endpoint where it stands, or else take it out and write it anew."""
        change = asked
        refuse_parts(change, sites_of(self.analysis, change))
        before = self.files, self.analysis, self.expected.copy(), list(self.notes)
        try:
            change = self._rename(asked)
            self._apply(
                plan_update(self.analysis, change, self._catalog, self._settings, asked.name)
            )
            if self.problem() is None:
                return
        except (NotInPlaceError, RefusedError):
            pass
        self.files, self.analysis, self.expected, self.notes = before
        lost = list(lost_sending(self.analysis, asked))
        if not self._send_anew(change, asked):
            self.files, self.analysis, self.expected, self.notes = before
            remove, add = asked.apart
            try:
                self._remove(remove)
            except RefusedError as refusal:
                refusal.diagnostic = or_renames(refusal.diagnostic, asked)
                raise
            self._add(add)
        self.notes += lost

    def _send_anew(self, change: Update, asked: Update) -> bool:
        """Keep a publisher, and let other lines publish through it; tell whether that could be."""
        endpoint = change.endpoint
        if not isinstance(endpoint, Publisher) or not is_sending(endpoint):
            return False
        try:
            self._rename(asked)
            remove = Remove(change.kind, endpoint.name, change.span, change.node)
            self._apply(plan_silence(self.analysis, remove))
            silent = change._replace(
                name=endpoint.name, endpoint=endpoint._replace(publications=())
            )
            self._apply(plan_update(self.analysis, silent, self._catalog, self._settings))
            add = Add(endpoint, change.node)
            self._apply(plan_addition(self.analysis, add, self._catalog, self._settings))
        except (NotInPlaceError, RefusedError):
            return False
        return self.problem() is None

    def _rename(self, change: Update) -> Update:
        """Give an endpoint the name that it shall have; return what is left to change."""
        name = change.endpoint.name
        if name == change.name or change.kind is EndpointKind.TIMER:
            return change
        rename = Rename(change.kind, change.name, name, change.span, change.node)
        self._apply(plan_renames(self.analysis, [rename]))
        return change._replace(name=name)

    def _add(self, change: Add) -> None:
        self._exchange.add(change.endpoint)
        self._apply(plan_addition(self.analysis, change, self._catalog, self._settings))

    def _apply(self, plan: Plan) -> None:
        self.files = with_splices(self.files, plan.splices)
        self.expected.subtract(endpoints_of(self.analysis, plan.lost))
        self.expected.update(plan.added)
        self.notes += plan.notes
        outlines = self._outlines()
        self.analysis = analyze_files(outlines, self._source.library, self._beside)

    def _outlines(self) -> list[CppFile]:
        """Return the files as they are now; what did not change is not parsed again."""
        before = {file.name: file for file in self.analysis.unit.files}
        found = []
        for at, (name, text) in enumerate(self.files.texts):
            own = "" if at == 0 else name
            is_same = before[own].syntax.text == text
            found.append(before[own] if is_same else outline(own, parse(text)))
        return found

    def problem(self) -> str | None:
        """Return what is wrong with the changed files, None where nothing is."""
        pairs = zip(self.before.unit.files, self.analysis.unit.files, strict=True)
        if any(after.syntax.errors > before.syntax.errors for before, after in pairs):
            return "leave a file that parses worse"
        if endpoints_of(self.analysis) != +self.expected:
            return "change other endpoints than the ones asked for"
        if not _has_same_nodes(self.before, self.analysis):
            return "change the nodes of the file"
        return None


def _has_same_nodes(before: Analysis, after: Analysis) -> bool:
    """Whether the nodes are the same; one that nothing shows any more may be gone."""
    missing = Counter(node.name for node in group(before))
    missing.subtract(node.name for node in group(after))
    is_fewer = len(after.sites) < len(before.sites)
    return all(count == 0 or (count > 0 and is_fewer) for count in missing.values())
