"""Keeps the robot's mode, for those that come late too."""
import rclpy
from rclpy.node import Node
from rclpy.qos import QoSDurabilityPolicy, QoSProfile, QoSReliabilityPolicy
from std_msgs.msg import String
from std_srvs.srv import SetBool, Trigger

LATCHED = QoSProfile(
    depth=1,
    durability=QoSDurabilityPolicy.TRANSIENT_LOCAL,
    reliability=QoSReliabilityPolicy.RELIABLE,
)


class ModeKeeper(Node):
    def __init__(self) -> None:
        super().__init__("mode_keeper")
        self.mode = "idle"
        self.mode_pub = self.create_publisher(String, "mode", LATCHED)
        self.create_service(SetBool, "~/arm", self.on_arm)
        self.create_service(Trigger, "~/mode", self.on_mode)
        self.create_subscription(String, "wanted_mode", self.on_wanted, LATCHED)
        self.tell()

    def tell(self) -> None:
        self.mode_pub.publish(String(data=self.mode))

    def on_wanted(self, msg: String) -> None:
        self.mode = msg.data
        self.tell()

    def on_arm(self, request, response):
        self.mode = "armed" if request.data else "idle"
        self.tell()
        response.success = True
        response.message = self.mode
        return response

    def on_mode(self, request, response):
        response.success = self.mode == "armed"
        response.message = self.mode
        return response


def main():
    rclpy.init()
    node = ModeKeeper()
    try:
        rclpy.spin(node)
    except (KeyboardInterrupt, rclpy.executors.ExternalShutdownException):
        pass


if __name__ == "__main__":
    main()
