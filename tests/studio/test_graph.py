from __future__ import annotations

from itertools import combinations
from pathlib import Path

import pytest
from studio_driver import PROGRAM, SIZES, Driver, studio
from textual.geometry import Offset, Region

from plastron_tui.model.graph import graph_of
from plastron_tui.session import Session
from plastron_tui.studio.panels.drawing import DETAILS
from plastron_tui.studio.panels.fitting import Fitted, Size
from plastron_tui.studio.panels.picture import Picture, picture_of

HELLO = 'create_message hello of message_type String and input "hello"\n'


def chain(length: int) -> str:
    """A program in which each node passes something on to the next one."""
    lines = [HELLO]
    for number in range(length):
        lines.append(f"create_node 'worker_{number}' as n{number}\n")
        if number:
            topic = f"'passed_on_{number - 1}'"
            lines.append(f"subscribe n{number} to {topic} of message_type String\n")
        lines.append(f"n{number} publish hello to 'passed_on_{number}' of message_type String\n")
    return "".join(lines)


def pairs(count: int) -> str:
    return HELLO + "".join(
        f"create_node 'a{at}' as a{at}\na{at} publish hello to 't{at}' of message_type String\n"
        for at in range(count)
    )


EXAMPLES = sorted((Path(__file__).parents[2] / "examples").glob("*.plastron"))
PROGRAMS = {
    **{path.stem: path.read_text() for path in EXAMPLES},
    **{f"chain of {n}": chain(n) for n in (2, 3, 6)},
    "pairs": pairs(9),
    "a program": PROGRAM,
}
ROOMS = [(40, 4), (80, 8), (80, 20), (86, 14), (120, 36)]


def picture(program: str) -> Picture:
    session = Session(program.encode(), Path(EXAMPLES[0].parent / "x.plastron"), environ={})
    assert not session.diagnostics
    return picture_of(graph_of(session.workspace))


def text(fitted: Fitted) -> list[str]:
    return ["".join(piece.text for piece in line) for line in fitted.lines]


@pytest.mark.parametrize("program", PROGRAMS.values(), ids=PROGRAMS)
@pytest.mark.parametrize("room", ROOMS, ids=str)
def test_the_largest_drawing_that_fits_is_taken(program: str, room: tuple[int, int]) -> None:
    made = picture(program)
    fitted = made.fitted(Size(*room))
    sizes = [made.fitted(Size(*room, detail)) for detail in range(len(DETAILS))]
    fits = [size.detail for size in sizes if size.width <= room[0] and len(size.lines) <= room[1]]
    if fits:
        # A smaller one is taken only where that saves lines from row to row.
        assert fitted.detail == fits[0] or (fitted.detail in fits and "╯" in drawn(sizes[fits[0]]))
        assert fitted.width <= room[0] and len(fitted.lines) <= room[1]
    else:
        # What has to be scrolled is no higher than two windows, or has the fewest rows.
        narrow = [size for size in sizes if size.width <= room[0]] or sizes[-1:]
        low = [size for size in narrow if len(size.lines) <= 2 * room[1]]
        fewest = min(narrow, key=lambda size: len(size.lines))
        assert fitted.detail == (low or [fewest])[0].detail


def test_a_dock_that_is_dragged_leaves_few_pictures() -> None:
    drawing = picture(chain(6)).drawing
    assert drawing is not None
    first = drawing.fitted(Size(40, 20)).lines
    for width in range(41, 80):
        drawing.fitted(Size(width, 20))
    assert drawing.is_fitted(Size(79, 20)) and not drawing.is_fitted(Size(40, 20))
    assert len(drawing._fitted) <= 8 and len(drawing._plans) <= 48
    assert drawing.fitted(Size(40, 20)).lines == first


def drawn(fitted: Fitted) -> str:
    return "\n".join(text(fitted))


def test_a_picture_is_drawn_smaller_rather_than_in_rows_that_many_lines_join() -> None:
    long, far = "a_node_with_a_name_of_some_length", "/arm/left/joint_states"
    program = f"""{HELLO}create_node '{long}' as one
one publish hello to '{far}' of message_type String
create_node 'short' as two
subscribe two to '{far}' of message_type String
two publish hello to 'x' of message_type String
subscribe two to 'x' of message_type String
subscribe one to 'x' of message_type String
"""
    made = picture(program)
    broken, whole = made.fitted(Size(72, 20, 0)), made.fitted(Size(72, 20))
    assert broken.width <= 72 and len(broken.lines) <= 20
    assert whole.detail > 0
    assert whole.places[0].x < whole.places[1].x


@pytest.mark.parametrize("program", PROGRAMS.values(), ids=PROGRAMS)
@pytest.mark.parametrize("detail", range(len(DETAILS)))
def test_every_box_is_drawn_where_it_is_said_to_be(program: str, detail: int) -> None:
    made = picture(program)
    fitted = made.fitted(Size(100, 30, detail))
    rows = text(fitted)
    assert max(map(len, rows)) <= fitted.width
    assert set(fitted.places) == set(range(len(made.entries)))
    regions = {box: Region(*place) for box, place in fitted.places.items()}
    for one, other in combinations(regions.values(), 2):
        assert not one.overlaps(other)
    for box, region in regions.items():
        inside = "\n".join(row[region.x : region.right] for row in rows[region.y : region.bottom])
        name = made.entries[box].text
        assert (name if len(name) < DETAILS[detail].widest else name[:8]) in inside
        assert inside[0] in "┌╭[("
        assert inside[-1] in "┘╯])"


def test_what_stands_alone_stands_beside_each_other() -> None:
    made = picture("".join(f"create_node 'a{at}' as a{at}\n" for at in range(6)))
    assert len(made.fitted(Size(80, 10)).lines) == 3


def test_nodes_at_one_topic_are_folded_where_there_is_no_room_for_all() -> None:
    program = HELLO + "create_node 'camera' as camera\n"
    program += "camera publish hello to 'image' of message_type String\n"
    for at in range(30):
        program += f"create_node 'v{at}' as v{at}\n"
        program += f"subscribe v{at} to 'image' of message_type String\n"
    made = picture(program)
    assert "more" not in "\n".join(text(made.fitted(Size(80, 31))))
    folded = made.fitted(Size(80, 12))
    assert len(folded.lines) <= 12
    assert "[and 25 more]" in "\n".join(text(folded))
    assert set(folded.places) == set(range(len(made.entries)))
    assert len(set(folded.places.values())) == len(made.entries) - 24
    # Who asks for a size sees all of it.
    assert "more" not in "\n".join(text(made.fitted(Size(80, 12, 3))))


def test_what_changes_nothing_in_the_graph_is_not_laid_out_again() -> None:
    before, after = picture(PROGRAM), picture(f"// A comment.\n{PROGRAM}")
    assert before.statements != after.statements
    assert before.fitted(Size(80, 20)) is after.fitted(Size(80, 20))
    other = picture(PROGRAM.replace("'talker'", "'speaker'"))
    assert other.fitted(Size(80, 20)) is not before.fitted(Size(80, 20))


def test_too_many_boxes_are_said() -> None:
    assert "too many" in text(picture(pairs(201)).fitted(Size(80, 20)))[0]
    assert text(picture(HELLO).fitted(Size(80, 20))) == [" nothing to draw yet"]


def test_a_box_that_several_lines_come_to_is_one_box_where_it_has_no_frame() -> None:
    program = HELLO + "create_node 'boss' as boss\n"
    program += "".join(
        f"boss publish hello to '{topic}' of message_type String\n"
        f"create_node 'on_{topic}' as {topic}\n"
        f"subscribe {topic} to '{topic}' of message_type String\n"
        for topic in ("left", "right")
    )
    rows = text(picture(program).fitted(Size(80, 20, 3)))
    assert [row[:8].strip() for row in rows] == ["┌boss┐─", "└────┘─"]
    assert "(/left)────▶[on_left]" in rows[0]


async def graph(driver: Driver) -> None:
    driver.main.action_show("graph")
    await driver.settle()


def lit(driver: Driver) -> str:
    current = driver.main.panels["graph"].current
    assert current is not None
    return current.text


@pytest.mark.parametrize("size", SIZES)
async def test_a_box_is_gone_to_with_keys_and_leads_to_its_statement(
    program: Path, size: tuple[int, int]
) -> None:
    async with studio(program, size) as driver:
        await graph(driver)
        assert lit(driver) == "talker"
        assert "Rename" in driver.main.query_one("KeyBar").text
        editor = driver.main.editor
        await driver.press("home")
        assert lit(driver) == "talker"
        await driver.press("right")
        assert lit(driver) == "/chatter"
        assert editor.cursor_offset == PROGRAM.index("talker publish")
        await driver.press("right")
        assert lit(driver) == "listener"
        assert driver.main.panels["graph"].has_focus
        await driver.press("right", "left", "left", "end", "enter")
        assert editor.cursor_offset == PROGRAM.index("create_node 'listener'")
        assert editor.view.has_focus


@pytest.mark.parametrize("size", SIZES)
async def test_the_box_follows_the_cursor(program: Path, size: tuple[int, int]) -> None:
    async with studio(program, size) as driver:
        driver.main.dock_layout.bring("graph")
        await driver.settle()
        for at, box in (
            ("subscribe", "/chatter"),
            ("create_node 'l", "listener"),
            ("create_n", "talker"),
        ):
            driver.main.editor.go_to(PROGRAM.index(at))
            await driver.settle()
            assert lit(driver) == box


@pytest.mark.parametrize("size", SIZES)
async def test_a_box_is_clicked(program: Path, size: tuple[int, int]) -> None:
    async with studio(program, size) as driver:
        await graph(driver)
        panel = driver.main.panels["graph"]
        row = next(at for at, line in enumerate(text(panel._fitted)) if "listener" in line)
        column = text(panel._fitted)[row].index("listener")
        await driver.pilot.click(panel, offset=Offset(column, row))
        await driver.settle()
        assert driver.main.editor.cursor_offset == PROGRAM.index("create_node 'listener'")


async def test_a_box_can_be_renamed_and_generated(program: Path) -> None:
    program.write_text(PROGRAM.replace("generate_node listener\n", ""))
    async with studio(program) as driver:
        await graph(driver)
        await driver.press("end", "g")
        assert driver.text.endswith("generate_node listener\n")
        await graph(driver)
        await driver.press("home", "right")
        await driver.pilot.press("f2")
        await driver.dialog("Prompt")
        await driver.pilot.press(*"news", "enter")
        await driver.back()
        assert driver.text.count("'news'") == 2
        assert lit(driver) == "/news"


async def test_the_picture_follows_the_size_of_the_window(tmp_path: Path) -> None:
    file = tmp_path / "chain.plastron"
    file.write_text(chain(4))
    async with studio(file, (200, 60)) as driver:
        await graph(driver)
        shown = []
        for width, height in ((250, 60), (120, 40), (80, 24), (60, 20)):
            await driver.pilot.resize_terminal(width, height)
            await driver.settle()
            panel = driver.main.panels["graph"]
            assert panel.lines == panel.picture.fitted(panel.room).lines
            shown.append(panel._fitted.detail)
        assert shown == sorted(shown)
        assert shown[0] < shown[-1]


async def test_what_does_not_fit_scrolls_to_the_box_at_the_cursor(tmp_path: Path) -> None:
    file = tmp_path / "chain.plastron"
    file.write_text(chain(40))
    async with studio(file, (80, 24)) as driver:
        await graph(driver)
        panel = driver.main.panels["graph"]
        assert panel.max_scroll_y > 0
        assert lit(driver) == "worker_0" and panel.scroll_offset == (0, 0)
        status = driver.main.query_one("#status")
        assert "Shift+arrows: scroll" in status.text and "create_message" not in status.text
        for _ in range(8):
            await driver.press("down")
            place = panel._place(panel._cursor)
            assert panel.scroll_offset.y <= place.y < panel.scroll_offset.y + panel.size.height
        assert panel.scroll_offset.y > 0
        await driver.press("home")
        assert panel.scroll_offset.y == 0
        await driver.press("shift+down")
        assert panel.scroll_offset.y > 0
        await driver.press("escape")
        assert "create_" in status.text and "scroll" not in status.text


async def test_the_size_can_be_chosen(program: Path) -> None:
    async with studio(program) as driver:
        await graph(driver)
        seen = []
        for _ in range(len(DETAILS)):
            await driver.press("s")
            seen.append(driver.main.panels["graph"]._fitted.detail)
        assert seen == list(range(len(DETAILS)))
        await driver.press("s")
        assert driver.main.panels["graph"]._fitted.detail == 0
