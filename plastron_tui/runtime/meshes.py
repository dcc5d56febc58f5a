"""How large meshes are, measured by the package `trimesh` in a process that has limits."""

from __future__ import annotations

import importlib.util
import json
import os
import pickle
from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass
from itertools import islice
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
        is_late: whether that is because others took too long.
    """

    least: Vector = (0.0, 0.0, 0.0)
    most: Vector = (0.0, 0.0, 0.0)
    points: tuple[Vector, ...] = ()
    reason: str = ""
    is_unable: bool = False
    is_late: bool = False


@dataclass(slots=True)
class Patience:
    """How long meshes may still take that take longer than they should.

    Attributes:
        seconds: so much; none is measured any more where nothing is left.
    """

    seconds: float = 60.0


_OTHER = Bounds(reason=f"it ends in none of {', '.join(f'`{each}`' for each in KINDS)}")
_LATE = Bounds(reason="other meshes take too long", is_late=True)
_FAIR = 2.0
"""The seconds that a mesh may take without being counted."""

_UNABLE = Bounds(reason="what measures meshes is not installed", is_unable=True)


def measure(paths: Sequence[Path], patience: Patience | None = None) -> tuple[Bounds, ...]:
    """Measure meshes; their files are read whole, and no other ones.

    Args:
        paths: the files, which whoever calls this lets be read.
        patience: how long it may take, besides what meshes commonly take; some of it is used up.
    """
    if importlib.util.find_spec("trimesh") is None:
        return (_UNABLE,) * len(paths)
    known = [each for each in paths if each.suffix.lower() in KINDS]
    measured = dict(zip(known, _measured(known, patience or Patience()), strict=True))
    return tuple(measured.get(each, _OTHER) for each in paths)


def _measured(paths: Sequence[Path], patience: Patience) -> list[Bounds]:
    """Measure in one process, as starting it takes longest; in more where one fails."""
    found: list[Bounds] = []
    while len(found) < len(paths):
        left = paths[len(found) :]
        if patience.seconds <= 0:
            return [*found, *(_LATE for _ in left)]
        before = _work()
        answered, reason = _answers(left)
        found += answered
        spent = max(_work() - before, reason.wait)
        patience.seconds -= max(0.0, spent - _FAIR * len(answered))
        # What comes after others gets the whole of the time for itself before it is blamed.
        if not answered:
            found.append(Bounds(reason=reason.text))
    return found


class _Reason(NamedTuple):
    """Why a process did not answer all, and the seconds that were waited in vain."""

    text: str
    wait: float = 0.0


def _answers(paths: Sequence[Path]) -> tuple[list[Bounds], _Reason]:
    """Return what a process finds out of the first of some meshes, and why not of all."""
    from .mesh_process import Request

    # The libraries behind numpy start as many threads as there are cores, each with much memory.
    environ = {"PATH": os.defpath, "LANG": "C.UTF-8", "OPENBLAS_NUM_THREADS": "1"}
    request = pickle.dumps(Request(tuple(paths), _LIMITS, _LARGEST))
    try:
        reply = run_limited(_START, request, _LIMITS, environ=environ)
    except TimedOutError:
        return [], _Reason(f"measuring it does not end within {_LIMITS.wait} s", _LIMITS.wait)
    except OSError as error:
        return [], _Reason(f"no process can be started for it: {error}", _LIMITS.wait)
    return list(islice(_read(reply.text), len(paths))), _Reason(reply.why(_LIMITS))


def _work() -> float:
    """Return the seconds of processor time of the processes that have ended."""
    times = os.times()
    return times.children_user + times.children_system


def _read(text: bytes) -> Iterator[Bounds]:
    """Read what a process says of meshes, a line each; one that it broke off is none."""
    with suppress(ValueError, KeyError, TypeError, AttributeError, RecursionError):
        for line in text.split(b"\n")[:-1]:
            yield _bounds(json.loads(line))


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
