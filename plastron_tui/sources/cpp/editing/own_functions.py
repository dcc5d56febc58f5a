"""The functions that Plastron writes for an endpoint, which go with it."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from tree_sitter import Node

from ..analysis import Analysis
from ..scopes import CppFile, Function, Scope, Variable, scope_at
from ..serving_timers import description_of
from .deletions import Deletions
from .leftovers import has_uses
from .uses import word

_WAITS = ("is_served", "wait_until_served", "wait_for_action")
_ASKS = frozenset({"ask", "call", "send_goal"})

# Functions that others need: name, what they are described as, how many statements they have.
_HELPERS = (
    ("accept_goal", "Accept a goal if the node is active.", 2),
    ("ask", "Call a service that is there, and log its answer.", 5),
    ("call", "Call a service that is there, and log its answer.", 4),
    ("fail", "Log an error, unless what was asked was ended.", 1),
    ("goes_on", "Tell whether the node is active, and not ending.", 1),
    ("goes_on", "Tell whether the node is not ending.", 1),
    (
        "is_answered",
        "Wait for what an action server answers; tell whether it came before the server was gone.",
        2,
    ),
    ("is_current", "Tell whether a goal is still the one to work on.", 2),
    ("is_served", "Wait for a service, not too long, and tell whether it is there.", 4),
    ("is_done", "Tell whether nothing is left of what was begun.", 1),
    (
        "send_goal",
        "Send a goal to an action that is served, and log its feedback and its result.",
        11,
    ),
    (
        "send_goal",
        "Send a goal to an action that is served, and log its feedback and its result.",
        13,
    ),
    (
        "send_goal",
        "Send a goal to an action that is served, and log its feedback and its result.",
        6,
    ),
    (
        "start",
        "Do work in a thread of its own, which leaves the node free for its other work.",
        1,
    ),
    (
        "wait_for_action",
        "Wait until somebody serves an action, and warn while nobody does; tell whether it is"
        " served.",
        3,
    ),
    ("wait_until_served", "Wait until somebody serves a name, and warn while nobody does.", 3),
    (
        "wait_until_served",
        "Wait until a service is there, and warn while it is not; tell whether it is.",
        3,
    ),
)
_MEMBER = re.compile(rb"\b\w+_\b")
_ENDS_GOALS = ("Let the work on goals end", "Abort the goals that are worked on")
_STEP = b"// The work of one step goes here."
_GOAL_FUNCTION = re.compile(r"execute_(\w+)|accept_(\w+)_goal|run_(\w+)_goal")
_GOAL_STATEMENTS = {"execute": (4, 5), "accept": (2,), "run": (2,)}


def asking_function(analysis: Analysis, scope: Scope) -> list[Function]:
    """Return the function around a use of a client that does nothing but ask through it.

    It comes with its declarations; there are none where it does anything else.
    """
    function = scope.around
    if function is None or not _only_asks(function):
        return []
    return analysis.unit.with_declarations(function)


def _only_asks(function: Function) -> bool:
    body = function.statements
    return bool(body) and all(_is_asking(each, function.file) for each in body)


def _is_asking(node: Node, file: CppFile) -> bool:
    if node.type != "if_statement" or node.child_by_field_name("alternative") is not None:
        return False
    condition = node.child_by_field_name("condition")
    text = "" if condition is None else file.syntax.word(condition).lstrip("( ")
    inner = node.child_by_field_name("consequence")
    return text.startswith(_WAITS) and inner is not None and _is_part(inner, file)


def _is_part(node: Node, file: CppFile) -> bool:
    """Tell whether a statement makes a request, sets its fields, or sends it."""
    if node.type == "compound_statement":
        return all(_is_part(each, file) for each in node.named_children)
    if node.type in ("declaration", "comment"):
        return True
    inner = node.named_children[0] if node.named_child_count == 1 else None
    if node.type != "expression_statement" or inner is None:
        return False
    if inner.type == "assignment_expression":
        return True
    called = inner.child_by_field_name("function")
    return called is not None and file.syntax.word(called) in _ASKS


def emptied_functions(analysis: Analysis, name: str, gone: Deletions) -> Iterator[list[Function]]:
    """Yield the functions that Plastron wrote to send, or to end goals, and that do nothing now."""
    for own, functions in analysis.unit.functions.items():
        if not own.startswith(("publish_", "end_goals")):
            continue
        defined = [each for each in functions if each.scope is not None]
        if len(defined) != 1 or not defined[0].statements:
            continue
        function = defined[0]
        is_empty = all(
            gone.covers(function.file, each.start_byte)
            or b"lock_guard" in function.file.syntax.code[each.start_byte : each.end_byte]
            for each in function.statements
        )
        if gone.covers(function.file, function.node.start_byte) or not is_empty:
            continue
        starts = (f"Publish to {name};", *_ENDS_GOALS)
        if any(description_of(each).startswith(starts) for each in functions):
            yield functions


def goal_functions(analysis: Analysis, name: str) -> Iterator[list[Function]]:
    """Yield the functions that work on the goals of an action as Plastron writes them."""
    for own, functions in analysis.unit.functions.items():
        found = _GOAL_FUNCTION.fullmatch(own)
        defined = [each for each in functions if each.scope is not None]
        if found is None or len(defined) != 1:
            continue
        function, kind = defined[0], own.partition("_")[0]
        node, text = function.node, function.file.syntax.text
        is_step = kind != "execute" or _STEP in text[node.start_byte : node.end_byte]
        if not is_step or len(function.statements) not in _GOAL_STATEMENTS[kind]:
            continue
        descriptions = (
            f"Work on a goal of {name}.",
            f"Begin the work on a goal of {name}.",
            f"Work on a goal of {name}, after the one before.",
        )
        if any(_is_described(each, line) for each in functions for line in descriptions):
            yield functions


def goal_variables(analysis: Analysis, functions: Sequence[Function]) -> Iterator[Variable]:
    """Yield the members that hold the goals of an action, and the threads that work on them."""
    for function in functions:
        found = _GOAL_FUNCTION.fullmatch(function.name)
        stem = next(each for each in found.groups() if each) if found is not None else ""
        owner = analysis.unit.class_of_function(function)
        for name in (f"{stem}_goal_", f"{stem}_goal_thread_"):
            member = analysis.unit.member(owner, name) if owner is not None else None
            if member is not None:
                yield member


def reading_function(analysis: Analysis, scope: Scope, name: str) -> list[Function]:
    """Return the function that reads a parameter as Plastron writes it, with its declarations."""
    function = scope.around
    if function is None or len(function.statements) not in range(3, 9):
        return []
    found = analysis.unit.with_declarations(function)
    bare = name.removeprefix("~").removeprefix("/")
    description = f"Return the parameter {bare}, or its last good value."
    return found if any(_is_described(each, description) for each in found) else []


def getter_of(analysis: Analysis, name: str) -> Function | None:
    """Return the function that reads a parameter as Plastron writes it, None for none."""
    bare = name.removeprefix("~").removeprefix("/")
    description = f"Return the parameter {bare}, or its last good value."
    for own, functions in analysis.unit.functions.items():
        if own.startswith("get_") and any(_is_described(each, description) for each in functions):
            return functions[0]
    return None


def members_of(analysis: Analysis, function: Function) -> Iterator[Variable]:
    """Yield the members that a function names."""
    owner, body = analysis.unit.class_of_function(function), function.node
    if owner is None:
        return
    for found in _MEMBER.finditer(function.file.syntax.code, body.start_byte, body.end_byte):
        member = analysis.unit.member(owner, found[0].decode())
        if member is not None:
            yield member


def mentions(
    analysis: Analysis, functions: list[Function], gone: Deletions
) -> Iterator[tuple[CppFile, Node, Scope]]:
    """Yield the statements that stay and name a function, each with the function's scope."""
    own = [(each.file, each.node.start_byte, each.node.end_byte) for each in functions]
    for file in analysis.unit.files if functions else ():
        for found in word(functions[0].name).finditer(file.syntax.code):
            at = found.start()
            if gone.covers(file, at) or any(
                each is file and start <= at < end for each, start, end in own
            ):
                continue
            node = file.syntax.root.named_descendant_for_byte_range(at, found.end())
            if node is None or not node.type.endswith("identifier"):
                continue
            statement = _outer_statement(node)
            if statement is not None:
                yield file, statement, scope_at(file, statement.start_byte)


def _outer_statement(node: Node) -> Node | None:
    """Return the statement that a node is in, that around a lambda for what is in one."""
    found, inner = None, node.parent
    while inner is not None and inner.type != "function_definition":
        if inner.type == "lambda_expression":
            found = None
        elif found is None and inner.type in ("expression_statement", "declaration"):
            found = inner
        inner = inner.parent
    return found


def repeating_function(analysis: Analysis, scope: Scope, gone: Deletions) -> list[Function]:
    """Return the function that only begins again what goes, with its declarations."""
    function = scope.around
    if function is None or not function.name.startswith("repeat_"):
        return []
    for each in function.statements:
        if each.type == "declaration" or gone.covers(function.file, each.start_byte):
            continue
        inner = each.child_by_field_name("consequence")
        if each.type != "if_statement" or inner is None:
            return []
        parts = inner.named_children if inner.type == "compound_statement" else [inner]
        if not all(gone.covers(function.file, part.start_byte) for part in parts):
            return []
    return analysis.unit.with_declarations(function)


def unused_helpers(analysis: Analysis, gone: Deletions) -> Iterator[list[Function]]:
    """Yield the functions that Plastron wrote for those that go, and that nothing else uses."""
    nothing = Deletions()
    for name, description, statements in _HELPERS:
        functions = analysis.unit.functions.get(name, [])
        if not functions or all(gone.covers(each.file, each.node.start_byte) for each in functions):
            continue
        defined = [each for each in functions if each.scope is not None]
        if len(defined) != 1 or len(defined[0].statements) != statements:
            continue
        if not any(_is_described(each, description) for each in functions):
            continue
        if has_uses(analysis, functions, nothing) and not has_uses(analysis, functions, gone):
            yield functions


def _is_described(function: Function, description: str) -> bool:
    """Tell whether the first line of the comment above a function is as it was written."""
    return description_of(function) == description
