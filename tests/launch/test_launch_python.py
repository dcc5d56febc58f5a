"""Launch files in Python: what is written is read again, and literals of others are read."""

from __future__ import annotations

import ast
from pathlib import Path

import pytest
from ament_linters import findings
from hypothesis import HealthCheck, Phase, given, settings
from launch_files import launch_files
from machine import examples

from plastron_tui.ros.launch import Group, Include, LaunchFile, ParameterValue, StartedNode, Unread
from plastron_tui.sources.launch.python_reader import read_launch_python
from plastron_tui.targets.launch.python import write_python

written_often = settings(
    max_examples=examples(60),
    deadline=None,
    suppress_health_check=list(HealthCheck),
    phases=(Phase.explicit, Phase.reuse, Phase.generate),
)


@written_often
@given(launch=launch_files(2))
def test_what_is_written_is_read_again(launch: LaunchFile) -> None:
    written = write_python(launch)
    ast.parse(written)
    read = read_launch_python(written.encode())
    assert read.diagnostics == ()
    assert read.launch == launch, written


@pytest.mark.long
def test_what_is_written_is_clean(tmp_path: Path) -> None:
    made: list[Path] = []

    @written_often
    @given(launch_files(2))
    def make(launch: LaunchFile) -> None:
        made.append(tmp_path / f"made_{len(made)}.launch.py")
        made[-1].write_text(write_python(launch), encoding="utf-8")

    make()
    assert findings(tmp_path) == []


def _read(body: str) -> list[str]:
    """Return what a function reads as: nodes by their executables, and what is not understood."""
    lines = "".join(f"    {line}\n" for line in body.splitlines())
    source = f"import os\ndef generate_launch_description():\n{lines}"
    ast.parse(source)
    launch = read_launch_python(source.encode()).launch
    assert launch is not None
    found = []
    for item in launch.items:
        if isinstance(item, StartedNode):
            values = (f"{x.name}={x.value}" for x in item.parameters
                      if isinstance(x, ParameterValue))  # fmt: skip
            found.append(" ".join((str(item.executable), *values)))
        elif isinstance(item, Include):
            arguments = (f"{name}={value}" for name, value in item.arguments)
            found.append(" ".join((str(item.file), *arguments)))
        elif isinstance(item, Group):
            assert item.condition is not None
            found.append(f"if {item.condition.value}")
        else:
            assert isinstance(item, Unread)
            found.append(f"? {item.what}")
    return found


A, B = "Node(package='p', executable='a')", "Node(package='p', executable='b')"
C = "Node(package='p', executable=f'{x}_1')"
RETURN = "return LaunchDescription(nodes)"
INCLUDE = (
    "return LaunchDescription([IncludeLaunchDescription('x', launch_arguments=given.items())])"
)


@pytest.mark.parametrize(
    ("body", "expected"),
    [
        (f"nodes = [{A}]\nnodes.append({B})\n{RETURN}", ["a", "b"]),
        (f"nodes = []\nnodes.extend([{A}, {B}])\n{RETURN}", ["a", "b"]),
        (f"nodes = [{A}]\nnodes += [{B}]\n{RETURN}", ["a", "b"]),
        (f"nodes = [{A}]\nnodes.insert(0, {B})\n{RETURN}", ["b", "a"]),
        (f"nodes = [{A}]\nmore = nodes\nmore.append({B})\n{RETURN}", ["a", "b"]),
        (f"nodes = [{A}]\nkept = nodes + []\nkept.append({B})\n{RETURN}", ["a"]),
        (f"inner = [{A}]\nnodes = [*inner, {B}]\n{RETURN}", ["a", "b"]),
        (f"nodes = other = [{A}]\nother.append({B})\n{RETURN}", ["a", "b"]),
        (f"nodes: list = [{A}]\n{RETURN}", ["a"]),
        (f"nodes, word = [{A}], 1\n{RETURN}", ["? `nodes`"]),
        (f"nodes = [{A}]\nnodes.extend(more())\n{RETURN}", ["a", "? `more`"]),
        (f"nodes = [{A}]\nnodes += more()\n{RETURN}", ["a", "? `more`"]),
        (f"nodes = [{A}, {B}]\nnodes.pop()\n{RETURN}", ["? `nodes`"]),
        (f"nodes = [{A}, {B}]\ndel nodes[0]\n{RETURN}", ["? `nodes`"]),
        (f"nodes = [{A}, {B}]\nnodes[0] = {B}\n{RETURN}", ["? `nodes`"]),
        (f"nodes = [{A}]\nnodes[1:] = [{B}]\n{RETURN}", ["? `nodes`"]),
        (f"nodes = [{A}]\nprint(nodes)\n{RETURN}", ["a"]),
        (f"nodes = [{A}]\nfill(nodes)\n{RETURN}", ["a", "? what `fill` adds"]),
        (f"nodes = [{A}]\nif os:\n    nodes.append({B})\n{RETURN}",
         ["a", "if $(os)"]),
        (f"nodes = [{A}]\nfor x in 'ab':\n    nodes += [{B}]\n{RETURN}",
         ["a", "? what a `for` adds"]),
        (f"nodes = [{A} for _ in range(2)]\n{RETURN}", ["a", "a"]),
        (f"nodes = [{A} for x in os]\n{RETURN}",
         ["? `[Node(package='p', executable='a') for x…`"]),
        (f"nodes = [{A} for x in ('a', 'b') if x]\n{RETURN}",
         ["? `[Node(package='p', executable='a') for x…`"]),
        (f"names = ['l', 'r']\nnodes = [{C} for n, x in zip(names, names)]\n{RETURN}",
         ["? `[Node(package='p', executable=f'{x}_1') …`"]),
        (f"names = ['l', 'r']\nnodes = [{C} for x in names]\n{RETURN}", ["l_1", "r_1"]),
        (f"nodes = [{C} for n, x in [(1, 'l'), (2, 'r')]]\n{RETURN}", ["l_1", "r_1"]),
        (f"names = ['l', 'r']\nnodes = []\nfor x in names:\n    nodes.append({C})\n{RETURN}",
         ["l_1", "r_1"]),
        (f"nodes = []\nfor x in ['l', 'r']:\n    y = x\n    if y:\n        break\n"
         f"    nodes += [{C}]\n{RETURN}", ["? what a `for` adds"]),
        (f"nodes = []\nfor x in ():\n    nodes += [{C}]\n{RETURN}", []),
        (f"x = 'l'\nnodes = [{C}]\n{RETURN}", ["l_1"]),
        (f"x = os.name\nnodes = [{C}]\n{RETURN}", ["$(f'{x}_1')"]),
        (f"nodes = []\nfor x in range(2000):\n    nodes.append({A})\n{RETURN}",
         ["? what a `for` adds"]),
        (f"nodes = [{A}]\nif nodes.count(1):\n    print(1)\n{RETURN}", ["a"]),
        (f"ld = LaunchDescription()\nld.add_action({A})\nld.add_action(action={B})\nreturn ld",
         ["a", "b"]),
        (f"ld = LaunchDescription()\nsame = ld\nsame.add_action({A})\nreturn ld", ["a"]),
        (f"ld = LaunchDescription([{A}])\nfill(ld)\nreturn ld", ["a", "? what `fill` adds"]),
        (f"ld = LaunchDescription([{A}])\nld.entities.append({B})\nreturn ld",
         ["a", "? `ld.entities`", "? a description that is computed"]),
        ("given = {'rate': '1'}\ngiven['rate'] = '5'\n" + INCLUDE, ["x rate=5"]),
        ("given = {}\ngiven.update({'rate': '5'})\n" + INCLUDE, ["x rate=5"]),
        ("given = {'rate': '1'}\ngiven.update(rate='5')\n" + INCLUDE,
         ["? `IncludeLaunchDescription`"]),
        ("given = {'rate': '1'}\ngiven[word()] = '5'\n" + INCLUDE,
         ["? `IncludeLaunchDescription`"]),
        ("given = {'rate': '1'}\nfor k, v in given.items():\n    print(k)\n" + INCLUDE,
         ["x rate=1"]),
        ("given = {'rate': '1'}\nif os:\n    given['rate'] = '2'\n" + INCLUDE,
         ["? `IncludeLaunchDescription`"]),
        (f"with open('f') as f:\n    return LaunchDescription([{A}])", ["a"]),
        (f"with open('f') as f:\n    nodes = [{A}]\n{RETURN}", ["a"]),
        (f"try:\n    nodes = [{A}]\nexcept OSError:\n    pass\n{RETURN}", ["a"]),
        (f"try:\n    nodes = [{A}]\nexcept OSError:\n    nodes = []\n{RETURN}",
         ["? `nodes`"]),
        (f"try:\n    pass\nexcept OSError:\n    return 1\nelse:\n    nodes = [{A}]\n{RETURN}",
         ["? what an `except` returns", "a"]),
        (f"try:\n    pass\nfinally:\n    nodes = [{A}]\n{RETURN}", ["a"]),
        (f"if os:\n    return LaunchDescription([{A}])\nreturn LaunchDescription([{B}])",
         ["if $(os)", "? what an `if` returns", "b"]),
        (f"return LaunchDescription([{A}])\nreturn LaunchDescription([{B}])", ["a"]),
        ("return LaunchDescription([Node(executable=','.join(['a', 'b']))])", ["a,b"]),
        ("return LaunchDescription([Node(executable=os.path.join('a', 'b'))])", ["a/b"]),
        ("s = '-'\nreturn LaunchDescription([Node(executable=s.join(('a', 'b')))])", ["a-b"]),
        ("return LaunchDescription([Node(executable=other.join('a', 'b'))])",
         ["$(other.join('a', 'b'))"]),
        ("x = word()\nreturn LaunchDescription([Node(executable=x, parameters=[{'a': x}])])",
         ["$(word) a=$(word)"]),
        ("nodes = []\nnodes.append(nodes)\nnodes.append(nodes)\n" + RETURN, []),
    ],
)  # fmt: skip
def test_statements_are_followed_or_told(body: str, expected: list[str]) -> None:
    assert _read(body) == expected


def test_lone_carriage_returns_end_lines() -> None:
    lines = ["def generate_launch_description():", "    # Starts nothing.",
             "    return LaunchDescription([Node(package='a', executable='b')])", ""]  # fmt: skip
    for end in ("\n", "\r\n", "\r"):
        read = read_launch_python(end.join(lines).encode())
        assert read.launch is not None
        assert [type(each) for each in read.launch.items] == [StartedNode]
