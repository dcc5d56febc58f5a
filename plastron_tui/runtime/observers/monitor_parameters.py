"""The parameters of running ROS 2 nodes, for the studio's monitor.

Services: https://github.com/ros2/rcl_interfaces/tree/rolling/rcl_interfaces/srv
"""

from __future__ import annotations

from collections.abc import Callable, Generator, Iterable
from typing import Any

from monitor_pipes import answer, is_now, send
from rcl_interfaces.srv import DescribeParameters, GetParameters, ListParameters, SetParameters
from rclpy.parameter import Parameter, parameter_value_to_python

_PERIOD = 2.0
_LIMIT = 5.0
_OF_EVERY_NODE = ("use_sim_time", "qos_overrides", "start_type_description_service")
_TYPES = {
    1: "bool", 2: "int", 3: "float", 4: "string",
    6: "bool_list", 7: "int_list", 8: "float_list", 9: "string_list",
}  # fmt: skip
Steps = Generator[Callable[[], bool], None, None]
Later = Callable[[dict[str, Any], Callable[[bool], bool]], None]


class Parameters:
    """Asks nodes for their parameters from time to time, and sets them.

    Attributes:
        nodes: the nodes that are there.
    """

    def __init__(self, caller: Any) -> None:
        """Start with no node; `caller` is the node that asks, which somebody has to spin."""
        self.nodes: frozenset[str] = frozenset()
        self._caller = caller
        self._watched: set[str] = set()
        self._asked: dict[str, float] = {}
        self._running: dict[
            str, tuple[Generator[Callable[[], bool], None, None], Callable[[], bool]]
        ] = {}
        self._told: dict[str, Any] = {}

    @property
    def is_asking(self) -> bool:
        """Whether an answer is still to come."""
        return bool(self._running)

    def watch(self, names: Iterable[str]) -> None:
        """Ask these nodes, and no others."""
        self._watched = set(names)
        for name in set(self._told) - self._watched:
            del self._told[name]

    def turn(self, now: float) -> None:
        """Go on with what was asked, and ask again what was asked long ago."""
        for name in self._watched & self.nodes:
            if name not in self._running and now - self._asked.get(name, 0.0) > _PERIOD:
                self._asked[name] = now
                # It can go on at once, to its first question.
                self._running[name] = self._ask(name), lambda: True
        for name, (steps, waiting) in list(self._running.items()):
            if now - self._asked[name] > _LIMIT:
                steps.close()
                del self._running[name]
                continue
            try:
                if waiting():
                    self._running[name] = steps, next(steps)
            except StopIteration:
                del self._running[name]
            except Exception:  # whatever a foreign node answers; it is asked again later
                steps.close()
                del self._running[name]

    def _ask(self, name: str) -> Steps:
        """Ask a node; what is yielded tells whether it can go on."""
        kinds = (
            (ListParameters, "list_parameters"),
            (GetParameters, "get_parameters"),
            (DescribeParameters, "describe_parameters"),
        )
        clients = [self._caller.create_client(kind, f"{name}/{part}") for kind, part in kinds]
        try:
            yield lambda: all(client.service_is_ready() for client in clients)
            listing = clients[0].call_async(ListParameters.Request())
            yield listing.done
            names = [
                each
                for each in listing.result().result.names
                if each.partition(".")[0] not in _OF_EVERY_NODE
            ]
            values = clients[1].call_async(GetParameters.Request(names=names))
            described = clients[2].call_async(DescribeParameters.Request(names=names))
            yield lambda: bool(values.done() and described.done())
            found = zip(names, values.result().values, described.result().descriptors, strict=False)
            rows = [_row(*each) for each in found]
            if self._told.get(name) != rows:
                self._told[name] = rows
                send(tell="parameters", node=name, rows=rows)
        finally:
            for client in clients:
                self._caller.destroy_client(client)

    def set(self, order: dict[str, Any], later: Later) -> None:
        """Set a parameter, and tell what the node says to it."""
        node, name, value = order["node"], order["name"], order["value"]
        client = self._caller.create_client(SetParameters, f"{node}/set_parameters")
        kind = next((each for each, word in _TYPES.items() if word == order.get("type")), None)
        type_ = None if kind is None else Parameter.Type(kind)
        request = SetParameters.Request(
            parameters=[Parameter(name, type_, value).to_parameter_msg()]
        )
        sent: list[Any] = []

        def step(is_late: bool) -> bool:
            if not sent and client.service_is_ready():
                sent.append(client.call_async(request))
            if sent and sent[0].done():
                (result,) = sent[0].result().results
                refused = result.reason or "the node refuses it"
                said = is_now(name, value) if result.successful else refused
                answer(order, said, is_failure=not result.successful)
                # What was asked before that is out of date, and is asked again.
                self._asked[node] = 0.0
            elif is_late:
                answer(order, "the node does not answer", is_failure=True)
            else:
                return False
            self._caller.destroy_client(client)
            return True

        later(order, step)


def _row(name: str, given: Any, descriptor: Any) -> dict[str, Any]:
    value = parameter_value_to_python(given)
    if not isinstance(value, (bool, int, float, str, type(None))):
        value = [each if not isinstance(each, bytes) else each[0] for each in value]
    ranges = [*descriptor.floating_point_range, *descriptor.integer_range]
    return {
        "name": name,
        "value": value,
        "type": _TYPES.get(given.type, ""),
        "range": [ranges[0].from_value, ranges[0].to_value] if ranges else None,
        "about": descriptor.description,
        "is_read_only": descriptor.read_only,
    }
