"""Uses of a value that do nothing but tell it: a log line has to say what the node has."""

from __future__ import annotations

import re

from tree_sitter import Node

from .analysis import Analysis

# Around a value these still only make a text of it.
_IN_TEXT = frozenset(
    {"binary_operator", "concatenated_string", "interpolation", "keyword_argument", "list"}
    | {"parenthesized_expression", "string", "tuple"}
)
_TO_TEXT = frozenset({"format", "join", "repr", "str"} | {"resolve_name", "resolve_topic_name"})
_TELLING = re.compile(
    r"print|warnings\.warn"
    r"|rospy\.(\w+\.)*log(debug|info|warn|err|fatal)(_once|_throttle|_throttle_identical)?"
    # `self.get_logger().info`, `logging.info`, `self._log.warning`, `node.get_logger().warn_once`
    r"|(.*\W)?((\w*_)?log|\w*logg(er|ing))(\(\))?\.(debug|info|warn|warning|error|fatal|critical|exception)",
    re.IGNORECASE,
)
# A node that waits for a service waits for the one that it calls.
_WAITING = frozenset({"rospy.wait_for_service", "rospy.client.wait_for_service"})


def is_only_told(analysis: Analysis, node: Node) -> bool:
    """Whether an expression is only logged, printed, or waited for as a service."""
    current = node
    while (parent := current.parent) is not None:
        if parent.type == "argument_list" and parent.parent is not None:
            callee = parent.parent.child_by_field_name("function")
            if callee is None or is_telling(analysis, callee):
                return callee is not None
            if not _makes_text(analysis, callee):
                return False
            current = parent.parent
        elif parent.type in _IN_TEXT:
            current = parent
        else:
            return False
    return False


def is_telling(analysis: Analysis, callee: Node) -> bool:
    """Whether a call of this logs, prints, or waits for a service."""
    scope = analysis.scopes.at(callee.start_byte)
    written = "".join(analysis.syntax.slice(callee).split())
    names = (written, *analysis.resolver.qualified(callee, scope))
    return any(_TELLING.fullmatch(name) or name in _WAITING for name in names)


def _makes_text(analysis: Analysis, callee: Node) -> bool:
    name = callee.child_by_field_name("attribute") or callee
    return analysis.syntax.slice(name) in _TO_TEXT
