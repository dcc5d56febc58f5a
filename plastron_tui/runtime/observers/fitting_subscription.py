"""A subscription of ROS 2 that every publisher of its topic can serve, whichever come and go.

Where one cannot, its node warns of an "incompatible QoS", and whoever reads that looks for a
mistake in the node that is none.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy

_OWN_NODES = "_plastron"


class FittingSubscription:
    """Follows the publishers of a topic.

    Attributes:
        subscription: what rclpy made; another one after the publishers have changed.
    """

    def __init__(
        self, node: Any, name: str, message_class: Any, on_message: Callable[[Any], object]
    ) -> None:
        """Subscribe to a topic.

        Args:
            node: the node that subscribes.
            name: the topic.
            message_class: the class of its messages.
            on_message: gets the bytes of each message, if somebody spins the node.
        """
        self._node, self._name = node, name
        self._class, self._on_message = message_class, on_message
        offers = self._offers()
        self._is_served = bool(offers)
        self.subscription = self._subscribed(asked_of(offers))

    def look(self) -> None:
        """Ask for no more than publishers offer that came later, and for all the first one does."""
        offers = self._offers()
        had, wanted = self.subscription.qos_profile, asked_of(offers)
        is_less = (
            had.reliability != wanted.reliability == ReliabilityPolicy.BEST_EFFORT
            or had.durability != wanted.durability == DurabilityPolicy.VOLATILE
        )
        is_other = (had.reliability, had.durability) != (wanted.reliability, wanted.durability)
        # Asking those for more who are heard already would bring the last message twice.
        is_first = bool(offers) and not self._is_served
        self._is_served = bool(offers)
        if is_less or (is_first and is_other):
            self.close()
            self.subscription = self._subscribed(wanted)

    def close(self) -> None:
        """Hear no more of it."""
        self._node.destroy_subscription(self.subscription)

    def _offers(self) -> list[Any]:
        """Return what the publishers offer, but for those that send what the studio is told to."""
        infos = self._node.get_publishers_info_by_topic(self._name)
        return [each.qos_profile for each in infos if not each.node_name.startswith(_OWN_NODES)]

    def _subscribed(self, qos: Any) -> Any:
        return self._node.create_subscription(
            self._class, self._name, self._on_message, qos, raw=True
        )


def asked_of(offers: list[Any]) -> Any:
    """Return the most that can be asked of publishers; of nobody the least: any may come."""
    is_reliable = all(each.reliability == ReliabilityPolicy.RELIABLE for each in offers)
    is_kept = all(each.durability == DurabilityPolicy.TRANSIENT_LOCAL for each in offers)
    has_any = bool(offers)
    return QoSProfile(
        depth=100,
        reliability=(
            ReliabilityPolicy.RELIABLE if has_any and is_reliable else ReliabilityPolicy.BEST_EFFORT
        ),
        durability=(
            DurabilityPolicy.TRANSIENT_LOCAL if has_any and is_kept else DurabilityPolicy.VOLATILE
        ),
    )
