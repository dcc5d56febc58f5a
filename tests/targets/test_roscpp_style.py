"""Nodes of ROS 1 in C++ are in the style of ROS 2, as its linters see it."""

from __future__ import annotations

from pathlib import Path

import pytest
from test_rclcpp_style import findings
from test_roscpp_text import LIBRARIES, PROGRAMS, rendered

pytestmark = pytest.mark.long


@pytest.mark.parametrize("layout", ["single", "split"])
def test_what_the_programs_make_is_clean(tmp_path: Path, layout: str) -> None:
    for number, program in enumerate(PROGRAMS):
        for library in LIBRARIES:
            made = rendered(program.read_text(), library, layout)
            for node, each in enumerate(made):
                assert each.files is not None, each.diagnostics
                package = tmp_path / f"{library}_{number}_{node}"
                header = each.files.main.partition(b'#include "')[2].partition(b'"')[0].decode()
                stem = Path(header).stem if layout == "split" else "node"
                for name, text in each.files.texts:
                    file = package / "src" / name.format(stem)
                    file.parent.mkdir(parents=True, exist_ok=True)
                    file.write_bytes(text)
    assert findings(tmp_path) == ""
