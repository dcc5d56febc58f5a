"""Which types are variants of each other, and which packages belong together."""

from __future__ import annotations

from collections.abc import ItemsView
from pathlib import Path

import pytest

from plastron_tui.lint.sides import are_connected, is_variant
from plastron_tui.lint.tree import PackageFacts, SourceTree


@pytest.mark.parametrize(
    ("one", "other", "are_variants"),
    [
        ("Twist", "TwistStamped", True),
        ("PoseWithCovarianceStamped", "Pose", True),
        ("Point", "PointXYZ", True),
        ("IMU", "IMUData", True),
        ("Int32", "Int32MultiArray", True),
        ("Int32", "UInt32", False),
        ("Int8", "UInt8", False),
        ("Image", "CompressedImage", False),
        ("Joy", "Joystick", False),
        ("IM", "IMU", False),
    ],
)
def test_a_variant_has_whole_words_more_at_the_end(
    one: str, other: str, are_variants: bool
) -> None:
    assert is_variant(one, other) is is_variant(other, one) is are_variants


class _Counted(dict[str, PackageFacts]):
    """Packages that count how often somebody goes through them."""

    walks = 0

    def items(self) -> ItemsView[str, PackageFacts]:
        self.walks += 1
        return super().items()


def test_what_packages_need_is_looked_up_once_for_a_workspace() -> None:
    names = ("one", "other", "third")
    packages = _Counted({each: PackageFacts(Path(each), each, (2,), {}) for each in names})
    tree = SourceTree(Path(), packages)
    assert not any(are_connected(tree, "one", each) for each in names[1:])
    assert packages.walks == 1
