"""From the text and the panels to the code, and the view that shows it."""

from __future__ import annotations

from contextlib import nullcontext
from pathlib import Path

import pytest
from studio_driver import PROGRAM, studio
from test_terminal import Terminal, start, terminal  # noqa: F401 - a fixture
from textual.widgets import Label, OptionList

from plastron_tui.model.kinds import EndpointKind
from plastron_tui.output.writer import write
from plastron_tui.session import Options, Session
from plastron_tui.studio.code_places import Found, Place, find_code
from plastron_tui.studio.editor.external_editor import command_at
from plastron_tui.studio.panels.code_lines import CodeLines
from plastron_tui.studio.panels.code_text import marked
from plastron_tui.studio.panels.entry import Entry, Subject
from plastron_tui.studio.screens.code_view import CodeView, line_again

ROBOT = """\
create_robot 'cart' as cart
cart has_link 'base'
cart has_link 'arm'
cart has_joint 'turn' of joint_type fixed from 'base' to 'arm'
generate_robot cart
"""


def found(path: Path, asked: Entry | int | str, target: str | None = "rclpy") -> Found:
    text = path.read_bytes()
    at = text.index(asked.encode()) if isinstance(asked, str) else asked
    return find_code(Session(text, path, Options(target)), at)


def lines(found: Found) -> list[tuple[str, str]]:
    """Return each place: what it is said to be, and the line that is there."""
    said = []
    for place in found.places:
        text = place.path.read_bytes() if place.text is None else place.text
        row = text.decode().split("\n")[place.line - 1].strip()
        said.append((f"{place.path.suffix} {place.what}", row))
    return said


PUBLISHED = (
    ".py publisher chatter",
    'self.publisher = self.create_publisher(String, "chatter", 10)',
)
HEARD = ".py subscription chatter"


def test_a_statement_leads_to_what_would_be_written_and_then_to_the_file(program: Path) -> None:
    before = found(program, "talker publish")
    assert "create_publisher" in lines(before)[0][1]
    assert before.places[0].text is not None
    session = Session(program.read_bytes(), program, Options("rclpy"))
    plan, _ = session.plan()
    write(plan)
    now = found(program, "subscribe listener")
    assert [what for what, _ in lines(now)] == [HEARD, ".py function on_chatter"]
    assert lines(now)[1][1].startswith("def on_chatter(")
    file, there = now.places[0].path, lines(now)
    assert now.places[0].text is None
    # Somebody has written above it: the line is found anew.
    file.write_text(file.read_text().replace("class ", "# one\n# two\n\n\nclass ", 1))
    again = found(program, "subscribe listener")
    assert lines(again) == there
    assert again.places[0].line == now.places[0].line + 4


def test_a_topic_leads_to_all_that_meet_there(program: Path) -> None:
    topic = Entry("", "/chatter", subject=Subject.TOPIC, name="/chatter")
    assert {what for what, _ in lines(found(program, topic))} == {
        ".py publisher chatter", HEARD, ".py function on_chatter",
    }  # fmt: skip


def test_header_and_source_of_a_built_node_are_both_offered(program: Path) -> None:
    program.write_text(
        PROGRAM.replace("generate_node listener", "generate_node listener using rclcpp")
    )
    said = lines(found(program, "subscribe listener"))
    assert all("on_chatter" in line or "chatter" in line for _, line in said)
    assert {what.split()[1] for what, _ in said} == {"subscription", "function"}
    assert all(what.startswith((".cpp", ".hpp")) for what, _ in said)


def test_a_loaded_node_leads_to_its_file(program: Path) -> None:
    program.write_text("load 'old.py' as old\n")
    program.with_name("old.py").write_text(
        "import rospy\nfrom std_msgs.msg import String\n\n\ndef heard(message):\n    pass\n\n\n"
        "rospy.init_node('old')\nrospy.Subscriber('chatter', String, heard)\n"
    )
    key = Entry("", "chatter", subject=EndpointKind.SUBSCRIPTION, node="old", name="chatter")
    assert lines(found(program, key, None)) == [
        (HEARD, "rospy.Subscriber('chatter', String, heard)"),
        (".py function heard", "def heard(message):"),
    ]
    assert lines(found(program, "load", None)) == [(".py node old", "rospy.init_node('old')")]


def test_parts_of_robots_and_problems_of_files_lead_to_their_lines(program: Path) -> None:
    program.write_text(ROBOT)
    joint = Entry("", "turn", subject=Subject.JOINT, robot="cart", name="turn")
    assert [line for _, line in lines(found(program, joint))] == [
        '<joint name="turn" type="fixed">'
    ]
    file = program.with_name("plastron.yaml")
    problem = Entry("", "wrong", subject=Subject.PROBLEM, file=file, line=7)
    place = found(program, problem).places[0]
    assert (place.path, place.line) == (file, 7)
    assert found(program, "\n").places  # the end of the statement still counts
    assert (
        found(program, Entry("", "x", subject=Subject.MESSAGE, name="x")).reason
        == "x is in no file"
    )


@pytest.mark.parametrize(
    ("editor", "words"),
    [
        ("vi", ["+7", "{}"]),
        ("/usr/bin/nvim -u NONE", ["-u", "NONE", "+7", "{}"]),
        ("nano", ["+7", "{}"]),
        ("emacs -nw", ["-nw", "+7", "{}"]),
        ("micro", ["+7", "{}"]),
        ("hx", ["{}:7"]),
        ("code --wait", ["--wait", "--goto", "{}:7"]),
        ("kate --block", ["--block", "--line", "7", "{}"]),
        ("ed", ["{}"]),
    ],
)
def test_editors_are_told_the_line(editor: str, words: list[str]) -> None:
    command = editor.split()
    file = Path("/a/-b {line}.py")
    assert command_at(command, file, 7) == [command[0], *(word.format(file) for word in words)]


CODE = {
    "a.py": (b'# c\nclass A:\n    def f(self):\n\treturn "x", 1, None\n', 4,
             "# c:quiet class:keyword A:name def:keyword f:name return:keyword "
             '"x":string 1:number None:number'),
    "a.cpp": (b'#include <a.h>\nint main(int n) {\n  // c\n  return 0x1;\n}\n', 5,
              "#include:keyword <a.h>:string int:builtin main:name int:builtin // c:quiet "
              "return:keyword 0x1:number"),
    "a.xml": (b"<a b='c'>\n<!-- d -->text</a>", 2,
              "a:keyword b:name 'c':string <!-- d -->:quiet a:keyword"),
    "a.yaml": (b"# c\na: 1\n", 2, "# c:quiet"),
    "CMakeLists.txt": (b"# c\nfoo(bar)\n", 2, "# c:quiet"),
    "a.bin": (b"\xff\r\n\n", 2, ""),
    "b.py": (b"", 1, ""),
}  # fmt: skip


@pytest.mark.parametrize("name", CODE)
def test_code_is_coloured_and_nothing_of_it_is_lost(name: str) -> None:
    text, count, tones = CODE[name]
    code = CodeLines(text, Path(name))
    assert len(code) == count
    said = " ".join(f"{piece.text}:{piece.tone}" for line in code for piece in line if piece.tone)
    assert said.startswith(tones)
    shown = ["".join(piece.text for piece in line) for line in code]
    expected = text.decode("utf-8", "replace").replace("\r\n", "\n").split("\n")[:count]
    assert shown == [line.expandtabs(4) for line in expected]


@pytest.mark.parametrize("name", ["a.py", "a.yaml", "a.bin"])
def test_code_cannot_look_like_other_code(name: str) -> None:
    line = "a = 'x\u202e\u2066' # \u200b\x1b[31m\tb"
    (shown,) = CodeLines(line.encode(), Path(name))
    assert "".join(piece.text for piece in shown).split() == [
        "a", "=", r"'x\u202e\u2066'", "#", r"\u200b\x1b[31m", "b",
    ]  # fmt: skip


def test_a_name_that_no_file_has_is_said() -> None:
    view = CodeView([Place(Path("a\0b"), 1, "node a")])
    assert len(view._read()) == 1
    assert view._problem.startswith("cannot be read: ")


def test_of_a_large_file_only_what_is_in_sight_is_parsed(monkeypatch: pytest.MonkeyPatch) -> None:
    module = "plastron_tui.studio.panels.code_lines"
    text = b'def f(x):\n    """Say."""\n    return 1\n\n' * 500
    whole = list(CodeLines(text, Path("a.py")))
    monkeypatch.setattr(f"{module}._LARGE", 10_000)
    monkeypatch.setattr(f"{module}._MOST_MADE", 100)
    parts = CodeLines(text, Path("a.py"))
    assert parts._tree is None
    assert [parts[row] for row in (1999, 0, 1000, 1001)] == [
        whole[row] for row in (-1, 0, 1000, 1001)
    ]
    assert list(parts) == whole


def test_what_is_found_is_marked_whatever_the_case() -> None:
    assert marked([("self.Chat", "name"), ("ter", "")], "chatter") == [
        ("self.", "name"), ("Chatter", "match"),
    ]  # fmt: skip


def test_of_letters_only_those_of_english_are_the_same() -> None:
    assert marked([("Über", "")], "über") == [("Über", "")]
    assert marked([("ÜBER", "")], "Über") == [("ÜBER", "match")]


@pytest.mark.long
def test_the_terminal_is_lent_to_an_editor_at_the_line_and_comes_back(
    terminal: Terminal,  # noqa: F811 - a fixture
    tmp_path: Path,
) -> None:
    editor = tmp_path / "vi"
    editor.write_text('#!/bin/sh\necho "told $1"; read answer; echo "# $answer" >>"$2"\n')
    editor.chmod(0o755)
    terminal._environ["EDITOR"] = str(editor)
    program = tmp_path / "mine.plastron"
    program.write_text(PROGRAM)
    write(Session(PROGRAM.encode(), program).plan()[0])
    start(terminal, "mine.plastron")
    terminal.wait(lambda screen: "listener" in screen)
    terminal.keys("M-c")
    terminal.wait(lambda screen: "node talker" in screen and "Esc closes" in screen)
    terminal.keys("e")
    terminal.wait(lambda screen: "told +" in screen and "Esc closes" not in screen)
    terminal.keys("-l", "an answer")
    terminal.keys("Enter")
    terminal.wait(lambda screen: "node talker" in screen and "Esc closes" in screen)
    terminal.keys("End")
    terminal.wait(lambda screen: "# an answer" in screen)


def test_the_line_is_found_again_in_another_text() -> None:
    path = Path("a.py")
    before = CodeLines(b"a\nb\nc\nb\n", path)
    assert line_again(before, 3, CodeLines(b"b\nx\ny\nb\nc\nz\n", path)) == 3
    assert line_again(before, 2, CodeLines(b"x\nx\nx\nx\n c\n", path)) == 4
    assert line_again(before, 2, CodeLines(b"x\n", path)) == 2


async def test_of_several_places_the_file_that_is_there_comes_first(program: Path) -> None:
    program.write_text("load 'node.py' as old\ngenerate_node old\n")
    program.with_name("node.py").write_text(
        "import rospy\nfrom std_msgs.msg import String\nrospy.init_node('old')\n"
        "rospy.Publisher('a', String, queue_size=1)\n"
    )
    async with studio(program, (80, 24)) as driver:
        await driver.pilot.press("alt+c")
        dialog = await driver.dialog("ChoosePlace")
        listed = dialog.query_one(OptionList)
        options = [str(listed.get_option_at_index(at).prompt) for at in (0, 1)]
        assert [option.split("  ")[1:] for option in options] == [
            ["work/node.py:3"], ["output/node.py:3", "not written yet"]
        ]  # fmt: skip
        box = dialog.query_one("#dialog").region
        assert abs(box.y - (24 - box.bottom)) <= 1 and abs(box.x - (80 - box.right)) <= 1
        await driver.pilot.press("enter")
        view = await driver.dialog("CodeView")
        assert view.place.text is None


async def test_the_view_shows_finds_turns_and_edits(
    program: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    editor, told = tmp_path / "vi", tmp_path / "told"
    editor.write_text(f'#!/bin/sh\necho "$@" >{told}\nsed -i "1i # mine" "$2"\n')
    editor.chmod(0o755)
    monkeypatch.setenv("EDITOR", str(editor))
    calling = "String calling on_chatter\ngenerate_node listener"
    program.write_text(PROGRAM.replace("String\ngenerate_node listener", calling))
    async with studio(program, (80, 24), options=Options("rclpy")) as driver:
        monkeypatch.setattr(driver.app, "suspend", nullcontext)
        driver.main.editor.go_to(program.read_text().index("subscribe listener"))
        await driver.pilot.press("alt+c")
        view = await driver.dialog("CodeView")
        title = view.query_one("#dialog-title", Label)
        assert "subscription chatter  not written yet: F6 would write this  1 of 2" in str(
            title.content
        )
        await driver.pilot.press("e")
        await driver.until(lambda: "this file is not written yet" in driver.notes())
        code, line = view.query_one("CodeText"), view.query_one("CodeText").line
        await driver.pilot.press("N")
        assert code.line == line + 2
        await driver.pilot.press("ctrl+f", *"RCLPY", "enter", "f3")
        assert str(view.query_one("#code-count", Label).content).strip().endswith("places")
        assert b"rclpy" in code.code.text.split(b"\n")[code.line]
        await driver.pilot.press("escape", "escape")
        await driver.back()
        # A function is gone to at once.
        driver.main.editor.go_to(program.read_text().index("on_chatter"))
        await driver.pilot.press("f12")
        code = (await driver.dialog("CodeView")).query_one("CodeText")
        assert b"def on_chatter" in code.code.text.split(b"\n")[code.line]
        await driver.pilot.press("escape")
        await driver.back()
        driver.main.editor.go_to(program.read_text().index("String"))
        await driver.pilot.press("f12")
        await driver.until(lambda: driver.main.editor.hover.is_asked)
        write(driver.main.open.session.plan()[0])
        await driver.show("nodes")
        await driver.pilot.press("home", "c")
        view = await driver.dialog("CodeView")
        code = view.query_one("CodeText")
        line = code.line
        assert view.place.text is None
        await driver.pilot.press("e")
        file = view.place.path
        await driver.until(lambda: code.line == line + 1)
        assert told.read_text().split() == [f"+{line + 1}", str(file)]
        assert file.read_text().startswith("# mine\n")
        file.unlink()
        outside = Entry("", "wrong", subject=Subject.PROBLEM, file=Path("/etc/hostname"), line=1)
        driver.main.action_code(outside)
        await driver.until(lambda: "hostname is outside of the project" in driver.notes())
        view.look_at_disk()
        assert "cannot be read: no such file" in str(view.query_one("#dialog-title", Label).content)
