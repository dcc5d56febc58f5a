"""Launch files in YAML."""

from __future__ import annotations

from pathlib import Path

from plastron_tui.diagnostics import Diagnostic, codes
from plastron_tui.ros.launch import Format

from .xml_reader import LaunchRead


def read_launch_yaml(source: bytes, file: Path | None = None) -> LaunchRead:
    """Read a launch file in YAML."""
    found = Diagnostic(codes.BROKEN_LAUNCH, "launch files in YAML are not read yet", file=file)
    return LaunchRead(None, Format.YAML, None, (found,))
