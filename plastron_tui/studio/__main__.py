"""The studio alone: `python -m plastron_tui.studio [FILE]`, which a browser's server starts."""

from __future__ import annotations

import sys
from pathlib import Path

from .app import run

sys.exit(run(Path(sys.argv[1]) if len(sys.argv) > 1 else None))
