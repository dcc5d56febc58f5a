"""Random keys in the whole studio: it shows what a studio would that is opened on the same text."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from tempfile import TemporaryDirectory

import idle_loop
import pytest
from hypothesis import HealthCheck, Phase, example, given, note, settings
from hypothesis import strategies as some
from machine import examples
from rich.segment import Segment
from studio_driver import PROGRAM, Driver, studio
from textual.events import Key, Paste
from textual.scroll_view import ScrollView
from tree_sitter import Node

from plastron_tui.language import Document
from plastron_tui.session import Session
from plastron_tui.studio.analysis import Analysis, analyse
from plastron_tui.studio.editor.marks import Marks
from plastron_tui.studio.panels.bars import Bar
from plastron_tui.studio.panels.dock import TabStrip
from plastron_tui.studio.panels.entry_list import EntryList
from plastron_tui.studio.panels.key_bar import KeyBar
from plastron_tui.studio.panels.registry import make

Step = tuple[str, str]
"""What is done, and with what: `key` a key, `type` keys all at once, `paste`, `find`, `size`,
`click` a place in percent of the window, `keys` keys that follow each other."""

STATEMENTS = [
    "create_node 'arm' as arm\n",
    "create_node 'talker' as talker using rclpy\n",
    "create_message m of message_type Point and input x=1, y=2\n",
    "create_message twist of message_type Twist and input linear=(1, 0,\n",
    "arm publish m to 'points' of message_type Point at 5 hz\n",
    "talker publish greeting to '/chatter' of message_type String\n",
    "subscribe arm to 'chatter' of message_type String calling heard\n",
    "arm provides_service 'go' of service_type SetBool\n",
    "listener client_requests 'go' of service_type SetBool with input True\n",
    "listener stop_request 'go'\n",
    "unsubscribe listener from 'chatter'\n",
    "load talker_pub as again\n",
    "generate_node arm using rclpy\n",
    "generate_node again\n",
]
PIECES = [
    "sub", "create_", "generate_node lis", "talker p", "'", '"', " of message_type Po", "/* ", "*/",
    "// ", "(", "]", ", ", "=", "é", "日本", "\U0001f600", "1e3", "\n", "\n\n", "nonsense ",
]  # fmt: skip
PASTES = ["", "\t", "a\r\nb\r\n", "e\u0301\u200d\x00\x07\x1b[31m", PROGRAM, *STATEMENTS]
MOVES = (
    "up down left right home end pageup pagedown ctrl+left ctrl+right ctrl+home ctrl+end"
    " shift+up shift+down shift+left shift+right ctrl+shift+right shift+end ctrl+a f12 f8 shift+f8"
)
EDITS = (
    "enter backspace delete tab ctrl+w ctrl+delete ctrl+k ctrl+d alt+up alt+down ctrl+underscore"
    " ctrl+z ctrl+y ctrl+x ctrl+c ctrl+v ctrl+l f4 escape alt+enter"
)
PANELS = (
    "f7 alt+1 alt+2 alt+3 alt+4 alt+5 alt+6 alt+7 alt+8 f9 ctrl+t alt+plus alt+minus"
    " left_square_bracket right_square_bracket"
)
OTHERS = "f1 f2 f3 f6 f10 ctrl+f ctrl+g ctrl+r ctrl+s alt+z"
FINDS = ["chatter", "t(.)", "(", "[a-c]+$", "", "\\n", "é"]
CLICKS = ["5x10", "40x5", "60x15", "10x50", "30x55", "50x55", "90x55", "20x70", "80x70", "99x30"]
SERIES = [
    "f6 enter escape",
    "f2 x enter",
    "ctrl+g 3 enter",
    "ctrl+s ctrl+k",
    "ctrl+a ctrl+x ctrl+v",
    "ctrl+a delete",
]
SIZES = ["80x24", "120x40", "60x20", "160x50", "20x6", "200x60"]


def keys(names: str) -> some.SearchStrategy[Step]:
    return some.tuples(some.just("key"), some.sampled_from(names.split()))


def texts(kind: str, values: list[str]) -> some.SearchStrategy[Step]:
    return some.tuples(some.just(kind), some.sampled_from(values))


STEPS = some.lists(
    some.one_of(
        texts("type", STATEMENTS),
        texts("type", PIECES),
        keys(EDITS),
        keys(MOVES),
        texts("paste", PASTES),
        keys(PANELS),
        keys("up down enter space home end delete r g f j k"),
        keys(OTHERS),
        texts("find", FINDS),
        texts("size", SIZES),
        texts("click", CLICKS),
        texts("keys", SERIES),
    ),
    min_size=5,
    max_size=40,
)


async def do(driver: Driver, step: Step) -> None:
    """Do a step, and go back to the main screen."""
    kind, value = step
    match kind:
        case "key":
            await driver.pilot.press(value)
        case "type":
            for character in value:
                key = "enter" if character == "\n" else character
                driver.app.post_message(Key(key, "\r" if character == "\n" else character))
            await driver.pilot.press("f24")
        case "paste":
            driver.app.post_message(Paste(value))
            await driver.pilot.press("f24")
        case "find":
            await driver.pilot.press("ctrl+r", "alt+r")
            driver.main.editor.find_bar.query_one("#find-what").value = value
            driver.main.editor.find_bar.query_one("#find-with").value = r"\1x"
            await driver.pilot.press("enter", "f3", "alt+a", "escape")
        case "keys":
            for key in value.split():
                await driver.pilot.press(key)
                await driver.pilot.pause()
        case "click":
            x, y = (int(part) for part in value.split("x"))
            size = driver.app.size
            await driver.pilot.click(offset=(size.width * x // 100, size.height * y // 100))
        case _:
            width, height = (int(part) for part in value.split("x"))
            await driver.pilot.resize_terminal(width, height)
    await driver.pilot.pause()
    while driver.app.screen is not driver.main:
        await driver.pilot.press("escape")
        await driver.pilot.pause()
    await driver.settle()


def shape(node: Node) -> Iterator[tuple[object, ...]]:
    """Yield all that a tree says: kinds, places, fields, what is missing."""
    cursor, depth = node.walk(), 0
    while True:
        here = cursor.node
        assert here is not None
        yield (depth, here.type, here.start_byte, here.end_byte, cursor.field_name,
               here.is_missing, here.start_point, here.end_point)  # fmt: skip
        if cursor.goto_first_child():
            depth += 1
            continue
        while not cursor.goto_next_sibling():
            if not cursor.goto_parent():
                return
            depth -= 1


def opened_anew(driver: Driver) -> Analysis:
    """Return what the text means to a session that begins with it."""
    open_ = driver.main.open
    analysis = analyse(Session(open_.text, open_.path, open_.session.options), lambda: None)
    for request in driver.main.feed.wanted():
        make(analysis, request)
    return analysis


def check(driver: Driver) -> None:
    """Compare the text, its tree, the mistakes, and all panels in sight."""
    main, editor = driver.main, driver.main.editor
    text = editor.text
    assert text is main.open.text
    text.decode()
    tree, fresh_tree = main.open.session.document.tree, Document(text).tree
    assert list(shape(tree.root_node)) == list(shape(fresh_tree.root_node))
    assert editor.statement_help is not None

    fresh, known = opened_anew(driver), main.open.analysis
    assert known is not None
    assert known.diagnostics == fresh.diagnostics
    marks = Marks([found for found in fresh.diagnostics if found.file in (None, main.open.path)])
    assert editor.marks.between(0, len(text)) == marks.between(0, len(text))
    asked = dict(main.feed.wanted())
    for name, panel in main.panels.items():
        made = fresh.made.get((name, asked.get(name)))
        match name:
            case "preview" if main.dock_layout.is_in_sight(name):
                assert panel.previews == (made or ())
            case "graph" if name in asked:
                assert panel.picture == made
            case _ if isinstance(panel, EntryList) and name in asked:
                assert panel.entries.all == made.all
                assert panel.entries.empty == made.empty


def drawn(driver: Driver) -> dict[str, list[list[Segment]]]:
    """Return what stands in each part of the screen that is Plastron's own."""
    parts = {}
    for number, widget in enumerate(driver.main.query("*")):
        is_own = type(widget).__module__.startswith("plastron_tui") and widget.is_on_screen
        if is_own and isinstance(widget, ScrollView | Bar | TabStrip | KeyBar):
            strips = widget.render_lines(widget.size.region)
            parts[f"{number} {widget}"] = [list(strip.simplify()) for strip in strips]
    return parts


async def check_screen(driver: Driver) -> None:
    """Nothing on the screen is left over from before."""
    await driver.until(lambda: not driver.main.editor._settle.is_waiting)
    before = drawn(driver)
    for widget in driver.main.query("*"):
        widget.refresh()
    await driver.settle()
    assert drawn(driver) == before


async def run(steps: list[Step], ending: str = "\n", size: str = "120x40") -> None:
    with TemporaryDirectory() as folder:
        program = Path(folder, "talk.plastron")
        program.write_bytes(PROGRAM.replace("\n", ending).encode())
        width, height = (int(part) for part in size.split("x"))
        async with studio(program, (width, height)) as driver:
            check(driver)
            for step in steps:
                await do(driver, step)
                note(f"{step} {driver.main.editor.selection} {driver.text!r}")
                check(driver)
            await check_screen(driver)


@pytest.mark.long(0.5)
@example(
    [
        ("size", "160x50"),
        ("keys", "ctrl+a delete"),
        ("key", "ctrl+z"),
        ("size", "120x40"),
        ("keys", "ctrl+a delete"),
        ("size", "200x60"),
    ],
    "\r\n",
    "80x24",
)
@given(STEPS, some.sampled_from(["\n", "\r\n"]), some.sampled_from(SIZES[:4]))
@settings(
    max_examples=examples(12),
    deadline=None,
    suppress_health_check=list(HealthCheck),
    # To find fewer steps that fail as well takes longer than to read all of them.
    phases=[Phase.explicit, Phase.reuse, Phase.generate],
)
def test_random_keys(steps: list[Step], ending: str, size: str) -> None:
    idle_loop.run(run(steps, ending, size))
