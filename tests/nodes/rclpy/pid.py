import rclpy
import rclpy.node
from std_msgs.msg import Float64
from my_control_interfaces.srv import SetGains


class Pid(rclpy.node.Node):
    def __init__(self):
        super().__init__(node_name='pid')
        self.declare_parameters('', [('p', 1.0), ('i', 0.0), ('d', 0.05)])
        self.p = self.get_parameter('p').get_parameter_value().double_value
        self.i = (
            self.get_parameter('i')
            .get_parameter_value()
            .double_value
        )
        self.d = self.get_parameter(name="d").value
        self.goal = self.sum = self.last = 0.0
        self.out = self.create_publisher(Float64, 'effort', 1)
        self.create_subscription(Float64, 'goal', self.set_goal, 1)
        self.create_subscription(Float64, 'measured', self.measured, 1)
        self.create_service(callback=self.gains, srv_name='set_gains', srv_type=SetGains)
        self.cli = self.create_client(SetGains, srv_name='motor/enable')

    def set_goal(self, m):
        self.goal = m.data

    def measured(self, m):
        error = self.goal - m.data
        self.sum += error
        self.out.publish(Float64(data=self.p * error + self.i * self.sum + self.d * (error - self.last)))
        self.last = error

    def gains(self, request, response):
        self.p, self.i, self.d = request.p, request.i, request.d
        return response


rclpy.init()
rclpy.spin(Pid())
