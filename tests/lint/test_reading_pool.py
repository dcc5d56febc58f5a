"""Processes that read files, and die of some of them.

Each test asks a process of its own: this one has threads, beside which none is started.
"""

from __future__ import annotations

import json
import signal
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

_GROUPS = [[f"{group}{each}" for each in range(8)] for group in "abcd"]
_ALL = sorted(value for group in _GROUPS for value in group)

_HEAD = f"""
import json, os, signal, sys, time
from pathlib import Path
from plastron_tui.project.linting.pool import Died, Pool

GROUPS = {_GROUPS}

def upper(value):
    return value.upper()

def deadly(value):
    if value in ("a3", "c0"):
        os.kill(os.getpid(), signal.SIGKILL)
    return value.upper()

def always_deadly(value):
    os._exit(1)

def dies_once(value):
    mark = Path(sys.argv[1], "died")
    if value == "b5" and not mark.exists():
        mark.touch()
        os._exit(1)
    return value.upper()

def endless(value):
    while value == "c3":
        pass
    return value.upper()

def slow(value):
    if not value.endswith("0"):
        time.sleep(600)
    return os.getpid()

def sorted_out(found):
    found = list(found)
    died = sorted(each.value for each in found if isinstance(each, Died))
    return [sorted(each for each in found if isinstance(each, str)), died]
"""


def _asked(body: str, *arguments: str) -> Any:
    command = [sys.executable, "-c", _HEAD + body, *arguments]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    assert done.stderr == ""
    return json.loads(done.stdout)


def _upper(*but: str) -> list[str]:
    return [each.upper() for each in _ALL if each not in but]


def test_all_values_come_back_from_how_many_processes_ever() -> None:
    found = _asked("""
told = []
for workers in (1, 2, 5):
    with Pool(upper, workers) as pool:
        told.append(sorted_out(pool.map(GROUPS)))
        # The same processes go on with what comes next.
        told.append(sorted_out(pool.map(GROUPS[:3])))
        told.append(sorted_out(pool.map([])))
print(json.dumps(told))
""")
    assert found == 3 * [[_upper(), []], [_upper()[:24], []], [[], []]]


def test_process_that_dies_takes_its_value_along_and_no_other(tmp_path: Path) -> None:
    once, some, ever = _asked(
        """
told = []
for function in (dies_once, deadly, always_deadly):
    with Pool(function, 2) as pool:
        told.append(sorted_out(pool.map(GROUPS)))
print(json.dumps(told))
""",
        str(tmp_path),
    )
    # One that is not to blame is tried again.
    assert (tmp_path / "died").exists()
    assert once == [_upper(), []]
    assert some == [_upper("a3", "c0"), ["a3", "c0"]]
    assert ever == [[], _ALL]


_LASTING = """
with Pool(slow if sys.argv[1] == "busy" else lambda value: os.getpid(), 2) as pool:
    found = pool.map(GROUPS)
    print(json.dumps([next(found)] if sys.argv[1] == "busy" else sorted(set(found))), flush=True)
    time.sleep(600)
"""


@pytest.mark.parametrize(("what", "way"), [("idle", signal.SIGKILL), ("busy", signal.SIGINT)])
def test_processes_end_with_the_one_that_started_them(what: str, way: int) -> None:
    with subprocess.Popen(
        [sys.executable, "-c", _HEAD + _LASTING, what],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
    ) as parent:
        assert parent.stdout is not None
        assert parent.stderr is not None
        assert json.loads(parent.stdout.readline())
        parent.send_signal(way)
        # They hold its standard error as long as they live: this comes back when they have ended.
        said = parent.stderr.read().decode()
    assert said.count("Traceback") == (way == signal.SIGINT)


def test_file_that_takes_for_ever_is_left_out() -> None:
    body = """
from plastron_tui.project.linting import pool as module
module._LONGEST = 0.3
with Pool(endless, 2) as pool:
    print(json.dumps(sorted_out(pool.map(GROUPS))))
"""
    rest = sorted(each.upper() for each in _ALL if each != "c3")
    assert _asked(body) == [rest, ["c3"]]
