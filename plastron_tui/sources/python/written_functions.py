"""Functions that Plastron writes, and that an edit knows again: each is declared once.

A line is one statement, a tab in front of it a level of indent. What is in braces differs; what
begins with `log` logs something. A short function is known by its docstring too: people write such.

Source: `rclpy.action` of Jazzy, `actionlib` of Noetic.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from tree_sitter import Node

from .analysis import Analysis
from .generated import body_of
from .scopes import Scope
from .syntax import parts_of

STEP = "# The work of one step goes here."
UNSENT = "# rospy sends in the background, and closes what is unsent."
QUIET_THREADS = "threading.excepthook = lambda failure: None"
"""Lets a timer of rospy that is at its turn at Ctrl-C find its topics closed, and say nothing."""
COMMENTS = frozenset({STEP, UNSENT})
"""The comments in what Plastron writes; others are somebody's own."""

SEND_ASYNC = (
    "if not {client}.server_is_ready():",
    "\t{log}",
    "\treturn",
    "{timer}.cancel()",
    "future = {client}.send_goal_async({goal}, lambda message: {log_feedback})",
    "future.add_done_callback({answer})",
)
"""Sends a goal in rclpy."""

AWAIT_RESULT = (
    '"""Log whether {label} takes the goal, and what comes of it."""',
    "goal_handle = future.result()",
    "if not goal_handle.accepted:",
    "\t{log_error}",
    "\treturn",
    "result = goal_handle.get_result_async()",
    "result.add_done_callback(lambda done: {log_result})",
)
"""Hears in rclpy whether a server takes a goal."""

SEND_AND_WAIT = (
    "if not {client}.wait_for_server():",
    "\treturn",
    "{client}.send_goal({goal}, feedback_cb=lambda feedback: {log_feedback})",
    "if {client}.wait_for_result():",
    "\tstate = {status}.to_string({client}.get_state())",
    "\t{log_state}",
    "\t{log_result}",
)
"""Sends a goal in rospy, in a thread that has nothing else to do."""

EXECUTE_ASYNC = (
    "{log}",
    "{goal} = goal_handle",
    "for _ in range(10):",
    "\tif goal_handle.is_cancel_requested:",
    "\t\tgoal_handle.canceled()",
    "\t\treturn {result}",
    "\tif {goal} is not goal_handle:",
    "\t\tgoal_handle.abort()",
    "\t\treturn {result}",
    f"\t{STEP}",
    "\tgoal_handle.publish_feedback({feedback})",
    "\tawait {sleep}(0.5)",
    "goal_handle.succeed()",
    "return {result}",
)
"""Works on a goal in rclpy, and leaves the node free for its other work meanwhile."""

EXECUTE = (
    "{log}",
    "for _ in range(10):",
    "\tif {server}.is_preempt_requested():",
    "\t\t{server}.set_preempted()",
    "\t\treturn",
    f"\t{STEP}",
    "\t{server}.publish_feedback({feedback})",
    "\t{pause}(0.5)",
    "{server}.set_succeeded({result})",
)
"""Works on a goal in rospy, in a thread of its own."""

ACCEPT_CANCEL = (
    '"""Let whoever sent a goal cancel it; rclpy would not."""',
    "return {cancel_response}.ACCEPT",
)
"""Lets whoever sent a goal cancel it."""

SLEEP = (
    '"""Wait, while the node goes on with its other work."""',
    "woken = {future}()",
    "timer = {node}.create_timer(seconds, lambda: woken.set_result(None))",
    "await woken",
    "{node}.destroy_timer(timer)",
)
"""Waits in rclpy."""

EXECUTE_OWN = (
    "{log}",
    "server = {server}",
    "for _ in range(10):",
    "\tif server.is_preempt_requested():",
    "\t\tserver.set_preempted()",
    "\t\treturn",
    "\tif not server.is_active():",
    "\t\treturn",
    f"\t{STEP}",
    "\tserver.publish_feedback({feedback})",
    "\t{pause}(0.5)",
    "server.set_succeeded({result})",
)
"""Works on a goal in a node of rospy that is all Plastron's."""

END_GOALS = (
    '"""Abort the goals that are worked on when the node ends, and take no more."""',
    "for server in {servers}:",
    "\tserver.action_server.started = False",
    "\tif server.is_active():",
    '\t\tserver.set_aborted(text="the node ends")',
    f"\t\t{UNSENT}",
    "\t\trospy.rostime.wallsleep(0.1)",
)
"""Ends the goals of all servers in such a node."""

EARLIER_END_GOALS = END_GOALS[:-2]
"""The same in the files of versions that did not wait until it is sent."""

WARN_UNHEARD = (
    '"""Warn as long as nobody listens to {label}."""',
    "if {publisher}.get_num_connections():",
    "\t{timer}.shutdown()",
    "else: {log}",
)
"""Tells in rospy that nobody hears what was sent once."""

SENDING = (SEND_ASYNC, SEND_AND_WAIT)
ENDING = (END_GOALS, EARLIER_END_GOALS)
EXECUTING = (EXECUTE_ASYNC, EXECUTE, EXECUTE_OWN)
HELPERS = (AWAIT_RESULT, ACCEPT_CANCEL, SLEEP)

_DIFFERENT = re.compile(r"\{(\w+)\}")
_LOG = r"[\w.()]*(?:info|err|log|print)\w*\(.*\)"


def filled(function: tuple[str, ...], **values: str) -> list[str]:
    """Return the lines of a function."""
    return [line.format(**values) for line in function]


def is_one_of(analysis: Analysis, function: Scope, functions: tuple[tuple[str, ...], ...]) -> bool:
    """Whether a function of a file is one of some, and nobody has been at work in it."""
    comments = {analysis.syntax.slice(each) for each in _comments(function.node)}
    if not comments <= COMMENTS:
        return False
    whole = parts_of(function.node.child_by_field_name("body"))
    documented, bare = (list(_statements(analysis, each)) for each in (whole, body_of(function)))
    return any(
        _is_alike(documented if each[0].startswith('"') else bare, each) for each in functions
    )


def _is_alike(found: list[str], function: tuple[str, ...]) -> bool:
    lines = [line for line in function if line.strip() not in COMMENTS]
    return len(found) == len(lines) and all(
        re.fullmatch(_pattern(line), text) for line, text in zip(lines, found, strict=True)
    )


def _pattern(line: str) -> str:
    literal, *rest = _DIFFERENT.split(_plain(line))
    parts = [re.escape(literal)]
    for name, after in zip(rest[::2], rest[1::2], strict=True):
        parts += [_LOG if name.startswith("log") else ".+", re.escape(after)]
    return "".join(parts)


def _statements(analysis: Analysis, statements: list[Node]) -> Iterator[str]:
    """Yield the statements of a block, those of the blocks within it too."""
    for each in statements:
        fields = (each.child_by_field_name(name) for name in ("body", "consequence"))
        block = next((found for found in fields if found is not None), None)
        if block is None:
            yield _plain(analysis.syntax.slice(each))
            continue
        yield _plain(analysis.syntax.between(each.start_byte, block.start_byte))
        yield from _statements(analysis, parts_of(block))
        rest = analysis.syntax.between(block.end_byte, each.end_byte)
        if rest.strip():
            yield _plain(rest)


def _plain(text: str) -> str:
    """Return a statement without what only formats it."""
    return re.sub(r",(?=[)\]])", "", re.sub(r"\s+", "", text)).replace("'''", '"""')


def _comments(node: Node) -> Iterator[Node]:
    pending = [node]
    while pending:
        each = pending.pop()
        if each.type == "comment":
            yield each
        pending += each.children
