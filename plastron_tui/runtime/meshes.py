"""How large meshes are, measured by the package `trimesh` in a process that has limits."""

from __future__ import annotations

import importlib.util
import json
import os
import pickle
from collections.abc import Sequence
from math import isfinite
from pathlib import Path
from typing import Any, NamedTuple

from plastron_tui.limited_process import Limits, TimedOutError, run_limited, starting
from plastron_tui.ros.robots.description import Vector

KINDS = (".stl", ".dae", ".obj")
"""The endings of the files that are measured; those that RViz draws."""

REMEDY = "install what measures meshes with `pip install 'plastron-tui[meshes]'`"

_LIMITS = Limits(work=20, wait=60, memory=1024**3, reply=1_000_000, processes=0)
_LARGEST = 128 * 1024**2
_START = starting("plastron_tui.runtime.mesh_process")


class Bounds(NamedTuple):
    """The box around a mesh; without one, why nobody knows it.

    Attributes:
        least: the least x, y and z in it, in metres where the file says what its unit is.
        most: the greatest likewise.
        points: points of it whose convex hull is about that of the whole mesh.
        reason: why it is not known, to stand behind a colon.
        is_unable: whether that is because what measures meshes is not installed.
    """

    least: Vector = (0.0, 0.0, 0.0)
    most: Vector = (0.0, 0.0, 0.0)
    points: tuple[Vector, ...] = ()
    reason: str = ""
    is_unable: bool = False


_OTHER = Bounds(reason=f"it ends in none of {', '.join(f'`{each}`' for each in KINDS)}")
_UNABLE = Bounds(reason="what measures meshes is not installed", is_unable=True)


def measure(paths: Sequence[Path]) -> tuple[Bounds, ...]:
    """Measure meshes; their files are read whole, and no other ones.

    Args:
        paths: the files, which whoever calls this lets be read.
    """
    if importlib.util.find_spec("trimesh") is None:
        return (_UNABLE,) * len(paths)
    known = [each for each in paths if each.suffix.lower() in KINDS]
    measured = dict(zip(known, _measured(known), strict=True))
    return tuple(measured.get(each, _OTHER) for each in paths)


def _measured(paths: Sequence[Path]) -> list[Bounds]:
    """Measure in one process, as starting it takes longest; one by one where that fails."""
    if not paths:
        return []
    from .mesh_process import Request

    # The libraries behind numpy start as many threads as there are cores, each with much memory.
    environ = {"PATH": os.defpath, "LANG": "C.UTF-8", "OPENBLAS_NUM_THREADS": "1"}
    request = pickle.dumps(Request(tuple(paths), _LIMITS, _LARGEST))
    try:
        reply = run_limited(_START, request, _LIMITS, environ=environ)
    except TimedOutError:
        reason = f"measuring it does not end within {_LIMITS.wait} s"
    except OSError as error:
        reason = f"no process can be started for it: {error}"
    else:
        is_whole = reply.status == 0 and len(reply.text) <= _LIMITS.reply
        found = _read(reply.text) if is_whole else []
        if len(found) == len(paths):
            return found
        reason = reply.why(_LIMITS)
    if len(paths) == 1:
        return [Bounds(reason=reason)]
    return [bounds for each in paths for bounds in _measured([each])]


def _read(text: bytes) -> list[Bounds]:
    try:
        return [_bounds(each) for each in json.loads(text)]
    except (ValueError, KeyError, TypeError, AttributeError, RecursionError):
        return []


def _bounds(said: Any) -> Bounds:
    if said.get("missing"):
        return _UNABLE
    if "reason" in said:
        return Bounds(reason=str(said["reason"]))
    (a, b, c), (d, e, f) = (map(float, corner) for corner in said["bounds"])
    points = tuple((float(x), float(y), float(z)) for x, y, z in said.get("points", ()))
    if not all(isfinite(each) for point in ((a, b, c), (d, e, f), *points) for each in point):
        return Bounds(reason="it goes on without end")
    return Bounds((a, b, c), (d, e, f), points)
