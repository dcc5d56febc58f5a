from __future__ import annotations

import importlib.util
import sys
from pathlib import Path
from types import ModuleType

import pytest

from plastron_tui.diagnostics import codes
from plastron_tui.language import DECLARATIONS
from plastron_tui.session import Session

SCRIPT = Path(__file__).parents[2] / "scripts" / "build_docs.py"


@pytest.fixture(scope="module")
def script() -> ModuleType:
    spec = importlib.util.spec_from_file_location("build_docs", SCRIPT)
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module
    sys.path.append(str(SCRIPT.parent))  # as where it is run
    spec.loader.exec_module(module)
    return module


def test_the_committed_pages_are_what_the_source_says(script: ModuleType) -> None:
    assert script.main(["--check"]) == 0, "run scripts/build_docs.py"


def test_a_page_that_differs_fails_the_check(
    script: ModuleType, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(script, "DOCS", tmp_path)
    assert script.main([]) == 0
    assert script.main(["--check"]) == 0
    page = tmp_path / "language.md"
    page.write_text(page.read_text(encoding="utf-8") + "\n", encoding="utf-8")
    assert script.main(["--check"]) == 1
    assert script.main([]) == 0
    gone = tmp_path / "rules" / "RG999.md"
    gone.touch()
    assert script.main(["--check"]) == 1
    assert script.main([]) == 0
    assert not gone.exists()
    page.unlink()
    assert script.main(["--check"]) == 1


def test_every_code_has_an_entry(script: ModuleType) -> None:
    page = script.diagnostics_page()
    for code in codes.CODES.values():
        assert page.count(f"### `{code}`\n") == 1
        assert code.bad in page
        assert code.good in page


def test_every_statement_has_a_section(script: ModuleType) -> None:
    page = script.language_page()
    for declaration in DECLARATIONS.values():
        assert f"\n{declaration.usage}\n" in page
        assert f"\n{declaration.example}\n" in page
        assert declaration.summary in page
        for slot in declaration.slots:
            assert slot.help in page


def test_the_program_at_the_top_of_the_page_is_right(script: ModuleType, tmp_path: Path) -> None:
    program = script.language_page().split("```plastron\n")[1].split("```")[0]
    session = Session(program.encode(), tmp_path / "program.plastron", environ={})
    assert session.diagnostics == ()
    assert len(session.workspace.generations) == 1
