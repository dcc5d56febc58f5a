"""The other side of a ROS 2 node: send it goals, serve its goals, answer its requests.

It tells of each event in a line of JSON; `time` is in seconds, of one clock.
"""

import json
import os
import sys
import time
from contextlib import suppress
from itertools import repeat

import rclpy
from action_msgs.msg import GoalStatus
from probe_ros2 import load, plain
from rcl_interfaces.srv import ListParameters
from rclpy.action import ActionClient, ActionServer, CancelResponse, GoalResponse
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import ExternalShutdownException, MultiThreadedExecutor
from rclpy.node import NodeNameNonExistentError
from std_msgs.msg import String
from std_srvs.srv import SetBool, Trigger

STATUS = {
    GoalStatus.STATUS_SUCCEEDED: "succeeded",
    GoalStatus.STATUS_CANCELED: "canceled",
    GoalStatus.STATUS_ABORTED: "aborted",
}


def tell(event, **more):
    sys.stdout.write(json.dumps({"event": event, "time": time.monotonic(), **more}) + "\n")
    sys.stdout.flush()


def wait_for_clients(node, names):
    """Wait until a server knows of those who ask: what it answers before that is lost to them."""
    end = time.monotonic() + 60
    while not all(map(node.count_clients, names)) and time.monotonic() < end:
        time.sleep(0.01)


def parts(action):
    return [f"/{action}/_action/{each}" for each in ("send_goal", "cancel_goal", "get_result")]


def services_of(node, name, namespace):
    """Return the services of a node, none where it is not yet known, or has gone."""
    with suppress(NodeNameNonExistentError):
        return [each for each, _ in node.get_service_names_and_types_by_node(name, namespace)]
    return []


def wait_to_be_known(node, action):
    """Wait until the node that provides an action knows of all that was made here so far.

    It hears of what a node has in the order in which it was made: once it answers a client that was
    made last, no answer and no feedback to the others is lost.
    """
    end = time.monotonic() + 60
    asked = None
    while asked is None and time.monotonic() < end:
        for name, namespace in node.get_node_names_and_namespaces():
            services = services_of(node, name, namespace)
            if parts(action)[0] in services:
                asked = [each for each in services if each.endswith("/list_parameters")]
        rclpy.spin_once(node, timeout_sec=0.05)
    for service in asked or ():
        client = node.create_client(ListParameters, service)
        while time.monotonic() < end:
            answer = client.call_async(ListParameters.Request())
            rclpy.spin_until_future_complete(node, answer, timeout_sec=1)
            if answer.done():
                break


def send(node, action, type_name, fields, cancel_at, second_at):
    """Send a goal; at a number of feedbacks cancel it, or send a second one."""
    type_ = load("action", type_name)
    client = ActionClient(node, type_, action)
    ended = []

    def begin(index):
        heard = []
        handles = []

        def on_feedback(message):
            heard.append(message)
            tell("feedback", goal=index, feedback=plain(message.feedback))
            if index == 0 and len(heard) == cancel_at:
                handles[0].cancel_goal_async().add_done_callback(on_cancel)
            if index == 0 and len(heard) == second_at:
                begin(1)

        def on_cancel(future):
            tell("cancel", goal=index, accepted=bool(future.result().goals_canceling))

        def on_response(future):
            handles.append(future.result())
            if handles[0].accepted:
                tell("accepted", goal=index)
                handles[0].get_result_async().add_done_callback(on_result)
            else:
                tell("result", goal=index, status="rejected")
                ended.append(index)

        def on_result(future):
            response = future.result()
            result = plain(response.result)
            tell("result", goal=index, status=STATUS[response.status], result=result)
            ended.append(index)

        goal = type_.Goal(**fields)
        client.send_goal_async(goal, on_feedback).add_done_callback(on_response)

    node.create_subscription(String, "chatter", lambda message: tell("message"), 10)
    assert client.wait_for_server(60), "the action is not there"
    wait_to_be_known(node, action)
    begin(0)
    end = time.monotonic() + 120
    while len(ended) < (2 if second_at else 1):
        assert time.monotonic() < end, "no result"
        rclpy.spin_once(node, timeout_sec=0.1)


def serve(node, action, type_name, how, feedback, result):
    """Serve an action: `succeed`, `abort` or `reject` each goal, or `die` of it.

    `hold` works on a goal until it is canceled, `late` does so too, and takes long to accept it.
    """
    is_held = how in ("hold", "late")
    type_ = load("action", type_name)

    def on_goal(goal):
        tell("goal", goal=plain(goal))
        wait_for_clients(node, parts(action))
        time.sleep(5 if how == "late" else 0)
        return GoalResponse.REJECT if how == "reject" else GoalResponse.ACCEPT

    def on_cancel(_):
        tell("cancel")
        return CancelResponse.ACCEPT

    def work(handle):
        for _ in repeat(None) if is_held else range(3):
            if is_held and handle.is_cancel_requested:
                break
            handle.publish_feedback(type_.Feedback(**feedback))
            time.sleep(0.2)
        if how == "die":
            os._exit(0)
        ways = {"succeed": handle.succeed, "abort": handle.abort}
        ways.get(how, handle.canceled)()
        return type_.Result(**result)

    callbacks = {"goal_callback": on_goal, "cancel_callback": on_cancel}
    group = ReentrantCallbackGroup()
    ActionServer(node, type_, action, work, callback_group=group, **callbacks)
    spin(node)


def answer(node, seconds):
    """Serve `ready` and `enable_motor`, with answers that take so long."""
    flying = []

    def answering(name, message):
        def handle(request, response):
            flying.append(name)
            tell("request", service=name, flying=flying.count(name), request=plain(request))
            wait_for_clients(node, [f"/{name}"])
            time.sleep(seconds)
            flying.remove(name)
            response.success, response.message = True, message
            return response

        return handle

    group = ReentrantCallbackGroup()
    node.create_service(Trigger, "ready", answering("ready", "yes"), callback_group=group)
    motor = answering("enable_motor", "on")
    node.create_service(SetBool, "enable_motor", motor, callback_group=group)
    spin(node)


def spin(node):
    tell("serving")
    with suppress(KeyboardInterrupt, ExternalShutdownException):
        rclpy.spin(node, MultiThreadedExecutor(4))


if __name__ == "__main__":
    command, *arguments = sys.argv[1:]
    rclpy.init()
    peer = rclpy.create_node("peer")
    peer_command = {"send": send, "serve": serve, "answer": answer}[command]
    peer_command(peer, *map(json.loads, arguments))
