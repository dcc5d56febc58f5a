"""What no edit writes into somebody's file, and what to write there by hand instead."""

from __future__ import annotations

from plastron_tui.diagnostics import codes
from plastron_tui.model.kinds import ActionClient, Endpoint, Service

from .messages import CannotAddError


def refuse_by_hand(endpoint: Endpoint) -> None:
    """Refuse to write what would be a heap of code in a file that somebody else keeps.

    Raises:
        CannotAddError: it is to be written by hand; the help says what.
    """
    if isinstance(endpoint, ActionClient) and len(endpoint.goals) > 1:
        message = (
            f"of the goals for `{endpoint.name}` no more than one is written into a loaded file"
        )
        remedy = "send the others by hand, each when the one before is done; "
        remedy += "or let a node of its own send them: `create_node`"
        raise CannotAddError(codes.EDIT_REFUSED, message, endpoint.span, remedy)


def refuse_answer(endpoint: Endpoint) -> None:
    """Refuse to write an answer into a function that the file has.

    Raises:
        CannotAddError: the function is to be changed by hand.
    """
    if isinstance(endpoint, Service) and endpoint.answer is not None:
        message = f"the answer of `{endpoint.name}` is not written into a function that is there"
        remedy = "leave out `answering`, and fill in the response by hand in its function"
        raise CannotAddError(codes.EDIT_REFUSED, message, endpoint.span, remedy)
