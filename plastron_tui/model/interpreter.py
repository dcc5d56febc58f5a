"""The interpreter: statements, from top to bottom, become a workspace.

A statement with a mistake has no effect, and gives one diagnostic; what merely follows from a
mistake gives none.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

from plastron_tui.diagnostics import Diagnostic, Label, Span
from plastron_tui.language import statements as st
from plastron_tui.language.declaration import Statement
from plastron_tui.language.lowering import Program
from plastron_tui.language.pause import collection_paused
from plastron_tui.ros.interfaces import InterfaceKind, InterfaceName

from .agreement import Agreement
from .checks import Checks, Mistake, exists_already
from .loading import has_other_work, loaded_node
from .setting import LoadRequest, Setting
from .source import EndpointKind
from .workspace import (
    DEFAULT_RATE,
    Client,
    Generation,
    Message,
    Node,
    Publication,
    Publisher,
    Service,
    Subscription,
    Workspace,
)


@dataclass(frozen=True, slots=True)
class Interpretation:
    """What a program means, and what is wrong with it."""

    workspace: Workspace
    diagnostics: tuple[Diagnostic, ...]


def interpret(program: Program, setting: Setting) -> Interpretation:
    """Run the statements of a program and return the workspace that they build."""
    interpreter = Interpreter(setting)
    with collection_paused():
        diagnostics = interpreter.run(program)
    return Interpretation(interpreter.workspace, diagnostics)


class Interpreter(Checks):
    """Runs programs, one after the other, in one workspace."""

    def __init__(self, setting: Setting) -> None:
        super().__init__(setting)
        self._diagnostics: list[Diagnostic] = []
        self._topics = Agreement("topic")
        self._services = Agreement("service")
        self._node_names: dict[str, Span] = {}
        self._run: dict[type[Statement], Callable[[Any], None]] = {
            st.CreateNode: self._create_node,
            st.Load: self._load,
            st.CreateMessage: self._create_message,
            st.Subscribe: self._subscribe,
            st.Unsubscribe: self._unsubscribe,
            st.Publish: self._publish,
            st.StopPublishing: self._stop_publishing,
            st.ClientRequests: self._client_requests,
            st.StopRequest: self._stop_request,
            st.ProvidesService: self._provides_service,
            st.StopService: self._stop_service,
            st.GenerateNode: self._generate_node,
        }

    def run(self, program: Program) -> tuple[Diagnostic, ...]:
        """Run the statements of a program, and return all that is wrong with it."""
        self._broken |= program.broken_words
        self._diagnostics = list(program.diagnostics)
        run = self._run
        for statement in program.statements:
            try:
                run[type(statement)](statement)
            except Mistake as mistake:  # noqa: PERF203 - each statement has its own
                if mistake.diagnostic is not None:
                    self._diagnostics.append(mistake.diagnostic)
                # What the statement was to declare is broken, not unknown.
                declared = getattr(statement, "variable", None)
                if declared is not None:
                    self._broken.add(declared)
        return tuple(self._diagnostics)

    def _create_node(self, statement: st.CreateNode) -> None:
        self._check_new_variable(statement, statement.variable)
        library = self._library(statement)
        version = self._version if library is None else self._setting.libraries[library]
        self._check_name(statement, "name", statement.name, version)
        earlier = self._node_names.get(statement.name)
        if earlier is not None:
            raise Mistake(
                Diagnostic(
                    "node-exists",
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
        self._check_new_variable(statement, statement.variable)
        request = LoadRequest(
            statement.source, statement.is_path, tuple(self.workspace.generations)
        )
        loaded = self._setting.read(request)
        where = statement.span_of("source")
        self._diagnostics.extend(
            found if found.file is not None else replace(found, span=where)
            for found in loaded.diagnostics
        )
        if loaded.source is None:
            raise Mistake
        node = loaded_node(loaded.source, statement)
        for publisher in node.publishers.values():
            self._topics.adopt(
                node, EndpointKind.PUBLISHER, publisher.topic, publisher.type, statement
            )
        for listener in node.subscriptions.values():
            self._topics.adopt(
                node, EndpointKind.SUBSCRIPTION, listener.topic, listener.type, statement
            )
        for service in node.services.values():
            self._services.adopt(node, EndpointKind.SERVICE, service.name, service.type, statement)
        for client in node.clients.values():
            self._services.adopt(node, EndpointKind.CLIENT, client.name, client.type, statement)
        self.workspace.nodes[statement.variable] = node

    def _create_message(self, statement: st.CreateMessage) -> None:
        self._check_new_variable(statement, statement.variable)
        version = self._version
        type_ = self._type(statement, statement.type, InterfaceKind.MESSAGE, version)
        value = self._fit(statement, type_, version)
        self.workspace.messages[statement.variable] = Message(
            statement.variable, value, statement.span
        )

    def _subscribe(self, statement: st.Subscribe) -> None:
        node = self._node(statement)
        version = self._version_of(node)
        topic = statement.topic
        self._check_name(statement, "topic", topic, version)
        type_ = self._type(statement, statement.type, InterfaceKind.MESSAGE, version).name
        if topic in node.subscriptions:
            raise exists_already(
                statement, "already-subscribed", f"`{node.variable}` subscribes to", topic
            )
        self._check_function(statement, statement.function)
        self._agree(statement, node, EndpointKind.SUBSCRIPTION, topic, type_)
        node.subscriptions[topic] = Subscription(topic, type_, statement.function, statement.span)

    def _unsubscribe(self, statement: st.Unsubscribe) -> None:
        node = self._node(statement)
        endpoints = node.subscriptions
        self._take(statement, "topic", node, endpoints, "not-subscribed", "subscribe to")
        self._topics.leave(node, EndpointKind.SUBSCRIPTION, statement.topic)

    def _publish(self, statement: st.Publish) -> None:
        node = self._node(statement)
        message = self._message(statement)
        version = self._version_of(node)
        topic = statement.topic
        self._check_name(statement, "topic", topic, version)
        type_ = self._type(statement, statement.type, InterfaceKind.MESSAGE, version).name
        if message.value.type != type_:
            raise Mistake(
                Diagnostic(
                    "message-type-mismatch",
                    f"`{message.variable}` is of type `{message.value.type}`, not `{type_}`",
                    statement.span_of("type"),
                    help=f"write of message_type {message.value.type}",
                    labels=(Label(message.span, "created here"),),
                )
            )
        rate = DEFAULT_RATE if statement.rate is None else self._rate(statement, statement.rate)
        publisher = node.publishers.get(topic)
        earlier = () if publisher is None else publisher.publications
        if any(publication.message is message for publication in earlier):
            what = f"`{node.variable}` publishes `{message.variable}` to"
            raise exists_already(statement, "already-publishing", what, topic)
        self._agree(statement, node, EndpointKind.PUBLISHER, topic, type_)
        span = statement.span if publisher is None else publisher.span
        node.publishers[topic] = Publisher(
            topic, type_, (*earlier, Publication(message, rate, statement.span)), span
        )

    def _stop_publishing(self, statement: st.StopPublishing) -> None:
        node = self._node(statement)
        self._take(statement, "topic", node, node.publishers, "not-publishing", "publish to")
        self._topics.leave(node, EndpointKind.PUBLISHER, statement.topic)

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
            node.clients[name] = replace(client, requests=(*client.requests, request))

    def _stop_request(self, statement: st.StopRequest) -> None:
        node = self._node(statement)
        self._take(statement, "service", node, node.clients, "not-requesting", "request")
        self._services.leave(node, EndpointKind.CLIENT, statement.service)

    def _provides_service(self, statement: st.ProvidesService) -> None:
        node = self._node(statement)
        version = self._version_of(node)
        name = statement.service
        self._check_name(statement, "service", name, version)
        type_ = self._type(statement, statement.type, InterfaceKind.SERVICE, version).name
        if name in node.services:
            raise exists_already(
                statement, "already-providing", f"`{node.variable}` provides", name
            )
        self._check_function(statement, statement.function)
        self._agree(statement, node, EndpointKind.SERVICE, name, type_)
        node.services[name] = Service(name, type_, statement.function, statement.span)

    def _stop_service(self, statement: st.StopService) -> None:
        node = self._node(statement)
        self._take(statement, "service", node, node.services, "not-providing", "provide")
        self._services.leave(node, EndpointKind.SERVICE, statement.service)

    def _generate_node(self, statement: st.GenerateNode) -> None:
        node = self._node(statement)
        library = self._library(statement) or node.library or self._setting.library
        if node.is_idle and not has_other_work(node):
            raise Mistake(
                Diagnostic(
                    "idle-node",
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
        agreement = (
            self._topics
            if role is EndpointKind.PUBLISHER or role is EndpointKind.SUBSCRIPTION
            else self._services
        )
        conflict = agreement.join(node, role, name, type_, statement)
        if conflict is not None:
            raise Mistake(conflict)
