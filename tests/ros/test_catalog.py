from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest
from rosbags.interfaces import Nodetype
from rosbags.typesys import Stores, get_typestore

from plastron_tui.diagnostics import codes
from plastron_tui.ros.catalog import DISTRIBUTIONS, Catalog, moved, usual_distribution
from plastron_tui.ros.catalog.distributions import EXTRA_DISTRIBUTION, stand_in
from plastron_tui.ros.interfaces import Interface, InterfaceKind, InterfaceName
from plastron_tui.ros.primitives import primitive

MESSAGE, SERVICE, ACTION = InterfaceKind.MESSAGE, InterfaceKind.SERVICE, InterfaceKind.ACTION
STORES = {
    "noetic": Stores.ROS1_NOETIC,
    "humble": Stores.ROS2_HUMBLE,
    "jazzy": Stores.ROS2_JAZZY,
    "kilted": Stores.ROS2_KILTED,
    "lyrical": Stores.ROS2_LYRICAL,
}
# What a distribution has no more (common_interfaces 5.7.0 and 5.8.0).
GONE = {"lyrical": {"actionlib_msgs", "geometry_msgs/Pose2D"}}
COMMON_PACKAGES = {
    "actionlib_msgs",
    "diagnostic_msgs",
    "geometry_msgs",
    "nav_msgs",
    "sensor_msgs",
    "shape_msgs",
    "std_msgs",
    "stereo_msgs",
    "trajectory_msgs",
    "visualization_msgs",
}
ROS2_PACKAGES = {"builtin_interfaces", "action_msgs", "unique_identifier_msgs"}
SERVICES = {
    "std_srvs": ["Empty", "SetBool", "Trigger"],
    "nav_msgs": ["GetMap", "GetPlan", "LoadMap", "SetMap"],
    "sensor_msgs": ["SetCameraInfo"],
    "diagnostic_msgs": ["AddDiagnostics", "SelfTest"],
}

every_distribution = pytest.mark.parametrize("distribution", list(DISTRIBUTIONS))


def all_interfaces(catalog: Catalog) -> list[Interface]:
    found = [catalog.find(name, kind) for kind in InterfaceKind for name in catalog.names(kind)]
    return [interface for interface in found if interface is not None]


@every_distribution
def test_every_name_is_found_and_every_nested_message_too(distribution: str) -> None:
    catalog = Catalog(distribution)
    interfaces = all_interfaces(catalog)
    assert len(interfaces) == sum(len(catalog.names(kind)) for kind in InterfaceKind)
    for interface in interfaces:
        for section in interface.sections:
            for field in section.fields:
                if field.type.message is not None:
                    assert catalog.find(field.type.message, MESSAGE), (interface.name, field)
                else:
                    assert primitive(field.type.name, catalog.ros_version), (interface.name, field)
    assert catalog.problems == []


@every_distribution
def test_every_common_package_is_whole(distribution: str) -> None:
    catalog = Catalog(distribution)
    wanted = COMMON_PACKAGES | (ROS2_PACKAGES if catalog.ros_version == 2 else set())
    assert wanted - GONE.get(distribution, set()) <= set(catalog.packages(MESSAGE))
    store = get_typestore(STORES[distribution])
    names = set(catalog.names(MESSAGE))
    for full_name in store.fielddefs:
        package, _, name = full_name.split("/")
        if package in wanted:
            assert InterfaceName(package, name) in names
    for package, listed in SERVICES.items():
        have = [name.name for name in catalog.names(SERVICE) if name.package == package]
        assert have == listed


def described(description: object, ros_version: int) -> str:
    """Return a type of a `rosbags` store as a definition would write it."""
    assert isinstance(description, tuple)
    node, value = description
    if node is Nodetype.BASE:
        name = {"octet": "byte"}.get(value[0], value[0])
        return name + (f"<={value[1]}" if value[1] else "")
    if node is Nodetype.NAME:
        name = value.replace("/msg/", "/")
        builtin = {"builtin_interfaces/Time": "time", "builtin_interfaces/Duration": "duration"}
        return builtin.get(name, name) if ros_version == 1 else name
    element = described(value[0], ros_version)
    if node is Nodetype.ARRAY:
        return f"{element}[{value[1]}]"
    return f"{element}[<={value[1]}]" if value[1] else f"{element}[]"


@every_distribution
def test_fields_and_constants_are_those_of_an_independent_reading(distribution: str) -> None:
    catalog = Catalog(distribution)
    store = get_typestore(STORES[distribution])
    compared = 0
    for full_name, (constants, fields) in store.fielddefs.items():
        package, _, short = full_name.split("/")
        interface = catalog.find(InterfaceName(package, short), MESSAGE)
        if interface is None:
            assert package not in COMMON_PACKAGES
            continue
        own = [(field.name, str(field.type)) for field in interface.fields]
        theirs = [(name, described(type_, catalog.ros_version)) for name, type_ in fields]
        # The library leaves out what only a connection fills in, and fills empty messages.
        filler = ("structure_needs_at_least_one_member", "uint8")
        assert [pair for pair in own if pair != ("seq", "uint32")] == [
            pair for pair in theirs if pair not in (("seq", "uint32"), filler)
        ], full_name
        kept = {(constant.name, constant.value) for constant in interface.sections[0].constants}
        assert kept == {(name, value) for name, _, value in constants}, full_name
        compared += 1
    assert compared > 120


# (bare name, kind, package in ROS 1, package in ROS 2)
WELL_KNOWN = [
    *((name, MESSAGE, "std_msgs", "std_msgs") for name in ("String", "Char", "Int32", "Float32")),
    *(
        (name, MESSAGE, "geometry_msgs", "geometry_msgs")
        for name in ("Point", "Vector3", "Quaternion", "Pose2D", "Pose", "Twist")
    ),
    *((name, SERVICE, "std_srvs", "std_srvs") for name in ("Empty", "SetBool", "Trigger")),
    ("AddTwoInts", SERVICE, "beginner_tutorials", "example_interfaces"),
    ("WaypointClear", SERVICE, "mavros_msgs", "mavros_msgs"),
    ("WaypointPull", SERVICE, "mavros_msgs", "mavros_msgs"),
    ("WordCount", SERVICE, "basics", "basics"),
]


@every_distribution
@pytest.mark.parametrize(("bare", "kind", "ros1", "ros2"), WELL_KNOWN)
def test_a_well_known_name_has_one_meaning_whatever_else_there_is(
    tmp_path: Path, distribution: str, bare: str, kind: InterfaceKind, ros1: str, ros2: str
) -> None:
    other = tmp_path / "aaa" / kind.value / f"{bare}.{kind.value}"
    other.parent.mkdir(parents=True)
    other.write_text("---\n" if kind is SERVICE else "")
    catalog = Catalog(distribution, [tmp_path])
    package = ros1 if DISTRIBUTIONS[distribution] == 1 else ros2
    known = InterfaceName(package, bare)
    if str(known) in GONE.get(distribution, ()):
        assert catalog.candidates(bare, kind) == ()
        return
    assert catalog.candidates(bare, kind) == (known,)
    assert catalog.find(known, kind) is not None
    assert InterfaceName("aaa", bare) in catalog.names(kind)


def test_bare_names_that_mean_several_types_or_none() -> None:
    catalog = Catalog("jazzy")
    meanings = [str(name) for name in catalog.candidates("GoalStatus", MESSAGE)]
    assert meanings == ["action_msgs/GoalStatus", "actionlib_msgs/GoalStatus"]
    assert catalog.candidates("Nothing", MESSAGE) == ()
    assert catalog.candidates("String", SERVICE) == ()
    assert catalog.find(InterfaceName("std_msgs", "Nothing"), MESSAGE) is None
    assert catalog.find(InterfaceName("../noetic/std_msgs", "String"), MESSAGE) is None


def test_definitions_keep_defaults_bounds_and_words() -> None:
    catalog = Catalog("kilted")
    quaternion = catalog.find(InterfaceName("geometry_msgs", "Quaternion"), MESSAGE)
    assert quaternion is not None
    assert [field.default for field in quaternion.fields] == [0.0, 0.0, 0.0, 1.0]
    assert quaternion.comment.startswith("This represents an orientation")
    set_bool = catalog.find(InterfaceName("std_srvs", "SetBool"), SERVICE)
    assert set_bool is not None
    assert set_bool.response.fields[0].comment.startswith("indicate successful run")


def test_what_lyrical_has_changed() -> None:
    kilted, lyrical = Catalog("kilted"), Catalog("lyrical")
    old, new = set(kilted.names(MESSAGE)), set(lyrical.names(MESSAGE))
    gone = {name for name in old - new if name.package != "actionlib_msgs"}
    assert gone == {InterfaceName("geometry_msgs", "Pose2D")}
    assert InterfaceName("nav_msgs", "Trajectory") in new - old
    assert {name.package for name in new - old} == {"geometry_msgs", "nav_msgs", "rosgraph_msgs"}
    assert lyrical.names(SERVICE) == kilted.names(SERVICE)
    assert lyrical.names(ACTION) == kilted.names(ACTION)
    event = InterfaceName("lifecycle_msgs", "TransitionEvent")
    fields = [
        interface.fields[0].name
        for interface in (kilted.find(event, MESSAGE), lyrical.find(event, MESSAGE))
        if interface is not None
    ]
    assert fields == ["timestamp", "stamp"]


def test_the_usual_distributions() -> None:
    assert [usual_distribution(version) for version in (1, 2)] == ["noetic", EXTRA_DISTRIBUTION]


def test_an_unknown_distribution_is_refused() -> None:
    with pytest.raises(ValueError, match="no distribution"):
        Catalog("melodic")


@pytest.mark.parametrize(
    ("version", "name", "distribution"),
    [
        (1, "noetic", "noetic"),
        (1, "melodic", "noetic"),
        (1, "humble", "noetic"),
        (2, "humble", "humble"),
        (2, "kilted", "kilted"),
        (2, "lyrical", "lyrical"),
        (2, "rolling", "lyrical"),
        (2, "noetic", "lyrical"),
        (2, "foxy", "humble"),
        (2, "iron", "jazzy"),
    ],
)
def test_what_stands_for_a_distribution(version: int, name: str, distribution: str) -> None:
    assert stand_in(name, version) == distribution


@pytest.mark.parametrize(("version", "distribution"), [(1, "noetic"), (2, "lyrical")])
def test_what_moved_is_where_it_is_said_to_be(version: int, distribution: str) -> None:
    from plastron_tui.ros.catalog.moved import _MOVED, _NOTES

    catalog = Catalog(distribution)
    for name in _MOVED[version].values():
        kinds = {"AddTwoInts": SERVICE, "Fibonacci": ACTION}
        kind = kinds.get(name.name, MESSAGE)
        assert catalog.find(name, kind) is not None, name
    packages = {each.package for each in catalog.names(MESSAGE)}
    for name in _NOTES[version]:
        is_outside = version == 2 or name.package not in packages
        assert is_outside or catalog.find(name, MESSAGE), name
    assert moved(InterfaceName("std_msgs", "String"), version) is None
    assert "seq" in str(moved(InterfaceName("std_msgs", "Header"), version))


LOADS_NOTHING = """
import sys
from plastron_tui.ros.catalog import Catalog
assert "yaml" not in sys.modules
from plastron_tui.ros.catalog import data
from plastron_tui.ros.interfaces import InterfaceKind, InterfaceName
catalog = Catalog("noetic")
opened = []
sys.addaudithook(lambda event, args: opened.append(str(args[0])) if event == "open" else None)
(name,) = catalog.candidates("String", InterfaceKind.MESSAGE)
first = catalog.find(name, InterfaceKind.MESSAGE)
print(*sorted(path.rsplit("/", 1)[1] for path in opened if path.endswith(".yaml")))
opened.clear()
assert catalog.find(name, InterfaceKind.MESSAGE) is first
print(len(opened))
"""


def test_only_the_packages_that_are_needed_are_read() -> None:
    command = [sys.executable, "-c", LOADS_NOTHING]
    result = subprocess.run(command, capture_output=True, text=True, check=True)
    assert result.stdout.split() == ["index.yaml", "std_msgs.yaml", "0"]


def test_the_code_of_a_bad_definition_is_listed() -> None:
    assert "bad-definition" in codes.CODES


def test_a_type_without_a_definition_has_no_fields() -> None:
    catalog = Catalog("noetic")
    wheel, point = InterfaceName("my_msgs", "Wheel"), InterfaceName("geometry_msgs", "Point")
    with_wheel = catalog.with_undefined([(MESSAGE, wheel), (MESSAGE, point)])
    found = with_wheel.find(wheel, MESSAGE)
    assert found is not None
    assert found.fields == ()
    assert with_wheel.find(point, MESSAGE) == catalog.find(point, MESSAGE)
    assert catalog.find(wheel, MESSAGE) is None
