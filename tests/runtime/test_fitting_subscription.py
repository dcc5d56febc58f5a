"""What a subscription asks for as publishers come and go."""

from __future__ import annotations

import sys
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

import plastron_tui.runtime.observers as observers

LEAST = ("best effort", "volatile")
PLAIN = ("reliable", "volatile")
KEPT = ("reliable", "kept")


class Node:
    """A node that knows the publishers of one topic, and keeps the subscriptions made."""

    def __init__(self) -> None:
        self.offers: list[tuple[str, str]] = []
        self.own: list[tuple[str, str]] = []
        self.asked: list[tuple[str, str]] = []

    def get_publishers_info_by_topic(self, name: str) -> list[Any]:
        names = {"robot": self.offers, "_plastron_monitor": self.own}
        return [
            SimpleNamespace(
                node_name=node, qos_profile=SimpleNamespace(reliability=a, durability=b)
            )
            for node, offers in names.items()
            for a, b in offers
        ]

    def create_subscription(self, *about: Any, raw: bool) -> Any:
        qos = about[-1]
        self.asked.append((qos.reliability, qos.durability))
        return SimpleNamespace(qos_profile=qos)

    def destroy_subscription(self, subscription: Any) -> None:
        pass


@pytest.mark.parametrize(
    ("steps", "asked"),
    [
        # Of nobody nothing is asked that whoever comes may not offer.
        ([[]], [LEAST]),
        ([[], [KEPT]], [LEAST, KEPT]),
        ([[], [LEAST]], [LEAST]),
        # Less is asked for where one more cannot serve it, and not more again.
        ([[KEPT], [KEPT, PLAIN], [KEPT]], [KEPT, PLAIN]),
        ([[PLAIN], [PLAIN, LEAST], [PLAIN]], [PLAIN, LEAST]),
        # Who comes after all have left is asked anew.
        ([[KEPT], [], [PLAIN]], [KEPT, LEAST, PLAIN]),
        ([[PLAIN], [PLAIN]], [PLAIN]),
    ],
)  # fmt: skip
def test_no_publisher_is_asked_for_what_it_cannot_serve(
    monkeypatch: pytest.MonkeyPatch, steps: list[Any], asked: list[tuple[str, str]]
) -> None:
    monkeypatch.syspath_prepend(str(Path(observers.__file__).parent))
    words = SimpleNamespace(RELIABLE="reliable", BEST_EFFORT="best effort",
                            TRANSIENT_LOCAL="kept", VOLATILE="volatile")  # fmt: skip
    qos = SimpleNamespace(
        QoSProfile=SimpleNamespace, ReliabilityPolicy=words, DurabilityPolicy=words
    )
    monkeypatch.setitem(sys.modules, "rclpy", SimpleNamespace())
    monkeypatch.setitem(sys.modules, "rclpy.qos", qos)
    monkeypatch.delitem(sys.modules, "fitting_subscription", raising=False)
    import fitting_subscription

    node = Node()
    # What the studio itself sends is served by whatever is asked.
    node.own = [KEPT]
    node.offers = steps[0]
    fitting = fitting_subscription.FittingSubscription(node, "/a", object, print)
    for node.offers in steps[1:]:
        fitting.look()
    assert node.asked == asked
    monkeypatch.delitem(sys.modules, "fitting_subscription")
