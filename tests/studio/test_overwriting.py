"""What is written over is what was shown, and nothing else."""

from __future__ import annotations

from pathlib import Path

import pytest
from studio_driver import PROGRAM, Driver, studio

from plastron_tui.studio.main.screen import MainScreen
from plastron_tui.studio.recipes import Recipe


@pytest.fixture(autouse=True)
def _only_saving_asks(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(MainScreen, "look_at_disk", lambda _: None)


async def agree(driver: Driver, shown: str, path: Path, meanwhile: str | None) -> None:
    """Agree that a text goes, which somebody replaces before the answer comes."""
    await driver.until(lambda: f"-{shown}" in text_of(driver))
    if meanwhile is not None:
        path.write_text(meanwhile + "\n")
    await driver.pilot.press("o")


def text_of(driver: Driver) -> str:
    found = driver.app.screen.query("TextView")
    is_question = type(driver.app.screen).__name__ == "Question"
    return found.first().text if is_question and found else ""  # type: ignore[attr-defined]


async def test_a_program_is_asked_about_again_when_it_is_another(program: Path) -> None:
    async with studio(program) as driver:
        await driver.type("// mine\n")
        program.write_text("// one\n")
        await driver.pilot.press("ctrl+s")
        await agree(driver, "// one", program, "// two")
        await driver.until(lambda: "-// two" in text_of(driver))
        assert program.read_text() == "// two\n"
        await agree(driver, "// two", program, "// three")
        await driver.until(lambda: "-// three" in text_of(driver))
        await driver.pilot.press("escape")
        await driver.back()
        assert program.read_text() == "// three\n"
        assert driver.main.open.is_changed
        await driver.pilot.press("ctrl+s")
        await agree(driver, "// three", program, None)
        await driver.until(lambda: not driver.main.open.is_changed)
    assert program.read_text() == "// mine\n" + PROGRAM


async def test_so_is_a_file_that_a_recipe_is_to_replace(program: Path, tmp_path: Path) -> None:
    (tmp_path / "old.py").write_text("import rospy\n")
    recipe = Recipe("t", "d", tmp_path / "r.plastron", b"// recipe\n", (Path("old.py"),))
    mine = program.with_name("r.plastron")
    mine.write_text("// one\n")
    async with studio(program) as driver:
        driver.app.run_worker(driver.main.files.take_recipe(recipe))
        await driver.dialog("ChooseFile")
        await driver.pilot.press("enter")
        await agree(driver, "// one", mine, "// two")
        await driver.until(lambda: "-// two" in text_of(driver))
        assert mine.read_text() == "// two\n"
        await agree(driver, "// two", mine, None)
        await driver.until(lambda: driver.main.open.path == mine)
    assert mine.read_text() == "// recipe\n"
