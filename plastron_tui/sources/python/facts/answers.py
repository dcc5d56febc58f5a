"""What clients of services and actions get: at once, by futures, and by the handles of goals.

Sources: `rclpy.client`, `rclpy.action.client` of Jazzy; `rospy.impl.tcpros_service` and `actionlib`
of Noetic.
"""

from __future__ import annotations

from typing import NamedTuple

from plastron_tui.model.code_facts import Part
from plastron_tui.model.kinds import EndpointKind

_RESPONSE = "the future of a response"
_GOAL = "the future of a handle"
_HANDLE = "the handle of a goal"
_RESULT = "the future of a result"


class Answer(NamedTuple):
    """What a call of a client gives.

    Attributes:
        kind: the kind of the client.
        part: the message that comes of it.
        behind: what has the message, "" for the message itself (`Held.behind`).
    """

    kind: EndpointKind
    part: Part
    behind: str = ""


ASKED = {
    (1, "call"): Answer(EndpointKind.CLIENT, Part.RESPONSE),
    (1, "get_result"): Answer(EndpointKind.ACTION_CLIENT, Part.RESULT),
    (2, "call"): Answer(EndpointKind.CLIENT, Part.RESPONSE),
    (2, "call_async"): Answer(EndpointKind.CLIENT, Part.RESPONSE, _RESPONSE),
    (2, "send_goal_async"): Answer(EndpointKind.ACTION_CLIENT, Part.RESULT, _GOAL),
}
"""The methods of clients, by generation of ROS and name."""

THEN = {
    (_RESPONSE, "result"): "",
    (_GOAL, "result"): _HANDLE,
    (_HANDLE, "get_result_async"): _RESULT,
    # What comes then has the result in its field `result`.
    (_RESULT, "result"): "result",
}
"""What methods of futures and handles give, by what the message is behind before."""
