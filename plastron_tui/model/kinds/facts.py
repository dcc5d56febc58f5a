"""What is declared of a kind of endpoint, once, for all that handle endpoints."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import TYPE_CHECKING, Any, NamedTuple

from plastron_tui.diagnostics import Code
from plastron_tui.language import DECLARATIONS, Declaration, SlotKind, Statement
from plastron_tui.ros.interfaces import InterfaceKind
from plastron_tui.ros.names import NameProblem, check_topic_name

if TYPE_CHECKING:
    from plastron_tui.model.run import Run


INTERFACES = {
    SlotKind.MESSAGE_TYPE: InterfaceKind.MESSAGE,
    SlotKind.SERVICE_TYPE: InterfaceKind.SERVICE,
    SlotKind.ACTION_TYPE: InterfaceKind.ACTION,
}
"""The slots that name a type, and the kind of interface that it is of."""


NAMES = frozenset(
    {SlotKind.TOPIC, SlotKind.SERVICE, SlotKind.ACTION, SlotKind.PARAMETER, SlotKind.TIMER}
)
"""The slots that have the name of an endpoint."""


class Facts(NamedTuple):
    """What holds for every endpoint of a kind.

    Attributes:
        verb: what a node does with one, before its name: `publishes to`.
        named: what its name is the name of: `topic`, `service`, `action`, `name`; None where
            the kind has no names.
        interface: the kind of interface that types it, None for what has no type.
        role: what a node is called that has one: `publisher`.
        does: what it does, alone: `publishes`.
        sends: whether the node begins: it publishes, or it calls.
        check_name: says what is wrong with a name of the kind, for a generation of ROS.
        calls_back: whether it has a function of the node called.
        sign: the character that stands for one in a list.
        tone: the name of the sign's colour (`studio.tcss`).
        editing: how statements make one and end one, None where none do.
    """

    verb: str
    named: str | None
    interface: InterfaceKind | None
    role: str = ""
    does: str = ""
    check_name: Callable[[str, int], NameProblem | None] = check_topic_name
    sends: bool = False
    calls_back: bool = False
    sign: str = "·"
    tone: str = "dim"
    editing: Editing | None = None


class Editing(NamedTuple):
    """How statements make endpoints of a kind, and end them.

    Attributes:
        endpoint: the class of the endpoints; its first two fields are `name` and `type`.
        made_by: the statement that makes one.
        make: interprets that statement.
        ended_by: the statement that ends one.
        not_there: the code of ending one that is not there.
        infinitive: what the node does not do then, before the name: `publish to`.
        already: the code of making one that is there already; None where one may be said again.
        indicative: what the node does already then, before the name: `subscribes to`.
    """

    endpoint: type[Any]
    made_by: type[Statement]
    make: Callable[[Run, Any], None]
    ended_by: type[Statement]
    not_there: Code
    infinitive: str
    already: Code | None = None
    indicative: str = ""

    @property
    def name_slot(self) -> str:
        """The slot of both statements that has the endpoint's name."""
        ended_by: Any = self.ended_by  # which mypy takes for not hashable
        return _name_slot(ended_by)

    @property
    def making(self) -> Declaration:
        """The declaration of the statement that makes one."""
        return DECLARATIONS[self.made_by]

    @property
    def ending(self) -> Declaration:
        """The declaration of the statement that ends one."""
        return DECLARATIONS[self.ended_by]


@cache
def _name_slot(statement: type[Statement]) -> str:
    return next(slot.name for slot in DECLARATIONS[statement].slots if slot.kind in NAMES)
