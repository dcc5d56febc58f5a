"""By how many threads the callbacks of a file's nodes are called, and in which groups.

Source: `rclpy.callback_groups`, `rclpy.executors` of Jazzy. Whatever the executor is, it calls no
two callbacks of a `MutuallyExclusiveCallbackGroup` at a time; the default group of a node is one.
"""

from __future__ import annotations

import re
from enum import Enum
from functools import cached_property
from typing import NamedTuple

from tree_sitter import Node

from plastron_tui.model.kinds import EndpointKind
from plastron_tui.sources.python.analysis import Analysis, Site
from plastron_tui.sources.python.arguments import Arguments
from plastron_tui.sources.python.calls import Argument
from plastron_tui.sources.python.scopes import Scope

from .called_back import CalledBack, is_certain, running_scope
from .objects import Objects

_METHODS = frozenset({"spin", "spin_once", "spin_until_future_complete"})
_EXECUTOR = {
    "rclpy.spin": Argument(1, "executor"),
    "rclpy.spin_once": Argument(-1, "executor"),
    "rclpy.spin_until_future_complete": Argument(2, "executor"),
}
_GROUP, _GROUP_OF_TIMER = Argument(-1, "callback_group"), Argument(2, "callback_group")
_KINDS = ("MutuallyExclusiveCallbackGroup", "ReentrantCallbackGroup")


class GroupKind(Enum):
    """What a group of callbacks lets run at a time."""

    DEFAULT = "default"
    EXCLUSIVE = "exclusive"
    REENTRANT = "reentrant"
    UNKNOWN = "unknown"


class Group(NamedTuple):
    """A group of callbacks.

    Attributes:
        kind: its kind.
        calls: what makes it, by the ids of the nodes in the tree.
    """

    kind: GroupKind
    calls: frozenset[int] = frozenset()


class Execution:
    """How the callbacks of a file's nodes are called."""

    def __init__(self, analysis: Analysis, objects: Objects) -> None:
        self._analysis = analysis
        self._objects = objects

    @cached_property
    def is_single(self) -> bool:
        """Whether the file spins its nodes, and with an executor of one thread."""
        calls = self._analysis.captures.get("call", [])
        has_executor = bool(self._executors)
        return not self.has_threads and any(self._spins(call, has_executor) for call in calls)

    @cached_property
    def has_threads(self) -> bool:
        """Whether the file makes an executor that may have several threads."""
        return bool(self._executors - {"SingleThreadedExecutor"})

    @property
    def has_groups(self) -> bool:
        """Whether the file says of any endpoint which group it is in."""
        return re.search(rb"\bcallback_group\s*=", self._analysis.syntax.text) is not None

    @cached_property
    def _executors(self) -> frozenset[str]:
        called = map(self._analysis.syntax.called_name, self._analysis.captures.get("call", []))
        return frozenset(name for name in called if name.endswith("Executor"))

    def _spins(self, call: Node, has_executor: bool) -> bool:
        """Tell whether a call has callbacks called, outside of the nodes' own methods."""
        analysis = self._analysis
        name = analysis.syntax.called_name(call)
        owners = {node.owner for node in analysis.nodes}
        scope = running_scope(analysis, call)
        if name not in _METHODS or scope.enclosing("class") in owners - {None}:
            return self._is_handed_over(call, has_executor)
        names = analysis.resolver.qualified(call.child_by_field_name("function"), scope)
        spun = next((each for each in names if each in _EXECUTOR), None)
        arguments = Arguments.of(call, analysis.syntax)
        if spun is not None:
            given = arguments.get(_EXECUTOR[spun])
            return not arguments.is_open and (given is None or has_executor)
        return has_executor

    def _is_handed_over(self, call: Node, has_executor: bool) -> bool:
        """Tell whether a call is `Thread(target=rclpy.spin, …)`, or has an executor spin so."""
        if self._analysis.syntax.called_name(call) != "Thread":
            return False
        target = Arguments.of(call, self._analysis.syntax).get(Argument(1, "target"))
        scope = self._analysis.scopes.at(call.start_byte)
        names = self._analysis.resolver.qualified(target, scope)
        text = b"" if target is None else target.text or b""
        return "rclpy.spin" in names or (has_executor and text.endswith(b".spin"))

    def group(self, site: Site) -> Group:
        """Return the group that an endpoint is in."""
        is_timer = site.endpoint.kind is EndpointKind.TIMER
        given = site.arguments.get(_GROUP_OF_TIMER if is_timer else _GROUP)
        if site.arguments.is_open or b"default_callback_group" in self._analysis.syntax.text:
            return Group(GroupKind.UNKNOWN)
        if given is None or given.type == "none":
            return Group(GroupKind.DEFAULT)
        made = self._objects.makings(given, site.scope)
        kinds = {self._analysis.syntax.called_name(each.call) for each in made}
        if len(kinds) != 1 or not kinds <= set(_KINDS):
            return Group(GroupKind.UNKNOWN)
        is_exclusive = kinds == {_KINDS[0]}
        calls = frozenset(each.call.id for each in made)
        return Group(GroupKind.EXCLUSIVE if is_exclusive else GroupKind.REENTRANT, calls)

    def exclude(self, callback: CalledBack, site: Site) -> bool:
        """Tell whether nothing of an endpoint is done while a callback runs, by whatever executor.

        The two are in one group of callbacks, which does one thing at a time.
        """
        is_known = callback.site is not None and not callback.is_inherited
        if callback.site is None or not is_known or callback.is_task:
            return False
        if not self.are_of_one_node(callback, site):
            return False
        one, other = self.group(callback.site), self.group(site)
        if one.kind is GroupKind.DEFAULT:
            return other.kind is GroupKind.DEFAULT
        return one.kind is GroupKind.EXCLUSIVE and one == other and len(one.calls) == 1

    def are_of_one_node(self, callback: CalledBack, site: Site) -> bool:
        """Tell whether a callback is one of the node that an endpoint belongs to."""
        owner, name = _node(site)
        if callback.site is not None and not callback.is_inherited:
            other, other_name = _node(callback.site)
            return name == other_name and self._is_one(owner, other)
        function = callback.function
        around = None if function is None else function.enclosing("class")
        if around is not None:
            return not name and self._is_one(owner, around)
        return len(self._analysis.nodes) == 1 and is_certain(site, self._analysis)

    def _is_one(self, one: Scope, other: Scope) -> bool:
        """Tell whether two scopes are one, or classes of which one derives from the other."""
        bases = self._analysis.resolver.classes.bases
        return one is other or one in bases(other) or other in bases(one)


def _node(site: Site) -> tuple[Scope, str]:
    """Return what tells the node of an endpoint: the class that it is of, or what holds it."""
    if site.owner is not None:
        return site.owner, ""
    root = site.receiver.partition(".")[0]
    found = site.scope.lookup(root)
    holder = site.scope if found is None else found[0]
    if holder.self_name == root and holder.parent is not None:
        holder = holder.parent
    return holder, site.receiver
