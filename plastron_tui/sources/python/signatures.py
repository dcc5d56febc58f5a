"""How a file writes its functions: what they call what they get, its types, what they do."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from tree_sitter import Node

from plastron_tui.model.source import EndpointKind

from .analysis import Analysis, Site
from .functions import callback_scope
from .generated import is_docstring
from .handed_on import handed_by_partial
from .scopes import Scope
from .syntax import parts_of

_TYPED = frozenset({"typed_parameter", "typed_default_parameter"})
_PLAIN = re.compile(r"\w|_?(msg|message|data|req|request|res|resp|response|event|input|arg)_?")
# A file of fewer functions tells nothing by what they leave out.
_FEW = 2


@dataclass(frozen=True, slots=True)
class Signatures:
    """How the functions of a file are written.

    Attributes:
        says_types: whether most of them say the types of what they get.
        says_returns: whether most of them say what they return.
        is_documented: whether most of them say what they do.
        is_silent: whether none of them does.
    """

    says_types: bool
    says_returns: bool
    is_documented: bool
    is_silent: bool

    def head(self, name: str, parameters: Iterable[tuple[str, str]], returns: str) -> str:
        """Return the first line of a function.

        Args:
            name: the function's name.
            parameters: names, each with its type, "" for one that has none.
            returns: the type of what it returns.
        """
        listed = ", ".join(
            f"{each}: {type_}" if type_ and self.says_types else each for each, type_ in parameters
        )
        end = f" -> {returns}" if returns and self.says_returns else ""
        return f"def {name}({listed}){end}:"


def signatures_of(analysis: Analysis, kind: EndpointKind) -> Signatures:
    """Find out how a file writes its functions, above all the callbacks of a kind."""
    functions = [scope for scope in analysis.scopes.all if scope.node.type == "function_definition"]
    models = _callbacks(analysis, (kind,)) or _callbacks(analysis, EndpointKind) or functions
    taking = [scope for scope in models if _parameters(scope)]
    # `main(args=None)` is often the one function that nobody annotates.
    taking = taking or [scope for scope in functions if _parameters(scope) and scope.self_name]
    documented = sum(map(_is_documented, functions))
    says_returns = _are_most(
        [scope.node.child_by_field_name("return_type") is not None for scope in models]
    )
    typed = [any(each.type in _TYPED for each in _parameters(scope)) for scope in taking]
    return Signatures(
        _are_most(typed) if typed else says_returns,
        says_returns,
        documented * 2 > len(functions),
        not documented and len(functions) >= _FEW,
    )


def parameter_names(analysis: Analysis, kind: EndpointKind, usual: Sequence[str]) -> list[str]:
    """Return what the callbacks of a kind call what they get, as most of the file's do."""
    found: list[Counter[str]] = [Counter() for _ in usual]
    for site, scope in _called(analysis, (kind,)):
        given = site.arguments.get(site.shape.callback) if site.shape.callback else None
        wrapped = handed_by_partial(analysis, site, given) if given is not None else None
        first = len(wrapped[1].before) if wrapped is not None else 0
        for count, each in zip(found, _parameters(scope)[first:], strict=False):
            inner = each.named_children[0] if each.type == "typed_parameter" else each
            name = analysis.syntax.slice(inner)
            if inner.type == "identifier" and not name.startswith("_"):
                count[name] += 1
    names = [
        next((name for name, number in count.most_common() if _is_plain(name, number)), each)
        for count, each in zip(found, usual, strict=True)
    ]
    return names if len({*names}) == len(names) else list(usual)


def _is_plain(name: str, number: int) -> bool:
    """Whether a name fits a message of any type: `twist` in one callback does not."""
    return number > 1 or _PLAIN.fullmatch(name) is not None


def _callbacks(analysis: Analysis, kinds: Iterable[EndpointKind]) -> list[Scope]:
    return [scope for _, scope in _called(analysis, kinds)]


def _called(analysis: Analysis, kinds: Iterable[EndpointKind]) -> list[tuple[Site, Scope]]:
    """Return the callbacks of some kinds, each with the last call that hands it on."""
    found: dict[int, tuple[Site, Scope]] = {}
    wanted = set(kinds)
    for site in analysis.sites:
        scope = callback_scope(analysis, site) if site.endpoint.kind in wanted else None
        if scope is not None and scope.node.type == "function_definition":
            found[scope.node.id] = site, scope
    return list(found.values())


def _parameters(scope: Scope) -> list[Node]:
    """Return the parameters of a function, the object of a method left out."""
    return parts_of(scope.node.child_by_field_name("parameters"))[1 if scope.self_name else 0 :]


def _is_documented(scope: Scope) -> bool:
    first = next(iter(parts_of(scope.node.child_by_field_name("body"))), None)
    return first is not None and is_docstring(first)


def _are_most(said: Sequence[bool]) -> bool:
    return sum(said) * 2 > len(said)
