"""Types that are found by their full names alone, and mean nothing where a name is bare."""

from __future__ import annotations

from pathlib import Path

import pytest

from plastron_tui.ros.catalog import DISTRIBUTIONS, Catalog, data
from plastron_tui.ros.interfaces import InterfaceKind, InterfaceName

_ACTION, _MESSAGE = InterfaceKind.ACTION, InterfaceKind.MESSAGE
_TO_POSE = InterfaceName("nav2_msgs", "NavigateToPose")
_ROS2 = [name for name, version in DISTRIBUTIONS.items() if version == 2]


def _fields(catalog: Catalog, name: InterfaceName, kind: InterfaceKind, at: int) -> list[str]:
    found = catalog.find(name, kind)
    assert found is not None
    return [str(each.name) for each in found.sections[at].fields]


@pytest.mark.parametrize("distribution", _ROS2)
def test_all_of_them_can_be_read(distribution: str) -> None:
    catalog, further = Catalog(distribution), data.further(distribution)
    assert set(further) == data.FURTHER
    for package, definitions in further.items():
        for kind, types in definitions.items():
            for name in types:
                full = InterfaceName(package, name)
                assert catalog.find(full, InterfaceKind(kind)) is not None, full
                assert full not in catalog.names(InterfaceKind(kind))


@pytest.mark.parametrize(
    ("distribution", "result"), [("humble", ["result"]), ("jazzy", ["error_code", "error_msg"])]
)
def test_each_distribution_has_its_own(distribution: str, result: list[str]) -> None:
    assert _fields(Catalog(distribution), _TO_POSE, _ACTION, 1) == result


def test_bare_names_mean_what_they_did() -> None:
    catalog = Catalog("jazzy")
    assert catalog.candidates("Bool", _MESSAGE) == (InterfaceName("std_msgs", "Bool"),)
    assert catalog.candidates("NavigateToPose", _ACTION) == ()
    assert Catalog("noetic").find(_TO_POSE, _ACTION) is None
    assert catalog.find(InterfaceName("nav2_msgs", "Nothing"), _MESSAGE) is None


def test_definition_of_a_folder_goes_before(tmp_path: Path) -> None:
    folder = tmp_path / "nav2_msgs" / "action"
    folder.mkdir(parents=True)
    (folder / "NavigateToPose.action").write_text("string goal\n---\n---\n")
    catalog = Catalog("jazzy", type_folders=(tmp_path,))
    assert _fields(catalog, _TO_POSE, _ACTION, 0) == ["goal"]


def test_type_that_changed_is_not_known() -> None:
    # Its centre was a `geometry_msgs/Pose2D` up to Galactic.
    box = InterfaceName("vision_msgs", "BoundingBox2D")
    assert all(Catalog(each).find(box, _MESSAGE) is None for each in _ROS2)
