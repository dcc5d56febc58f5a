"""How long `plastron lint` takes for a workspace of 100 packages, and its memory for 1,000.

The packages are made here: nodes of Python and C++ with headers, launch and parameter files,
definitions, build files. Cold nothing is known of them; warm nothing has changed; edited is one
source. The memory is that of all processes together (`Pss`), at its peak.
"""

from __future__ import annotations

import os
import subprocess
import sys
import time
from collections.abc import Iterator, Mapping
from contextlib import suppress
from pathlib import Path
from statistics import median
from tempfile import TemporaryDirectory

from .process import ENVIRON
from .row import Row

_PACKAGE = """\
<package format="3"><name>{name}</name><version>0.1.0</version><description>d</description>
<maintainer email="a@b.c">m</maintainer><license>MIT</license>
<depend>{library}</depend><depend>std_msgs</depend><depend>geometry_msgs</depend>
<export><build_type>{build}</build_type></export></package>
"""
_SETUP = """\
from setuptools import setup

setup(
    name='{name}',
    packages=['{name}'],
    data_files=[('share/{name}', ['package.xml'])],
    entry_points={{'console_scripts': [{scripts}]}},
)
"""
_PYTHON = """\
import rclpy
from geometry_msgs.msg import Twist
from rclpy.node import Node
from std_msgs.msg import String

from .topics import NAMES


class Driver{at}(Node):
    def __init__(self):
        super().__init__('driver_{at}')
        self.declare_parameter('rate', 10.0)
        self.pub = self.create_publisher(Twist, NAMES[{at}], 10)
        self.create_subscription(String, '{name}/mode_{at}', self.on_mode, 10)
        self.create_timer(1.0 / self.get_parameter('rate').value, self.on_timer)

    def on_mode(self, msg):
        self.get_logger().info('mode %s' % msg.data)

    def on_timer(self):
        msg = Twist()
        msg.linear.x = 0.5
        self.pub.publish(msg)
{helpers}

def main():
    rclpy.init()
    rclpy.spin(Driver{at}())
"""
_HELPER = """
    def step_{at}(self, speed, limit=1.0):
        # no faster than the wheels can turn
        for wheel in range(4):
            if speed * wheel > limit:
                self.get_logger().debug('wheel %d is slow' % wheel)
        return max(-limit, min(limit, speed))
"""
_HEADER = """\
#pragma once
#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/string.hpp>
#include "{name}/topics.hpp"

namespace {name}
{{
class Arm{at} : public rclcpp::Node
{{
public:
  Arm{at}();

private:
  void on_command(const std_msgs::msg::String & msg);
  rclcpp::Publisher<std_msgs::msg::String>::SharedPtr pub_;
  rclcpp::Subscription<std_msgs::msg::String>::SharedPtr sub_;
}};
}}  // namespace {name}
"""
_CPP = """\
#include "{name}/arm_{at}.hpp"

namespace {name}
{{
Arm{at}::Arm{at}()
: Node("arm_{at}")
{{
  using std::placeholders::_1;
  pub_ = create_publisher<std_msgs::msg::String>(TOPIC_{at}, 10);
  sub_ = create_subscription<std_msgs::msg::String>(
    "{name}/command_{at}", 10, std::bind(&Arm{at}::on_command, this, _1));
}}

void Arm{at}::on_command(const std_msgs::msg::String & msg)
{{
  std_msgs::msg::String answer;
  answer.data = msg.data;
  pub_->publish(answer);
}}
{helpers}
}}  // namespace {name}

int main(int argc, char ** argv)
{{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<{name}::Arm{at}>());
  rclcpp::shutdown();
}}
"""
_CPP_HELPER = """
double step_{at}(double speed, double limit)
{{
  for (int joint = 0; joint < 6; ++joint) {{
    if (speed * joint > limit) {{
      RCLCPP_DEBUG(rclcpp::get_logger("arm"), "joint %d is slow", joint);
    }}
  }}
  return speed > limit ? limit : speed;
}}
"""
_CMAKE = """\
cmake_minimum_required(VERSION 3.8)
project({name})
find_package(ament_cmake REQUIRED)
find_package(rclcpp REQUIRED)
find_package(std_msgs REQUIRED)
include_directories(include)
{targets}
ament_package()
"""
_TARGET = """\
add_executable(arm_{at} src/arm_{at}.cpp)
ament_target_dependencies(arm_{at} rclcpp std_msgs)
install(TARGETS arm_{at} DESTINATION lib/${{PROJECT_NAME}})
"""
_LAUNCH = """\
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
{nodes}
    ])
"""
_STARTED = "        Node(package='{name}', executable='{exe}', remappings=[('a', 'b')]),"
_PARAMETERS = "driver_{at}:\n  ros__parameters:\n    rate: 5.0\n"
_NODES = 5
_HELPERS = 16


def _python_package(name: str) -> Mapping[str, str]:
    nodes = range(_NODES)
    helpers = "".join(_HELPER.format(at=at) for at in range(_HELPERS))
    scripts = ", ".join(f"'driver_{at} = {name}.driver_{at}:main'" for at in nodes)
    started = (_STARTED.format(name=name, exe=f"driver_{at}") for at in nodes)
    topics = ", ".join(f"'{name}/cmd_{at}'" for at in nodes)
    return {
        "package.xml": _PACKAGE.format(name=name, library="rclpy", build="ament_python"),
        "setup.py": _SETUP.format(name=name, scripts=scripts),
        f"{name}/__init__.py": "",
        f"{name}/topics.py": f"NAMES = [{topics}]\n",
        **{
            f"{name}/driver_{at}.py": _PYTHON.format(name=name, at=at, helpers=helpers)
            for at in nodes
        },
        "launch/all.launch.py": _LAUNCH.format(nodes="\n".join(started)),
        "config/all.yaml": "".join(_PARAMETERS.format(at=at) for at in nodes),
        "resource/notes.md": "# Notes\n" * 50,
    }


def _cpp_package(name: str) -> Mapping[str, str]:
    nodes = range(_NODES)
    helpers = "".join(_CPP_HELPER.format(at=at) for at in range(_HELPERS))
    topics = "".join(f'constexpr char TOPIC_{at}[] = "{name}/arm_{at}";\n' for at in nodes)
    started = (_STARTED.format(name=name, exe=f"arm_{at}") for at in nodes)
    found = {
        "package.xml": _PACKAGE.format(name=name, library="rclcpp", build="ament_cmake"),
        "CMakeLists.txt": _CMAKE.format(
            name=name, targets="".join(_TARGET.format(at=at) for at in nodes)
        ),
        f"include/{name}/topics.hpp": f"#pragma once\n{topics}",
        "launch/all.launch.py": _LAUNCH.format(nodes="\n".join(started)),
        "msg/State.msg": "std_msgs/Header header\nfloat64[] angles\n",
    }
    for at in nodes:
        found[f"include/{name}/arm_{at}.hpp"] = _HEADER.format(name=name, at=at)
        found[f"src/arm_{at}.cpp"] = _CPP.format(name=name, at=at, helpers=helpers)
    return found


def workspace(root: Path, packages: int) -> None:
    """Make a workspace, half of whose packages are of Python and half of C++."""
    for at in range(packages):
        name = f"package_{at}"
        for path, text in (_cpp_package if at % 2 else _python_package)(name).items():
            file = root / name / path
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text)


def rows() -> Iterator[Row]:
    with TemporaryDirectory() as folder:
        root = Path(folder, "src")
        workspace(root, 100)
        files = sum(len(names) for _, _, names in os.walk(root))
        cold = median(_run(root, f"cold{at}") for at in range(3))
        yield Row("lint of 100 packages, cold", cold, 5, "s", f"{files:,} files")
        _run(root, "warm")
        warm = median(_run(root, "warm") for _ in range(5))
        yield Row("lint of 100 packages, warm", warm, 0.5, "s")
        yield Row("lint of 100 packages, warm / cold", warm / cold, 0.2)
        edited = median(_run_edited(root, at) for at in range(5))
        yield Row("lint of 100 packages, one source edited / cold", edited / cold, 0.6)
    with TemporaryDirectory() as folder:
        root = Path(folder, "src")
        workspace(root, 1_000)
        for name in ("cold", "warm"):
            peak = _peak(root)
            yield Row(f"memory of lint, 1,000 packages, {name}", peak, 500, "MB")


def _command(root: Path, cache: str) -> tuple[list[str], dict[str, str]]:
    command = [sys.executable, "-m", "plastron_tui", "lint", str(root)]
    return command, {**ENVIRON, "XDG_CACHE_HOME": str(root.parent / cache)}


def _run(root: Path, cache: str) -> float:
    command, environ = _command(root, cache)
    start = time.perf_counter()
    done = subprocess.run(command, capture_output=True, env=environ, check=False)
    spent = time.perf_counter() - start
    assert done.returncode in (0, 1), done.stderr
    return spent


def _run_edited(root: Path, number: int) -> float:
    file = root / "package_0" / "package_0" / "driver_0.py"
    file.write_text(f"{file.read_text()}# edit {number}\n")
    return _run(root, "warm")


def _peak(root: Path) -> float:
    """Return the most memory of a run in MB, looked at as often as that costs it little."""
    command, environ = _command(root, "cache")
    peak = 0
    quiet = subprocess.DEVNULL
    with subprocess.Popen(command, stdout=quiet, stderr=quiet, env=environ) as process:
        while process.poll() is None:
            peak = max(peak, sum(map(_memory, (process.pid, *_children(process.pid)))))
            time.sleep(0.05)
    return peak / 1024


def _children(process: int) -> list[int]:
    with suppress(OSError):
        found = Path(f"/proc/{process}/task/{process}/children").read_text()
        return [int(each) for each in found.split()]
    return []


def _memory(process: int) -> int:
    """Return the memory of a process in kB, what it shares with others by its part in it."""
    with suppress(OSError, StopIteration):
        lines = Path(f"/proc/{process}/smaps_rollup").read_text().splitlines()
        return int(next(each for each in lines if each.startswith("Pss:")).split()[1])
    return 0
