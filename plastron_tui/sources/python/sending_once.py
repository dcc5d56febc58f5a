"""Publishing a message once from a file, also to those who listen later.

rospy latches it. rclpy keeps it for subscriptions that ask for that, and waits for a first one: a
subscription that is volatile would miss what is sent before it is there.
"""

from __future__ import annotations

from collections.abc import Sequence

from plastron_tui.diagnostics import codes

from .addition import Addition
from .analysis import Site
from .messages import CannotAddError

PERIOD = "0.2"
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


def when_heard(added: Addition, heard: str, timer: str, sends: Sequence[str]) -> list[str]:
    """Write what a timer does so that something is sent once somebody listens.

    Args:
        added: the publisher.
        heard: the variable that says whether somebody listened the last time.
        timer: the variable that holds the timer.
        sends: what sends.
    """
    declared = []
    if "." not in heard:
        # The function is one of the module, or stands in the one that creates the publisher.
        declared = [f"{'global' if added.place.scope.parent is None else 'nonlocal'} {heard}"]
    return [
        *declared,
        f"was_heard = {heard}",
        f"{heard} = {added.variable}.get_subscription_count() > 0",
        f"if was_heard and {heard}:",
        "\t# A subscription that is there for so long knows this publisher too.",
        f"\t{timer}.cancel()",
        *(f"\t{line}" for line in sends),
    ]
