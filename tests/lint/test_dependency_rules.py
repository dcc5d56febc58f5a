"""What RK501 to RK503 tell of dependencies in packages of types, and of setup.cfg."""

from __future__ import annotations

from pathlib import Path

import pytest
from linted import run_over, write_tree
from packages import CATKIN, CMAKE, PY_NODE, PYTHON, Break, found_in, told_of

from plastron_tui.lint.rules.package_examples import TYPES_PACKAGE, package_xml, setup_py
from plastron_tui.project.linting.rewriting import mend

_GEOMETRY = "<depend>geometry_msgs</depend>"
_EXEC = "  <exec_depend>geometry_msgs</exec_depend>\n"
_MEMBER = "  <member_of_group>rosidl_interface_packages</member_of_group>\n"
_TIME = "builtin_interfaces/Time stamp\n"
_MADE_OF = 'Speed.msg" DEPENDENCIES '
_LISTS = TYPES_PACKAGE["demo/CMakeLists.txt"]
_OF_TIME = _LISTS.replace('Speed.msg"', f"{_MADE_OF}builtin_interfaces")


def _demo(*lines: str) -> str:
    """Return the package.xml of the package of types, with further lines."""
    return TYPES_PACKAGE["demo/package.xml"].replace(
        _MEMBER, _MEMBER + "".join(f"  {each}\n" for each in lines)
    )


_CASES = [
    # A package of types names what it has no use for.
    Break("demo/package.xml", "", _demo(_GEOMETRY), "RK502 demo/package.xml:12"),
    Break("demo/package.xml", "", _demo(_GEOMETRY),
          more={"demo/msg/Speed.msg": "geometry_msgs/Twist twist\n",
                "demo/CMakeLists.txt": _LISTS.replace('Speed.msg"', f"{_MADE_OF}geometry_msgs")}),
    Break("demo/package.xml", "", _demo("<test_depend>geometry_msgs</test_depend>")),
    Break("demo/package.xml", "", _demo(_GEOMETRY),
          more={"demo/CMakeLists.txt": _LISTS.replace("ament_package", "ament_auto_package")}),
    # What the build of types needs: in packages that have some, and in no others.
    Break("demo/package.xml", "", _demo("<depend>action_msgs</depend>")),
    Break("wheels/package.xml", _EXEC, _EXEC + "  <depend>action_msgs</depend>\n",
          "RK502 wheels/package.xml:10"),
    Break("wheels/package.xml", _EXEC, _EXEC + "  <depend>geographic_msgs</depend>\n",
          "RK502 wheels/package.xml:10"),
    # A package that nothing is known of may have more than types.
    Break("wheels/package.xml", _EXEC, _EXEC + "  <depend>acme_msgs</depend>\n"),
    # What comes along is told where CMake looks for it by its name.
    Break("demo/msg/Speed.msg", "", _TIME,
          more={"demo/CMakeLists.txt": _OF_TIME}),
    Break("demo/msg/Speed.msg", "", _TIME, "RK501 demo/msg/Speed.msg:1",
          more={"demo/CMakeLists.txt": _OF_TIME.replace(
              "rosidl_generate", "find_package(builtin_interfaces REQUIRED)\nrosidl_generate")}),
    Break("wheels/wheels/mover.py", "import rclpy\n", "import rclpy\nimport action_msgs.msg\n"),
    Break("wheels/wheels/mover.py", "import rclpy\n", "import rclpy\nimport nav2_msgs.msg\n",
          "RK501 wheels/wheels/mover.py:3"),
    # What types alone are imported of in this way is a package of types, known or not.
    Break("wheels/wheels/mover.py", "import rclpy\n",
          "import rclpy\nfrom acme_msgs.msg import Wheel\n", "RK501 wheels/wheels/mover.py:3"),
    Break("wheels/wheels/mover.py", "import rclpy\n",
          "import rclpy\nfrom acme_interfaces.srv import Wheel\n",
          "RK501 wheels/wheels/mover.py:3"),
    Break("rover/src/mover.cpp", "#include <rclcpp/rclcpp.hpp>",
          '#include "acme_msgs/msg/wheel.hpp"',
          "RK501 rover/src/mover.cpp:1"),
    Break("old/scripts/mover.py", "import rospy\n",
          "import rospy\nfrom acme_srvs.srv import Wheel\n", "RK501 old/scripts/mover.py:3"),
    Break("wheels/wheels/mover.py", "import rclpy\n",
          "import rclpy\nfrom acme.msg import Wheel\n"),
    Break("wheels/wheels/mover.py", "import rclpy\n",
          "import rclpy\nfrom acme_msgs.tools import Wheel\n"),
    Break("wheels/wheels/mover.py", "import rclpy\n",
          "import rclpy\nfrom acme_msgs.msg import Wheel\n",
          more={"wheels/acme_msgs/__init__.py": "", "wheels/acme_msgs/msg.py": "Wheel = 1\n"}),
    # A slip in the code speaks for the dependency, where nobody has a package of that name.
    Break("wheels/wheels/mover.py", "geometry_msgs", "geometry_msg",
          "RK501 wheels/wheels/mover.py:4"),
    Break("wheels/wheels/mover.py", "from geometry_msgs.msg", "from goemetry_msgs.msg",
          "RK501 wheels/wheels/mover.py:4"),
    Break("wheels/wheels/mover.py", "from geometry_msgs.msg", "from geometry_2msgs.msg",
          "RK502 wheels/package.xml:9"),
    Break("wheels/wheels/mover.py", "from geometry_msgs.msg", "from geometry_msg.msg",
          "RK502 wheels/package.xml:9", more={"wheels/wheels/geometry_msg/msg.py": ""}),
    Break("wheels/wheels/mover.py", "from geometry_msgs.msg", "from geometry_msg.msg",
          "RK502 wheels/package.xml:9",
          more={"geometry_msg/package.xml": package_xml("geometry_msg"),
                "geometry_msg/setup.py": setup_py(name="geometry_msg").replace(
                    "packages=['geometry_msg']", "packages=[]")}),
    Break("wheels/wheels/mover.py", "from geometry_msgs.msg import Twist",
          "try:\n    from geometry_msg.msg import Twist\nexcept ImportError:\n    raise"),
    Break("wheels/wheels/mover.py", "from geometry_msgs.msg", "from geometry_msg.msg",
          "RK501 wheels/wheels/mover.py:4", more={"wheels/wheels/b.py": "import geometry_msgs\n"}),
    Break("rover/src/mover.cpp", "geometry_msgs", "geometry_msg", "RK501 rover/src/mover.cpp:2"),
    Break("rover/package.xml", "", CMAKE["rover/package.xml"].replace(
              "<depend>rclcpp", "<depend>nav_msgs</depend>\n  <depend>rclcpp"),
          "RK501 rover/src/part.cpp:1",
          more={"rover/src/part.cpp": "#include <nav_msg/msg/path.hpp>\n"}),
    Break("demo/package.xml", "", _demo(_GEOMETRY), "RK507 demo/msg/Speed.msg:1",
          more={"demo/msg/Speed.msg": "geometry_msg/Twist twist\n"}),
]  # fmt: skip


@pytest.mark.parametrize("case", _CASES, ids=lambda case: f"{case.file} {case.found}"[:60])
def test_dependency_is_told_where_it_is(tmp_path: Path, case: Break) -> None:
    own = {"demo": TYPES_PACKAGE, "wheels": PYTHON, "rover": CMAKE, "old": CATKIN}[
        case.file.partition("/")[0]
    ]
    assert told_of(tmp_path, case.files(own)) == case.found


def test_slip_in_an_import_keeps_the_dependency(tmp_path: Path) -> None:
    text = PY_NODE.replace("geometry_msgs", "geometry_msg")
    root = write_tree(tmp_path, PYTHON | {"wheels/wheels/mover.py": text, "plastron.yaml": ""})
    run = run_over(root, "RK")
    mend(run)
    assert (root / "wheels/package.xml").read_text() == PYTHON["wheels/package.xml"]
    (found,) = (each.diagnostic for each in run.told)
    assert found.message == "no package `geometry_msg` is known"
    assert found.help == "did you mean `geometry_msgs`?"
    assert found.span is not None
    assert text[found.span.start : found.span.end] == "geometry_msg"


_NAV = "#include <nav_msgs/msg/path.hpp>\n"
_OUT = "or take the include"
_NOTES = [
    # One finding a package, with the first place in each further file.
    ({"rover/src/a.cpp": _NAV}, (), "or take the include out: nothing uses"),
    ({"rover/src/a.cpp": _NAV, "rover/src/b.cpp": _NAV}, ("b.cpp",), "includes out: nothing"),
    ({f"rover/src/{each}.cpp": _NAV for each in "abcdef"}, ("b.cpp", "c.cpp", "d.cpp"),
     "includes out: nothing"),
    # The name is used here, in another file, or may be where somebody includes the header.
    ({"rover/src/a.cpp": f"{_NAV}nav_msgs::msg::Path path;\n"}, (), ""),
    ({"rover/src/a.cpp": _NAV, "rover/src/b.cpp": "nav_msgs::msg::Path path;\n"}, (), ""),
    ({"rover/include/rover/a.hpp": _NAV}, (), ""),
    # What is no package of types may work without being named.
    ({"rover/src/a.cpp": "#include <tf2_ros/buffer.h>\n"}, (), ""),
]  # fmt: skip


@pytest.mark.parametrize(("files", "others", "out"), _NOTES, ids=lambda each: str(each)[:50])
def test_one_finding_has_all_places(
    tmp_path: Path, files: dict[str, str], others: tuple[str, ...], out: str
) -> None:
    sources = " ".join(each[6:] for each in files if each.endswith(".cpp"))
    lists = CMAKE["rover/CMakeLists.txt"].replace("src/part.cpp", sources)
    # Others may include the headers of the package.
    lists = lists.replace("install(DIRECTORY launch", "install(DIRECTORY include launch")
    workspace = CMAKE | {"rover/CMakeLists.txt": lists} | files
    (found,) = (each for each in found_in(tmp_path, workspace) if each.rule.code == "RK501")
    _, *notes = found.diagnostic.labels
    assert tuple(each.file.name for each in notes if each.file is not None) == others
    assert (
        (out in (found.diagnostic.help or "")) if out else _OUT not in (found.diagnostic.help or "")
    )
    if len(files) > 4:
        assert notes[-1].message == "used here too, and in 2 more files"


_IMPORTS = [
    ("from nav_msgs.msg import Path", "", True),
    ("from nav_msgs.msg import Path", "path = Path()", False),
    ("from nav_msgs.msg import Path as P", "path = Path()", True),
    ("from nav_msgs.msg import Path, Odometry", "path = Odometry()", False),
    ("from nav_msgs.msg import *", "", False),
    ("import nav_msgs.msg", "", True),
    ("import nav_msgs.msg as nm", "path = nm.Path()", False),
    ("import nav_msgs.msg", "nav_msgs.msg.Path()", False),
]


@pytest.mark.parametrize(("line", "use", "is_idle"), _IMPORTS)
def test_import_that_nothing_uses_may_go(
    tmp_path: Path, line: str, use: str, is_idle: bool
) -> None:
    text = PYTHON["wheels/wheels/mover.py"].replace(
        "import rclpy\n", f"import rclpy\n{line}\n{use}\n", 1
    )
    (found,) = found_in(tmp_path, PYTHON | {"wheels/wheels/mover.py": text})
    assert ("or take the import out" in (found.diagnostic.help or "")) == is_idle


_DEVELOP = "[develop]\nscript_dir=$base/lib/wheels\n"
_INSTALL = "[install]\ninstall_scripts=$base/lib/wheels\n"
_BEHIND = "`ros2 run` looks for programs in `lib/wheels`, and "
_LINKED = "`ros2 run` looks for programs of a build with `--symlink-install` in `lib/wheels`, and "
_FOLDERS = [
    (_DEVELOP + _INSTALL, ""),
    (f"{_DEVELOP}{_INSTALL}".replace("_", "-").replace("=", " = "), ""),
    (f"{_DEVELOP}[install]\ninstall_scripts: lib/wheels/\n", ""),
    (_DEVELOP, f"1 {_BEHIND}`setup.cfg` does not say that below `[install]`"),
    (_INSTALL, f"1 {_LINKED}`setup.cfg` does not say that below `[develop]`"),
    ("", f"8 {_BEHIND}no `setup.cfg` says that"),
    ("[metadata]\nname=wheels\n", f"8 {_BEHIND}no `setup.cfg` says that"),
    (_DEVELOP + _INSTALL.replace("wheels", "rover"),
     f"4 {_BEHIND}they are installed to `$base/lib/rover`"),
    (_DEVELOP.replace("wheels", "rover") + _INSTALL,
     f"2 {_LINKED}they are installed to `$base/lib/rover`"),
    (_DEVELOP + _INSTALL.replace("[install]", "[instal]"),
     f"3 {_BEHIND}`install_scripts` counts below `[install]` alone"),
    (_DEVELOP.replace("[develop]", "[egg_info]") + _INSTALL,
     f"1 {_LINKED}`script_dir` counts below `[develop]` alone"),
    (f"{_DEVELOP}[install]\ninstall_scripts=$base/lib/%(name)s\n", ""),
    (f"# [install]\n{_DEVELOP}# install_scripts=bin\n{_INSTALL}", ""),
]  # fmt: skip


@pytest.mark.parametrize(("text", "told"), _FOLDERS, ids=lambda each: str(each)[-50:])
def test_scripts_are_installed_where_nodes_are_looked_for(
    tmp_path: Path, text: str, told: str
) -> None:
    found = []
    for each in found_in(tmp_path, PYTHON | {"wheels/setup.cfg": text}):
        file, span = each.diagnostic.file, each.diagnostic.span
        assert file is not None and span is not None
        line = file.read_bytes()[: span.start].count(b"\n") + 1
        found.append(f"{line} {each.diagnostic.message}")
    assert found == ([told] if told else [])


@pytest.mark.parametrize("file", ["setup.py", "pyproject.toml"])
def test_scripts_may_be_placed_by_other_files(tmp_path: Path, file: str) -> None:
    said = {
        "setup.py": PYTHON["wheels/setup.py"].replace(
            "    entry_points",
            "    options={'install': {'install_scripts': 'lib/wheels'}},\n    entry_points",
        ),
        "pyproject.toml": "[tool.distutils.install]\ninstall-scripts = '$base/lib/wheels'\n",
    }
    assert told_of(tmp_path, PYTHON | {"wheels/setup.cfg": "", f"wheels/{file}": said[file]}) == ""
