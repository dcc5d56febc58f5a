import rclpy
from rclpy.node import Node
from std_msgs.msg import Int8, String

TOPIC = 'module'
OTHER = 'other'
LOOP = 'loop'


class Scopes(Node):
    TOPIC = 'class'

    def __init__(self):
        super().__init__('scopes')
        a = self.create_publisher(String, TOPIC, 1)
        b = self.create_publisher(String, self.TOPIC, 1)
        OTHER = 'local'
        c = self.create_publisher(String, OTHER, 1)
        d = [self.create_publisher(String, LOOP, 1) for LOOP in 'xyz']
        e = self.create_publisher(String, LOOP, 1)
        f = lambda TOPIC: self.create_publisher(String, TOPIC, 1)

    def shadow(self):
        from example_interfaces.msg import String
        return self.create_publisher(String, OTHER, 1)

    def fallback(self, topic=None, name=OTHER):
        topic = topic or 'fallback'
        self.create_publisher(String, topic, 1)
        self.create_publisher(String, name, 1)

    def given(self, topic=None):
        if topic is None:
            topic = 'given'
        kind = String if topic else Int8
        self.create_publisher(kind, topic, 1)


def main():
    rclpy.init()
    node = Scopes()
    node.given('taken')
    match node.get_name().split('_'):
        case [OTHER, *_]:
            node.create_publisher(String, OTHER, 1)
    while (LOOP := input()):
        node.create_publisher(String, LOOP, 1)
