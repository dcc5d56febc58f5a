"""What every statement is checked for: its variables, its names, its functions."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from plastron_tui.diagnostics import (
    Code,
    Diagnostic,
    Edit,
    Fix,
    Label,
    Span,
    codes,
    guess,
    write,
    write_before,
)
from plastron_tui.language import statements as st
from plastron_tui.language.declaration import Statement
from plastron_tui.language.sentence import sentence
from plastron_tui.ros.catalog import DISTRIBUTIONS
from plastron_tui.ros.interfaces import InterfaceName
from plastron_tui.ros.names import (
    NameProblem,
    check_node_name,
    check_service_name,
    check_topic_name,
    parameter_name,
    spelled,
)

from .consequences import Consequences
from .context import Setting
from .kinds import MADE_BY, EndpointKind, callback_of
from .kinds.needs import users_of
from .libraries import default_library
from .mistake import Mistake, function_conflict
from .other_things import another
from .workspace import Node, Workspace

_VERSIONS = {"ros1": 1, "ros2": 2, **DISTRIBUTIONS}
"""The generation of ROS that is meant by its name, or by a distribution's."""


NameCheck = Callable[[str, int], NameProblem | None]
"""Says what is wrong with a name in a generation of ROS."""

_CHECKS: dict[str, NameCheck] = {
    "name": check_node_name,
    "topic": check_topic_name,
    "service": check_service_name,
    "action": check_service_name,
    "trigger": check_topic_name,
}


class Checks:
    """Looks up what a statement names, and raises a mistake where there is none such."""

    def __init__(self, setting: Setting, workspace: Workspace, consequences: Consequences) -> None:
        """Check what is written against a workspace.

        Args:
            setting: what programs are interpreted in.
            workspace: what the program has built so far.
            consequences: tells what merely follows from an earlier mistake.
        """
        self._setting = setting
        self._workspace = workspace
        self._consequences = consequences
        self._versions: dict[str | None, int] = {}
        self._shared: set[str] = set()

    def new_variable(self, statement: Statement, variable: str) -> None:
        """Check that a statement may give a variable its meaning."""
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
        self.new_name(statement, "variable", variable)

    def new_name(self, statement: Statement, slot: str, variable: str) -> None:
        """Check that a name of the program stands for nothing yet."""
        earlier = self._workspace.what(variable)
        if earlier is None:
            return
        word, span = earlier
        raise Mistake(
            Diagnostic(
                codes.VARIABLE_EXISTS,
                f"a {word} `{variable}` exists already",
                statement.span_of(slot),
                help="all variables share one namespace; choose another name",
                labels=(Label(span, "first created here"),),
            )
        )

    def node(self, statement: Any) -> Node:
        """Return the node that a statement is about."""
        variable: str = statement.node
        node = self._workspace.nodes.get(variable)
        if node is not None:
            return node if variable not in self._shared else self._own(variable)
        if self._consequences.declares(variable):
            raise Mistake
        where = statement.span_of("node")
        remedy, fix = guess(variable, self._workspace.nodes, where)
        remedy, fix = another(self._workspace, statement, variable) or (remedy, fix)
        if remedy is None:
            remedy = f"make it first: `create_node '{variable}' as {variable}`"
        if fix is not None:
            # The node that is meant lacks this statement: it is not to be called idle.
            self._consequences.add_nodes({edit.text for edit in fix.edits})
        raise Mistake(
            Diagnostic(codes.UNKNOWN_NODE, f"no node `{variable}`", where, help=remedy, fix=fix)
        )

    def share(self) -> None:
        """Change no node any more that there is now, but a copy of it."""
        self._shared = set(self._workspace.nodes)

    def own_all(self) -> None:
        """Have copies of all nodes that are shared."""
        for variable in list(self._shared):
            self._own(variable)

    def _own(self, variable: str) -> Node:
        self._shared.remove(variable)
        node = self._workspace.nodes[variable] = self._workspace.nodes[variable].snapshot()
        return node

    def library(self, statement: st.CreateNode | st.GenerateNode) -> str | None:
        """Return the client library that a statement names."""
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

    def version_of(self, node: Node) -> int:
        """Return the generation of ROS that a node is for."""
        return self._versions.get(node.library) or self.version(node.library)

    def version(self, library: str | None) -> int:
        """Return the generation of ROS of a client library, None for that of the program."""
        if library not in self._versions:
            self._versions[library] = self._setting.ros_version(library)
        return self._versions[library]

    def name(
        self,
        statement: Statement,
        slot: str,
        name: str,
        version: int,
        check: NameCheck | None = None,
    ) -> None:
        """Check that a slot has a name that a generation of ROS takes."""
        problem = (check or _CHECKS[slot])(name, version)
        if problem is not None:
            raise Mistake(_wrong_name(statement, slot, name, problem))

    def function(self, statement: Any, node: Node, type_: InterfaceName | None = None) -> None:
        """Check the function that a statement calls: its name, and what else the node calls it for.

        A callback takes a message, a handler a request: no function can be both, nor give
        answers of two types.

        Args:
            statement: the statement.
            node: the node.
            type_: the type of what it answers to, None where that says nothing.
        """
        function = statement.function
        if function is None:
            return
        self.function_name(statement, node)
        kind = MADE_BY[type(statement)]
        for (other_kind, name), other in node.endpoints.items():
            if callback_of(other) != function:
                continue
            # What is sent for each message of a topic is sent by the function that takes them.
            sends = bool(users_of(node, other_kind, name))
            if sends or other_kind is not kind or type_ not in (None, other.type):
                message = f"`{node.variable}` calls `{function}` for something else already"
                remedy = "each kind of message and request needs a function of its own"
                raise function_conflict(message, remedy, statement.span_of("function"), other.span)

    def function_name(self, statement: Any, node: Node | None) -> None:
        """Check that a function may have its name in a node, None for one that is not there."""
        function = statement.function
        name = self._setting.library if node is None else node.library or self._setting.library
        library = self._setting.libraries.get(name)
        if function is None or library is None or not library.is_keyword(function):
            return
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

    def absent(self, statement: Statement, node: Node) -> None:
        """Check that a node does not have yet what a statement gives it."""
        kind = MADE_BY[type(statement)]
        editing = kind.editing
        assert editing.already is not None, "it may be said again"
        name = self.endpoint_name(statement, node, kind)
        earlier = node.by_kind[kind].get(name)
        if earlier is None:
            return
        what = f"`{node.variable}` {editing.indicative}"
        slot = editing.name_slot
        first = None
        if earlier.span is None and not users_of(node, kind, name):
            texts = {"node": node.variable, slot: getattr(statement, slot)}
            first = sentence(editing.ending, texts)
        code = editing.already
        raise self.exists_already(statement, slot, node, code, what, earlier.span, first)

    def unused(self, statement: Statement, node: Node, kind: EndpointKind) -> None:
        """Check that nothing else of a node needs an endpoint that a statement takes away."""
        name = self.endpoint_name(statement, node, kind)
        users = users_of(node, kind, name) if name in node.by_kind[kind] else ()
        if users:
            slot = kind.editing.name_slot
            raise Mistake(
                Diagnostic(
                    codes.STILL_NEEDED,
                    f"`{node.variable}` needs `{getattr(statement, slot)}` for something else",
                    statement.span_of(slot),
                    help="take away first what needs it",
                    labels=tuple(Label(span, "needed here") for span in users),
                )
            )

    def endpoint_name(self, statement: Statement, node: Node, kind: EndpointKind) -> str:
        """Return the name of the endpoint that a statement is about, as nodes have it."""
        written: str = getattr(statement, kind.editing.name_slot)
        if kind is EndpointKind.PARAMETER:
            return parameter_name(written, self.version_of(node))
        return spelled(written)

    def take(self, statement: Statement, node: Node, kind: EndpointKind) -> str:
        """Take an endpoint away from a node, and return its name, or say that there is none."""
        editing = kind.editing
        slot = editing.name_slot
        name = self.endpoint_name(statement, node, kind)
        if not node.take(kind, name):
            if self._consequences.explains(node, name):
                raise Mistake
            where = statement.span_of(slot)
            name, *names = map(kind.written, (name, *node.by_kind[kind]))
            is_quoted = kind.facts.named is not None
            remedy, fix = guess(name, names, where, is_quoted=is_quoted)
            message = f"`{node.variable}` does not {editing.infinitive} `{name}`"
            raise Mistake(Diagnostic(editing.not_there, message, where, help=remedy, fix=fix))
        node.removed[name] = statement.span
        return name

    def exists_already(
        self,
        statement: Any,
        slot: str,
        node: Node,
        code: Code,
        what: str,
        earlier: Span | None,
        first: str | None = None,
    ) -> Mistake:
        """Make the mistake of what the node has already, since an earlier statement if known.

        What it has of its file may be changed: by the statement, after `first`.
        """
        name = spelled(getattr(statement, slot))
        if self._consequences.explains(node, name):
            return Mistake()
        fix = Fix("take the statement away", (Edit(statement.span, ""),))
        remedy = None
        if first is not None:
            remedy = f"to change what the file has, write `{first}` before"
            fix = write_before(first, statement.span)
        labels = () if earlier is None else (Label(earlier, "said first here"),)
        message = f"{what} `{name}` already"
        where = statement.span_of(slot)
        return Mistake(Diagnostic(code, message, where, help=remedy, fix=fix, labels=labels))


def _wrong_name(statement: Statement, slot: str, name: str, problem: NameProblem) -> Diagnostic:
    whole = statement.span_of(slot)
    start = whole.start + 1  # within the quotes
    before = len(name[: problem.offset].encode())
    length = len(name[problem.offset : problem.offset + problem.length].encode())
    return Diagnostic(
        codes.INVALID_NAME,
        problem.message,
        Span(start + before, start + before + length),
        help=None if problem.suggestion is None else f"write '{problem.suggestion}'",
        fix=None if problem.suggestion is None else write(f"'{problem.suggestion}'", whole),
    )
