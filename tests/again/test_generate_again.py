"""A program that loads a node may be generated any number of times: it starts from the original."""

from __future__ import annotations

from pathlib import Path

import pytest
from again_driver import LIBRARIES, NODES, WAYS, Bench, shown
from hypothesis import given, settings
from hypothesis import strategies as st
from machine import examples, mostly_long

from plastron_tui.model.kinds import Subscription
from plastron_tui.output.manifest import NAME, load_manifest

CHANGES = """\
n publish hello to 'chatter' of message_type String
subscribe n to 'numbers' of message_type Int32
unsubscribe n from 'command'
n stop_service 'reset'
generate_node n
"""
PUBLISH_MORE = "n publish five to 'more' of message_type Int32\n"
each_way = pytest.mark.parametrize("way", mostly_long(WAYS, list(WAYS)[:4:2]))


@pytest.fixture(params=LIBRARIES)
def bench(request: pytest.FixtureRequest, tmp_path: Path) -> Bench:
    return Bench(tmp_path, request.param)


@each_way
def test_second_time_nothing_changes(bench: Bench, way: str) -> None:
    load, origin, written, in_place = WAYS[way]
    bench.put(origin)
    first = bench.generate(f"{load}\n{CHANGES}", in_place=in_place)
    assert (first.warnings, first.conflicts, first.errors) == ([], [], [])
    assert ("publishers", "chatter") in shown(bench.path / written)
    before = bench.files()
    for _ in range(2):
        again = bench.generate(f"{load}\n{CHANGES}", in_place=in_place)
        assert again == (["identical"], [], [], [])
        assert bench.files() == before


@each_way
def test_without_its_changes_the_original_is_back(bench: Bench, way: str) -> None:
    load, origin, written, in_place = WAYS[way]
    original = bench.put(origin).read_bytes()
    bench.generate(f"{load}\n{CHANGES}", in_place=in_place)
    assert bench.generate(f"{load}\ngenerate_node n\n", in_place=in_place).states == ["changed"]
    assert (bench.path / written).read_bytes() == original
    again = bench.generate(f"{load}\ngenerate_node n\n", in_place=in_place)
    assert again == (["identical"], [], [], [])


OTHER_NODE = [
    "n publish hello to 'chatter' of message_type String",
    "n publish five to 'numbers' of message_type Int32 at 2 hz",
    "n publish hello to 'status' of message_type String",
    "subscribe n to 'more' of message_type String calling hear",
    "subscribe n to 'numbers' of message_type Int32",
    "unsubscribe n from 'command'",
    "unsubscribe n from 'command'\n"
    "subscribe n to 'command' of message_type Int32 calling on_command",
    "n stop_publishing to 'status'",
    "n stop_service 'reset'",
    "n provides_service 'start' of service_type Trigger",
    "n client_requests 'stop' of service_type Empty with input none",
]

REMOVALS = {
    "unsubscribe n from 'command'",
    "n stop_publishing to 'status'",
    "n stop_service 'reset'",
}
"""What takes away all that the node has."""


@st.composite
def programs(draw: st.DrawFn) -> str:
    """Return statements that can stand together."""
    chosen = draw(st.lists(st.sampled_from(OTHER_NODE), unique=True, max_size=5))
    verbs = [line for each in chosen for line in each.split("\n")]
    unsubscribes = [line for line in verbs if line.startswith("unsubscribe")]
    stops = any("stop_publishing" in line for line in verbs)
    if len(unsubscribes) > 1:
        chosen = [each for each in chosen if each != unsubscribes[0]]
    if stops:
        chosen = [each for each in chosen if "hello to 'status'" not in each]
    if set(chosen) == REMOVALS:
        chosen.pop()  # a node that does nothing is a mistake
    return "\n".join([*chosen, "generate_node n\n"])


@settings(max_examples=examples(40), deadline=None)
@given(programs(), programs(), st.sampled_from(LIBRARIES), st.sampled_from(sorted(WAYS)))
def test_what_was_generated_before_does_not_matter(
    tmp_path_factory: pytest.TempPathFactory, one: str, two: str, library: str, way: str
) -> None:
    load, origin, written, in_place = WAYS[way]
    texts = []
    for runs in ([one, two, two, one], [one]):
        bench = Bench(tmp_path_factory.mktemp("again"), library)
        bench.put(origin)
        for program in runs:
            outcome = bench.generate(f"{load}\n{program}", in_place=in_place)
            assert (outcome.conflicts, outcome.errors) == ([], [])
        texts.append((bench.path / written).read_bytes())
    assert texts[0] == texts[1]
    again = bench.generate(f"{load}\n{one}", in_place=in_place)
    assert again == (["identical"], [], [], [])


@pytest.mark.parametrize(
    "way",
    mostly_long([way for way in WAYS if way != "by its name, in the output"], list(WAYS)[:4:3]),
)
def test_folder_of_its_own_makes_no_difference(bench: Bench, way: str) -> None:
    load, origin, _, in_place = WAYS[way]
    bench.put(origin)
    bench.generate(f"{load}\n{CHANGES}", in_place=in_place)
    assert bench.generate(f"{load}\n{CHANGES}", output="elsewhere").states == ["create"]
    first = bench.path / WAYS[way][2]
    assert (bench.path / "elsewhere/robot.py").read_bytes() == first.read_bytes()
    assert bench.generate(f"{load}\n{CHANGES}", output="elsewhere").states == ["identical"]


def check_followed(bench: Bench, original: Path) -> None:
    """Check that what is changed in an original is in the output the next time, and stays."""
    program = f"load robot as n\n{CHANGES}"
    bench.generate(program)
    bench.edit(str(original), "somebody", "somebody else")
    assert bench.generate(program) == (["changed"], [], [], [])
    assert b"somebody else" in (bench.path / "output/robot.py").read_bytes()
    assert bench.generate(program).states == ["identical"]


def test_original_that_is_changed_counts_as_it_is(bench: Bench) -> None:
    check_followed(bench, bench.put("robot.py"))


def test_program_that_changes_nothing_any_more_is_forgotten(bench: Bench) -> None:
    bench.put("output/robot.py")
    bench.generate(f"load robot as n\n{CHANGES}")
    assert list(load_manifest(bench.path / "output")[0].layers) == ["robot.py"]
    assert bench.generate("load robot as n\ngenerate_node n\n").states == ["changed"]
    assert load_manifest(bench.path / "output")[0].layers == {}


def test_what_a_program_wrote_hides_other_files_without_a_word(bench: Bench) -> None:
    program = f"load robot as n\n{CHANGES}"
    bench.put("robot.py")
    bench.put("output/robot.py")
    assert [found.code for found in bench.session(program).diagnostics] == ["hidden-file"]
    bench.generate(program)
    for name in ("robot.plastron", "other.plastron"):
        assert bench.session("load robot as n\ngenerate_node n\n", name).diagnostics == ()


def test_original_that_is_changed_is_read_again_by_the_session_that_is_there(bench: Bench) -> None:
    program = "load robot as n\nn stop_service 'reset'\ngenerate_node n\n"
    bench.put("robot.py")
    bench.generate(program)
    session = bench.session(program)
    assert list(session.workspace.nodes["n"].of(Subscription)) == ["command"]
    bench.edit("robot.py", '"command"', '"order"')
    session.files_changed()
    assert list(session.workspace.nodes["n"].of(Subscription)) == ["order"]


def test_files_made_from_each_other_lead_to_the_first(bench: Bench) -> None:
    bench.put("first/robot.py", NODES[bench.library].replace("somebody", "nobody"))
    bench.put("second/robot.py")
    bench.generate(f"load 'second/robot.py' as n\n{CHANGES}", output="third")
    made = bench.generate(f"load 'first/robot.py' as n\n{CHANGES}", output="second", force=True)
    assert made.errors == []
    bench.edit("first/robot.py", "nobody", "nobody else")
    last = f"load 'third/robot.py' as n\n{CHANGES}"
    assert bench.generate(last, output="third") == (["changed"], [], [], [])
    assert "nobody else" in (bench.path / "third/robot.py").read_text()


def test_original_that_is_gone_is_remembered(bench: Bench) -> None:
    program = f"load robot as n\n{CHANGES}"
    original = bench.put("robot.py")
    bench.generate(program)
    original.unlink()
    for _ in range(2):
        assert bench.generate(program) == (["identical"], [], [], [])
    assert bench.generate("load robot as n\ngenerate_node n\n").states == ["changed"]
    assert (bench.path / "output/robot.py").read_text() == NODES[bench.library]


@pytest.mark.parametrize("in_place", [True, False])
def test_file_that_is_put_back_is_an_original_again(bench: Bench, in_place: bool) -> None:
    """As version control does it; the second time with what somebody has committed since."""
    program = f"load 'output/robot.py' as n\n{CHANGES}"
    for text in (NODES[bench.library], NODES[bench.library].replace("somebody", "somebody else")):
        bench.put("output/robot.py", text)
        assert bench.generate(program, in_place=in_place) == (["changed"], [], [], [])
        changed = bench.files()
        bench.put("output/robot.py", text)
        assert bench.generate(program, in_place=in_place) == (["changed"], [], [], [])
        assert bench.files() == changed


def test_link_is_followed(bench: Bench) -> None:
    bench.put("real/robot.py")
    (bench.path / "robot.py").symlink_to(bench.path / "real/robot.py")
    program = f"load 'robot.py' as n\n{CHANGES}"
    assert bench.generate(program, in_place=True).states == ["changed"]
    assert bench.generate(program, in_place=True).states == ["identical"]
    assert (bench.path / "real" / NAME).is_file()
    assert (bench.path / "robot.py").is_symlink()


@pytest.mark.parametrize("library", LIBRARIES)
def test_node_of_the_other_ros(tmp_path: Path, library: str) -> None:
    other = {"rospy": "rclpy", "rclpy": "rospy"}[library]
    bench = Bench(tmp_path, library)
    bench.put("robot.py")
    program = f"load robot as n\n{CHANGES}".replace("node n", f"node n using {other}")
    first = bench.generate(program)
    assert (first.states, first.conflicts, first.errors) == (["create"], [], [])
    again = bench.generate(program)
    assert (again.states, again.warnings) == (["identical"], first.warnings)
    less = program.replace("n stop_service 'reset'\n", "")
    assert bench.generate(less).states == ["changed"]
    fresh = Bench(tmp_path / "fresh", library)
    fresh.put("robot.py")
    fresh.generate(less)
    written = fresh.path / "output/robot.py"
    assert written.read_bytes() == (tmp_path / "output/robot.py").read_bytes()
    bench.edit("output/robot.py", "somebody", "somebody else")
    kept = "merged-by-hand: `robot.py`: your changes are kept"
    for each in (less, program):
        assert kept in bench.generate(each).warnings
        assert "somebody else" in (tmp_path / "output/robot.py").read_text()
    assert bench.generate(program).states == ["identical"]


def test_node_that_is_created_loaded_and_changed(bench: Bench) -> None:
    program = """\
create_node 'talker' as t
t publish hello to 'chatter' of message_type String
generate_node t
load talker_pub as n
subscribe n to 'numbers' of message_type Int32
generate_node n
"""
    assert bench.generate(program).states == ["create"]
    assert bench.generate(program) == (["identical"], [], [], [])
    more = f"{program}n publish five to 'x' of message_type Int32\ngenerate_node n\n"
    fresh = Bench(bench.path / "fresh", bench.library)
    fresh.generate(more)
    assert bench.generate(more).states == ["changed"]
    written = (bench.path / "output/talker_pub.py", fresh.path / "output/talker_pub.py")
    assert written[0].read_bytes() == written[1].read_bytes()


def test_node_that_is_loaded_changed_and_loaded_again(bench: Bench) -> None:
    bench.put("robot.py")
    program = f"""\
load robot as n
{CHANGES}load robot as m
unsubscribe m from 'numbers'
generate_node m
"""
    first = bench.generate(program)
    assert first == (["create"], [], [], [])
    expected = shown(bench.path / "output/robot.py")
    assert ("publishers", "chatter") in expected
    assert ("subscriptions", "numbers") not in expected
    assert bench.generate(program) == (["identical"], [], [], [])
    bench.edit("output/robot.py", "somebody", "somebody else")
    for _ in range(2):
        assert bench.generate(program).states == ["identical"]
        assert "somebody else" in (bench.path / "output/robot.py").read_text()


def test_program_without_a_file_has_no_memory(bench: Bench) -> None:
    bench.put("output/robot.py")
    program = "load robot as n\nn publish hello to 'chatter' of message_type String\n"
    session = bench.session(f"{program}generate_node n\n")
    session.path = None
    plan, _ = session.plan()
    assert [file.layers for file in plan.files] == [None]


def test_memory_of_files_that_are_gone_is_dropped(bench: Bench) -> None:
    for name in ("one", "two"):
        bench.put(f"{name}.py")
        bench.generate(f"load {name} as n\n{CHANGES}", f"{name}.plastron")
    assert sorted(load_manifest(bench.path / "output")[0].layers) == ["one.py", "two.py"]
    (bench.path / "output/one.py").unlink()
    bench.generate("load two as n\ngenerate_node n\n", "two.plastron")
    assert sorted(load_manifest(bench.path / "output")[0].layers) == ["two.py"]


def test_original_behind_a_link_counts_as_it_is(bench: Bench) -> None:
    (bench.path / ".git").mkdir()
    real = bench.put("elsewhere/robot.py")
    here = Bench(bench.path / "here", bench.library)
    here.path.mkdir()
    (here.path / "robot.py").symlink_to(real)
    check_followed(here, real)


def test_manifest_leads_to_no_file_that_a_name_cannot_mean(bench: Bench) -> None:
    """One who shares a folder must not have another's files changed with it."""
    outside = bench.put("outside/robot.py")
    here = Bench(bench.path / "here", bench.library)
    here.put("nodes/robot.py")
    here.generate(f"load 'nodes/robot.py' as n\n{CHANGES}")
    manifest = here.path / "output" / NAME
    text = manifest.read_text()
    assert "../nodes/robot.py" in text
    manifest.write_text(text.replace("../nodes/robot.py", "../../outside/robot.py"))
    program = f"load robot as n\n{CHANGES}".replace("generate", PUBLISH_MORE + "generate")
    before = outside.read_bytes()
    assert here.generate(program, in_place=True).states == ["changed"]
    assert outside.read_bytes() == before
