from __future__ import annotations

import fcntl
import os
import shutil
import subprocess
import sys
from collections.abc import Iterator, Mapping
from pathlib import Path
from xmlrpc.client import ServerProxy

import pytest
from graph import Graph
from interfaces import build
from interfaces import environ as interfaces_environ
from machine import domain_id, free_port, skip_or_fail, wait_until
from processes import Process, processes

ROS1_PYTHON = Path("/usr/bin/python3")
ROS1_INSTALL = (
    "ROS 1 is missing: apt-get install --no-install-recommends python3-rospy python3-roslaunch "
    "python3-rosmaster python3-rostopic python3-rosservice python3-rosnode python3-std-msgs "
    "python3-std-srvs python3-geometry-msgs python3-genpy python3-genmsg"
)
ROS1_MODULES = "rospy, rosmaster, roslaunch, genpy, std_msgs.msg, std_srvs.srv, geometry_msgs.msg"
GENERATOR = Path("/usr/lib/genpy/gensrv_py.py")

# Services of the language's table that Debian has no package for.
SERVICES = {
    "beginner_tutorials": {"AddTwoInts": "int64 a\nint64 b\n---\nint64 sum\n"},
    "mavros_msgs": {
        "WaypointClear": "---\nbool success\n",
        "WaypointPull": "---\nbool success\nuint32 wp_received\n",
    },
    "basics": {"WordCount": "string words\n---\nuint32 count\n"},
}


@pytest.fixture(scope="session")
def ros1_services(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with the Python packages of the services, made by Debian's generator."""
    check = subprocess.run(
        [ROS1_PYTHON, "-c", f"import {ROS1_MODULES}"], capture_output=True, check=False
    )
    if check.returncode != 0 or not GENERATOR.exists():
        skip_or_fail(ROS1_INSTALL)
    root = tmp_path_factory.mktemp("services")
    for package, services in SERVICES.items():
        definitions = root / "definitions" / package
        definitions.mkdir(parents=True)
        module = root / "python" / package / "srv"
        module.mkdir(parents=True)
        (module.parent / "__init__.py").touch()
        for name, text in services.items():
            file = definitions / f"{name}.srv"
            file.write_text(text)
            _generator("-p", package, "-o", str(module), str(file))
        _generator("--initpy", "-p", package, "-o", str(module))
    return root / "python"


def _generator(*arguments: str) -> None:
    done = subprocess.run(
        [ROS1_PYTHON, GENERATOR, *arguments], capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stdout + done.stderr


@pytest.fixture(scope="session")
def ros1_env(
    ros1_services: Path, tmp_path_factory: pytest.TempPathFactory
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
        "PYTHONPATH": str(ros1_services),
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


@pytest.fixture
def ros1(ros1_env: dict[str, str], tmp_path: Path) -> Iterator[Graph]:
    logs = tmp_path / "ros1-logs"
    logs.mkdir()
    probe = Path(__file__).with_name("probe_ros1.py")
    with processes() as started:
        yield Graph("rospy", ROS1_PYTHON, probe, ros1_env, logs, started)


ROS2_INSTALL = (
    "ROS 2 is missing: pip install ros-rclpy ros-rmw-fastrtps-cpp ros-std-msgs ros-std-srvs "
    "ros-geometry-msgs (or set PLASTRON_ROS2_PYTHON to a Python that has them)"
)
ROS2_BUILD_INSTALL = (
    "the tools that build an interface package are missing: ./dev setup dev, "
    "and apt-get install cmake make g++"
)
ROS2_BUILD_MODULES = "colcon_core, ament_package, rosidl_generator_py, rosidl_adapter, numpy"
ROS2_DEFINITIONS = {
    "example_interfaces": {
        "srv/AddTwoInts": SERVICES["beginner_tutorials"]["AddTwoInts"],
        "action/Fibonacci": "int32 order\n---\nint32[] sequence\n---\nint32[] sequence\n",
    },
    "mavros_msgs": {f"srv/{name}": text for name, text in SERVICES["mavros_msgs"].items()},
}
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
def ros2_services_env(
    ros2_python: Path, tmp_path_factory: pytest.TempPathFactory
) -> dict[str, str]:
    """The environment with the packages of the tests, which are built once for all workers."""
    check = subprocess.run(
        [ros2_python, "-c", f"import {ROS2_BUILD_MODULES}"], capture_output=True, check=False
    )
    if check.returncode != 0 or not all(map(shutil.which, ("cmake", "make", "g++"))):
        skip_or_fail(ROS2_BUILD_INSTALL)
    base = tmp_path_factory.getbasetemp()
    workspace = (base.parent if "PYTEST_XDIST_WORKER" in os.environ else base) / "interfaces"
    workspace.mkdir(exist_ok=True)
    prefix = ros2_python.parent.parent
    done = workspace / "done"
    with (workspace / "lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        if not done.exists():
            build(ROS2_DEFINITIONS, workspace, prefix)
            done.touch()
    return interfaces_environ(workspace / "install", prefix)


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


@pytest.fixture(params=["ros1", "ros2_with_services"])
def service_graph(request: pytest.FixtureRequest) -> Graph:
    """A graph of each generation, with the services of the language's table, and an action."""
    found: Graph = request.getfixturevalue(request.param)
    return found


@pytest.fixture(params=["ros1", "ros2"])
def graph(request: pytest.FixtureRequest) -> Graph:
    """A graph of each generation."""
    found: Graph = request.getfixturevalue(request.param)
    return found
