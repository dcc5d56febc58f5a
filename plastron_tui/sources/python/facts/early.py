"""Messages that are published once, right after their publisher is created: nobody hears them.

A subscriber is connected some time after the publisher has come: rospy hears from the master of it
(`rospy.topics`), rclpy by discovery. Only what is latched, or transient local, waits for it.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator

from tree_sitter import Node

from plastron_tui.diagnostics import Span
from plastron_tui.model.code_facts import EarlyPublish
from plastron_tui.model.kinds import EndpointKind
from plastron_tui.sources.python.analysis import Analysis, Site
from plastron_tui.sources.python.calls import Argument
from plastron_tui.sources.python.functions import function_uses
from plastron_tui.sources.python.references import Use, references, statement_of, variable_of
from plastron_tui.sources.python.scopes import Scope
from plastron_tui.sources.python.syntax import FUNCTIONS, is_in_loop, parts_of
from plastron_tui.sources.unreachable import is_unreachable

from .call_graph import CallGraph
from .called_back import is_certain, running_scope

_QUICK = frozenset(
    {
        "append", "bool", "create_client", "create_node", "create_publisher", "create_service",
        "create_subscription", "create_timer", "debug", "declare_parameter", "dict", "encode",
        "error", "fatal", "float", "format", "get", "get_clock", "get_logger", "get_name",
        "get_param", "get_parameter", "get_parameter_value", "has_param", "info", "init",
        "init_node", "int", "len", "list", "logdebug", "logerr", "loginfo", "logwarn", "now",
        "on_shutdown", "print", "publish", "range", "round", "split", "str", "strip", "super",
        "time", "to_msg", "tuple", "warn", "warning", "__init__", "Duration", "Publisher", "Rate",
        "Service", "ServiceProxy", "Subscriber", "Time", "Timer",
    }
)  # fmt: skip
"""What is called between the two in no time to speak of."""

_LIBRARIES = frozenset({"copy", "datetime", "json", "math", "numpy", "random", "struct", "yaml"})
_WAITING = re.compile(r"sleep|wait|load|read", re.IGNORECASE)
_MOST_DEEP = 3
_MOST_MENTIONS = 8
"""How often a publisher may be mentioned that sends once; each is looked at."""

_LOOPS = frozenset({"while_statement", "for_statement", "await", "yield", "with_statement"})
_LATCH = Argument(4, "latch")


def early(analysis: Analysis, graph: CallGraph) -> Iterator[EarlyPublish]:
    """Yield the only messages of publishers, where they are sent right after those are created."""
    names = Counter(
        site.endpoint.name
        for site in analysis.first_sites()
        if site.endpoint.kind is EndpointKind.PUBLISHER
    )
    # Who listens in the same program may be there at once.
    names.update(
        site.endpoint.name
        for site in analysis.first_sites()
        if site.endpoint.kind is EndpointKind.SUBSCRIPTION
    )
    time = _Time(analysis, graph)
    for site in analysis.first_sites():
        is_alone = site.endpoint.name is None or names[site.endpoint.name] == 1
        if site.endpoint.kind is not EndpointKind.PUBLISHER or not is_alone:
            continue
        if is_certain(site, analysis) and not _is_kept(site):
            sent = _messages(analysis, site)
            if sent and all(time.is_right_behind(site.call, each) for each in sent):
                yield EarlyPublish(
                    Span(sent[0].start_byte, sent[0].end_byte),
                    Span(site.call.start_byte, site.call.end_byte),
                )


def _is_kept(site: Site) -> bool:
    """Tell whether a publisher keeps its message for who comes later, or may do so."""
    qos = site.endpoint.qos
    if site.shape.qos is not None and site.shape.qos.latch is not None:
        return site.arguments.is_open or site.arguments.get(_LATCH) is not None
    return qos is None or qos.durability not in (None, "volatile")


def _messages(analysis: Analysis, site: Site) -> list[Node]:
    """Return the calls that publish, where they are all that is done with a publisher."""
    parent = site.call.parent
    if parent is None:
        return []
    if parent.type == "attribute":
        call = parent.parent
        name = parent.child_by_field_name("attribute")
        is_sent = name is not None and name.text == b"publish"
        return [call] if is_sent and call is not None and call.type == "call" else []
    target = parent.child_by_field_name("left") if parent.type == "assignment" else None
    variable = variable_of(target, analysis) if target is not None else None
    if variable is None or target is None:
        return []
    named = re.compile(rb"\b%s\b" % re.escape(analysis.syntax.encode(variable.name)))
    if len(named.findall(analysis.syntax.text)) > _MOST_MENTIONS:
        return []
    uses = [
        each
        for each in references(variable, analysis)
        if each.use is not Use.NOTHING and each.node.id != target.id
    ]
    if any(each.use is not Use.PUBLISH for each in uses):
        return []
    calls = (each.node.parent.parent for each in uses if each.node.parent is not None)
    return [call for call in calls if call is not None]


class _Time:
    """Tells whether anything of a file takes time."""

    def __init__(self, analysis: Analysis, graph: CallGraph) -> None:
        self._analysis = analysis
        self._graph = graph

    def is_right_behind(self, created: Node, sent: Node) -> bool:
        """Tell whether a message is sent at once after its publisher is created, and only then."""
        if is_in_loop(created) or is_in_loop(sent) or is_unreachable(sent):
            return False
        made, sending = (running_scope(self._analysis, each) for each in (created, sent))
        if made is sending:
            return self._is_quick_between(created, sent)
        maker = self._only_call(made) if made.name == "__init__" else None
        call = self._only_call(sending)
        start = sending.node.child_by_field_name("body")
        if start is not None and call is not None and self._takes_no_time(start, sent):
            if running_scope(self._analysis, call) is made:
                return self._is_quick_between(created, call)
            sent = call
        if maker is None or not self._is_quick_behind(created, made):
            return False
        is_beside = running_scope(self._analysis, maker) is running_scope(self._analysis, sent)
        return is_beside and self._is_quick_between(maker, sent)

    def _only_call(self, function: Scope) -> Node | None:
        """Return the call of a function, where the file does nothing else with it."""
        owner = function.parent
        named = owner if function.name == "__init__" and owner is not None else function
        if function.kind != "function":
            return None
        uses = function_uses(self._analysis, named)
        callee = uses[0] if len(uses) == 1 else None
        if callee is not None and callee.parent is not None and callee.parent.type == "attribute":
            callee = callee.parent
        call = None if callee is None else callee.parent
        if call is None or call.type != "call" or is_in_loop(call):
            return None
        return call if self._graph.callee(call) is function else None

    def _is_quick_between(self, first: Node, last: Node) -> bool:
        """Tell whether one part of a function comes right behind another one."""
        above, below = statement_of(first), statement_of(last)
        if above.id == below.id:
            return True
        block = above.parent
        if block is None or not block.start_byte <= below.start_byte < block.end_byte:
            return False
        return above.start_byte < below.start_byte and all(
            self._takes_no_time(each, last)
            for each in parts_of(block)
            if above.end_byte <= each.start_byte <= below.start_byte
        )

    def _is_quick_behind(self, node: Node, function: Scope) -> bool:
        """Tell whether a function comes to its end at once behind a part of it."""
        statement = statement_of(node)
        block = statement.parent
        if block is None or block != function.node.child_by_field_name("body"):
            return False
        behind = (each for each in parts_of(block) if statement.end_byte <= each.start_byte)
        return all(self._takes_no_time(each, None) for each in behind)

    def _takes_no_time(self, statement: Node, last: Node | None, depth: int = 0) -> bool:
        """Tell whether all of a statement, up to a call, is done at once."""
        pending = [statement]
        while pending:
            node = pending.pop()
            if node.type in FUNCTIONS or (last is not None and node.start_byte >= last.end_byte):
                continue
            if node.type in _LOOPS:
                return False
            is_other = last is None or node.id != last.id
            if node.type == "call" and is_other and not self._is_quick(node, depth):
                return False
            pending += node.named_children
        return True

    def _is_quick(self, call: Node, depth: int) -> bool:
        """Tell whether a call makes a message, or is one of those that return at once."""
        analysis = self._analysis
        function = self._graph.callee(call)
        if function is not None:
            body = function.node.child_by_field_name("body")
            return depth < _MOST_DEEP and (
                body is not None and self._takes_no_time(body, None, depth + 1)
            )
        name = analysis.syntax.called_name(call)
        if name in _QUICK:
            return True
        scope = analysis.scopes.at(call.start_byte)
        callee = call.child_by_field_name("function")
        if analysis.resolver.interface(callee, scope) is not None:
            return True
        names = analysis.resolver.qualified(callee, scope)
        if any(each.partition(".")[0] in _LIBRARIES for each in names):
            return _WAITING.search(name) is None
        return any(part in each.split(".") for each in names for part in ("msg", "srv"))
