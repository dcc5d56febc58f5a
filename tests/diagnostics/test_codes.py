from __future__ import annotations

from pathlib import Path

import pytest

import plastron_tui
from plastron_tui.diagnostics import Code, Severity, codes
from plastron_tui.diagnostics.codes import GROUPS
from plastron_tui.session import Session

SHOWN = [pytest.param(code, id=name) for name, code in codes.CODES.items() if code.bad]


def codes_of(program: str, folder: Path) -> list[tuple[str, Severity]]:
    session = Session(program.encode(), folder / "program.plastron", environ={})
    found = session.diagnostics
    if not found:
        found = session.plan()[1]
    return [(each.code, each.severity) for each in found]


@pytest.mark.parametrize("code", SHOWN)
def test_the_bad_program_gives_this_code_and_nothing_else(code: Code, tmp_path: Path) -> None:
    assert codes_of(code.bad, tmp_path) == [(code, code.severity)]


@pytest.mark.parametrize("code", SHOWN)
def test_the_good_program_gives_nothing(code: Code, tmp_path: Path) -> None:
    assert codes_of(code.good, tmp_path) == []


def test_every_code_is_used() -> None:
    package = Path(plastron_tui.__file__).parent
    modules = [file for file in package.rglob("*.py") if "codes" not in file.parts]
    text = "\n".join(file.read_text() for file in modules)
    names = {code: code.upper().replace("-", "_") for code in codes.CODES}
    assert [code for code, name in names.items() if f"codes.{name}" not in text] == []
    assert all(getattr(codes, name) is codes.CODES[code] for code, name in names.items())


def test_each_entry_is_whole() -> None:
    for code in codes.CODES.values():
        assert code == code.lower()
        assert code.summary.endswith("."), code
        assert bool(code.bad) == bool(code.good), code
        assert code.bad == "" or code.bad.endswith("\n"), code


def test_every_code_of_a_program_is_shown_by_one() -> None:
    # What no program can show is about files, the machine, or what runs.
    shown = (
        code for group in ("sentences", "names", "meaning", "values") for code in GROUPS[group]
    )
    assert [code for code in shown if not code.bad] == []


def test_a_missing_file_of_a_load_is_an_error_of_the_program() -> None:
    assert codes.CANNOT_WRITE.is_io
    assert not codes.FILE_NOT_FOUND.is_io
