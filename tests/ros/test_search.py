"""Types are found by their names and by what they are for."""

from __future__ import annotations

from pathlib import Path

import pytest

from plastron_tui.ros.catalog import DISTRIBUTIONS, Catalog
from plastron_tui.ros.catalog.data import purposes
from plastron_tui.ros.interfaces import InterfaceKind
from plastron_tui.ros.search import FoundType, search_types

MESSAGE, SERVICE = InterfaceKind.MESSAGE, InterfaceKind.SERVICE
every_distribution = pytest.mark.parametrize("distribution", list(DISTRIBUTIONS))

# What one types, and what has to come first.
FIRST = [
    (MESSAGE, "distance", "Range"),
    (MESSAGE, "camera", "Image"),
    (MESSAGE, "picture", "Image"),
    (MESSAGE, "speed", "Twist"),
    (MESSAGE, "drive the robot", "Twist"),
    (MESSAGE, "battery", "BatteryState"),
    (MESSAGE, "arm", "JointState"),
    (MESSAGE, "map", "OccupancyGrid"),
    (MESSAGE, "on/off", "Bool"),
    (MESSAGE, "turn on a lamp", "Bool"),
    (MESSAGE, "text", "String"),
    (MESSAGE, "number", "Int32"),
    (MESSAGE, "decimal number", "Float32"),
    (MESSAGE, "gps", "NavSatFix"),
    (MESSAGE, "list of numbers", "Float32MultiArray"),
    (MESSAGE, "twist", "Twist"),
    (MESSAGE, "Tw", "Twist"),
    (MESSAGE, "laser", "LaserScan"),
    (MESSAGE, "std_msgs/Str", "String"),
    (MESSAGE, "std_msgs/msg/String", "String"),
    (MESSAGE, "Twsit", "Twist"),
    (MESSAGE, "temprature", "Temperature"),
    (MESSAGE, "how far away", "Range"),
    (MESSAGE, "turn it on or off", "Bool"),
    (SERVICE, "on/off", "SetBool"),
    (SERVICE, "switch", "SetBool"),
    (SERVICE, "reset", "Trigger"),
    (SERVICE, "sum", "AddTwoInts"),
    (SERVICE, "map", "GetMap"),
]


@pytest.fixture(scope="module", params=list(DISTRIBUTIONS))
def catalog(request: pytest.FixtureRequest) -> Catalog:
    return Catalog(request.param)


@pytest.mark.parametrize(("kind", "query", "name"), FIRST)
def test_the_first_is_what_a_beginner_means(
    catalog: Catalog, kind: InterfaceKind, query: str, name: str
) -> None:
    assert search_types(catalog, kind, query)[0].name.name == name


@pytest.mark.parametrize("kind", [MESSAGE, SERVICE])
def test_every_type_is_found_by_its_names_and_has_a_line(
    catalog: Catalog, kind: InterfaceKind
) -> None:
    everything = search_types(catalog, kind, "")
    assert sorted(found.name for found in everything) == list(catalog.names(kind))
    for found in everything:
        assert found in search_types(catalog, kind, found.name.name)
        assert search_types(catalog, kind, str(found.name))[0] == found
        assert catalog.candidates(found.written, kind) in ((found.name,), ())
        assert found.line == found.line.strip() != ""
        assert "\n" not in found.line
        assert len(found.line) <= 100


def test_what_is_described_exists_somewhere_and_once() -> None:
    for kind in InterfaceKind:
        names = {str(name) for each in DISTRIBUTIONS for name in Catalog(each).names(kind)}
        described = purposes()[kind.value]
        assert set(described) <= names
        for text in described.values():
            line, bar, words = text.partition(" | ")
            assert line and bar and words
            assert words.split() == list(dict.fromkeys(words.lower().split()))


@every_distribution
def test_every_type_that_comes_along_is_described(distribution: str) -> None:
    catalog = Catalog(distribution)
    actions = {str(name) for name in catalog.names(InterfaceKind.ACTION)}
    for kind in InterfaceKind:
        missing = {str(name) for name in catalog.names(kind)} - set(purposes()[kind.value])
        assert all(any(name.startswith(action) for action in actions) for name in missing), missing


def found(catalog: Catalog, kind: InterfaceKind, name: str) -> FoundType:
    return search_types(catalog, kind, name)[0]


def test_a_type_comes_with_its_fields_and_the_way_to_write_it() -> None:
    catalog = Catalog("jazzy")
    twist = found(catalog, MESSAGE, "Twist")
    assert (twist.package, twist.written) == ("geometry_msgs", "Twist")
    vector = "geometry_msgs/Vector3"
    assert twist.fields == (("linear", vector), ("angular", vector))
    switch = found(catalog, SERVICE, "SetBool")
    assert switch.fields == (("data", "bool"),)
    assert switch.answer == (("success", "bool"), ("message", "string"))
    # Two packages of this distribution have a type of this name.
    assert found(catalog, MESSAGE, "action_msgs/GoalStatus").written == "action_msgs/GoalStatus"


def test_what_leads_nowhere_finds_nothing(catalog: Catalog) -> None:
    assert search_types(catalog, MESSAGE, "zzzzqqqq") == []
    assert search_types(catalog, MESSAGE, "Twsit", is_lenient=False) == []
    assert search_types(catalog, MESSAGE, "  /  ") == search_types(catalog, MESSAGE, "")


def test_types_of_a_user_are_found_by_what_their_definitions_say(tmp_path: Path) -> None:
    folder = tmp_path / "rover" / "msg"
    folder.mkdir(parents=True)
    (folder / "Wheel.msg").write_text("# How often a wheel went round\n\nint32 turns\nbool slips\n")
    (folder / "Plain.msg").write_text("int32 turns\nbool slips\n")
    catalog = Catalog("noetic", [tmp_path])
    wheel = found(catalog, MESSAGE, "round")
    assert (str(wheel.name), wheel.line) == ("rover/Wheel", "How often a wheel went round")
    assert found(catalog, MESSAGE, "Plain").line == "Holds turns, slips"
    assert {str(each.name) for each in search_types(catalog, MESSAGE, "slips")} == {
        "rover/Wheel",
        "rover/Plain",
    }
