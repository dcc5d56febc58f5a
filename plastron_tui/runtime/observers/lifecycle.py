"""Configures and activates managed nodes of ROS 2, as soon as each is there.

Prints a line of JSON for each node when it is active, or cannot be:
`{"node": "/talker", "passed": ["configure", "activate"], "error": null}`, with the transitions that
it was asked for and passed, and the error null where all is well. A node that is further already is
only brought the rest of the way. Arguments: the most seconds that it may take, and the nodes' full
names.

States, transitions and services: https://design.ros2.org/articles/node_lifecycle.html
"""

from __future__ import annotations

import json
import sys
import time
from typing import Any

import rclpy
from lifecycle_msgs.msg import Transition
from lifecycle_msgs.srv import ChangeState, GetState
from rclpy.signals import SignalHandlerOptions

_NEXT = {
    "unconfigured": ("configure", Transition.TRANSITION_CONFIGURE),
    "inactive": ("activate", Transition.TRANSITION_ACTIVATE),
}
# Seconds after which the state is asked for again: a node that configures itself takes its time.
_LOST = 3.0
_OWN_NAME = "_plastron_lifecycle"


class _Managed:
    """A node that is brought up: its state is asked for, then changed, until it is active."""

    def __init__(self, node: Any, name: str) -> None:
        self.name = name
        self.passed: list[str] = []
        self._get = node.create_client(GetState, f"{name}/get_state")
        self._change = node.create_client(ChangeState, f"{name}/change_state")
        self._answer: Any = None
        self._asked = 0.0
        self._transition = ""

    def look(self) -> str | None:
        """Go on as far as it goes now; return nothing yet, `active`, or what is wrong."""
        if self._answer is not None and self._answer.done():
            return self._go_on(self._answer.result())
        # An answer is lost where the node does not know the client yet.
        if self._answer is None or time.monotonic() - self._asked > _LOST:
            self._ask_state()
        return None

    def _go_on(self, answer: Any) -> str | None:
        self._answer = None
        if isinstance(answer, ChangeState.Response):
            if not answer.success:
                return f"it did not {self._transition}"
            self.passed.append(self._transition)
            return None
        label = str(answer.current_state.label)
        if label in _NEXT:
            self._transition, number = _NEXT[label]
            request = ChangeState.Request(transition=Transition(id=number))
            self._answer = self._change.call_async(request)
            self._asked = time.monotonic()
            return None
        if label == "finalized":
            return "it is finalized"
        return label if label == "active" else None

    def _ask_state(self) -> None:
        if self._get.service_is_ready() and self._change.service_is_ready():
            self._answer = self._get.call_async(GetState.Request())
            self._asked = time.monotonic()


def main() -> None:
    """Bring all nodes up, or those that come in time."""
    limit, names = float(sys.argv[1]), sys.argv[2:]
    rclpy.init(signal_handler_options=SignalHandlerOptions.NO)
    node = rclpy.create_node(_OWN_NAME, enable_rosout=False, start_parameter_services=False)
    waiting = [_Managed(node, name) for name in names]
    end = time.monotonic() + limit
    while waiting:
        is_late = time.monotonic() > end
        for managed in list(waiting):
            found = managed.look() or ("it does not answer" if is_late else None)
            if found is not None:
                waiting.remove(managed)
                error = None if found == "active" else found
                told = {"node": managed.name, "passed": managed.passed, "error": error}
                print(json.dumps(told), flush=True)
        rclpy.spin_once(node, timeout_sec=0.1)
    node.destroy_node()
    rclpy.shutdown()


if __name__ == "__main__":
    try:
        main()
    except KeyboardInterrupt:
        sys.exit(130)
