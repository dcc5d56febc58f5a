"""Where the bodies of a whole robot are, held against another reader of its URDF."""

from __future__ import annotations

import io

import pytest
from drawn_robots import many_links, rover

from plastron_tui.output.graphs.robots.scales import seen_from_all
from plastron_tui.output.graphs.robots.solids import scene_of
from plastron_tui.ros.robots.description import Description
from plastron_tui.targets.robots.urdf import write_urdf


@pytest.mark.long
@pytest.mark.parametrize("robot", [rover(), many_links(40), many_links(40, seed=8)])
def test_views_are_as_large_as_what_yourdfpy_reads(robot: Description) -> None:
    from yourdfpy import URDF

    read = URDF.load(io.BytesIO(write_urdf(robot)), load_meshes=False)
    low, high = read.scene.bounds
    top, side, front = (each.frame for each in seen_from_all(scene_of(robot)))
    # Its spheres and cylinders are of triangles, with corners on the surface: a bit too small.
    assert (top.left, top.low, side.low) == pytest.approx(tuple(low), abs=2e-3)
    assert (top.right, top.high, side.high) == pytest.approx(tuple(high), abs=2e-3)
    # Rims have 32 corners here.
    assert (front.left, front.right) == pytest.approx((top.low, top.high), abs=2e-3)
