"""What no edit writes into somebody's file, and what to write there by hand instead."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from plastron_tui.diagnostics import codes
from plastron_tui.model.kinds import (
    ActionClient,
    Client,
    Endpoint,
    Publisher,
    Service,
    Timer,
)
from plastron_tui.model.values import OfReceived, Value, computed_in

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
        case Publisher(publications=publications):
            for each in publications:
                if each.reaction is not None:
                    heard = each.reaction.topic
                    yield _Reason(
                        f"what is sent to `{name}` for each message of `{heard}` is not written "
                        "into a loaded file",
                        f"publish to `{name}` by hand in the function that hears `{heard}`",
                    )
                if each.parameter is not None:
                    yield _parameter_rate(f"the rate of `{name}`", each.parameter)
                if _is_received(each.message.value):
                    yield _Reason(
                        f"what is sent to `{name}` is computed from a message that is received, "
                        "which is not written into a loaded file",
                        "publish it by hand in the function that hears the message",
                    )
        case Client(requests=requests):
            for sent in requests:
                if sent.rate is not None and sent.rate.parameter is not None:
                    yield _parameter_rate(f"the rate of calls of `{name}`", sent.rate.parameter)
        case ActionClient(goals=goals) if len(goals) > 1:
            yield _Reason(
                f"of the goals for `{name}` no more than one is written into a loaded file",
                "send the others by hand, each when the one before is done; "
                "or let a node of its own send them: `create_node`",
            )
        case Timer(rate=rate) if rate is not None and rate.parameter is not None:
            yield _parameter_rate(f"the rate of `{name}`", rate.parameter)


def refuse_answer(endpoint: Endpoint) -> None:
    """Refuse to write an answer into a function that the file has.

    Raises:
        CannotAddError: the function is to be changed by hand.
    """
    if isinstance(endpoint, Service) and endpoint.answer is not None:
        message = f"the answer of `{endpoint.name}` is not written into a function that is there"
        remedy = "leave out `answering`, and fill in the response by hand in its function"
        raise CannotAddError(codes.EDIT_REFUSED, message, endpoint.span, remedy)


def _parameter_rate(what: str, parameter: str) -> _Reason:
    bare = parameter.removeprefix("~/")
    return _Reason(
        f"{what} is that of the parameter `{bare}`, which is not written into a loaded file",
        f"write the rate as a number, or let a timer follow `{bare}` by hand",
    )


def _is_received(value: Value) -> bool:
    return any(isinstance(each.source, OfReceived) for each in computed_in(value))
