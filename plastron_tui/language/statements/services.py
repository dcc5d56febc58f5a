"""The statements about services."""

from __future__ import annotations

from ..declaration import SlotKind, Statement, slot, statement
from ..inputs import Input, Rate
from .shared import CALLBACK_HELP

SERVICE_HELP = "the service, a name that nodes share"


@statement(
    "client_requests_statement",
    "{node} client_requests {service} of service_type {type} with input {input} [at {rate} hz]",
    summary="Let a node call a service.",
    example="caller client_requests 'add' of service_type AddTwoInts with input 5, 6",
    purpose="ask a question and wait for the answer",
    ros_term="service client",
    about="A request goes to the one node that provides the service, and its answer comes back.",
)
class ClientRequests(Statement):
    """Let a node call a service."""

    node: str = slot(SlotKind.NODE, "the node that asks")
    service: str = slot(SlotKind.SERVICE, SERVICE_HELP)
    type: str = slot(SlotKind.SERVICE_TYPE, "the type of the service")
    input: Input = slot(SlotKind.INPUT, "the values of the request, in order or by name")
    rate: Rate | None = slot(SlotKind.RATE, "how often, in hertz; without it once")


@statement(
    "stop_request_statement",
    "{node} stop_request {service}",
    summary="Let a node no longer call a service.",
    example="caller stop_request 'add'",
    purpose="no longer ask a question",
    ros_term="service client",
    about="Takes a service client away again.",
    undoes=ClientRequests,
)
class StopRequest(Statement):
    """Let a node no longer call a service."""

    node: str = slot(SlotKind.NODE, "the node that asks")
    service: str = slot(SlotKind.SERVICE, SERVICE_HELP)


@statement(
    "provides_service_statement",
    "{node} provides_service {service} of service_type {type}"
    " [answering {answer}] [calling {function}]",
    summary="Let a node answer the calls of a service.",
    example="adder provides_service 'add' of service_type AddTwoInts",
    purpose="answer questions",
    ros_term="service",
    about="Other nodes call, a function of this node works out the answer.",
)
class ProvidesService(Statement):
    """Let a node answer the calls of a service."""

    node: str = slot(SlotKind.NODE, "the node that answers")
    service: str = slot(SlotKind.SERVICE, SERVICE_HELP)
    type: str = slot(SlotKind.SERVICE_TYPE, "the type of the service")
    answer: Input | None = slot(SlotKind.ANSWER, "the values of the answer, in order or by name")
    function: str | None = slot(SlotKind.FUNCTION, CALLBACK_HELP)


@statement(
    "stop_service_statement",
    "{node} stop_service {service}",
    summary="Let a node no longer answer the calls of a service.",
    example="adder stop_service 'add'",
    purpose="no longer answer questions",
    ros_term="service",
    about="Takes a service away again.",
    undoes=ProvidesService,
)
class StopService(Statement):
    """Let a node no longer answer the calls of a service."""

    node: str = slot(SlotKind.NODE, "the node that answers")
    service: str = slot(SlotKind.SERVICE, SERVICE_HELP)
