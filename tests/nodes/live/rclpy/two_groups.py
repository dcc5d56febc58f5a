import rclpy
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup, ReentrantCallbackGroup
from rclpy.executors import ExternalShutdownException, MultiThreadedExecutor
from rclpy.node import Node
from std_msgs.msg import Empty, Int32
from std_srvs.srv import Trigger


class TwoGroups(Node):
    """Counts in one group of callbacks, answers in another."""

    def __init__(self):
        super().__init__('two_groups')
        self.counting = MutuallyExclusiveCallbackGroup()
        self.asking = ReentrantCallbackGroup()
        self.count = 0
        self.count_pub = self.create_publisher(Int32, 'count', 10)
        self.step_sub = self.create_subscription(
            Empty, 'step', self.on_step, 10, callback_group=self.counting)
        self.back_sub = self.create_subscription(
            Empty, 'back', self.on_back, 10, callback_group=self.counting)
        self.srv = self.create_service(
            Trigger, 'how_many', self.on_how_many, callback_group=self.asking)

    def on_step(self, _):
        self.count += 1
        self.count_pub.publish(Int32(data=self.count))

    def on_back(self, _):
        self.count -= 1
        self.count_pub.publish(Int32(data=self.count))

    def on_how_many(self, request, response):
        response.success = True
        response.message = str(self.count)
        return response


def main():
    rclpy.init()
    node = TwoGroups()
    executor = MultiThreadedExecutor(num_threads=2)
    executor.add_node(node)
    try:
        executor.spin()
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        executor.shutdown()
        node.destroy_node()


if __name__ == '__main__':
    main()
