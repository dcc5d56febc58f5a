"""The imports of a file that gives up a type and needs it again stay as they were."""

from __future__ import annotations

import re

import pytest
from edits import AT, CLI, SUB, edited, publish, subscribe

from plastron_tui.model.kinds import Client
from plastron_tui.model.source import Add, Remove
from plastron_tui.ros.interfaces import InterfaceName

BODY = """
rospy.init_node('n')
rospy.Subscriber('old', Bool, print)
rospy.Publisher('other', Float32, queue_size=1)
"""
IMPORTS = [
    "import rospy\nfrom std_msgs.msg import Bool, Float32\n",
    "import rospy\nfrom std_msgs.msg import (\n    Bool,\n    Float32,\n)\n",
    "import rospy\nfrom std_msgs.msg import Float32, Bool  # what it hears\n",
    "import rospy\nfrom std_msgs.msg import Bool\nfrom geometry_msgs.msg import Point as Float32\n",
]


@pytest.mark.parametrize("imports", IMPORTS)
def test_the_imports_stay(imports: str) -> None:
    changes = (Remove(SUB, "old", AT), subscribe("new", "std_msgs/Bool", "hear"))
    text = edited(imports + BODY, *changes)
    assert text.startswith(imports + "\n")


def test_names_that_are_new_come_behind() -> None:
    changes = (
        Remove(SUB, "old", AT),
        subscribe("new", "std_msgs/Bool", "hear"),
        publish("said", "std_msgs/String"),
    )
    text = edited(IMPORTS[0] + BODY, *changes)
    assert text.startswith("import rospy\nfrom std_msgs.msg import Bool, Float32, String\n\n")


def test_two_lines_of_one_module_may_become_one() -> None:
    imports = "import rospy\nfrom std_msgs.msg import Bool\nfrom std_msgs.msg import Float32\n"
    changes = (Remove(SUB, "old", AT), subscribe("new", "std_msgs/Bool", "hear"))
    text = edited(imports + BODY, *changes)
    assert text.startswith("import rospy\nfrom std_msgs.msg import Bool, Float32\n\n")


def test_a_name_that_is_not_needed_again_goes() -> None:
    text = edited(IMPORTS[0] + BODY, Remove(SUB, "old", AT))
    assert text.startswith("import rospy\nfrom std_msgs.msg import Float32\n\n")


UNDER_TRY = """import logging
try:
    import rospy
    from std_msgs.msg import Bool
except ImportError:
    rospy = None
    Bool = None
rospy.init_node('n')
rospy.Subscriber('old', Bool, print)
"""


def test_an_import_that_may_fail_stays_with_the_others() -> None:
    text = edited(UNDER_TRY, subscribe("new", "geometry_msgs/Point", "hear"))
    assert "    import rospy\n    from geometry_msgs.msg import Point\n    from std" in text


def test_an_import_that_may_fail_goes_again_but_not_where_its_name_is_bound_otherwise() -> None:
    change = Add(Client("new", InterfaceName("std_srvs", "Empty"), [], AT))
    assert edited(edited(UNDER_TRY, change), Remove(CLI, "new", AT)) == UNDER_TRY
    assert "import Bool\n" in edited(UNDER_TRY, Remove(SUB, "old", AT))


def test_a_name_that_is_none_without_ros_is_the_type() -> None:
    text = edited(UNDER_TRY, subscribe("new", "std_msgs/Bool"))
    assert text.startswith(UNDER_TRY[: UNDER_TRY.index("except")])
    assert text.endswith("print)\nrospy.Subscriber('new', Bool, on_new)\n")


CLASS_IN_FUNCTION = """import logging


def main():
    import rclpy
    from rclpy.node import Node
    from std_msgs.msg import Bool

    class Lamp(Node):
        def __init__(self):
            super().__init__('lamp')
            self.pub = self.create_publisher(Bool, 'on', 10)

    rclpy.init()
    rclpy.spin(Lamp())


main()
"""


def test_a_class_in_a_function_sees_what_the_function_imports() -> None:
    text = edited(CLASS_IN_FUNCTION, publish("at", "geometry_msgs/Point", x=1.0))
    start = "import logging\n\n\ndef main():\n    from geometry_msgs.msg import Point\n"
    assert text.startswith(f"{start}    import rclpy\n    from rclpy.node")
    assert text.count("import Point") == 1


def test_what_a_method_imports_its_callbacks_do_not_see() -> None:
    text = edited(
        "class Lamp:\n    def __init__(self):\n        import rclpy\n"
        "        from std_msgs.msg import Bool\n"
        "        self.node = rclpy.create_node('lamp')\n"
        "        self.pub = self.node.create_publisher(Bool, 'on', 10)\n",
        publish("at", "geometry_msgs/Point", x=1.0),
    )
    assert text.startswith("from geometry_msgs.msg import Point\n")
    assert text.count("import Point") == 1


ORDERS = {
    "plain imports first": (
        "import math\n\nimport rospy\nfrom geometry_msgs.msg import Point\nfrom tf import x\n",
        "import math\n\nimport rospy\nfrom geometry_msgs.msg import Point\n"
        "from std_msgs.msg import String\nfrom tf import x\n",
    ),
    "by the modules alone": (
        "from geometry_msgs.msg import Point\nimport rospy\nimport tf\nfrom turtle import x\n",
        "from geometry_msgs.msg import Point\nimport rospy\n"
        "from std_msgs.msg import String\nimport tf\nfrom turtle import x\n",
    ),
    "the library's group": (
        "import rospy\nimport yaml\n\nimport mine\n",
        "import rospy\nimport yaml\nfrom std_msgs.msg import String\n\nimport mine\n",
    ),
    "no order": (
        "import rospy\nfrom tf.msg import a\nfrom geometry_msgs.msg import Point\nimport tf\n",
        "import rospy\nfrom tf.msg import a\nfrom geometry_msgs.msg import Point\n"
        "from std_msgs.msg import String\nimport tf\n",
    ),
    "names that sort": (
        "import rospy\nfrom std_msgs.msg import Bool, Float32, UInt8\n",
        "import rospy\nfrom std_msgs.msg import Bool, Float32, String, UInt8\n",
    ),
    "names on lines that sort": (
        "import rospy\nfrom std_msgs.msg import (\n    UInt8,\n    UInt16,\n)\n",
        "import rospy\nfrom std_msgs.msg import (\n    String,\n    UInt8,\n    UInt16,\n)\n",
    ),
    "names below each other": (
        "import rospy\nfrom std_msgs.msg import (Bool,\n                          UInt8)\n",
        "import rospy\nfrom std_msgs.msg import (Bool,\n                          String,\n"
        "                          UInt8)\n",
    ),
    "the first below each other": (
        "import rospy\nfrom std_msgs.msg import (UInt8,\n                          UInt16)\n",
        "import rospy\nfrom std_msgs.msg import (String,\n                          UInt8,\n"
        "                          UInt16)\n",
    ),
    "what only a checker of types imports": (
        "import rospy\n\nif TYPE_CHECKING:\n    from std_msgs.msg import String\n",
        "import rospy\nfrom std_msgs.msg import String\n\nif TYPE_CHECKING:\n"
        "    from std_msgs.msg import String\n",
    ),
    "names that do not sort": (
        "import rospy\nfrom std_msgs.msg import UInt8, Bool\n",
        "import rospy\nfrom std_msgs.msg import UInt8, Bool, String\n",
    ),
    "a line each": (
        "import rospy\nfrom std_msgs.msg import Bool\nfrom std_msgs.msg import Float32\n",
        "import rospy\nfrom std_msgs.msg import Bool\nfrom std_msgs.msg import Float32\n"
        "from std_msgs.msg import String\n",
    ),
    "whole modules": (
        "import rospy\nimport geometry_msgs.msg\nimport tf\n",
        "import rospy\nimport geometry_msgs.msg\nimport std_msgs.msg\nimport tf\n",
    ),
}


@pytest.mark.parametrize("order", ORDERS)
def test_an_import_goes_where_it_sorts(order: str) -> None:
    before, after = ORDERS[order]
    main = "def hear(message):\n    pass\n\n\nrospy.init_node('n')\nrospy.spin()\n"
    text = edited(f"{before}\n{main}", subscribe("text", callback="hear"))
    assert text.startswith(f"{after}\n")


_POINT = "from geometry_msgs.msg import Point\n"
BOTH_ORDERS = {
    # The style of ROS 2, which ament_flake8 checks, has single quotes, and modules in one order.
    "single quotes": ("'", f"{_POINT}import rclpy\nfrom rclpy.node import Node\n"),
    "double quotes": ('"', f"import rclpy\n{_POINT}from rclpy.node import Node\n"),
}


@pytest.mark.parametrize(("quote", "after"), BOTH_ORDERS.values(), ids=BOTH_ORDERS)
def test_quotes_tell_the_order_where_two_fit(quote: str, after: str) -> None:
    before = "import rclpy\nfrom rclpy.node import Node\n"
    main = (
        "\n\ndef hear(message):\n    pass\n\n\nrclpy.init()\nnode = Node('n')\nrclpy.spin(node)\n"
    )
    main = main.replace("'", quote)
    text = edited(before + main, subscribe("at", "geometry_msgs/Point", "hear"))
    assert text.startswith(f"{after}\n\ndef")


# Where `from std_msgs.msg import String` goes: at the `>`; Twist at the `<`.
GROUPS = {
    "among the messages, not in the library's group above": (
        "# ROS\nimport rospy\nimport tf\n\n# Messages\nfrom nav_msgs.msg import Path\n"
        "from geometry_msgs.msg import Twist\n>\n# Mine\nfrom rover_msgs.msg import Wheel\n"
    ),
    "among those that come with ROS, of one group below another": (
        "import rospy\n\nfrom nav_msgs.msg import Path\n>\nfrom rover_msgs.msg import Arm, Wheel\n"
        "from rover_msgs.srv import Stop\n"
    ),
    "with its package, among those of one kind": (
        "import rospy\nfrom geometry_msgs.msg import Twist\nfrom nav_msgs.msg import Path\n\n"
        "from std_srvs.srv import Empty\n\nfrom std_msgs.msg import Bool\n"
        "from std_msgs.msg import Int8\n>"
    ),
    "with messages, not with services": (
        "import rospy\n\n# Services\nfrom std_srvs.srv import Empty\n"
        "from nav_msgs.srv import GetPlan\n\n# Messages\nfrom nav_msgs.msg import Path\n>"
    ),
    "beside the library alone, not with what is of nobody": (
        "import os\n\nimport rospy\n>\nimport numpy as np\nfrom rover import wheels\n"
    ),
    "beside the library, in no order": (
        "import sys\nimport os\nimport rospy\n>\nimport numpy as np\nimport cv2\n"
    ),
    "in a group of its own, where each package has one": (
        "import math\n\nfrom nav_msgs.msg import Path\n\nimport rclpy\n"
        "from rclpy.node import Node\n>\nfrom tf2_msgs.msg import TFMessage\n"
    ),
    "in a group of its own, behind the library": (
        "from nav_msgs.msg import Path\n\nimport rclpy\nfrom rclpy.node import Node\n>"
    ),
    "in a group of its own, before all": (
        "import math\n\n<import rclpy\n\nfrom std_msgs.msg import String\n"
    ),
    "in the group behind the library": (
        "import rclpy\nfrom rclpy.node import Node\n\nfrom nav_msgs.msg import Path\n>"
    ),
    "in the group behind the library, before another": (
        "from geometry_msgs.msg import Twist\nfrom nav_msgs.msg import Path\n\nimport rclpy\n\n"
        ">from tf2_msgs.msg import TFMessage\nfrom turtle_msgs.msg import Pose\n"
    ),
    "in a group of its own, where each package has one, its message alone": (
        "import rclpy\nfrom rclpy.node import Node\n\nfrom sensor_msgs.msg import Imu\n>\n"
        "import yaml\n"
    ),
    "where its name sorts, a line each": (
        "import rospy\nfrom nav_msgs.msg import Path\nfrom std_msgs.msg import Bool\n"
        ">from std_msgs.msg import StringX\n"
    ),
    "behind its package, in no order": (
        "import rospy\nfrom std_msgs.msg import Int8\nfrom std_msgs.msg import Bool\n>"
        "from nav_msgs.msg import Path\nfrom tf import x\nimport sys\n"
    ),
    "not behind what a file imports late": (
        "import rospy\nimport numpy\n>\n\ndef sub():\n    pass\n\n\nfrom nav_msgs.msg import Path\n"
    ),
}


@pytest.mark.parametrize("groups", GROUPS)
def test_an_import_goes_to_its_group(groups: str) -> None:
    before, mark, after = re.split("([<>])", GROUPS[groups])
    package, name = ("std_msgs", "String") if mark == ">" else ("geometry_msgs", "Twist")
    own = f"from {package}.msg import {name}\n"
    if "of its own" in groups:
        own = own + "\n" if before.endswith("\n\n") else "\n" + own
    main = "\n\ndef hear(message):\n    pass\n\n\nrospy.init_node('n')\nrospy.spin()\n"
    if "rclpy" in GROUPS[groups]:
        main = main.replace("rospy.init_node", "node = rclpy.create_node")
    text = edited(before + after + main, subscribe("text", f"{package}/{name}", "hear"))
    assert text.startswith(before + own + after + "\n\ndef")
