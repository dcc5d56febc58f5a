"""The plan of a whole file, from a node and the types that its library has."""

from __future__ import annotations

from collections.abc import Callable

from plastron_tui.diagnostics import Diagnostic, codes
from plastron_tui.model.kinds import (
    Client,
    Parameter,
    Publisher,
    Service,
    Subscription,
    Timer,
    callback_of,
)
from plastron_tui.model.workspace import Node
from plastron_tui.ros.catalog import Catalog
from plastron_tui.sources.python import literals, naming
from plastron_tui.sources.python.dialect import Dialect
from plastron_tui.sources.python.import_block import Imports

from ..plan import NodePlan
from .computed import AS_FLOAT32
from .parameters import add_parameters
from .services import add_clients, add_services
from .timers import add_timers
from .topics import add_publishers, add_subscriptions
from .writing import CannotPlanError, Writing

_PARTS: tuple[Callable[[Writing, NodePlan], None], ...] = (
    add_parameters,
    add_publishers,
    add_subscriptions,
    add_services,
    add_clients,
    add_timers,
)
"""What plans each group of what a node has, in the order in which names are given."""


class Planner:
    """Plans one node.

    Attributes:
        diagnostics: why there is no plan.
    """

    def __init__(self, node: Node, catalog: Catalog, dialect: Dialect) -> None:
        self._node = node
        self._catalog = catalog
        self._dialect = dialect
        self.diagnostics: list[Diagnostic] = []

    def plan(self) -> NodePlan | None:
        """Return the plan, None when the node cannot be written for its library."""
        try:
            plan, imports = self._plan(Imports())
            clashes = imports.clashes(self._dialect.reserved())
            if clashes:
                plan, _ = self._plan(Imports(clashes))
        except CannotPlanError as error:
            self.diagnostics.append(error.diagnostic)
            return None
        return plan

    def _plan(self, imports: Imports) -> tuple[NodePlan, Imports]:
        node, dialect = self._node, self._dialect
        plan = NodePlan(literals.string(node.name), naming.label(node.name, "of this file"))
        given = {name for each in node.endpoints.values() if (name := callback_of(each))}
        writing = Writing(node, self._catalog, dialect, imports, given)
        _check_names(writing)
        for add in _PARTS:
            add(writing, plan)
        plan.summary = _summary(node)
        plan.functions = frozenset(writing.functions)
        taken = imports.names() | dialect.reserved()
        plan.class_name = naming.Scope(taken).new(naming.class_name(node.name))
        plan.imports = imports.render(_standard(dialect, plan), dialect.modules, dialect.symbols)
        return plan, imports


def _check_names(writing: Writing) -> None:
    """Refuse what the program calls its functions where that can be no method."""
    dialect = writing.dialect
    for each in writing.node.endpoints.values():
        name, span = callback_of(each), each.span
        if name is None:
            continue
        if not literals.is_name(name):
            writing.refuse(codes.INVALID_FUNCTION, f"`{name}` cannot be a name in Python", span)
        if name.startswith("__") and name.endswith("__"):
            message = f"`{name}` has a meaning of its own in Python"
            writing.refuse(codes.INVALID_FUNCTION, message, span, "write a name without `__`")
        if name in dialect.method_names or name in dialect.attribute_names:
            message = f"`{name}` is a method that every {dialect.library} node has"
            writing.refuse(codes.INVALID_FUNCTION, message, span, f"write `on_{name}`, say")


def _standard(dialect: Dialect, plan: NodePlan) -> tuple[str, ...]:
    """Return the modules of Python that a node needs, those for calls and how they went too."""
    calling = dialect.calling if plan.calls else ()
    own = ("ctypes",) if AS_FLOAT32 in plan.functions else ()
    return (*dialect.standard, *own, *(name for name in calling if name != "sys" or plan.ends))


_MOST_SAID = 4
"""How much of what a node does is said: it has to go on one line."""


def _summary(node: Node) -> str:
    """Return what a node does, as a sentence."""
    parts = [
        ("publishes messages", node.of(Publisher)),
        ("listens to messages", node.of(Subscription)),
        ("provides services", node.of(Service)),
        ("calls services", node.of(Client)),
        ("repeats functions", node.of(Timer)),
        ("has parameters", node.of(Parameter)),
    ]
    does = [text for text, has in parts if has] or ["does nothing yet"]
    if len(does) > _MOST_SAID:
        does = [*does[: _MOST_SAID - 1], "more"]
    text = does[0] if len(does) == 1 else f"{', '.join(does[:-1])} and {does[-1]}"
    return f"{text[0].upper()}{text[1:]}."
