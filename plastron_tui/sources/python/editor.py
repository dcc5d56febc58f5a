"""Editing a file: each change by splices, and the whole checked before it is handed out."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from functools import cached_property

from plastron_tui.diagnostics import Diagnostic, codes
from plastron_tui.model.source import Change, Rename, SourceUnit
from plastron_tui.ros.catalog import Catalog, moved
from plastron_tui.sources.base import Rendered
from plastron_tui.sources.left_behind import unread

from .analysis import Analysis, Meanings
from .calls import LIBRARIES
from .compiling import syntax_error
from .dialect import Dialect
from .edits import Edits
from .found_endpoints import Found, endpoints_of
from .guessed_names import tell_guessed_names
from .idle_code import tell_idle, tell_unused_results
from .imports import restore_imports
from .keeps_running import never_called
from .line_limit import line_limit
from .listed_endpoints import gone_entries
from .messages import CannotAddError
from .refusals import RefusedError
from .shared_analysis import analyze, analyze_again, package_names
from .splices import apply
from .still_named import tell_still_named
from .still_read import tell_still_read
from .uncalled import tell_uncalled, uncalled_functions
from .unresolved import lost_names, meanings
from .wrapping import wrap_new_lines


def edit_python(
    source: SourceUnit,
    changes: Sequence[Change],
    catalog: Catalog,
    dialect: Dialect,
    line_length: int | None = None,
) -> Rendered:
    """Change a Python file; what no change asks for stays byte for byte.

    The result was read again: it parses no worse, and holds exactly the endpoints that were
    asked for. Otherwise there is no text, and a diagnostic says why.

    Args:
        source: the file, and what was read of it.
        changes: what is asked for.
        catalog: the interface types.
        dialect: the client library.
        line_length: how long a line may be, None for what the file, or its ROS, keeps to.
    """
    if not changes:
        return Rendered(source.files)
    library = LIBRARIES[source.library]
    before = analyze(source.files.main, library, package_names(source.path, library))
    used = {
        (each.kind.facts.interface, each.type)
        for each in source.endpoints
        if each.type is not None and moved(each.type, catalog.ros_version) is None
    }
    catalog = catalog.with_undefined((kind, name) for kind, name in used if kind is not None)
    edits = Edits(before, catalog, dialect, endpoints_of(before))
    edits.notes += tell_guessed_names(before, changes)
    try:
        edits.make(changes)
    except (CannotAddError, RefusedError) as refusal:
        return Rendered(None, (refusal.diagnostic,))
    except UnicodeEncodeError as error:
        return Rendered(None, (not_encodable(source, error),))
    analysis = edits.analysis
    restored = apply(analysis.syntax.text, restore_imports(before, analysis))
    if restored != analysis.syntax.text:
        analysis = analyze_again(before, restored)
    if entries := gone_entries(analysis, changes):
        analysis = analyze_again(before, apply(analysis.syntax.text, entries))
    standard = _Standard(before)
    problem = standard.problem(analysis, edits.expected)
    # Of a call that gets another name one string changes, unless a linter asks for more, as that
    # of ROS 2 does.
    is_renamed = all(isinstance(change, Rename) for change in changes)
    limit = line_limit(before.syntax.text, source.library, line_length)
    is_checked = line_length is not None or source.library == "rclpy"
    if problem is None and not (is_renamed and (limit.slack or not is_checked)):
        wrapped = wrap_new_lines(before.syntax.text, analysis.syntax, limit)
        if wrapped != analysis.syntax.text:
            again = analyze_again(before, wrapped)
            if standard.problem(again, edits.expected) is None:
                analysis = again
    if problem is not None:
        message = f"the change of `{source.path.name}` would {problem}"
        return Rendered(None, (Diagnostic(codes.EDIT_REFUSED, message),))
    silent = never_called(before, analysis)
    if silent is not None:
        return Rendered(None, (silent,))
    uncalled = uncalled_functions(before, analysis)
    told = (
        tell_uncalled(before, changes, uncalled),
        tell_still_read(before, analysis, changes, uncalled),
        tell_idle(before, analysis, changes),
        tell_unused_results(before, analysis, changes),
        unread(
            (site.endpoint for site in before.sites),
            (site.endpoint for site in analysis.sites),
            changes,
        ),
        tell_still_named(analysis, changes, uncalled),
    )
    edits.notes += [each for each in told if each is not None]
    return Rendered(source.files.with_main(analysis.syntax.text), tuple(edits.notes))


def not_encodable(source: SourceUnit, error: UnicodeEncodeError) -> Diagnostic:
    """Return what is said of a character that the encoding of a file has not."""
    character = error.object[error.start]
    message = f"`{source.path.name}` is in {error.encoding}, which has no `{character}`"
    return Diagnostic(codes.EDIT_REFUSED, message, help="save the file in UTF-8 first")


class _Standard:
    """A file as it was, than which a changed one may be no worse."""

    def __init__(self, before: Analysis) -> None:
        self._before = before

    @cached_property
    def _compiles(self) -> bool:
        return syntax_error(self._before.syntax.text) is None

    @cached_property
    def _meanings(self) -> Meanings:
        return meanings(self._before)

    def problem(self, after: Analysis, expected: Found) -> str | None:
        """Return what is wrong with a changed file, None where nothing is."""
        before = self._before
        if after.syntax.errors > before.syntax.errors:
            return "leave a file that parses worse"
        if after.syntax.encoding != before.syntax.encoding:
            return "change the file's encoding"
        if endpoints_of(after) != +expected:
            return "change other endpoints than the ones asked for"
        if not _has_same_nodes(before, after):
            return "change the nodes of the file"
        if self._compiles and syntax_error(after.syntax.text) is not None:
            return "leave a file that does not compile"
        lost = lost_names(meanings(after), self._meanings)
        if lost:
            return f"use `{lost[0]}`, which nothing in the file defines any more"
        return None


def _has_same_nodes(before: Analysis, after: Analysis) -> bool:
    """Whether the nodes are the same; one that nothing shows any more may be gone."""
    missing = Counter(node.name for node in before.nodes)
    missing.subtract(node.name for node in after.nodes)
    is_fewer = len(after.sites) < len(before.sites) and bool(before.library.node_classes)
    return all(count == 0 or (count > 0 and is_fewer) for count in missing.values())
