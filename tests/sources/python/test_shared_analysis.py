"""The analysis of a text is made once for all who ask, and anew where something else changed."""

from __future__ import annotations

import gc
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from weakref import ref

import pytest

from plastron_tui.output.writer import write
from plastron_tui.session import Options, Session
from plastron_tui.sources.python import shared_analysis
from plastron_tui.sources.python.analysis import Analysis
from plastron_tui.sources.python.calls import RCLPY
from plastron_tui.sources.python.shared_analysis import analyze, package_names
from plastron_tui.sources.text_memo import MEMO

NODE = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Robot(Node):
    def __init__(self):
        super().__init__('robot')
        self.status = self.create_publisher(String, 'status', 10)
        self.create_subscription(String, 'command', self.on_command, 10)

    def on_command(self, msg):
        self.status.publish(msg)


def main():
    rclpy.init()
    rclpy.spin(Robot())


main()
"""
PROGRAM = """\
load 'node.py' as robot
subscribe robot to 'mode' of message_type String calling {callback}
generate_node robot
"""


@pytest.fixture
def analyzed(monkeypatch: pytest.MonkeyPatch) -> Counter[bytes]:
    """How often each text was analyzed."""
    made: Counter[bytes] = Counter()
    complete = shared_analysis.complete

    def count(outlined):
        made[outlined.syntax.text] += 1
        return complete(outlined)

    monkeypatch.setattr(shared_analysis, "complete", count)
    MEMO.clear()
    return made


def generate(folder: Path, callback: str) -> bytes:
    program = PROGRAM.format(callback=callback).encode()
    session = Session(program, folder / "a.plastron", Options(in_place=True), environ={})
    assert not session.diagnostics
    plan, found = session.plan()
    assert not [each.message for each in found if each.severity == "error"]
    write(plan)
    return (folder / "node.py").read_bytes()


def test_a_generate_analyzes_each_text_once(tmp_path: Path, analyzed: Counter[bytes]) -> None:
    node = tmp_path / "node.py"
    node.write_text(NODE)
    made = generate(tmp_path, "on_mode")
    assert analyzed == {NODE.encode(): 1, made: 1}
    # Again, as in a process of its own: the output leads back to the original.
    analyzed.clear()
    MEMO.clear()
    assert generate(tmp_path, "on_mode") == made
    assert analyzed == {NODE.encode(): 1, made: 1}
    # Lines that were written beside, merged by lines; then the very line, merged by endpoints.
    for by_hand, callback in (
        ((b"publish(msg)", b"publish(msg)  # on"), "on_mode_now"),
        ((b"on_mode_now, 10", b"on_mode_now, 20"), "on_other"),
    ):
        node.write_bytes(node.read_bytes().replace(*by_hand))
        analyzed.clear()
        MEMO.clear()
        made = generate(tmp_path, callback)
        assert made.count(by_hand[1].replace(b"on_mode_now", callback.encode())) == 1
        assert analyzed[made] == analyzed[NODE.encode()] == 1
        assert set(analyzed.values()) == {1}


BESIDE = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String
from names import SCAN

node = rclpy.create_node('n')
node.create_publisher(String, SCAN, 10)
"""


@pytest.mark.parametrize(
    ("name", "text", "changed", "topics"),
    [
        ("scripts/names.py", "SCAN = 'scan'\n", "SCAN = 'other'\n", ("scan", "other")),
        ("scripts/names.py", "SCAN = 'scan'\n", None, ("scan", None)),
        ("scripts/names.py", None, "SCAN = 'new'\n", (None, "new")),
        # The package begins a folder further up, where there are names as well.
        ("package.xml", None, "<package/>", (None, "of package")),
    ],
)
def test_what_changes_beside_a_text_counts(
    tmp_path: Path,
    analyzed: Counter[bytes],
    name: str,
    text: str | None,
    changed: str | None,
    topics: tuple[str | None, str | None],
) -> None:
    scripts = tmp_path / "scripts"
    scripts.mkdir()
    (tmp_path / "names.py").write_text("SCAN = 'of package'\n")

    def read(content: str | None) -> tuple[Analysis, str | None]:
        (tmp_path / name).unlink(missing_ok=True)
        if content is not None:
            (tmp_path / name).write_text(content)
        found = analyze(BESIDE.encode(), RCLPY, package_names(scripts / "node.py", RCLPY))
        return found, found.sites[0].endpoint.name

    first, topic = read(text)
    assert topic == topics[0]
    (scripts / "another.py").write_text("nobody asks for it\n")
    names = package_names(scripts / "node.py", RCLPY)
    assert analyze(BESIDE.encode(), RCLPY, names) is first
    again, topic = read(changed)
    assert again is not first
    assert topic == topics[1]
    assert analyzed[BESIDE.encode()] == 2


def test_what_one_text_asks_of_a_package_takes_nothing_from_the_next(tmp_path: Path) -> None:
    # So many modules are read of a package (`MOST_MODULES`), for each version of a file.
    for number in range(40):
        (tmp_path / f"m{number}.py").write_text(f"TOPIC = 'topic_{number}'\n")
    for first in (0, 20):
        text = "import rclpy\nfrom std_msgs.msg import String\nnode = rclpy.create_node('n')\n"
        for number in range(first, first + 20):
            text += f"from m{number} import TOPIC as T{number}\n"
            text += f"node.create_publisher(String, T{number}, 10)\n"
        found = analyze(text.encode(), RCLPY, package_names(tmp_path / "node.py", RCLPY))
        assert [site.endpoint.name for site in found.sites] == [
            f"topic_{number}" for number in range(first, first + 20)
        ]


def test_who_asks_next_may_ask_as_much(analyzed: Counter[bytes]) -> None:
    first = analyze(NODE.encode(), RCLPY)
    left = first.resolver.effort.in_all, first.resolver.passes_left
    first.resolver.effort.in_all, first.resolver.passes_left = 0, 0
    assert analyze(NODE.encode(), RCLPY) is first
    assert (first.resolver.effort.in_all, first.resolver.passes_left) == left


def test_each_thread_has_its_own(analyzed: Counter[bytes]) -> None:
    first = analyze(NODE.encode(), RCLPY)
    with ThreadPoolExecutor(1) as other:
        second = other.submit(analyze, NODE.encode(), RCLPY).result()
    assert second is not first
    assert analyzed[NODE.encode()] == 2


def test_what_is_forgotten_needs_no_collector(tmp_path: Path) -> None:
    (tmp_path / "names.py").write_text("SCAN = 'scan'\n")
    names = package_names(tmp_path / "node.py", RCLPY)
    scopes = ref(analyze(BESIDE.encode(), RCLPY, names).scopes)
    package = ref(names._package)
    del names
    gc.disable()
    try:
        assert scopes() is not None
        MEMO.clear()
        assert scopes() is None
        assert package() is None
    finally:
        gc.enable()
