"""What stands in a package of ROS 2 is clean for ament_flake8 and ament_pep257 as they are."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from ament_linters import findings
from hypothesis import HealthCheck, Phase, given, settings
from machine import examples, mostly_long
from random_programs import random_programs

from plastron_tui.diagnostics import has_errors
from plastron_tui.output.writer import write
from plastron_tui.session import Options, Session

EXAMPLES = Path(__file__).parents[3] / "examples"
ABOUT = 'described_as "Ann\'s nodes" maintained_by "Ann <ann@example.org>" licensed_under "MIT"'

# What each plugin that ament_flake8 asks for finds (package.xml of ament_flake8).
FOUND = {
    "A001": "id = 1\n",
    "B901": "try:\n    pass\nexcept:\n    pass\n",
    "C408": "x = dict()\n",
    "CNL100": "class A:\n    def b(self):\n        pass\n",
    "D401": 'def a():\n    """Adds."""\n',
    "E501": f"x = '{'a' * 99}'\n",
    "F401": "import a\n",
    "I100": "import b\nimport a\n",
    "Q000": 'x = "a"\n',
}


def packaged(program: str) -> str:
    """Return a program that puts the nodes it creates into a package, and starts them."""
    if "generate_package" in program:
        return program
    nodes = re.findall(r"^create_node .* as (\w+)", program, re.M)
    lines = [
        *("create_launch 'bringup' as bringup", f"create_package 'demo' as demo {ABOUT}"),
        *(f"bringup starts {node}" for node in nodes),
        *(f"demo contains {node}" for node in (*nodes, "bringup")),
        "generate_package demo\n",
    ]
    return "\n".join([program, *lines])


def put(program: str, folder: Path) -> Path:
    """Write the packages of a program, with launch files in Python."""
    folder.mkdir(exist_ok=True)
    (folder / "plastron.yaml").write_text("launch: python\n", encoding="utf-8")
    options = Options("rclpy", folder / "output")
    session = Session(program.encode(), folder / "a.plastron", options, environ={})
    assert not has_errors(session.diagnostics), session.diagnostics
    plan, found = session.plan()
    assert not has_errors([*found, *write(plan).diagnostics])
    return folder / "output"


@pytest.mark.parametrize("code", FOUND)
def test_linters_find_what_is_wrong(code: str, tmp_path: Path) -> None:
    """Without a plugin its rules would hold for anything."""
    (tmp_path / "a.py").write_text(FOUND[code], encoding="utf-8")
    assert any(f" {code} " in each for each in findings(tmp_path))


@pytest.mark.parametrize(
    "path",
    mostly_long(
        # What loads a node keeps that file's style.
        [each for each in sorted(EXAMPLES.glob("*.plastron")) if "change_node" not in each.stem],
        {"managed"},
        lambda path: path.stem,
    ),
)
def test_examples_are_clean(path: Path, tmp_path: Path) -> None:
    folder = put(packaged(path.read_text(encoding="utf-8")), tmp_path / "a")
    assert len(list(folder.glob("*/launch/*.launch.py"))) == 1
    assert findings(folder) == []


def drop_known(folder: Path, known: set[tuple[str, bytes]]) -> None:
    """Remove the files that are known already, by name and text: linters find the same in them."""
    for file in folder.rglob("*.py"):
        found = file.name, file.read_bytes()
        if found in known:
            file.unlink()
        known.add(found)


@pytest.mark.long
def test_random_nodes_are_clean(tmp_path: Path) -> None:
    made: list[Path] = []
    known: set[tuple[str, bytes]] = set()

    @settings(
        max_examples=examples(150),
        suppress_health_check=list(HealthCheck),
        phases=(Phase.explicit, Phase.reuse, Phase.generate),
    )
    @given(random_programs("rclpy"))
    def make(program: str) -> None:
        made.append(put(packaged(program), tmp_path / f"made_{len(made)}"))
        drop_known(made[-1], known)

    make()
    assert len(made) > 10
    # A node of each, and its test.
    assert len(list(tmp_path.rglob("*.py"))) > len(made)
    assert findings(tmp_path) == []
