"""Plays a node of `chant`: says what it would do, and ends."""

from __future__ import annotations

import sys
from pathlib import Path

for line in Path(sys.argv[1]).with_suffix(".chanth").read_text().splitlines():
    print(line.strip())
