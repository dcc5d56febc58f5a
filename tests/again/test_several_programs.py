"""Programs that load what others generate: each answers for its own changes."""

from __future__ import annotations

from pathlib import Path

import pytest
from again_driver import LIBRARIES, Bench, shown

CREATE = """\
create_node 'talker' as t
t publish hello to 'chatter' of message_type String
generate_node t
"""
LOAD = "load talker_pub as n\n"
SUBSCRIBE = "subscribe n to 'numbers' of message_type Int32\n"
PROVIDE = "n provides_service 'reset' of service_type Empty\n"
END = "generate_node n\n"
FILE = "output/talker_pub.py"


@pytest.fixture(params=LIBRARIES)
def bench(request: pytest.FixtureRequest, tmp_path: Path) -> Bench:
    return Bench(tmp_path, request.param)


def run(bench: Bench, program: str, text: str) -> list[str]:
    outcome = bench.generate(text, f"{program}.plastron")
    assert (outcome.conflicts, outcome.errors) == ([], [])
    return [*outcome.states, *outcome.warnings]


def names(bench: Bench) -> list[str]:
    return sorted(str(name) for _, name in shown(bench.path / FILE))


def test_each_of_three_programs_can_be_generated_again(bench: Bench) -> None:
    programs = {
        "create": CREATE, "listen": f"{LOAD}{SUBSCRIBE}{END}", "serve": f"{LOAD}{PROVIDE}{END}",
    }  # fmt: skip
    for program, text in programs.items():
        assert run(bench, program, text) in (["create"], ["changed"])
    assert names(bench) == ["chatter", "numbers", "reset"]
    before = bench.files()
    for program in ("serve", "create", "listen", "create", "serve"):
        assert run(bench, program, programs[program]) == ["identical"]
        assert bench.files() == before


@pytest.mark.parametrize("changed", ["create", "listen", "serve"])
def test_change_of_one_undoes_what_comes_after_it(bench: Bench, changed: str) -> None:
    programs = {
        "create": CREATE, "listen": f"{LOAD}{SUBSCRIBE}{END}", "serve": f"{LOAD}{PROVIDE}{END}",
    }  # fmt: skip
    for program, text in programs.items():
        run(bench, program, text)
    first = {
        "create": "create_node 'talker' as t\nt publish hello to 'chat' of message_type String\n"
        "generate_node t\n",
        "listen": f"{LOAD}{SUBSCRIBE.replace('numbers', 'digits')}{END}",
        "serve": f"{LOAD}{PROVIDE.replace('reset', 'start')}{END}",
    }[changed]
    later = list(programs)[list(programs).index(changed) + 1 :]
    told = [
        "changes-undone: `talker_pub.py` is made anew, without the changes of "
        + " and ".join(f"`{each}.plastron`" for each in later)
    ]
    assert run(bench, changed, first) == ["changed", *(told if later else [])]
    programs[changed] = first
    for program in later:
        assert run(bench, program, programs[program]) == ["changed"]
    fresh = Bench(bench.path / "fresh", bench.library)
    for program, text in programs.items():
        run(fresh, program, text)
    assert (fresh.path / FILE).read_bytes() == (bench.path / FILE).read_bytes()
    for program, text in programs.items():
        assert run(bench, program, text) == ["identical"]


def test_handwork_over_two_programs(bench: Bench) -> None:
    programs = {"create": CREATE, "listen": f"{LOAD}{SUBSCRIBE}{END}"}
    for program, text in programs.items():
        run(bench, program, text)
    bench.edit(FILE, '"hello"', '"good day"')
    before = bench.files()
    kept = "merged-by-hand: `talker_pub.py`: your changes are kept"
    assert run(bench, "listen", programs["listen"]) == ["identical", kept]
    assert run(bench, "create", CREATE) == ["identical"]
    assert bench.files() == before
    # What the first makes anew would lose what was changed by hand over the second.
    outcome = bench.generate(CREATE.replace("chatter", "chat"), "create.plastron")
    assert outcome.states == ["conflict"]
    (conflict,) = outcome.conflicts
    assert conflict.endswith("was changed by hand, and by `listen.plastron` too")
    assert bench.files() == before
    assert run(bench, "listen", f"{LOAD}{SUBSCRIBE}{PROVIDE}{END}") == ["changed", kept]
    assert names(bench) == ["chatter", "numbers", "reset"]
    assert b'"good day"' in (bench.path / FILE).read_bytes()


def test_handwork_between_two_programs(bench: Bench) -> None:
    run(bench, "create", CREATE)
    bench.edit(FILE, "def main(", "def mine():\n    return 1\n\n\ndef main(")
    run(bench, "listen", f"{LOAD}{SUBSCRIBE}{END}")
    before = bench.files()
    for program, text in (("create", CREATE), ("listen", f"{LOAD}{SUBSCRIBE}{END}")):
        assert run(bench, program, text)[0] == "identical"
        assert bench.files() == before
    more = "t publish five to 'more' of message_type Int32\ngenerate_node t\n"
    told = run(bench, "create", CREATE.replace("generate_node t\n", more))
    assert told[0] == "changed"
    assert [each.split(":")[0] for each in told[1:]] == ["merged-by-hand", "changes-undone"]
    assert names(bench) == ["chatter", "more"]
    assert run(bench, "listen", f"{LOAD}{SUBSCRIBE}{END}") == ["changed"]
    assert names(bench) == ["chatter", "more", "numbers"]
    assert b"def mine" in (bench.path / FILE).read_bytes()


def test_forced_it_is_made_anew_and_a_backup_kept(bench: Bench) -> None:
    programs = {"create": CREATE, "listen": f"{LOAD}{SUBSCRIBE}{END}"}
    run(bench, "create", CREATE)
    created = (bench.path / FILE).read_bytes()
    run(bench, "listen", programs["listen"])
    bench.edit(FILE, '"hello"', '"good day"')
    mine = (bench.path / FILE).read_bytes()
    assert bench.generate(CREATE, "create.plastron", force=True).errors == []
    assert (bench.path / FILE).read_bytes() == created
    assert (bench.path / f"{FILE}.bak").read_bytes() == mine
    assert run(bench, "listen", programs["listen"]) == ["changed"]


def test_two_programs_that_write_one_file_from_two_originals(bench: Bench) -> None:
    for folder in ("a", "b"):
        bench.put(f"{folder}/robot.py")
    programs = {each: f"load '{each}/robot.py' as n\n{SUBSCRIBE}{END}" for each in "ab"}
    bench.edit("b/robot.py", "somebody", "somebody else")
    assert run(bench, "a", programs["a"]) == ["create"]
    before = bench.files()
    (conflict,) = bench.generate(programs["b"], "b.plastron").conflicts
    assert conflict.endswith("was generated by another program, `a.plastron`")
    assert bench.files() == before
    create = "create_node 'robot' as n\nn publish hello to 'x' of message_type String\n"
    created = f"{create}{SUBSCRIBE}{END}"
    bench.put("c/robot_node.py")
    run(bench, "c", f"load 'c/robot_node.py' as n\n{SUBSCRIBE}{END}")
    (conflict,) = bench.generate(created, "create.plastron").conflicts
    assert conflict.endswith("was generated by another program, `c.plastron`")


def test_two_programs_change_one_file_in_place(bench: Bench) -> None:
    bench.put("nodes/robot.py")
    load = "load 'nodes/robot.py' as n\n"
    programs = {
        "one": f"{load}{SUBSCRIBE}{END}",
        "two": f"{load}unsubscribe n from 'numbers'\n{END}",
    }

    def in_place(program: str) -> list[str]:
        return bench.generate(programs[program], f"{program}.plastron", in_place=True).states

    assert [in_place(each) for each in ("one", "two")] == [["changed"], ["changed"]]
    before = bench.files()
    for each in ("two", "one", "two"):
        assert in_place(each) == ["identical"]
        assert bench.files() == before


def test_renamed_program_is_known_by_its_text(bench: Bench) -> None:
    bench.put("robot.py")
    program = f"load robot as n\nn publish hello to 'chatter' of message_type String\n{END}"
    old = bench.path / "old.plastron"
    old.write_text(program)
    run(bench, "old", program)
    before = (bench.path / "output/robot.py").read_bytes()
    # A program of the same text beside it is another, which starts from what the first wrote.
    assert run(bench, "copy", program) == ["changed"]
    old.unlink()
    bench.put("output/robot.py", before.decode())
    assert run(bench, "new", program) == ["identical"]
    more = program.replace(END, f"{SUBSCRIBE}{END}")
    assert run(bench, "new", more) == ["changed"]
    assert run(bench, "new", program) == ["changed"]
    assert (bench.path / "output/robot.py").read_bytes() == before


def test_output_of_an_unknown_program_that_hides_a_file(bench: Bench) -> None:
    bench.put("robot.py")
    text = f"load robot as n\n{SUBSCRIBE}{END}"
    run(bench, "one", text)
    assert bench.session(text, "one.plastron").diagnostics == ()
    (bench.path / "output/.plastron.json").unlink()
    text = f"load robot as n\nn publish hello to 'chatter' of message_type String\n{END}"
    (found,) = bench.session(text, "one.plastron").diagnostics
    hidden = bench.path / "robot.py"
    assert (found.code, found.severity.value) == ("hidden-file", "warning")
    assert found.message == f"`robot.py` is the one of the output folder, and hides `{hidden}`"


def mark(bench: Bench) -> None:
    """Change the file by hand."""
    bench.edit(FILE, "def main(", "# mine\ndef main(")


def test_handwork_over_the_first_of_two_is_kept(bench: Bench) -> None:
    """The second has nothing of its own on top, but what it found was changed by hand."""
    run(bench, "create", CREATE)
    run(bench, "listen", f"{LOAD}{SUBSCRIBE}{END}")
    mark(bench)
    run(bench, "serve", f"{LOAD}{PROVIDE}{END}")
    before = bench.files()
    for program, text in (
        ("create", CREATE.replace("chatter", "chat")),
        ("listen", f"{LOAD}{SUBSCRIBE.replace('numbers', 'digits')}{END}"),
    ):
        states = bench.generate(text, f"{program}.plastron").states
        if program == "create":
            assert states == ["conflict"]
            assert bench.files() == before
    assert b"# mine" in (bench.path / FILE).read_bytes()


@pytest.mark.parametrize("marked", [1, 2, 3])
@pytest.mark.parametrize("forced", ["create", "listen"])
def test_forced_a_backup_is_kept_of_handwork_between_programs(
    bench: Bench, marked: int, forced: str
) -> None:
    programs = {
        "create": CREATE, "listen": f"{LOAD}{SUBSCRIBE}{END}", "serve": f"{LOAD}{PROVIDE}{END}",
    }  # fmt: skip
    for number, (program, text) in enumerate(programs.items(), 1):
        run(bench, program, text)
        if number == marked:
            mark(bench)
    mine = (bench.path / FILE).read_bytes()
    text = programs[forced].replace("chatter", "chat").replace("numbers", "digits")
    assert bench.generate(text, f"{forced}.plastron", force=True).errors == []
    now = (bench.path / FILE).read_bytes()
    assert b"# mine" in now or (bench.path / f"{FILE}.bak").read_bytes() == mine


@pytest.mark.parametrize("creating", ["one", "two"])
def test_hand_written_file_that_a_program_loaded_is_not_written_over(
    bench: Bench, creating: str
) -> None:
    bench.put(FILE)
    run(bench, "one", f"{LOAD}{SUBSCRIBE}{END}")
    before = bench.files()
    outcome = bench.generate(CREATE, f"{creating}.plastron")
    assert [each.split(" and ")[-1] for each in outcome.conflicts] == [
        "was not written by plastron"
    ]
    assert bench.files() == before
    bench.generate(CREATE, f"{creating}.plastron", force=True)
    assert (bench.path / f"{FILE}.bak").read_bytes() == before[FILE]
    assert bench.generate(CREATE, f"{creating}.plastron").states == ["identical"]
