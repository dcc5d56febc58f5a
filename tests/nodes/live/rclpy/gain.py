import rclpy
from rcl_interfaces.msg import SetParametersResult
from rclpy.node import Node
from std_msgs.msg import Float64
from std_srvs.srv import Trigger


class Gain(Node):
    def __init__(self):
        super().__init__("gain")
        self.declare_parameters("", [("offset", 1.0), ("unit", "m")])
        self.declare_parameter("gain", 2.0)
        self.add_on_set_parameters_callback(self.on_parameters)
        self.output = self.create_publisher(Float64, "output", 1)
        self.input = self.create_subscription(Float64, "input", self.on_input, 1)
        self.tell = self.create_service(Trigger, "~/tell", self.on_tell)

    def on_parameters(self, parameters):
        return SetParametersResult(successful=all(each.value for each in parameters))

    def on_input(self, msg):
        gain = self.get_parameter("gain").value
        offset = self.get_parameter("offset").get_parameter_value().double_value
        self.output.publish(Float64(data=gain * msg.data + offset))

    def on_tell(self, request, response):
        response.success = True
        response.message = f"{self.get_parameter('gain').value} {self.get_parameter('unit').value}"
        return response


def main():
    rclpy.init()
    node = Gain()
    try:
        rclpy.spin(node)
    except KeyboardInterrupt:
        pass
    finally:
        node.destroy_node()
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
