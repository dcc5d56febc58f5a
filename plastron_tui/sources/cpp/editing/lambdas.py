"""Lambdas that a unit's endpoints call, and new ones written as those are."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass

from tree_sitter import Node

from plastron_tui.model.source import EndpointKind

from ..analysis import Analysis, Site
from ..scopes import Function, Scope, Variable
from .adding import Addition
from .style import Style

K = EndpointKind

_CALLING = (K.SUBSCRIPTION, K.SERVICE, K.TIMER)
_SIMPLE = re.compile(r"\[(?:[&=]|this|\*this)(?:,(?:this|\*this))?\]")
_HANDED = re.compile(
    r"\{\s*(?:return\s+)?(?:this->)?(\w+)\(\s*(?:\w+|std::move\(\w+\))?"
    r"(?:\s*,\s*(?:\w+|std::move\(\w+\)))*\s*\);\s*\}"
)


@dataclass(frozen=True, slots=True)
class Lambda:
    """A lambda that an endpoint calls.

    Attributes:
        site: the call that is handed it.
        scope: the scope of its body.
        variable: the local variable that holds it, None where it stands in the call.
    """

    site: Site
    scope: Scope
    variable: Variable | None

    @property
    def function(self) -> Function | None:
        """Its parameters and its body, None where it has no list of parameters."""
        return self.scope.function

    @property
    def body(self) -> Node | None:
        """Its block."""
        return self.scope.node.child_by_field_name("body")

    @property
    def handed_to(self) -> str:
        """The function that it does nothing but call; "" where it does anything else."""
        text = "" if self.body is None else self.scope.file.syntax.word(self.body)
        found = _HANDED.fullmatch(text)
        return found[1] if found is not None else ""


def lambda_of(analysis: Analysis, site: Site) -> Lambda | None:
    """Return the lambda that an endpoint calls, None where it calls anything else."""
    position = site.shape.callback
    if position is None or position >= len(site.arguments):
        return None
    node: Node | None = site.arguments[position]
    variable = None
    file = site.place.file
    if node is not None and node.type == "identifier":
        name = file.syntax.word(node)
        variable = analysis.unit.lookup(name, site.call.scope, node.start_byte)
        node = variable.value if variable is not None and variable.kind == "local" else None
    while node is not None and node.type == "call_expression":
        # `boost::function<void(const T &)>([this](const T & x) {…})`
        listed = node.child_by_field_name("arguments")
        given = listed.named_children if listed is not None else []
        node = given[0] if len(given) == 1 else None
    if node is None or node.type != "lambda_expression":
        return None
    own = variable.file if variable is not None else file
    scope = next((each for each in own.scopes if each.node.id == node.id), None)
    return None if scope is None else Lambda(site, scope, variable)


def model_lambda(added: Addition, kind: EndpointKind) -> Lambda | None:
    """Return the lambda that what an endpoint of a kind calls is modelled on.

    None where most of what its like, or else what any endpoint of the node calls, is a function.
    """
    owner, unit = added.owner, added.analysis.unit
    for kinds in ((kind,), _CALLING):
        sites = [
            site
            for site in added.sites
            if site.endpoint.kind in kinds
            and site.shape.callback is not None
            and site.shape.callback < len(site.arguments)
            and unit.class_of(site.call.scope) is owner
            and site.options is None
        ]
        found = [each for site in sites if (each := lambda_of(added.analysis, site)) is not None]
        if not sites:
            continue
        if len(found) * 2 <= len(sites):
            return None
        here = [each for each in found if each.site is added.model(kind)]
        return here[-1] if here else found[-1]
    return None


def handed_functions(analysis: Analysis, site: Site, owner: Scope | None) -> Iterator[Function]:
    """Yield the methods that a lambda does nothing but hand its arguments to."""
    found = lambda_of(analysis, site) if owner is not None else None
    name = found.handed_to if found is not None else ""
    yield from analysis.unit.functions_of(owner, name)


def callback_names(analysis: Analysis, sites: Iterable[Site]) -> Iterator[tuple[EndpointKind, str]]:
    """Yield how what endpoints call is named, with the kind of each endpoint."""
    for site in sites:
        found = lambda_of(analysis, site) if site.endpoint.callback is None else None
        name = found.handed_to if found is not None else site.endpoint.callback
        if name:
            yield site.endpoint.kind, name


def called_functions(analysis: Analysis, site: Site) -> list[Function]:
    """Return the functions that an endpoint calls, or the lambda."""
    if site.callback.functions:
        return list(site.callback.functions)
    found = lambda_of(analysis, site)
    return [found.function] if found is not None and found.function is not None else []


def opening_of(model: Lambda, parameters: str, captures: Sequence[str] | None) -> tuple[str, bool]:
    """Write what stands before the body of a lambda, as that of another one.

    Args:
        model: the other one.
        parameters: its parameters.
        captures: what it takes where the model does not say it for all that are seen; None for
            a method, which takes its object.

    Returns:
        The text, and whether the brace has a line of its own.
    """
    node, syntax = model.scope.node, model.scope.file.syntax
    taken, body = node.child_by_field_name("captures"), model.body
    assert taken is not None and body is not None, "a lambda has both"
    text = "".join(syntax.word(taken).split())
    if _SIMPLE.fullmatch(text) and ("this" in text) <= (captures is None):
        text = syntax.slice(taken)
    elif captures is None:
        text = "[this]"
    else:
        text = f"[{', '.join(dict.fromkeys(captures))}]"
    declarator = node.child_by_field_name("declarator")
    listed = declarator.child_by_field_name("parameters") if declarator is not None else None
    if listed is None:
        between = syntax.between(taken.end_byte, body.start_byte)
        is_broken = "\n" in between
        return f"{text}({parameters})" if parameters else text, is_broken
    gap = syntax.between(taken.end_byte, listed.start_byte)
    between = syntax.between(listed.end_byte, body.start_byte)
    rest = " ".join(between.split())
    if "->" in rest and rest not in ("-> void", "-> bool"):
        rest = ""
    head = f"{text}{' ' if gap else ''}({parameters}){f' {rest}' if rest else ''}"
    return head, "\n" in between


@dataclass(frozen=True, slots=True)
class NewLambda:
    """A lambda that an edit writes.

    Attributes:
        like: the one that it is written as.
        parameters: its parameters.
        body: its statements.
        name: the local variable that holds it, "" where it stands in the call.
        captures: what it takes, see `opening_of`.
    """

    like: Lambda
    parameters: Sequence[str]
    body: Sequence[str]
    name: str = ""
    captures: Sequence[str] | None = None

    def lines(
        self, added: Addition, head: str, before: Sequence[str], tail: str = ");"
    ) -> list[str]:
        """Return the call that is handed it.

        Args:
            added: the endpoint.
            head: what stands before the arguments of the call, with the bracket.
            before: the arguments before it.
            tail: what stands behind it, with the bracket.
        """
        style, used = added.style(added.place.file), added.columns
        text, is_broken = opening_of(self.like, ", ".join(self.parameters), self.captures)
        body = self.like.body
        if self.name:
            lines = with_body(
                f"auto {self.name} = ", [], (text, is_broken), self.body, ";", style, used
            )
            return [*lines, f"{head}{', '.join([*before, self.name])}{tail}"]
        if self.like.handed_to and body is not None and _is_one_line(body):
            # As one finds it: `{call(x);}` or `{ call(x); }`.
            pad = " " if self.like.scope.file.syntax.slice(body)[1:2] == " " else ""
            given = f"{text} {{{pad}{' '.join(self.body)}{pad}}}"
            room = style.width - used - len(style.continuation.expandtabs(4))
            if len(given) + len(tail) <= room:
                return [f"{head}{', '.join([*before, given])}{tail}"]
        return with_body(
            head,
            before,
            (text, is_broken),
            self.body,
            tail,
            style,
            used,
            hanging=_is_hanging(self.like),
        )


def _is_one_line(node: Node) -> bool:
    return bool(node.start_point.row == node.end_point.row)


def _is_hanging(model: Lambda) -> bool:
    """Tell whether a lambda begins in a line below that of the call that is handed it."""
    if model.variable is not None:
        return False
    return bool(model.scope.node.start_point.row > model.site.call.node.start_point.row)


def with_body(
    head: str,
    before: Sequence[str],
    opening: tuple[str, bool],
    body: Sequence[str],
    tail: str,
    style: Style,
    used: int,
    *,
    hanging: bool = False,
) -> list[str]:
    """Return a call whose last argument, or last but what the tail says, is a lambda.

    Args:
        head: what stands before the arguments, with the bracket.
        before: the arguments before the lambda.
        opening: see `opening_of`.
        body: the statements of the lambda.
        tail: what stands behind its brace.
        style: the layout of the file.
        used: the columns that are taken at the place.
        hanging: whether the arguments begin in a line of their own.
    """
    text, is_broken = opening
    brace = 0 if is_broken else 2
    given = "".join(f"{each}, " for each in before)
    inner = [f"\t{each}" if each else "" for each in body]

    def block(first: str) -> list[str]:
        return (
            [first, "{", *inner, f"}}{tail}"] if is_broken else [f"{first} {{", *inner, f"}}{tail}"]
        )

    if not hanging and used + len(head) + len(given) + len(text) + brace <= style.width:
        return block(f"{head}{given}{text}")
    room = style.width - used - len(style.continuation.expandtabs(4)) - brace
    if len(given) + len(text) <= room or not before:
        return [head.rstrip(), *(f"\v{each}" for each in block(f"{given}{text}"))]
    return [head.rstrip(), f"\v{given.rstrip()}", *(f"\v{each}" for each in block(text))]
