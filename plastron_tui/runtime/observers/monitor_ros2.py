"""The studio's monitor of nodes of ROS 2 (see `monitor_pipes.py` for how the two speak).

It looks every second for topics, services and nodes, and subscribes to no topic but those that the
studio looks at. Their messages are taken from the middleware in turns, as they are: an executor
would look through all subscriptions for each single message, and only the last message of a turn
is made readable.
"""

from __future__ import annotations

import contextlib
import importlib
import time
from collections.abc import Callable
from typing import Any

import rclpy
from fitting_subscription import FittingSubscription
from goals_ros2 import ActionClients
from graph_ros2 import RunningGraph
from message_filling import fill, has_stamp
from message_summary import summary_of
from monitor_goals import Goals
from monitor_parameters import Parameters
from monitor_pipes import Orders, answer, send, sent_words
from monitor_sending import Sendings
from monitor_subscriptions import NotInstalledError, Subscriptions
from monitor_topics import WatchedTopic
from plastron_text import line_of
from rclpy.executors import SingleThreadedExecutor
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy
from rclpy.serialization import deserialize_message
from rclpy.signals import SignalHandlerOptions
from watch import ros2_class

_TURN, _IDLE_TURN = 0.05, 0.5
_REPORT = 0.25
_LOOK = 1.0
_ANSWER = 10.0
_MATCHING = 1.5
_MOST_A_TURN = 1000
_NAMES = ("_plastron_monitor", "_plastron_monitor_calls")


class _Watching:
    """A subscription that nobody spins: its messages are taken in turns."""

    def __init__(self, node: Any, name: str, type_name: str) -> None:
        self._class = _class_of(type_name)
        self.topic = WatchedTopic(type_name, lambda raw: deserialize_message(raw, self._class))
        self._fitting = FittingSubscription(node, name, self._class, lambda _: None)

    def take(self) -> None:
        """Note the messages that came."""
        subscription = self._fitting.subscription
        clock = time.monotonic() - time.time()
        with subscription.handle:
            for _ in range(_MOST_A_TURN):
                found = subscription.handle.take_message(subscription.msg_type, True)
                if found is None:
                    return
                at = found[1]["received_timestamp"] / 1e9 + clock
                self.topic.see(found[0], at if abs(at - time.monotonic()) < 1 else None)

    def look(self) -> None:
        """Follow the publishers that are there now."""
        self._fitting.look()

    def close(self) -> None:
        """Hear no more of it."""
        self._fitting.close()


def _class_of(type_name: str) -> Any:
    try:
        return ros2_class(type_name)
    except (ModuleNotFoundError, AttributeError) as error:
        raise NotInstalledError(type_name) from error


class _Monitor:
    """The nodes of the monitor, and what the studio has asked for."""

    def __init__(self) -> None:
        self._node, self._caller = (
            rclpy.create_node(name, enable_rosout=False, start_parameter_services=False)
            for name in _NAMES
        )
        self._executor = SingleThreadedExecutor()
        self._executor.add_node(self._caller)
        self._topics = Subscriptions(lambda name, type_: _Watching(self._node, name, type_))
        self._pending: list[tuple[dict[str, Any], float, Callable[[bool], bool]]] = []
        self._parameters = Parameters(self._caller)
        self._sendings = Sendings()
        self._goals, self._action_clients = Goals(), ActionClients(self._caller)
        self._running = RunningGraph(self._node, self._topics, self._action_clients)
        self._graph: dict[str, Any] = {}
        self._looked = self._reported = 0.0

    @property
    def turn_time(self) -> float:
        """Seconds until the next turn."""
        is_busy = self._topics or self._is_spun
        return _TURN if is_busy else _IDLE_TURN

    @property
    def _is_spun(self) -> bool:
        """Whether an answer is waited for."""
        return bool(self._pending or self._goals or self._parameters.is_asking)

    def do(self, order: dict[str, Any]) -> None:
        """Do what the studio wants."""
        try:
            match order["do"]:
                case "watch":
                    self._topics.watch(order["topics"], order["full"])
                    self._parameters.watch(order["nodes"])
                case "publish" if order.get("rate"):
                    self._send(order)
                case "publish":
                    self._publish(order)
                case "stop":
                    self._sendings.stop(order["name"])
                case "goal":
                    self._action_clients.send(order, self._goals)
                case "cancel":
                    self._goals.cancel(order["goal"])
                case "call":
                    self._call(order)
                case "set":
                    self._parameters.set(order, self._later)
        except Exception as error:  # a type that is not installed, a value that does not fit, …
            answer(order, str(error) or type(error).__name__, is_failure=True)

    def close(self) -> None:
        """Send nothing any more, because the studio is gone."""
        self._sendings.close()

    def turn(self) -> None:
        """Take what came, and tell of it."""
        now = time.monotonic()
        if now - self._looked >= _LOOK:
            self._looked = now
            self._look()
        self._topics.take()
        self._sendings.turn()
        if now - self._reported >= _REPORT:
            self._reported = now
            self._topics.report()
            self._goals.report()
        self._parameters.turn(now)
        if self._is_spun:
            for _ in range(10):
                self._executor.spin_once(timeout_sec=0)
            asked, self._pending = self._pending, []
            self._pending += [each for each in asked if not self._is_done(*each)]
            self._goals.turn()

    def _look(self) -> None:
        """Find out what is there, and tell it where that is new."""
        try:
            graph = self._running.look()
        except Exception as error:  # rclpy's own kinds of error differ between distributions
            send(tell="problem", text=str(error) or type(error).__name__)
            # Told again as soon as there is one, it says that there is no problem any more.
            self._graph = {}
            return
        self._topics.look()
        self._parameters.nodes = frozenset(graph["nodes"])
        if graph != self._graph:
            self._graph = graph
            send(tell="graph", **graph)
        send(tell="beat")

    def _later(
        self, order: dict[str, Any], step: Callable[[bool], bool], limit: float = _ANSWER
    ) -> None:
        """Ask `step` in each turn whether it is done; it is told when the time is up."""
        self._pending.append((order, time.monotonic() + limit, step))

    def _is_done(self, order: dict[str, Any], end: float, step: Callable[[bool], bool]) -> bool:
        try:
            return step(time.monotonic() > end)
        except Exception as error:  # whatever a foreign node answers
            answer(order, str(error) or type(error).__name__, is_failure=True)
            return True

    def _publish(self, order: dict[str, Any]) -> None:
        name, values = order["name"], order["values"]
        message = fill(ros2_class(order["type"])(), values)
        qos = self._publisher_qos(name)
        publisher = self._node.create_publisher(type(message), name, qos)
        self._running.publishers[name] += 1

        def send_it(is_late: bool) -> bool:
            listening = self._node.count_subscribers(name)
            reached = publisher.get_subscription_count()
            if reached < listening and not is_late:
                return False
            self._stamp(message, values)
            self._later(order, leave, _MATCHING)
            publisher.publish(message)
            own = self._topics.hears(name)
            answer(order, sent_words(name, listening - own, reached - own))
            return True

        def leave(is_late: bool) -> bool:
            # It has arrived by then; nodes that start later must not be told to move again.
            if is_late:
                self._running.publishers[name] -= 1
                self._node.destroy_publisher(publisher)
            return is_late

        self._later(order, send_it, _MATCHING)

    def _send(self, order: dict[str, Any]) -> None:
        """Send a message at a rate."""
        name, values = order["name"], order["values"]
        message = fill(ros2_class(order["type"])(), values)
        # What was sent to it until now has a publisher of its own.
        self._sendings.stop(name)
        publisher = self._node.create_publisher(type(message), name, self._publisher_qos(name))
        self._running.publishers[name] += 1

        def publish() -> None:
            self._stamp(message, values)
            publisher.publish(message)

        def close() -> None:
            self._running.publishers[name] -= 1
            self._node.destroy_publisher(publisher)

        self._sendings.start(order, publish, close, summary_of(message, order["type"]).text)

    def _stamp(self, message: Any, values: dict[str, Any]) -> None:
        if has_stamp(message, values):
            message.header.stamp = self._node.get_clock().now().to_msg()

    def _publisher_qos(self, name: str) -> Any:
        """Return a quality of service that every subscription of the topic accepts."""
        infos = self._node.get_subscriptions_info_by_topic(name)
        is_kept = any(
            info.qos_profile.durability == DurabilityPolicy.TRANSIENT_LOCAL for info in infos
        )
        return QoSProfile(
            depth=10,
            reliability=ReliabilityPolicy.RELIABLE,
            durability=DurabilityPolicy.TRANSIENT_LOCAL if is_kept else DurabilityPolicy.VOLATILE,
        )

    def _call(self, order: dict[str, Any]) -> None:
        package, name = order["type"].split("/")
        service = getattr(importlib.import_module(f"{package}.srv"), name)
        request = fill(service.Request(), order["values"])
        client = self._caller.create_client(service, order["name"])
        sent: list[Any] = []

        def step(is_late: bool) -> bool:
            if not sent and client.service_is_ready():
                sent.append(client.call_async(request))
            if sent and sent[0].done():
                error = sent[0].exception()
                text = str(error) if error is not None else line_of(sent[0].result()) or "done"
                answer(order, text, is_failure=error is not None)
            elif is_late:
                text = "no answer came" if sent else "nobody provides it now"
                answer(order, text, is_failure=True)
            else:
                return False
            self._caller.destroy_client(client)
            return True

        self._later(order, step)


def main() -> None:
    """Watch until the studio has enough."""
    # First of all: who started this may be gone before the middleware is ready.
    orders = Orders()
    rclpy.init(args=[], signal_handler_options=SignalHandlerOptions.NO)
    monitor = _Monitor()
    while True:
        monitor.turn()
        for order in orders.take(monitor.turn_time):
            if order.get("do") == "leave":
                monitor.close()
                return
            monitor.do(order)


if __name__ == "__main__":
    with contextlib.suppress(KeyboardInterrupt):
        main()
