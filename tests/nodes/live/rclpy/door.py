import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import Bool, String
from std_srvs.srv import SetBool


class Door(Node):
    """Locks itself, by way of a service, when somebody asks for it."""

    def __init__(self):
        super().__init__('door')
        self.lock_client = self.create_client(SetBool, 'lock')
        self.status = self.create_publisher(String, 'status', 10)
        self.create_subscription(Bool, 'close', self.on_close, 10)

    def on_close(self, msg):
        if not self.lock_client.wait_for_service(timeout_sec=5.0):
            self.get_logger().warning('no lock')
            return
        request = SetBool.Request()
        request.data = msg.data
        future = self.lock_client.call_async(request)
        future.add_done_callback(self.on_answer)

    def on_answer(self, future):
        answer = future.result()
        self.status.publish(String(data=f'{answer.success}: {answer.message}'))


def main(args=None):
    rclpy.init(args=args)
    door = Door()
    try:
        rclpy.spin(door)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    door.destroy_node()


if __name__ == '__main__':
    main()
