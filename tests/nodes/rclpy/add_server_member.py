from example_interfaces.srv import AddTwoInts
import rclpy
from rclpy.node import Node


class AddServer(Node):

    def __init__(self):
        super().__init__('add_two_ints_server')
        self.srv = self.create_service(AddTwoInts, 'add_two_ints', self.add)

    async def add(self, request, response):
        response.sum = request.a + request.b
        return response


def main(args=None):
    rclpy.init(args=args)
    server = AddServer()
    rclpy.spin(server)
    rclpy.shutdown()
