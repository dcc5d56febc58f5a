"""A long day does not grow the memory; `python -m benchmarks.memory` lives through a longer one."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

MOST = 1.2


@pytest.mark.long(5)
@pytest.mark.parametrize(("work", "steps"), [("rounds", 1_200), ("keys", 1_500)])
def test_the_memory_stays(work: str, steps: int) -> None:
    command = [sys.executable, "-m", "benchmarks.memory", work, str(steps)]
    root = Path(__file__).parent.parent
    done = subprocess.run(command, check=True, capture_output=True, cwd=root, text=True)
    assert float(done.stdout) < MOST, done.stderr
