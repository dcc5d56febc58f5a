"""Lines that go on saying a name which an edit took out of a file."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from tree_sitter import Node

from plastron_tui.diagnostics import Diagnostic, codes, listed
from plastron_tui.model.source import Change
from plastron_tui.sources.gone_names import gone_name

from .analysis import Analysis
from .creation import line_of
from .log_uses import is_only_told
from .name_texts import docs_naming, is_other_name, texts_saying
from .scopes import Scope

# Shorter names are words as well.
_FEWEST_LETTERS = 4


def tell_still_named(
    after: Analysis, changes: Sequence[Change], uncalled: Sequence[Scope]
) -> Diagnostic | None:
    """Return a warning that names the lines of code which say what is called otherwise now.

    That are texts which are the name, what is logged with it, and comments and docstrings, but for
    those of functions that nothing calls any more.

    Args:
        after: the file as it is.
        changes: what was asked for.
        uncalled: these functions.
    """
    left = {(site.endpoint.name or "").lstrip("~/") for site in after.sites}
    for change in changes:
        old, span = gone_name(change)
        bare = (old or "").lstrip("~/")
        if old is None or bare in left or len(bare) < _FEWEST_LETTERS:
            continue
        said = {line_of(node) for node in _texts(after, old)}
        lines = sorted(said.union(_documented(after, old, uncalled)))
        if lines:
            message = f"{_says(lines)} `{old}`"
            return Diagnostic(codes.STILL_NAMED, message, span, help="change it by hand")
    return None


def _says(lines: Sequence[int]) -> str:
    numbers = listed(map(str, lines))
    return f"line {numbers} still says" if len(lines) == 1 else f"lines {numbers} still say"


def _texts(analysis: Analysis, name: str) -> Iterator[Node]:
    """Yield the texts of a file that are a name, or that log it."""
    for text in texts_saying(analysis, name):
        is_alike = (text.written[0] in "~/") == (name[0] in "~/")
        is_spelled = is_alike or "/" in text.written
        is_said = text.is_whole and is_spelled and not is_other_name(analysis, text)
        is_told = text.is_sure and is_only_told(analysis, text.node)
        if not (_is_default(text.node) or _names_node(analysis, text.node)) and (
            is_said or is_told
        ):
            yield text.node


def _documented(analysis: Analysis, name: str, uncalled: Sequence[Scope]) -> Iterator[int]:
    """Yield the lines of comments and docstrings that say a name for sure."""
    text = analysis.syntax.text
    for said in docs_naming(analysis, name):
        is_kept = any(each.node.start_byte <= said.start < each.node.end_byte for each in uncalled)
        if not is_kept:
            yield text.count(b"\n", 0, said.start) + 1


def _is_default(node: Node) -> bool:
    """Whether a text is what a parameter is where no caller says otherwise."""
    return node.parent is not None and node.parent.type.endswith("default_parameter")


def _names_node(analysis: Analysis, node: Node) -> bool:
    """Whether a text is given to what makes a node."""
    calls = [each.call for each in analysis.nodes if each.call is not None]
    return any(call.start_byte <= node.start_byte < call.end_byte for call in calls)
