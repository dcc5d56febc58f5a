"""Functions that an edit leaves with nobody to call them."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator, Sequence

from plastron_tui.diagnostics import Diagnostic, Span, codes, listed
from plastron_tui.model.source import Change, Remove, Update

from ..analysis import Analysis
from ..scopes import Function, Variable
from .deletions import Deletions
from .lambdas import lambda_of
from .leftovers import has_uses
from .uses import uses_of

_WORD = re.compile(rb"[A-Za-z_]\w*")
_CALLED_BY_OTHERS = re.compile(rb"\b(?:override|virtual|final)\b")


def uncalled_functions(before: Analysis, after: Analysis) -> list[Function]:
    """Return the functions that the files called before and do not call any more."""
    # What is written anew may say the name in its log.
    rarer = {word.decode() for word in _words(before) - _words(after)}
    rarer |= _callbacks(before) - _callbacks(after)
    was_called = {name for name, _ in _uncalled(before, rarer)}
    return [each for name, each in _uncalled(after, rarer) if name not in was_called]


def uncalled_lambdas(before: Analysis, after: Analysis) -> list[Variable]:
    """Return the variables whose lambdas endpoints called before, and nothing calls any more."""
    lambdas = (lambda_of(before, site) for site in before.sites)
    names = {each.variable.name for each in lambdas if each is not None and each.variable}
    return [
        variable
        for scope in after.unit.scopes()
        for name in sorted(names & scope.variables.keys())
        for variable in scope.variables[name]
        if variable.value is not None
        and variable.value.type == "lambda_expression"
        and not variable.file.is_beside
        and not any(uses_of(after, variable))
    ]


def tell_uncalled(
    found: Sequence[Function | Variable], changes: Sequence[Change]
) -> Iterator[Diagnostic]:
    """Warn of functions that the files do not call any more."""
    if not found:
        return
    names = listed(
        f"`{each.name}` (line {each.file.place_of(each.node.start_point.row + 1)})"
        for each in found
    )
    message = f"nothing in the file calls {names} any more"
    it = "it if it is" if len(found) == 1 else "them if they are"
    span = span_of(changes)
    yield Diagnostic(codes.UNCALLED_FUNCTION, message, span, help=f"remove {it} of no other use")


def _callbacks(analysis: Analysis) -> set[str]:
    return {site.endpoint.callback for site in analysis.sites if site.endpoint.callback}


def _words(analysis: Analysis) -> Counter[bytes]:
    found: Counter[bytes] = Counter()
    for file in analysis.unit.files:
        found.update(_WORD.findall(file.syntax.code))
    return found


def _uncalled(analysis: Analysis, names: set[str]) -> Iterator[tuple[tuple[str, str], Function]]:
    """Yield the functions of some names that nothing names, with their class and name."""
    nothing = Deletions()
    for name in sorted(names & analysis.unit.functions.keys()):
        for functions in analysis.unit.functions_by_class(name):
            class_name = functions[0].class_name
            defined = [each for each in functions if each.scope is not None]
            if not defined or defined[0].file.is_beside or name == class_name:
                continue
            if any(map(_is_called_by_others, functions)) or name == "main":
                continue
            if not has_uses(analysis, functions, nothing):
                yield (class_name, name), defined[0]


def _is_called_by_others(function: Function) -> bool:
    body = function.body
    end = function.node.end_byte if body is None else body.start_byte
    code = function.file.syntax.code[function.node.start_byte : end]
    return _CALLED_BY_OTHERS.search(code) is not None


def span_of(changes: Sequence[Change]) -> Span | None:
    """Return the first statement that takes something out."""
    spans = [each.span for each in changes if isinstance(each, Remove | Update)]
    return spans[0] if spans else None
