"""Types of a modest size that something grows from."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest
from limited import Attacker, make_project
from machine import mostly_long

Make = Callable[[Path], object]


def _types(fields: Callable[[int], str], count: int) -> Make:
    """Return what writes types `T0`, `T1`, …, each with the fields of its number."""

    def make(folder: Path) -> None:
        for number in range(count):
            (folder / "msg" / f"T{number}.msg").write_text(fields(number))

    return make


def _doubled(last: str) -> Make:
    fields = _types(lambda n: f"T{n + 1} a\nT{n + 1} b\n", 31)

    def make(folder: Path) -> None:
        fields(folder)
        (folder / "msg/T31.msg").write_text(last)

    return make


def _message(text: str) -> Make:
    return lambda folder: (folder / "msg/T0.msg").write_text(text)


def _both(*makes: Make) -> Make:
    return lambda folder: [make(folder) for make in makes]


def _program(text: str) -> Make:
    return lambda folder: (folder / "p.plastron").write_text(text)


def _file(name: str, text: str | bytes) -> Make:
    data = text.encode() if isinstance(text, str) else text

    def make(folder: Path) -> None:
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(data)

    return make


def _sent(values: str) -> str:
    """Return a program that sends a message of type `T0`."""
    return f"""\
create_node 'n' as n
create_message m of message_type T0 and input {values}
n publish m to 'c' of message_type T0 at 2 hz
generate_node n
"""


TYPES: dict[str, Make] = {
    "doubled": _both(_doubled("int32 x\n"), _program(_sent("1, 2"))),
    "doubled, empty": _both(_doubled(""), _program(_sent("1, 2"))),
    "doubled, named": _both(_doubled("int32 x\n"), _program(_sent("q_x=1"))),
    "doubled, far": _both(_doubled("int32 x\n"), _program(_sent(f"{'a.' * 31}x=1"))),
    "in itself": _both(_types(lambda n: f"T{n} a\n", 1), _program(_sent("1"))),
    "in turns": _both(_types(lambda n: f"T{(n + 1) % 9} a\nT0 b\n", 9), _program(_sent("1"))),
    "deep": _both(_types(lambda n: f"T{n + 1} a\n", 3000), _program(_sent("1, 2"))),
    "many fields": _both(
        _message("".join(f"int8 f{n}\n" for n in range(80_000))), _program(_sent("1, 2"))
    ),
    "many fields, named": _both(
        _message("".join(f"int8 f{n}\n" for n in range(80_000))), _program(_sent("g=2"))
    ),
    "many constants": _both(
        _message("".join(f"int8 F{n}=1\n" for n in range(80_000))), _program(_sent("1, 2"))
    ),
    "huge array": _both(_message("uint8[999999999] data\nint32 x\n"), _program(_sent("x=1"))),
    "long name": _both(_message(f"int32 {'x' * 900_000}\n"), _program(_sent("1, 2"))),
    "almost a name": _both(_message(f"int32 {'x' * 900_000}X\n"), _program(_sent("1, 2"))),
    "almost a constant": _both(_message(f"int32 {'X' * 900_000}x=1\n"), _program(_sent("1, 2"))),
    "long type name": _both(_message(f"{'X' * 900_000} x\n"), _program(_sent("1"))),
    "wrong lines": _both(_message("?\n" * 400_000), _program(_sent("1"))),
    "quotes": _both(_message("string x " + "'#" * 400_000), _program(_sent("1"))),
    "quotes, opened": _both(_message('string[] x ["' + ",'\" " * 200_000), _program(_sent("1"))),
    "long comment": _both(
        _message("# e.g. x\n" * 100_000 + "int32 x  # " + "e.g. " * 1000), _program(_sent("1"))
    ),
    "brackets": _both(_message("int32[" * 150_000), _program(_sent("1"))),
    "numbers": _both(_message("int32 x " + "9" * 900_000), _program(_sent("1"))),
    "many files": _both(_types(lambda n: "int32 x\n", 20_000), _program(_sent("'x'"))),
    "manifest of comments": _both(_file("package.xml", "<!--" * 25_000), _program(_sent("1"))),
    "manifest of names": _both(_file("package.xml", "<name>" + " " * 90_000), _program(_sent("1"))),
}

_QUICK = {"doubled", "doubled, empty", "quotes"}


@pytest.mark.parametrize("name", mostly_long(TYPES, _QUICK))
def test_a_type_ends_with_a_diagnostic(attacker: Attacker, tmp_path: Path, name: str) -> None:
    folder = tmp_path / "project"
    make_project(folder)
    (folder / "plastron.yaml").write_text("target: rclpy\n")
    TYPES[name](folder)
    for command in (
        "check p.plastron",
        "check --format json p.plastron",
        "generate p.plastron",
        "types pkg/T0",
    ):
        attacker.run(folder, *command.split()).check()
