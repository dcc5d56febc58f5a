"""What an endpoint that is taken out of a file leaves without a purpose."""

from __future__ import annotations

import re
from collections.abc import Sequence

from tree_sitter import Node

from .analysis import Analysis, Site
from .creation import Removal
from .endings import destroying
from .functions import callback_scope, definition, function_uses, timers_of
from .generated import body_of, is_stub
from .log_uses import is_telling
from .purity import is_pure
from .references import Use, Variable, function_of, references, statement_of
from .scopes import Scope
from .splices import Splice
from .syntax import parts_of
from .unused_attributes import is_plain_class

_LOGGING = frozenset(
    {"debug", "info", "logdebug", "loginfo", "loginfo_once", "loginfo_throttle", "print"}
)
_PUBLISHES = b".publish("
_SENT = re.compile(rb"\b(publish|sent\b|sending\b)", re.IGNORECASE)
_MADE = re.compile(rb"subscri|publish|advertis|servi|client", re.IGNORECASE)
_WORD = re.compile(rb"\w+(?:/\w+)*")


def placeholders(analysis: Analysis, variable: Variable, removal: Removal) -> list[Node]:
    """Return the statements that only make room for what is gone: `self.pub = None`."""
    ranges = [(each.start_byte, each.end_byte) for each in removal.statements]
    ranges += [(each.start, each.end) for each in removal.splices]
    left = [
        each
        for each in references(variable, analysis)
        if not any(start <= each.node.start_byte < end for start, end in ranges)
    ]
    if any(each.use is not Use.NOTHING for each in left):
        return []
    return [each.statement for each in left if len(parts_of(each.statement)) == 1]


def sending_logs(analysis: Analysis, removal: Removal) -> list[Node]:
    """Return the lines beside what is gone that log nothing but that: `loginfo('published')`.

    Beside what publishes they say so; beside what creates an endpoint, or a timer of it, they say
    its name or its type as well.
    """
    found = []
    names = _names_of(removal.sites)
    left = _names_of([site for site in analysis.sites if site not in removal.sites])
    gone = {each.id for each in removal.statements}
    for statement in removal.statements:
        text = statement.text or b""
        is_sending = _PUBLISHES in text
        block = statement.parent
        beside = [_beside(statement, "prev"), _beside(statement, "next")]
        if block is None or (is_sending and _sends_more(block, removal)):
            continue
        for each in beside:
            said = _logged(analysis, each) if each is not None else None
            if (
                each is None
                or said is None
                or each.id in gone
                or (_SENT if is_sending else _MADE).search(said) is None
            ):
                continue
            if is_sending or (_names(said, names) and not _names(said, left)):
                found.append(each)
    return list({each.id: each for each in found}.values())


def _names_of(sites: Sequence[Site]) -> set[str | None]:
    """Return the names and the types of endpoints."""
    names = {site.endpoint.name for site in sites}
    return names | {site.endpoint.type.name for site in sites if site.endpoint.type is not None}


def _beside(statement: Node, side: str) -> Node | None:
    """Return the statement before or behind another one; a comment between them is none."""
    found: Node | None = getattr(statement, f"{side}_named_sibling")
    while found is not None and found.type == "comment":
        found = getattr(found, f"{side}_named_sibling")
    return found


def _sends_more(block: Node, removal: Removal) -> bool:
    """Whether a block goes on to publish something else."""
    gone = {each.id for each in removal.statements}
    return any(_PUBLISHES in (each.text or b"") for each in parts_of(block) if each.id not in gone)


def _names(said: bytes, names: set[str | None]) -> bool:
    """Whether a text has one of some endpoints' names in it."""
    words = set(_WORD.findall(said))
    return any(name and name.strip("~/").encode() in words for name in names)


def _logged(analysis: Analysis, statement: Node) -> bytes | None:
    """Return what a statement logs, where it does nothing besides."""
    call = statement.named_children[0] if statement.named_children else statement
    if statement.type == "print_statement":
        return statement.text if is_pure(analysis, call) else None
    if statement.type != "expression_statement" or call.type != "call":
        return None
    callee, arguments = (call.child_by_field_name(each) for each in ("function", "arguments"))
    is_log = analysis.syntax.called_name(call) in _LOGGING
    if callee is None or arguments is None or not is_log or not is_telling(analysis, callee):
        return None
    return arguments.text if is_pure(analysis, arguments) else None


def remove_idle(analysis: Analysis, removal: Removal) -> bool:
    """Remove the functions of which nothing is left, with the timers and lines that call them.

    Returns:
        Whether there were any.
    """
    before = len(removal.statements)
    gone = {(each.start_byte, each.end_byte) for each in removal.statements}
    scopes = (analysis.scopes.at(start).enclosing("function") for start, _ in gone)
    for function in {each.node.id: each for each in scopes if each is not None}.values():
        whole = definition(function)
        if not _is_within(whole, gone) and _is_inherited_alike(function, gone):
            removal.statements.append(whole)
            continue
        if _is_within(whole, gone) or not _is_emptied(function, gone):
            continue
        timers = timers_of(analysis, function)
        uses = [use for use in function_uses(analysis, function) if not _is_within(use, gone)]
        calls = [_called_alone(analysis, function, use, timers) for use in uses]
        ends = [destroying(analysis, timer) for timer in timers]
        if not uses or None in calls or None in ends:
            continue
        removal.sites += timers
        removal.statements += [whole, *(each for each in calls if each is not None)]
        removal.statements += [each for listed in ends for each in listed or ()]
    return len(removal.statements) > before


def _is_within(node: Node, gone: set[tuple[int, int]]) -> bool:
    return any(start <= node.start_byte and node.end_byte <= end for start, end in gone)


def _is_emptied(function: Scope, gone: set[tuple[int, int]]) -> bool:
    """Whether nothing is left of a function that no decorator, base class or file may call."""
    owner = function.parent
    is_inherited = owner is not None and owner.kind == "class" and not is_plain_class(owner)
    if function.name.startswith("__") or function.name == "main" or is_inherited:
        return False
    return not _is_decorated(function) and all(
        each.type == "pass_statement" or _is_within(each, gone) for each in body_of(function)
    )


def _is_inherited_alike(function: Scope, gone: set[tuple[int, int]]) -> bool:
    """Whether nothing is left of a constructor or `__del__`, and each object has one like it."""
    owner, block = function.parent, function.node.child_by_field_name("body")
    is_own = function.name in ("__init__", "__del__") and list(function.bindings) == ["self"]
    if not is_own or block is None or owner is None or owner.kind != "class":
        return False
    is_plain = all(each.text == b"object" for each in owner.bases)
    # A comment above the first statement is no part of the block.
    parts = [each for each in function.node.children if each.type == "comment"] + block.children
    return (
        is_plain and not _is_decorated(function) and all(_is_within(each, gone) for each in parts)
    )


def _called_alone(
    analysis: Analysis, function: Scope, use: Node, timers: list[Site]
) -> Node | None:
    """Return the statement that does nothing but call a function, or create its timer."""
    statement = statement_of(use)
    inner = statement.named_children[0] if statement.named_child_count == 1 else None
    if statement.type != "expression_statement" or inner is None:
        return None
    for timer in timers:
        if timer.call.start_byte <= use.start_byte < timer.call.end_byte:
            made = inner.child_by_field_name("right") if inner.type == "assignment" else inner
            # What waits for one thing to be done may wait for the timer.
            is_woken = b"spin_once" in analysis.syntax.text
            return statement if made == timer.call and not is_woken else None
    callee, arguments = (inner.child_by_field_name(each) for each in ("function", "arguments"))
    if callee is None or arguments is None or not is_pure(analysis, arguments):
        return None
    name = callee.child_by_field_name("attribute") or callee
    is_own = name == use and function_of(callee, analysis) is function
    return statement if is_own else None


def stub_callbacks(analysis: Analysis, sites: list[Site], gone: list[Splice]) -> list[Node]:
    """Return the stubs that nothing refers to once the call sites are gone."""
    found = []
    for site in sites:
        function = callback_scope(analysis, site)
        if function is None or not is_stub(analysis, function, site):
            continue
        uses = function_uses(analysis, function)
        inside = all(
            any(splice.start <= node.start_byte < splice.end for splice in gone) for node in uses
        )
        if inside and not _is_decorated(function):
            found.append(definition(function))
    return found


def _is_decorated(function: Scope) -> bool:
    """Whether a decorator may give the function to others."""
    return definition(function).type == "decorated_definition"
