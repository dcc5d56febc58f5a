"""Lines that go on saying a name which an edit took out of the files."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from plastron_tui.diagnostics import Diagnostic, codes, listed
from plastron_tui.model.source import Change
from plastron_tui.sources.gone_names import gone_name, is_surely_name
from plastron_tui.sources.splices import line_end, line_number, line_start

from ..analysis import Analysis
from ..scopes import CppFile

# Shorter names are words as well.
_FEWEST_LETTERS = 4
# Frames of tf often have the names of topics.
_OTHER = re.compile(rb"frame|transform|\btf", re.IGNORECASE)
_COMMENTED_CODE = re.compile(rb"//.*[;{}(]\s*\Z")


def tell_still_named(after: Analysis, changes: Sequence[Change]) -> Iterator[Diagnostic]:
    """Warn of the lines that say what is called otherwise now, or gone.

    That are strings which are the name, what is logged with it, and comments.
    """
    left = {
        (site.endpoint.name or site.endpoint.default or "").lstrip("~/") for site in after.sites
    }
    for change in changes:
        old, span = gone_name(change)
        bare = (old or "").lstrip("~/")
        if old is None or bare in left or len(bare) < _FEWEST_LETTERS:
            continue
        found = [file.place_of(line) for file, line in _lines(after, bare)]
        if found:
            lines = listed(dict.fromkeys(found))
            says = "line {} still says" if len(set(found)) == 1 else "lines {} still say"
            message = f"{says.format(lines)} `{old}`"
            yield Diagnostic(codes.STILL_NAMED, message, span, help="change it by hand")


def _lines(analysis: Analysis, bare: str) -> Iterator[tuple[CppFile, int]]:
    word = re.compile(rb"(?<![\w/.}>-])[~/]*%s(?![\w/{]|[.-]\w)" % re.escape(bare.encode()))
    for file in analysis.unit.files:
        if file.is_beside:
            continue
        text = file.syntax.text
        for found in word.finditer(text):
            around = text[line_start(text, found.start()) : line_end(text, found.start())]
            if not _OTHER.search(around) and _says(analysis, file, found, around, bare):
                yield file, line_number(text, found.start())


def _says(
    analysis: Analysis, file: CppFile, found: re.Match[bytes], around: bytes, bare: str
) -> bool:
    """Tell whether a string or a comment says the name for sure."""
    syntax = file.syntax
    start, end = found.span()
    is_sure = is_surely_name(found[0], bare, around)
    if not syntax.code[start:end].strip():
        is_code = _COMMENTED_CODE.search(around.rstrip()) is not None
        is_word = bare in analysis.unit.functions or _names_variable(analysis, bare)
        return is_sure and not is_code and not (is_word and found[0] == bare.encode())
    node = syntax.root.named_descendant_for_byte_range(start, end)
    if node is None or node.type not in ("string_literal", "string_content"):
        return False
    whole = node if node.type == "string_literal" else node.parent
    if whole is None or _names_node(analysis, file, start):
        return False
    is_whole = syntax.slice(whole).strip('"').lstrip("~/") == bare
    return is_whole or is_sure


def _names_variable(analysis: Analysis, name: str) -> bool:
    return any(name in scope.variables for scope in analysis.unit.scopes())


def _names_node(analysis: Analysis, file: CppFile, at: int) -> bool:
    """Whether a text is given to what makes a node."""
    return any(
        each.file is file and each.place.start_byte <= at < each.place.end_byte
        for each in analysis.nodes
        if each.place.type not in ("class_specifier", "struct_specifier")
    )
