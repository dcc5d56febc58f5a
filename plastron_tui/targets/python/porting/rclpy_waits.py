"""From rospy to rclpy: what waits for others: calls of services, and for a service or message.

A thread handles what comes meanwhile. Where a callback may be what waits, the executor has a
second thread for it, and what is waited for is in a callback group of its own.
"""

from __future__ import annotations

from dataclasses import dataclass, field

from tree_sitter import Node

from plastron_tui.model.source import EndpointKind
from plastron_tui.ros.interfaces import InterfaceKind
from plastron_tui.sources.python.analysis import Site
from plastron_tui.sources.python.arguments import Arguments
from plastron_tui.sources.python.calls import Argument
from plastron_tui.sources.python.constants import Known
from plastron_tui.sources.python.scopes import BindingKind
from plastron_tui.sources.python.splices import Splice

from .call_graph import functions_that_reach, reaches
from .endpoints import site_of, visible_type
from .fields import Given, fields_of, write_fields
from .kinds import is_plain, kind_of
from .plain import given_to, is_side, put
from .port_state import Work
from .rclpy_node import has_node
from .rclpy_running import INTERRUPT_IMPORTS, INTERRUPTS, LISTENS, caught, port_caught
from .rclpy_words import is_number
from .rewriting import time_module

_CLIENT_NAMES = ("client", "proxy", "service", "srv")
_GROUP = "callback_group=ReentrantCallbackGroup()"
_ANSWER = frozenset({"rospy.ServiceException", "rospy.service.ServiceException"})
_TIME_IS_UP = frozenset({"rospy.ROSException", "rospy.exceptions.ROSException"})

_CALL = """\
def {call}(client, request):
    \"\"\"Call a service, and wait for its answer.\"\"\"
    if not client.wait_for_service(timeout_sec=1.0):
        raise {error}(f"service [{{client.service_name}}] unavailable")
    answered = threading.Event()
    future = client.call_async(request)
    future.add_done_callback(lambda future: answered.set())
    while not answered.wait(0.1):
        if not rclpy.ok():
            raise ROSInterruptException
    return future.result()
"""
_SERVICE = """\
def {service}(service, timeout=None):
    \"\"\"Wait until a service is there, no longer than some seconds.\"\"\"
    name = {node}.resolve_service_name(service)
    end = {time}.time() + timeout if timeout else None
    while rclpy.ok():
        if {node}.count_services(name):
            return
        if end is not None and {time}.time() >= end:
            raise {error}(f"timeout exceeded while waiting for service {{name}}")
        {time}.sleep(0.1)
    raise ROSInterruptException
"""
_MESSAGE = """\
def {message}(subscription, timeout=None):
    \"\"\"Return the first message that comes, in some seconds.\"\"\"
    came = queue.Queue()
    subscription.callback = came.put
    end = {time}.time() + timeout if timeout is not None else None
    try:
        while rclpy.ok():
            try:
                return came.get(timeout=0.1)
            except queue.Empty:
                if end is not None and {time}.time() >= end:
                    raise {error}(f"no message on topic {{subscription.topic_name}}")
    finally:
        {node}.destroy_subscription(subscription)
    raise ROSInterruptException
"""
_ERROR = """\
class {name}(Exception):
    \"\"\"{what}\"\"\"
"""


@dataclass(frozen=True, slots=True)
class _Call:
    """A call of a service.

    Attributes:
        call: the call.
        client: what holds the client.
        request: what makes the request of what is given, empty where it is one.
        given: what is given.
        site: what makes the client.
    """

    call: Node
    client: Node
    request: str
    given: Given
    site: Site


@dataclass(slots=True)
class Waits:
    """What a file waits for, as far as it can be brought to rclpy.

    Attributes:
        calls: the calls of services.
        services: the calls that wait for a service, with what holds a client that does.
        messages: the calls that wait for a message.
        in_callbacks: whether a callback may be what waits.
        names: the names of the functions that wait: `call`, `service` and `message`.
    """

    calls: list[_Call] = field(default_factory=list)
    services: list[tuple[Node, Node | None]] = field(default_factory=list)
    messages: list[Site] = field(default_factory=list)
    in_callbacks: bool = False
    names: dict[str, str] = field(default_factory=dict)

    def is_message(self, site: Site) -> bool:
        """Tell whether an endpoint is a message that the file waits for."""
        return any(site is each for each in self.messages)

    @property
    def group(self) -> str:
        """What a call of rclpy takes for what a callback waits for."""
        return f", {_GROUP}" if self.in_callbacks else ""

    @property
    def needs_thread(self) -> bool:
        """Whether what comes has to be handled while the file waits."""
        return bool(self.calls or self.messages)


def find_waits(work: Work) -> Waits:
    """Find what a file waits for; what nobody can be sure of is marked, or left to be."""
    waits = Waits()
    is_made = any(each.call is not None for each in work.analysis.nodes)
    for call in work.analysis.captures.get("call", []):
        callee = call.child_by_field_name("function")
        if callee is None:
            continue
        if _is_client(work, callee):
            can_wait = is_made and has_node(work, call)
            made = _service_call(work, call, callee) if can_wait else None
            if made is not None:
                waits.calls.append(made)
            else:
                remedy = "`call_async` a request, and take its future"
                work.mark(call, f"the call of {work.slice(callee)}", remedy)
        elif b"wait_for_service" in (callee.text or b"") and is_made and has_node(work, call):
            part = callee.child_by_field_name("attribute")
            holder = callee.child_by_field_name("object")
            is_function = set(work.qualified(callee)) == {"rospy.wait_for_service"}
            is_method = part is not None and work.slice(part) == "wait_for_service"
            if is_function and _is_known_wait(work, call, Argument(0, "service")):
                waits.services.append((call, None))
            elif is_method and holder is not None and _is_known_wait(work, call, None):
                site = site_of(work, holder, EndpointKind.CLIENT)
                waits.services += [(call, holder)] if site is not None else []
    waits.messages = [each for each in work.analysis.sites if is_made and _is_message(work, each)]
    listens = any(
        site.endpoint.kind in LISTENS and not waits.is_message(site) for site in work.analysis.sites
    )
    waits.in_callbacks = listens and waits.needs_thread
    waits.names = {
        "call": work.free_name("call_service"),
        "service": work.free_name("wait_for_service"),
        "message": work.free_name("wait_for_message"),
    }
    return waits


def _is_client(work: Work, callee: Node) -> bool:
    """Tell whether a callee is a client, which rospy calls as a function, or its `call`."""
    part, holder = callee.child_by_field_name("attribute"), callee.child_by_field_name("object")
    if part is not None and holder is not None and work.slice(part) == "call":
        made = work.analysis.resolver.instance(holder, work.scope(holder))
        if made is not None and made.qualified.endswith(".ServiceProxy"):
            return True
    found = work.analysis.resolver.instance(callee, work.scope(callee))
    if found is not None:
        return found.qualified.endswith(".ServiceProxy")
    # A function that is handed a client: nothing else tells what its parameter is.
    name = work.slice(callee)
    is_client = any(each in name.lower() for each in _CLIENT_NAMES)
    has_clients = any(s.endpoint.kind is EndpointKind.CLIENT for s in work.analysis.sites)
    bound = work.scope(callee).lookup(name) if has_clients and is_client else None
    return bound is not None and any(each.kind is BindingKind.PARAMETER for each in bound[1])


def _service_call(work: Work, call: Node, callee: Node) -> _Call | None:
    """Return how a client is called, None where nobody can be sure of the request."""
    part, arguments = callee.child_by_field_name("attribute"), call.child_by_field_name("arguments")
    holder = callee.child_by_field_name("object")
    is_method = part is not None and work.slice(part) == "call" and holder is not None
    client = holder if is_method and holder is not None else callee
    site = site_of(work, client, EndpointKind.CLIENT)
    if site is None and is_method:
        client, site = callee, site_of(work, callee, EndpointKind.CLIENT)
    if site is None or arguments is None or arguments.type != "argument_list":
        return None
    if client.type not in ("identifier", "attribute") or _serves(work, site):
        return None
    given, class_ = given_to(work, arguments), visible_type(work, site, call)
    if given is None:
        return None
    if len(given) == 1 and given[0][0] is None:
        value = given[0][1]
        if is_side(work, value, "Request"):
            return _Call(call, client, "", given, site)
        if not is_plain(kind_of(work, value)):
            return None
    if class_ is None or (given and _fields(work, site, given) is None):
        return None
    return _Call(call, client, f"{class_}.Request", given, site)


def _serves(work: Work, client: Site) -> bool:
    """Tell whether the file serves what a client calls, which waits for the callback that calls."""
    return any(
        site.endpoint.kind is EndpointKind.SERVICE and site.endpoint.name == client.endpoint.name
        for site in work.analysis.sites
    )


def _fields(work: Work, site: Site, given: Given) -> list[Splice] | None:
    type_ = site.endpoint.type
    known = fields_of(work, type_, InterfaceKind.SERVICE, "Request") if type_ is not None else None
    return write_fields(work, given, known) if known is not None else None


def _is_known_wait(work: Work, call: Node, name: Argument | None) -> bool:
    """Tell whether a name is known, and a timeout is a number of seconds."""
    arguments = Arguments.of(call, work.analysis.syntax)
    timeout = arguments.get(Argument(1 if name is not None else 0, "timeout"))
    count = len(arguments.positional) + len(arguments.keywords)
    if arguments.is_open or count != (name is not None) + (timeout is not None):
        return False
    if timeout is not None and timeout.type != "none" and not is_number(work, timeout):
        return False
    if name is None:
        return True
    given = arguments.get(name)
    folded = work.analysis.resolver.fold(given, work.scope(call)) if given is not None else None
    return isinstance(folded, Known) and not str(folded.value).startswith("~")


def _is_message(work: Work, site: Site) -> bool:
    if not site.shape.gives_message:
        return False
    timeout = site.arguments.get(Argument(2, "timeout"))
    is_known = timeout is None or timeout.type == "none" or is_number(work, timeout)
    return is_known and not site.arguments.is_open and has_node(work, site.call)


def port_waits(work: Work, waits: Waits, node: str) -> None:
    """Rewrite what waits, and what is caught then."""
    names = waits.names
    answer, time_is_up = work.free_name("ServiceException"), work.free_name("ROSException")
    for each in waits.calls:
        _port_call(work, each, names["call"])
    for call, client in waits.services:
        _port_service(work, call, client, names["service"])
    answers = [each.call for each in waits.calls]
    waiting = [call for call, _ in waits.services] + [each.call for each in waits.messages]
    used = _port_caught(work, [*answers, *waiting], answer, time_is_up)
    used |= _port_raised(work, time_is_up)
    if answers or answer in used:
        what = "A service that is not there."
        work.helpers.append(_ERROR.format(name=answer, what=what))
    if waiting or time_is_up in used:
        what = "What did not come in time, or is not as it has to be."
        work.helpers.append(_ERROR.format(name=time_is_up, what=what))
    if answers:
        work.helpers.append(_CALL.format(**names, error=answer))
        work.imports.add("import threading")
    if waits.services:
        time = time_module(work)
        work.helpers.append(_SERVICE.format(**names, node=node, error=time_is_up, time=time))
    if waits.messages:
        time = time_module(work)
        helper = _MESSAGE.format(**names, node=node, error=time_is_up, time=time)
        work.helpers.append(helper)
        work.imports.add("import queue")
    if answers or waiting:
        work.imports.add(INTERRUPT_IMPORTS[1])
    if waits.in_callbacks:
        work.imports.add("from rclpy.callback_groups import ReentrantCallbackGroup")


def _port_call(work: Work, each: _Call, name: str) -> None:
    """Hand the client and its request to the function that waits for the answer."""
    arguments = each.call.child_by_field_name("arguments")
    assert arguments is not None
    encode = work.analysis.syntax.encode
    start, end = arguments.start_byte, arguments.end_byte
    work.done.add(each.call.id)
    work.insert(each.client.start_byte, f"{name}(")
    if not each.request:
        work.cut(Splice(each.client.end_byte, start + 1, encode(", ")))
        return
    work.cut(Splice(each.client.end_byte, start, encode(f", {each.request}")))
    put(work, _fields(work, each.site, each.given) or [])
    work.insert_last(end, ")")


def _port_service(work: Work, call: Node, client: Node | None, name: str) -> None:
    callee, arguments = (call.child_by_field_name(each) for each in ("function", "arguments"))
    assert callee is not None
    assert arguments is not None
    if client is None:
        work.replace(callee, name)
        return
    encode = work.analysis.syntax.encode
    work.done.update((call.id, *(each.id for each in callee.named_children)))
    gap = ", " if arguments.named_child_count else ""
    work.insert(callee.start_byte, f"{name}(")
    work.cut(Splice(client.end_byte, arguments.start_byte + 1, encode(f".srv_name{gap}")))


def _port_caught(work: Work, waiting: list[Node], answer: str, time_is_up: str) -> set[str]:
    """Rewrite what is caught around what waits, and return it; what others raise is rospy's own."""
    functions = functions_that_reach(work, waiting)
    used = set()
    for node in caught(work, _ANSWER | _TIME_IS_UP):
        clause: Node | None = node
        while clause is not None and clause.type != "try_statement":
            clause = clause.parent
        body = clause.child_by_field_name("body") if clause is not None else None
        if body is not None and reaches(work, body, waiting, functions):
            is_answer = bool(set(work.qualified(node)) & _ANSWER)
            used.add(answer if is_answer else time_is_up)
            port_caught(work, node, answer if is_answer else f"{time_is_up}, {INTERRUPTS}")
    return used


def _port_raised(work: Work, name: str) -> set[str]:
    """Rewrite what the file raises itself, and return it."""
    if b"ROSException" not in work.analysis.syntax.text:
        return set()
    raised = [
        callee
        for call in work.analysis.captures.get("call", [])
        if (callee := call.child_by_field_name("function")) is not None
        and set(work.qualified(callee)) & _TIME_IS_UP
    ]
    for callee in raised:
        work.replace(callee, name)
    return {name} if raised else set()
