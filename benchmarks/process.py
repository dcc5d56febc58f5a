"""How long a whole process takes, against one that only imports what is needed at least."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

from .row import Row, paired

# Installed packages are compiled once; so is a checkout, where the environment allows it.
ENVIRON = {name: value for name, value in os.environ.items() if name != "PYTHONDONTWRITEBYTECODE"}

EXAMPLES = sorted(Path(__file__).parent.parent.joinpath("examples").glob("*.plastron"))


def rows() -> Iterator[Row]:
    check = [sys.executable, "-m", "plastron_tui", "check", *map(str, EXAMPLES)]
    least = [sys.executable, "-c", "import tree_sitter, yaml, click"]
    ours, theirs, ratio = paired(lambda: _run(check), lambda: _run(least), 25)
    yield Row(
        f"plastron check, {len(EXAMPLES)} examples / import tree_sitter, yaml, click",
        ratio,
        2,
        detail=f"{ours * 1e3:.0f} ms / {theirs * 1e3:.0f} ms",
    )


def _run(command: list[str]) -> None:
    subprocess.run(command, check=True, capture_output=True, env=ENVIRON)
