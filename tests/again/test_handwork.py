"""What is changed by hand in a node that was loaded and generated stays, or is a conflict."""

from __future__ import annotations

from itertools import product
from pathlib import Path

import pytest
from again_driver import LIBRARIES, WAYS, Bench, shown
from machine import mostly_long

KEPT = "merged-by-hand: `robot.py`: your changes are kept"
PUBLISH = "n publish hello to 'chatter' of message_type String\n"
SUBSCRIBE = "subscribe n to 'numbers' of message_type Int32\n"
MORE = "subscribe n to 'more' of message_type String\n"
UNSUBSCRIBE = "unsubscribe n from 'command'\n"
END = "generate_node n\n"

BY_NAME, BY_NAME_IN_OUTPUT = "by its name, beside the program", "by its name, in the output"
FOUR_WAYS = (BY_NAME, BY_NAME_IN_OUTPUT, "by its path", "in place")
LISTENING = {
    "rospy": ('    rospy.Service("reset"', '    rospy.Subscriber("mine", String, print)\n'),
    "rclpy": (
        '        self.create_service(Empty, "reset"',
        '        self.create_subscription(String, "mine", print, 10)\n',
    ),
}


class Hand:
    """A way to load a node, and what was written in it by hand."""

    def __init__(self, path: Path, library: str, way: str) -> None:
        self.bench = Bench(path, library)
        load, origin, self.written, self.in_place = WAYS[way]
        self.load = f"{load}\n"
        self.original = self.bench.put(origin)

    def generate(self, *statements: str, force: bool = False) -> tuple[list[str], list[str]]:
        """Generate; return the states, and what is told."""
        program = "".join([self.load, *statements, END])
        outcome = self.bench.generate(program, in_place=self.in_place, force=force)
        assert outcome.errors == []
        return outcome.states, [*outcome.warnings, *outcome.conflicts]

    def edit(self, old: str, new: str) -> None:
        self.bench.edit(self.written, old, new)

    @property
    def text(self) -> str:
        return (self.bench.path / self.written).read_text()

    def shown(self, kind: str) -> list[str]:
        found = shown(self.bench.path / self.written)
        return sorted(str(name) for each, name in found.elements() if each == kind)


# Each library, in place and in a folder of its own. The others are gone in the long suite.
QUICK = [(LIBRARIES[0], "in place"), (LIBRARIES[1], BY_NAME_IN_OUTPUT)]


@pytest.fixture(params=mostly_long(product(LIBRARIES, FOUR_WAYS), QUICK))
def hand(request: pytest.FixtureRequest, tmp_path: Path) -> Hand:
    return Hand(tmp_path, *request.param)


def test_handwork_stays_whatever_the_program_does(hand: Hand) -> None:
    hand.generate(PUBLISH, SUBSCRIBE)
    hand.edit("somebody wrote", "two people wrote")
    for statements in (
        (PUBLISH, SUBSCRIBE), (PUBLISH, SUBSCRIBE, MORE), (PUBLISH,), (UNSUBSCRIBE,), (),
    ):  # fmt: skip
        assert hand.generate(*statements)[1] == [KEPT]
        assert "two people wrote" in hand.text
        compile(hand.text, "robot.py", "exec")
        states, told = hand.generate(*statements)
        # Where the program changes nothing, the file is an original, and the user's.
        assert (states, told in ([KEPT], [] if not statements else [KEPT])) == (["identical"], True)
        expected = {"command", "numbers", "more"}
        expected -= {"command"} if UNSUBSCRIBE in statements else set()
        expected -= {"numbers"} if SUBSCRIBE not in statements else set()
        expected -= {"more"} if MORE not in statements else set()
        assert set(hand.shown("subscriptions")) == expected
        assert hand.shown("publishers").count("chatter") == statements.count(PUBLISH)


def test_callback_that_is_filled_in_stays(hand: Hand) -> None:
    hand.generate(SUBSCRIBE)
    before = hand.text
    at = before.index("\n", before.index("def on_numbers(")) + 1
    indent = before[at:][: len(before[at:]) - len(before[at:].lstrip())]
    filled = (
        f"{before[:at]}{indent}total = msg.data + 1  # mine\n{indent}print(total)\n{before[at:]}"
    )
    (hand.bench.path / hand.written).write_text(filled)
    assert hand.generate(SUBSCRIBE) == (["identical"], [KEPT])
    assert hand.generate(SUBSCRIBE, MORE) == (["changed"], [KEPT])
    assert "# mine" in hand.text
    assert hand.shown("subscriptions") == ["command", "more", "numbers"]
    states, told = hand.generate(MORE)
    assert states == ["changed"]
    assert "merged-by-hand: `on_numbers` is kept, but no longer called" in told
    assert "# mine" in hand.text
    assert hand.shown("subscriptions") == ["command", "more"]
    assert hand.generate(MORE)[0] == ["identical"]


def test_what_was_added_by_hand_can_be_taken_out_by_the_program(hand: Hand) -> None:
    hand.generate(PUBLISH)
    old, new = LISTENING[hand.bench.library]
    hand.edit(old, new + old)
    assert hand.generate(PUBLISH) == (["identical"], [KEPT])
    if "nodes/robot.py" in hand.load and not hand.in_place:
        # The path means the original, in which nothing was done by hand.
        program = f"{hand.load}unsubscribe n from 'mine'\n{END}"
        assert hand.bench.generate(program).errors != []
        return
    assert hand.generate(PUBLISH, "unsubscribe n from 'mine'\n")[0] == ["changed"]
    assert hand.shown("subscriptions") == ["command"]
    assert hand.generate(PUBLISH, "unsubscribe n from 'mine'\n")[0] == ["identical"]
    assert hand.shown("publishers") == ["chatter", "status"]


def test_what_was_taken_out_by_hand_stays_out(hand: Hand) -> None:
    hand.generate(PUBLISH, SUBSCRIBE)
    line = next(
        line for line in hand.text.split("\n") if "on_numbers" in line and "def" not in line
    )
    hand.edit(f"{line}\n", "")
    for statements in ((PUBLISH, SUBSCRIBE), (PUBLISH, SUBSCRIBE, MORE)):
        states, told = hand.generate(*statements)
        assert told[0] == KEPT
        assert "numbers" not in hand.shown("subscriptions")
    assert states == ["changed"]
    assert "more" in hand.shown("subscriptions")


def test_same_lines_changed_by_both_are_a_conflict_and_nothing_is_lost(hand: Hand) -> None:
    hand.generate(PUBLISH)
    line = next(line for line in hand.text.split("\n") if '"chatter"' in line)
    name = line.split(" =")[0]
    hand.edit(f"{line}\n", f"{line}\n{name}.anything()\n")
    before = hand.bench.files()
    states, told = hand.generate(SUBSCRIBE)
    assert states == ["conflict"]
    number = hand.text[: hand.text.index("anything")].count("\n") + 1
    assert told[-1].endswith(f"the publisher `chatter` is used in line {number}")
    assert hand.bench.files() == before
    assert hand.generate(SUBSCRIBE, force=True)[0] == ["conflict"]
    assert "anything" not in hand.text
    backup = hand.bench.path / f"{hand.written}.bak"
    assert "anything" in backup.read_text()
    assert hand.generate(SUBSCRIBE) == (["identical"], [])


def test_force_writes_what_a_first_run_writes(hand: Hand) -> None:
    hand.generate(PUBLISH)
    fresh = hand.text
    hand.edit("somebody wrote", "two people wrote")
    hand.generate(PUBLISH, force=True)
    assert hand.text == fresh
    assert hand.generate(PUBLISH, force=True)[0] == ["identical"]
    assert hand.generate(PUBLISH) == (["identical"], [])


def test_check_sees_what_generate_sees(hand: Hand) -> None:
    hand.generate(PUBLISH, SUBSCRIBE)
    hand.edit("somebody wrote", "two people wrote")
    for statements in ((PUBLISH, SUBSCRIBE), (PUBLISH, PUBLISH), ("unsubscribe n from 'x'\n",)):
        program = "".join([hand.load, *statements, END])
        session = hand.bench.session(program, output="output")
        outcome = hand.bench.generate(program, in_place=hand.in_place)
        codes = [f"{each.code}: {each.message}" for each in session.diagnostics]
        assert codes == outcome.errors


@pytest.mark.parametrize("library", LIBRARIES)
def test_original_and_output_are_both_changed(tmp_path: Path, library: str) -> None:
    hand = Hand(tmp_path, library, BY_NAME)
    hand.generate(PUBLISH)
    hand.edit("somebody wrote", "two people wrote")
    text = hand.original.read_text()
    hand.original.write_text(text.replace('"fine"', '"very well"'))
    assert hand.generate(PUBLISH) == (["changed"], [KEPT])
    assert "two people wrote" in hand.text
    assert '"very well"' in hand.text
    assert hand.generate(PUBLISH) == (["identical"], [KEPT])
    hand.original.write_text(text.replace("somebody wrote", "three people wrote"))
    before = hand.bench.files()
    states, told = hand.generate(PUBLISH)
    assert states == ["conflict"]
    assert told[-1].endswith("robot.py`, which it was made from, in the same lines")
    assert hand.bench.files() == before


@pytest.mark.parametrize("library", LIBRARIES)
def test_handwork_that_the_program_changed_does_not_go_to_another_original(
    tmp_path: Path, library: str
) -> None:
    hand = Hand(tmp_path, library, BY_NAME)
    hand.generate(PUBLISH)
    old, new = LISTENING[library]
    hand.edit(old, new + old)
    assert hand.generate(PUBLISH, "unsubscribe n from 'mine'\n")[0] == ["changed"]
    hand.edit('"fine"', '"good"')
    hand.bench.edit("robot.py", "somebody", "somebody else")
    before = hand.bench.files()
    for statements in ((), (PUBLISH,), (PUBLISH, SUBSCRIBE)):
        states, told = hand.generate(*statements)
        assert states == ["conflict"]
        assert told[-1].endswith("robot.py`, which it was made from, was changed as well")
    assert hand.bench.files() == before


@pytest.mark.parametrize("library", LIBRARIES)
@pytest.mark.parametrize("how", ["gone", "broken", "broken layer"])
def test_without_a_memory_nothing_is_lost(tmp_path: Path, library: str, how: str) -> None:
    hand = Hand(tmp_path, library, BY_NAME_IN_OUTPUT)
    hand.generate(SUBSCRIBE)
    manifest = tmp_path / "output/.plastron.json"
    if how == "gone":
        manifest.unlink()
    elif how == "broken":
        manifest.write_bytes(manifest.read_bytes()[:-9])
    else:
        text = manifest.read_text()
        at = text.index('"texts": "') + 30
        manifest.write_text(text[:at] + "AAAA" + text[at + 4 :])
    before = hand.text
    outcome = hand.bench.generate(f"{hand.load}{SUBSCRIBE}{END}")
    assert [each.split(":")[0] for each in outcome.errors] == ["already-subscribed"]
    outcome = hand.bench.generate(f"{hand.load}{MORE}{END}")
    assert outcome.states == ["changed"]
    assert [each.split(":")[0] for each in outcome.warnings] == (
        [] if how == "gone" else ["bad-manifest"]
    )
    assert hand.shown("subscriptions") == ["command", "more", "numbers"]
    assert before != hand.text
    assert hand.generate(MORE) == (["identical"], [])


@pytest.mark.parametrize("library", LIBRARIES)
def test_file_that_is_indented_anew(tmp_path: Path, library: str) -> None:
    """Lines of both indents together are no Python, and no start for a second run."""
    hand = Hand(tmp_path, library, BY_NAME_IN_OUTPUT)
    hand.original.write_text(hand.text.replace("    ", "\t"))
    assert hand.generate(UNSUBSCRIBE) == (["changed"], [])
    hand.original.write_text(hand.text.expandtabs(4))
    for statements in ((PUBLISH,), ("n stop_publishing to 'status'\n", SUBSCRIBE)):
        states, told = hand.generate(*statements)
        assert (states, told[-1]) == (["changed"], KEPT)
        assert all(each.startswith("idle-code: ") for each in told[:-1])
        assert "\t" not in hand.text
        compile(hand.text, "robot.py", "exec")
        assert hand.generate(*statements)[0] == ["identical"]


@pytest.mark.parametrize("library", LIBRARIES)
def test_node_that_is_created_and_loaded_and_no_longer_changed(
    tmp_path: Path, library: str
) -> None:
    bench = Bench(tmp_path, library)
    create = "create_node 'a' as a\na publish hello to 'x' of message_type String\n"
    start = f"{create}generate_node a\nload a_pub as n\n"
    assert bench.generate(f"{start}{SUBSCRIBE}{END}").states == ["create"]
    bench.edit("output/a_pub.py", "def main(", "# mine\ndef main(")
    kept = KEPT.replace("robot", "a_pub")
    assert bench.generate(f"{start}{END}") == (["changed"], [kept], [], [])
    before = bench.files()
    assert b"# mine" in before["output/a_pub.py"]
    for _ in range(2):
        assert bench.generate(f"{start}{END}") == (["identical"], [kept], [], [])
        assert bench.files()["output/a_pub.py"] == before["output/a_pub.py"]
    bench.generate(f"{start}{SUBSCRIBE}{END}")
    assert b"# mine" in bench.files()["output/a_pub.py"]


@pytest.mark.parametrize("library", LIBRARIES)
@pytest.mark.parametrize("force", [False, True])
def test_node_that_is_generated_loaded_and_generated(
    tmp_path: Path, library: str, force: bool
) -> None:
    bench = Bench(tmp_path, library)
    original = bench.put("robot.py").read_text()
    start = f"load robot as n\n{UNSUBSCRIBE}{END}load robot as m\n"
    texts = [f"{start}{each.replace('n ', 'm ', 1)}generate_node m\n" for each in (PUBLISH, "")]
    bench.generate(texts[0])
    bench.edit("output/robot.py", "def main(", "# mine\ndef main(")
    for number, text in enumerate([texts[0], texts[0], texts[1], texts[0]]):
        outcome = bench.generate(text, force=force and number > 1)
        assert number > 1 or outcome.states == ["identical"]
        bench.put("robot.py", original + "\n" * number)
        kept = [each for name, each in bench.files().items() if not name.endswith(".json")]
        assert any(b"# mine" in each for each in kept)


def test_a_callback_renamed_by_hand_is_not_taken_for_the_programs(hand: Hand) -> None:
    """What is remembered of the program is settled at once, with `force` as well."""
    hand.generate(PUBLISH)
    source = hand.text
    hand.bench.put(hand.written, source.replace("on_command", "on_order"))
    for force in (False, True):
        hand.generate(PUBLISH, SUBSCRIBE, force=force)
        settled = hand.bench.files()
        assert ("on_order" in hand.text) != force
        states, _ = hand.generate(PUBLISH, SUBSCRIBE)
        assert states == ["identical"]
        assert hand.bench.files() == settled


def test_what_program_and_hands_keep_stays(tmp_path: Path) -> None:
    """The timer of the original was not the program's, though it sends through what goes."""
    bench = Bench(tmp_path, "rclpy")
    original = bench.put("robot.py").read_text()
    changes = (
        "n publish hello to 'chatter' of message_type String\nn stop_publishing to 'status'\n"
        "n publish five to 'numbers' of message_type Int32 at 2 hz\n"
    )
    assert bench.generate(f"load robot as n\n{changes}generate_node n\n").states == ["create"]
    bench.edit("output/robot.py", "from std_msgs", "# mine\nfrom std_msgs")
    bench.edit("output/robot.py", "    def tick", "    # mine as well\n    def tick")
    outcome = bench.generate("load robot as n\ngenerate_node n\n")
    assert outcome.conflicts == []
    now = (bench.path / "output/robot.py").read_text()
    assert [line for line in now.split("\n") if "# mine" not in line] == original.split("\n")


def test_a_timer_that_goes_with_what_it_sends_was_not_taken_out_by_hand(tmp_path: Path) -> None:
    bench = Bench(tmp_path, "rclpy")
    bench.put("robot.py")
    changes = (
        "subscribe n to 'more' of message_type String calling hear\nn stop_publishing to 'status'\n"
    )
    assert bench.generate(f"load robot as n\n{changes}generate_node n\n").states == ["create"]
    mine = '        self.create_subscription(String, "mine", print, 10)\n'
    bench.edit(
        "output/robot.py", "        self.create_service", f"{mine}        self.create_service"
    )
    outcome = bench.generate("load robot as n\ngenerate_node n\n")
    assert (outcome.states, outcome.conflicts) == (["changed"], [])
    assert not [each for each in outcome.warnings if "by hand, and stays out" in each]
    assert any("and 3 other lines" in each for each in outcome.warnings), outcome.warnings
    before = bench.files()
    assert bench.generate("load robot as n\ngenerate_node n\n").states == ["identical"]
    assert bench.files() == before


def test_what_program_and_hands_keep_is_not_dropped(tmp_path: Path) -> None:
    """No merge by lines, and endpoint by endpoint the original's timer would go: a conflict."""
    bench = Bench(tmp_path, "rclpy")
    bench.put("robot.py")
    changes = (
        "n publish hello to 'chatter' of message_type String\nn stop_publishing to 'status'\n"
        "n publish five to 'numbers' of message_type Int32 at 2 hz\n"
        "subscribe n to 'more' of message_type String calling hear\n"
    )
    assert bench.generate(f"load robot as n\n{changes}generate_node n\n").states == ["create"]
    mine = '        self.create_subscription(String, "mine", print, 10)\n'
    bench.edit(
        "output/robot.py", "        self.create_service", f"{mine}        self.create_service"
    )
    before = bench.files()
    outcome = bench.generate("load robot as n\ngenerate_node n\n")
    assert any("would lose `" in each for each in outcome.conflicts), outcome
    assert bench.files() == before
