"""The loop or the timer of a file that runs at its rate for as long as the node does."""

from __future__ import annotations

import re
from typing import NamedTuple

from tree_sitter import Node

from plastron_tui.model.source import EndpointKind

from .addition import Addition
from .analysis import Analysis, Site
from .functions import callback_scope, function_uses
from .generated import is_named_as_own
from .rates import is_once, loop_rate, timer_rate
from .references import statement_of
from .run_order import Starting, is_sure
from .scopes import Scope
from .syntax import parts_of

_UNTIL_SHUTDOWN = re.compile(r"\(?(not (\w+\.)*is_shutdown\(\)|(\w+\.)*ok\([^()]*\)|True|1)\)?")
# What takes any time, so that a loop around it has no rate.
_WAITING = frozenset(
    {"accept", "input", "raw_input", "readline", "recv", "recvfrom", "spin"}
    | {"spin_until_future_complete", "wait", "wait_for_message", "wait_for_result"}
    | {"wait_for_server", "wait_for_service"}
)
_OF_A_LOOP = frozenset({"break_statement", "continue_statement"})
_LEAVING = _OF_A_LOOP | {"return_statement", "raise_statement"}
_FUNCTIONS = frozenset({"function_definition", "class_definition", "lambda"})
_INTERRUPT = re.compile(rb"Interrupt|Shutdown")


class OwnBlock(NamedTuple):
    """What runs at a rate: its body, and the rate in Hz, None where that is not literal."""

    body: Node
    rate: float | None


def own_block(added: Addition) -> OwnBlock | None:
    """Return the body of the file's single loop or timer, where it can see the publisher."""
    analysis = added.analysis
    loops = [node for node in analysis.captures.get("while", []) if is_loop(added, node)]
    timers = [site for site in analysis.sites if site.endpoint.kind is EndpointKind.TIMER]
    starting = Starting(analysis)
    mains = [node for node in loops if _is_main(added, node, starting)]
    if len(mains or loops) + len(timers) != 1:
        return None
    if loops:
        return _loop_block(added, mains[0]) if mains else None
    return _timer_block(added, timers[0], starting)


def _loop_block(added: Addition, loop: Node) -> OwnBlock | None:
    analysis = added.analysis
    function = analysis.scopes.at(loop.start_byte).enclosing("function") or analysis.scopes.module
    is_later = function is not added.place.scope or loop.start_byte >= added.place.offset
    if not (is_later and _sees(added, function)):
        return None
    body = loop.child_by_field_name("body")
    return OwnBlock(body, loop_rate(analysis, loop)) if body and _is_plain(loop, body) else None


def _timer_block(added: Addition, timer: Site, starting: Starting) -> OwnBlock | None:
    analysis, function = added.analysis, callback_scope(added.analysis, timer)
    if function is None or is_named_as_own(function):
        return None
    body = function.node.child_by_field_name("body")
    if body is None or not _is_plain(function.node, body) or not _sees(added, function):
        return None
    is_alone = len(function_uses(analysis, function)) == 1
    if is_once(timer) or not is_alone or not _is_started(added, timer.call, starting):
        return None
    ends = (b".cancel(", b".shutdown(", b"destroy_timer(")
    if any(word in (body.text or b"") for word in ends) or not _runs_through(analysis, body):
        return None
    return OwnBlock(body, timer_rate(analysis, timer))


def is_loop(added: Addition, node: Node) -> bool:
    """Whether a `while` is the loop of a node: until ROS shuts down, or forever at a rate."""
    condition = node.child_by_field_name("condition")
    text = added.analysis.syntax.slice(condition) if condition is not None else ""
    if "is_shutdown" in text or "rclpy.ok" in text:
        return True
    body = node.child_by_field_name("body")
    return (
        text in ("True", "1")
        and body is not None
        and any(is_sleep(added.analysis, child) for child in body.named_children)
    )


def is_endless(analysis: Analysis, loop: Node) -> bool:
    """Whether the condition of a loop holds until ROS shuts down."""
    condition = loop.child_by_field_name("condition")
    text = analysis.syntax.slice(condition) if condition is not None else ""
    return _UNTIL_SHUTDOWN.fullmatch(text) is not None


def woken_loop(added: Addition) -> Node | None:
    """Return a loop of the node that goes on whenever something comes, and does not sleep."""
    for loop in added.analysis.captures.get("while", []):
        body = loop.child_by_field_name("body")
        parts = statements_of(body) if body is not None else []
        is_waiting = any(
            each.type == "expression_statement"
            and b"spin_once(" in (each.text or b"")
            and _waits(added.analysis, each.named_children[0])
            for each in parts
        )
        is_paced = any(is_sleep(added.analysis, each) for each in parts)
        if is_waiting and len(parts) > 1 and not is_paced and is_endless(added.analysis, loop):
            return loop
    return None


def is_sleep(analysis: Analysis, statement: Node) -> bool:
    """Whether a statement waits until a loop runs again."""
    return statement.type == "expression_statement" and ".sleep(" in analysis.syntax.slice(
        statement
    )


def statements_of(block: Node) -> list[Node]:
    """Return the statements of a block, or those of the `try` that is all there is in it."""
    statements = parts_of(block)
    while len(statements) == 1 and statements[0].type == "try_statement":
        inner = statements[0].child_by_field_name("body")
        if inner is None or not _is_plain(statements[0], inner):
            break
        statements = parts_of(inner)
    return statements


def _is_main(added: Addition, loop: Node, starting: Starting) -> bool:
    """Whether a loop starts with the node, ends with it, and sleeps once in each round."""
    analysis = added.analysis
    body = loop.child_by_field_name("body")
    if body is None or not is_endless(analysis, loop) or _is_behind_another(analysis, loop):
        return False
    is_paced = sum(is_sleep(analysis, each) for each in statements_of(body)) == 1
    return is_paced and _is_started(added, loop, starting) and _runs_through(analysis, body)


def _is_behind_another(analysis: Analysis, loop: Node) -> bool:
    """Whether a loop only begins when one above it has ended."""
    above = loop.prev_named_sibling
    while above is not None:
        if above.type == "while_statement" and is_endless(analysis, above):
            return True
        above = above.prev_named_sibling
    return False


def _is_started(added: Addition, node: Node, starting: Starting) -> bool:
    """Whether a loop or a timer surely runs as the node starts, or where the endpoint is made."""
    analysis, beside = added.analysis, added.place.statement.parent
    statement = statement_of(node)
    if beside is not None and statement.parent is not None and statement.parent.id == beside.id:
        return True
    function = analysis.scopes.at(node.start_byte).enclosing("function") or analysis.scopes.module
    return starting.is_starting(function) and is_sure(node, function)


def sleeps_by_spinning(analysis: Analysis, body: Node) -> bool:
    """Whether the body of a loop spins once, and sleeps with a rate that only that wakes.

    The timer of a rate wakes who sleeps (`rclpy/timer.py`). A `spin_once` that calls something else
    instead lets the loop sleep for ever.
    """
    text = analysis.syntax.text
    return (
        b"spin_once(" in (body.text or b"")
        and b".create_rate(" in text
        and b"Thread(" not in text
        and any(
            is_sleep(analysis, each) and not (each.text or b"").startswith(b"time.")
            for each in statements_of(body)
        )
    )


def _runs_through(analysis: Analysis, body: Node) -> bool:
    """Whether a body surely comes to its end, in no time to speak of."""
    statements = parts_of(body)
    may_spin = sleeps_by_spinning(analysis, body)
    if len(statements) == 1 and statements[0].type == "try_statement":
        handlers = [each for each in statements[0].children if each.type == "except_clause"]
        if not all(_INTERRUPT.search(_head(each)) for each in handlers):
            return False
    ending = [each.id for each in statements[-1:] if each.type == "return_statement"]
    pending = [(each, _LEAVING) for each in statements if each.id not in ending]
    while pending:
        node, leaving = pending.pop()
        is_waiting = _waits(analysis, node) and not (may_spin and b"spin_once" in _head(node))
        if node.type in leaving or node.type == "while_statement" or is_waiting:
            return False
        is_handler = node.type == "except_clause" and _INTERRUPT.search(_head(node))
        if node.type in _FUNCTIONS or is_handler:
            continue
        inner = leaving - _OF_A_LOOP if node.type == "for_statement" else leaving
        pending += [(child, inner) for child in node.named_children]
    return True


def _head(node: Node) -> bytes:
    """Return the first line of a statement."""
    return (node.text or b"").partition(b"\n")[0]


def _waits(analysis: Analysis, node: Node) -> bool:
    """Whether a call takes as long as something else wants."""
    name = analysis.syntax.called_name(node) if node.type == "call" else ""
    if name != "spin_once":
        return name in _WAITING
    return re.search(rb"timeout_sec\s*=\s*0(\.0*)?\s*[,)]", node.text or b"") is None


def _is_plain(owner: Node, block: Node) -> bool:
    return bool(block.start_point.row > owner.start_point.row) and not block.has_error


def _sees(added: Addition, function: Scope) -> bool:
    """Whether a function can use the variable that holds the publisher."""
    holder, dot, _ = added.variable.rpartition(".")
    if dot:
        return function.self_name == holder and function.parent is added.place.owner
    return function.is_within(added.place.scope)
