from __future__ import annotations

import os
import shutil
import subprocess
import sys
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any
from xmlrpc.client import ServerProxy

import pytest
from command_line import Copies
from cpp_builds import real_prefix
from graph import Graph
from jazzy import jazzy_python
from machine import domain_id, free_port, skip_or_fail, wait_until
from processes import Process, processes, use_copies
from table_packages import NEEDED_ON_ROS2, made_packages, shared_cache

from plastron_tui.ros.installations import Origin
from plastron_tui.runtime.environment import Environment

ROS1_PYTHON = Path("/usr/bin/python3")
ROS1_INSTALL = (
    "ROS 1 is missing: apt-get install --no-install-recommends python3-rospy python3-roslaunch "
    "python3-rosmaster python3-rostopic python3-rosservice python3-rosnode python3-std-msgs "
    "python3-std-srvs python3-geometry-msgs python3-genpy python3-genmsg"
)
ROS1_MODULES = "rospy, rosmaster, roslaunch, genpy, std_msgs.msg, std_srvs.srv, geometry_msgs.msg"


@pytest.fixture(scope="session", autouse=True)
def plastron_is_copied(copied: Copies) -> None:
    """Start plastron, which only makes the nodes here, as a copy; tests/cli starts it anew."""
    use_copies(copied)


@pytest.fixture(scope="session", name="shared_cache")
def _shared_cache(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder of the user's cache, the same for all workers."""
    return shared_cache(tmp_path_factory)


@pytest.fixture(scope="session")
def ros1_services(shared_cache: Path) -> str:
    """The Python path with the packages of the services."""
    check = subprocess.run(
        [ROS1_PYTHON, "-c", f"import {ROS1_MODULES}"], capture_output=True, check=False
    )
    if check.returncode != 0:
        skip_or_fail(ROS1_INSTALL)
    environment = Environment(Origin.DEBIAN, 1, "noetic", ROS1_PYTHON)
    return made_packages(environment, shared_cache)["PYTHONPATH"]


@pytest.fixture(scope="session")
def ros1_env(
    ros1_services: str, tmp_path_factory: pytest.TempPathFactory
) -> Iterator[dict[str, str]]:
    """The environment of a master that listens on the loopback interface only."""
    home = tmp_path_factory.mktemp("ros1")
    uri = f"http://127.0.0.1:{(port := free_port())}/"
    kept = {name: os.environ[name] for name in ("PATH", "HOME", "LANG") if name in os.environ}
    env = {
        **kept,
        "ROS_MASTER_URI": uri,
        "ROS_IP": "127.0.0.1",
        "ROS_HOME": str(home),
        "ROS_LOG_DIR": str(home / "log"),
        "PYTHONPATH": ros1_services,
        "PYTHONUNBUFFERED": "1",
    }
    master = Process(["/usr/bin/roscore", "-p", str(port)], env, home / "roscore.log")
    try:
        wait_until(lambda: _answers(uri), "the master answers", 60)
        yield env
    finally:
        master.interrupt(20)


def _answers(uri: str) -> bool:
    try:
        return bool(ServerProxy(uri).getPid("/test")[0] == 1)
    except OSError:
        return False


def _parameters(master: Any) -> set[str]:
    code, message, found = master.getParam("/test", "/")
    assert code == 1 and isinstance(found, dict), message
    return set(found)


def _forget_nodes(master: Any) -> None:
    """Take off a master what nodes left there that were killed, as `rosnode cleanup` does."""
    publishers, subscriptions, services = master.getSystemState("/test")[2]
    for entries, forget in (
        (publishers, master.unregisterPublisher),
        (subscriptions, master.unregisterSubscriber),
    ):
        for topic, nodes in entries:
            for node in nodes:
                if node != "/rosout":
                    forget(node, topic, master.lookupNode("/test", node)[2])
    for service, nodes in services:
        for node in nodes:
            if node != "/rosout":
                master.unregisterService(node, service, master.lookupService("/test", service)[2])


@pytest.fixture
def ros1(ros1_env: dict[str, str], tmp_path: Path) -> Iterator[Graph]:
    logs = tmp_path / "ros1-logs"
    logs.mkdir()
    probe = Path(__file__).with_name("probe_ros1.py")
    master = ServerProxy(ros1_env["ROS_MASTER_URI"])
    before = _parameters(master)
    with processes() as started:
        yield Graph("rospy", ROS1_PYTHON, probe, ros1_env, logs, started)
    # The master goes on, and what it keeps would be that of the next test's nodes.
    for name in _parameters(master) - before:
        master.deleteParam("/test", f"/{name}")
    _forget_nodes(master)


ROS2_INSTALL = (
    "ROS 2 is missing: pip install ros-rclpy ros-rmw-fastrtps-cpp ros-std-msgs ros-std-srvs "
    "ros-geometry-msgs (or set PLASTRON_ROS2_PYTHON to a Python that has them)"
)
ROS2_BUILD_INSTALL = (
    "the tools that build an interface package are missing: ./dev setup dev, "
    "and apt-get install cmake make g++"
)
ROS2_BUILD_MODULES = "ament_package, catkin_pkg, rosidl_generator_py, rosidl_adapter, numpy"
ROS2_MODULES = "rclpy, rmw_fastrtps_cpp, std_msgs.msg, std_srvs.srv, geometry_msgs.msg"


@pytest.fixture(scope="session")
def ros2_python() -> Path:
    """A Python that has rclpy."""
    python = Path(os.environ.get("PLASTRON_ROS2_PYTHON", sys.executable))
    check = subprocess.run(
        [python, "-c", f"import {ROS2_MODULES}"], capture_output=True, check=False
    )
    if check.returncode != 0:
        skip_or_fail(ROS2_INSTALL)
    return python


@pytest.fixture(scope="session")
def ros2_services_env(ros2_python: Path, shared_cache: Path) -> dict[str, str]:
    """The environment with the packages of the services."""
    check = subprocess.run(
        [ros2_python, "-c", f"import {ROS2_BUILD_MODULES}"], capture_output=True, check=False
    )
    if check.returncode != 0 or not all(map(shutil.which, ("cmake", "make", "g++"))):
        skip_or_fail(ROS2_BUILD_INSTALL)
    environment = Environment(Origin.EXTRA, 2, "kilted", ros2_python)
    return made_packages(environment, shared_cache, NEEDED_ON_ROS2)


@pytest.fixture
def ros2(ros2_python: Path, tmp_path: Path) -> Iterator[Graph]:
    """A graph of its own, on the loopback interface only."""
    yield from _ros2(ros2_python, tmp_path, os.environ)


@pytest.fixture
def ros2_with_services(
    ros2_python: Path, ros2_services_env: dict[str, str], tmp_path: Path
) -> Iterator[Graph]:
    """A graph of its own, with the services of the language's table."""
    yield from _ros2(ros2_python, tmp_path, ros2_services_env)


def _ros2(python: Path, folder: Path, environ: Mapping[str, str]) -> Iterator[Graph]:
    logs = folder / "ros2-logs"
    logs.mkdir()
    env = {
        **environ,
        "ROS_DOMAIN_ID": domain_id(),
        "ROS_AUTOMATIC_DISCOVERY_RANGE": "LOCALHOST",
        "ROS_LOG_DIR": str(logs),
        "RMW_IMPLEMENTATION": "rmw_fastrtps_cpp",
    }
    probe = Path(__file__).with_name("probe_ros2.py")
    with processes() as started:
        yield Graph("rclpy", python, probe, env, logs, started)


@pytest.fixture
def jazzy(
    shared_cache: Path, tmp_path_factory: pytest.TempPathFactory, tmp_path: Path
) -> Iterator[Graph]:
    """A graph of its own of the older ROS 2, with an action of the language's table."""
    python = jazzy_python(tmp_path_factory)
    environment = Environment(Origin.EXTRA, 2, "jazzy", python)
    environ = made_packages(environment, shared_cache, ["example_interfaces"])
    yield from _ros2(python, tmp_path, environ)


# ROS 2 has no package of these that pip installs: they are built, which takes minutes.
@pytest.fixture(params=["ros1", pytest.param("ros2_with_services", marks=pytest.mark.long)])
def service_graph(request: pytest.FixtureRequest) -> Graph:
    """A graph of each generation, with the services of the language's table, and an action."""
    found: Graph = request.getfixturevalue(request.param)
    return found


@pytest.fixture(params=["ros1", "ros2"])
def graph(request: pytest.FixtureRequest) -> Graph:
    """A graph of each generation."""
    found: Graph = request.getfixturevalue(request.param)
    return found


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Leave out what only a real rclcpp can do, where there is the stand-in alone."""
    if real_prefix() is not None:
        return
    left_out = [item for item in items if "actors" in getattr(item, "fixturenames", ())]
    if left_out:
        config.hook.pytest_deselected(items=left_out)
        items[:] = [item for item in items if item not in left_out]
