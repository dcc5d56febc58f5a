import rclpy
import rclpy.lifecycle as lc
from lifecycle_msgs.srv import ChangeState, GetState
from std_msgs.msg import String


class Managed(lc.Node):
    def __init__(self, node_name: str):
        super().__init__(node_name)

    def on_configure(self, state):
        self.pub = self.create_lifecycle_publisher(msg_type=String, topic='out', qos_profile=10)
        return lc.TransitionCallbackReturn.SUCCESS


class Manager(rclpy.node.Node):
    TARGET = 'managed'

    def __init__(self):
        super().__init__('manager')
        self.change = self.create_client(ChangeState, f'/{self.TARGET}/change_state')
        self.state = self.create_client(GetState, '/{}/get_state'.format(Manager.TARGET))


def main():
    rclpy.init()
    executor = rclpy.executors.MultiThreadedExecutor(num_threads=2)
    for node in (Managed('managed'), Manager()):
        executor.add_node(node)
    executor.spin()
