import rclpy
from action_msgs.msg import GoalStatus
from geometry_msgs.msg import PoseStamped
from orchard_driver.names import BATTERY_TOPIC, FRUITS
from orchard_interfaces.action import DriveRow
from orchard_interfaces.msg import FruitCount, ToolCommand
from orchard_interfaces.srv import CountFruits
from rclpy.action import ActionClient
from rclpy.node import Node
from rclpy.qos import qos_profile_sensor_data
from sensor_msgs.msg import BatteryState
from std_msgs.msg import String
from std_srvs.srv import Trigger

ROWS = ['A1', 'A2', 'B1']


class Supervisor(Node):
    def __init__(self):
        super().__init__('supervisor')
        self.declare_parameter('rows', ROWS)
        self.declare_parameter('speed', 0.5)
        self.declare_parameter('start_delay', 2.0)
        self.voltage = None
        self.goal_pose = PoseStamped()
        self.mode_pub = self.create_publisher(String, 'mode', 10)
        self.tool_pub = self.create_publisher(ToolCommand, 'tool/command', 10)
        self.create_subscription(BatteryState, BATTERY_TOPIC, self.on_battery, qos_profile_sensor_data)
        self.create_subscription(FruitCount, FRUITS, self.on_fruits, 10)
        self.create_subscription(PoseStamped, 'row_goal', self.on_goal_pose, 10)
        self.drive = ActionClient(self, DriveRow, 'drive_row')
        self.count_client = self.create_client(CountFruits, 'count_fruits')
        self.stop_client = self.create_client(Trigger, 'motor_driver/stop')
        self.tick = self.create_timer(self.get_parameter('start_delay').value, self.start)

    def on_battery(self, msg: BatteryState):
        self.voltage = msg.voltage
        if msg.percentage < 0.1:
            self.stop_client.call_async(Trigger.Request())

    def on_fruits(self, fruits: FruitCount):
        self.get_logger().info(f'row {fruits.row}: {fruits.ripe} ripe, {fruits.unripe} not')
        if fruits.ripe > 3:
            command = ToolCommand(command=ToolCommand.CLOSE, force=2.5, fingers=['thumb', 'index'])
            self.tool_pub.publish(command)

    def on_goal_pose(self, pose):
        self.goal_pose = pose

    def start(self):
        self.tick.cancel()
        self.mode_pub.publish(String(data='harvest'))
        self.drive.wait_for_server(timeout_sec=0.0)
        goal = DriveRow.Goal()
        goal.row = self.get_parameter('rows').value[0]
        goal.speed = self.get_parameter('speed').value
        sent = self.drive.send_goal_async(goal, feedback_callback=self.on_feedback)
        sent.add_done_callback(self.on_accepted)
        request = CountFruits.Request(row=goal.row, use_flash=False)
        self.count_client.call_async(request).add_done_callback(self.on_counted)

    def on_feedback(self, message):
        self.get_logger().info(f'{message.feedback.progress:.0%}')

    def on_accepted(self, future):
        handle = future.result()
        if handle.accepted:
            handle.get_result_async().add_done_callback(self.on_result)

    def on_result(self, future):
        if future.result().status == GoalStatus.STATUS_SUCCEEDED:
            self.get_logger().info(f'{future.result().result.distance} m')

    def on_counted(self, future):
        response = future.result()
        self.get_logger().info(f'{response.count.ripe} fruits')


def main():
    rclpy.init()
    node = Supervisor()
    try:
        rclpy.spin(node)
    finally:
        node.destroy_node()
        rclpy.shutdown()
