"""Services, and the calls of them."""

from __future__ import annotations

from plastron_tui.diagnostics import codes
from plastron_tui.model.kinds import Client, Service
from plastron_tui.ros.interfaces import InterfaceKind
from plastron_tui.sources.python import naming

from ..plan import CallPlan, ClientPlan, MethodPlan, NodePlan, ServicePlan
from .writing import Writing


def add_services(writing: Writing, plan: NodePlan) -> None:
    """Plan the services that a node provides."""
    for service in writing.node.of(Service).values():
        type_ = writing.known(service.type, InterfaceKind.SERVICE, service.name, service.span)
        handler = service.callback
        if handler is None:
            handler = writing.attributes.new(f"handle_{naming.words(service.name)}")
        response = writing.dialect.response(type_, writing.imports)
        answer, may_fail = "", False
        if service.answer is not None:
            answer = response = writing.response(type_, service.answer, service.span)
            may_fail = writing.may_fail(service.answer)
        class_ = writing.class_of(type_, InterfaceKind.SERVICE)
        plan.services.append(ServicePlan(writing.name(service), class_, handler))
        known = writing.methods.get(handler)
        if known is None:
            label = naming.label(service.name, handler)
            method = MethodPlan(handler, label, response, answer, may_fail)
            writing.methods[handler] = method
            plan.handlers.append(method)
        elif known.response != response:
            message = f"`{handler}` cannot answer `{service.name}` and do its other work"
            writing.refuse(codes.INVALID_FUNCTION, message, service.span, "give it another name")


def add_clients(writing: Writing, plan: NodePlan) -> None:
    """Plan the services that a node calls."""
    for client in writing.node.of(Client).values():
        type_ = writing.known(client.type, InterfaceKind.SERVICE, client.name, client.span)
        attribute = writing.attributes.new(f"{naming.words(client.name)}_client")
        class_ = writing.class_of(type_, InterfaceKind.SERVICE)
        plan.clients.append(ClientPlan(attribute, writing.name(client), class_))
        for request in client.requests:
            written = writing.request(type_, request.value, client.span)
            plan.calls.append(CallPlan(attribute, written))
