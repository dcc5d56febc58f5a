"""How large meshes are: where they are found, what is remembered, and what no mesh is."""

from __future__ import annotations

import json
import pickle
from collections.abc import Sequence
from math import hypot
from pathlib import Path

import pytest

from plastron_tui.boundary import find_boundary
from plastron_tui.limited_process import Limits, Reply
from plastron_tui.project.mesh_sizes import KnownMeshes, MeshSizes
from plastron_tui.ros.robots.description import Body, Description, Link, Mesh
from plastron_tui.runtime import meshes
from plastron_tui.runtime.meshes import Bounds, measure

CUBE = Bounds((0.0, -1.0, 0.0), (1.0, 1.0, 3.0))
OBJ = "v 0 0 0\nv 1 0 0\nv 0 2 3\nf 1 2 3\n"
STL = """\
solid a
facet normal 0 0 1
outer loop
vertex 0 0 0
vertex 1 0 0
vertex 0 2 3
endloop
endfacet
endsolid a
"""
DAE = """\
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset>{}<up_axis>Z_UP</up_axis></asset>
<library_geometries><geometry id="g"><mesh>
<source id="p"><float_array id="a" count="9">0 0 0 100 0 0 0 200 300</float_array>
<technique_common><accessor source="#a" count="3" stride="3"><param name="X" type="float"/>
<param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="1"><input semantic="VERTEX" source="#v" offset="0"/><p>0 1 2</p></triangles>
</mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node><instance_geometry url="#g"/></node>
</visual_scene></library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>
"""


def size(bounds: Bounds) -> tuple[float, ...] | None:
    corners = zip(bounds.least, bounds.most, strict=True)
    return None if bounds.reason else tuple(most - least for least, most in corners)


@pytest.fixture
def project(tmp_path: Path) -> Path:
    package = tmp_path / "project" / "rover"
    (package / "urdf").mkdir(parents=True)
    (package / "package.xml").write_text("<package format='3'><name>rover</name></package>")
    for name in ("rover/wheel.stl", "rover/urdf/beside.stl", "here.stl", "../beyond.stl"):
        (tmp_path / "project" / name).write_text("solid")
    return tmp_path / "project"


def test_meshes_are_found_and_measured_once(project: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[str] = []

    def measured(paths: Sequence[Path]) -> tuple[Bounds, ...]:
        asked.extend(each.name for each in paths)
        return (CUBE,) * len(paths)

    monkeypatch.setattr(meshes, "measure", measured)
    known = KnownMeshes()

    def sizes() -> MeshSizes:
        found = MeshSizes(project, find_boundary(project), {}, known)
        found.add_folder(project / "rover" / "urdf")
        return found

    uris = ["package://rover/wheel.stl", "beside.stl", "here.stl", "file://../beyond.stl"]
    corners = CUBE.least, CUBE.most
    bodies = tuple(Body(Mesh(uri)) for uri in uris)
    robot = Description("rover", {"base": Link("base", bodies, bodies)})
    assert sizes().outermost(robot) == dict.fromkeys(uris[:3], corners)
    assert sizes().bounds("here.stl") == corners
    assert sizes().bounds("beside.stl") == corners
    assert asked == ["wheel.stl", "beside.stl", "here.stl"]
    assert sizes().bounds("../beyond.stl") is sizes().bounds("none.stl") is None
    assert sizes().problem("none.stl") == ("it is not there", None)
    assert sizes().problem("here.stl") == ("", None)
    (project / "here.stl").write_text("changed")
    assert sizes().bounds("here.stl") == corners
    assert asked[3:] == ["here.stl"]
    # What the program puts into a package is beside the program before.
    assert sizes().bounds("package://made/here.stl") == corners
    assert sizes().bounds("package://rover/here.stl") == corners
    assert sizes().bounds("package://made/../../beyond.stl") is None
    # A package that comes later is found then.
    assert sizes().bounds("package://arm/arm.stl") is None
    (project / "arm").mkdir()
    (project / "arm" / "package.xml").write_text("<package><name>arm</name></package>")
    (project / "arm" / "arm.stl").touch()
    assert sizes().bounds("package://arm/arm.stl") == corners


def test_what_measures_meshes_may_come_later(
    project: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    sizes = MeshSizes(project, find_boundary(project), {}, KnownMeshes())
    monkeypatch.setattr("importlib.util.find_spec", lambda _: None)
    assert sizes.bounds("here.stl") is None
    reason, remedy = sizes.problem("here.stl")
    assert reason == "what measures meshes is not installed"
    assert remedy == "install what measures meshes with `pip install 'plastron-tui[meshes]'`"
    monkeypatch.setattr(meshes, "measure", lambda paths: (CUBE,) * len(paths))
    assert sizes.bounds("here.stl") == (CUBE.least, CUBE.most)


@pytest.mark.long
def test_what_is_outermost_of_a_mesh_is_measured(tmp_path: Path) -> None:
    """A ball of many points has about as many of them as there are directions."""
    trimesh = pytest.importorskip("trimesh")
    ball = trimesh.creation.icosphere(4, 0.5)
    inside = trimesh.creation.box((0.4, 0.4, 0.4))
    trimesh.util.concatenate([ball, inside]).export(tmp_path / "ball.stl")
    [found] = measure([tmp_path / "ball.stl"])
    assert 60 < len(found.points) < 80
    assert {round(hypot(*point), 2) for point in found.points} == {0.5}
    for axis in range(3):
        assert min(point[axis] for point in found.points) == pytest.approx(found.least[axis])
        assert max(point[axis] for point in found.points) == pytest.approx(found.most[axis])


@pytest.mark.long
def test_meshes_of_strangers_are_measured_or_refused(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    # However busy the machine is.
    monkeypatch.setattr(meshes, "_LIMITS", meshes._LIMITS._replace(wait=600))
    bomb = '<!DOCTYPE r [<!ENTITY a "aa"><!ENTITY b "&a;&a;">]><COLLADA>&b;</COLLADA>'
    right = {
        "a.obj": OBJ,
        "a.STL": STL,
        "metres.dae": DAE.format("").replace("00", ""),
        "centimetres.dae": DAE.format('<unit name="cm" meter="0.01"/>'),
        "library.obj": f"mtllib /etc/passwd\nusemtl a\n{OBJ}",
    }
    wrong = {
        "bomb.dae": (bomb, "it declares entities, which are not expanded"),
        "broken.dae": ("<COLLADA><asset>", "no element found"),
        "junk.stl": ("x" * 1000, ""),
        "empty.stl": ("", "it has no surface"),
        "promise.stl": (" " * 80 + "\x7f" * 4, ""),
        "nan.obj": (OBJ.replace("1 0 0", "nan 0 0").replace("3", "inf", 1), "without end"),
        "a.blend": ("BLENDER", "it ends in none of `.stl`, `.dae`, `.obj`"),
    }
    for name, text in right.items():
        (tmp_path / name).write_text(text)
    for name, (text, _) in wrong.items():
        (tmp_path / name).write_text(text)
    names = [*right, *wrong, "none.obj"]
    found = dict(zip(names, measure([tmp_path / name for name in names]), strict=True))
    for name in right:
        assert size(found[name]) == pytest.approx((1, 2, 3)), (name, found[name].reason)
        assert sorted(found[name].points) == [(0, 0, 0), (0, 2, 3), (1, 0, 0)]
    for name, (_, reason) in wrong.items():
        assert size(found[name]) is None, name
        assert reason in found[name].reason, found[name].reason
    assert "No such file" in found["none.obj"].reason


def test_a_mesh_that_ends_the_process_takes_no_other_with_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def run(code: str, request: bytes, limits: Limits, **_: object) -> Reply:
        paths = pickle.loads(request).paths
        if any(each.name == "bad.obj" for each in paths):
            return Reply(-9, b"")
        return Reply(0, json.dumps([{"bounds": [[0, 0, 0], [1, 2, 3]]} for _ in paths]).encode())

    monkeypatch.setattr(meshes, "run_limited", run)
    found = measure([tmp_path / name for name in ("a.obj", "bad.obj", "b.obj")])
    assert [size(each) for each in found] == [(1, 2, 3), None, (1, 2, 3)]
    assert found[1].reason == "its process ended with signal 9"


@pytest.mark.parametrize(
    "answer",
    [
        b"",
        b"\xff",
        b"{}",
        b"[1]",
        b"[]",
        b'[{"bounds": [[0, 0], [1]]}]',
        b"[" * 100_000,
        b"[{}, {}]",
    ],
)
def test_what_a_process_answers_is_not_believed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, answer: bytes
) -> None:
    monkeypatch.setattr(meshes, "run_limited", lambda *_, **__: Reply(0, answer))
    (found,) = measure([tmp_path / "a.obj"])
    assert size(found) is None
