from __future__ import annotations

import os
import sysconfig
import venv
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest

from plastron_tui.diagnostics import Severity, codes
from plastron_tui.ros import installations
from plastron_tui.ros.installations import Installation, Origin
from plastron_tui.runtime.environment import (
    Environment,
    Found,
    find_environments,
    missing_package,
    missing_packages,
    node_environ,
)

NOWHERE = Path("/no/such/python3")
EXTENSION = sysconfig.get_config_var("EXT_SUFFIX")
MakePython = Callable[..., Path]


@pytest.fixture
def make_python(tmp_path: Path) -> MakePython:
    """Makes an interpreter in whose packages there are the named ones, and middlewares."""

    def make(*packages: str, middlewares: tuple[str, ...] = (), name: str = "env") -> Path:
        root = tmp_path / name
        venv.create(root, symlinks=True)
        site = next(root.glob("lib/python3*/site-packages"))
        add(site, *packages)
        index(root, *middlewares)
        return root / "bin" / "python3"

    return make


def add(site: Path, *packages: str) -> None:
    for package in packages:
        (site / package).mkdir(parents=True)
        (site / package / "__init__.py").write_text("raise RuntimeError('this was imported')")
    if "rclpy" in packages:
        (site / "rclpy" / f"_rclpy_pybind11{EXTENSION}").touch()
        information = site / "rclpy-9.1.2.dist-info"
        information.mkdir()
        (information / "METADATA").write_text("Name: rclpy\nVersion: 9.1.2\n")


def index(prefix: Path, *middlewares: str) -> None:
    folder = prefix / "share" / "ament_index" / "resource_index" / "rmw_typesupport"
    folder.mkdir(parents=True)
    for middleware in ("rmw_implementation", *middlewares):
        (folder / middleware).touch()


def find(environ: dict[str, str], interpreter: Path, debian: Path = NOWHERE) -> Found:
    path = os.environ["PATH"]
    return find_environments(
        {"PATH": path, **environ}, interpreter=interpreter, debian_python=debian
    )


def test_the_python_packages_are_found(make_python: MakePython) -> None:
    python = make_python("rclpy", middlewares=("rmw_fastrtps_cpp",))
    found = find({}, python)
    assert found == Found((Environment(Origin.EXTRA, 2, "kilted", python),))
    assert found.environments[0].library == "rclpy"
    assert found.choose(2) == found.choose() == (found.environments[0], [])


def test_debian_s_rospy_is_found(make_python: MakePython) -> None:
    debian = make_python("rospy", "rosmaster")
    found = find({}, make_python(name="other"), debian)
    assert found == Found((Environment(Origin.DEBIAN, 1, "noetic", debian),))
    assert found.environments[0].library == "rospy"


def test_a_sourced_ros_goes_before_the_others(make_python: MakePython, tmp_path: Path) -> None:
    sourced = tmp_path / "ros"
    add(sourced / "site", "rclpy")
    index(sourced, "rmw_cyclonedds_cpp")
    python = make_python("rclpy", middlewares=("rmw_fastrtps_cpp",))
    debian = make_python("rospy", "rosmaster", name="debian")
    environ = {
        "PATH": str(python.parent),
        "ROS_VERSION": "2",
        "ROS_DISTRO": "jazzy",
        "AMENT_PREFIX_PATH": str(sourced),
        "PYTHONPATH": str(sourced / "site"),
    }
    found = find(environ, python, debian)
    assert [(one.origin, one.distribution) for one in found.environments] == [
        (Origin.SOURCED, "jazzy"),
        (Origin.EXTRA, "kilted"),
        (Origin.DEBIAN, "noetic"),
    ]
    assert found.choose(1)[0] == found.environments[2]
    extra = node_environ(found.environments[1], environ)
    assert not {"AMENT_PREFIX_PATH", "ROS_DISTRO", "ROS_VERSION"} & set(extra)
    assert extra["PYTHONPATH"] == ""
    assert node_environ(found.environments[0], environ)["ROS_DISTRO"] == "jazzy"


def problem(found: Found, ros_version: int | None = None) -> tuple[str, str, str]:
    environment, diagnostics = found.choose(ros_version)
    assert environment is None
    (diagnostic,) = diagnostics
    assert diagnostic.code in codes.CODES
    assert diagnostic.help is not None
    return diagnostic.code, diagnostic.message, diagnostic.help


@pytest.mark.parametrize(
    ("ros_version", "brought", "command"),
    [
        (None, "ROS 2 kilted", "pip install 'plastron-tui[ros2]'"),
        (2, "ROS 2 kilted", "pip install 'plastron-tui[ros2]'"),
        (1, "ROS 1 noetic", "sudo apt install python3-rospy python3-rosmaster python3-std-msgs"),
    ],
)
def test_no_ros_at_all(
    make_python: MakePython, ros_version: int | None, brought: str, command: str
) -> None:
    code, _, remedy = problem(find({}, make_python()), ros_version)
    assert (code, remedy) == ("no-ros", f"install {brought} with `{command}`")


def test_only_the_other_ros(make_python: MakePython) -> None:
    found = find({}, make_python(), make_python("rospy", "rosmaster", name="debian"))
    assert problem(found, 2)[:2] == (
        "no-ros",
        "no ROS 2 is on this machine, only ROS 1 noetic (Debian's)",
    )


def test_a_ros_that_is_not_sourced(
    make_python: MakePython, monkeypatch: pytest.MonkeyPatch
) -> None:
    humble = Installation(Origin.UNSOURCED, 2, "humble")
    monkeypatch.setattr(installations, "installed", lambda: (humble,))
    found = find({}, make_python(), make_python("rospy", "rosmaster", name="debian"))
    assert problem(found, 2) == (
        "no-ros",
        "ROS 2 humble is installed, but not sourced",
        "source it with `. /opt/ros/humble/setup.bash`",
    )
    assert found.choose(1)[0] is not None


@pytest.mark.parametrize(
    ("environ", "packages", "middlewares", "remedy"),
    [
        pytest.param(
            {},
            ("rclpy",),
            (),
            "install it with `pip install ros-rmw-fastrtps-cpp`",
            id="rclpy without a middleware",
        ),
        pytest.param(
            {"RMW_IMPLEMENTATION": "rmw_zenoh_cpp"},
            ("rclpy",),
            ("rmw_fastrtps_cpp",),
            "build `rmw_zenoh_cpp` from its definitions with colcon, and source the result, "
            "or unset RMW_IMPLEMENTATION",
            id="another middleware is asked for",
        ),
        pytest.param(
            {"ROS_VERSION": "2", "ROS_DISTRO": "humble"},
            (),
            (),
            "install it with `sudo apt install ros-humble-rclpy`",
            id="sourced without rclpy",
        ),
    ],
)
def test_half_a_ros_2(
    make_python: MakePython,
    environ: dict[str, str],
    packages: tuple[str, ...],
    middlewares: tuple[str, ...],
    remedy: str,
) -> None:
    python = make_python(*packages, middlewares=middlewares)
    found = find({"PATH": str(python.parent), **environ}, python)
    code, _, told = problem(found, 2)
    assert (code, told) == ("half-a-ros", remedy)


def test_half_a_ros_1(make_python: MakePython) -> None:
    found = find({}, make_python(name="other"), make_python("rospy"))
    code, _, remedy = problem(found, 1)
    assert (code, remedy) == (
        "half-a-ros",
        "install it with `sudo apt install python3-rosmaster`",
    )


def test_half_a_ros_beside_a_whole_one_is_a_warning(make_python: MakePython) -> None:
    found = find({}, make_python("rclpy"), make_python("rospy", "rosmaster", name="debian"))
    environment, (diagnostic,) = found.choose()
    assert environment is not None
    assert environment.library == "rospy"
    assert diagnostic.severity is Severity.WARNING
    assert found.choose(1) == (environment, [])


def test_rclpy_of_another_python_does_not_count(make_python: MakePython) -> None:
    python = make_python("rclpy", middlewares=("rmw_fastrtps_cpp",))
    (compiled,) = python.parent.parent.glob("lib/*/site-packages/rclpy/_rclpy_pybind11*")
    compiled.rename(compiled.with_name("_rclpy_pybind11.cpython-36m-x86_64-linux-gnu.so"))
    assert find({}, python) == Found(())


@pytest.mark.parametrize(
    ("origin", "distribution", "package", "remedy"),
    [
        (Origin.EXTRA, "kilted", "nav_msgs", "install it with `pip install ros-nav-msgs`"),
        (
            Origin.EXTRA,
            "kilted",
            "rover_msgs",
            "build `rover_msgs` from its definitions with colcon, and source the result",
        ),
        (
            Origin.SOURCED,
            "humble",
            "example_interfaces",
            "install it with `sudo apt install ros-humble-example-interfaces`",
        ),
    ],
)
def test_a_missing_package_is_named_with_its_remedy(
    make_python: MakePython, origin: Origin, distribution: str, package: str, remedy: str
) -> None:
    python = make_python("rclpy", "std_msgs", middlewares=("rmw_fastrtps_cpp",))
    environment = Environment(origin, 2, distribution, python)
    (missing,) = missing_packages(environment, ["std_msgs", package, package])
    assert missing_package(environment, missing).help == remedy


def test_packages_of_an_overlay_are_not_missing(make_python: MakePython, tmp_path: Path) -> None:
    environment = Environment(Origin.EXTRA, 2, "kilted", make_python("rclpy"))
    for overlay in ("first", "second"):
        add(tmp_path / overlay / "python", f"{overlay}_msgs")
    both = replace(environment, overlays=(tmp_path / "first", tmp_path / "second"))
    wanted = ["first_msgs", "second_msgs"]
    assert missing_packages(environment, wanted) == wanted
    assert missing_packages(both, wanted) == []
    own = node_environ(both, {"LD_LIBRARY_PATH": "/opt/lib"})
    libraries = [str(each / "lib") for each in both.overlays]
    assert own["LD_LIBRARY_PATH"].split(os.pathsep) == [*libraries, "/opt/lib"]


EXTRA = Environment(Origin.EXTRA, 2, "kilted", NOWHERE)
HUMBLE = Environment(Origin.SOURCED, 2, "humble", NOWHERE)
ROS1 = Environment(Origin.DEBIAN, 1, "noetic", NOWHERE)


def at_once(environment: Environment) -> dict[str, str]:
    """Return the variables by which the lines of a node come as soon as it prints them."""
    own = {"PYTHONUNBUFFERED": "1"}
    if environment.ros_version == 1:
        own["ROSCONSOLE_STDOUT_LINE_BUFFERED"] = "1"
    return own


@pytest.mark.parametrize(
    ("environment", "environ", "expected"),
    [
        (EXTRA, {}, {"ROS_AUTOMATIC_DISCOVERY_RANGE": "LOCALHOST"}),
        (
            EXTRA,
            {"ROS_STATIC_PEERS": "10.0.0.1", "ROS_AUTOMATIC_DISCOVERY_RANGE": "SUBNET"},
            {"ROS_AUTOMATIC_DISCOVERY_RANGE": "LOCALHOST"},
        ),
        (
            HUMBLE,
            {},
            {"ROS_AUTOMATIC_DISCOVERY_RANGE": "LOCALHOST", "ROS_LOCALHOST_ONLY": "1"},
        ),
        (
            ROS1,
            {"ROS_HOSTNAME": "robot", "ROS_MASTER_URI": "http://robot:11311"},
            {"ROS_IP": "127.0.0.1", "ROS_MASTER_URI": "http://127.0.0.1:4242"},
        ),
    ],
)
def test_nodes_speak_on_this_machine_only(
    environment: Environment, environ: dict[str, str], expected: dict[str, str]
) -> None:
    own = node_environ(environment, environ, master_uri="http://127.0.0.1:4242")
    assert own == {**at_once(environment), **expected}


@pytest.mark.parametrize("environment", [EXTRA, HUMBLE, ROS1])
def test_the_network_is_the_user_s(environment: Environment) -> None:
    environ = {"ROS_STATIC_PEERS": "10.0.0.1", "ROS_HOSTNAME": "robot", "ROS_IP": "10.0.0.2"}
    own = node_environ(environment, environ, network=True)
    assert own == {**at_once(environment), **environ}


def test_the_wheels_hook_does_not_reach_another_python(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("sys.prefix", "/env")
    environ = {
        "_ROS_WHEELS_BOOTSTRAP_COMPLETE": "1",
        "LD_LIBRARY_PATH": "/env/lib:/opt/own/lib:/env/lib/python3.11/site-packages/a.libs",
    }
    own = node_environ(ROS1, environ)
    assert "_ROS_WHEELS_BOOTSTRAP_COMPLETE" not in own
    assert own["LD_LIBRARY_PATH"] == "/opt/own/lib"


def test_a_workspace_on_top_of_the_python_packages(make_python: MakePython, tmp_path: Path) -> None:
    python = make_python("rclpy", middlewares=("rmw_fastrtps_cpp",))
    environ = {"PATH": str(python.parent), "AMENT_PREFIX_PATH": str(tmp_path / "install")}
    environment, _ = find(environ, python).choose()
    assert environment == Environment(Origin.SOURCED, 2, "kilted", python)
    assert node_environ(environment, environ)["AMENT_PREFIX_PATH"] == str(tmp_path / "install")
