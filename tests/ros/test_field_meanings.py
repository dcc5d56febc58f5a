"""What is known of the fields of messages is known of fields that there are."""

from __future__ import annotations

import pytest

from plastron_tui.ros.catalog import Catalog
from plastron_tui.ros.field_meanings import field_meanings, meaning_of, rank_of
from plastron_tui.ros.interfaces import Interface, InterfaceKind, InterfaceName, Section

MESSAGE, SERVICE = InterfaceKind.MESSAGE, InterfaceKind.SERVICE


def find(catalog: Catalog, name: str, kind: InterfaceKind) -> Interface | None:
    return catalog.find(InterfaceName(*name.split("/")), kind)


def has_field(catalog: Catalog, section: Section, path: list[str]) -> bool:
    for name in path:
        fields = {each.name: each.type for each in section.fields}
        if name not in fields:
            return False
        message = fields[name].message
        found = None if message is None else catalog.find(message, MESSAGE)
        section = found.sections[0] if found is not None else Section()
    return True


def test_the_fields_are_there_in_a_distribution() -> None:
    catalogs = [Catalog(each) for each in ("noetic", "jazzy")]
    for key, fields in field_meanings().items():
        name, _, part = key.partition(" ")
        found = [
            (catalog, interface.response if part else interface.sections[0])
            for catalog in catalogs
            for kind in (MESSAGE, SERVICE)
            if (interface := find(catalog, name, kind)) is not None
        ]
        assert found, key
        for path, meaning in fields.items():
            assert any(has_field(*each, path.split(".")) for each in found), (key, path)
            assert meaning.words and meaning.words == meaning.words.strip()


@pytest.mark.parametrize(
    ("type_", "path", "said"),
    [
        ("geometry_msgs/Twist", "linear.x", "m/s, forward, below 0 backward"),
        ("geometry_msgs/TwistStamped", "twist.linear.x", "m/s, forward, below 0 backward"),
        ("nav_msgs/Odometry", "twist.twist.linear.x", "m/s, how fast it goes forward"),
        ("sensor_msgs/LaserScan", "header.frame_id", "the part of the robot, or the map"),
        ("geometry_msgs/Vector3", "x", ""),
        ("std_msgs/String", "nowhere.at.all", ""),
    ],
)
def test_a_field_is_looked_up_from_the_outside(type_: str, path: str, said: str) -> None:
    catalog = Catalog("jazzy")
    interface = find(catalog, type_, MESSAGE)
    assert interface is not None
    found = meaning_of(catalog, interface, path.split("."))
    assert (found.said if found is not None else "").startswith(said)
    assert (found is None) == (not said)


def test_what_matters_most_comes_first() -> None:
    catalog = Catalog("noetic")
    scan = find(catalog, "sensor_msgs/LaserScan", MESSAGE)
    assert scan is not None
    paths = [["header", "seq"], ["angle_min"], ["range_min"], ["ranges"], ["header", "frame_id"]]
    ranked = sorted(paths, key=lambda path: rank_of(catalog, scan, path))
    assert [path[-1] for path in ranked] == ["ranges", "angle_min", "range_min", "frame_id", "seq"]


def test_an_answer_has_meanings_of_its_own() -> None:
    catalog = Catalog("jazzy")
    switch = find(catalog, "std_srvs/SetBool", SERVICE)
    assert switch is not None
    asked, answered = meaning_of(catalog, switch, ["data"]), switch.response
    done = meaning_of(catalog, switch, ["success"], answered)
    assert asked is not None and done is not None and done.first == "True"
    assert meaning_of(catalog, switch, ["success"]) is None
