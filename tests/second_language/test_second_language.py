"""A language that Plastron does not know, and that nothing outside of its own files names."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from command_line import Copies
from machine import find_ros, graph_environ, mostly_long

HERE = Path(__file__).parent
PROGRAM = """\
create_node 'talker' as talker
create_message hello of message_type String and input "hello"
talker publish hello to 'chatter' of message_type String
subscribe talker to 'hymn' of message_type String calling sing
generate_node talker
create_node 'asker' as asker
asker client_requests 'reset' of service_type Empty with input none
generate_node asker
"""
TALKER = {
    "talker_node.chant": (
        "; what talker does\nnode talker\nend\n\nverse sing of talker\n  speak\nend\n"
    ),
    "talker_node.chanth": (
        "; what talker speaks to\nnode talker\n  sends chatter std_msgs/String\n"
        "  hears hymn std_msgs/String by sing\nend\n"
    ),
}
CHOIR = {
    "choir.chant": (
        "; ours\nnode alto\nend\nnode bass\nend\n\nverse low of bass\n  speak slowly ; ours\nend\n"
    ),
    "choir.chanth": (
        "; ours\nnode alto\n  sends high std_msgs/String\nend\n\n"
        "node bass\n  hears low std_msgs/String by low ; ours\n"
        "  hears hum std_msgs/String by low\nend\n"
    ),
}


class Bench:
    """A folder with a program, and the target beside it as pip would leave it."""

    def __init__(self, folder: Path, copied: Copies) -> None:
        self.folder = folder
        self._copied = copied
        self.output = folder / "output"
        site = folder / "site"
        site.mkdir()
        for name in ("chant.py", "chant_player.py"):
            shutil.copy(HERE / name, site)
        metadata = site / "roschant-1.0.dist-info"
        metadata.mkdir()
        metadata.joinpath("METADATA").write_text("Metadata-Version: 2.1\nName: roschant\n")
        entry = "[plastron.targets]\nroschant = chant:ChantTarget\n"
        metadata.joinpath("entry_points.txt").write_text(entry)
        self.environ = {
            **graph_environ(folder),
            "PYTHONPATH": str(site),
        }
        self.write("a.plastron", PROGRAM)

    def write(self, name: str, text: str) -> None:
        file = self.folder / name
        file.parent.mkdir(exist_ok=True)
        file.write_text(text)

    def python(self, *arguments: str) -> subprocess.CompletedProcess[str]:
        done = subprocess.run(
            [sys.executable, *arguments],
            cwd=self.folder,
            env=self.environ,
            capture_output=True,
            text=True,
            timeout=120,
        )
        assert "Traceback" not in done.stderr, done.stderr
        return done

    def start(self, *arguments: str) -> subprocess.CompletedProcess[str]:
        """Start plastron as a user does."""
        code = "from plastron_tui.cli import main; main()"
        return self.python("-c", code, *arguments)

    def plastron(self, *arguments: str) -> subprocess.CompletedProcess[str]:
        """Run plastron in a copy of a process that has its modules, and none of the target's."""
        done = self._copied.run(arguments, self.folder, b"", self.environ, is_debian=False)
        out, err = done.stdout.decode(), done.stderr.decode()
        assert "Traceback" not in err, err
        return subprocess.CompletedProcess(done.args, done.returncode, out, err)

    def generate(self, program: str = "a.plastron") -> str:
        done = self.plastron("generate", program, "-t", "roschant")
        assert done.returncode == 0, done.stderr
        return done.stderr

    def files(self, folder: Path | None = None) -> dict[str, str]:
        """Return what the output folder holds."""
        found = (folder or self.output).iterdir()
        return {each.name: each.read_text() for each in found if not each.name.startswith(".")}


@pytest.fixture
def bench(tmp_path: Path, copied: Copies) -> Bench:
    return Bench(tmp_path, copied)


def test_check(bench: Bench) -> None:
    done = bench.plastron("check", "a.plastron", "-t", "roschant")
    assert (done.returncode, done.stderr) == (0, "")
    bench.write("b.plastron", PROGRAM.replace("calling sing", "calling verse"))
    done = bench.plastron("check", "b.plastron", "-t", "roschant")
    assert "`verse` is a keyword of Chant and cannot be a function" in done.stderr
    # A keyword of Python alone is none there.
    bench.write("b.plastron", PROGRAM.replace("calling sing", "calling import"))
    assert bench.plastron("check", "b.plastron", "-t", "roschant").returncode == 0


def test_generate(bench: Bench) -> None:
    assert bench.generate() == ""
    files = bench.files()
    assert {name: files[name] for name in TALKER} == TALKER
    assert files["chorus.txt"] == "asker_client.chant\ntalker_node.chant\n"
    assert set(files) == {*TALKER, "chorus.txt", "asker_client.chant", "asker_client.chanth"}
    assert all(not os.access(bench.output / name, os.X_OK) for name in files)
    before = files
    done = bench.start("generate", "a.plastron", "-t", "roschant")
    assert "changed" not in done.stdout
    assert bench.files() == before


@pytest.mark.parametrize(
    "name", mostly_long(["talker_node.chant", "talker_node.chanth"], ["talker_node.chant"])
)
def test_merge(bench: Bench, name: str) -> None:
    bench.generate()
    file = bench.output / name
    file.write_text(file.read_text().replace("; what", "; by hand: what"))
    more = "subscribe talker to 'more' of message_type String\n"
    bench.write(
        "a.plastron", PROGRAM.replace("generate_node talker", f"{more}generate_node talker")
    )
    assert "was changed by hand and is kept, with the program's changes" in bench.generate()
    files = bench.files()
    assert "; by hand: what" in files[name]
    assert "  hears more std_msgs/String by on_more\n" in files["talker_node.chanth"]
    assert "verse on_more of talker\n" in files["talker_node.chant"]
    before = files
    bench.generate()
    assert bench.files() == before


def test_a_file_of_the_node_that_is_gone_is_made_again(bench: Bench) -> None:
    bench.generate()
    before = bench.files()
    (bench.output / "talker_node.chanth").unlink()
    assert bench.generate() == ""
    assert bench.files() == before


LOAD = "load choir node 'bass' as bass\n"


@pytest.fixture
def choir(bench: Bench) -> Bench:
    for name, text in CHOIR.items():
        bench.write(name, text)
    return bench


def test_load_and_edit(choir: Bench) -> None:
    choir.write(
        "b.plastron",
        f"{LOAD}unsubscribe bass from 'hum'\n"
        "subscribe bass to 'hymn' of message_type String calling on_hymn\ngenerate_node bass\n",
    )
    assert choir.generate("b.plastron") == ""
    files = choir.files()
    hymn = "  hears hymn std_msgs/String by on_hymn\n"
    hum = "  hears hum std_msgs/String by low\n"
    assert files["choir.chanth"] == CHOIR["choir.chanth"].replace(hum, hymn)
    assert files["choir.chant"].startswith(CHOIR["choir.chant"])
    assert "verse on_hymn of bass\n" in files["choir.chant"]
    # Again, with handwork in the other file of the set.
    file = choir.output / "choir.chant"
    file.write_text(file.read_text().replace("speak slowly", "speak up"))
    choir.write("b.plastron", f"{LOAD}unsubscribe bass from 'hum'\ngenerate_node bass\n")
    assert "was changed by hand and is kept" in choir.generate("b.plastron")
    assert choir.files()["choir.chanth"] == CHOIR["choir.chanth"].replace(hum, "")
    assert "speak up ; ours" in choir.files()["choir.chant"]
    assert "on_hymn" not in choir.files()["choir.chant"]


@pytest.mark.parametrize(
    ("statement", "line"),
    [
        ("'deep' of message_type String", "hears deep std_msgs/String by low ; ours"),
        ("'low' of message_type Int32", "hears low std_msgs/Int32 by low ; ours"),
        ("'low' of message_type String calling hum", "hears low std_msgs/String by hum ; ours"),
    ],
)
def test_update_in_place(choir: Bench, statement: str, line: str) -> None:
    subscribe = f"unsubscribe bass from 'low'\nsubscribe bass to {statement}\n"
    choir.write("b.plastron", f"{LOAD}{subscribe}generate_node bass\n")
    assert choir.generate("b.plastron") == ""
    low = "hears low std_msgs/String by low ; ours"
    assert choir.files()["choir.chanth"] == CHOIR["choir.chanth"].replace(low, line)


def test_two_names_change_places(choir: Bench) -> None:
    renames = "".join(
        f"bass renames topic '{old}' to '{new}'\n"
        for old, new in (("low", "x"), ("hum", "low"), ("x", "hum"))
    )
    choir.write("b.plastron", f"{LOAD}{renames}generate_node bass\n")
    assert choir.generate("b.plastron") == ""
    header = CHOIR["choir.chanth"].replace("hears low", "hears x").replace("hears hum", "hears low")
    assert choir.files()["choir.chanth"] == header.replace("hears x", "hears hum")


LOOK_TWICE = """\
from pathlib import Path
from plastron_tui.model.kinds import Subscription
from plastron_tui.session import Options, Session
program = Path("b.plastron").resolve()
session = Session(program.read_bytes(), program, Options(target="roschant"))
print(sorted(session.workspace.nodes["bass"].of(Subscription)))
header = Path("output/choir.chanth")
mine = "by low ; ours\\n  hears mine std_msgs/String by low"
header.write_text(header.read_text().replace("by low ; ours", mine))
session.files_changed()
print(sorted(session.workspace.nodes["bass"].of(Subscription)))
"""


def test_what_changes_beside_the_main_file_is_seen(choir: Bench) -> None:
    choir.write(
        "b.plastron", f"{LOAD}subscribe bass to 'hymn' of message_type String\ngenerate_node bass\n"
    )
    assert choir.generate("b.plastron") == ""
    before, after = choir.python("-c", LOOK_TWICE).stdout.splitlines()
    assert "mine" not in before and "mine" in after


def test_edit_in_place(choir: Bench) -> None:
    program = f"{LOAD}subscribe bass to 'hymn' of message_type String\ngenerate_node bass\n"
    choir.write("b.plastron", program)
    done = choir.plastron("generate", "b.plastron", "-t", "roschant", "--in-place")
    assert done.returncode == 0, done.stderr
    assert "hears hymn" in (choir.folder / "choir.chanth").read_text()
    assert "verse on_hymn of bass" in (choir.folder / "choir.chant").read_text()
    assert "verse on_hymn" not in "".join(choir.files().values() if choir.output.exists() else ())


def test_a_file_of_several_nodes_asks_for_a_name(choir: Bench) -> None:
    choir.write("b.plastron", "load choir as choir\n")
    assert "`choir.chant` holds 2 nodes: `alto`, `bass`" in choir.plastron(
        "check", "b.plastron"
    ).stderr  # fmt: skip


def test_graph_and_inspect(choir: Bench) -> None:
    choir.write("b.plastron", LOAD)
    done = choir.plastron("graph", "b.plastron", "--format", "json")
    graph = json.loads(done.stdout)
    assert [topic["name"] for topic in graph["topics"]] == ["/low", "/hum"]
    found = json.loads(choir.plastron("inspect", "choir.chant", "--format", "json").stdout)
    assert found["client_library"] == "roschant"
    assert [node["name"] for node in found["nodes"]] == ["alto", "bass"]


def test_no_node_is_brought_to_another_language(choir: Bench) -> None:
    choir.write("b.plastron", f"{LOAD}generate_node bass using rclpy\n")
    done = choir.plastron("generate", "b.plastron")
    assert "plastron cannot bring a node of `roschant` to `rclpy`" in done.stderr


PREVIEW = """\
from pathlib import Path
from plastron_tui.session import Options, Session
from plastron_tui.studio.analysis import analyse
from plastron_tui.studio.panels.preview import previews_of
text = Path("a.plastron").read_bytes()
session = Session(text, Path("a.plastron"), Options(target="roschant"))
for preview in previews_of(analyse(session, lambda: None), "talker"):
    print(preview.name, preview.state.value, "".join(p.text for p in preview.lines[1]))
"""


def test_preview(bench: Bench) -> None:
    done = bench.python("-c", PREVIEW)
    assert done.stdout.splitlines() == [
        "talker_node.chant create node talker",
        "talker_node.chanth create node talker",
    ]


@pytest.mark.live
def test_run(bench: Bench) -> None:
    find_ros(2)
    done = bench.start("run", "a.plastron", "-t", "roschant")
    assert done.returncode == 0, done.stderr
    assert "talker   | sends chatter std_msgs/String\n" in done.stdout
    assert "asker    | asks reset std_srvs/Empty\n" in done.stdout
