"""Inertia of shapes, against closed forms, trimesh and numpy."""

from __future__ import annotations

from math import pi

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from plastron_tui.ros.robots.description import Box, Cylinder, Mesh, Shape, Sphere, Tensor, Vector
from plastron_tui.ros.robots.inertia import is_possible, tensor_of, turned
from plastron_tui.ros.robots.transforms import rotation_matrix, seen_from

_ANGLES = st.floats(-7, 7)
_TURNS = st.tuples(_ANGLES, _ANGLES, _ANGLES)
_MOMENTS = st.one_of(st.floats(0, 10), st.sampled_from([0.0, 1.0, 2.0]))


def _matrix(tensor: Tensor) -> np.ndarray:
    ixx, ixy, ixz, iyy, iyz, izz = tensor
    return np.array([[ixx, ixy, ixz], [ixy, iyy, iyz], [ixz, iyz, izz]])


@pytest.mark.parametrize(
    ("shape", "size", "moments"),
    [
        # Tables of moments of inertia, for 12 kg, 3 kg and 5 kg.
        (Box((1.0, 2.0, 3.0)), None, (13.0, 10.0, 5.0)),
        (Cylinder(2.0, 4.0), None, (28.0, 28.0, 24.0)),
        (Sphere(0.5), None, (1.2, 1.2, 1.2)),
        (Mesh("a.stl"), (1.0, 2.0, 3.0), (13.0, 10.0, 5.0)),
    ],
)
def test_closed_forms(shape: Shape, size: Vector | None, moments: Vector) -> None:
    tensor = tensor_of(shape, 12.0, size)
    assert tensor is not None
    assert (tensor.ixx, tensor.iyy, tensor.izz) == pytest.approx(moments)
    assert tensor.ixy == tensor.ixz == tensor.iyz == 0


def test_a_mesh_of_unknown_size_has_none() -> None:
    assert tensor_of(Mesh("a.stl"), 1.0) is None


@given(_MOMENTS, _MOMENTS, _MOMENTS, _TURNS)
def test_what_a_body_can_have_is_told_as_by_eigenvalues(
    a: float, b: float, c: float, turn: Vector
) -> None:
    tensor = turned(Tensor(a, 0.0, 0.0, b, 0.0, c), rotation_matrix(turn))
    low, middle, high = np.linalg.eigvalsh(_matrix(tensor))
    spare = min(low + middle - high, low)
    # Just at the edge, a description of few digits is let through.
    if abs(spare) > 1e-4 * max(high, 1e-3):
        assert is_possible(tensor) is bool(spare > 0)


@given(st.lists(st.floats(-2, 2), min_size=6, max_size=6))
def test_any_matrix_is_told_as_by_eigenvalues(numbers: list[float]) -> None:
    tensor = Tensor(*numbers)
    low, middle, high = np.linalg.eigvalsh(_matrix(tensor))
    spare = min(low + middle - high, low)
    if abs(spare) > 1e-3:
        assert is_possible(tensor) is bool(spare > 0)


@pytest.mark.parametrize("wrong", [float("nan"), float("inf"), -float("inf"), 1e308])
def test_no_number_is_too_large_to_be_looked_at(wrong: float) -> None:
    is_possible(Tensor(wrong, wrong, 0.0, wrong, 0.0, 1.0))
    tensor_of(Sphere(wrong), wrong)
    tensor_of(Cylinder(wrong, wrong), wrong)
    tensor_of(Box((wrong, wrong, wrong)), wrong)


@given(_TURNS, _TURNS)
def test_axes_are_turned_as_matrices_are(one: Vector, other: Vector) -> None:
    frame, inner = np.array(rotation_matrix(one)), np.array(rotation_matrix(other))
    seen = seen_from(rotation_matrix(one), rotation_matrix(other))
    assert np.allclose(frame @ np.array(seen), inner)
    tensor = Tensor(1.0, 0.1, 0.2, 2.0, 0.3, 2.5)
    assert np.allclose(
        _matrix(turned(tensor, rotation_matrix(one))), frame @ _matrix(tensor) @ frame.T
    )


@pytest.mark.long
@pytest.mark.parametrize("turn", [(0.0, 0.0, 0.0), (pi / 2, 0.0, 0.0), (0.3, -0.7, 2.0)])
@pytest.mark.parametrize(
    ("shape", "close"),
    [
        (Box((0.4, 0.3, 0.1)), 1e-6),
        (Cylinder(0.1, 0.3), 1e-3),
        (Cylinder(0.5, 0.01), 1e-3),
        (Sphere(0.2), 5e-3),
        (Mesh("box.stl", (2.0, -1.0, 0.5)), 1e-6),
    ],
)
def test_as_trimesh_has_it(shape: Shape, close: float, turn: Vector) -> None:
    import trimesh

    size = (0.2, 0.6, 1.0)
    match shape:
        case Box(size=extents):
            mesh = trimesh.creation.box(extents)
        case Cylinder(radius=radius, length=length):
            mesh = trimesh.creation.cylinder(radius=radius, height=length, sections=256)
        case Sphere(radius=radius):
            mesh = trimesh.creation.icosphere(subdivisions=4, radius=radius)
        case Mesh(scale=scale):
            mesh = trimesh.creation.box(size)
            mesh.apply_scale(np.abs(scale))
            x, y, z = (abs(a * b) for a, b in zip(size, scale, strict=True))
            size = (x, y, z)
    rotation = np.eye(4)
    rotation[:3, :3] = rotation_matrix(turn)
    mesh.apply_transform(rotation)
    mesh.density = 5.0 / mesh.volume
    tensor = tensor_of(shape, 5.0, size)
    assert tensor is not None
    own = _matrix(turned(tensor, rotation_matrix(turn)))
    assert np.allclose(own, mesh.moment_inertia, atol=close * abs(own).max())
