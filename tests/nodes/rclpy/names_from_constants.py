import rclpy
from rclpy.node import Node
from std_msgs.msg import String

NODE = 'names'
ROBOT = 'atlas'
ARM: str = "left"
INDEX = 3
BASE = f'/{ROBOT}'


class Topics:
    STATE = 'state'
    FULL = STATE + '/full'


class Names(Node):
    TOPIC = 'talk'

    def __init__(self):
        super().__init__(f'{NODE}_node')
        depth = 10
        tail = 'tail'
        self.a = self.create_publisher(String, BASE, depth)
        self.b = self.create_publisher(String, BASE + '/odom', depth)
        self.c = self.create_publisher(String, self.TOPIC, depth)
        self.d = self.create_publisher(String, Names.TOPIC, depth)
        self.e = self.create_publisher(String, Topics.STATE, depth)
        self.f = self.create_publisher(String, Topics.FULL, depth)
        self.g = self.create_publisher(String, '%s_arm' % ARM, depth)
        self.h = self.create_publisher(String, '{}/{}/{}'.format(ROBOT, INDEX, ARM), depth)
        self.i = self.create_publisher(String, f"{BASE}/{ARM}/{tail}", depth)
        self.j = self.create_publisher(String, 'one' '/two' f'/{ROBOT}', depth)
        self.k = self.create_publisher(String, '{name}'.format(name=ROBOT), depth)
        self.l = self.create_publisher(String, f'{{left}}', depth)
        self.m = self.create_publisher(String, f'{self.get_name()}/x', depth)
        self.n = self.create_publisher(String, self.get_namespace() + '/x', depth)


rclpy.init()
rclpy.spin(Names())
