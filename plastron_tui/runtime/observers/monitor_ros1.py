"""The studio's monitor of nodes of ROS 1 (see `monitor_pipes.py` for how the two speak).

It asks the master every second for topics, services and nodes, and subscribes to no topic but those
that the studio looks at. Only the last message of a turn is made readable.
"""

from __future__ import annotations

import contextlib
import threading
import time
from collections.abc import Callable, Iterable
from typing import Any

import rosgraph
import roslib.message
import rospy
import rosservice
from message_filling import fill, has_stamp
from monitor_pipes import Orders, answer, send
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


class _Watching:
    """A subscription to the bytes of a topic's messages."""

    def __init__(self, name: str, type_name: str) -> None:
        made = roslib.message.get_message_class(type_name)
        if made is None:
            raise ImportError(type_name)
        self.topic = WatchedTopic(type_name, lambda raw: made().deserialize(raw))
        self._subscriber = rospy.Subscriber(
            name, rospy.AnyMsg, lambda message: self.topic.see(message._buff)
        )

    def close(self) -> None:
        """Hear no more of it."""
        self._subscriber.unregister()


class _Monitor:
    """What the studio has asked for, and what is there."""

    def __init__(self) -> None:
        self._master = rosgraph.Master(rospy.get_name())
        self._watched: dict[str, _Watching | None] = {}
        self._full: set[str] = set()
        self._nodes: list[str] = []
        self._types: dict[str, str] = {}
        self._service_types: dict[str, str] = {}
        self._publishers: dict[str, Any] = {}
        self._graph: dict[str, Any] = {}
        self._told: dict[str, Any] = {}
        self._looked = self._asked = 0.0

    def do(self, order: dict[str, Any]) -> None:
        """Do what the studio wants; what may take its time has a thread of its own."""
        try:
            if order["do"] == "watch":
                self._full = set(order["full"])
                self._nodes = order["nodes"]
                self._told = {k: v for k, v in self._told.items() if k in self._nodes}
                self._watch(order["topics"])
            elif order["do"] == "publish":
                self._aside(self._publish, order)
            elif order["do"] == "call":
                self._aside(self._call, order)
            elif order["do"] == "set":
                rospy.set_param(f"{order['node']}/{order['name']}", order["value"])
                self._asked = 0.0
                answer(order, "set; a node of ROS 1 sees it when it reads it again")
        except Exception as error:  # a type that is not installed, a master that is gone, …
            answer(order, str(error) or type(error).__name__, is_failure=True)

    def _aside(self, work: Callable[[dict[str, Any]], None], order: dict[str, Any]) -> None:
        def run() -> None:
            try:
                work(order)
            except Exception as error:  # whatever a foreign node answers
                answer(order, str(error) or type(error).__name__, is_failure=True)

        threading.Thread(target=run, daemon=True).start()

    def turn(self) -> None:
        """Tell what is new."""
        now = time.monotonic()
        if now - self._looked >= _LOOK:
            self._looked = now
            try:
                self._look()
            except Exception as error:  # the master is gone, or says what it should not
                send(tell="problem", text=str(error))
            send(tell="beat")
        reports = {
            name: watching.topic.report() for name, watching in self._watched.items() if watching
        }
        rows = {name: report for name, report in reports.items() if report is not None}
        if rows:
            send(tell="topics", rows=rows)
        if self._nodes and now - self._asked >= _PARAMETERS:
            self._asked = now
            self._tell_parameters()

    def _look(self) -> None:
        graph = self._found()
        for name, watching in self._watched.items():
            if watching is None and name in self._types:
                self._subscribe(name)
        if graph != self._graph:
            self._graph = graph
            send(tell="graph", **graph)

    def _found(self) -> dict[str, Any]:
        publishers, subscribers, services = self._master.getSystemState()
        self._types = {name: kind for name, kind in self._master.getTopicTypes() if kind != "*"}
        counts: dict[str, list[int]] = {}
        for side, found in enumerate((publishers, subscribers)):
            for name, owners in found:
                count = sum(not _is_hidden(owner) for owner in owners)
                counts.setdefault(name, [0, 0])[side] += count
        topics = [
            (name, self._types.get(name, ""), *count)
            for name, count in sorted(counts.items())
            if is_shown(name) and any(count)
        ]
        shown = [name for name, owners in services if self._is_offered(name, owners)]
        nodes = {owner for kind in (publishers, subscribers, services) for _, own in kind
                 for owner in own if not _is_hidden(owner)}  # fmt: skip
        return {
            "topics": topics,
            "services": [(name, self._service_type(name)) for name in sorted(shown)],
            "nodes": sorted(nodes),
        }

    def _is_offered(self, name: str, owners: list[str]) -> bool:
        return not name.endswith(_HIDDEN_SERVICES) and not all(map(_is_hidden, owners))

    def _service_type(self, name: str) -> str:
        known = self._service_types.get(name)
        if known is None:
            try:
                known = rosservice.get_service_type(name) or ""
            except rosservice.ROSServiceIOException:
                return ""
            self._service_types[name] = known
        return known

    def _watch(self, names: Iterable[str]) -> None:
        wanted = set(names)
        for name in set(self._watched) - wanted:
            watching = self._watched.pop(name)
            if watching is not None:
                watching.close()
        for name in sorted(wanted - set(self._watched)):
            self._watched[name] = None
            if name in self._types:
                self._subscribe(name)
        for name, watching in self._watched.items():
            if watching is not None:
                watching.topic.is_full = name in self._full

    def _subscribe(self, name: str) -> None:
        try:
            watching = _Watching(name, self._types[name])
        except (ImportError, ValueError):
            text = f"{self._types[name]} is not installed here"
            send(tell="topics", rows={name: {"count": 0, "rate": 0, "text": text, "number": None}})
            return
        watching.topic.is_full = name in self._full
        self._watched[name] = watching

    def _publish(self, order: dict[str, Any]) -> None:
        name = order["name"]
        made = roslib.message.get_message_class(order["type"])
        if made is None:
            raise ImportError(f"{order['type']} is not installed here")
        message = fill(made(), order["values"])
        if name not in self._publishers:
            self._publishers[name] = rospy.Publisher(name, made, queue_size=10)
        publisher = self._publishers[name]
        end = time.monotonic() + _MATCHING
        # Who listens connects to a new publisher some time after it is there.
        subscribed = dict(self._master.getSystemState()[1])
        listening = len(subscribed.get(name, ()))
        while publisher.get_num_connections() < listening and time.monotonic() < end:
            time.sleep(0.02)
        if has_stamp(message, order["values"]):
            message.header.stamp = rospy.Time.now()
        publisher.publish(message)
        others = sum(not _is_hidden(owner) for owner in subscribed.get(name, ()))
        answer(order, f"sent to {name}" if others else f"sent to {name}; nobody listens there")

    def _call(self, order: dict[str, Any]) -> None:
        made = roslib.message.get_service_class(order["type"])
        if made is None:
            raise ImportError(f"{order['type']} is not installed here")
        request = fill(made._request_class(), order["values"])
        rospy.wait_for_service(order["name"], timeout=_TIMEOUT)
        proxy = rospy.ServiceProxy(order["name"], made)
        answer(order, line_of(proxy(request)) or "done")

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


def _is_hidden(node: str) -> bool:
    return node.startswith(_HIDDEN_NODES)


def main() -> None:
    """Watch until the studio has enough."""
    rospy.init_node(_NAME, anonymous=True, disable_signals=True, disable_rosout=True)
    monitor, orders = _Monitor(), Orders()
    try:
        while True:
            monitor.turn()
            for order in orders.take(_TURN):
                if order.get("do") == "leave":
                    return
                monitor.do(order)
    finally:
        # The master forgets what it knows of this node.
        rospy.signal_shutdown("the studio has enough")


if __name__ == "__main__":
    with contextlib.suppress(KeyboardInterrupt):
        main()
