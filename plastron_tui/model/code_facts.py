"""What the code of a node does besides creating endpoints, as far as the source says it for sure.

A language reads it (`Language.code_facts`), rules look at it (`lint`). What hangs on a value that
is not known, on what another file may do, or on a name that may be bound to something else as well,
is not among it.
"""

from __future__ import annotations

import re
from enum import Enum
from typing import NamedTuple

from plastron_tui.diagnostics import Span
from plastron_tui.ros.interfaces import InterfaceKind, InterfaceName

from .kinds import EndpointKind


class Part(Enum):
    """Which message of an interface is meant."""

    MESSAGE = "message"
    REQUEST = "request"
    RESPONSE = "response"
    GOAL = "goal"
    RESULT = "result"
    FEEDBACK = "feedback"

    @property
    def section(self) -> int:
        """Which of the sections of its definition it is, from 0."""
        if self is Part.FEEDBACK:
            return 2
        return int(self in (Part.RESPONSE, Part.RESULT))


class MessageType(NamedTuple):
    """A message, or one of the messages that a service or an action is made of."""

    name: InterfaceName
    part: Part = Part.MESSAGE

    @property
    def kind(self) -> InterfaceKind:
        """The kind of the interface."""
        if self.part is Part.MESSAGE:
            return InterfaceKind.MESSAGE
        is_service = self.part in (Part.REQUEST, Part.RESPONSE)
        return InterfaceKind.SERVICE if is_service else InterfaceKind.ACTION


ITEM = "[]"
"""An index in a path of names of fields, `msg.poses[0].position`."""


class MessageField(NamedTuple):
    """A message, or what it has at a path of names of fields."""

    type: MessageType
    path: tuple[str, ...] = ()


class FieldUse(NamedTuple):
    """A field of a message that is read or written: `msg.linear.x`.

    Attributes:
        type: the type of the message.
        path: the names of the fields, with `ITEM` for an index in Python; in C++ an index is left
            out, and ends a path where it is not known that what is indexed is a list of messages.
        spans: where the names stand, those of the last ones where a variable has the rest.
        file: the name of the file in its set, "" for the main file.
        others: what the field may be as well, where a variable has one or another message.
        is_set: whether it is only given a value.
    """

    type: MessageType
    path: tuple[str, ...]
    spans: tuple[Span, ...]
    file: str = ""
    others: tuple[MessageField, ...] = ()
    is_set: bool = False


class ValueKind(Enum):
    """What a value is, as Python and C++ tell values apart."""

    BOOL = "bool"
    INT = "int"
    FLOAT = "float"
    TEXT = "str"
    BYTES = "bytes"
    LIST = "list"
    DICT = "dict"
    SET = "set"
    NONE = "None"
    MESSAGE = "message"
    CLASS = "class"
    """The class of a message, `String` for `String()`."""
    TIME = "time"
    """A time or a duration of the client library, `node.get_clock().now()`."""


class FieldValue(NamedTuple):
    """A value that a field of a message gets.

    Attributes:
        type: the type of the message.
        path: the names of the fields, none for the message as a whole; `ITEM` for an index, and
            `#0` for what a constructor gets as its first argument.
        kind: what the value is.
        span: the value.
        file: the name of the file in its set, "" for the main file.
        text: the source of a literal, "" for any other value.
        elements: what the elements of a list are, as far as each is known.
        message: the type of a value that is a message.
        source: the message, or the field of one, that the value is.
        items: where an element of a list is a plain decimal literal, in the order of the list.
        others: the fields that may be meant as well, where a variable has one or another message.
        extremes: the least and the greatest of those literals, none where there is none.
    """

    type: MessageType
    path: tuple[str, ...]
    kind: ValueKind
    span: Span
    file: str = ""
    text: str = ""
    elements: tuple[ValueKind, ...] = ()
    message: InterfaceName | None = None
    source: MessageField | None = None
    items: tuple[Span, ...] = ()
    others: tuple[MessageField, ...] = ()
    extremes: tuple[int, ...] = ()


class Built(NamedTuple):
    """A message that is constructed.

    Attributes:
        type: its type.
        positional: how many arguments have no name.
        keywords: the names of the others, each with its place.
        span: the call.
        file: the name of the file in its set, "" for the main file.
        places: where the arguments without a name begin.
    """

    type: MessageType
    positional: int
    keywords: tuple[tuple[str, Span], ...]
    span: Span
    file: str = ""
    places: tuple[int, ...] = ()


REMOVING = ("action", "DELETE")
"""The path of an action that may take away what was shown, of a marker."""


def adds(value: bytes) -> bool:
    """Tell whether an expression is what the action of a marker is that shows something."""
    return re.search(rb"(?:^|\W)(?:ADD|MODIFY)$|^0$", value) is not None


class Sent(NamedTuple):
    """A message that is published, whose making is known as a whole.

    Attributes:
        type: its type.
        paths: the paths of all fields that get a value, or may: what is handed to a function that
            is not known may get any, and is then no `Sent`. `REMOVING` is among them where the
            field `action` may get another value than `ADD` or `MODIFY`.
        span: the call that publishes it.
        file: the name of the file in its set, "" for the main file.
        made: where the variable that holds it is made, in bytes; -1 where it has none.
    """

    type: MessageType
    paths: frozenset[tuple[str, ...]]
    span: Span
    file: str = ""
    made: int = -1


class Wait(Enum):
    """What holds up whoever calls it."""

    SERVICE = "a service call that waits for the answer"
    ACTION = "an action that waits for the result"
    SPIN = "spinning until something is done"
    SLEEP = "sleep"


class Blocking(NamedTuple):
    """A call that waits, in a function that the executor calls.

    Attributes:
        wait: what it waits for.
        callback: the function that the executor calls, which calls it, itself or by others.
        kind: the kind of the endpoint whose callback that is.
        span: the call.
        file: the name of the file in its set, "" for the main file.
        is_endless: whether what it waits for can never come: what brings the answer is done by the
            thread that waits. False where several threads, or groups of callbacks, may do it.
        seconds: how long it sleeps, None where that is not known.
        created: where the call begins that hands the callback over.
        inside: the function that makes the call, "" where that is the callback itself.
    """

    wait: Wait
    callback: str
    kind: EndpointKind
    span: Span
    file: str = ""
    is_endless: bool = False
    seconds: float | None = None
    created: int = 0
    inside: str = ""


class Arity(NamedTuple):
    """A callback that cannot be called as its endpoint calls it.

    Attributes:
        callback: its name.
        kind: the kind of the endpoint.
        given: how many arguments the endpoint gives it.
        least: how many it has to get.
        most: how many it takes, None for any number.
        span: what names it where the endpoint is created.
        definition: its parameters, where it is defined.
        file: the name of the file in its set, "" for the main file.
        is_result: whether it is called where it was to be handed over, and so gives nothing that
            can be called; the counts say nothing then.
        besides: what rospy is told to hand over besides the message, in the words of the file.
        with_self: how a method begins that is written without `self`, once it has it; "" for all
            else.
    """

    callback: str
    kind: EndpointKind
    given: int
    least: int
    most: int | None
    span: Span
    definition: Span
    file: str = ""
    is_result: bool = False
    besides: str = ""
    with_self: str = ""


class Repeated(NamedTuple):
    """An endpoint that is created again each time that something is called.

    Attributes:
        kind: its kind.
        callback: the function that is called again and again; "" for a loop that goes on for ever.
        span: the call that creates it.
        file: the name of the file in its set, "" for the main file.
    """

    kind: EndpointKind
    callback: str
    span: Span
    file: str = ""


class Dropped(NamedTuple):
    """An endpoint, or a callback of parameters, whose handle nobody keeps, and which ends with it.

    Attributes:
        kind: the kind of the endpoint, None for a callback of parameters.
        span: the call.
        file: the name of the file in its set, "" for the main file.
    """

    kind: EndpointKind | None
    span: Span
    file: str = ""


class EarlyPublish(NamedTuple):
    """A message that is published once, right after its publisher is created: nobody hears it."""

    span: Span
    created: Span
    file: str = ""


class ParameterAccess(Enum):
    """What a call does with a parameter of its own node."""

    DECLARE = "declare"
    GET = "get"
    READ = "put into a variable, where it is there"
    GET_OR = "get, or take another value"
    SET = "set"
    HAS = "ask whether it is there"


class ParameterUse(NamedTuple):
    """A call about a parameter.

    Attributes:
        access: what it does.
        name: the parameter's name, None where that is not known.
        span: what names it.
        file: the name of the file in its set, "" for the main file.
        type: the type that a declaration gives it for sure, as `ParameterDetails.type`.
        is_guarded: whether the code goes on where there is no such parameter.
    """

    access: ParameterAccess
    name: str | None
    span: Span
    file: str = ""
    type: str | None = None
    is_guarded: bool = False


class ParameterFacts(NamedTuple):
    """The parameters of a node.

    Attributes:
        uses: the calls about them.
        is_whole: whether all that the node declares is among them.
        is_own: whether all is among them but for what well-known libraries declare by themselves.
        takes_options: whether who makes the node may let it have parameters that it does not
            declare.
        is_elsewhere: whether the files make the node alone, and others define its class.
        is_rest_whole: whether all else that the node declares is among the uses then.
    """

    uses: tuple[ParameterUse, ...] = ()
    is_whole: bool = False
    is_own: bool = False
    takes_options: bool = False
    is_elsewhere: bool = False
    is_rest_whole: bool = False


class CodeFacts(NamedTuple):
    """All of it, of the files of a unit.

    Attributes:
        is_closed: whether all that creates endpoints of the nodes is read with the files: no node
            is handed to code that is not, and no class of one has a base that is not.
        fields: fields that are used.
        values: values that fields get.
        built: messages that are constructed.
        sent: messages that are published.
        blocking: calls that wait in callbacks.
        arities: callbacks that cannot be called.
        repeated: endpoints that are created again and again.
        dropped: endpoints whose handle nobody keeps.
        early: messages that are published too early.
        no_queue: publishers of rospy without a `queue_size`, endpoints of rclpy without a profile.
        idle: where a program that has callbacks ends, or goes on, without ever calling them; None
            where it spins, or that is not sure.
        parameters: the parameters of each of the nodes, in their order; none where not known.
        allows_undeclared: whether some node that the code makes may have parameters that it does
            not declare.
    """

    is_closed: bool = False
    fields: tuple[FieldUse, ...] = ()
    values: tuple[FieldValue, ...] = ()
    built: tuple[Built, ...] = ()
    sent: tuple[Sent, ...] = ()
    blocking: tuple[Blocking, ...] = ()
    arities: tuple[Arity, ...] = ()
    repeated: tuple[Repeated, ...] = ()
    dropped: tuple[Dropped, ...] = ()
    early: tuple[EarlyPublish, ...] = ()
    no_queue: tuple[tuple[str, Span], ...] = ()
    idle: Span | None = None
    parameters: tuple[ParameterFacts, ...] = ()
    allows_undeclared: bool = False
