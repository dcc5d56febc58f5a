import rclpy
from rclpy.node import Node
from nav_msgs.msg import Path
from std_msgs.msg import String
from std_srvs.srv import Empty


class FromParameters(Node):
    def __init__(self):
        super().__init__('from_parameters')
        self.declare_parameter('topic', 'chatter')
        a = self.create_publisher(String, self.get_parameter('topic').value, 10)
        b = self.create_publisher(
            String, self.declare_parameter('out', 'out_default').value, 10)
        name = self.get_parameter('topic').get_parameter_value().string_value
        c = self.create_subscription(String, name, self.heard, 10)
        plan = self.declare_parameter('plan', 'plan/global').value
        d = self.create_subscription(Path, plan, self.heard, 10)
        self.service_name = self.declare_parameter('service', 'clear').get_parameter_value().string_value
        e = self.create_service(Empty, self.service_name, self.clear)
        f = self.create_client(Empty, f'{name}/clear')
        g = self.create_timer(self.get_parameter('period').value, self.beat)

    def heard(self, msg):
        pass

    def clear(self, request, response):
        return response

    def beat(self):
        pass


rclpy.init()
rclpy.spin(FromParameters())
