"""The plan of a whole Python file, from a node and the types that its library has."""

from __future__ import annotations

from plastron_tui.diagnostics import Diagnostic, codes
from plastron_tui.model.kinds import (
    ActionClient,
    ActionServer,
    Client,
    callback_of,
)
from plastron_tui.model.workspace import Node
from plastron_tui.ros.catalog import Catalog
from plastron_tui.sources.python import literals, naming
from plastron_tui.sources.python.dialect import Dialect
from plastron_tui.sources.python.import_block import Imports, Symbol
from plastron_tui.targets.planning import plan_parts, summary
from plastron_tui.targets.planning.plan import NodePlan
from plastron_tui.targets.planning.writing import CannotPlanError

from .writing import AS_FLOAT32, PythonWriting


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
            symbols = _symbols(self._dialect, plan)
            clashes = imports.clashes(self._dialect.reserved(symbols), symbols)
            if clashes:
                plan, _ = self._plan(Imports(clashes))
        except CannotPlanError as error:
            self.diagnostics.append(error.diagnostic)
            return None
        return plan

    def _plan(self, imports: Imports) -> tuple[NodePlan, Imports]:
        node, dialect = self._node, self._dialect
        plan = NodePlan(literals.string(node.name), naming.label(node.name, "of this file"))
        plan.is_managed = node.is_managed
        given = {name for each in node.endpoints.values() if (name := callback_of(each))}
        writing = PythonWriting(node, self._catalog, dialect, imports, given)
        _check_names(writing)
        plan_parts(writing, plan)
        plan.summary = summary(node)
        symbols = _symbols(dialect, plan)
        plan.functions = frozenset(writing.functions)
        taken = imports.names() | dialect.reserved(symbols)
        plan.class_name = naming.Scope(taken).new(naming.class_name(node.name))
        plan.imports = imports.render(_standard(dialect, plan), dialect.modules, symbols)
        return plan, imports


def _check_names(writing: PythonWriting) -> None:
    """Refuse what the program calls its functions where that can be no method."""
    dialect, node = writing.dialect, writing.node
    reserved = dialect.method_names | dialect.attribute_names
    managed = dialect.managed_names if node.is_managed else frozenset()
    reserved |= managed
    if any(node.of(ActionServer)) or any(node.of(ActionClient)) or any(node.of(Client)):
        reserved |= dialect.task_names
    for each in writing.node.endpoints.values():
        name, span = callback_of(each), each.span
        if name is None:
            continue
        if not literals.is_name(name):
            writing.refuse(codes.INVALID_FUNCTION, f"`{name}` cannot be a name in Python", span)
        if name.startswith("__") and name.endswith("__"):
            message = f"`{name}` has a meaning of its own in Python"
            writing.refuse(codes.INVALID_FUNCTION, message, span, "write a name without `__`")
        if name in reserved:
            which = " with calls or actions" if name in dialect.task_names else ""
            kind = "managed " if name in managed else ""
            message = f"`{name}` is a method that every {kind}{dialect.library} node{which} has"
            remedy = "give it another name" if name in managed else f"write `on_{name}`, say"
            writing.refuse(codes.INVALID_FUNCTION, message, span, remedy)


def _standard(dialect: Dialect, plan: NodePlan) -> tuple[str, ...]:
    """Return the modules of Python that a node needs, those for calls and how they went too."""
    calling = dialect.calling if plan.works else ()
    timing = dialect.timing if plan.timers else ()
    own = ("ctypes",) if AS_FLOAT32 in plan.functions else ()
    needed = [*dialect.standard, *own, *(name for name in calling if name != "sys" or plan.ends)]
    return tuple(dict.fromkeys((*needed, *timing)))


def _symbols(dialect: Dialect, plan: NodePlan) -> tuple[Symbol, ...]:
    """Return the names that the template of a node imports."""
    symbols = dialect.managed_symbols if plan.is_managed else dialect.symbols
    if plan.action_servers:
        symbols += dialect.server_symbols
    if plan.action_servers and plan.is_managed:
        symbols += dialect.managed_server_symbols
    if plan.goals:
        symbols += dialect.goal_symbols
    if plan.action_clients:
        symbols += dialect.client_symbols
    if plan.waits:
        symbols += dialect.task_symbols
    return symbols
