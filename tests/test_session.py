from __future__ import annotations

from pathlib import Path

import pytest

from plastron_tui.model.kinds import Publisher
from plastron_tui.output import manifest
from plastron_tui.output.manifest import Reading, load_manifest
from plastron_tui.output.plan import FileState
from plastron_tui.output.writer import write
from plastron_tui.project import loader
from plastron_tui.project.program_file import check_text, read_program
from plastron_tui.session import Options, Session
from plastron_tui.trust import TrustStore

TALKER = """\
create_node 'talker' as talker
create_message greeting of message_type String and input "hello"
talker publish greeting to 'chatter' of message_type String
generate_node talker
"""


def session(folder: Path, text: str = TALKER, **options: object) -> Session:
    return Session(
        text.encode(), folder / "a.plastron", Options(**options), environ={}  # type: ignore[arg-type]
    )  # fmt: skip


def codes(made: Session) -> list[str]:
    return [found.code for found in made.diagnostics]


def test_everything_follows_from_the_text(tmp_path: Path) -> None:
    made = session(tmp_path)
    assert len(made.program.statements) == 4
    assert made.diagnostics == ()
    assert list(made.workspace.nodes) == ["talker"]
    plan, diagnostics = made.plan()
    assert diagnostics == ()
    assert [(file.name, file.state) for file in plan.files] == [("talker_pub.py", FileState.CREATE)]
    assert not (tmp_path / "output").exists()


def test_files_that_were_written_are_loaded_when_that_is_told(tmp_path: Path) -> None:
    made = session(tmp_path, "load 'talker_pub.py' as talker\n")
    assert codes(made) == ["file-not-found"]
    write(session(tmp_path, output=tmp_path).plan()[0])
    assert codes(made) == ["file-not-found"]
    made.files_changed()
    assert codes(made) == []
    assert list(made.workspace.nodes["talker"].of(Publisher)) == ["chatter"]


SPEED = """\
create_message_type Axle with float64 angle default 0.5
create_node 'talker' as talker
subscribe talker to 'speeds' of message_type {}
"""
DEFINED = {
    "float64 x": [],
    # A field of ROS 1 has no default value: the program is not for ROS 1.
    "float64 x 0.5": [],
    "floot64 x": ["unknown-type", "bad-definition"],
}


@pytest.mark.parametrize("definition", DEFINED)
@pytest.mark.parametrize("name", ["Speed", "own_msgs/Speed"])
def test_definitions_count_beside_types_of_the_program(
    definition: str, name: str, tmp_path: Path
) -> None:
    (tmp_path / "own_msgs" / "msg").mkdir(parents=True)
    (tmp_path / "own_msgs" / "msg" / "Speed.msg").write_text(f"{definition}\n")
    made = session(tmp_path, SPEED.format(name), target="rclpy")
    assert codes(made) == DEFINED[definition]


def test_what_a_program_wrote_for_one_ros_is_no_mistake_in_the_other(tmp_path: Path) -> None:
    text = SPEED.format("Axle") + "create_message_type Box with Axle axle\ngenerate_node talker\n"
    write(session(tmp_path, text, target="rclpy").plan()[0])
    assert list((tmp_path / "output").glob("*/msg/Axle.msg"))
    # The type is looked for elsewhere now, and is found where it was written.
    broken = text.replace("float64 angle default 0.5", "uint8 angle default 300")
    assert codes(session(tmp_path, broken, target="rclpy")) == ["bad-field"]


def wrong_types(folder: Path) -> None:
    """Write definitions of ROS 1: one names the header shortly, and others hold that."""
    (folder / "mine" / "msg").mkdir(parents=True)
    (folder / "mine" / "package.xml").write_text("<package><name>mine</name></package>")
    for name, text in {"Old": "Header header", "Box": "Old old", "Case": "Box box"}.items():
        (folder / "mine" / "msg" / f"{name}.msg").write_text(f"{text}\n")


def test_the_problems_of_a_program_are_those_of_its_own_types(tmp_path: Path) -> None:
    wrong_types(tmp_path)
    made = session(tmp_path, target="rclpy")
    for name in ("Old", "Box", "Case"):
        text = f"create_message a of message_type mine/{name} and input x=1\n"
        other = session(tmp_path, text, target="rclpy")
        made.edit(0, len(made.document.text), text.encode())
        assert "bad-definition" in codes(made)
        assert codes(made) == codes(other)
        made.edit(0, len(made.document.text), TALKER.encode())
        assert codes(made) == []
        assert made.plan()[1] == ()


def test_a_port_asks_for_types_of_the_other_ros_without_a_word(tmp_path: Path) -> None:
    wrong_types(tmp_path)
    node = "import rospy\nfrom mine.msg import Old\nrospy.init_node('n')\n"
    (tmp_path / "node.py").write_text(f"{node}rospy.Publisher('old', Old, queue_size=1)\n")
    made = session(tmp_path, "load 'node.py' as n\ngenerate_node n using rclpy\n")
    assert codes(made) == []
    plan, _ = made.plan()
    assert b"import rclpy" in plan.files[0].text
    assert made.diagnostics == made.type_problems == ()


def test_a_node_is_read_again_where_a_file_that_it_imports_from_changed(tmp_path: Path) -> None:
    node = "import rospy\nfrom topics import T\nfrom std_msgs.msg import String\n"
    (tmp_path / "node.py").write_text(f"{node}rospy.Publisher(T, String, queue_size=1)\n")
    (tmp_path / "topics.py").write_text("T = 'old'\n")
    made = session(tmp_path, "load 'node.py' as node\n")
    assert list(made.workspace.nodes["node"].of(Publisher)) == ["old"]
    (tmp_path / "topics.py").write_text("T = 'newer'\n")
    made.files_changed()
    assert list(made.workspace.nodes["node"].of(Publisher)) == ["newer"]


def test_a_manifest_is_read_once_and_again_where_it_changed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert write(session(tmp_path).plan()[0]).diagnostics == ()
    written = tmp_path / "output" / "talker_pub.py"
    written.write_text(f"{written.read_text()}# mine\n")
    read: list[Path] = []

    def counted(folder: Path) -> Reading:
        read.append(folder)
        return load_manifest(folder)

    monkeypatch.setattr(manifest, "load_manifest", counted)
    made = session(tmp_path, f"load driver as driver\ngenerate_node driver\n{TALKER}")
    (tmp_path / "driver.py").write_bytes(b"import rospy\nrospy.init_node('driver')\n")
    (tmp_path / "output" / "driver.py").write_bytes((tmp_path / "driver.py").read_bytes())
    for _ in range(2):
        assert made.plan()[0].conflicts == ()
    assert read == [tmp_path / "output"]
    (tmp_path / "output" / manifest.NAME).unlink()
    made.files_changed()
    assert [found.file for found in made.plan()[0].conflicts] == [written]
    (tmp_path / "output" / manifest.NAME).write_text("broken")
    for _ in range(2):
        before = len(read)
        assert "bad-manifest" in [found.code for found in made.plan()[1]]
        # Whether it can be read now is no matter of its text alone.
        assert len(read) > before


def test_a_node_that_is_too_large_is_not_loaded(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "driver.py").write_text("import rospy\nrospy.init_node('driver')\n")
    text = "load driver as driver\nsubscribe driver to 'a' of message_type String\n"
    assert session(tmp_path, text).diagnostics == ()
    monkeypatch.setattr(loader, "LARGEST_FILE", 10)
    assert codes(session(tmp_path, text)) == ["unreadable-file"]


def test_an_edit_changes_what_follows(tmp_path: Path) -> None:
    made = session(tmp_path)
    at = TALKER.index("talker publish")
    made.edit(at, at + len("talker"), b"tolker")
    assert codes(made)[0] == "unknown-node"
    made.edit(at, at + len("tolker"), b"talker")
    assert made.diagnostics == ()
    assert made.document.text == TALKER.encode()


@pytest.fixture
def trusted(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> TrustStore:
    """What the user trusts, in a state of the test's own."""
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    return TrustStore()


def test_output_folder_by_precedence(tmp_path: Path, trusted: TrustStore) -> None:
    assert session(tmp_path).output == tmp_path / "output"
    (tmp_path / "plastron.yaml").write_text("output: nodes")
    assert session(tmp_path).output == tmp_path / "nodes"
    (tmp_path / "plastron.yaml").write_text("output: ../nodes")
    assert session(tmp_path).output == tmp_path / "output"
    trusted.add(tmp_path)
    assert session(tmp_path).output == tmp_path / ".." / "nodes"
    assert session(tmp_path, output=Path("x")).output == Path("x")


def test_output_folder_of_a_trusted_project_may_lie_anywhere(
    tmp_path: Path, trusted: TrustStore
) -> None:
    home = tmp_path / "home"
    home.mkdir()
    (home / "plastron.yaml").write_text("output: ../nodes")
    trusted.add(home)
    plan, diagnostics = session(home).plan()
    assert diagnostics == ()
    assert write(plan).diagnostics == ()
    assert (tmp_path / "nodes" / "talker_pub.py").exists()


def test_problems_of_types_are_there_at_once(tmp_path: Path) -> None:
    (tmp_path / "msg").mkdir()
    (tmp_path / "msg" / "Mine.msg").write_text("int32\n")
    made = session(tmp_path, TALKER.replace("String", "Mine"))
    assert "bad-definition" in codes(made)
    assert codes(made) == codes(made)


def test_last_generation_of_a_node_counts(tmp_path: Path) -> None:
    more = "subscribe talker to 'x' of message_type String\ngenerate_node talker\n"
    (generated,) = session(tmp_path, TALKER + more).generated()
    assert generated.files is not None
    assert generated.files.name == "talker_node.py"


def test_one_node_for_two_libraries_is_two_files(tmp_path: Path) -> None:
    made = session(tmp_path, TALKER + "generate_node talker using rclpy\n")
    assert [each.generation.library for each in made.generated()] == ["rospy", "rclpy"]
    _, diagnostics = made.plan()
    assert [found.code for found in diagnostics] == ["same-file"]


def test_lines_of_other_files(tmp_path: Path) -> None:
    made = session(tmp_path)
    other = tmp_path / "other"
    other.write_text("a\nb\n")
    lines = made.lines(other)
    assert lines is not None
    assert lines.line(2) == "b"
    assert made.lines(tmp_path / "missing") is None
    assert made.lines(None) is made.document.lines


def test_path_that_is_none(tmp_path: Path) -> None:
    (found,) = read_program(Path("a\0b")).diagnostics
    assert found.code == "unreadable-file"
    assert check_text(None, "grüße\r\n".encode()).diagnostics == ()
