"""Recipes: each a program in `examples/` that works from where somebody saves it."""

from __future__ import annotations

import ast
import shutil
from pathlib import Path

import pytest
from machine import mostly_long
from studio_driver import studio

from plastron_tui.language.formatter import format_document
from plastron_tui.session import Options, Session
from plastron_tui.studio.recipes import Recipe, place_files, recipes, recipes_folder

RECIPES = recipes()
NEEDED = {
    "Talker and listener": "talker_listener",
    "Service and client": "service_and_client",
    "Drive a robot": "drive",
    "Sensor and processing": "sensor",
    "Relay between two topics": "relay",
    "A task that takes a while": "count",
    "Send a goal pose": "goal_pose",
    "Emergency stop": "emergency_stop",
    "Drive with a joystick": "joystick",
    "Drive at a set speed": "speed",
    "Rover": "rover",
    "Arm": "arm",
    "Sensor mast": "mast",
    "Change a ROS 1 node": "change_node",
    "Change a ROS 2 node": "change_node_ros2",
}

every_recipe = pytest.mark.parametrize("recipe", RECIPES, ids=lambda recipe: recipe.path.stem)


def test_what_a_beginner_needs_is_there() -> None:
    titles = {recipe.title: recipe.path.stem for recipe in RECIPES}
    assert titles.items() >= NEEDED.items()
    assert RECIPES[0].title == "Talker and listener"
    assert [bool(recipe.files) for recipe in RECIPES] == sorted(
        bool(recipe.files) for recipe in RECIPES
    )


def test_a_recipe_is_a_file_and_nothing_more(tmp_path: Path) -> None:
    (tmp_path / "wave.plastron").write_text("// Wave: an arm\n// goes up.\n\n// More.\n")
    (tmp_path / "no_comment.plastron").write_text("create_node 'arm' as arm\n")
    (tmp_path / "loads.plastron").write_text(
        "// Loads: files\nload 'a/b.py' as b\nload '../c.py' as c\nload d as d\n"
    )
    (tmp_path / "broken.plastron").write_bytes(b"\xff\xfe")
    (tmp_path / "other.txt").write_text("// Other: no recipe\n")
    found = [(each.title, each.description, each.files) for each in recipes(tmp_path)]
    assert found == [
        ("No comment", "", ()),
        ("Wave", "an arm goes up", ()),
        ("Loads", "files", (Path("a/b.py"),)),
    ]
    assert recipes(tmp_path / "nowhere") == ()


@every_recipe
def test_a_recipe_says_what_it_is(recipe: Recipe) -> None:
    assert recipe.title and recipe.description
    # The list of the welcome has this room in a window of eighty columns.
    assert len(recipe.title) <= 26
    assert len(recipe.description) <= 42


@every_recipe
@pytest.mark.parametrize("target", ["rospy", "rclpy"])
def test_a_recipe_generates_without_a_word_where_somebody_saves_it(
    recipe: Recipe, target: str, tmp_path: Path
) -> None:
    path = tmp_path / recipe.path.name
    path.write_bytes(recipe.text)
    placed = place_files(recipe, tmp_path)
    assert (placed.written, placed.kept, placed.problem) == (recipe.files, (), None)
    session = Session(recipe.text, path, Options(target=target), {})
    assert list(session.diagnostics) == []
    plan, problems = session.plan()
    assert plan.files and not problems
    for file in plan.files:
        if file.path.suffix == ".py":
            ast.parse(file.text)
    assert format_document(session.document) == recipe.text


async def choose(driver: object, recipe: Recipe) -> None:
    """Choose a recipe of the welcome, by keyboard."""
    dialog = await driver.dialog("Welcome")  # type: ignore[attr-defined]
    options = dialog.query_one("OptionList")
    titles = [str(option.prompt).strip() for option in options.options if not option.disabled]
    (at,) = (i for i, title in enumerate(titles) if title.startswith(recipe.title))
    assert recipe.description in titles[at]
    await driver.pilot.press("home", *["down"] * at, "enter")  # type: ignore[attr-defined]


# In the quick suite one of nodes, one of a robot, and one with files; each size has some.
SIZES = [(80, 24), (120, 40), (60, 20)]
OPENED = [(recipe.path.stem, SIZES[number % 3]) for number, recipe in enumerate(RECIPES)]
QUICK = ("talker_listener", "rover", "change_node")


@pytest.mark.parametrize("case", mostly_long(OPENED, [each for each in OPENED if each[0] in QUICK]))
async def test_a_recipe_is_opened_from_the_welcome(
    case: tuple[str, tuple[int, int]], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    stem, size = case
    (recipe,) = (each for each in RECIPES if each.path.stem == stem)
    monkeypatch.chdir(tmp_path)
    async with studio(None, size, welcome=True) as driver:
        await choose(driver, recipe)
        if recipe.files:
            dialog = await driver.dialog("ChooseFile")
            assert dialog.query_one("Input").value == recipe.path.name
            await driver.pilot.press("enter")
        await driver.back()
        assert driver.main.open.text == recipe.text
        assert driver.main.open.analysis.diagnostics == ()
        assert (driver.main.open.path is None) == (not recipe.files)
    for file in recipe.files:
        assert (tmp_path / file).read_bytes() == (recipes_folder() / file).read_bytes()
        assert [path.name for path in (tmp_path / file).parent.iterdir()] == [file.name]


async def test_a_recipe_is_opened_with_the_mouse() -> None:
    async with studio(None, (80, 24), welcome=True) as driver:
        dialog = await driver.dialog("Welcome")
        lines = [
            "".join(segment.text for segment in line) for line in dialog._compositor.render_strips()
        ]
        (row,) = (row for row, line in enumerate(lines) if RECIPES[2].title in line)
        await driver.pilot.click(offset=(lines[row].index(RECIPES[2].title), row))
        await driver.back()
        assert driver.main.open.text == RECIPES[2].text


def changing() -> Recipe:
    return next(recipe for recipe in RECIPES if recipe.path.stem == "change_node")


async def test_nothing_is_written_over(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    own = tmp_path / "nodes" / "sonar.py"
    own.parent.mkdir()
    shutil.copy(recipes_folder() / "nodes" / "sonar.py", own)
    own.write_text(own.read_text() + "# mine\n")
    mine = tmp_path / "change_node.plastron"
    mine.write_text("// mine\n")
    async with studio(None, welcome=True) as driver:
        await choose(driver, changing())
        await driver.dialog("ChooseFile")
        await driver.pilot.press("enter")
        await driver.dialog("Question")
        await driver.pilot.press("escape")
        await driver.back()
        assert mine.read_text() == "// mine\n"
        assert [path.name for path in tmp_path.iterdir() if path.is_file()] == [mine.name]
        assert driver.text == ""
        await driver.pilot.press("alt+0")
        await choose(driver, changing())
        dialog = await driver.dialog("ChooseFile")
        dialog.query_one("Input").value = "other"
        await driver.pilot.press("enter")
        await driver.back()
        assert driver.main.open.path == tmp_path / "other.plastron"
        assert "sonar.py was there already" in driver.notes()
    assert own.read_text().endswith("# mine\n")


async def test_a_recipe_with_files_can_be_refused(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    async with studio(None, welcome=True) as driver:
        await choose(driver, changing())
        await driver.dialog("ChooseFile")
        await driver.pilot.press("escape")
        await driver.back()
        assert driver.text == ""
    assert not list(tmp_path.glob("*.plastron"))
    assert not (tmp_path / "nodes").exists()


async def test_a_folder_that_cannot_be_made_is_said(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "nodes").write_text("a file\n")
    async with studio(None, welcome=True) as driver:
        await choose(driver, changing())
        await driver.dialog("ChooseFile")
        await driver.pilot.press("enter")
        await driver.back()
        assert "cannot make the folder `nodes`" in driver.notes()
        assert driver.text == ""
    assert not list(tmp_path.glob("*.plastron"))


@pytest.mark.parametrize("exists", [False, True])
@pytest.mark.parametrize("recipe", [RECIPES[0], changing()], ids=["alone", "with files"])
async def test_a_recipe_is_for_the_file_that_was_named(
    recipe: Recipe, exists: bool, tmp_path: Path
) -> None:
    mine = tmp_path / "mine.plastron"
    if exists:
        mine.touch()
    async with studio(mine) as driver:
        driver.main.action_start_from(str(recipe.path))
        if recipe.files:
            dialog = await driver.dialog("ChooseFile")
            assert dialog.query_one("Input").value == "mine.plastron"
            await driver.pilot.press("enter")
            if exists:
                await driver.dialog("Question")
                await driver.pilot.press("o")
        await driver.until(lambda: driver.main.open.text == recipe.text)
        await driver.back()
        assert driver.main.open.path == mine
        await driver.press("ctrl+s")
        await driver.until(lambda: not driver.main.open.is_changed)
    assert mine.read_bytes() == recipe.text


async def test_a_recipe_takes_no_file_that_has_a_program(program: Path) -> None:
    async with studio(program) as driver:
        driver.main.action_start_from(str(RECIPES[0].path))
        await driver.until(lambda: driver.main.open.text == RECIPES[0].text)
        assert driver.main.open.path is None


def test_comments_of_examples_are_no_wider_than_a_small_terminal() -> None:
    texts = [path.read_text() for path in RECIPES[0].path.parent.glob("*.plastron")]
    lines = [line for text in texts for line in text.splitlines() if line.startswith("//")]
    assert len(lines) > 20 and not [line for line in lines if len(line) > 78]
