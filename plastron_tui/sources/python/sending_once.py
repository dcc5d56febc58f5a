"""Publishing a message once from a file, also to those who listen later.

rospy latches it. rclpy keeps it for subscriptions that ask for that, and waits for a first one: a
subscription that is volatile would miss what is sent before it is there.
"""

from __future__ import annotations

from collections.abc import Sequence

from plastron_tui.diagnostics import codes
from plastron_tui.model.source import EndpointKind

from .addition import Addition
from .analysis import Site
from .conventions import method_naming, variable_naming
from .function_place import method_place
from .messages import CannotAddError
from .signatures import signatures_of
from .writing import Key

_PERIOD = "0.2"
"""How often rclpy looks whether somebody listens, in seconds."""


def check_kept(added: Addition, site: Site) -> None:
    """Refuse to send once through a publisher that keeps nothing for those who listen later.

    Raises:
        CannotAddError: it is to be changed by hand.
    """
    if site.endpoint.qos is not None and site.endpoint.qos.durability == "transient_local":
        return
    what = "transient_local" if added.is_rclpy else "latch=True"
    message = f"the publisher of `{added.name}` in line {site.endpoint.line} keeps no message for"
    raise CannotAddError(
        codes.EDIT_REFUSED,
        f"{message} those who listen later",
        added.endpoint.span,
        f"make it `{what}` by hand, or let the node stop publishing to `{added.name}` first",
    )


def send_when_heard(added: Addition, sending: Sequence[str]) -> list[str]:
    """Write the method that sends once somebody listens; return the lines that start it.

    Raises:
        CannotAddError: there is no class for the method.
    """
    holder, dot, _ = added.variable.rpartition(".")
    if not added.is_method_place or not dot or added.place.owner is None:
        raise CannotAddError(
            codes.EDIT_REFUSED,
            f"what is sent once to `{added.name}` is only written into a class that is a node",
            added.endpoint.span,
            "publish it by hand once somebody listens: `get_subscription_count()` tells",
        )
    method = added.free_name(method_naming(added.analysis, "publish").name(added.name))
    timer = added.free_name(variable_naming(added.analysis, EndpointKind.TIMER).name(added.name))
    heard = added.free_name(f"{timer.removesuffix('_timer').removesuffix('_')}_is_heard")
    self_name = added.place.self_name
    manner = signatures_of(added.analysis, EndpointKind.TIMER)
    lines = [
        manner.head(method, [(self_name, "")], "None"),
        f'\t"""Publish to {added.label}, once: when somebody listens."""',
        f"\twas_heard = {self_name}.{heard}",
        f"\t{self_name}.{heard} = {added.variable}.get_subscription_count() > 0",
        f"\tif was_heard and {self_name}.{heard}:",
        "\t\t# A subscription that is there for so long knows this publisher too.",
        f"\t\t{self_name}.{timer}.cancel()",
        *(f"\t\t{line}" for line in sending),
    ]
    added.writer.function(method_place(added.analysis, added.place, ()), lines)
    key: Key = (EndpointKind.TIMER, _PERIOD, "None", method)
    added.writer.endpoints.append(key)
    call = f"{added.place.receiver}.create_timer({_PERIOD}, {self_name}.{method})"
    return [f"{holder}.{heard} = False", f"{holder}.{timer} = {call}"]
