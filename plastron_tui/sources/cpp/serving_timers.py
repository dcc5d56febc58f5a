"""Which timers of a unit serve another endpoint, in functions as Plastron writes them."""

from __future__ import annotations

import re
from collections.abc import Iterator

from tree_sitter import Node

from plastron_tui.sources.splices import line_start

from .analysis import Analysis, Site
from .scopes import Function

_NAME = re.compile(r"(?:publish|call|send|repeat|await|follow)(?:_|[A-Z]).*")
# What the functions say that Plastron lets timers call for something else.
_DESCRIPTIONS = ("Publish to ", "Call ", "Send ", "Warn as long as ", "Give the timers ")
# What these call, beside filling in messages.
_CALLED = re.compile(
    r"publish|get_subscription_count|getNumSubscribers|get_logger|get_clock|(?:RCLCPP|ROS)_\w+"
    r"|cancel|stop|reset|start|is_done|valid|wait_for|async|seconds|lock|call_\w+|send_\w+"
    r"|setPeriod|Duration|get_\w+|now|c_str|make_shared|make_unique"
)
_FILLED = re.compile(r"message(?:\.|->|\[)")


def serves(analysis: Analysis, site: Site) -> bool:
    """Tell whether the function of a timer does a part of something else that Plastron writes.

    It publishes a message, waits for who hears it, calls a service, or sets the rates of others.
    """
    functions = site.callback.functions
    if site.callback.name is None or _NAME.fullmatch(site.callback.name) is None:
        return False
    defined = [each for each in functions if each.scope is not None]
    if len(defined) != 1:
        return False
    called = list(_called(defined[0]))
    if not all(_CALLED.fullmatch(name) for name in called):
        return False
    if any(description_of(each).startswith(_DESCRIPTIONS) for each in functions):
        return True
    return "publish" in called and all(map(_is_of_message, _statements(defined[0])))


def _called(function: Function) -> Iterator[str]:
    """Yield the names of what a function calls, at any depth."""
    for call in function.file.calls:
        if function.node.start_byte <= call.node.start_byte < function.node.end_byte:
            yield call.name


def _statements(function: Function) -> list[tuple[Node, Function]]:
    body = function.node.child_by_field_name("body")
    return [] if body is None else [(each, function) for each in body.named_children]


def _is_of_message(part: tuple[Node, Function]) -> bool:
    """Tell whether a statement makes a message, fills it in, or publishes it."""
    statement, function = part
    text = function.file.syntax.word(statement)
    inner = statement.named_children
    if statement.type == "declaration":
        return text.rstrip(" ;").endswith(" message")
    if statement.type != "expression_statement" or len(inner) != 1:
        return False
    if inner[0].type == "assignment_expression":
        return _FILLED.match(text) is not None
    return inner[0].type == "call_expression"


def description_of(function: Function) -> str:
    """Return the first line of the comment above a function."""
    node, text = function.node, function.file.syntax.text
    if node.parent is not None and node.parent.type == "template_declaration":
        node = node.parent
    first, at = b"", line_start(text, node.start_byte)
    while at > 0:
        above = line_start(text, at - 1)
        if not text[above:at].lstrip().startswith(b"///"):
            break
        first, at = text[above:at].strip(), above
    return first.removeprefix(b"///").strip().decode(function.file.syntax.encoding, "replace")
