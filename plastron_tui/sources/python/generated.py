"""What Plastron writes into nodes, told from what people write there."""

from __future__ import annotations

import re
from collections.abc import Iterator

from tree_sitter import Node

from plastron_tui.model.source import EndpointKind

from .analysis import Analysis, Site
from .references import Reference
from .scopes import Scope
from .syntax import parts_of

_SENDING = re.compile(r"_?(publish|call)(_|[A-Z])")
_LOGGERS = re.compile(r"_*(log_?)?info(_?msg)?|print")
# `chatter: %s`, `chatter: {}`, `chatter: {message}`: what a stub logs.
_LABELLED = re.compile(r"[\w/~]+: (%s|\{\w*\})$")


def body_of(function: Scope) -> list[Node]:
    """Return the statements of a function, its docstring and comments left out."""
    block = function.node.child_by_field_name("body")
    if block is None:
        return []
    statements = parts_of(block)
    if statements and is_docstring(statements[0]):
        statements = statements[1:]
    return statements


def has_comments(function: Scope) -> bool:
    """Whether a function holds a comment: then someone has been at work in it."""
    pending = [function.node]
    while pending:
        node = pending.pop()
        if node.type == "comment":
            return True
        pending.extend(node.named_children)
    return False


def is_docstring(statement: Node) -> bool:
    """Whether a statement is a text and nothing else."""
    children = statement.named_children
    return (
        statement.type == "expression_statement"
        and len(children) == 1
        and children[0].type in ("string", "concatenated_string")
    )


def is_stub(analysis: Analysis, function: Scope, site: Site) -> bool:
    """Whether a callback does nothing: it logs what it got, and returns a default response."""
    if has_comments(function) or function.node.children[0].type == "async":
        return False
    parameters = [name for name in function.bindings if name != function.self_name]
    return all(
        _is_idle(analysis, statement, parameters, site.endpoint.kind, function.name)
        for statement in body_of(function)
    )


def _is_idle(
    analysis: Analysis,
    statement: Node,
    parameters: list[str],
    kind: EndpointKind,
    function: str,
) -> bool:
    if statement.type == "pass_statement":
        return True
    children = statement.named_children
    if statement.type == "return_statement":
        return not children or _is_default_response(analysis, children[0], parameters, kind)
    if statement.type != "expression_statement" or len(children) != 1:
        return False
    if kind is EndpointKind.TIMER and _logs_text(analysis, children[0], function):
        return True
    return children[0].type == "ellipsis" or _is_log(analysis, children[0], parameters)


def _logs_text(analysis: Analysis, call: Node, text: str) -> bool:
    """Whether a call logs a text, as often as a timer's stub does."""
    given = parts_of(call.child_by_field_name("arguments")) if call.type == "call" else []
    logger = analysis.syntax.called_name(call).removesuffix("_throttle") if given else ""
    return (
        bool(given)
        and _LOGGERS.fullmatch(logger) is not None
        and any(_content(analysis, each) == text for each in given)
    )


def _is_default_response(
    analysis: Analysis, value: Node, parameters: list[str], kind: EndpointKind
) -> bool:
    if kind is not EndpointKind.SERVICE:
        return value.type == "none"
    if value.type == "identifier":
        return analysis.syntax.slice(value) in parameters[1:]
    arguments = value.child_by_field_name("arguments")
    callee = value.child_by_field_name("function")
    return (
        value.type == "call"
        and arguments is not None
        and arguments.named_child_count == 0
        and callee is not None
        and analysis.syntax.slice(callee).endswith("Response")
    )


def _is_log(analysis: Analysis, call: Node, parameters: list[str]) -> bool:
    """Whether a call logs the whole message, as Plastron's stubs do, and nothing else."""
    arguments = call.child_by_field_name("arguments")
    if call.type != "call" or arguments is None:
        return False
    if _LOGGERS.fullmatch(analysis.syntax.called_name(call)) is None:
        return False
    given = [part for node in parts_of(arguments) for part in _filled(analysis, node)]
    return (
        bool(given)
        and bool(_LABELLED.match(_content(analysis, given[0])))
        and all(_is_message(analysis, node, parameters) for node in given)
    )


def _filled(analysis: Analysis, node: Node) -> list[Node]:
    """Return a text and what `%` or `format` puts into it, or else the node."""
    if node.type == "binary_operator":
        return [each for each in node.named_children if each.type != "comment"]
    callee = node.child_by_field_name("function")
    if callee is None or analysis.syntax.called_name(node) != "format":
        return [node]
    return [*callee.named_children[:1], *parts_of(node.child_by_field_name("arguments"))]


def _content(analysis: Analysis, node: Node) -> str:
    if node.type != "string" or node.child_count < 2:
        return ""
    return analysis.syntax.between(node.children[0].end_byte, node.children[-1].start_byte)


def _is_message(analysis: Analysis, node: Node, parameters: list[str]) -> bool:
    if node.type == "identifier":
        return analysis.syntax.slice(node) in parameters
    if node.type != "string":
        return False
    return all(
        child.named_child_count == 1
        and child.named_children[0].type == "identifier"
        and analysis.syntax.slice(child.named_children[0]) in parameters
        for child in node.named_children
        if child.type == "interpolation"
    )


def is_publishing_function(
    analysis: Analysis, function: Scope, publishing: list[Reference]
) -> bool:
    """Whether a function does nothing but fill in messages and send them on one publisher."""
    if not is_named_as_own(function) or has_comments(function):
        return False
    sending = {reference.statement.id for reference in publishing}
    statements = body_of(function)
    return any(statement.id in sending for statement in statements) and all(
        statement.id in sending or _fills_message(analysis, statement) for statement in statements
    )


def _fills_message(analysis: Analysis, statement: Node) -> bool:
    children = statement.named_children
    if len(children) != 1 or children[0].type != "assignment":
        return False
    target = children[0].child_by_field_name("left")
    return target is not None and analysis.syntax.slice(target) in (
        "message",
        "message.header.stamp",
    )


_SERVING = re.compile(r"_?(publish|call|send|repeat|await|follow)(_|[A-Z])")
# What the functions say that Plastron lets timers call for something else.
_SERVING_SUMMARIES = re.compile(
    r"Publish to |Call |Send |Warn as long as |Start timers anew|Ask again|.* once it is there"
)
# What these do, beside filling in messages.
_SERVING_CALLS = re.compile(
    r"publish|warning|logwarn(_throttle)?|logerr|loginfo|info|error|cancel|shutdown|reset"
    r"|call(_\w+)?|send_\w+|wait_\w+|ask|add_done_callback"
)


def serves(analysis: Analysis, function: Scope | None) -> bool:
    """Whether a timer's function is a part of something else that Plastron writes."""
    if function is None or _SERVING.match(function.name) is None:
        return False
    if not all(map(_SERVING_CALLS.fullmatch, _called_in(analysis, function.node))):
        return False
    block = function.node.child_by_field_name("body")
    first = next(iter(parts_of(block)), None) if block is not None else None
    if first is not None and is_docstring(first):
        text = analysis.syntax.slice(first).lstrip("rub'\"")
        return _SERVING_SUMMARIES.match(text) is not None
    statements = body_of(function)
    return bool(statements) and all(
        _fills_message(analysis, each) or _publishes(analysis, each) for each in statements
    )


def _called_in(analysis: Analysis, block: Node) -> Iterator[str]:
    """Yield the names of what the statements of a block call, at any depth."""
    for each in block.named_children:
        if each.type == "expression_statement":
            call = each.named_children[0]
            if call.type == "await":
                call = call.named_children[0]
            if call.type == "call":
                yield analysis.syntax.called_name(call)
        elif each.type.endswith(("block", "statement", "clause")):
            yield from _called_in(analysis, each)


def _publishes(analysis: Analysis, statement: Node) -> bool:
    call = next(iter(statement.named_children), None)
    is_call = statement.type == "expression_statement" and call is not None and call.type == "call"
    return is_call and call is not None and analysis.syntax.called_name(call) == "publish"


_CALLING = frozenset(
    {"expression_statement", "try_statement", "if_statement", "return_statement", "pass_statement"}
)
_REPEATING_SUMMARY = "if it is there, and log its answer."
# The first is also what rospy nodes said before.
_CALLING_SUMMARIES = (
    "once it is there, and log its answer.",
    _REPEATING_SUMMARY,
    "within 10 s, and log its answer.",
)


def is_calling_function(analysis: Analysis, function: Scope) -> bool:
    """Whether a function does what Plastron writes to call one service, and nothing else."""
    block = function.node.child_by_field_name("body")
    if not is_named_as_own(function) or has_comments(function) or block is None:
        return False
    if not any(each in analysis.syntax.slice(block)[:200] for each in _CALLING_SUMMARIES):
        return False
    pending = body_of(function)
    while pending:
        statement = pending.pop()
        if statement.type not in _CALLING:
            return False
        for child in statement.named_children:
            if child.type == "assignment":
                left = child.child_by_field_name("left")
                if left is None or analysis.syntax.slice(left) not in ("response", "future"):
                    return False
            elif child.type in ("block", "except_clause", "else_clause"):
                inner = [child] if child.type == "block" else child.named_children
                pending += [
                    each
                    for block in inner
                    if block.type == "block"
                    for each in block.named_children
                ]
    return True


def repeats_call(analysis: Analysis, node: Node) -> bool:
    """Whether a node is in a function that Plastron wrote to call a service at a rate."""
    function = analysis.scopes.at(node.start_byte).enclosing("function")
    return (
        function is not None
        and is_calling_function(analysis, function)
        and _REPEATING_SUMMARY in analysis.syntax.slice(function.node)
    )


# What the methods of Plastron's templates call that ask a server, and how they wait for it.
_ASKING = {
    "call_": ("call", ("wait_until_served", "is_served")),
    "send_": ("send_goal", ("wait_until_served", "wait_for_action")),
}


def is_asking_function(analysis: Analysis, function: Scope) -> bool:
    """Whether a method does what Plastron's templates write to ask one server, and no more."""
    prefix = next((each for each in _ASKING if function.name.startswith(each)), None)
    if prefix is None or has_comments(function) or not function.self_name:
        return False
    asking, waiting = _ASKING[prefix]
    called = set()
    pending = body_of(function)
    while pending:
        statement = pending.pop()
        call = next(iter(parts_of(statement)), None)
        if statement.type == "if_statement" and not statement.child_by_field_name("alternative"):
            pending += parts_of(statement.child_by_field_name("consequence"))
        elif statement.type != "expression_statement":
            return False
        if call is not None and call.type == "await":
            call = next(iter(call.named_children), None)
        callee = call.child_by_field_name("function") if call is not None else None
        if callee is None:
            return False
        called.add(analysis.syntax.slice(callee))
    asks, *waits = (f"{function.self_name}.{each}" for each in (asking, *waiting))
    return asks in called and called <= {asks, *waits}


_REPEATED_TASK = re.compile(
    r"def repeat_\w+\((\w+)\):\s+(?:\"\"\"|''').*; called at its rate\.(?:\"\"\"|''')\s+"
    r"calls = \1\.(?P<task>\w+)\s+# The last answer may still have to come\.\s+"
    r"if calls is None or calls\.done\(\):\s+calls = \1\.executor\.create_task\(\1\.\w+\)\s+"
    r"\1\.(?P=task) = calls\s*"
)


def repeated_task(analysis: Analysis, function: Scope) -> str | None:
    """Return the attribute in which a function of rclpy's templates keeps the call that it repeats.

    None where the function does something else as well.
    """
    found = _REPEATED_TASK.fullmatch(analysis.syntax.slice(function.node))
    return found["task"] if found is not None else None


_SENDS_ONCE = re.compile(
    r"def \w+\([^)]*\)[^:]*:\s+(?:\"\"\"|''')Publish to [^\n]*, once: when somebody listens\."
    r"(?:\"\"\"|''')\s+(?:(?:global|nonlocal) \w+\s+)?was_heard = (?P<heard>[\w.]+)\s+"
    r"(?P=heard) = (?P<publisher>[\w.]+)\.get_subscription_count\(\) > 0\s+"
    r"if (?:was_heard and (?P=heard)|not (?P=heard):\s+.*\s+elif was_heard):\s+"
    r"# A subscription [^\n]*\s+(?P<timer>[\w.]+)\.cancel\(\)\s.*",
    re.DOTALL,
)


def sent_once(analysis: Analysis, function: Scope) -> re.Match[str] | None:
    """Return what a function names that sends something once, None for others."""
    return _SENDS_ONCE.fullmatch(analysis.syntax.slice(function.node))


def is_named_as_own(function: Scope) -> bool:
    """Whether a function is called as those that Plastron writes to send something."""
    return _SENDING.match(function.name) is not None


def is_own_helper(function: Scope) -> bool:
    """Whether a function is the one that Plastron writes to call services with."""
    return function.name == "call" and list(function.bindings)[1:3] == ["client", "request"]


def is_own_call(analysis: Analysis, reference: Reference) -> bool:
    """Whether a use is `self.call(self.client, request)` with the method that Plastron writes."""
    arguments = reference.node.parent
    call = arguments.parent if arguments is not None else None
    if arguments is None or call is None or call.type != "call":
        return False
    if analysis.syntax.called_name(call) != "call" or arguments.named_child_count != 2:
        return False
    helper = next(
        (
            scope
            for scope in analysis.scopes.all
            if scope.kind == "function" and scope.name == "call"
        ),
        None,
    )
    parent = call.parent
    if parent is not None and parent.type == "await":
        parent = parent.parent
    return (
        helper is not None
        and list(helper.bindings)[1:3] == ["client", "request"]
        and parent is not None
        and parent.type == "expression_statement"
        and arguments.named_children[0].id == reference.node.id
    )
