"""Parameters that nodes use and never declare, in Python and in C++."""

from __future__ import annotations

from pathlib import Path

import pytest
from parameter_packages import cpp, marked, python, told

UNDECLARED = {
    "a name where an error is handled": python("""
        try:
            self.read()
        except ValueError:
            self.get_parameter('rate')  # wrong
    """),
    "a name with a slip": python("""
        self.declare_parameter('rate', 1.0)
        self.rate = self.get_parameter('rat').value  # wrong
    """),
    "a name that is declared nowhere": python("self.get_parameter('rate')  # wrong"),
    "one of several": python("""
        self.declare_parameters('', [('a_rate', 1.0), ('b_rate', 2.0)])
        self.get_parameters(['a_rate', 'rates'])  # wrong
    """),
    "a name in a namespace": python("""
        self.declare_parameters('pid', [('p', 1.0)])
        self.get_parameter('p')  # wrong
    """),
    "a parameter that is set": python("""
        self.declare_parameter('rate', 1.0)
        self.set_parameters([Parameter('speed', Parameter.Type.DOUBLE, 1.0)])  # wrong
    """),
    "another name of the method": python("""
        declare = self.declare_parameter
        declare('rate', 1.0)
        self.get_parameter('rate')
        self.get_parameter('speed')  # wrong
    """),
    "a loop": python("""
        for name, value in [('rate', 1.0), ('speed', 2.0)]:
            self.declare_parameter(name, value)
        self.get_parameter('rate')
        self.get_parameter('gain')  # wrong
    """),
    "a slip where any error is caught": python("""
        self.declare_parameter('rate', 1.0)
        try:
            self.rate = float(self.get_parameter('raet').value)  # wrong
        except ValueError:
            pass
    """),
    "a slip where other code may declare": python("""
        import tools
        tools.declare_more(self)
        self.declare_parameter('speed_limit', 1.0)
        self.get_parameter('speed_limt')  # wrong
    """),
    "another value": python("self.get_parameter_or('rate', Parameter('rate', value=1.0))  # wrong"),
    "a variable of C++": cpp('get_parameter("rate", rate_);  // wrong'),
    "another value of C++": cpp('get_parameter_or("rate", rate_, 1.0);  // wrong'),
    "a node of C++": cpp("""
        declare_parameter("rate", 1.0);
        get_parameter("rat").as_double();  // wrong
    """),
    "a node of C++ that others listen with": cpp(
        """
        this->declare_parameter<double>("rate", 1.0);
        listener_ = std::make_shared<tf2_ros::TransformListener>(*buffer_, this);
        timer_ = create_wall_timer(period_, std::bind(&Driver::tick, this));
        double rate = this->get_parameter("speed").as_double();  // wrong
        """,
        more="  void tick() {}",
    ),
    "a node of Nav2": cpp(
        """
        nav2_util::declare_parameter_if_not_declared(this, "rate", rclcpp::ParameterValue(1.0));
        get_parameter("speed");  // wrong
        """,
        base="nav2_util::LifecycleNode",
    ),
    "a managed node": cpp(
        """
        declare_parameter("rate", 1.0);
        get_parameter("speed");  // wrong
        """,
        base="rclcpp_lifecycle::LifecycleNode",
    ),
}


def _files(text: str) -> dict[str, str]:
    return {"driver.cpp" if "#include" in text else "driver.py": text}


@pytest.mark.parametrize("text", UNDECLARED.values(), ids=UNDECLARED)
def test_use_of_what_is_never_declared_is_told(tmp_path: Path, text: str) -> None:
    assert told(tmp_path, _files(text), "RP304") == marked({"": text})


MEANT = {
    "what every node has": python("self.get_parameter('use_sim_time')"),
    "what is asked for before": python("""
        if self.has_parameter('rate'):
            self.get_parameter('rate')
    """),
    "what is caught": python("""
        try:
            self.get_parameter('rate')
        except Exception:
            pass
    """),
    "undeclared parameters that are allowed": python(
        "self.get_parameter('rate')", handed=", allow_undeclared_parameters=True"
    ),
    "parameters that are declared by themselves": python(
        "self.get_parameter('rate')",
        handed=", automatically_declare_parameters_from_overrides=True",
    ),
    "code that gets the node": python("""
        import tools
        tools.declare_more(self)
        self.get_parameter('rate')
    """),
    "a base class that is not read": python("self.get_parameter('rate')").replace(
        "rclpy.node import Node", "tools import Node"
    ),
    "a name that is computed": python("""
        for each in self.names:
            self.declare_parameter(each, 1.0)
        self.get_parameter('rate')
    """),
    "a name of a function that declares": python("""
        declare = self.declare_parameter
        for each in self.names:
            declare(each, 1.0)
        self.get_parameter('rate')
    """),
    "a variable of C++, and whether it is set": cpp("""
        if (!get_parameter("rate", rate_)) {
          rate_ = 1.0;
        }
    """),
    "a helper of C++ that declares": cpp("""
        nav2_util::declare_parameter_if_not_declared(this, "rate", rclcpp::ParameterValue(1.0));
        declare_or_get_parameter("speed", 1.0);
        get_parameter("rate");
        get_parameter("speed");
    """),
    "a helper of C++ that is not known": cpp("""
        tools::declare_all(this);
        get_parameter("rate");
    """),
    "a class of C++ that gets the node": cpp("""
        loader_ = std::make_unique<tools::Loader>(this);
        get_parameter("rate");
    """),
    "a variable of C++ that looks like a function": cpp("""
        auto node = shared_from_this();
        tools::Loader loader(node);
        get_parameter("rate");
    """),
    "a base class of C++ that is not read": cpp('get_parameter("rate");', base="tools::Node"),
}


@pytest.mark.parametrize("text", MEANT.values(), ids=MEANT)
def test_what_may_be_declared_is_not_told(tmp_path: Path, text: str) -> None:
    assert told(tmp_path, _files(text), "RP304") == []


def test_class_that_another_file_derives_from_is_read_with_that(tmp_path: Path) -> None:
    base = python("self.rate = self.get_parameter('rate')").replace("Driver", "Base")
    heir = python("self.declare_parameter('rate', 1.0)").replace("(Node)", "(Base)")
    heir = heir.replace("from rclpy.node import Node", "from base import Base")
    assert told(tmp_path, {"base.py": base, "driver.py": heir}, "RP304") == []


@pytest.mark.parametrize(
    ("helper", "is_told"),
    [
        ("def load(node):\n    node.declare_parameter('rate', 1.0)\n", False),
        ("from more import more\n\ndef load(node):\n    more(node)\n", False),
        ("from more import *\n\ndef load(node):\n    more(node)\n", False),
        ("def load(node):\n    node.get_logger().info('loaded')\n", True),
    ],
)
def test_helper_of_another_file_may_declare(tmp_path: Path, helper: str, is_told: bool) -> None:
    node = python("load(self)\nself.get_parameter('rate')  # wrong")
    files = {
        "driver.py": f"from helper import load\n{node}",
        "helper.py": helper,
        "more.py": "def more(node):\n    node.declare_parameter('rate', 1.0)\n",
    }
    assert told(tmp_path, files, "RP304") == (marked(files) if is_told else [])


@pytest.mark.parametrize("allowed", ["", ", allow_undeclared_parameters=True"])
@pytest.mark.parametrize("module", ["base", "middle"])
def test_base_class_of_another_file_may_allow_more(
    tmp_path: Path, module: str, allowed: str
) -> None:
    base = (
        "from rclpy.node import Node\n\nclass Base(Node):\n    def __init__(self):\n"
        "        self.rate = 1.0\n\n    def main(self, name):\n"
        f"        super().__init__(name{allowed})\n"
    )
    heir = python("pass").replace("(Node)", "(Base)")
    heir = heir.replace("from rclpy.node import Node", f"from {module} import Base")
    heir = heir.replace("super().__init__('driver')", "Base.__init__(self)")
    heir = heir.replace(
        "pass", "Base.main(self, 'driver')\n        self.get_parameter('rate')  # wrong"
    )
    files = {"base.py": base, "middle.py": "from base import Base\n", "driver.py": heir}
    assert told(tmp_path, files, "RP304") == ([] if allowed else marked(files))


@pytest.mark.parametrize(("holder", "is_told"), [("_own", True), ("_given", False)])
def test_node_that_an_object_was_given_is_another(
    tmp_path: Path, holder: str, is_told: bool
) -> None:
    text = f"""\
import rclpy

from rclpy.node import Node

class Driver(Node):
    def __init__(self):
        super().__init__('driver')
        self.declare_parameter('speed', 1.0)
        self.backend = Backend(node=self)

class Backend:
    def __init__(self, node: Node):
        self._given = node
        self._own = rclpy.create_node('backend')
        self.{holder}.get_parameter('speed')  # wrong
"""
    found = told(tmp_path, _files(text), "RP304")
    assert found == (marked({"": text}) if is_told else [])
