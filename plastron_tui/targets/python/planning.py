"""The plan of a Python file, from a node and the types that its library has."""

from __future__ import annotations

from collections import defaultdict
from typing import NoReturn

from plastron_tui.diagnostics import Code, Diagnostic, Span, codes
from plastron_tui.model.kinds import (
    Client,
    Endpoint,
    Publication,
    Publisher,
    Service,
    Subscription,
)
from plastron_tui.model.values import MessageValue, Value
from plastron_tui.model.workspace import Node
from plastron_tui.ros.catalog import Catalog, moved
from plastron_tui.ros.interfaces import FieldType, Interface, InterfaceKind, InterfaceName
from plastron_tui.ros.names import name_as_written
from plastron_tui.sources.python import literals, naming
from plastron_tui.sources.python.dialect import Dialect
from plastron_tui.sources.python.import_block import Imports

from .plan import (
    CallPlan,
    ClientPlan,
    MethodPlan,
    NodePlan,
    PublisherPlan,
    SendPlan,
    ServicePlan,
    SubscriptionPlan,
    TimerPlan,
)

_HEADER = InterfaceName("std_msgs", "Header")


class _CannotPlanError(Exception):
    """A part of the node that its client library cannot have; the diagnostic says which."""

    def __init__(self, diagnostic: Diagnostic) -> None:
        self.diagnostic = diagnostic


class Planner:
    """Plans one node.

    Attributes:
        diagnostics: why there is no plan.
    """

    def __init__(self, node: Node, catalog: Catalog, dialect: Dialect) -> None:
        self._node = node
        self._catalog = catalog
        self._dialect = dialect
        self._imports = Imports()
        self.diagnostics: list[Diagnostic] = []

    def plan(self) -> NodePlan | None:
        """Return the plan, None when the node cannot be written for its library."""
        try:
            plan = self._plan()
            clashes = self._imports.clashes(self._dialect.reserved())
            if clashes:
                self._imports = Imports(clashes)
                plan = self._plan()
        except _CannotPlanError as error:
            self.diagnostics.append(error.diagnostic)
            return None
        return plan

    def _plan(self) -> NodePlan:
        node, dialect = self._node, self._dialect
        plan = NodePlan(literals.string(node.name), naming.label(node.name, "of this file"))
        self._attributes = naming.Scope(dialect.attribute_names)
        self._methods: dict[str, MethodPlan] = {}
        for given in self._given_names():
            self._attributes.add(given)
        self._add_publishers(plan)
        self._add_subscriptions(plan)
        self._add_services(plan)
        self._add_clients(plan)
        plan.summary = _summary(node)
        taken = self._imports.names() | dialect.reserved()
        plan.class_name = naming.Scope(taken).new(naming.class_name(node.name))
        plan.imports = self._imports.render(
            _standard(dialect, plan),
            dialect.modules,
            dialect.symbols,
        )
        return plan

    def _given_names(self) -> set[str]:
        """Return the callbacks and handlers that the program names, if all can be methods."""
        node, dialect = self._node, self._dialect
        given = [(each.callback, each.span) for each in node.of(Subscription).values()]
        given += [(each.callback, each.span) for each in node.of(Service).values()]
        for name, span in given:
            if name is None:
                continue
            if not literals.is_name(name):
                self._refuse(codes.INVALID_FUNCTION, f"`{name}` cannot be a name in Python", span)
            if name.startswith("__") and name.endswith("__"):
                message = f"`{name}` has a meaning of its own in Python"
                self._refuse(codes.INVALID_FUNCTION, message, span, "write a name without `__`")
            if name in dialect.method_names or name in dialect.attribute_names:
                message = f"`{name}` is a method that every {dialect.library} node has"
                self._refuse(codes.INVALID_FUNCTION, message, span, f"write `on_{name}`, say")
        return {name for name, _ in given if name is not None}

    def _add_publishers(self, plan: NodePlan) -> None:
        for publisher in self._node.of(Publisher).values():
            name = naming.words(publisher.name)
            attribute = self._attributes.new(f"{name}_publisher")
            type_ = self._message_class(publisher.type, publisher.name, publisher.span)
            topic = self._name(publisher)
            plan.publishers.append(PublisherPlan(attribute, topic, type_))
            by_rate: dict[float, list[Publication]] = defaultdict(list)
            for publication in publisher.publications:
                by_rate[publication.rate].append(publication)
            for rate, publications in by_rate.items():
                method = self._attributes.new(f"publish_{name}")
                sends = tuple(self._send(publisher, each) for each in publications)
                label = naming.label(publisher.name, "its topic")
                plan.timers.append(TimerPlan(attribute, method, _period(rate), label, sends))

    def _name(self, endpoint: Endpoint) -> str:
        """Write the name of an endpoint as the client library takes it."""
        return literals.string(name_as_written(endpoint.name, self._dialect.ros_version))

    def _send(self, publisher: Publisher, publication: Publication) -> SendPlan:
        value = publication.message.value
        type_ = self._find(value.type, InterfaceKind.MESSAGE, publisher.span)
        has_header = any(
            field.name == "header" and field.type.message == _HEADER for field in type_.fields
        )
        header = value.fields.get("header")
        has_time = isinstance(header, MessageValue) and "stamp" in header.fields
        return SendPlan(self._message(value, publisher.span), has_header and not has_time)

    def _add_subscriptions(self, plan: NodePlan) -> None:
        for subscription in self._node.of(Subscription).values():
            type_ = self._message_class(subscription.type, subscription.name, subscription.span)
            callback = subscription.callback
            if callback is None:
                callback = self._attributes.new(f"on_{naming.words(subscription.name)}")
            topic = self._name(subscription)
            plan.subscriptions.append(SubscriptionPlan(topic, type_, callback))
            if callback not in self._methods:
                method = MethodPlan(callback, naming.label(subscription.name, callback))
                self._methods[callback] = method
                plan.callbacks.append(method)

    def _add_services(self, plan: NodePlan) -> None:
        for service in self._node.of(Service).values():
            type_ = self._service_type(service.type, service.name, service.span)
            handler = service.callback
            if handler is None:
                handler = self._attributes.new(f"handle_{naming.words(service.name)}")
            name = self._name(service)
            response = self._dialect.response(type_, self._imports)
            plan.services.append(ServicePlan(name, self._service_class(type_), handler))
            known = self._methods.get(handler)
            if known is None:
                method = MethodPlan(handler, naming.label(service.name, handler), response)
                self._methods[handler] = method
                plan.handlers.append(method)
            elif known.response != response:
                message = f"`{handler}` cannot answer `{service.name}` and do its other work"
                self._refuse(codes.INVALID_FUNCTION, message, service.span, "give it another name")

    def _add_clients(self, plan: NodePlan) -> None:
        for client in self._node.of(Client).values():
            type_ = self._service_type(client.type, client.name, client.span)
            attribute = self._attributes.new(f"{naming.words(client.name)}_client")
            name = self._name(client)
            plan.clients.append(ClientPlan(attribute, name, self._service_class(type_)))
            for request in client.requests:
                plan.calls.append(CallPlan(attribute, self._request(client, type_, request)))

    def _request(self, client: Client, type_: InterfaceName, request: MessageValue) -> str:
        interface = self._find(type_, InterfaceKind.SERVICE, client.span)
        class_ = self._dialect.request(type_, self._imports)
        return f"{class_}({self._arguments(interface, request, client.span)})"

    def _message(self, value: MessageValue, span: Span | None) -> str:
        interface = self._find(value.type, InterfaceKind.MESSAGE, span)
        class_ = self._imports.use(f"{interface.name.package}.msg", interface.name.name)
        return f"{class_}({self._arguments(interface, value, span)})"

    def _arguments(self, interface: Interface, value: MessageValue, span: Span | None) -> str:
        types = {field.name: field.type for field in interface.fields}
        written = []
        for name, each in value.fields.items():
            if name not in types:
                message = (
                    f"`{interface.name}` has no field `{name}` in {self._catalog.distribution}"
                )
                self._refuse(codes.UNKNOWN_FIELD, message, span, self._note(interface.name))
            argument = self._dialect.field(name)
            written.append(f"{argument}={self._value(types[name], each, span)}")
        return ", ".join(written)

    def _value(self, type_: FieldType, value: Value, span: Span | None) -> str:
        if type_.is_array and isinstance(value, tuple):
            element = type_._replace(is_array=False, length=None, bound=None)
            return f"[{', '.join(self._value(element, each, span) for each in value)}]"
        if isinstance(value, MessageValue):
            return self._message(value, span)
        return self._dialect.scalar(type_, value, self._imports)

    def _message_class(self, type_: InterfaceName | None, name: str, span: Span | None) -> str:
        found = self._known(type_, InterfaceKind.MESSAGE, name, span)
        return self._imports.use(f"{found.package}.msg", found.name)

    def _service_type(
        self, type_: InterfaceName | None, name: str, span: Span | None
    ) -> InterfaceName:
        return self._known(type_, InterfaceKind.SERVICE, name, span)

    def _service_class(self, type_: InterfaceName) -> str:
        return self._imports.use(f"{type_.package}.srv", type_.name)

    def _known(
        self, type_: InterfaceName | None, kind: InterfaceKind, name: str, span: Span | None
    ) -> InterfaceName:
        """Return the type as the distribution names it."""
        if type_ is None:
            message = f"the type of `{name}` is not known"
            self._refuse(codes.UNKNOWN_TYPE, message, span, "name its type in the source file")
        return self._find(type_, kind, span).name

    def _find(self, type_: InterfaceName, kind: InterfaceKind, span: Span | None) -> Interface:
        """Return an interface, under its new name where ROS has renamed it."""
        found = self._catalog.find(type_, kind)
        if found is None:
            instead = moved(type_, self._catalog.ros_version)
            if isinstance(instead, InterfaceName):
                found = self._catalog.find(instead, kind)
        if found is None:
            message = f"{self._catalog.distribution} has no type `{type_}`"
            self._refuse(codes.UNKNOWN_TYPE, message, span, self._note(type_))
        reason = self._dialect.unusable(found, self._catalog)
        if reason is not None:
            self._refuse(codes.UNUSABLE_TYPE, reason, span)
        return found

    def _note(self, type_: InterfaceName) -> str | None:
        """Return what is known to have become of a type."""
        note = moved(type_, self._catalog.ros_version)
        return f"use `{note}`" if isinstance(note, InterfaceName) else note

    def _refuse(
        self, code: Code, message: str, span: Span | None, help_text: str | None = None
    ) -> NoReturn:
        raise _CannotPlanError(Diagnostic(code, message, span or self._node.span, help=help_text))


def _standard(dialect: Dialect, plan: NodePlan) -> tuple[str, ...]:
    """Return the modules of Python that a node needs, those for calls and how they went too."""
    calling = dialect.calling if plan.calls else ()
    return (*dialect.standard, *(name for name in calling if name != "sys" or plan.ends))


def _period(rate: float) -> str:
    """Return the seconds between two messages, as a fraction that shows the rate."""
    return f"1 / {literals.number(int(rate) if rate.is_integer() else rate)}"


def _summary(node: Node) -> str:
    """Return what a node does, as a sentence."""
    parts = [
        ("publishes messages", node.of(Publisher)),
        ("listens to messages", node.of(Subscription)),
        ("provides services", node.of(Service)),
        ("calls services", node.of(Client)),
    ]
    does = [text for text, has in parts if has] or ["does nothing yet"]
    text = does[0] if len(does) == 1 else f"{', '.join(does[:-1])} and {does[-1]}"
    return f"{text[0].upper()}{text[1:]}."
