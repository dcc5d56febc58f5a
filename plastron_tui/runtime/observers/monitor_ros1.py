"""The studio's monitor of nodes of ROS 1 (see `monitor_pipes.py` for how the two speak).

It asks the master every second for topics, services and nodes, and subscribes to no topic but those
that the studio looks at. Only the last message of a turn is made readable.
"""

from __future__ import annotations

import contextlib
import threading
import time
from collections.abc import Callable
from typing import Any

import rosgraph
import roslib.message
import rospy
import rosservice
from goals_ros1 import ActionClients, action_types, is_part
from message_filling import fill, has_stamp
from message_summary import summary_of
from monitor_goals import Goals
from monitor_pipes import Orders, answer, is_now, send, sent_words
from monitor_sending import Sendings
from monitor_services import ServiceTypes, within
from monitor_subscriptions import NotInstalledError, Subscriptions
from monitor_topics import WatchedTopic
from plastron_text import line_of
from ros1_parameters import rows_of
from watch import is_shown

_TURN = 0.25
_LOOK = 1.0
_PARAMETERS = 2.0
_MATCHING = 1.5
_NAME = "plastron_monitor"
_HIDDEN_NODES = ("/rosout", "/plastron_monitor_", "/plastron_watch_")
_HIDDEN_SERVICES = ("/get_loggers", "/set_logger_level")
_TIMEOUT = 5.0
_ANSWER = 10.0


class _Watching:
    """A subscription to the bytes of a topic's messages."""

    def __init__(self, name: str, type_name: str) -> None:
        made = roslib.message.get_message_class(type_name)
        if made is None:
            raise NotInstalledError(type_name)
        self.topic = WatchedTopic(type_name, lambda raw: made().deserialize(raw))
        self._subscriber = rospy.Subscriber(
            name, rospy.AnyMsg, lambda message: self.topic.see(message._buff)
        )

    def take(self) -> None:
        """Do nothing: rospy brings the messages."""

    def look(self) -> None:
        """Do nothing: rospy follows the publishers."""

    def close(self) -> None:
        """Hear no more of it."""
        self._subscriber.unregister()


class _Monitor:
    """What the studio has asked for, and what is there."""

    def __init__(self) -> None:
        self._master = rosgraph.Master(rospy.get_name())
        self._topics = Subscriptions(_Watching)
        self._nodes: list[str] = []
        self._service_types = ServiceTypes(_service_type)
        self._sendings = Sendings()
        self._goals, self._action_clients = Goals(), ActionClients()
        self._publishers: dict[str, Any] = {}
        self._graph: dict[str, Any] = {}
        self._told: dict[str, Any] = {}
        self._looked = self._asked = 0.0

    def do(self, order: dict[str, Any]) -> None:
        """Do what the studio wants; what may take its time has a thread of its own."""
        try:
            if order["do"] == "watch":
                self._nodes = order["nodes"]
                self._told = {k: v for k, v in self._told.items() if k in self._nodes}
                self._topics.watch(order["topics"], order["full"])
            elif order["do"] == "publish" and order.get("rate"):
                self._send(order)
            elif order["do"] == "stop":
                self._sendings.stop(order["name"])
            elif order["do"] == "goal":
                self._action_clients.send(order, self._goals)
            elif order["do"] == "cancel":
                self._goals.cancel(order["goal"])
            elif order["do"] == "publish":
                self._aside(self._publish, order)
            elif order["do"] == "call":
                self._aside(self._call, order)
            elif order["do"] == "set":
                rospy.set_param(f"{order['node']}/{order['name']}", order["value"])
                self._asked = 0.0
                said = is_now(order["name"], order["value"])
                answer(order, f"{said}; a node of ROS 1 sees it when it reads it again")
        except Exception as error:  # a type that is not installed, a master that is gone, …
            answer(order, str(error) or type(error).__name__, is_failure=True)

    def _aside(self, work: Callable[[dict[str, Any]], None], order: dict[str, Any]) -> None:
        def run() -> None:
            try:
                work(order)
            except Exception as error:  # whatever a foreign node answers
                answer(order, str(error) or type(error).__name__, is_failure=True)

        threading.Thread(target=run, daemon=True).start()

    def close(self) -> None:
        """Send nothing any more, because the studio is gone."""
        self._sendings.close()

    def turn(self) -> None:
        """Tell what is new."""
        now = time.monotonic()
        if now - self._looked >= _LOOK:
            self._looked = now
            try:
                self._look()
            except Exception as error:  # the master is gone, or says what it should not
                send(tell="problem", text=str(error) or type(error).__name__)
                # Told again as soon as there is one, it says that there is no problem any more.
                self._graph = {}
            send(tell="beat")
        self._topics.report()
        self._sendings.turn()
        self._goals.turn()
        self._goals.report()
        if self._nodes and now - self._asked >= _PARAMETERS:
            self._asked = now
            self._tell_parameters()

    def _look(self) -> None:
        graph = self._found()
        self._topics.look()
        if graph != self._graph:
            self._graph = graph
            send(tell="graph", **graph)

    def _found(self) -> dict[str, Any]:
        publishers, subscribers, services = self._master.getSystemState()
        found = self._master.getTopicTypes()
        types = self._topics.types = {name: kind for name, kind in found if kind != "*"}
        counts: dict[str, list[int]] = {}
        nobody = [0, 0]
        for side, known in enumerate((publishers, subscribers)):
            for name, owners in known:
                count = sum(not _is_hidden(owner) for owner in owners)
                counts.setdefault(name, [0, 0])[side] += count
        at: dict[str, set[str]] = {}
        for name, owners in (*publishers, *subscribers):
            at.setdefault(name, set()).update(owners)
        ends: dict[str, list[tuple[bool, str, str]]] = {}
        for sends, side in ((True, publishers), (False, subscribers)):
            for name, owners in side:
                shown = sorted(owner for owner in owners if not _is_hidden(owner))
                ends.setdefault(name, []).extend((sends, owner, "") for owner in shown)
        # An action is one thing, and not the five topics that it consists of.
        actions = action_types(types)
        topics = [
            (name, types.get(name, ""), *count, sorted(at[name]), ends.get(name, []))
            for name, count in sorted(counts.items())
            if is_shown(name) and any(count) and not is_part(name, actions)
        ]
        offered = {name: own for name, own in services if self._is_offered(name, own)}
        nodes = {owner for kind in (publishers, subscribers, services) for _, own in kind
                 for owner in own if not _is_hidden(owner)}  # fmt: skip
        return {
            "topics": topics,
            "services": [
                (name, self._service_types.of(name), own) for name, own in sorted(offered.items())
            ],
            "actions": [
                (name, type_, counts.get(f"{name}/status", nobody)[0], sorted(at[f"{name}/goal"]))
                for name, type_ in sorted(actions.items())
                # The master knows the types of what is gone as well.
                if any(counts.get(f"{name}/goal", nobody))
            ],
            "nodes": sorted(nodes),
        }

    def _is_offered(self, name: str, owners: list[str]) -> bool:
        return not name.endswith(_HIDDEN_SERVICES) and not all(map(_is_hidden, owners))

    def _send(self, order: dict[str, Any]) -> None:
        """Send a message at a rate."""
        publisher, message = self._prepared(order)

        def publish() -> None:
            _stamp(message, order["values"])
            publisher.publish(message)

        self._sendings.start(order, publish, lambda: None, summary_of(message, order["type"]).text)

    def _prepared(self, order: dict[str, Any]) -> tuple[Any, Any]:
        """Return the publisher of a topic, and a message."""
        name, made = order["name"], roslib.message.get_message_class(order["type"])
        if made is None:
            raise NotInstalledError(order["type"])
        message = fill(made(), order["values"])
        if name not in self._publishers:
            self._publishers[name] = rospy.Publisher(name, made, queue_size=10)
        return self._publishers[name], message

    def _publish(self, order: dict[str, Any]) -> None:
        name = order["name"]
        publisher, message = self._prepared(order)
        end = time.monotonic() + _MATCHING
        # Who listens connects to a new publisher some time after it is there.
        subscribed = dict(self._master.getSystemState()[1])
        listening = len(subscribed.get(name, ()))
        while publisher.get_num_connections() < listening and time.monotonic() < end:
            time.sleep(0.02)
        _stamp(message, order["values"])
        publisher.publish(message)
        others = sum(not _is_hidden(owner) for owner in subscribed.get(name, ()))
        answer(order, sent_words(name, others, others))

    def _call(self, order: dict[str, Any]) -> None:
        made = roslib.message.get_service_class(order["type"])
        if made is None:
            raise NotInstalledError(order["type"])
        request = fill(made._request_class(), order["values"])
        rospy.wait_for_service(order["name"], timeout=_TIMEOUT)
        proxy = rospy.ServiceProxy(order["name"], made)
        text = within(_ANSWER, lambda: line_of(proxy(request)) or "done")
        answer(order, text or "no answer came", is_failure=text is None)

    def _tell_parameters(self) -> None:
        try:
            tree = rospy.get_param("/")
        except (KeyError, OSError):
            return
        for node in self._nodes:
            found = tree
            for part in node.strip("/").split("/"):
                found = found.get(part, {}) if isinstance(found, dict) else {}
            rows = list(rows_of(found)) if isinstance(found, dict) else []
            if self._told.get(node) != rows:
                self._told[node] = rows
                send(tell="parameters", node=node, rows=rows)


def _stamp(message: Any, values: dict[str, Any]) -> None:
    if has_stamp(message, values):
        message.header.stamp = rospy.Time.now()


def _service_type(name: str) -> str:
    return rosservice.get_service_type(name) or ""


def _is_hidden(node: str) -> bool:
    return node.startswith(_HIDDEN_NODES)


def main() -> None:
    """Watch until the studio has enough."""
    # First of all: who started this may be gone before the master has answered.
    orders = Orders()
    rospy.init_node(_NAME, anonymous=True, disable_signals=True, disable_rosout=True)
    monitor = _Monitor()
    try:
        while True:
            monitor.turn()
            for order in orders.take(_TURN):
                if order.get("do") == "leave":
                    return
                monitor.do(order)
    finally:
        monitor.close()
        # The master forgets what it knows of this node.
        rospy.signal_shutdown("the studio has enough")


if __name__ == "__main__":
    with contextlib.suppress(KeyboardInterrupt):
        main()
