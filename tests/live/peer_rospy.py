"""The other side of a ROS 1 node: send it goals, serve its goals, answer its requests.

It tells of each event in a line of JSON; `time` is in seconds, of one clock.
"""

import json
import os
import sys
import threading
import time

import actionlib
import rospy
from probe_ros1 import load, plain
from std_msgs.msg import String
from std_srvs.srv import SetBool, SetBoolResponse, Trigger, TriggerResponse


def tell(event, **more):
    sys.stdout.write(json.dumps({"event": event, "time": time.monotonic(), **more}) + "\n")
    sys.stdout.flush()


def send(action, type_name, fields, cancel_at, second_at):
    """Send a goal; at a number of feedbacks cancel it, or send a second one."""
    client = actionlib.ActionClient(action, load("msg", type_name + "Action"))
    goals = []
    done = threading.Event()
    ended = []

    def index_of(handle):
        # What is heard of a goal may come before it is known that it was sent.
        return goals.index(handle) if handle in goals else len(goals)

    def on_transition(handle):
        state = handle.get_comm_state()
        index = index_of(handle)
        if state == actionlib.CommState.ACTIVE:
            tell("accepted", goal=index)
        elif state == actionlib.CommState.DONE:
            status = actionlib.GoalStatus.to_string(handle.get_terminal_state()).lower()
            result = plain(handle.get_result())
            tell("result", goal=index, status=status, result=result)
            ended.append(index)
            if len(ended) == (2 if second_at else 1):
                done.set()

    heard = {}

    def on_feedback(handle, feedback):
        index = index_of(handle)
        heard[index] = heard.get(index, 0) + 1
        tell("feedback", goal=index, feedback=plain(feedback))
        if index == 0 and heard[0] == cancel_at:
            handle.cancel()
        if index == 0 and heard[0] == second_at:
            begin()

    def begin():
        goal = load("msg", type_name + "Goal")(**fields)
        goals.append(client.send_goal(goal, on_transition, on_feedback))

    rospy.Subscriber("chatter", String, lambda message: tell("message"))
    assert client.wait_for_server(rospy.Duration(60)), "the action is not there"
    begin()
    assert done.wait(120), "no result"


def serve(action, type_name, how, feedback, result):
    """Serve an action: `succeed`, `abort` or `reject` each goal, or `die` of it."""

    def on_goal(handle):
        tell("goal", goal=plain(handle.get_goal()))
        if how == "reject":
            handle.set_rejected()
            return
        handle.set_accepted()
        threading.Thread(target=work, args=(handle,), daemon=True).start()

    def work(handle):
        for _ in range(3):
            handle.publish_feedback(load("msg", type_name + "Feedback")(**feedback))
            time.sleep(0.2)
        if how == "die":
            os._exit(0)
        end = {"succeed": handle.set_succeeded, "abort": handle.set_aborted}[how]
        end(load("msg", type_name + "Result")(**result))

    server = actionlib.ActionServer(
        action, load("msg", type_name + "Action"), on_goal, lambda _: tell("cancel"), False
    )
    server.start()
    tell("serving")
    rospy.spin()


def answer(seconds):
    """Serve `ready` and `enable_motor`, with answers that take so long."""
    flying = []

    def answering(name, response):
        def handle(request):
            flying.append(name)
            tell("request", service=name, flying=flying.count(name), request=plain(request))
            time.sleep(seconds)
            flying.remove(name)
            return response

        return handle

    rospy.Service("ready", Trigger, answering("ready", TriggerResponse(True, "yes")))
    motor = answering("enable_motor", SetBoolResponse(True, "on"))
    rospy.Service("enable_motor", SetBool, motor)
    tell("serving")
    rospy.spin()


if __name__ == "__main__":
    command, *arguments = sys.argv[1:]
    rospy.init_node("peer", anonymous=True)
    {"send": send, "serve": serve, "answer": answer}[command](*map(json.loads, arguments))
