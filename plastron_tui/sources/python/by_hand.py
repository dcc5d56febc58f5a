"""What no edit writes into somebody's file, and what to write there by hand instead."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from plastron_tui.diagnostics import codes
from plastron_tui.model.kinds import (
    ActionClient,
    ActionServer,
    Client,
    Endpoint,
    Service,
)

from .messages import CannotAddError


class _Reason(NamedTuple):
    message: str
    remedy: str


def refuse_by_hand(endpoint: Endpoint) -> None:
    """Refuse to write what would be a heap of code in a file that somebody else keeps.

    Raises:
        CannotAddError: it is to be written by hand; the help says what.
    """
    reason = next(_reasons(endpoint), None)
    if reason is not None:
        raise CannotAddError(codes.EDIT_REFUSED, reason.message, endpoint.span, reason.remedy)


def _reasons(endpoint: Endpoint) -> Iterator[_Reason]:
    name = endpoint.name
    match endpoint:
        case Client(requests=requests) if any(each.rate is not None for each in requests):
            yield _Reason(
                f"calls of `{name}` at a rate are not written into a loaded file",
                f"call `{name}` by hand in a function, and let the node repeat that: "
                "`NODE repeats FUNCTION at RATE hz`",
            )
        case ActionServer():
            yield _Reason(
                f"the server of the action `{name}` is not written into a loaded file",
                "create an action server by hand, with a function that works on its goals; "
                "or let a node of its own provide the action: `create_node`",
            )
        case ActionClient():
            yield _Reason(
                f"goals for `{name}` are not written into a loaded file",
                "create an action client by hand, wait for its server and send the goal; "
                "or let a node of its own send it: `create_node`",
            )


def refuse_answer(endpoint: Endpoint) -> None:
    """Refuse to write an answer into a function that the file has.

    Raises:
        CannotAddError: the function is to be changed by hand.
    """
    if isinstance(endpoint, Service) and endpoint.answer is not None:
        message = f"the answer of `{endpoint.name}` is not written into a function that is there"
        remedy = "leave out `answering`, and fill in the response by hand in its function"
        raise CannotAddError(codes.EDIT_REFUSED, message, endpoint.span, remedy)
