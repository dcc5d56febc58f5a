"""Robots in the studio: shown, completed, acted on, renamed."""

from __future__ import annotations

from pathlib import Path

import pytest
from studio_driver import studio

from plastron_tui.language import Document
from plastron_tui.language.expectations import expected_at
from plastron_tui.session import Session
from plastron_tui.studio.analysis import Analysis, analyse
from plastron_tui.studio.editor.completion import candidates
from plastron_tui.studio.editor.robot_parts import Part, find_part, part_at, wrong_part_name
from plastron_tui.studio.editor.vocabulary import Vocabulary
from plastron_tui.studio.panels.entry import Entry
from plastron_tui.studio.panels.preview import previews_of
from plastron_tui.studio.panels.registry import PACKAGES, ROBOTS
from plastron_tui.studio.panels.robot_panel import Looks, Shown
from plastron_tui.studio.renaming import fixed_name, renamed, wrong_name

TEXT = """\
create_robot 'rover' as rover
rover has_link 'base'
rover has_link 'body' shaped box 0.4, 0.3, 0.1 weighing 5 painted blue
rover has_joint 'hold' of joint_type fixed from 'base' to 'body'
rover has_link 'wheel' shaped cylinder 0.1, 0.04 weighing 0.5 painted "#102030"
rover has_joint 'turn' of joint_type continuous from 'body' to 'wheel' with axis 0, 1, 0
rover has_link 'mast' shaped mesh "mast.stl"
rover has_joint 'lift' of joint_type prismatic from 'body' to 'mast' mimicking 'turn'
rover limits_joint 'lift' between 0 and 0.5 m with effort 20 and velocity 0.1
generate_robot rover
"""


_TWO_LINKS = """\
<robot name="r">
  <link name="a"/>
  <link name="b"/>
  <joint name="j" type="fixed"><parent link="a"/><child link="b"/></joint>
</robot>
"""


def analysis_of(text: str, path: Path | None = None) -> Analysis:
    return analyse(Session(text.encode(), path, environ={}), lambda: None)


def shown(analysis: Analysis, looks: Looks) -> Shown:
    assert ROBOTS.make is not None
    made = ROBOTS.make(analysis, looks)
    assert isinstance(made, Shown)
    return made


def entries(analysis: Analysis) -> tuple[Entry, ...]:
    return shown(analysis, Looks("rover", 0, 0)).entries.all


def test_the_tree_has_each_link_below_its_joint() -> None:
    analysis = analysis_of(TEXT)
    lines = [
        f"{'  ' * each.depth}{each.sign} {each.text} {each.detail}" for each in entries(analysis)
    ]
    assert lines == [
        "◈ rover 4 links",
        "  □ base a place",
        "    ─ hold fixed",
        "    ■ body box 0.4 × 0.3 × 0.1 · 5 kg · blue",
        "      ○ turn continuous y",
        "      ■ wheel cylinder r 0.1, l 0.04 · 0.5 kg · color_102030",
        "      ⇄ lift prismatic x · 0 to 0.5 m · 20 N · 0.1 m/s · follows turn",
        "      ■ mast mesh mast.stl",
    ]
    assert [each.tone for each in entries(analysis) if each.sign == "■"] == [
        "#0000ff",
        "#102030",
        "quiet",
    ]
    assert ROBOTS.count is not None and ROBOTS.count(analysis) == 1


def test_a_package_shows_the_robot_that_it_contains() -> None:
    text = "create_package 'demo' as demo\ndemo contains rover\ngenerate_package demo\n"
    analysis = analysis_of(TEXT + text)
    assert PACKAGES.make is not None
    found = PACKAGES.make(analysis, None).all  # type: ignore[attr-defined]
    assert [(each.sign, each.text) for each in found] == [("▣", "demo"), ("◈", "rover")]
    assert found[1].statement == "demo no_longer_contains rover"
    assert entries(analysis)[0].warning == ""


def test_what_is_wrong_stands_beside_its_part_and_is_mended_there() -> None:
    text = TEXT.replace("shaped box", "shaped bx").replace("generate_robot rover\n", "")
    found = {each.text: each for each in entries(analysis_of(text))}
    assert found["rover"].warning == "not written"
    assert "bx" in found["body"].warning and found["body"].sign == "✖"
    assert [edit.text for edit in found["body"].edits] == ["box"]


def test_a_part_of_a_file_says_where_it_stands(tmp_path: Path) -> None:
    (tmp_path / "old.urdf").write_text(
        '<?xml version="1.0"?>\n<robot name="old">\n  <link name="base"/>\n'
        '  <link name="arm"/>\n  <joint name="turn" type="continuous">\n'
        '    <parent link="base"/>\n    <child link="arm"/>\n  </joint>\n</robot>\n'
    )
    text = "load_robot 'old.urdf' as old\nold has_link 'arm' shaped sphere 0.1\n"
    analysis = analysis_of(text, tmp_path / "x.plastron")
    assert analysis.diagnostics == ()
    found = {each.text: each for each in entries(analysis)}
    assert found["turn"].warning == ""
    broken = (tmp_path / "old.urdf").read_text().replace("continuous", "revolute")
    (tmp_path / "bad.urdf").write_text(broken)
    bad = analysis_of(text.replace("old.urdf", "bad.urdf"), tmp_path / "x.plastron")
    assert {each.text for each in entries(bad) if "<limit>" in each.warning} == {"turn"}
    assert found["turn"].span is None and found["turn"].elsewhere == "turn is in old.urdf, line 5"
    assert found["arm"].span is not None and found["arm"].detail == "sphere r 0.1"
    assert found["arm"].statement == (
        "old no_longer_has_joint 'turn'\nold no_longer_has_link 'arm'"
    )
    for refused in (fixed_name(analysis, found["arm"]), wrong_name(analysis, found["arm"], "x")):
        assert refused == "`old.urdf` has the name: change it there"


def test_colours_and_axes_are_those_of_the_picture(tmp_path: Path) -> None:
    body = '<visual><geometry><sphere radius="1"/></geometry><material name="m">{}</material>'
    red = body.format('<color rgba="1 0 0 1"/>')
    (tmp_path / "r.urdf").write_text(
        f'<robot name="r"><link name="a">{red}</visual></link>'
        f'<link name="b">{body.format("")}</visual></link><joint name="j" type="continuous">'
        '<parent link="a"/><child link="b"/><axis xyz="0 0 2"/></joint></robot>'
    )
    analysis = analysis_of("load_robot 'r.urdf' as r\n", tmp_path / "x.plastron")
    found = {each.text: each for each in entries(analysis)}
    # A name means the first material that has it, wherever that stands.
    assert (found["a"].tone, found["b"].tone) == ("#ff0000", "#ff0000")
    assert found["j"].detail == "continuous z"


def test_macros_that_are_not_expanded_stand_for_what_they_make(tmp_path: Path) -> None:
    (tmp_path / "old.xacro").write_text(
        '<robot name="old" xmlns:xacro="http://www.ros.org/wiki/xacro">\n  <link name="base"/>\n'
        '  <xacro:wheel side="left"/>\n</robot>\n'
    )
    analysis = analysis_of("load_robot 'old.xacro' as old\n", tmp_path / "x.plastron")
    robot, base, wheel = entries(analysis)
    assert "not trusted" in robot.warning
    assert (base.text, wheel.text, wheel.detail) == ("base", "wheel", 'side="left"')
    assert wheel.place == "old.xacro, line 3"


def test_the_part_at_the_cursor_stands_out_in_the_picture() -> None:
    analysis = analysis_of(TEXT)
    plain, marked = (
        shown(analysis, Looks("rover", 60, 20, "", part)).picture for part in ("", "wheel")
    )
    texts = [["".join(piece.text for piece in line) for line in each] for each in (plain, marked)]
    assert len(plain) == 20 and all(len(line) == 60 for line in texts[0])
    assert plain != marked
    assert {"top", "front"} <= {word for line in texts[0] for word in line.split()}
    alone = shown(analysis, Looks("rover", 60, 20, "side")).picture
    assert "".join(piece.text for piece in alone[0]).startswith("right side")


@pytest.mark.parametrize(
    ("line", "first"),
    [
        ("rover ", ["has_link", "no_longer_has_link", "has_joint"]),
        ("generate_robot ", ["rover"]),
        ("create_robot 'arm' as ", ["arm"]),
        ("load_robot 'urdf/arm.urdf' as ", ["arm"]),
        ("rover has_link 'x' shaped ", ["box", "cylinder", "sphere", "mesh"]),
        ("rover has_link 'x' shaped cylinder ", ["0.1, 0.05"]),
        ("rover has_link 'x' painted or", ["orange"]),
        ("rover has_link 'x' turned 90, 0, 0 ", ["deg", "rad"]),
        ("rover has_joint 'x' of joint_type ", ["fixed", "revolute", "continuous"]),
        ("rover has_joint 'x' of joint_type fixed from ", ["'base'", "'body'"]),
        ("rover has_joint 'x' of joint_type fixed from 'base' to ", ["'body'", "'wheel'"]),
        ("rover has_joint 'x' of joint_type fixed from 'base' to 'body' with axis ", ["0, 0, 1"]),
        (
            "rover has_joint 'x' of joint_type fixed from 'base' to 'body' mimicking ",
            ["'turn'", "'lift'"],
        ),
        ("rover limits_joint ", ["'turn'", "'lift'"]),
        ("rover limits_joint 'turn' between 0 and 1 ", ["deg", "rad"]),
        ("rover limits_joint 'lift' between 0 and 1 ", ["m"]),
        ("rover no_longer_has_link ", ["'base'", "'body'", "'wheel'", "'mast'"]),
        ("rover no_longer_has_joint ", ["'hold'", "'turn'", "'lift'"]),
    ],
)
def test_completion_offers_what_a_robot_has(line: str, first: list[str]) -> None:
    session = Session((TEXT + line + "\n").encode(), environ={})
    known = Session(TEXT.encode(), environ={})
    expected = expected_at(session.document, len((TEXT + line).encode()))
    found = candidates(expected, Vocabulary(known.program, known.workspace), session)
    assert [each.text for each in found][: len(first)] == first


def test_completion_offers_what_turns_no_metres() -> None:
    text = TEXT.replace("joint_type prismatic", "joint_type revolute").replace("0.5 m", "90 deg")
    line = "rover limits_joint 'lift' between 0 and 1 "
    session = Session((text + line + "\n").encode(), environ={})
    known = Session(text.encode(), environ={})
    expected = expected_at(session.document, len((text + line).encode()))
    found = candidates(expected, Vocabulary(known.program, known.workspace), session)
    assert "m" not in [each.text for each in found]


def test_completion_offers_the_files_of_robots(tmp_path: Path) -> None:
    for name in ("urdf/arm.urdf", "rover.xacro", "other.xml"):
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text("")
    session = Session(b"load_robot ", tmp_path / "x.plastron", environ={})
    expected = expected_at(session.document, len(b"load_robot "))
    found = candidates(expected, Vocabulary(session.program, session.workspace), session)
    assert [each.text for each in found] == ["'rover.xacro'", "'urdf/arm.urdf'"]


@pytest.mark.parametrize(
    ("key", "new", "changed"),
    [
        ("robot rover", "cart", ["create_robot 'cart' as cart", "cart has_link 'base'",
                                 "generate_robot cart"]),
        ("link rover body", "box", ["has_link 'box' shaped box", "from 'base' to 'box'",
                                    "from 'box' to 'wheel'"]),
        ("joint rover turn", "spin", ["has_joint 'spin'", "mimicking 'spin'"]),
    ],
)  # fmt: skip
def test_another_name_is_put_everywhere(key: str, new: str, changed: list[str]) -> None:
    analysis = analysis_of(TEXT)
    entry = next(each for each in entries(analysis) if each.key == key)
    assert wrong_name(analysis, entry, new) is None
    assert wrong_name(analysis, entry, entry.text) is not None
    assert wrong_name(analysis, entry, "a name") is not None
    text = TEXT
    edits = renamed(analysis, entry, new).edits
    for edit in sorted(edits, key=lambda each: each.span.start, reverse=True):
        text = text[: edit.span.start] + edit.text + text[edit.span.end :]
    assert {each.code for each in analysis_of(text).diagnostics} == {
        each.code for each in analysis.diagnostics
    }
    assert all(each in text for each in changed)


@pytest.mark.parametrize(
    ("at", "definition", "count"),
    [
        ("from 'body' to 'wheel'", "body' shaped box", 4),
        ("'turn'\nrover limits", "turn' of joint_type", 2),
        ("'hold'", "hold' of joint_type", 1),
    ],
)
def test_a_part_leads_to_where_it_is_made(at: str, definition: str, count: int) -> None:
    document = Document(TEXT.encode())
    offset = TEXT.index(at) + at.index("'") + 2
    part = part_at(document, offset)
    assert part is not None
    found = find_part(document, part)
    assert found.definition is not None
    assert TEXT[found.definition.start :].startswith(definition)
    assert {TEXT[start:end] for start, end in found.places} == {found.name} == {part.name}
    assert len(found.places) == count
    assert part_at(document, 3) is None
    none = "rover has_joint 'turn' mimicking none\n"
    assert part_at(Document(none.encode()), none.index("none") + 1) is None


def test_a_part_that_a_file_names_keeps_its_name(tmp_path: Path) -> None:
    (tmp_path / "r.urdf").write_text(_TWO_LINKS)
    text = "load_robot 'r.urdf' as r\nr has_link 'far' shaped sphere 1\nr has_link 'b'\n"
    analysis = analysis_of(text, tmp_path / "x.plastron")
    document, robot = analysis.session.document, analysis.workspace.robots["r"]
    own, loaded = (Part("r", "link", name) for name in ("far", "b"))
    assert "`r.urdf` has the name" in (wrong_part_name(document, loaded, "new", robot) or "")
    assert wrong_part_name(document, own, "new", robot) is None
    # What is taken is told of a program that nobody has understood yet, too.
    for other, known in (("a", robot), ("b", robot), ("b", None), ("a b", robot), ("a b", None)):
        assert wrong_part_name(document, own, other, known) is not None
    assert wrong_part_name(document, own, "a", None) is None


def test_the_preview_has_the_file_of_the_robot_at_the_cursor(tmp_path: Path) -> None:
    analysis = analysis_of(TEXT, tmp_path / "x.plastron")
    (preview,) = previews_of(analysis, "rover")
    assert preview.name == "rover.urdf"
    tones = {piece.tone for line in preview.lines for piece in line}
    assert {"keyword", "name", "string"} <= tones
    assert analysis.written_at(TEXT.index("rover has_joint")) == "rover"


async def test_a_picture_fits_below_its_tree_before_any_key(program: Path) -> None:
    # In a tall panel the tree of so many links leaves less room than an empty one.
    links = "".join(f"rover has_link 'l{number}'\n" for number in range(20))
    program.write_text(TEXT.replace("generate_robot rover\n", f"{links}generate_robot rover\n"))
    async with studio(program, (120, 60)) as driver:
        panel = driver.main.panels["robots"]
        await driver.until(lambda: len(panel.picture.lines) == panel.picture.size.height)
        await driver.settle()
        assert panel.picture.display
        await driver.press("down")
        # The part at the cursor is one no longer, and nobody moves the cursor.
        await driver.type("x")
        assert panel._marked(driver.main.editor.cursor_offset) == ""


async def test_a_robot_is_seen_while_it_is_typed(program: Path) -> None:
    program.write_text(TEXT)
    async with studio(program, (120, 40)) as driver:
        # A program of robots alone begins with them.
        assert driver.main.dock_layout.is_in_sight("robots")
        await driver.press("down", "down")
        await driver.press("alt+l")
        panel = driver.main.panels["robots"]
        tree = panel.parts
        assert tree.has_focus and tree.current.text == "body"
        assert "v View" in driver.main.query_one("KeyBar").text
        main = driver.main
        assert panel.request(main.open.analysis, main.editor.cursor_offset).marked == "body"
        before = panel.picture.text
        await driver.press("v")
        assert panel.picture.text.startswith("top")
        await driver.press("v", "v", "v")
        assert panel.picture.text == before
        await driver.press("end", "d")
        ended = "rover no_longer_has_joint 'lift'\nrover no_longer_has_link 'mast'\n"
        assert f"{ended}generate_robot rover\n" in driver.text
        driver.main.editor.go_to(TEXT.index("0.4"))
        driver.main.editor.focus()
        await driver.press("delete", "1")
        assert "box 1.4" in next(each.detail for each in tree.entries.all if each.text == "body")
        assert panel.picture.text != before
