"""What the rules of packages tell of a workspace that is changed in one place."""

from __future__ import annotations

from pathlib import Path

import pytest
from packages import CATKIN, CATKIN_LISTS, CMAKE, PYTHON, WORKSPACE, Break, found_in, told_of

from plastron_tui.lint.rules.package_examples import package_xml

_DEPEND = "  <depend>geometry_msgs</depend>\n"
_EXEC = "  <exec_depend>geometry_msgs</exec_depend>\n"


def _other(name: str, *needed: str) -> dict[str, str]:
    """Return a package without code."""
    lines = [f"<depend>{each}</depend>" for each in needed]
    return {
        f"{name}/package.xml": package_xml(name, *lines, build_type="ament_cmake"),
        f"{name}/CMakeLists.txt": f"project({name})\nfind_package(ament_cmake REQUIRED)\n",
    }


_ALL = CMAKE["rover/package.xml"].replace(_DEPEND, f"{_DEPEND}  <depend>all_msgs</depend>\n")
_STD_SRVS = {
    "rover/package.xml": CMAKE["rover/package.xml"].replace(
        _DEPEND, _DEPEND + "  <build_depend>std_srvs</build_depend>\n"
    )
}

_IS_MAIN = "if __name__ == '__main__':\n    main()\n"
_OTHER = """\
import rclpy
def main():
    rclpy.init()
    node = rclpy.create_node('other')
    rclpy.spin(node)
"""

_BY_PATH = {
    "rover/launch/rover.launch.xml": '<launch>\n  <node pkg="rover" exec="mover"/>\n</launch>\n',
    "rover/launch/other.launch.py": "cmd = ['python3', str(share / 'scripts' / 'mover.py')]\n",
    "rover/scripts/other.py": PYTHON["wheels/wheels/mover.py"].replace("'mover'", "'other'"),
}
_HEADER = {"rover/include/rover/path.hpp": "#include <nav_msgs/msg/path.hpp>\n"}
_INSTALLING = {
    "rover/CMakeLists.txt": CMAKE["rover/CMakeLists.txt"].replace(
        "ament_package()", "install(DIRECTORY include/ DESTINATION include)\nament_package()"
    )
}

_CASES = [
    # A header is used if something that is built includes it, or if others may.
    Break("rover/README.md", "", "", more=_HEADER),
    Break("rover/README.md", "", "", "RK501 rover/include/rover/path.hpp:1",
          more=_HEADER | _INSTALLING),
    Break("rover/src/mover.cpp", "class Mover", '#include <rover/path.hpp>\nclass Mover',
          "RK501 rover/include/rover/path.hpp:1", more=_HEADER),
    # A dependency that is used: not there, there for something else, or for another ROS.
    Break("wheels/package.xml", _EXEC, "", "RK501 wheels/wheels/mover.py:4"),
    Break("wheels/package.xml", "<exec_depend>geometry_msgs</exec_depend>",
          "<test_depend>geometry_msgs</test_depend>", "RK501 wheels/wheels/mover.py:4"),
    Break("wheels/package.xml", "<exec_depend>geometry_msgs</exec_depend>",
          '<exec_depend condition="$ROS_VERSION == 1">geometry_msgs</exec_depend>',
          "RK501 wheels/wheels/mover.py:4"),
    Break("wheels/package.xml", "<exec_depend>geometry_msgs</exec_depend>",
          '<exec_depend condition="$ROS_DISTRO == jazzy">geometry_msgs</exec_depend>'),
    Break("wheels/wheels/mover.py", "import rclpy\n",
          "import rclpy\ntry:\n    import sensor_msgs.msg\nexcept ImportError:\n    pass\n"),
    Break("wheels/wheels/mover.py", "import rclpy\n", "import rclpy\nimport sensor_msgs.msg as m\n",
          "RK501 wheels/wheels/mover.py:3"),
    Break("wheels/wheels/helper.py", "", "from rover.msg import Speed\n",
          "RK501 wheels/wheels/helper.py:1"),
    Break("wheels/test/test_mover.py", "", "from sensor_msgs.msg import Image\n"),
    Break("rover/package.xml", _DEPEND, "  <exec_depend>geometry_msgs</exec_depend>\n",
          "RK501 rover/src/mover.cpp:2"),
    Break("rover/src/mover.cpp", "class Mover", "#if 0\n#include <nav_msgs/msg/path.hpp>\n#endif\n"
          "/*\n#include <sensor_msgs/msg/image.hpp>\n*/\nclass Mover"),
    Break("rover/src/mover.cpp", "class Mover", "// as a/*.hpp\n#include <nav_msgs/msg/path.hpp>\n"
          "class Mover", "RK501 rover/src/mover.cpp:5"),
    Break("rover/src/mover.cpp", "class Mover",
          'auto made = R"(\n#include <nav_msgs/msg/path.hpp>\n)";\nclass Mover'),
    Break("rover/src/mover.cpp", "#include <rclcpp",
          "#ifndef SLIM\n#include <nav_msgs/msg/path.hpp>\n#endif\n#include <rclcpp"),
    Break("rover/src/mover.cpp", "class Mover", "#include <nav_msgs/msg/path.hpp>\nclass Mover",
          "RK501 rover/src/mover.cpp:4"),
    Break("rover/include/rover/mover.hpp", "",
          "#ifndef A\n#define A\n#include <nav_msgs/msg/path.hpp>\n#endif\n",
          "RK501 rover/include/rover/mover.hpp:3", more=_INSTALLING),
    Break("old/package.xml", _DEPEND, "  <build_depend>geometry_msgs</build_depend>\n",
          "RK501 old/scripts/mover.py:3"),
    # A header of one's own, in a folder that another package is called by.
    Break("rover/src/mover.cpp", "class Mover", "#include <nav_msgs/path.h>\nclass Mover",
          more={"rover/include/nav_msgs/path.h": ""}),
    # What comes with a package that is there for nothing else, and a circle.
    Break("rover/src/mover.cpp", "class Mover", "#include <nav_msgs/msg/path.hpp>\nclass Mover",
          more={"rover/package.xml": _ALL, **_other("all_msgs", "nav_msgs")}),
    Break("rover/src/mover.cpp", "class Mover", "#include <wheel/wheel.hpp>\nclass Mover",
          "RK501 rover/src/mover.cpp:4",
          more={**_other("wheel"), "wheel/include/wheel/wheel.hpp": ""}),
    Break("rover/src/mover.cpp", "class Mover", "#include <wheel/wheel.hpp>\nclass Mover",
          more={**_other("wheel", "rover"), "wheel/include/wheel/wheel.hpp": ""}),
    # A package within a package is no package for those who build.
    Break("rover/src/mover.cpp", "class Mover", "#include <wheel/wheel.hpp>\nclass Mover",
          more={f"rover/{file}": text for file, text in
                {**_other("wheel"), "wheel/include/wheel/wheel.hpp": ""}.items()}),
    # A dependency that nothing uses.
    Break("rover/CMakeLists.txt", "find_package(rclcpp REQUIRED)", "find_package(rclcpp REQUIRED)\n"
          "find_package(std_srvs REQUIRED)", "RK502 rover/package.xml:13", more=_STD_SRVS),
    Break("rover/CMakeLists.txt", "mover rclcpp geometry_msgs", "mover rclcpp std_srvs",
          more=_STD_SRVS),
    Break("rover/CMakeLists.txt", "install(TARGETS",
          "target_link_libraries(mover ${std_srvs_TARGETS})\ninstall(TARGETS", more=_STD_SRVS),
    Break("old/package.xml", "<depend>geometry_msgs</depend>\n",
          "<depend>geometry_msgs</depend>\n  <depend>std_msgs</depend>\n",
          "RK502 old/package.xml:12"),
    Break("old/package.xml", "<depend>geometry_msgs</depend>\n",
          "<depend>geometry_msgs</depend>\n  <depend>std_msgs</depend>\n",
          more={"old/action/Go.action": "---\n---\n",
                "old/CMakeLists.txt": CATKIN_LISTS.replace("generate_messages(",
                "add_action_files(FILES Go.action)\ngenerate_messages(")}),
    Break("wheels/package.xml", _EXEC, _EXEC + "  <exec_depend>sensor_msgs</exec_depend>\n",
          "RK502 wheels/package.xml:10"),
    Break("rover/package.xml", _DEPEND, _DEPEND + "  <build_depend>std_srvs</build_depend>\n",
          "RK502 rover/package.xml:13"),
    Break("wheels/package.xml", _EXEC, _EXEC + "  <exec_depend>rover</exec_depend>\n"),
    # A node that is not installed, or elsewhere.
    Break("wheels/setup.py", "'mover = wheels.mover:main'", "",
          "RK506 wheels/launch/wheels.launch.py:7, RK503 wheels/wheels/mover.py:18"),
    Break("wheels/setup.cfg", "install_scripts=$base/lib/wheels", "install_scripts=$base/lib/whels",
          "RK503 wheels/setup.cfg:4"),
    Break("wheels/setup.cfg", "", None, "RK503 wheels/setup.py:8"),
    Break("rover/CMakeLists.txt", "install(TARGETS mover DESTINATION lib/${PROJECT_NAME})",
          "if(NOT WIN32)\n  install(TARGETS mover DESTINATION lib/${PROJECT_NAME})\nendif()"),
    Break("wheels/wheels/mover.py", "def main():",
          "def __getattr__(name):\n    return print\n\n\ndef other():"),
    Break("wheels/wheels/mover.py", "def main():", "from typing import TYPE_CHECKING\n"
          "if TYPE_CHECKING:\n    import sensor_msgs.msg\n\n\ndef main():"),
    Break("wheels/setup.cfg", "install_scripts=", "install_scripts: "),
    Break("wheels/setup.cfg", "install_scripts=$base/lib", "install_scripts: $base/bin",
          "RK503 wheels/setup.cfg:4"),
    Break("wheels/wheels/other.py", "", "from wheels.mover import Mover\n\n"
          "def main():\n    pass\n"),
    Break("rover/CMakeLists.txt", "install(TARGETS mover DESTINATION lib/${PROJECT_NAME})\n", "",
          "RK503 rover/CMakeLists.txt:12"),
    Break("rover/CMakeLists.txt", "TARGETS mover DESTINATION lib/${PROJECT_NAME}",
          "TARGETS mover\n  ARCHIVE DESTINATION lib\n  RUNTIME DESTINATION bin",
          "RK503 rover/CMakeLists.txt:12"),
    Break("rover/CMakeLists.txt", "TARGETS mover DESTINATION lib/${PROJECT_NAME}",
          "TARGETS mover\n  LIBRARY DESTINATION lib\n  RUNTIME DESTINATION lib/${PROJECT_NAME}"),
    Break("rover/CMakeLists.txt", "  scripts/mover.py\n", "  # scripts/mover.py\n",
          "RK506 rover/launch/rover.launch.xml:3, RK503 rover/scripts/mover.py:18"),
    Break("rover/CMakeLists.txt", "scripts/mover.py\n  DESTINATION lib/${PROJECT_NAME}",
          "scripts/mover.py\n  DESTINATION share/${PROJECT_NAME}",
          "RK503 rover/CMakeLists.txt:18, RK506 rover/launch/rover.launch.xml:3"),
    # One program that several files start is told once.
    Break("rover/launch/rover.launch.xml", '"mover"', '"motor"',
          "RK506 rover/launch/more.launch.xml:2",
          more={"rover/launch/more.launch.xml": '<launch>\n  <node pkg="rover" exec="motor"/>\n'
                '</launch>\n'}),
    # On another computer there may be another workspace.
    Break("old/launch/old.launch", 'type="mover.py"', 'machine="arm" type="motor.py"'),
    # What is started by its path, and what lies beside it.
    Break("rover/CMakeLists.txt", "scripts/mover.py\n  DESTINATION lib/${PROJECT_NAME}",
          "scripts/mover.py\n  scripts/other.py\n  DESTINATION share/${PROJECT_NAME}/scripts",
          more=_BY_PATH),
    Break("rover/CMakeLists.txt", "scripts/mover.py\n  DESTINATION lib/${PROJECT_NAME}",
          "scripts/mover.py\n  DESTINATION share/${PROJECT_NAME}/scripts", more=_BY_PATH),
    Break("rover/CMakeLists.txt", "ament_package()", "my_own_command(mover.py)\nament_package()"),
    Break("rover/test/start.launch.py", "", "path = 'scripts/mover.py'\n"),
    Break("rover/scripts/other_old.py", "", "import rclpy\nrclpy.create_node('a')\n"
          "if __name__ == '__main__':\n    pass\n"),
    Break("rover/scripts/other.py", "", _OTHER + _IS_MAIN),
    Break("rover/scripts/other.py", "", "#!/usr/bin/env python3\n" + _OTHER + _IS_MAIN,
          "RK503 rover/scripts/other.py:7"),
    Break("wheels/wheels/other.py", "", _OTHER, "RK503 wheels/wheels/other.py:2"),
    Break("wheels/wheels/other.py", "", "# Run: python3 other.py --slow\n" + _OTHER),
    Break("wheels/wheels/other.py", "", _OTHER,
          more={"wheels/launch/x.launch.py": "cmd = ['python3', '-m', 'wheels.other']\n"}),
    Break("wheels/wheels/other.py", "", _OTHER,
          more={"wheels/launch/x.launch.py": "a = [\n    # other,\n]\n"}),
    # A node that the system cannot run.
    Break("rover/CMakeLists.txt", "install(PROGRAMS", "install(FILES",
          "RK504 rover/CMakeLists.txt:18"),
    Break("rover/CMakeLists.txt", "install(PROGRAMS\n  scripts/mover.py",
          "install(DIRECTORY\n  scripts/",
          "RK504 rover/CMakeLists.txt:18"),
    Break("rover/CMakeLists.txt", "install(PROGRAMS\n  scripts/mover.py\n",
          "install(DIRECTORY\n  scripts/\n  USE_SOURCE_PERMISSIONS\n"),
    Break("rover/scripts/mover.py", "#!/usr/bin/env python3\n", "",
          "RK504 rover/scripts/mover.py:1"),
    Break("rover/scripts/mover.py", "python3\n", "python3\r\n", "RK504 rover/scripts/mover.py:1"),
    Break("old/CMakeLists.txt", "catkin_install_python(PROGRAMS", "install(FILES",
          "RK504 old/CMakeLists.txt:10"),
    Break("old/scripts/mover.py", "#!/usr/bin/env python\n", "", "RK504 old/scripts/mover.py:1"),
    # An entry point to nothing.
    Break("wheels/setup.py", "wheels.mover:main", "wheels.mover:mian", "RK505 wheels/setup.py:8"),
    Break("wheels/setup.py", "wheels.mover:main", "wheels.moverr:main",
          "RK505 wheels/setup.py:8"),
    Break("wheels/setup.py", "wheels.mover:main", "wheel.mover:main",
          "RK505 wheels/setup.py:8"),
    Break("wheels/setup.py", "wheels.mover:main", "wheels.mover", "RK505 wheels/setup.py:8"),
    Break("wheels/setup.py", "packages=['wheels']", "packages=['wheels.other']",
          "RK505 wheels/setup.py:8"),
    Break("wheels/wheels/mover.py", "def main():", "def run():", "RK505 wheels/setup.py:8"),
    Break("wheels/wheels/mover.py", "import rclpy\n", "import rclpy\nfrom rclpy import *\n"),
    Break("wheels/setup.py", "wheels.mover:main", "mover:main", "RK505 wheels/setup.py:8"),
    # A launch file that starts nothing.
    Break("wheels/launch/wheels.launch.py", "executable='mover'", "executable='moverr'",
          "RK506 wheels/launch/wheels.launch.py:7"),
    Break("wheels/launch/wheels.launch.py", "executable='mover'", "executable='mover.py'",
          "RK506 wheels/launch/wheels.launch.py:7"),
    Break("wheels/launch/wheels.launch.py", "package='wheels'", "package='wheeels'",
          "RK506 wheels/launch/wheels.launch.py:7"),
    Break("wheels/launch/wheels.launch.py", "package='wheels'", "package='nav2_amcl'"),
    Break("rover/launch/rover.launch.xml", '<node pkg="rover" exec="mover"/>',
          '<node pkg="rover" exec="move"/>\n  <node pkg="rover" exec="move"/>',
          "RK506 rover/launch/rover.launch.xml:2"),
    Break("rover/launch/rover.launch.xml", 'exec="mover"', 'exec="move"',
          "RK506 rover/launch/rover.launch.xml:2"),
    Break("rover/launch/rover.launch.xml", "<launch>\n",
          '<launch>\n  <arg name="a" default="false"/>\n'
          '  <node pkg="rover" exec="moved" if="$(var a)"/>\n'
          '  <node pkg="far" exec="b" if="$(var a)"/>\n',
          "RK506 rover/launch/rover.launch.xml:3"),
    Break("old/launch/old.launch", "mover.py", "move.py", "RK506 old/launch/old.launch:2"),
    Break("wheels/launch/wheels.launch.py", "Node(package='wheels', executable='mover')",
          "Node(\n            package='wheels',\n            executable='moverr')",
          "RK506 wheels/launch/wheels.launch.py:9"),
    Break("rover/launch/rover.launch.xml", "</launch>", """\
  <node_container pkg="rclcpp_components" exec="component_container" name="c" namespace="">
    <composable_node pkg="rover" plugin="rover::Mover" name="a"/>
    <composable_node pkg="rover" plugin="rover::Moverr" name="b"/>
  </node_container>
</launch>""", "RK506 rover/launch/rover.launch.xml:6"),
    # A definition that is not built.
    Break("rover/msg/Angle.msg", "", "float64 value\n", "RK507 rover/msg/Angle.msg:1"),
    Break("rover/CMakeLists.txt", '  "srv/Reset.srv"\n', "", "RK507 rover/srv/Reset.srv:1"),
    Break("rover/CMakeLists.txt", '"srv/Reset.srv"\n', '# "srv/Reset.srv"\n'),
    Break("rover/CMakeLists.txt", '  "srv/Reset.srv"\n  DEPENDENCIES geometry_msgs\n)\n',
          '  DEPENDENCIES geometry_msgs\n)\n# srv/Reset.srv\n', "RK507 rover/srv/Reset.srv:1"),
    Break("rover/CMakeLists.txt", '"msg/Speed.msg"', '"msg/Sped.msg"',
          "RK507 rover/CMakeLists.txt:8, RK507 rover/msg/Speed.msg:1"),
    Break("rover/srv/Reset.srv", "", None, "RK507 rover/CMakeLists.txt:9"),
    Break("rover/CMakeLists.txt", "  DEPENDENCIES geometry_msgs\n", "",
          "RK507 rover/msg/Speed.msg:1"),
    Break("rover/CMakeLists.txt", "find_package(rosidl_default_generators REQUIRED)\n", "",
          "RK507 rover/CMakeLists.txt:6"),
    Break("rover/package.xml",
          "  <member_of_group>rosidl_interface_packages</member_of_group>\n", "",
          "RK507 rover/package.xml:3"),
    Break("old/CMakeLists.txt", "  Speed.msg\n", "  Sped.msg\n",
          "RK507 old/CMakeLists.txt:6, RK507 old/msg/Speed.msg:1"),
    Break("old/CMakeLists.txt", "  Speed.msg\n", "  Speed.msg\n  # Angle.msg\n",
          more={"old/msg/Angle.msg": "float64 value\n"}),
    Break("old/CMakeLists.txt", "  Speed.msg\n", "  Speed.msg\n  # Other.msg\n",
          "RK507 old/msg/Angle.msg:1", more={"old/msg/Angle.msg": "float64 value\n"}),
    Break("old/msg/A.msg", "", "bool a\n", ", ".join(f"RK507 old/msg/{x}.msg:1" for x in "ABC"),
          more={"old/msg/B.msg": "bool b\n", "old/msg/C.msg": "bool c\n"}),
    Break("old/msg/A.msg", "", "bool a\n", "RK507 old/msg/A.msg:1",
          more={f"old/msg/{x}.msg": "bool x\n" for x in "BCD"}),
    Break("old/CMakeLists.txt", "generate_messages(", "add_action_files(FILES Go.action)\n"
          "generate_messages(", more={"old/action/Go.action": "---\n---\n",
          "old/msg/GoAction.msg": "bool a\n", "old/msg/GoActionFeedback.msg": "bool a\n",
          "old/msg/GoGoal.msg": "bool a\n"}),
    Break("old/msg/GoGoals.msg", "", "bool a\n", "RK507 old/action/Go.action:1, "
          "RK507 old/msg/GoGoals.msg:1", more={"old/action/Go.action": "---\n---\n"}),
    Break("old/msg/GoGoal.msg", "", "# == DO NOT MODIFY! AUTOGENERATED FROM AN ACTION DEFINITION"
          " ==\nbool a\n"),
    Break("old/msg/GoGoal.msg", "", "bool a\n", "RK507 old/msg/GoGoal.msg:1"),
    Break("old/CMakeLists.txt", "generate_messages(DEPENDENCIES geometry_msgs)\n", "",
          "RK507 old/CMakeLists.txt:4"),
    Break("old/CMakeLists.txt", " message_generation", "", "RK507 old/CMakeLists.txt:4"),
    Break("wheels/msg/Speed.msg", "", "float64 value\n", "RK507 wheels/msg/Speed.msg:1"),
]  # fmt: skip


def test_workspace_breaks_no_rule(tmp_path: Path) -> None:
    assert told_of(tmp_path, WORKSPACE) == ""


@pytest.mark.parametrize("case", _CASES, ids=lambda case: f"{case.file} {case.new}"[:60])
def test_change_is_told_where_it_is(tmp_path: Path, case: Break) -> None:
    package = case.file.partition("/")[0]
    own = {"wheels": PYTHON, "rover": CMAKE, "old": CATKIN}[package]
    workspace = WORKSPACE if "rover" in (case.new or "") and package != "rover" else own
    assert told_of(tmp_path, case.files(workspace)) == case.found


def test_mode_of_a_script_counts_for_ros_1(tmp_path: Path) -> None:
    files = CATKIN | {
        "old/CMakeLists.txt": CATKIN["old/CMakeLists.txt"].partition("catkin_install")[0]
    }
    other = files | {"old/scripts/other.py": files["old/scripts/mover.py"]}
    assert told_of(tmp_path, other, ("old/scripts/other.py",)) == "RK504 old/scripts/mover.py:1"


_FORMAT_1 = (
    CATKIN["old/package.xml"]
    .replace('format="2"', 'format="1"')
    .replace("<depend>geometry_msgs</depend>", "")
    .replace("<depend>", "<run_depend>")
    .replace("</depend>", "</run_depend>")
    .replace("exec_depend", "run_depend")
)
_BOTH = "<build_depend>std_srvs</build_depend><exec_depend>std_srvs</exec_depend>"
_HELP = [
    (
        Break("rover/src/mover.cpp", "class Mover",
              "#include <nav_msgs/msg/path.hpp>\nnav_msgs::msg::Path path;\nclass Mover"),
        "write `<depend>nav_msgs</depend>` into package.xml, and "
        "`find_package(nav_msgs REQUIRED)` into CMakeLists.txt",
    ),
    (
        Break("rover/src/mover.cpp", "class Mover",
              "#include <nav_msgs/msg/path.hpp>\nnav_msgs::msg::Path path;\nclass Mover",
              more={"rover/CMakeLists.txt": CMAKE["rover/CMakeLists.txt"].replace(
                  "find_package(rclcpp REQUIRED)", "ament_auto_find_build_dependencies()")}),
        "write `<depend>nav_msgs</depend>` into package.xml",
    ),
    (
        Break("old/scripts/mover.py", "import rospy\n",
              "import rospy\nfrom nav_msgs.msg import Path\nPath()\n",
              more={"old/package.xml": CATKIN["old/package.xml"]
                    .replace("build_depend>", "exec_depend>").replace("<depend>", "<exec_depend>")
                    .replace("</depend>", "</exec_depend>")}),
        "write `<exec_depend>nav_msgs</exec_depend>` into package.xml",
    ),
    (
        Break("old/msg/Speed.msg", "Twist", "Pose", more={"old/package.xml": _FORMAT_1}),
        "write `<build_depend>geometry_msgs</build_depend>` and "
        "`<run_depend>geometry_msgs</run_depend>` into package.xml",
    ),
    (
        Break("rover/package.xml", _DEPEND, _DEPEND + "  <exec_depend>std_srvs</exec_depend>\n"),
        "take the dependency out",
    ),
    (
        Break(
            "rover/package.xml",
            _DEPEND,
            f"{_DEPEND}  {_BOTH}\n",
            more={
                "rover/CMakeLists.txt": CMAKE["rover/CMakeLists.txt"].replace(
                    "find_package(rclcpp", "find_package(std_srvs REQUIRED)\nfind_package(rclcpp"
                )
            },
        ),
        "take all 2 lines of it out of package.xml, and `std_srvs` out of CMakeLists.txt",
    ),
    (
        Break("wheels/setup.py", "wheels.mover:main", "wheels.commands:main",
              more={"wheels/tools/commands.py": ""}),
        "`tools/commands.py` is there: the module would be `wheels/commands.py`",
    ),
    (
        Break("wheels/setup.py", "wheels.mover:main", "wheels.rover:main"),
        "did you mean `wheels.mover`?",
    ),
    (Break("wheels/setup.py", "wheels.mover:main", "wheels.movement:main"), None),
    (
        Break("rover/launch/rover.launch.xml", 'exec="mover"', 'exec="mover_old"',
              more={"rover/src/mover_old.cpp": "", "rover/src/part.cpp": ""}),
        "`mover_old.cpp` is there, and `CMakeLists.txt` makes no program of it",
    ),
    (Break("rover/launch/rover.launch.xml", 'exec="mover"', 'exec="motor"'), None),
    (
        Break("wheels/wheels/other.py", "",
              _OTHER.replace("def main", "if __name__ == '__main__'").replace("main'()", "main'")),
        "start it in a function `main`, and add `other = wheels.other:main` to `console_scripts`",
    ),
]  # fmt: skip


@pytest.mark.parametrize(("case", "help_"), _HELP, ids=lambda case: str(case)[:40])
def test_help_says_what_mends_it(tmp_path: Path, case: Break, help_: str | None) -> None:
    own = {"wheels": PYTHON, "rover": CMAKE, "old": CATKIN}[case.file.partition("/")[0]]
    found = [each.diagnostic.help for each in found_in(tmp_path, case.files(own))]
    assert help_ in found


_CONTAINER = """\
<launch>
  <node_container pkg="rclcpp_components" exec="component_container" name="all" namespace="">
    <composable_node pkg="rover" plugin="rover::Brake" name="brake"/>
  </node_container>
</launch>
"""


def test_component_that_is_registered_twice_explains_the_missing_one(tmp_path: Path) -> None:
    again = 'rclcpp_components_register_node(part PLUGIN "rover::Mover" EXECUTABLE brake)\n'
    lists = CMAKE["rover/CMakeLists.txt"].replace("ament_package()", again + "ament_package()")
    files = CMAKE | {"rover/CMakeLists.txt": lists, "rover/launch/brake.launch.xml": _CONTAINER}
    (found,) = found_in(tmp_path, files)
    (label,) = found.diagnostic.labels
    assert found.diagnostic.message == "`rover` registers no component `rover::Brake`"
    assert lists[label.span.start : label.span.end] == '"rover::Mover"'
    assert label.span.start > lists.index("rclcpp_components_register_node(")


def test_places_that_start_what_is_not_there_are_shown(tmp_path: Path) -> None:
    text = '<launch>\n  <node pkg="rover" exec="motor"/>\n</launch>\n'
    files = CMAKE | {f"rover/launch/{at}.launch.xml": text for at in range(6)}
    (found,) = found_in(tmp_path, files)
    assert [each.message for each in found.diagnostic.labels] == [
        "it is started here too",
        "it is started here too",
        "it is started here too, and in 2 more files",
    ]
