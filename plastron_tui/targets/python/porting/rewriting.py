"""What both ways of porting do: endpoints in turn, arguments, lines, and opposites."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

from tree_sitter import Node

from plastron_tui.model.source import EndpointKind
from plastron_tui.sources.python.analysis import Site
from plastron_tui.sources.python.constants import Known
from plastron_tui.sources.python.scopes import BindingKind, Scope
from plastron_tui.sources.python.splices import line_start
from plastron_tui.sources.python.syntax import parts_of

from .layout import laid_out
from .port_state import Work

Writer = Callable[[Work, Site, str], str | None]
"""Writes the call that makes an endpoint, with the source of its name; None where it cannot."""


def port_sites(
    work: Work,
    writers: Mapping[EndpointKind, Writer],
    private_name: Callable[[Work, Site, Node], str],
) -> None:
    """Rewrite the calls that make endpoints, inner ones first.

    Args:
        work: the file.
        writers: what writes the call of each kind.
        private_name: writes a name that starts with `~`, which each library takes its own way.
    """
    for site in reversed(work.analysis.first_sites()):
        if site.endpoint.kind not in writers or site.arguments.is_open:
            continue
        name = site.arguments.get(site.shape.name)
        is_typed = site.shape.type is None or site.arguments.get(site.shape.type) is not None
        if name is None or not is_typed:
            continue
        folded = work.analysis.resolver.fold(name, site.scope)
        is_private = isinstance(folded, Known) and str(folded.value).startswith("~")
        written = private_name(work, site, name) if is_private else work.text(name)
        wanted = writers[site.endpoint.kind](work, site, written)
        if wanted is not None:
            work.replace(site.call, laid_out(work, site.call, wanted))


def mark_options(
    work: Work,
    site: Site,
    remedies: Mapping[str, str],
    taken: Sequence[str],
    positions: int | None = None,
) -> None:
    """Mark the options of an endpoint that its new call does not take over.

    Args:
        work: the file.
        site: the endpoint.
        remedies: what to write instead of options.
        taken: the keywords that are taken over, beside those of the name and the type.
        positions: how many positional arguments are, None for any number.
    """
    known = {*taken, site.shape.name.keyword, site.shape.type.keyword if site.shape.type else ""}
    for name, value in site.arguments.keywords.items():
        if name not in known and work.slice(value) not in ("None", "False"):
            work.mark(site.call, name, remedies.get(name))
    for value in site.arguments.positional[positions:] if positions is not None else ():
        if work.slice(value) not in ("None", "False"):
            work.mark(site.call, f"the option {work.slice(value)}")


def given_type(work: Work, site: Site) -> str:
    """Return the source of the type that an endpoint is of."""
    given = site.arguments.get(site.shape.type) if site.shape.type is not None else None
    return work.text(given) if given is not None else ""


def callable_text(text: str) -> str:
    """Return an expression so that it can be called."""
    return text if text.replace(".", "").isidentifier() else f"({text})"


def bound_early(work: Work, given: Node, wanted: str) -> tuple[str, str]:
    """Return the parameter of a lambda that keeps what is given there, and how to speak of it.

    A lambda works out what is in it when it is called: `args` is another one then, in a loop.
    What is the same at all times needs no parameter.
    """
    text = work.text(given)
    if _is_constant(work, given):
        return "", text
    name = work.free_name(wanted)
    return f", {name}={text}", name


def _is_constant(work: Work, given: Node) -> bool:
    """Tell whether an expression is the same at all times: a value, or a function of a name."""
    scope = work.scope(given)
    if isinstance(work.analysis.resolver.fold(given, scope), Known):
        return True
    match given.type:
        case "identifier":
            found = scope.lookup(work.slice(given))
            bindings = found[1] if found is not None else []
        case "attribute":
            bindings = work.analysis.resolver.attribute_bindings(given, scope)
        case "lambda":
            parameters = parts_of(given.child_by_field_name("parameters"))
            return all(each.type == "identifier" for each in parameters)
        case "tuple":
            return all(_is_constant(work, each) for each in parts_of(given))
        case _:
            return given.type in ("integer", "float", "true", "false", "none")
    return all(each.kind in (BindingKind.FUNCTION, BindingKind.IMPORT) for each in bindings)


def parameters_of(function: Scope) -> tuple[Node | None, list[Node]]:
    """Return the list of a function's parameters, and the parameters."""
    listed = function.node.child_by_field_name("parameters")
    return listed, parts_of(listed)


def append_parameter(work: Work, listed: Node, parameters: list[Node], parameter: str) -> None:
    """Let a function take one argument more."""
    if parameters:
        work.insert(parameters[-1].end_byte, f", {parameter}")
    else:
        work.insert(listed.start_byte + 1, parameter)


# Where a `not` needs no parentheses.
_NEGATING = frozenset(
    {"if_statement", "while_statement", "boolean_operator", "parenthesized_expression"}
    | {"return_statement", "assignment"}
)


def replace_by_opposite(work: Work, call: Node, opposite: str) -> None:
    """Rewrite a call as the opposite of another: `not rclpy.ok()` as `rospy.is_shutdown()`."""
    parent = call.parent
    if parent is not None and parent.type == "not_operator":
        work.done.add(call.id)
        work.replace(parent, opposite)
        return
    is_plain = parent is not None and parent.type in _NEGATING
    work.replace(call, f"not {opposite}" if is_plain else f"(not {opposite})")


def first_statement(body: Node) -> Node:
    """Return the first statement of a block, behind its docstring."""
    statements = parts_of(body)
    first = statements[0]
    is_docstring = first.type == "expression_statement" and bool(
        first.named_children and first.named_children[0].type == "string"
    )
    return statements[1] if is_docstring and len(statements) > 1 else first


def begins_line(work: Work, statement: Node) -> bool:
    """Tell whether nothing stands before a statement in its line."""
    text = work.analysis.syntax.text
    return not text[line_start(text, statement.start_byte) : statement.start_byte].strip()


def put_before(work: Work, statement: Node, lines: list[str]) -> None:
    """Insert lines before a statement; in a line with others, comments have no place."""
    text = work.analysis.syntax.text
    if not begins_line(work, statement):
        code = [line for line in lines if not line.startswith("#")]
        work.insert(statement.start_byte, "".join(f"{line}; " for line in code))
        return
    start = line_start(text, statement.start_byte)
    indent = text[start : statement.start_byte].decode("ascii", "replace")
    work.insert(start, "".join(f"{indent}{line}\n" for line in lines))


def time_module(work: Work) -> str:
    """Import the module `time`, and return its name, which the file has for nothing else."""
    bindings = [
        each for scope in work.analysis.scopes.all for each in scope.bindings.get("time", [])
    ]
    if all(each.kind is BindingKind.IMPORT and each.target == "time" for each in bindings):
        work.imports.add("import time")
        return "time"
    name = work.free_name("time_module")
    work.imports.add(f"import time as {name}")
    return name
