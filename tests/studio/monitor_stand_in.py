"""A monitor that needs no ROS: it says what it is told to, and writes down what it is asked."""

from __future__ import annotations

import json
import os
import signal
import sys
from pathlib import Path


def send(**report: object) -> None:
    print(json.dumps(report), flush=True)


def main() -> None:
    topics = [[f"/topic_{number:03}", "std_msgs/Float64", 1, 1] for number in range(50)]
    chatter = ["/chatter", "geometry_msgs/Twist", 1, 1]
    send(
        tell="graph",
        topics=[chatter, *topics],
        services=[["/add", "example_interfaces/AddTwoInts"]],
        actions=[["/count", "example_interfaces/Fibonacci", 1, ["/talker"]]],
        nodes=["/talker"],
    )
    goals = {}
    with Path(sys.argv[1]).open("a", encoding="utf-8") as log:
        for line in sys.stdin:
            order = json.loads(line)
            print(line, end="", file=log, flush=True)
            if order["do"] == "watch":
                fields = [["linear.x", "0.25", 0.25], ["linear.y", "0", 0.0]]
                rows = {name: {"count": 3, "rate": 2.0, "text": "0.25", "number": 0.25,
                               **({"fields": fields} if name in order["full"] else {})}
                        for name in order["topics"]}  # fmt: skip
                send(tell="topics", rows=rows)
                for node in order["nodes"]:
                    row = {"name": "speed", "value": 0.5, "type": "float", "range": [0, 1],
                           "about": "how fast", "is_read_only": False}  # fmt: skip
                    send(tell="parameters", node=node, rows=[row])
            elif order["do"] == "publish" and order["rate"]:
                text = ", ".join(map(str, order["values"]))
                send(tell="answer", id=order["id"], text="", is_failure=False)
                send(tell="sending", name=order["name"], rate=order["rate"], text=text)
            elif order["do"] == "stop":
                send(tell="sending", name=order["name"], rate=0, text="")
            elif order["do"] == "goal" and order["values"]:
                goals[order["id"]] = goal = {
                    "tell": "goal", "id": order["id"], "name": order["name"], "sent": "order: 5",
                    "state": "accepted", "text": "sequence: [0, 1]", "is_over": False,
                    "is_failure": False}  # fmt: skip
                send(**goal)
            elif order["do"] == "cancel":
                send(**{**goals[order["goal"]], "state": "canceled", "is_over": True})
            elif order["do"] == "goal":
                send(tell="answer", id=order["id"], text="it needs an order", is_failure=True)
            elif order["do"] == "call" and not order["values"]:
                os.kill(os.getpid(), signal.SIGKILL)
            elif order["do"] == "set" and order["value"] == 0.25:
                send(tell="answer", id=order["id"], text="not now", is_failure=True)
            elif order["do"] == "set":
                said = f"{order['name']} is {order['value']} now"
                send(tell="answer", id=order["id"], text=said, is_failure=False)
            else:
                send(tell="answer", id=order["id"], text=f"done: {order['do']}", is_failure=False)


main()
