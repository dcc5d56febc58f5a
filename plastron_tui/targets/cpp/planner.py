"""The plan of a whole C++ node, from a node and the types that its library has."""

from __future__ import annotations

from collections import Counter
from typing import NamedTuple

from plastron_tui.diagnostics import Diagnostic, codes
from plastron_tui.model.kinds import ActionClient, ActionServer, Client, callback_of
from plastron_tui.model.workspace import Node
from plastron_tui.ros.catalog import Catalog
from plastron_tui.sources.cpp import literals, naming
from plastron_tui.targets.planning import plan_parts, summary
from plastron_tui.targets.planning.plan import NodePlan
from plastron_tui.targets.planning.writing import CannotPlanError

from .dialect import Dialect
from .writing import CppWriting


class CppPlan(NamedTuple):
    """What the templates of a C++ node are given.

    Attributes:
        node: what is in it.
        headers: the headers of the interfaces that it uses, sorted.
        overloaded: the names that several of its methods have.
        has_private: whether any of its names is a private one, of ROS 1.
        keeps_out_nan: whether a parameter has a range, which rclcpp lets NaN through
            (`NodeParameters`: it refuses what is less than the least or more than the most).
    """

    node: NodePlan
    headers: tuple[str, ...]
    overloaded: frozenset[str]
    has_private: bool
    keeps_out_nan: bool

    @property
    def checks_parameters(self) -> bool:
        """Whether the node is asked before a parameter changes (ROS 2)."""
        return self.keeps_out_nan or bool(self.node.following)


def plan_node(node: Node, catalog: Catalog, dialect: Dialect) -> CppPlan | Diagnostic:
    """Return the plan of a node, or why it cannot be written for its library."""
    plan = NodePlan(literals.string(node.name), naming.label(node.name, "of this file"))
    plan.is_managed = node.is_managed
    given = {name for each in node.endpoints.values() if (name := callback_of(each))}
    writing = CppWriting(node, catalog, dialect, given)
    try:
        _check_names(writing)
        plan_parts(writing, plan)
    except CannotPlanError as error:
        return error.diagnostic
    plan.summary = summary(node)
    plan.functions = frozenset(writing.functions)
    plan.class_name = naming.class_name(node.name)
    return CppPlan(
        plan,
        tuple(sorted(writing.headers)),
        _overloaded(plan),
        _has_private(plan),
        keeps_out_nan=any(each.type == "double" and each.check for each in plan.parameters),
    )


def _overloaded(plan: NodePlan) -> frozenset[str]:
    """Return the names of several methods: `&Class::name` does not say which of them."""
    names = Counter(each.name for each in (*plan.callbacks, *plan.handlers))
    names.update(each.method for each in plan.timers)
    for server in plan.action_servers:
        names.update((server.method, f"accept_{server.attribute}", f"run_{server.attribute}"))
    return frozenset(name for name, count in names.items() if count > 1)


def _has_private(plan: NodePlan) -> bool:
    """Tell whether a node of ROS 1 has private names: a handle of its own takes them."""
    names = [
        *(each.topic for each in plan.publishers),
        *(each.topic for each in plan.subscriptions),
        *(each.name for each in plan.services),
        *(each.name for each in plan.clients),
        *(each.name for each in plan.action_servers),
        *(each.name for each in plan.action_clients),
    ]
    is_private = any(name.startswith('"~') for name in names)
    return is_private or any(each.is_own for each in plan.parameters)


def _check_names(writing: CppWriting) -> None:
    """Refuse what the program calls its functions where that can be no method."""
    dialect, node = writing.dialect, writing.node
    reserved = dialect.method_names | dialect.attribute_names | {naming.class_name(node.name)}
    managed = dialect.managed_names if node.is_managed else frozenset()
    has_tasks = any(node.of(ActionServer)) or any(node.of(ActionClient)) or any(node.of(Client))
    tasks = dialect.task_names if has_tasks else frozenset()
    for each in node.endpoints.values():
        name, span = callback_of(each), each.span
        if name is None:
            continue
        if not naming.is_name(name):
            writing.refuse(codes.INVALID_FUNCTION, f"`{name}` cannot be a name in C++", span)
        # An attribute is called as a method may be, with an underscore behind it.
        plain = name.removesuffix("_")
        if plain in reserved | managed | tasks:
            kind = "managed " if plain in managed else ""
            which = " with calls or actions" if plain in tasks else ""
            message = f"`{name}` is a name that every {kind}{dialect.library} node{which} has"
            writing.refuse(codes.INVALID_FUNCTION, message, span, f"write `on_my_{plain}`, say")
