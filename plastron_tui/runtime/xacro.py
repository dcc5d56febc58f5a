"""Expanding the macros of robots by the package `xacro`, in a process that has limits.

Whether that may be is for who calls this to decide: it runs expressions that stand in files.
"""

from __future__ import annotations

import json
import os
import pickle
import sys
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import NamedTuple

from plastron_tui.diagnostics.wording import shortened
from plastron_tui.limited_process import Limits, TimedOutError, run_limited, starting
from plastron_tui.ros.catalog.distributions import DISTRIBUTIONS
from plastron_tui.ros.robots.macros import Arguments
from plastron_tui.sources.urdf.reach import Reach
from plastron_tui.sources.xml.outline import MOST_BYTES

from . import installing

_LIMITS = Limits(work=10, wait=60, memory=512 * 1024**2, reply=2 * MOST_BYTES, processes=0)
_START = starting("plastron_tui.runtime.xacro_process")
_DEBIAN_MODULES = Path("/usr/lib/python3/dist-packages")
_LONGEST = 500
_EXTRA = "pip install 'plastron-tui[xacro]'"


class Expanded(NamedTuple):
    """What a file's macros make of it.

    Attributes:
        text: the URDF, None where there is none.
        reason: why there is none.
        files: the files that were looked at besides, or were not there.
        missing: the argument without a value that the reason is, "" for none.
        asked: the arguments that the macros asked for, or give a default.
        unused: those that they were given, and did not ask for.
    """

    text: bytes | None
    reason: str = ""
    files: tuple[Path, ...] = ()
    missing: str = ""
    asked: tuple[str, ...] = ()
    unused: tuple[str, ...] = ()


def find_xacro(environ: Mapping[str, str]) -> Path | None:
    """Return the folder that has the module `xacro`, None where it is not installed.

    It is that of this Python, or of a ROS; nothing of it is run.
    """
    found = (each for each in _module_folders(environ) if (each / "xacro/__init__.py").is_file())
    return next(found, None)


def remedy(environ: Mapping[str, str]) -> str:
    """Say how one gets the package."""
    distribution = environ.get("ROS_DISTRO", "")
    of_ros = installing.of_distribution("xacro", distribution)
    return f"install it with `{of_ros if of_ros and distribution in DISTRIBUTIONS else _EXTRA}`"


def _module_folders(environ: Mapping[str, str]) -> Iterator[Path]:
    yield from (Path(each) for each in sys.path if os.path.isabs(each))  # noqa: PTH117
    for prefix in environ.get("AMENT_PREFIX_PATH", "").split(os.pathsep):
        if Path(prefix).is_absolute():
            yield from sorted(Path(prefix, "lib").glob("python3*/site-packages"))
    yield _DEBIAN_MODULES


def expand(
    path: Path, text: bytes, reach: Reach, modules: Path, arguments: Arguments = ()
) -> Expanded:
    """Expand the macros of a file.

    Args:
        path: where it is, as a whole path.
        text: what it holds.
        reach: how far it may lead.
        modules: the folder that has the module `xacro`, as `find_xacro` tells it.
        arguments: what its arguments are given.
    """
    from .xacro_process import Request

    request = pickle.dumps(Request(path, text, reach, _LIMITS, arguments))
    environ = {"PATH": os.defpath, "LANG": "C.UTF-8"}
    try:
        reply = run_limited(
            _START,
            request,
            _LIMITS,
            environ=environ,
            folder=path.parent,
            modules=(os.fspath(modules),),
        )
    except TimedOutError:
        return Expanded(None, f"expanding them does not end within {_LIMITS.wait} s")
    except OSError as error:
        return Expanded(None, f"no process can be started for it: {error}")
    head, _, expanded = reply.text.partition(b"\n")
    if reply.status != 0 or len(reply.text) > _LIMITS.reply:
        return Expanded(None, f"expanding them fails: {reply.why(_LIMITS)}")
    try:
        said = json.loads(head)
        reason, refused, opened = (said[each] for each in ("reason", "refused", "opened"))
        files = tuple(map(Path, map(str, opened)))
        asked, unused = (tuple(map(str, said[each])) for each in ("asked", "unused"))
        missing = "" if refused else str(said["missing"])
        reason = shortened(str(refused[0] if refused else reason), _LONGEST)
    except (ValueError, KeyError, TypeError, RecursionError):
        return Expanded(None, "expanding them fails")
    if reason:
        return Expanded(None, reason, files, missing, asked, unused)
    return Expanded(expanded, "", files, "", asked, unused)
