"""Classes inside of types are no types: they have no name that another program could use."""
import rclpy
from nav2_msgs.action import NavigateToPose
from rclpy.node import Node
from std_msgs.msg._string import String as Text
from std_srvs.srv import SetBool


class FakeNavigation(Node):
    def __init__(self):
        super().__init__('fake_navigation')
        self.feedback = self.create_publisher(
            NavigateToPose.Impl.FeedbackMessage, 'navigate_to_pose/_action/feedback', 10)
        self.wishes = self.create_subscription(SetBool.Request, 'wishes', self.on_wish, 10)
        self.text = self.create_publisher(Text, 'text', 10)

    def on_wish(self, request):
        self.feedback.publish(NavigateToPose.Impl.FeedbackMessage())


rclpy.init()
rclpy.spin(FakeNavigation())
