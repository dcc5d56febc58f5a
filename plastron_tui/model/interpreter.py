"""The interpreter: statements, from top to bottom, become a workspace.

A statement with a mistake has no effect, and gives one diagnostic; what merely follows from a
mistake gives none.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from itertools import product
from typing import Any, NamedTuple

from plastron_tui.diagnostics import Diagnostic, Label, Span, codes, has_errors, write
from plastron_tui.language import statements as st
from plastron_tui.language.declaration import DECLARATIONS, SlotKind, Statement
from plastron_tui.language.lowering import Program
from plastron_tui.ros.interfaces import InterfaceKind, InterfaceName

from .agreement import Agreement
from .checks import Mistake
from .fitting import Fitter
from .late import late_changes
from .messages import Messages
from .setting import LoadRequest, Setting
from .workspace import (
    DEFAULT_RATE,
    Client,
    EndpointKind,
    Generation,
    Node,
    Publication,
    Publisher,
    Service,
    Subscription,
    Workspace,
)


class Interpretation(NamedTuple):
    """What a program means, and what is wrong with it.

    `fitters` know the values of its statements, by generation of ROS: they are a help with the
    same program after an edit.
    """

    workspace: Workspace
    diagnostics: tuple[Diagnostic, ...]
    fitters: Mapping[int, Fitter]


_STRETCH = 256
"""How many statements are run between two beats of the pulse: less than a millisecond of them."""


def interpret(
    program: Program,
    setting: Setting,
    fitters: Mapping[int, Fitter] | None = None,
    pulse: Callable[[], None] | None = None,
) -> Interpretation:
    """Run the statements of a program and return the workspace that they build.

    Args:
        program: the statements.
        setting: what they are interpreted in.
        fitters: those of an interpretation of the program before it was edited.
        pulse: called now and then; what it raises ends the interpretation.
    """
    interpreter = Interpreter(setting, fitters)
    diagnostics = interpreter.run(program, pulse)
    # In a program with a mistake, the statement that generates may be the mistake.
    if not has_errors(diagnostics):
        diagnostics += tuple(late_changes(program, interpreter.workspace))
    return Interpretation(interpreter.workspace, diagnostics, interpreter.fitters)


class Interpreter(Messages):
    """Runs programs, one after the other, in one workspace."""

    def __init__(self, setting: Setting, fitters: Mapping[int, Fitter] | None = None) -> None:
        super().__init__(setting, fitters or {})
        self._found: list[tuple[int, Diagnostic]] = []
        # ROS 1 and ROS 2 are two graphs: what one means by a topic is nothing to the other.
        self._topics = {v: Agreement("topic", codes.TOPIC_TYPE_CONFLICT) for v in (1, 2)}
        self._services = {v: Agreement("service", codes.SERVICE_TYPE_CONFLICT) for v in (1, 2)}
        self._node_names: dict[str, Span] = {}
        # Functions, not methods of this object: a cycle would keep each interpretation alive
        # until the collector comes, which passes of this size keep away.
        self._run: dict[type[Statement], Callable[[Interpreter, Any], None]] = {
            # The method of a `publish_statement` is `_publish`.
            type_: getattr(Interpreter, f"_{declaration.kind.removesuffix('_statement')}")
            for type_, declaration in DECLARATIONS.items()
        }

    def run(
        self, program: Program, pulse: Callable[[], None] | None = None
    ) -> tuple[Diagnostic, ...]:
        """Run the statements of a program, and return all that is wrong with it, in its order."""
        self._program = program
        self._broken = set(program.broken.declared)
        self._lost = program.broken.lost
        self._lines = program.broken
        self._failed = set()
        self._failed_nodes = set()
        self._found = []
        for first in range(0, len(program.statements), _STRETCH):
            if pulse is not None:
                pulse()
            self._run_all(program.statements[first : first + _STRETCH])
        if program.diagnostics:
            self._found += [
                (0 if found.span is None else found.span.start, found)
                for found in program.diagnostics
            ]
            self._found.sort(key=lambda entry: entry[0])
        return tuple([found for _, found in self._found])

    def _run_all(self, statements: Sequence[Statement]) -> None:
        run = self._run
        for statement in statements:
            try:
                run[type(statement)](self, statement)
            except Mistake as mistake:  # noqa: PERF203 - each statement has its own
                found = mistake.diagnostic or self._unknown_type(statement)
                if found is not None:
                    self._report(statement, found)
                self._fail(statement)

    def _report(self, statement: Statement, diagnostic: Diagnostic) -> None:
        self._found.append((statement.span.start, diagnostic))

    def _fail(self, statement: Statement) -> None:
        """Remember what a statement without effect was to make: it is broken, not missing."""
        declaration = DECLARATIONS[type(statement)]
        filled = [(slot.kind, getattr(statement, slot.name)) for slot in declaration.slots]
        self._broken.update(text for kind, text in filled if kind.makes is not None)
        names = [text for kind, text in filled if kind in (SlotKind.TOPIC, SlotKind.SERVICE)]
        if names and declaration.undoes is None:
            nodes = [text for kind, text in filled if kind is SlotKind.NODE]
            self._failed.update(product(nodes, names))
            self._failed_nodes.update(nodes)

    def _create_node(self, statement: st.CreateNode) -> None:
        self._check_new_variable(statement, statement.variable)
        library = self._library(statement)
        version = self._setting.ros_version(library)
        self._check_name(statement, "name", statement.name, version)
        earlier = self._node_names.get(statement.name)
        if earlier is not None:
            raise Mistake(
                Diagnostic(
                    codes.NODE_EXISTS,
                    f"a node `{statement.name}` exists already",
                    statement.span_of("name"),
                    help="ROS stops the first of two nodes of one name; choose another",
                    labels=(Label(earlier, "first created here"),),
                )
            )
        span = statement.span
        self._node_names[statement.name] = span
        self.workspace.nodes[statement.variable] = Node(
            statement.name, statement.variable, span, library
        )

    def _load(self, statement: st.Load) -> None:
        from .loading import loaded_node, node_in  # most programs load nothing

        self._check_new_variable(statement, statement.variable)
        request = LoadRequest(
            statement.source, statement.is_path, tuple(self.workspace.generations)
        )
        loaded = self._setting.read(request)
        where = statement.span_of("source")
        for found in loaded.diagnostics:
            fix = None if loaded.right is None else write(loaded.right, where)
            placed = found if found.file is not None else found._replace(span=where, fix=fix)
            self._report(statement, placed)
        if loaded.source is None:
            raise Mistake
        source = node_in(loaded.source, statement)
        if isinstance(source, Diagnostic):
            raise Mistake(source)
        node = loaded_node(source, statement)
        self._adopt(node, statement)
        self.workspace.nodes[statement.variable] = node

    def _adopt(self, node: Node, statement: st.Load) -> None:
        """Note what types a loaded node means by its topics and services."""
        version = self._version_of(node)
        topics, services = self._topics[version], self._services[version]
        for publisher in node.publishers.values():
            topics.adopt(node, EndpointKind.PUBLISHER, publisher.topic, publisher.type, statement)
        for listener in node.subscriptions.values():
            topics.adopt(node, EndpointKind.SUBSCRIPTION, listener.topic, listener.type, statement)
        for service in node.services.values():
            services.adopt(node, EndpointKind.SERVICE, service.name, service.type, statement)
        for client in node.clients.values():
            services.adopt(node, EndpointKind.CLIENT, client.name, client.type, statement)

    def _subscribe(self, statement: st.Subscribe) -> None:
        node = self._node(statement)
        version = self._version_of(node)
        topic = statement.topic
        self._check_name(statement, "topic", topic, version)
        type_ = self._type(statement, statement.type, InterfaceKind.MESSAGE, version).name
        if topic in node.subscriptions:
            raise self._exists_already(
                statement,
                "topic",
                node,
                codes.ALREADY_SUBSCRIBED,
                f"`{node.variable}` subscribes to",
            )
        if statement.function is not None:
            handlers = ((service.handler, service.span) for service in node.services.values())
            self._check_function(statement, node, handlers)
        self._agree(statement, node, EndpointKind.SUBSCRIPTION, topic, type_)
        node.subscriptions[topic] = Subscription(topic, type_, statement.function, statement.span)

    def _unsubscribe(self, statement: st.Unsubscribe) -> None:
        node = self._node(statement)
        endpoints = node.subscriptions
        self._take(statement, "topic", node, endpoints, codes.NOT_SUBSCRIBED, "subscribe to")
        self._topics[self._version_of(node)].leave(node, EndpointKind.SUBSCRIPTION, statement.topic)

    def _publish(self, statement: st.Publish) -> None:
        node = self._node(statement)
        message = self._message(statement)
        version = self._version_of(node)
        topic = statement.topic
        self._check_name(statement, "topic", topic, version)
        type_ = self._type(statement, statement.type, InterfaceKind.MESSAGE, version).name
        message = self._message_for(message, version)
        self._check_sent(statement, message, type_)
        is_open = statement.rate is None
        rate = DEFAULT_RATE if statement.rate is None else self._rate(statement, statement.rate)
        publisher = node.publishers.get(topic)
        earlier = () if publisher is None else publisher.publications
        if earlier and any(publication.message is message for publication in earlier):
            what = f"`{node.variable}` publishes `{message.variable}` to"
            raise self._exists_already(statement, "topic", node, codes.ALREADY_PUBLISHING, what)
        self._agree(statement, node, EndpointKind.PUBLISHER, topic, type_)
        span = statement.span if publisher is None else publisher.span
        sent = Publication(message, rate, statement.span, is_open)
        node.publishers[topic] = Publisher(topic, type_, (*earlier, sent), span)

    def _stop_publishing(self, statement: st.StopPublishing) -> None:
        node = self._node(statement)
        self._take(statement, "topic", node, node.publishers, codes.NOT_PUBLISHING, "publish to")
        self._topics[self._version_of(node)].leave(node, EndpointKind.PUBLISHER, statement.topic)

    def _client_requests(self, statement: st.ClientRequests) -> None:
        node = self._node(statement)
        version = self._version_of(node)
        name = statement.service
        self._check_name(statement, "service", name, version)
        type_ = self._type(statement, statement.type, InterfaceKind.SERVICE, version)
        request = self._fit(statement, type_, version)
        self._agree(statement, node, EndpointKind.CLIENT, name, type_.name)
        client = node.clients.get(name)
        if client is None:
            node.clients[name] = Client(name, type_.name, (request,), statement.span)
        else:
            node.clients[name] = client._replace(requests=(*client.requests, request))

    def _stop_request(self, statement: st.StopRequest) -> None:
        node = self._node(statement)
        self._take(statement, "service", node, node.clients, codes.NOT_REQUESTING, "request")
        self._services[self._version_of(node)].leave(node, EndpointKind.CLIENT, statement.service)

    def _provides_service(self, statement: st.ProvidesService) -> None:
        node = self._node(statement)
        version = self._version_of(node)
        name = statement.service
        self._check_name(statement, "service", name, version)
        type_ = self._type(statement, statement.type, InterfaceKind.SERVICE, version).name
        if name in node.services:
            raise self._exists_already(
                statement, "service", node, codes.ALREADY_PROVIDING, f"`{node.variable}` provides"
            )
        if statement.function is not None:
            callbacks = ((each.callback, each.span) for each in node.subscriptions.values())
            self._check_function(statement, node, callbacks)
            others = (each for each in node.services.values() if each.type != type_)
            self._check_function(statement, node, ((each.handler, each.span) for each in others))
        self._agree(statement, node, EndpointKind.SERVICE, name, type_)
        other = self._services[version].other(
            node, EndpointKind.SERVICE, name, self.workspace.nodes
        )
        if other is not None:
            self._report(
                statement,
                Diagnostic(
                    codes.SERVICE_PROVIDED_TWICE,
                    f"another node of this program provides `{name}` too",
                    statement.span_of("service"),
                    help="a call reaches one of them only; give each a service of its own",
                    labels=(Label(other.span, "provided here"),),
                ),
            )
        node.services[name] = Service(name, type_, statement.function, statement.span)

    def _stop_service(self, statement: st.StopService) -> None:
        node = self._node(statement)
        self._take(statement, "service", node, node.services, codes.NOT_PROVIDING, "provide")
        self._services[self._version_of(node)].leave(node, EndpointKind.SERVICE, statement.service)

    def _generate_node(self, statement: st.GenerateNode) -> None:
        node = self._node(statement)
        library = self._library(statement) or node.library or self._setting.library
        if node.is_idle and not _has_other_work(node):
            if self._is_unfinished(node):
                raise Mistake
            raise Mistake(
                Diagnostic(
                    codes.IDLE_NODE,
                    f"`{node.variable}` does nothing yet",
                    statement.span_of("node"),
                    help="let it publish, subscribe, provide a service or request one first",
                    labels=(Label(node.span, "created here"),),
                )
            )
        self.workspace.generations.append(Generation(node.snapshot(), library, statement.span))

    def _agree(
        self, statement: Statement, node: Node, role: EndpointKind, name: str, type_: InterfaceName
    ) -> None:
        is_topic = role is EndpointKind.PUBLISHER or role is EndpointKind.SUBSCRIPTION
        agreements = self._topics if is_topic else self._services
        agreement = agreements[self._version_of(node)]
        conflict = agreement.join(node, role, name, type_, statement)
        if conflict is not None:
            # Where the other use was to be taken away, it may be there because of a mistake.
            raise Mistake(None if name in self._lines.words else conflict)


def _has_other_work(node: Node) -> bool:
    """Tell whether a loaded node does something that the workspace does not show."""
    from .loading import has_other_work

    return has_other_work(node)
