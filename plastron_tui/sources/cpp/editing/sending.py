"""Publishing messages from files that exist: at a rate, once, or for what is heard."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Sequence
from dataclasses import dataclass

from plastron_tui.diagnostics import codes
from plastron_tui.model.kinds import Publication, Publisher, Rate, Reaction
from plastron_tui.model.source import EndpointKind
from plastron_tui.ros.interfaces import Field, InterfaceKind

from .. import literals
from ..analysis import Site
from ..scopes import Function
from .adding import Addition, put_in_body
from .computing import computing_for
from .hearing import hearing_functions
from .interfaces import refuse
from .manner import variable_naming
from .members import declare, is_local
from .parameter_names import commented_name, give_name
from .refilling import stamp
from .timers import capture, node_captures, period_of, run_at, timer_name
from .turns import Turn, may_leave, own_turn
from .uses import is_static

_ONCE = 5.0
"""How often a node of ROS 2 looks whether somebody listens, in hertz."""


@dataclass(frozen=True, slots=True)
class Sender:
    """What publishes.

    Attributes:
        variable: what holds the publisher.
        is_pointer: whether that points to it.
        is_local: whether it is a local variable.
        count: its method that counts who listens; that of `image_transport::Publisher` is another.
    """

    variable: str
    is_pointer: bool
    is_local: bool
    count: str = "get_subscription_count"

    @property
    def call(self) -> str:
        """What stands before a method of it."""
        return f"{self.variable}{'->' if self.is_pointer else '.'}"


def add_publishing(added: Addition, publisher: Publisher, sender: Sender) -> None:
    """Publish what a publisher is to publish."""
    unasked = [each for each in publisher.publications if each.reaction is None]
    _again(added, sender, [each for each in unasked if not each.is_once])
    _once(added, sender, [each for each in unasked if each.is_once])
    for each in publisher.publications:
        if each.reaction is not None:
            _react(added, sender, each, each.reaction)


def sends(
    added: Addition,
    sender: Sender,
    publication: Publication,
    variable: str,
    received: str = "",
    heard: Sequence[Field] = (),
) -> list[str]:
    """Return the lines that send one message."""
    value = publication.message.value
    interface = added.interfaces.find(value.type, InterfaceKind.MESSAGE, publication.span)
    class_ = added.interfaces.class_of(interface.name, InterfaceKind.MESSAGE)
    computing, conditions = computing_for(added, publication.span)
    required = []
    reaction = publication.reaction
    if reaction is not None and reaction.condition is not None:
        asked = reaction.condition
        written = literals.scalar(asked.value)
        required.append(computing.condition(asked, received, heard, written))
    lines = added.interfaces.fill(
        interface,
        interface.fields,
        value,
        f"{variable}.",
        computing,
        publication.span,
        received,
        heard,
    )
    if added.interfaces.needs_stamp(value):
        lines.append(stamp(added, f"{variable}."))
    lines = [f"{class_} {variable};", *lines, f"{sender.call}publish({variable});"]
    required = [*conditions.required, *required]
    if required:
        return added.style(added.place.file).block(f"if ({' && '.join(required)})", lines)
    return lines


def _again(added: Addition, sender: Sender, sent: Sequence[Publication]) -> None:
    if not sent:
        return
    turn = own_turn(added)
    if turn is not None and sender.is_local and turn.owner.type == "function_definition":
        turn = None
    if added.place.is_conditional:
        # Where there is no publisher, the turn is one nevertheless.
        turn = None
    fitting: list[Publication] = []
    by_rate: dict[Rate, list[Publication]] = defaultdict(list)
    for each in sent:
        is_fitting = turn is not None and each.fits(turn.rate)
        (fitting if is_fitting else by_rate[Rate(each.rate, each.parameter)]).append(each)
    if turn is not None and fitting:
        _publish_in(added, sender, turn, fitting)
    for rate, publications in by_rate.items():
        body = []
        for at, each in enumerate(publications):
            body += sends(added, sender, each, f"message{'' if not at else f'_{at + 1}'}")
        period = period_of(added, rate)
        run_at(added, added.topic, "publish", period, body, captures=_captures(added, sender, body))


def _captures(added: Addition, sender: Sender, body: Sequence[str]) -> tuple[str, ...]:
    """Return what a lambda that sends takes of a function."""
    own = (capture(added, sender.variable, is_pointer=sender.is_pointer),)
    node = added.place.node
    uses_node = bool(node) and any(node in line for line in body)
    return (*node_captures(added), *own) if uses_node else own


def _publish_in(
    added: Addition, sender: Sender, turn: Turn, publications: Sequence[Publication]
) -> None:
    lines = []
    for each in publications:
        lines += sends(added, sender, each, added.free(f"{added.topic}_message"))
    if turn.before is not None:
        added.put_above(turn.file, turn.before, lines)
    else:
        put_in_body(added, turn.file, turn.owner, turn.body, lines, is_end=True)
    added.include_types(turn.file)


def _once(added: Addition, sender: Sender, publications: Sequence[Publication]) -> None:
    """Send some messages once, behind the publisher's creation; in ROS 2 once somebody listens."""
    if not publications:
        return
    lines: list[str] = []
    for each in publications:
        name = "message" if added.is_ros2 else added.free(f"{added.topic}_message")
        number = "" if not lines or not added.is_ros2 else f"_{len(lines)}"
        lines += sends(added, sender, each, f"{name}{number}")
    if not added.is_ros2:
        added.lines += lines
        return
    timer = timer_name(added, added.topic)
    is_member = added.owner is not None
    like = variable_naming(added.analysis, EndpointKind.TIMER, added.sites, is_member=is_member)
    named = like.bare.name(f"{added.topic}_is_heard")
    heard = added.free(named, like.end)
    if is_local(added):
        added.lines.append(f"bool {heard} = false;")
    else:
        declare(added, f"bool {heard} = false;")
    body = [
        f"const bool was_heard = {heard};",
        f"{heard} = {sender.call}{sender.count}() > 0;",
        *added.style(added.place.file).block(
            f"if (was_heard && {heard})",
            [
                "// A subscription that is there for so long knows this publisher too.",
                f"{timer}->cancel();",
                *lines,
            ],
        ),
    ]
    taken = (*_captures(added, sender, body), f"&{timer}", f"&{heard}")
    period = period_of(added, _ONCE)
    run_at(added, added.topic, "publish", period, body, timer=timer, captures=taken)


def _react(added: Addition, sender: Sender, publication: Publication, reaction: Reaction) -> None:
    """Send for each message of a topic in the function that hears it.

    Raises:
        RefusedError: it is to be sent by hand.
    """
    sites = [
        site
        for site in added.sites
        if site.endpoint.kind is EndpointKind.SUBSCRIPTION
        and reaction.topic in (site.endpoint.name, site.endpoint.default)
    ]
    reason = ""
    functions = [each for site in sites for each in hearing_functions(added, site)]
    function = functions[0] if len(functions) == 1 and len(sites) == 1 else None
    body = function.body if function is not None else None
    if not sites:
        reason = "the file does not subscribe to it"
    elif sites[0].endpoint.type is None:
        reason = "the file does not say its type"
    elif function is None or body is None:
        reason = "no one function of the file hears it"
    elif len(function.parameters) != 1:
        reason = f"`{function.name or 'a lambda'}` takes more or less than the message"
    elif not _sees(added, function, sender):
        reason = f"`{function.name or 'a lambda'}` does not see `{sender.variable}`"
    elif len(added.analysis.callers.of(function)) > (site_is_lambda(sites[0]) and 1):
        reason = f"`{function.name}` is called for something else too"
    if reason or function is None or body is None:
        message = f"`{added.endpoint.name}` is not sent for each message of `{reaction.topic}`"
        remedy = f"publish to `{added.endpoint.name}` by hand in the function that hears"
        refuse(
            codes.EDIT_REFUSED, f"{message}: {reason}", added.span, f"{remedy} `{reaction.topic}`"
        )
    parameter = function.parameters[0]
    text = function.file.syntax.slice(parameter.node)
    is_pointer = "Ptr" in text or "_ptr" in text or parameter.is_pointer
    type_ = sites[0].endpoint.type
    interface = None
    if type_ is not None:
        interface = added.interfaces.find(type_, InterfaceKind.MESSAGE, publication.span)
    name = parameter.name
    if not name:
        commented = commented_name(function, parameter)
        name = "msg" if commented is None else commented[0]
    holder = f"{name}{'->' if is_pointer else '.'}"
    variable = added.free(f"{added.topic}_message")
    fields = interface.fields if interface is not None else ()
    lines = sends(added, sender, publication, variable, holder, fields)
    if not parameter.name and any(holder in line for line in lines):
        give_name(added.plan, function, parameter, name)
    # What the function may leave early, or moves away, is sent at its start.
    syntax = function.file.syntax
    is_end = (
        not may_leave(body) and b"std::move" not in syntax.code[body.start_byte : body.end_byte]
    )
    put_in_body(added, function.file, function.node, body, lines, is_end)
    added.include_types(function.file)


def _sees(added: Addition, function: Function, sender: Sender) -> bool:
    """Tell whether a function that hears can name what publishes."""
    if function.node.type != "lambda_expression":
        is_method = added.analysis.unit.class_of_function(function) is added.owner
        return is_method and not is_static(added.analysis, function) and not sender.is_local
    syntax = function.file.syntax
    taken = function.node.child_by_field_name("captures")
    text = "" if taken is None else "".join(syntax.word(taken).split())
    if sender.is_local:
        at = function.node.start_byte
        return text.startswith("[&") and text[2:3] in ("]", ",") and at > added.place.offset
    return added.owner is None or "this" in text or text[:2] in ("[&", "[=")


def site_is_lambda(site: Site) -> bool:
    """Tell whether a lambda stands between a subscription and the function that hears it."""
    return not site.callback.functions


__all__ = ["Sender", "add_publishing", "sends"]
