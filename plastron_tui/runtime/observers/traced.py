"""Runs a node's file and reports each service call that it serves or makes.

Neither ROS tells others of a service call (ROS 2's introspection has to be switched on by the
node itself), so the node's own client library is asked: services and clients are wrapped
before the node's file runs; the file stays as it is.

Arguments: the node's file, and its own arguments. Reports are lines of JSON on the file
descriptor that `PLASTRON_EVENTS_FD` names.
"""

from __future__ import annotations

import importlib.util
import inspect
import json
import os
import runpy
import sys
from pathlib import Path
from typing import Any

from plastron_text import line_of

# A write to a pipe is one piece up to PIPE_BUF, 4096 bytes, also among several writers.
_LONGEST = 700


def report(
    kind: str, service: str, request: Any, response: Any, response_class: Any = None
) -> None:
    """Tell of a call; `kind` is `served` or `called`. It never fails the node.

    With a `response_class` the response is what a rospy handler returned, which may be a value.
    """
    try:
        if response_class is not None:
            response = _as_message(response, response_class)
        answer = str(response) if isinstance(response, BaseException) else line_of(response)
        event = {
            "kind": kind,
            "service": service,
            "request": line_of(request)[:_LONGEST],
            "response": answer[:_LONGEST],
            "is_failure": isinstance(response, BaseException),
        }
        line = json.dumps(event, ensure_ascii=False) + "\n"
        os.write(int(os.environ["PLASTRON_EVENTS_FD"]), line.encode("utf-8", "replace"))
    except Exception:
        return


def trace_rospy() -> None:
    """Wrap the handlers of rospy's services and the calls of its clients."""
    import rospy

    make, call = rospy.Service.__init__, rospy.ServiceProxy.call

    def make_traced(
        self: Any, name: str, service_class: Any, handler: Any, *rest: Any, **named: Any
    ) -> None:
        def traced(request: Any) -> Any:
            try:
                response = handler(request)
            except Exception as error:
                report("served", self.resolved_name, request, error)
                raise
            report("served", self.resolved_name, request, response, service_class._response_class)
            return response

        make(self, name, service_class, traced, *rest, **named)

    def call_traced(self: Any, *values: Any, **named: Any) -> Any:
        request = rospy.msg.args_kwds_to_message(self.request_class, values, named)
        try:
            response = call(self, request)
        except Exception as error:
            report("called", self.resolved_name, request, error)
            raise
        report("called", self.resolved_name, request, response)
        return response

    rospy.Service.__init__ = make_traced
    rospy.ServiceProxy.call = call_traced


def _as_message(response: Any, response_class: Any) -> Any:
    """Return what a rospy handler returned as a message, the way rospy itself does."""
    from rospy.impl.tcpros_service import (
        convert_return_to_response,
    )

    return convert_return_to_response(response, response_class)


def trace_rclpy() -> None:
    """Wrap the callbacks of rclpy's services and the calls of its clients."""
    from rclpy.client import Client
    from rclpy.node import Node

    make, make_client, call = Node.create_service, Node.create_client, Client.call_async

    def make_traced(
        self: Any, srv_type: Any, srv_name: str, callback: Any, *rest: Any, **named: Any
    ) -> Any:
        service = self.resolve_service_name(srv_name)

        def traced(request: Any, response: Any) -> Any:
            try:
                result = callback(request, response)
            except Exception as error:
                report("served", service, request, error)
                raise
            report("served", service, request, result)
            return result

        async def traced_later(request: Any, response: Any) -> Any:
            result = await callback(request, response)
            report("served", service, request, result)
            return result

        own = _is_own(srv_type)
        wrapped = traced_later if inspect.iscoroutinefunction(callback) else traced
        return make(self, srv_type, srv_name, callback if own else wrapped, *rest, **named)

    def make_client_traced(
        self: Any, srv_type: Any, srv_name: str, *rest: Any, **named: Any
    ) -> Any:
        client = make_client(self, srv_type, srv_name, *rest, **named)
        if not _is_own(srv_type):
            client.plastron_service = self.resolve_service_name(srv_name)
        return client

    def call_traced(self: Any, request: Any) -> Any:
        future = call(self, request)
        service = getattr(self, "plastron_service", None)
        if service is not None:
            future.add_done_callback(lambda done: report_future(service, request, done))
        return future

    def report_future(service: str, request: Any, done: Any) -> None:
        if not done.cancelled():
            error = done.exception()
            report("called", service, request, error if error is not None else done.result())

    Node.create_service = make_traced
    Node.create_client = make_client_traced
    Client.call_async = call_traced


def _is_own(srv_type: Any) -> bool:
    """Tell whether a service is one that every ROS 2 node has, such as its parameters'."""
    return srv_type.__module__.split(".")[0] in ("rcl_interfaces", "type_description_interfaces")


def main() -> None:
    """Trace the client library that is there, then become the node."""
    path = Path(sys.argv[1])
    sys.argv = sys.argv[1:]
    sys.path[0] = str(path.parent)
    if os.environ.get("PLASTRON_ROS_VERSION") == "1":
        trace_rospy()
    elif importlib.util.find_spec("rclpy") is not None:
        trace_rclpy()
    runpy.run_path(str(path), run_name="__main__")


if __name__ == "__main__":
    main()
