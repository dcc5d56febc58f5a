"""The topics that an action of ROS 1 consists of, taken together.

Source: the ROS wiki page "actionlib/DetailedDescription": a client publishes `goal` and `cancel`,
a server publishes `status`, `feedback` and `result`.
"""

from __future__ import annotations

from collections.abc import Mapping

from plastron_tui.model.kinds import EndpointKind
from plastron_tui.ros.interfaces import InterfaceName

Endpoint = tuple[str, InterfaceName | None]
ByKind = Mapping[EndpointKind, tuple[Endpoint, ...]]

_ASKED = ("goal", "cancel")
_TOLD = ("status", "feedback", "result")
_SIDES = {
    EndpointKind.ACTION_SERVER: (_TOLD, _ASKED),
    EndpointKind.ACTION_CLIENT: (_ASKED, _TOLD),
}
"""What each side of an action publishes, and what it subscribes to."""


def with_actions(by_kind: ByKind) -> ByKind:
    """Return a node's endpoints with the actions that its topics are parts of, instead of these."""
    published = dict(by_kind.get(EndpointKind.PUBLISHER, ()))
    heard = dict(by_kind.get(EndpointKind.SUBSCRIPTION, ()))
    actions: dict[EndpointKind, list[Endpoint]] = {kind: [] for kind in _SIDES}
    for kind, (sent, taken) in _SIDES.items():
        for name in sorted({topic.rpartition("/")[0] for topic in published}):
            parts = [f"{name}/{part}" for part in sent], [f"{name}/{part}" for part in taken]
            goal = (heard if kind is EndpointKind.ACTION_SERVER else published).get(f"{name}/goal")
            is_there = published.keys() >= set(parts[0]) and heard.keys() >= set(parts[1])
            if not is_there or goal is None or not goal.name.endswith("ActionGoal"):
                continue
            actions[kind].append((name, goal._replace(name=goal.name.removesuffix("ActionGoal"))))
            for topics, own in zip((published, heard), parts, strict=True):
                for topic in own:
                    del topics[topic]
    found = {
        EndpointKind.PUBLISHER: tuple(published.items()),
        EndpointKind.SUBSCRIPTION: tuple(heard.items()),
        **{kind: (*by_kind.get(kind, ()), *each) for kind, each in actions.items()},
    }
    return {**by_kind, **{kind: each for kind, each in found.items() if each or kind in by_kind}}
