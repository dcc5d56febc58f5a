"""Services, and the calls of them."""

from __future__ import annotations

from collections import defaultdict

from plastron_tui.diagnostics import codes
from plastron_tui.model.kinds import Client, Rate, Service
from plastron_tui.ros.interfaces import InterfaceKind
from plastron_tui.sources import naming

from .periods import planned_timer
from .plan import ClientPlan, MethodPlan, NodePlan, ServicePlan, WorkPlan
from .writing import Writing


def add_services(writing: Writing, plan: NodePlan) -> None:
    """Plan the services that a node provides."""
    for service in writing.node.of(Service).values():
        type_ = writing.known(service.type, InterfaceKind.SERVICE, service.name, service.span)
        handler = service.callback
        if handler is None:
            handler = writing.attributes.new(f"handle_{naming.words(service.name)}")
        response = writing.empty_response(type_)
        answer, unsure = "", ""
        if service.answer is not None:
            answer = response = writing.response(type_, service.answer, service.span)
            unsure = ", ".join(writing.unsure(service.answer))
        class_ = writing.class_of(type_, InterfaceKind.SERVICE)
        attribute = writing.held(f"{naming.words(service.name)}_service")
        plan.services.append(ServicePlan(writing.name(service), class_, handler, attribute))
        key = writing.method_key(handler, class_)
        known = writing.methods.get(key)
        if known is None:
            label = naming.label(service.name, handler)
            method = MethodPlan(handler, label, class_, response, answer, unsure)
            writing.methods[key] = method
            plan.handlers.append(method)
        elif known.response != response:
            message = f"`{handler}` cannot answer `{service.name}` and do its other work"
            writing.refuse(codes.INVALID_FUNCTION, message, service.span, "give it another name")


def add_client(writing: Writing, plan: NodePlan, client: Client) -> None:
    """Plan a service that a node calls, with its requests."""
    type_ = writing.known(client.type, InterfaceKind.SERVICE, client.name, client.span)
    name = naming.words(client.name)
    attribute = writing.attributes.new(f"{name}_client")
    class_ = writing.class_of(type_, InterfaceKind.SERVICE)
    plan.clients.append(ClientPlan(attribute, writing.name(client), class_))
    by_rate: dict[Rate | None, list[str]] = defaultdict(list)
    for request in client.requests:
        by_rate[request.rate].append(writing.request(type_, request.value, client.span))
    for rate, requests in by_rate.items():
        work = WorkPlan(
            writing.attributes.new(f"call_{name}"),
            attribute,
            writing.name(client),
            naming.label(client.name, "the service"),
            tuple(requests),
        )
        if rate is not None:
            work = work._replace(repeat=writing.attributes.new(f"repeat_{name}"))
        work = work._replace(task=writing.sending(f"{name}_calls", is_repeated=rate is not None))
        if rate is not None:
            plan.timers.append(planned_timer(writing, rate, work.repeat, f"{name}_timer"))
        plan.works.append(work)
