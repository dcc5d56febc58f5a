"""Parameters that launch files and parameter files give to nodes."""

from __future__ import annotations

from pathlib import Path
from textwrap import dedent

import pytest
from parameter_packages import (
    CONFIG,
    LAUNCH,
    NODE,
    cpp,
    driver,
    found,
    launch,
    marked,
    package,
    python,
    told,
)

from plastron_tui.lint.rules.parameters_examples import GIVEN

CODES = ("RP301", "RP302", "RP303")

SPEED = python("self.declare_parameter('max_speed', 0.5)")
PID = python("self.declare_parameters('pid', [('kp', 1.0), ('ki', 0.0)])")
TYPES = python("""
    self.declare_parameter('rate', 1.0)
    self.declare_parameter('count', Parameter.Type.INTEGER)
    self.declare_parameter('frame', 'map')
    self.declare_parameter('on', False)
    self.declare_parameter('gains', [1.0, 2.0])
""")
OPEN = python("""
    import tools
    tools.declare_more(self)
    self.declare_parameter('max_speed', 0.5)
""")


def _config(text: str, block: str = "driver") -> str:
    lines = "".join(f"    {line}\n" for line in dedent(text).strip("\n").splitlines())
    return f"{block}:\n  ros__parameters:\n{lines}"


def _started_twice(parameters: str, other: str = "arm") -> dict[str, str]:
    """Return a package that starts `driver` and another program at one place."""
    includes = "".join(
        f'<include file="$(dirname)/one.launch.xml"><arg name="which" value="{each}"/></include>'
        for each in ("driver", other)
    )
    return {
        NODE: SPEED,
        "rover/rover/arm.py": python("self.declare_parameter('reach', 0.5)").replace(
            "'driver'", "'arm'"
        ),
        "rover/setup.py": GIVEN["rover/setup.py"].replace(
            "rover.driver:main'", "rover.driver:main', 'arm = rover.arm:main'"
        ),
        LAUNCH: launch(),
        "rover/launch/two.launch.xml": f"<launch>{includes}</launch>",
        "rover/launch/one.launch.xml": f"""
            <launch><arg name="which"/><node pkg="rover" exec="$(var which)">
            {parameters}
            </node></launch>
        """,
    }


RP301 = {
    "a slip": (SPEED, _config("max_sped: 1.0  # wrong")),
    "a key of no node": (SPEED, _config("max_speed: 1.0\nreverse: true  # wrong")),
    "a key for all nodes": (SPEED, _config("max_sped: 1.0  # wrong", "/**")),
    "a key below another": (PID, _config("pid:\n  kp: 1.0\n  kd: 1.0  # wrong")),
    "a key with dots": (PID, _config("pid.kp: 1.0\npid.k_i: 1.0  # wrong")),
    "a key above others": (PID, _config("pdi:  # wrong\n  kp: 1.0\n  ki: 1.0")),
    "a block of a node that declares nothing": (
        python("pass"),
        _config("max_speed: 1.0  # wrong\nreverse: true\nrate: 2.0"),
    ),
    "all that people do not only read": (
        python("pass"),
        _config("example_speed: 1.0\nreverse: true  # wrong\nrate: 2.0"),
    ),
    "the one that people do not only read": (
        python("pass"),
        _config("home_do_not_execute: 1.0\nreverse: true  # wrong"),
    ),
    "a word that begins as one for people": (SPEED, _config("home_do_nothing: 1.0  # wrong")),
    "an entry that shows how to write one": (
        SPEED,
        _config("max_speed: 1.0\nexample_home_do_not_execute: 1.0\nreverse: true  # wrong"),
    ),
    "a slip where more may be declared": (OPEN, _config("max_sped: 1.0  # wrong\nmore: 2")),
}
RP303 = {
    "an int for a float": (TYPES, _config("rate: 10  # wrong")),
    "a float for an int": (TYPES, _config("count: 10.5  # wrong")),
    "a text for a float": (TYPES, _config("rate: fast  # wrong")),
    "a number in quotes": (TYPES, _config("rate: '1.0'  # wrong")),
    "a number for a text": (TYPES, _config("frame: 12  # wrong")),
    "a word that is a bool": (TYPES, _config("frame: yes  # wrong")),
    "a number for a bool": (TYPES, _config("on: 1  # wrong")),
    "a value for a list": (TYPES, _config("gains: 1.0  # wrong")),
    "a list for a value": (TYPES, _config("rate: [1.0]  # wrong")),
    "a list of ints": (TYPES, _config("gains: [1, 2]  # wrong")),
    "a list of two types": (TYPES, _config("gains: [1, 2.0]  # wrong")),
}
RP302 = {
    "a slip": (SPEED, _config("max_speed: 1.0").replace("driver:", "drivr:  # wrong")),
    "another name": (SPEED, _config("max_speed: 1.0").replace("driver:", "wheels:  # wrong")),
    "a namespace": (
        SPEED,
        _config("max_speed: 1.0").replace("driver:", "/front/driver:  # wrong"),
    ),
}
WRONG = {
    f"{code} {name}": (code, {NODE: node, CONFIG: config})
    for code, cases in (("RP301", RP301), ("RP302", RP302), ("RP303", RP303))
    for name, (node, config) in cases.items()
}
WRONG |= {
    "RP301 in a launch file": (
        "RP301",
        {NODE: SPEED, LAUNCH: launch(driver("{\n'max_sped': 1.0,  # wrong\n}"))},
    ),
    "RP301 in a launch file, of a value that is not known": (
        "RP301",
        {
            NODE: SPEED,
            LAUNCH: launch(
                "DeclareLaunchArgument('top')",
                driver("{\n'max_sped': LaunchConfiguration('top'),  # wrong\n}"),
            ),
        },
    ),
    "RP301 of a node that starts with other arguments": (
        "RP301",
        {
            NODE: SPEED,
            LAUNCH: launch(
                "DeclareLaunchArgument('go', default_value='false')",
                driver(
                    "{\n'max_sped': 1.0,  # wrong\n}",
                    ", condition=IfCondition(LaunchConfiguration('go'))",
                ),
            ),
        },
    ),
    "RP301 in a launch file, beside what is for people": (
        "RP301",
        {
            NODE: SPEED,
            LAUNCH: launch(
                driver("{\n'home_do_not_execute': 1.0, 'example': 1,\n'reverse': True,  # wrong\n}")
            ),
        },
    ),
    "RP301 in a launch file, of all that one place starts": (
        "RP301",
        _started_twice("<param\nname='sped' value='1.0'/> # wrong"),
    ),
    "RP303 in a launch file": (
        "RP303",
        {NODE: SPEED, LAUNCH: launch(driver("{\n'max_speed': 1,  # wrong\n}"))},
    ),
    "RP301 of a file that no launch file hands on": (
        "RP301",
        {NODE: SPEED, LAUNCH: launch(), CONFIG: _config("max_speed: 1.0\nback: 1  # wrong")},
    ),
    "RP303 of a node that gets its name elsewhere": (
        "RP303",
        {
            NODE: TYPES,
            LAUNCH: launch(),
            CONFIG: _config("rate: 1.0\ncount: 1\non: yes\nframe: 12  # wrong", "front"),
        },
    ),
    "RP301 of a node whose options nobody uses": (
        "RP301",
        {
            NODE: python("pass", handed=", **options").replace("(self)", "(self, **options)"),
            CONFIG: _config("reverse: true  # wrong"),
        },
    ),
    "RP303 of a node of another package": (
        "RP303",
        {
            NODE: TYPES,
            LAUNCH: launch(),
            CONFIG: "",
            "config/driver.yaml": _config(
                "rate: 1.0\ncount: 1\nframe: 12  # wrong\na: 1\nb: 1\nc: 1\nd: 1"
            ),
        },
    ),
    "RP302 of a file that no launch file hands on": (
        "RP302",
        {
            NODE: SPEED,
            LAUNCH: launch(),
            CONFIG: _config("max_speed: 1.0").replace("driver:", "drvier:  # wrong"),
        },
    ),
    "RP302 of a node in a namespace": (
        "RP302",
        {
            NODE: SPEED,
            LAUNCH: launch(driver("CONFIG", ", namespace='front'")),
            CONFIG: _config("max_speed: 1.0").replace("driver:", "driver:  # wrong"),
        },
    ),
}


@pytest.mark.parametrize(("code", "files"), WRONG.values(), ids=WRONG)
def test_wrong_value_is_told_and_nothing_else(
    tmp_path: Path, code: str, files: dict[str, str]
) -> None:
    whole = package(files)
    assert told(tmp_path, whole, code) == marked(whole)


SHARES = [
    "FindPackageShare('rover').find('rover')",
    "FindPackageShare(package='rover').find(*word)",
]


@pytest.mark.parametrize(("share", "is_known"), zip(SHARES, (True, False), strict=True))
def test_file_in_the_share_of_a_package(tmp_path: Path, share: str, is_known: bool) -> None:
    text = launch(driver(f"{share} + '/config/driver.yaml'"))
    config = _config("max_sped: 1.0  # wrong").replace("driver:", "/**:")
    files = package({NODE: SPEED, LAUNCH: text, CONFIG: config})
    assert told(tmp_path, files, "RP301") == (marked(files) if is_known else [])


RIGHT = {
    "what is declared": {NODE: TYPES, CONFIG: _config("rate: 10.0\ncount: 1\non: yes\nframe: x")},
    "what every node has": {
        NODE: SPEED,
        CONFIG: _config("use_sim_time: true\nqos_overrides:\n  /scan:\n    depth: 1"),
    },
    "a name of another level": {NODE: SPEED, CONFIG: _config("max_speed: 1.0", "/**/driver")},
    "a node in a namespace": {
        NODE: SPEED,
        LAUNCH: launch(driver("CONFIG", ", namespace='front'")),
        CONFIG: _config("max_speed: 1.0", "/front/driver"),
    },
    "a node in the namespaces of several robots": {
        NODE: SPEED,
        CONFIG: _config("max_speed: 1.0", "/one/driver") + _config("max_speed: 2.0", "/two/driver"),
    },
    "more that may be declared": {NODE: OPEN, CONFIG: _config("reverse: true")},
    "a type that may change": {
        NODE: python(
            "self.declare_parameter('rate', 1.0, ParameterDescriptor(dynamic_typing=True))"
        ),
        CONFIG: _config("rate: 10"),
    },
    "a default that is computed": {
        NODE: python("self.declare_parameter('rate', 1.0 if ROS else 10)"),
        CONFIG: _config("rate: 10"),
    },
    "a node that starts with other arguments": {
        NODE: SPEED,
        LAUNCH: launch(
            "DeclareLaunchArgument('all', default_value='false')",
            driver("CONFIG"),
            "Node(package='other', executable='arm', name='arm', parameters=[CONFIG],"
            " condition=IfCondition(LaunchConfiguration('all')))",
        ),
        CONFIG: _config("reach: 1.0", "/**"),
    },
    "a block of another node": {
        NODE: SPEED,
        LAUNCH: launch(
            driver("CONFIG"),
            "Node(package='other', executable='arm', name='arm', parameters=[CONFIG])",
        ),
        CONFIG: _config("max_speed: 1.0") + _config("reach: 1.0", "arm"),
    },
    "no block for a node that is not read": {
        LAUNCH: launch(
            driver("CONFIG"),
            "Node(package='other', executable='arm', name='arm', parameters=[CONFIG])",
        ),
        CONFIG: _config("max_speed: 1.0") + _config("reach: 1.0", "arm_controller"),
    },
    "keys for people alone": {
        NODE: python("pass"),
        CONFIG: _config("example_speed: 1.0\nunused:\n  rate: 2.0\nhome_do_not_execute: 1"),
    },
    "what one of two declares that one place starts": _started_twice(
        "<param name='reach' value='1.0'/><param name='max_speed' value='1.0'/>"
    ),
    "what may be for a node that is not read, of two that one place starts": _started_twice(
        "<param name='reach' value='1.0'/>", "elsewhere"
    ),
    "a node of no package": {CONFIG: _config("reach: 1.0", "arm"), LAUNCH: launch()},
    "bytes": {
        NODE: python("self.declare_parameter('raw', Parameter.Type.BYTE_ARRAY)"),
        CONFIG: _config("raw: [1, 2]"),
    },
    "too few parameters to know a node by": {
        NODE: TYPES,
        LAUNCH: launch(),
        CONFIG: _config("rate: 1.0\ncount: 1\nframe: 12", "front"),
    },
    "a node of another package by a few of many parameters": {
        NODE: TYPES,
        LAUNCH: launch(),
        CONFIG: "",
        "config/driver.yaml": _config("rate: 1.0\nframe: 12\na: 1\nb: 1\nc: 1"),
    },
    "options that who makes the node decides": {
        NODE: python("pass", handed=", **options").replace(
            "__init__(self)", "__init__(self, **options)"
        ),
        "rover/rover/start.py": (
            "import rclpy\nfrom rover.driver import Driver\n\n\ndef main():\n    rclpy.init()\n"
            "    rclpy.spin(Driver(allow_undeclared_parameters=True))\n"
        ),
        CONFIG: _config("reverse: true"),
    },
    "aliases": {NODE: SPEED, CONFIG: "a: &a 1\n" + _config("max_sped: *a")},
    "no YAML": {NODE: SPEED, CONFIG: "ros__parameters: [\n"},
    "a deep file": {NODE: SPEED, CONFIG: "ros__parameters: " + "[" * 90_000},
}


@pytest.mark.parametrize("files", RIGHT.values(), ids=RIGHT)
def test_what_may_be_right_is_not_told(tmp_path: Path, files: dict[str, str]) -> None:
    assert told(tmp_path, package(files), *CODES) == []


CMAKE = """\
cmake_minimum_required(VERSION 3.8)
project(rover)
find_package(ament_cmake REQUIRED)
find_package(rclcpp REQUIRED)
add_executable(driver src/driver.cpp)
ament_target_dependencies(driver rclcpp)
install(TARGETS driver DESTINATION lib/${PROJECT_NAME})
ament_package()
"""
TYPED = cpp("""
    declare_parameter("rate", 1.0);
    double speed = 1;
    declare_parameter("max_speed", speed);
    declare_parameter<int>("count", 1.5);
    declare_parameter("frames", std::vector<std::string>());
    nav2_util::declare_parameter_if_not_declared(this, "gain", rclcpp::ParameterValue(1.0));
""")


def _in_cpp(text: str, config: str) -> dict[str, str]:
    """Return a package of one node in C++."""
    files = package({CONFIG: _config(config)})
    files = {name: text for name, text in files.items() if not name.endswith((".py", "setup.py"))}
    files[LAUNCH] = launch(driver("CONFIG"))
    files["rover/package.xml"] = files["rover/package.xml"].replace("ament_python", "ament_cmake")
    return files | {"rover/CMakeLists.txt": CMAKE, "rover/src/driver.cpp": text}


def test_a_node_in_cpp_that_declares_nothing_leaves_it_to_a_library(tmp_path: Path) -> None:
    assert told(tmp_path, _in_cpp(cpp(""), "rate: 1.0\nspeed: 1.0"), *CODES) == []


def test_values_of_nodes_in_cpp(tmp_path: Path) -> None:
    config = """
        rat: 1.0  # wrong
        max_speed: 1.0
        count: 2.5  # wrong
        frames: [1, 2]  # wrong
        gain: 1  # wrong
    """
    files = _in_cpp(TYPED, config)
    assert told(tmp_path, files, *CODES) == marked(files)


FIXES = {
    "RP301": ("max_sped: 1.0", "max_speed: 1.0"),
    "RP302": ("drivr:", "driver:"),
    "RP303": ("max_speed: 1\n", "max_speed: 1.0\n"),
}


@pytest.mark.parametrize("code", FIXES)
def test_fix_writes_what_was_meant(tmp_path: Path, code: str) -> None:
    wrong, right = FIXES[code]
    meant = "# Grüße\n" + _config("max_speed: 1.0\n")
    files = package({NODE: SPEED, CONFIG: meant.replace(right, wrong)})
    (told_of,) = found(tmp_path, files, code)
    assert told_of.fix is not None
    ((span, text),) = told_of.fix.edits
    written = files[CONFIG].encode()
    assert (written[: span.start] + text.encode() + written[span.end :]).decode() == meant
