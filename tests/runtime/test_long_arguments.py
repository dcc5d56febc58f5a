"""What is too long for a command line is in a file, and means the same there."""

from __future__ import annotations

from pathlib import Path

import pytest
import yaml

from plastron_tui.ros.parameter_values import yaml_text
from plastron_tui.runtime.long_arguments import ArgumentFiles

SHORT = ("--ros-args", "-r", "__node:=a", "-p", "speed:=1", "--params-file", "b.yaml")
LONG = "<robot>\n" + '<link name="é: := #"/>\n' * 10_000 + "</robot>\n"


def test_only_long_values_are_in_files_as_long_as_the_run() -> None:
    given = (*SHORT, "-p", f"robot_description:={yaml_text(LONG)}", "-p", "speed:=2")
    with ArgumentFiles() as files:
        assert files.placed(SHORT) == SHORT
        placed = files.placed(given)
        path = Path(placed[len(SHORT) + 1])
        assert placed == (*SHORT, "--params-file", str(path), "-p", "speed:=2")
        other = files.placed(given)[len(SHORT) + 1]
        assert other != str(path)
        found = yaml.safe_load(path.read_text(encoding="utf-8"))
        assert found == {"/**": {"ros__parameters": {"robot_description": LONG}}}
        assert path.parent.stat().st_mode & 0o077 == 0
    assert not path.parent.exists()


@pytest.mark.parametrize("word", ["x" * 200_000, "--log-level:=" + "x" * 200_000])
def test_what_is_no_parameter_stays(word: str) -> None:
    with ArgumentFiles() as files:
        assert files.placed(("-r", word)) == ("-r", word)
