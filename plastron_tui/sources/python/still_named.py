"""Lines that go on saying a name which an edit took out of a file."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from tree_sitter import Node

from plastron_tui.diagnostics import Diagnostic, Span, codes, listed
from plastron_tui.model.source import Change, Remove, Rename, Update

from .analysis import Analysis
from .creation import line_of
from .log_uses import is_only_told
from .name_texts import is_other_name, texts_saying

# Shorter names are words as well.
_FEWEST_LETTERS = 4


def tell_still_named(after: Analysis, changes: Sequence[Change]) -> Diagnostic | None:
    """Return a warning that names the lines of code which say what is called otherwise now.

    That are texts which are the name, and what is logged with it. Comments and docstrings are for
    people, who see that they are old.
    """
    left = {site.endpoint.name for site in after.sites}
    for change in changes:
        old, span = _old_name(change)
        if old is None or old in left or len(old.lstrip("~/")) < _FEWEST_LETTERS:
            continue
        lines = sorted({line_of(node) for node in _texts(after, old)})
        if lines:
            message = f"{_says(lines)} `{old}`"
            return Diagnostic(codes.STILL_NAMED, message, span, help="change it by hand")
    return None


def _says(lines: Sequence[int]) -> str:
    numbers = listed(map(str, lines))
    return f"line {numbers} still says" if len(lines) == 1 else f"lines {numbers} still say"


def _old_name(change: Change) -> tuple[str | None, Span | None]:
    """Return the name that a change takes out, and where a statement says so."""
    match change:
        case Remove() | Rename():
            return change.name, change.span
        case Update() if change.name != change.endpoint.name:
            return change.name, change.span
    return None, None


def _texts(analysis: Analysis, name: str) -> Iterator[Node]:
    """Yield the texts of a file that are a name, or that log it."""
    for text in texts_saying(analysis, name):
        is_alike = (text.written[0] in "~/") == (name[0] in "~/")
        is_spelled = is_alike or "/" in text.written
        is_said = text.is_whole and is_spelled and not is_other_name(analysis, text)
        is_told = text.is_sure and is_only_told(analysis, text.node)
        if not _is_default(text.node) and (is_said or is_told):
            yield text.node


def _is_default(node: Node) -> bool:
    """Whether a text is what a parameter is where no caller says otherwise."""
    return node.parent is not None and node.parent.type.endswith("default_parameter")
