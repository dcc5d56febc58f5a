"""Nodes of ROS 2 in C++ are clean for ament_cpplint, and for ament_uncrustify where there is one.

Who has the right to copy a file, and says so in it, its user knows.
"""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from hypothesis import Phase, given, settings
from machine import examples, skip_or_fail
from random_programs import random_programs
from test_rclcpp_text import PROGRAMS, rendered

pytestmark = pytest.mark.long

CPPLINT = Path(sys.executable).with_name("ament_cpplint")
UNCRUSTIFY = Path(sys.executable).with_name("ament_uncrustify")


def write(folder: Path, program: str, number: int) -> None:
    for library in ("rclcpp", "component"):
        for node, made in enumerate(rendered(program, library)):
            assert made.files is not None, made.diagnostics
            package = folder / f"{library}_{number}_{node}"
            # A source includes its own header first, which has its name.
            own = re.match(rb'(?s)//.*?\n\n#include "\w+/(\w+)\.hpp"', made.files.main)
            stem = "node" if own is None else own[1].decode()
            for name, text in made.files.texts:
                file = package / "src" / name.format(stem)
                file.parent.mkdir(parents=True, exist_ok=True)
                file.write_bytes(text)


def findings(folder: Path) -> str:
    if not CPPLINT.exists():
        skip_or_fail("ament_cpplint is missing: ./dev setup dev")
    linters = [[CPPLINT, "--filters=-legal/copyright"]]
    if UNCRUSTIFY.exists() and shutil.which("uncrustify"):
        linters.append([UNCRUSTIFY])
    # Each package has its own folder of headers, which is where a linter looks for a guard's name.
    folders = sorted(folder.glob("*/src")) + sorted(folder.glob("*/include"))
    found = [
        subprocess.run([*each, *folders], capture_output=True, text=True, check=False)
        for each in linters
    ]
    lines = [line for each in found for line in (each.stdout + each.stderr).splitlines()]
    if not any(each.returncode for each in found):
        return ""
    return "\n".join(line for line in lines if not line.startswith(("Done", "DEBUG", "No code")))


def test_what_the_programs_make_is_clean(tmp_path: Path) -> None:
    for number, program in enumerate(PROGRAMS):
        write(tmp_path, program.read_text(), number)
    assert findings(tmp_path) == ""


def test_what_random_programs_make_is_clean(tmp_path: Path) -> None:
    drawn: list[str] = []

    @settings(max_examples=examples(20), deadline=None, database=None, phases=[Phase.generate])
    @given(random_programs("rclpy"))
    def draw(program: str) -> None:
        drawn.append(program)

    draw()
    for number, program in enumerate(drawn):
        write(tmp_path, program, number)
    assert findings(tmp_path) == ""


def test_what_is_not_clean_is_found(tmp_path: Path) -> None:
    (tmp_path / "a/src").mkdir(parents=True)
    (tmp_path / "a/src/node.cpp").write_text("int main()\n{\n\treturn 0;\n}\n")
    assert "Tab found" in findings(tmp_path)
