"""Which line of a node a new endpoint comes behind, where its functions run at different times."""

from __future__ import annotations

import pytest
from edits import edit, edited, provide, publish, request, subscribe

ROSPY = "import rospy\nfrom std_msgs.msg import String\nfrom std_srvs.srv import Trigger\n\n\n"
RCLPY = "import rclpy\nfrom rclpy.node import Node\nfrom std_msgs.msg import String\n\n\n"

CLIENT_ON_DEMAND = (
    f"{ROSPY}class Arm:\n    def __init__(self):\n"
    "        rospy.Subscriber('angle', String, self.on_angle)\n"
    "        self.is_ready = True\n\n"
    "    def on_angle(self, msg):\n        pass\n\n"
    "    def home(self):\n"
    "        rospy.wait_for_service('home')\n"
    "        home = rospy.ServiceProxy('home', Trigger)\n"
    "        return home()\n\n\n"
    "rospy.init_node('arm')\nArm()\nrospy.spin()\n"
)
CLIENT_AT_ONCE = CLIENT_ON_DEMAND.replace(
    "        home = rospy.ServiceProxy('home', Trigger)\n        return home()\n",
    "        answer = rospy.ServiceProxy('home', Trigger)()\n        return answer\n",
)
SOMETIMES = (
    f"{ROSPY}class Room:\n    def __init__(self, doors=None):\n"
    "        self.pub_light = rospy.Publisher('light', String, queue_size=1)\n"
    "        if doors:\n            self.add_doors(doors)\n\n"
    "    def add_doors(self, doors):\n"
    "        for door in doors:\n"
    "            self.pubs[door] = rospy.Publisher(door, String, queue_size=1)\n\n\n"
    "rospy.init_node('room')\nroom = Room()\n"
)
SPLIT = (
    f"{ROSPY}class Room:\n    def __init__(self):\n"
    "        self.pub_light = rospy.Publisher('light', String, queue_size=1)\n"
    "        self.add_doors()\n\n"
    "    def add_doors(self):\n"
    "        self.pub_door = rospy.Publisher('door', String, queue_size=1)\n\n\n"
    "rospy.init_node('room')\nroom = Room()\n"
)
ASKED_TWICE = (
    f"{RCLPY}def once(node, topic):\n    found = []\n"
    "    sub = node.create_subscription(String, topic, found.append, 1)\n"
    "    rclpy.spin_once(node)\n    return found\n\n\n"
    "def main():\n    rclpy.init()\n    node = rclpy.create_node('scene')\n"
    "    print(once(node, 'a'), once(node, 'b'))\n"
)
TESTS = (
    f"{RCLPY}class TestMap:\n    def setUp(self):\n"
    "        self.node = rclpy.create_node('test_map')\n\n"
    "    def test_map(self):\n        seen = []\n"
    "        sub = self.node.create_subscription(String, 'map', seen.append, 1)\n"
    "        rclpy.spin_once(self.node)\n"
)
LIFECYCLE = (
    "import rclpy\nfrom rclpy.lifecycle import LifecycleNode\nfrom std_msgs.msg import String\n\n\n"
    "class Cell(LifecycleNode):\n    def on_configure(self, state):\n"
    "        self.sub = self.create_subscription(String, 'in', self.on_in, 10)\n"
    "        return super().on_configure(state)\n\n"
    "    def on_activate(self, state):\n"
    "        self.timer = self.create_timer(1.0, self.tick)\n"
    "        return super().on_activate(state)\n\n"
    "    def on_in(self, msg):\n        pass\n\n"
    "    def tick(self):\n        pass\n\n\n"
    "rclpy.init()\nrclpy.spin(Cell('cell'))\n"
)
ACTION_IN_CALLBACK = (
    f"{RCLPY}from nav2_msgs.action import Undock\nfrom rclpy.action import ActionClient\n\n\n"
    "class Dock(Node):\n    def __init__(self):\n        super().__init__('dock')\n"
    "        self.create_subscription(String, 'go', self.on_go, 10)\n\n"
    "    def on_go(self, msg):\n        self.undock()\n\n"
    "    def undock(self):\n"
    "        self.undocking = ActionClient(self, Undock, 'undock')\n"
    "        self.undocking.wait_for_server()\n\n\n"
    "rclpy.init()\nrclpy.spin(Dock())\n"
)
LOCAL_PARAMETERS = (
    f"{ROSPY}class Horn:\n    def __init__(self):\n        rospy.init_node('horn')\n"
    "        loud = rospy.get_param('~loud', 1.0)\n"
    "        rospy.Subscriber('blow', String, self.on_blow, loud)\n\n"
    "    def on_blow(self, msg, loud):\n        pass\n\n\nHorn()\n"
)
LOOP = (
    f"{ROSPY}class Legs:\n    def __init__(self, names):\n        self.legs = {{}}\n"
    "        for name in names:\n"
    "            pub = rospy.Publisher(name, String, queue_size=1)\n"
    "            self.legs[name] = pub\n"
    "        self.is_ready = True\n\n\nrospy.init_node('legs')\nLegs([])\n"
)
COMPREHENSIONS = (
    f"{ROSPY}def gains(ids):\n"
    "    proxies = [rospy.ServiceProxy('gain_%d' % i, Trigger) for i in ids]\n"
    "    [proxy() for proxy in proxies]\n\n\n"
    "class Legs:\n    def __init__(self, names):\n        rospy.init_node('legs')\n"
    "        self.legs = [rospy.Publisher(name, String, queue_size=1) for name in names]\n"
    "        self.is_ready = True\n\n\nLegs([])\n"
)
CONNECTED_LATER = (
    f"{ROSPY}class Truck:\n    def __init__(self):\n        rospy.init_node('truck')\n"
    "        self.pub_fork = rospy.Publisher('fork', String, queue_size=1)\n"
    "        Thread(target=self.connect).start()\n\n"
    "    def connect(self):\n        try:\n"
    "            rospy.wait_for_service('scan', timeout=1.0)\n"
    "            self.scan = rospy.ServiceProxy('scan', Trigger)\n"
    "        except rospy.ROSException:\n            pass\n\n\nTruck()\n"
)
CONNECTED_IN_A_LIBRARY = (
    f"{ROSPY}class Truck:\n    def initialize(self):\n"
    "        self.scan = rospy.ServiceProxy('scan', Trigger)\n\n"
    "    def ask(self):\n        scan = rospy.ServiceProxy('scan', Trigger)\n"
    "        return scan()\n"
)

WHEN_ASKED = (
    f"{ROSPY}class Wrench(Transport):\n    def __init__(self):\n"
    "        super(Wrench, self).__init__()\n        self.frame = rospy.get_param('~frame')\n\n"
    "    def subscribe(self):\n"
    "        self.sub = rospy.Subscriber('in', String, self.on_in)\n\n"
    "    def on_in(self, msg):\n        pass\n\n\n"
    "if __name__ == '__main__':\n    rospy.init_node('wrench')\n    Wrench()\n    rospy.spin()\n"
)
ACTION_WHEN_ASKED = (
    f"{RCLPY}from rclpy.action import ActionClient\n\n\nclass Actions(Node):\n"
    "    def __init__(self, bus):\n        super().__init__('actions')\n        self.bus = bus\n\n"
    "    def send_goal(self, name, type_):\n"
    "        self.clients[name] = ActionClient(self, type_, name)\n"
)
LENT = (
    f"{RCLPY}class Helper:\n    def __init__(self, node):\n        self.node = node\n\n"
    "    def listen(self, topic):\n"
    "        self.sub = self.node.create_subscription(String, topic, self.on_it, 1)\n\n"
    "    def on_it(self, msg):\n        pass\n"
)
SPINS_ITSELF = (
    f"{ROSPY}class Arm:\n    def __init__(self):\n        self.n = 1\n"
    "        rospy.spin()\n\n"
    "    def reach(self):\n        self.pub = rospy.Publisher('a', String, queue_size=1)\n\n\n"
    "rospy.init_node('arm')\nArm()\n"
)
SET_UP = (
    f"{ROSPY}class Arm:\n    def __init__(self):\n        self.n = 1\n\n"
    "    def setup_ros(self):\n        self.pub = rospy.Publisher('a', String, queue_size=1)\n"
)
MADE_FOR_EACH = (
    f"{ROSPY}class Leg:\n    def __init__(self, name):\n"
    "        self.pub = rospy.Publisher(name, String, queue_size=1)\n\n\n"
    "rospy.init_node('legs')\nlegs = [Leg(name) for name in ('a', 'b')]\nrospy.spin()\n"
)
TWO_BASES = (
    f"{RCLPY}class Arm(Node, Base):\n    def __init__(self):\n        Node.__init__(self, 'arm')\n"
    "        self.n = 1\n        Base.__init__(self)\n        self.m = 1\n\n\n"
    "rclpy.init()\nrclpy.spin(Arm())\n"
)
TWO_BASES_ROSPY = (
    f"{ROSPY}class Arm(Base):\n    def __init__(self):\n        rospy.init_node('arm')\n"
    "        super().__init__()\n        self.m = 1\n\n\nArm()\nrospy.spin()\n"
)
MAIN_ASKS = (
    f"{ROSPY}class Arm:\n    def __init__(self):\n        # Topics & Subscriptions\n"
    "        self.pub = rospy.Publisher('at', String, queue_size=1)\n\n\n"
    "def main():\n    rospy.init_node('arm')\n    Arm()\n"
    "    home = rospy.ServiceProxy('home', Trigger)\n    home()\n    rospy.spin()\n\n\nmain()\n"
)
EARLY = (
    f"{ROSPY}def main():\n    pub = rospy.Publisher('at', String, queue_size=1)\n"
    "    rospy.init_node('arm')\n    rospy.spin()\n\n\nmain()\n"
)
AMONG_OTHERS = (
    f"{RCLPY}class Arm(Node):\n    def __init__(self):\n        super().__init__('arm')\n"
    "        self.at = self.create_publisher(String, 'at', 10)\n"
    "        self.to = self.create_publisher(String, 'to', 10)\n        self.n = 1\n"
)
PLACES = {
    "what sends through a publisher that is made before the node, behind the node": (
        EARLY,
        publish("at", rate=2.0, data="x"),
        "    rospy.init_node('arm')\n\n    def publish_at(event):\n",
    ),
    "what sends through one of several publishers, behind them": (
        AMONG_OTHERS,
        publish("at", rate=2.0, data="x"),
        "'to', 10)\n        self.create_timer(0.5, self.publish_at)\n",
    ),
    "a client that is called, in the class rather than in another function": (
        MAIN_ASKS,
        request("ask", "std_srvs/Trigger"),
        "\n        self.ask_client = rospy.ServiceProxy('ask', Trigger)\n"
        "        rospy.Timer(rospy.Duration(0.1), self.call_ask, oneshot=True)\n\n    def call_ask",
    ),
    "behind what sets up the last base class": (
        TWO_BASES,
        publish("out"),
        "Base.__init__(self)\n        self.out_pub = self.create_publisher(String, 'out', 10)\n",
    ),
    "behind the node and what sets up the base class": (
        TWO_BASES_ROSPY,
        publish("out"),
        "__init__()\n        self.out_pub = rospy.Publisher('out', String, queue_size=10)\n",
    ),
    "where an object is made that subscribes when asked": (
        WHEN_ASKED,
        publish("out"),
        "get_param('~frame')\n"
        "        self.out_pub = rospy.Publisher('out', String, queue_size=10)\n",
    ),
    "where a node is made that sends goals when asked": (
        ACTION_WHEN_ASKED,
        publish("out"),
        "__init__('actions')\n        self.out_pub = self.create_publisher(String, 'out', 10)\n",
    ),
    "where an object gets its node": (
        LENT,
        publish("out"),
        '= node\n        self.out_pub = self.node.create_publisher(String, "out", 10)\n',
    ),
    "where an object is made, before it spins": (
        SPINS_ITSELF,
        publish("out"),
        "self.n = 1\n        self.out_pub = rospy.Publisher('out', String, queue_size=1)\n",
    ),
    "where a node sets up what it has": (
        SET_UP,
        publish("out"),
        "        self.pub = rospy.Publisher('a', String, queue_size=1)\n"
        "        self.out_pub = rospy.Publisher('out', String, queue_size=1)\n",
    ),
    "behind the node, not in what is made for each of some names": (
        MADE_FOR_EACH,
        publish("out"),
        "init_node('legs')\nout_pub = rospy.Publisher('out', String, queue_size=1)\n",
    ),
    "a service, not beside a client on demand": (
        CLIENT_ON_DEMAND,
        provide("stop"),
        "        rospy.Subscriber('angle', String, self.on_angle)\n"
        "        rospy.Service('stop', Trigger, self.handle_stop)\n",
    ),
    "a client, not beside a client on demand": (
        CLIENT_ON_DEMAND,
        request("ask", "std_srvs/Trigger"),
        "        rospy.Subscriber('angle', String, self.on_angle)\n"
        "        self.ask_client = rospy.ServiceProxy('ask', Trigger)\n",
    ),
    "a publisher, not beside a client that is called at once": (
        CLIENT_AT_ONCE,
        publish("out"),
        "        rospy.Subscriber('angle', String, self.on_angle)\n"
        "        self.out_pub = rospy.Publisher('out', String, queue_size=10)\n",
    ),
    "beside its like that is always made": (
        SOMETIMES,
        publish("out"),
        "        self.pub_light = rospy.Publisher('light', String, queue_size=1)\n"
        "        self.pub_out = rospy.Publisher('out', String, queue_size=1)\n",
    ),
    "beside the last of its like, in a method of the constructor": (
        SPLIT,
        publish("out"),
        "        self.pub_door = rospy.Publisher('door', String, queue_size=1)\n"
        "        self.pub_out = rospy.Publisher('out', String, queue_size=1)\n",
    ),
    "behind the node, not in a function that is called again": (
        ASKED_TWICE,
        subscribe("in"),
        "    node = rclpy.create_node('scene')\n"
        "    node.create_subscription(String, 'in', on_in, 1)\n",
    ),
    "behind the node, not in one of its tests": (
        TESTS,
        subscribe("in"),
        "        self.node = rclpy.create_node('test_map')\n"
        "        self.in_sub = self.node.create_subscription(String, 'in', self.on_in, 1)\n",
    ),
    "where a lifecycle node is configured, not where it is activated": (
        LIFECYCLE,
        provide("stop"),
        "        self.sub = self.create_subscription(String, 'in', self.on_in, 10)\n"
        "        self.stop_srv = self.create_service(Trigger, 'stop', self.handle_stop)\n",
    ),
    "not where a callback makes an action's client": (
        ACTION_IN_CALLBACK,
        provide("stop"),
        "        self.create_subscription(String, 'go', self.on_go, 10)\n"
        "        self.stop_service = self.create_service(Trigger, 'stop', self.handle_stop)\n",
    ),
    "an attribute, whatever parameters are called": (
        LOCAL_PARAMETERS,
        publish("out"),
        "        rospy.Subscriber('blow', String, self.on_blow, loud)\n"
        "        self.out_pub = rospy.Publisher('out', String, queue_size=10)\n",
    ),
    "behind a loop, and held by the object": (
        LOOP,
        publish("out"),
        "            self.legs[name] = pub\n"
        "        self.out_pub = rospy.Publisher('out', String, queue_size=1)\n",
    ),
    "behind a comprehension": (
        COMPREHENSIONS,
        publish("out"),
        "for name in names]\n        self.out_pub = rospy.Publisher('out', String, queue_size=1)\n",
    ),
    "not beside clients that a function makes to call them": (
        COMPREHENSIONS,
        request("ask", "std_srvs/Trigger"),
        "for name in names]\n        self.ask_client = rospy.ServiceProxy('ask', Trigger)\n",
    ),
    "not where a client may give up": (
        CONNECTED_LATER,
        request("ask", "std_srvs/Trigger"),
        "        self.pub_fork = rospy.Publisher('fork', String, queue_size=1)\n"
        "        self.client_ask = rospy.ServiceProxy('ask', Trigger)\n",
    ),
    "beside a client that is kept, where there is nothing else": (
        CONNECTED_IN_A_LIBRARY,
        request("ask", "std_srvs/Trigger"),
        "        self.scan = rospy.ServiceProxy('scan', Trigger)\n"
        "        self.ask_client = rospy.ServiceProxy('ask', Trigger)\n",
    ),
}


@pytest.mark.parametrize("case", PLACES)
def test_places(case):
    before, change, expected = PLACES[case]
    assert expected in edited(before, change)


NO_PLACES = {
    "a client that a function makes for one call": (
        f"{RCLPY}def call(node, name):\n    client = node.create_client(Trigger, name)\n"
        "    return client.call(Trigger.Request())\n"
    ),
    "a timer that a function waits for": (
        f"{RCLPY}def sleep(node, seconds):\n    timer = node.create_timer(seconds, print)\n"
        "    rclpy.spin_once(node)\n    timer.cancel()\n"
    ),
    "a function that makes an endpoint for who calls it": (
        f"{ROSPY}def listen(topic, callback):\n"
        "    return rospy.Subscriber(topic, String, callback)\n"
    ),
    "an attribute that makes its endpoint when it is read": (
        f"{RCLPY}class Plugin(Base):\n    @cached_property\n    def pub(self):\n"
        "        self._pub = self.create_publisher(String, 'a', 10)\n        return self._pub\n"
    ),
    "a line that goes on for as long as the node": (
        "import rclpy\nfrom rclpy.node import Node\n\n\n"
        "def main():\n    rclpy.init(); node = Node('a'); rclpy.spin(node)\n"
    ),
    "a callback": (
        f"{ROSPY}def on_name(msg):\n    pub = rospy.Publisher(msg.data, String, queue_size=1)\n\n\n"
        "def listen(name):\n    return rospy.wait_for_message(name, String)\n"
    ),
}


@pytest.mark.parametrize("case", NO_PLACES)
@pytest.mark.parametrize("change", [publish("out"), subscribe("in"), provide("stop")])
def test_nothing_is_created_at_every_call(case, change):
    (found,) = edit(NO_PLACES[case], change).diagnostics
    assert found.code == "edit-refused"
    assert "once, as it starts" in found.message
