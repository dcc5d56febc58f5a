"""What every statement is checked for: its variables, names, types, values."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import Any

from plastron_tui.diagnostics import Code, Diagnostic, Edit, Fix, Label, Span, codes, guess, write
from plastron_tui.language import statements as st
from plastron_tui.language.broken import Broken
from plastron_tui.language.declaration import DECLARATIONS, SlotKind, Statement
from plastron_tui.ros.catalog import DISTRIBUTIONS
from plastron_tui.ros.interfaces import Interface, InterfaceKind
from plastron_tui.ros.names import (
    NameProblem,
    check_node_name,
    check_service_name,
    check_topic_name,
)

from .fitting import Fitter
from .libraries import default_library
from .setting import Setting
from .types import TypeProblem, TypeResolver
from .values import MessageValue
from .workspace import Node, Workspace

_HIGHEST_RATE = 1e6
"""More than any node sends, in hertz; a typing error."""

_LOWEST_RATE = 1e-9
"""The lowest rate, in hertz: ROS 1 counts the seconds between two messages in 31 bits (genpy)."""

_VERSIONS = {"ros1": 1, "ros2": 2, **DISTRIBUTIONS}
"""The generation of ROS that is meant by its name, or by a distribution's."""


class Mistake(Exception):  # noqa: N818 - control flow, from a check to `interpret`
    """The statement at hand has a mistake; without a diagnostic, it follows from another."""

    def __init__(self, diagnostic: Diagnostic | None = None) -> None:
        self.diagnostic = diagnostic


_INTERFACES = {
    SlotKind.MESSAGE_TYPE: InterfaceKind.MESSAGE,
    SlotKind.SERVICE_TYPE: InterfaceKind.SERVICE,
}

_CHECKS: dict[str, Callable[[str, int], NameProblem | None]] = {
    "name": check_node_name,
    "topic": check_topic_name,
    "service": check_service_name,
}


class Checks:
    """Looks up what a statement names, and raises a mistake where there is none such."""

    def __init__(self, setting: Setting, fitters: Mapping[int, Fitter]) -> None:
        """Start with nothing.

        Args:
            setting: what programs are interpreted in.
            fitters: those of an earlier interpretation, by their generation of ROS.
        """
        self.workspace = Workspace()
        self._setting = setting
        self._broken: set[str] = set()
        self._lost = 0
        self._lines = Broken()
        self._failed: set[tuple[str, str]] = set()
        self._failed_nodes: set[str] = set()
        self._version = setting.ros_version(None)
        self._resolvers: dict[int, TypeResolver] = {}
        self.fitters: dict[int, Fitter] = {}
        self._earlier_fitters = fitters

    def _check_new_variable(self, statement: Statement, variable: str) -> None:
        if not variable[0].isalpha():
            where, right = statement.span_of("variable"), variable.lstrip("_") or "node1"
            raise Mistake(
                Diagnostic(
                    codes.INVALID_VARIABLE,
                    f"a variable starts with a letter, and `{variable}` does not",
                    where,
                    help=f"write `{right}`",
                    fix=write(right, where),
                )
            )
        workspace = self.workspace
        node = workspace.nodes.get(variable)
        earlier = node or workspace.messages.get(variable)
        if earlier is None:
            return
        raise Mistake(
            Diagnostic(
                codes.VARIABLE_EXISTS,
                f"a {'message' if node is None else 'node'} `{variable}` exists already",
                statement.span_of("variable"),
                help="nodes and messages share one namespace; choose another name",
                labels=(Label(earlier.span, "first created here"),),
            )
        )

    def _node(self, statement: Any) -> Node:
        node = self.workspace.nodes.get(statement.node)
        if node is not None:
            return node
        variable: str = statement.node
        if self._is_broken(variable):
            raise Mistake
        where = statement.span_of("node")
        remedy, fix = guess(variable, self.workspace.nodes, where)
        if variable in self.workspace.messages:
            remedy, fix = f"`{variable}` is a message", None
        if remedy is None:
            remedy = f"make it first: `create_node '{variable}' as {variable}`"
        if fix is not None:
            # The node that is meant lacks this statement: it is not to be called idle.
            self._failed_nodes.update(edit.text for edit in fix.edits)
        raise Mistake(
            Diagnostic(codes.UNKNOWN_NODE, f"no node `{variable}`", where, help=remedy, fix=fix)
        )

    def _is_broken(self, variable: str) -> bool:
        """Tell whether a variable that is not there was to be declared by a broken statement."""
        if variable not in self._broken and self._lost > 0:
            self._lost -= 1
            self._broken.add(variable)
        return variable in self._broken

    def _follows(self, node: Node, name: str) -> bool:
        """Tell whether what a node has under a name may be so because of an earlier mistake."""
        variable, lines = node.variable, self._lines
        return (
            (variable, name) in self._failed
            or variable in lines.unfinished
            or "" in lines.unfinished
            or (variable in lines.words and name in lines.words)
        )

    def _is_unfinished(self, node: Node) -> bool:
        """Tell whether a mistake kept a node from having what it was to have."""
        variable, lines = node.variable, self._lines
        return variable in self._failed_nodes or variable in lines.words or "" in lines.unfinished

    def _library(self, statement: st.CreateNode | st.GenerateNode) -> str | None:
        library = statement.library
        if library is None or library in self._setting.libraries:
            return library
        where = statement.span_of("library")
        version = _VERSIONS.get(library.lower())
        known = None if version is None else default_library(self._setting.libraries, version)
        names = self._setting.libraries if known is None else (known,)
        remedy, fix = guess(library if known is None else known, names, where)
        raise Mistake(
            Diagnostic(
                codes.UNKNOWN_LIBRARY,
                f"no client library `{library}`",
                where,
                help=remedy or f"there are {', '.join(names)}",
                fix=fix,
            )
        )

    def _version_of(self, node: Node) -> int:
        return self._setting.ros_version(node.library)

    def _check_name(self, statement: Statement, slot: str, name: str, version: int) -> None:
        problem = _CHECKS[slot](name, version)
        if problem is None:
            return
        whole = statement.span_of(slot)
        start = whole.start + 1  # within the quotes
        before = len(name[: problem.offset].encode())
        length = len(name[problem.offset : problem.offset + problem.length].encode())
        raise Mistake(
            Diagnostic(
                codes.INVALID_NAME,
                problem.message,
                Span(start + before, start + before + length),
                help=None if problem.suggestion is None else f"write '{problem.suggestion}'",
                fix=None if problem.suggestion is None else write(f"'{problem.suggestion}'", whole),
            )
        )

    def _type(
        self, statement: Statement, text: str, kind: InterfaceKind, version: int
    ) -> Interface:
        found = self._resolver(version).resolve(text, kind)
        if not isinstance(found, TypeProblem):
            return found
        where = statement.span_of("type")
        remedy: str | None = self._elsewhere(text, kind, version)
        fix: Fix | None = None
        if remedy is None:
            remedy = found.help
            fix = None if found.right is None else write(found.right, where)
        raise Mistake(Diagnostic(found.code, found.message, where, help=remedy, fix=fix))

    def _unknown_type(self, statement: Any) -> Diagnostic | None:
        """Return what is wrong with a type, whatever the broken node or message beside it is."""
        slots = DECLARATIONS[type(statement)].slots
        kind = next((_INTERFACES[slot.kind] for slot in slots if slot.kind in _INTERFACES), None)
        if kind is None:
            return None
        node = self.workspace.nodes.get(getattr(statement, "node", ""))
        version = self._version if node is None else self._version_of(node)
        # A node that is not there may be for the other ROS.
        others = {1, 2} - {version} if node is None else ()
        try:
            self._type(statement, statement.type, kind, version)
        except Mistake as mistake:
            found = (self._resolver(other).resolve(statement.type, kind) for other in others)
            if all(isinstance(each, TypeProblem) for each in found):
                return mistake.diagnostic
        return None

    def _elsewhere(self, text: str, kind: InterfaceKind, version: int) -> str | None:
        """Say how to get the other ROS, which has a type, where nobody chose this one."""
        if self._setting.is_chosen or version != self._version:
            return None
        other = 3 - version
        library = default_library(self._setting.libraries, other)
        if isinstance(self._resolver(other).resolve(text, kind), TypeProblem):
            return None
        return (
            f"ROS {other} has it, and ROS {version} is only the default: use `--target {library}`, "
            f"or write `target: {library}` in plastron.yaml"
        )

    def _resolver(self, version: int) -> TypeResolver:
        resolver = self._resolvers.get(version)
        if resolver is None:
            catalog = self._setting.catalog(version)
            resolver = self._resolvers[version] = TypeResolver(catalog)
            self.fitters[version] = Fitter(catalog, self._earlier_fitters.get(version))
        return resolver

    def _fit(
        self, statement: st.CreateMessage | st.ClientRequests, type_: Interface, version: int
    ) -> MessageValue:
        value = self.fitters[version].fit(type_, statement)
        if isinstance(value, Diagnostic):
            raise Mistake(value)
        return value

    def _rate(self, statement: Statement, rate: int | float) -> float:
        if _LOWEST_RATE <= rate <= _HIGHEST_RATE:
            return float(rate)
        where = statement.span_of("rate")
        is_negative = _LOWEST_RATE <= -rate <= _HIGHEST_RATE
        raise Mistake(
            Diagnostic(
                codes.INVALID_RATE,
                f"a rate is at least {_LOWEST_RATE:g} and at most {_HIGHEST_RATE:g} hz",
                where,
                help=f"write `at {-rate:g} hz`" if is_negative else None,
                fix=write(f"{-rate:g}", where) if is_negative else None,
            )
        )

    def _check_function(
        self,
        statement: st.Subscribe | st.ProvidesService,
        node: Node,
        others: Iterable[tuple[str | None, Span | None]],
    ) -> None:
        """Check the function that a statement calls: its name, and what else the node calls it for.

        A callback takes a message, a handler a request: no function can be both.
        """
        function = statement.function
        if function is None:
            return
        library = self._setting.libraries.get(node.library or self._setting.library)
        if library is not None and library.is_keyword(function):
            where = statement.span_of("function")
            raise Mistake(
                Diagnostic(
                    codes.INVALID_FUNCTION,
                    f"`{function}` is a keyword of {library.language} and cannot be a function",
                    where,
                    help=f"write `{function}_`",
                    fix=write(f"{function}_", where),
                )
            )
        for called, elsewhere in others:
            if called == function:
                labels = () if elsewhere is None else (Label(elsewhere, "called here"),)
                raise Mistake(
                    Diagnostic(
                        codes.FUNCTION_CONFLICT,
                        f"`{node.variable}` calls `{function}` for something else already",
                        statement.span_of("function"),
                        help="each kind of message and request needs a function of its own",
                        labels=labels,
                    )
                )

    def _take(
        self,
        statement: Statement,
        slot: str,
        node: Node,
        endpoints: dict[str, Any],
        code: Code,
        verb: str,
    ) -> None:
        """Take an endpoint away from the statement's node, or say that it has none such."""
        name: str = getattr(statement, slot)
        if endpoints.pop(name, None) is None:
            if self._follows(node, name):
                raise Mistake
            where = statement.span_of(slot)
            remedy, fix = guess(name, endpoints, where, is_quoted=True)
            message = f"`{node.variable}` does not {verb} `{name}`"
            raise Mistake(Diagnostic(code, message, where, help=remedy, fix=fix))
        node.removed[name] = statement.span

    def _exists_already(
        self, statement: Any, slot: str, node: Node, code: Code, what: str
    ) -> Mistake:
        """Make the mistake of an endpoint that the node has already."""
        name: str = getattr(statement, slot)
        if self._follows(node, name):
            return Mistake()
        fix = Fix("take the statement away", (Edit(statement.span, ""),))
        return Mistake(
            Diagnostic(code, f"{what} `{name}` already", statement.span_of(slot), fix=fix)
        )
