"""How large meshes are: where they are found, what is remembered, and what no mesh is."""

from __future__ import annotations

import pickle
import signal
from collections.abc import Sequence
from itertools import takewhile
from math import hypot
from pathlib import Path

import pytest

from plastron_tui.boundary import find_boundary
from plastron_tui.limited_process import Limits, Reply
from plastron_tui.project.mesh_sizes import KnownMeshes, MeshSizes
from plastron_tui.ros.robots.description import Body, Description, Link, Mesh
from plastron_tui.runtime import meshes
from plastron_tui.runtime.meshes import Bounds, Patience, measure

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

    def measured(paths: Sequence[Path], _: object) -> tuple[Bounds, ...]:
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
    monkeypatch.setattr(meshes, "measure", lambda paths, _: (CUBE,) * len(paths))
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
    assert "no such file" in found["none.obj"].reason


def answers(monkeypatch: pytest.MonkeyPatch, fails: str, status: int = -9) -> list[list[str]]:
    """Let processes measure what they are asked for until they come to one mesh; return that."""
    asked: list[list[str]] = []

    def run(code: str, request: bytes, limits: Limits, **_: object) -> Reply:
        names = [each.name for each in pickle.loads(request).paths]
        asked.append(names)
        fine = list(takewhile(lambda name: not name.startswith(fails), names))
        lines = b"".join(b'{"bounds": [[0, 0, 0], [1, 2, 3]]}\n' for _ in fine)
        is_whole = len(fine) == len(names)
        return Reply(0, lines) if is_whole else Reply(status, lines + b'{"bounds": [[0, 0, 0]')

    monkeypatch.setattr(meshes, "run_limited", run)
    return asked


def test_a_mesh_that_ends_the_process_takes_no_other_with_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    asked = answers(monkeypatch, "bad")
    found = measure([tmp_path / name for name in ("a.obj", "bad.obj", "b.obj")])
    assert [size(each) for each in found] == [(1, 2, 3), None, (1, 2, 3)]
    assert found[1].reason == "its process ended with signal 9"
    # It may be the others that used up the time: it is tried by itself.
    assert asked == [["a.obj", "bad.obj", "b.obj"], ["bad.obj", "b.obj"], ["b.obj"]]


def test_meshes_that_take_long_are_not_measured_without_end(
    project: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    asked = answers(monkeypatch, "bad", -signal.SIGXCPU)
    monkeypatch.setattr(meshes, "_work", lambda: 20.0 * len(asked))
    for number in range(50):
        (project / f"bad{number}.obj").touch()
    (project / "here.obj").touch()
    known = KnownMeshes()
    sizes = MeshSizes(project, find_boundary(project), {}, known)
    uris = [*(f"bad{number}.obj" for number in range(50)), "here.obj"]
    links = {uri: Link(uri, (Body(Mesh(uri)),)) for uri in uris}
    assert sizes.outermost(Description("r", links)) == {}
    assert len(asked) == 3
    assert sizes.problem("bad2.obj") == ("it works for more than 20 s", None)
    assert sizes.problem("bad3.obj") == ("other meshes take too long", None)
    assert len(asked) == 3
    # The next time those are measured that were not, and those that fail are not tried again.
    later = MeshSizes(project, find_boundary(project), {}, known)
    assert later.bounds("here.obj") == ((0, 0, 0), (1, 2, 3))
    assert asked[3:] == [["here.obj"]]
    assert later.problem("bad0.obj") == ("it works for more than 20 s", None)
    assert len(asked) == 4


def test_meshes_that_a_program_names_are_measured_together(
    project: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Starting a process takes a second: of 20 meshes a check took 20."""
    asked = answers(monkeypatch, "bad")
    for name in ("a.obj", "b.obj", "c.obj"):
        (project / name).touch()
    program = b"""\
r has_link 'a' shaped mesh "a.obj" weighing 1
r has_link 'b' shaped mesh uri="b.obj", scale=[1, 1, 1] weighing 1
r has_link 'c' shaped mesh "none.obj" weighing 1
r has_link 'd' shaped mesh "../../beyond.obj" weighing 1
"""
    boundary = find_boundary(project)
    sizes = MeshSizes(project, boundary, {}, KnownMeshes(), program)
    for name in ("a.obj", "b.obj"):
        assert sizes.bounds(name) == ((0, 0, 0), (1, 2, 3))
    assert asked == [["a.obj", "b.obj"]]
    assert sizes.bounds("none.obj") is None
    assert sizes.bounds("c.obj") == ((0, 0, 0), (1, 2, 3))
    assert asked[1:] == [["c.obj"]]


def test_meshes_that_are_measured_take_no_patience(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    asked = answers(monkeypatch, "bad")
    monkeypatch.setattr(meshes, "_work", lambda: 1.5 * len(asked))
    patience = Patience()
    for number in range(3):
        measure([tmp_path / f"{number}.obj"], patience)
    assert patience == Patience()


@pytest.mark.parametrize(
    "answer",
    [
        b"",
        b"\xff\n",
        b"{}\n",
        b"1\n",
        b"[]\n",
        b'{"bounds": [[0, 0], [1]]}\n',
        b"[" * 100_000 + b"\n",
        b"{}\n{}\n",
        b'{"bounds": [[0, 0, 0], [1, 2, 3]]}',
    ],
)
def test_what_a_process_answers_is_not_believed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, answer: bytes
) -> None:
    monkeypatch.setattr(meshes, "run_limited", lambda *_, **__: Reply(0, answer))
    (found,) = measure([tmp_path / "a.obj"])
    assert size(found) is None
