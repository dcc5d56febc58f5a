from __future__ import annotations

from pathlib import Path

import pytest
from emitted import emitted_codes

from plastron_tui.diagnostics import CODES, IO_CODES, Code, Severity
from plastron_tui.session import Session

SHOWN = [pytest.param(code, id=name) for name, code in CODES.items() if code.bad]

# A warning mends nothing by itself; every other code is of an error.
WARNINGS = {"changed-after-generating", "service-provided-twice"}


def codes_of(program: str, folder: Path) -> list[tuple[str, Severity]]:
    session = Session(program.encode(), folder / "program.plastron", environ={})
    found = session.diagnostics
    if not found:
        found = session.plan()[1]
    return [(each.code, each.severity) for each in found]


@pytest.mark.parametrize("code", SHOWN)
def test_the_bad_program_gives_this_code_and_nothing_else(code: Code, tmp_path: Path) -> None:
    severity = Severity.WARNING if code.name in WARNINGS else Severity.ERROR
    assert codes_of(code.bad, tmp_path) == [(code.name, severity)]


@pytest.mark.parametrize("code", SHOWN)
def test_the_good_program_gives_nothing(code: Code, tmp_path: Path) -> None:
    assert codes_of(code.good, tmp_path) == []


def test_every_code_that_the_package_emits_is_listed() -> None:
    emitted = emitted_codes()
    unclear = [found for found in emitted if found.code is None]
    assert not unclear, "write the code out as a string"
    assert [found for found in emitted if found.code not in CODES] == []


def test_every_listed_code_is_emitted() -> None:
    assert set(CODES) - {found.code for found in emitted_codes()} == set()


@pytest.mark.parametrize("code", CODES.values(), ids=CODES)
def test_an_entry_is_whole(code: Code) -> None:
    assert code.name == code.name.lower()
    assert code.summary.endswith(".")
    assert bool(code.bad) == bool(code.good)
    assert code.bad == "" or code.bad.endswith("\n")


def test_every_code_of_a_program_is_shown_by_one() -> None:
    # What no program can show is about files, the machine, or what runs.
    from plastron_tui.diagnostics.program_codes import PROGRAM_CODES
    from plastron_tui.diagnostics.value_codes import VALUE_CODES

    assert [code.name for code in (*PROGRAM_CODES, *VALUE_CODES) if not code.bad] == []


def test_a_missing_file_of_a_load_is_an_error_of_the_program() -> None:
    assert set(CODES) >= IO_CODES
    assert "file-not-found" not in IO_CODES
