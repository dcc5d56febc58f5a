"""The other side of `cpp/everything.cpp`: say words, answer what is asked, tell what is echoed."""

from contextlib import suppress

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.qos import DurabilityPolicy, QoSProfile
from std_msgs.msg import String
from std_srvs.srv import SetBool


def main():
    rclpy.init()
    node = rclpy.create_node("peer")
    publisher = node.create_publisher(String, "words", 10)

    def answer(request, response):
        response.message = f"asked {request.data}"
        return response

    node.create_service(SetBool, "answer", answer)
    late = QoSProfile(depth=10, durability=DurabilityPolicy.TRANSIENT_LOCAL)
    node.create_subscription(String, "echoes", lambda echo: print(echo.data, flush=True), late)
    node.create_timer(0.1, lambda: publisher.publish(String(data="true")))
    with suppress(KeyboardInterrupt, ExternalShutdownException):
        rclpy.spin(node)


if __name__ == "__main__":
    main()
