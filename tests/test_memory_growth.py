"""A long day does not grow the memory; `python -m benchmarks.memory` lives through a longer one."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest


# The resident memory grows in steps of some 7 MB, of which two may come in the half that counts.
@pytest.mark.long(5)
@pytest.mark.parametrize(
    ("work", "steps", "most"), [("rounds", 500, 1.1), ("keys", 600, 1.16)], ids=["rounds", "keys"]
)
def test_the_memory_stays(work: str, steps: int, most: float) -> None:
    command = [sys.executable, "-m", "benchmarks.memory", work, str(steps)]
    root = Path(__file__).parent.parent
    done = subprocess.run(command, check=True, capture_output=True, cwd=root, text=True)
    assert float(done.stdout) < most, done.stderr
