"""What README.md says of the folders is whole."""

from __future__ import annotations

import re
from pathlib import Path

ROOT = Path(__file__).parents[1]


def test_each_module_and_package_is_in_the_table_of_folders() -> None:
    table = re.findall(r"^\|(.+?)\| .+\|$", (ROOT / "README.md").read_text(), re.MULTILINE)
    listed = set()
    for name in re.findall(r"`plastron_tui/(.+?)`", "".join(table)):
        choices = re.fullmatch(r"\{(.+)\}(.+)", name)
        listed |= {f"{each}{choices[2]}" for each in choices[1].split(",")} if choices else {name}
    package = ROOT / "plastron_tui"
    modules = {path.name for path in package.glob("*.py") if not path.name.startswith("__")}
    packages = {f"{path.parent.name}/" for path in package.glob("*/__init__.py")}
    assert listed == modules | packages
