"""Measures meshes, in a process of its own (`meshes`): files may be of any size and make."""

from __future__ import annotations

import importlib
import io
import json
import os
import pickle
import sys
from collections.abc import Callable, Iterator
from math import cos, pi, sin, sqrt
from pathlib import Path
from typing import Any, NamedTuple
from xml.parsers import expat

from plastron_tui.limited_process import Limits, limit_itself
from plastron_tui.regular_files import read_regular, reason

from .file_guard import guard_files, leave_network

_LONGEST_REASON = 300
_SPREAD = 48
_DIGITS = 6


class Request(NamedTuple):
    """What is to be measured.

    Attributes:
        paths: the files, which may be read.
        limits: what the process may use.
        largest: the most bytes of a file.
    """

    paths: tuple[Path, ...]
    limits: Limits
    largest: int


def main() -> int:
    """Measure what the standard input asks for; return the exit status."""
    request: Request = pickle.load(sys.stdin.buffer)
    reply = os.dup(1)
    with Path(os.devnull).open("w") as nowhere:
        sys.stdout = sys.stderr = nowhere
        # Each at once: one that ends this process does not take those before it along.
        for each in _answers(request):
            answer = json.dumps(each).encode() + b"\n"
            while answer:
                answer = answer[os.write(reply, answer) :]
    return 0


def _answers(request: Request) -> Iterator[dict[str, Any]]:
    trimesh = importlib.import_module("trimesh")
    try:
        importlib.import_module("collada")
        reads_collada = True
    except ImportError:
        reads_collada = False
    numpy = importlib.import_module("numpy")
    # The library behind it takes its memory at the first product, and ends the process without.
    numpy.ones((256, 256)) @ numpy.ones((256, 256))
    leave_network()
    limit_itself(request.limits)
    guard_files(_allowed(request.paths))
    for path in request.paths:
        if _kind(path) == "dae" and not reads_collada:
            yield {"missing": True}
            continue
        try:
            answer = _measured(trimesh, read_regular(path, request.largest), _kind(path))
        except OSError as error:
            answer = {"reason": reason(error)[:_LONGEST_REASON]}
        except MemoryError:
            most = request.limits.memory // 1024**2
            answer = {"reason": f"it needs more than {most} MB of memory"}
        # What a file has that is no mesh may be anything.
        except (Exception, SystemExit) as error:
            said = " ".join(str(error).split()) or type(error).__name__
            answer = {"reason": said[:_LONGEST_REASON]}
        yield answer


def _kind(path: Path) -> str:
    return path.suffix.lower().removeprefix(".")


def _measured(trimesh: Any, text: bytes, kind: str) -> dict[str, Any]:
    """Return the corners of a mesh and points of its hull, in metres where it has a unit.

    Raises:
        Exception: whatever is raised for what is no mesh.
    """
    metres = _metres(text) if kind == "dae" else 1.0
    # Of bytes, without what would find other files: no texture matters here.
    scene = trimesh.load(io.BytesIO(text), file_type=kind, force="scene", process=False)
    if scene.bounds is None:
        raise ValueError("it has no surface")
    return {
        "bounds": [[metres * float(each) for each in corner] for corner in scene.bounds],
        "points": [
            [float(f"{metres * float(each):.{_DIGITS}g}") for each in point]
            for point in _outermost(scene)
        ],
    }


def _outermost(scene: Any) -> list[Any]:
    """Return the points of a mesh that are farthest in each of many directions.

    Their hull is about that of all points, and says from each side about what one sees of it.
    """
    numpy = importlib.import_module("numpy")
    found: dict[tuple[float, ...], Any] = {}
    for name in scene.graph.nodes_geometry:
        placed, geometry = scene.graph[name]
        points = numpy.asarray(scene.geometry[geometry].vertices)
        points = points @ placed[:3, :3].T + placed[:3, 3]
        for direction in _directions():
            point = points[(points @ numpy.array(direction)).argmax()]
            found[tuple(point)] = point
    # Each part has its own; of all of them fewer are outermost.
    points = numpy.array(list(found.values()))
    numbers = {int((points @ numpy.array(each)).argmax()): None for each in _directions()}
    return [points[number] for number in numbers]


def _directions() -> list[tuple[float, float, float]]:
    """Return directions all around: along the axes and between them, and spread evenly."""
    steps = (-1.0, 0.0, 1.0)
    found = [(x, y, z) for x in steps for y in steps for z in steps if x or y or z]
    for at in range(_SPREAD):
        # Fibonacci's sphere: a spiral whose turns are the golden angle.
        height, angle = 1 - (2 * at + 1) / _SPREAD, at * pi * (3 - sqrt(5))
        across = sqrt(1 - height**2)
        found.append((across * cos(angle), across * sin(angle), height))
    return found


def _allowed(paths: tuple[Path, ...]) -> Callable[[str], bool]:
    """Return what tells whether a file is a mesh, or of a module that is imported late."""
    own = {os.path.realpath(each) for each in paths}
    modules = tuple(os.path.realpath(each) + os.sep for each in sys.path)

    def allows(name: str) -> bool:
        real = os.path.realpath(name)
        return real in own or real.startswith(modules)

    return allows


def _metres(text: bytes) -> float:
    """Return how many metres the unit of a COLLADA file is; entities are refused.

    RViz and Gazebo draw it so, whatever axis is up in the file (rviz: `mesh_loader.cpp`).
    """
    found: list[float] = []

    def start(name: str, attributes: dict[str, str]) -> None:
        if name.rpartition(":")[2] == "unit" and "meter" in attributes and not found:
            found.append(float(attributes["meter"]))

    def refuse(*_: object) -> None:
        raise ValueError("it declares entities, which are not expanded")

    parser = expat.ParserCreate()
    parser.StartElementHandler = start
    parser.EntityDeclHandler = refuse
    parser.Parse(text, True)
    return found[0] if found else 1.0
