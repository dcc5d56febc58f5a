"""Long lines of Python are broken where `ruff format` breaks them."""

from __future__ import annotations

import subprocess
import sys

from plastron_tui.sources.python.layout import fit


def test_assigned_calls_break_as_ruff_breaks_them() -> None:
    """Names and texts of all lengths, where brackets of their own help and where they do not."""
    lines = [
        f'        self.{"k" * name} = self.create_lifecycle_publisher("{"q" * text}"{more})'
        for name in range(30, 80, 7)
        for text in range(20, 100, 4)
        for more in ("", ", 10", ", A, 10")
    ]
    made = fit("\n".join(["class A:", "    def f(self):", *lines, ""]))
    ruff = (sys.executable, "-m", "ruff", "format", "--isolated", "--no-cache", "-")
    assert subprocess.run(ruff, input=made, capture_output=True, text=True).stdout == made
