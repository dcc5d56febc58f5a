"""Programs that something grows from."""

from __future__ import annotations

from pathlib import Path

import pytest
from limited import Attacker, make_project
from machine import mostly_long

_STRING = "of message_type String"
_MESSAGE = f"create_message m {_STRING} and input "


def _repeated(count: int, text: str) -> str:
    """Return a text so many times; each `#` is the number of the time."""
    return "".join(text.replace("#", str(number)) for number in range(count))


def _node(text: str) -> str:
    return f"create_node 'n' as n\n{text}generate_node n\n"


def _subscribed(topic: str) -> str:
    return f"subscribe n to '{topic}' {_STRING}\n"


PROGRAMS: dict[str, str] = {
    "parentheses": _MESSAGE + "(" * 100_000,
    "nested": _MESSAGE + "(" * 20_000 + "1" + ")" * 20_000,
    "lists": _MESSAGE + "[" * 20_000 + "1" + "]" * 20_000,
    "long name": f"create_node '{'x' * 200_000}' as n\ngenerate_node n\n",
    "long variable": f"create_node 'x' as {'n' * 200_000}\ngenerate_node {'n' * 200_000}\n",
    "unknown variable": f"generate_node {'n' * 200_000}\n",
    "long type": f"create_message m of message_type {'S' * 200_000} and input 1\n",
    "long package": f"create_message m of message_type {'s' * 200_000}/S and input 1\n",
    "long text": f'create_message m of message_type Int32 and input "{"x" * 200_000}"\n',
    "long number": f"create_message m of message_type Int32 and input {'9' * 200_000}\n",
    "long field": f"create_message m of message_type Int32 and input {'x' * 200_000}=1\n",
    "long path": f"load '{'x/' * 100_000}y.py' as n\n",
    "long load": f"load {'x' * 200_000} as n\n",
    "long topic": _node(_subscribed("t" * 200_000)),
    "bad topic": _node(_subscribed("t!" * 100_000)),
    "long words": "x " * 100_000,
    "long garbage": "?" * 200_000,
    "many nodes": _repeated(20_000, "create_node 'n#' as n#\n") + "generate_node m\n",
    "chains": "load known as k0\n"
    + "".join(
        f"subscribe k{n} to 'c{n}' {_STRING}\ngenerate_node k{n}\nload known as k{n + 1}\n"
        for n in range(1_000)
    ),
    "loads": _repeated(300, f"load known as k#\nsubscribe k# to 'c#' {_STRING}\n"),
    "two types": "load known as n\n"
    + _repeated(1_000, _subscribed("c#") + _subscribed("d#").replace("String", "Int32"))
    + "generate_node n\n",
    "subscriptions": _node(_repeated(5_000, _subscribed("c#"))),
    "of a loaded": f"load known as n\n{_repeated(2_000, _subscribed('c#'))}generate_node n\n",
    "same node": "create_node 'n' as n\n" * 20_000,
    "wrong statements": "subscribe\n" * 20_000,
    "conflicts": _node((_subscribed("c") + _subscribed("c").replace("String", "Int32")) * 3_000),
}

# JSON says all that the text does, which `generate` shows: the many are spared doing it twice.
_OF_ALL = ("check --format json", "generate", "fmt --check", "graph")
_OF_SOME = ("check", *_OF_ALL)

_QUICK = {"nested", "long type", "long load"}


@pytest.mark.parametrize("name", mostly_long(PROGRAMS, _QUICK))
def test_a_program_ends_with_a_diagnostic(attacker: Attacker, tmp_path: Path, name: str) -> None:
    folder = tmp_path / "project"
    make_project(folder)
    (folder / "p.plastron").write_text(PROGRAMS[name])
    for command in _OF_SOME if name in _QUICK else _OF_ALL:
        attacker.run(folder, *command.split(), "p.plastron").check()
