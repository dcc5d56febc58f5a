"""Uses of a value that do nothing but tell it: a log line has to say what the node has."""

from __future__ import annotations

import re
from typing import NamedTuple

from tree_sitter import Node

from .analysis import Analysis

# Around a value these still only make a text of it.
_IN_TEXT = frozenset(
    {"binary_operator", "concatenated_string", "interpolation", "keyword_argument", "list"}
    | {"parenthesized_expression", "string", "tuple"}
)
_TO_TEXT = frozenset({"format", "join", "repr", "str"} | {"resolve_name", "resolve_topic_name"})
_TELLING = re.compile(
    r"print|warnings\.warn|(sys\.)?exit|rospy\.(\w+\.)*signal_shutdown"
    r"|rospy\.(\w+\.)*log(debug|info|warn|err|fatal)(_once|_throttle|_throttle_identical)?"
    # `self.get_logger().info`, `logging.info`, `self._log.warning`, `node.get_logger().warn_once`
    r"|(.*\W)?((\w*_)?log|\w*logg(er|ing))(\(\))?\.(debug|info|warn|warning|error|fatal|critical|exception)",
    re.IGNORECASE,
)
# A node that waits for a service waits for the one that it calls.
_WAITING = frozenset({"rospy.wait_for_service", "rospy.client.wait_for_service"})
# Methods of a node of rclpy that ask who else has a topic: `rclpy/node.py`.
_ASKING = re.compile(
    r".*\.(count_(publishers|subscribers)|get_(publishers|subscriptions)_info_by_topic)"
)


class Told(NamedTuple):
    """What becomes of an expression that may be a part of a text.

    Attributes:
        text: the whole text, which is the expression where nothing makes a text of it.
        is_told: whether it is only told: logged, printed, raised, or waited for as a service.
    """

    text: Node
    is_told: bool


def is_only_told(analysis: Analysis, node: Node) -> bool:
    """Whether an expression is only logged, printed, raised, or waited for as a service."""
    return told(analysis, node).is_told


def told(analysis: Analysis, node: Node) -> Told:
    """Return the text that an expression is made a part of, and whether it is only told."""
    current = node
    while (parent := current.parent) is not None:
        if parent.type == "argument_list" and (call := parent.parent) is not None:
            callee = call.child_by_field_name("function")
            if callee is None:
                return Told(current, False)
            if is_telling(analysis, callee) or _is_raised(call):
                return Told(current, True)
            if not _makes_text(analysis, callee):
                return Told(current, False)
            current = call
        elif parent.type == "attribute" and _is_formatted(analysis, parent):
            current = parent.parent or parent
        elif parent.type in _IN_TEXT:
            current = parent
        else:
            break
    return Told(current, False)


def _is_raised(call: Node) -> bool:
    return call.parent is not None and call.parent.type == "raise_statement"


def _is_formatted(analysis: Analysis, attribute: Node) -> bool:
    """Whether an attribute is the method of a text, as in `('a' + b).format(c)`."""
    holder, call = attribute.child_by_field_name("object"), attribute.parent
    texts = ("string", "parenthesized_expression", "concatenated_string", "binary_operator")
    is_text = holder is not None and holder.type in texts
    is_called = call is not None and call.type == "call"
    return is_text and is_called and _makes_text(analysis, attribute)


def is_telling(analysis: Analysis, callee: Node) -> bool:
    """Whether a call of this logs, prints, or waits for a service."""
    scope = analysis.scopes.at(callee.start_byte)
    written = "".join(analysis.syntax.slice(callee).split())
    names = (written, *analysis.resolver.qualified(callee, scope))
    return any(
        _TELLING.fullmatch(name) or _ASKING.fullmatch(name) or name in _WAITING for name in names
    )


def _makes_text(analysis: Analysis, callee: Node) -> bool:
    name = callee.child_by_field_name("attribute") or callee
    return analysis.syntax.slice(name) in _TO_TEXT
