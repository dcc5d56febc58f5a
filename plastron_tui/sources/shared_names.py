"""A warning of names that several objects of a class would share, in whatever language."""

from __future__ import annotations

from plastron_tui.diagnostics import Diagnostic, codes
from plastron_tui.model.kinds import Endpoint


def shares_name(owner: str, endpoint: Endpoint, telling: str) -> Diagnostic:
    """Return the warning that each object of a class creates an endpoint of one name.

    Args:
        owner: the class.
        endpoint: the endpoint.
        telling: what gives the objects names of their own.
    """
    message = f"each object of `{owner}` creates `{endpoint.name}`, while {telling} gives each"
    message += " a name of its own"
    help_ = "add it to what makes the objects, if there are several"
    return Diagnostic(codes.SHARED_NAME, message, endpoint.span, help=help_)
