"""The names of the package, each imported when it is first asked for."""

from __future__ import annotations

import subprocess
import sys

from plastron_tui import language


def test_all_names_of_the_package_can_be_had() -> None:
    assert set(language.__all__) == set(language._MODULES)
    for name in language.__all__:
        assert getattr(language, name) is not None


def test_whoever_asks_for_the_declarations_gets_all() -> None:
    code = """
from plastron_tui.language import DECLARATIONS
count = len(DECLARATIONS)
import plastron_tui.language.statements
assert count == len(DECLARATIONS) > 40, count
"""
    subprocess.run([sys.executable, "-c", code], check=True)
