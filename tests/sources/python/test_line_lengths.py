"""Lines that an edit writes: as long as the file's linter allows, broken as the file breaks its."""

from __future__ import annotations

from pathlib import Path

import pytest
from edits import AT, CATALOGS, DIALECTS, SUB, edited, subscribe
from file_sets import one

from plastron_tui.model.kinds import Subscription
from plastron_tui.model.source import Rename, Update
from plastron_tui.ros.interfaces import InterfaceName
from plastron_tui.sources.python import edit_python, read_python
from plastron_tui.sources.python.line_length import find_line_length, said_line_length
from plastron_tui.sources.python.line_limit import LineLimit, line_limit
from plastron_tui.sources.python.syntax import parse
from plastron_tui.sources.python.wrapping import wrap_new_lines

NODE = """\
from rclpy.node import Node
from std_msgs.msg import String


class A(Node):
    def __init__(self):
        super().__init__('a')
{}
    def on_text(self, message):
        pass
"""
LONG = "a_topic_of_long_name"

HABITS = {
    "one line within brackets": (
        "        self.sub = self.create_subscription(\n"
        "            String, 't', self.on_text, 10\n        )\n",
        "(\n            String, '{}', self.on_text, 10\n        )\n",
    ),
    "a closing bracket behind the last": (
        "        self.sub = self.create_subscription(\n"
        "            String, 't', self.on_text, 10)\n",
        "(\n            String, '{}', self.on_text, 10)\n",
    ),
    "two deeper": (
        "        self.sub = self.create_subscription(\n          String, 't', self.on_text, 10)\n",
        "(\n          String, '{}', self.on_text, 10)\n",
    ),
    "eight deeper": (
        "        self.sub = self.create_subscription(\n"
        "                String, 't', self.on_text, 10)\n",
        "(\n                String, '{}', self.on_text, 10)\n",
    ),
    "a line each": (
        "        self.sub = self.create_subscription(\n            String,\n"
        "            't',\n            self.on_text,\n            10\n        )\n",
        "(\n            String,\n            '{}',\n"
        "            self.on_text,\n            10\n        )\n",
    ),
    "a line each and a comma": (
        "        self.sub = self.create_subscription(\n            String,\n"
        "            't',\n            self.on_text,\n            10,\n        )\n",
        "(\n            String,\n            '{}',\n"
        "            self.on_text,\n            10,\n        )\n",
    ),
    "below the first": (
        "        self.sub = self.create_subscription(String, 't', self.on_text,\n"
        "                                            10)\n",
        "(String, '{}',\n{margin}self.on_text, 10)\n",
    ),
    "no habit": (
        "        self.sub = self.create_subscription(String, 't', self.on_text, 10)\n",
        "(\n            String, '{}', self.on_text, 10\n        )\n",
    ),
}


@pytest.mark.parametrize("habit", HABITS)
def test_a_long_call_is_broken_as_the_others_are(habit):
    before, after = HABITS[habit]
    text = edited(NODE.format(before), subscribe(LONG, callback="on_text"))
    call = f"        self.{LONG}_sub = self.create_subscription"
    assert f"{call}{after.format(LONG, margin=' ' * (len(call) + 1))}" in text


def edit_within(limit: int, text: str, *changes):
    source = read_python(Path("node.py"), one(text.encode())).source
    target = CATALOGS["rclpy"], DIALECTS["rclpy"]
    return edit_python(source, changes, *target, limit).files.main.decode()


@pytest.mark.parametrize("limit", [60, 79, 99, 120])
def test_no_new_line_is_longer_than_it_may_be(limit):
    text = edit_within(limit, NODE.format(""), subscribe("text", callback="on_text"))
    assert max(map(len, text.splitlines())) <= limit
    whole = "self.text_sub = self.create_subscription(String, 'text', self.on_text, 10)"
    assert (whole in text) == (len(whole) + 8 <= limit)


def test_a_replaced_argument_goes_on_a_line_of_its_own():
    calls = (
        "        self.s = self.create_subscription(String, 't',\n"
        + " " * 42
        + "self.on_text, 10)\n"
    )
    endpoint = Subscription("t" * 30, InterfaceName("std_msgs", "String"), None, AT)
    text = edit_within(79, NODE.format(calls), Update(SUB, "t", endpoint))
    margin = " " * 42
    assert f"(String,\n{margin}'{'t' * 30}',\n{margin}self.on_text, 10)\n" in text


OF_ROS_2 = NODE.format("        self.create_subscription(String, 't', self.on_text, 10)\n")
OF_ROS_1 = "import rospy\nfrom std_msgs.msg import String\nrospy.Subscriber('t', String, print)\n"


@pytest.mark.parametrize(("text", "is_broken"), [(OF_ROS_2, True), (OF_ROS_1, False)])
def test_a_longer_name_breaks_a_line_where_a_linter_is_known_to_ask(text, is_broken):
    found = edited(text, Rename(SUB, "t", "t" * 60, AT))
    assert ("(\n" in found) == is_broken


def test_a_line_that_was_too_long_stays_one():
    line = "sub = node.create_subscription(String, {}, callback_with_a_long_name, queue_of_ten)\n"
    before, after = (line.format(f"'{name}'").encode() for name in ("text", "texts"))
    assert wrap_new_lines(before, parse(after), LineLimit(60)) == after
    assert wrap_new_lines(b"", parse(after), LineLimit(60)) != after


TEXTS = ["s = '''\n{}(a, b)\n'''\n", "# {}(a, b)\n", "x = '{}'\n"]


@pytest.mark.parametrize("text", TEXTS)
def test_what_is_no_code_is_not_broken(text):
    after = text.format("word" * 20).encode()
    assert wrap_new_lines(b"", parse(after), LineLimit(60)) == after


LISTS = ["lambda a, b: a", "c for b, c in d", "*a"]


@pytest.mark.parametrize("item", LISTS)
def test_a_comma_of_an_item_parts_nothing(item):
    after = f"function({'x' * 40}, [{item}])\n".encode()
    assert wrap_new_lines(b"", parse(after), LineLimit(30)) == (
        f"function(\n    {'x' * 40},\n    [{item}],\n)\n".encode()
    )


def test_a_long_import_is_broken():
    names = ", ".join(f"Name{number}" for number in range(8))
    after = f"from package.msg import {names}\n".encode()
    broken = wrap_new_lines(b"", parse(after), LineLimit(70))
    assert broken == f"from package.msg import (\n    {names}\n)\n".encode()


def test_a_long_line_of_an_import_is_broken():
    after = "from package.msg import (One, Two, Three, Four,\n                         Five)\n"
    broken = after.replace(" Four,", "\n" + " " * 25 + "Four,")
    assert wrap_new_lines(b"", parse(after.encode()), LineLimit(45)).decode() == broken


SETTINGS = {
    ".flake8": ("[flake8]\nmax-line-length = 87\n", 87),
    "setup.cfg": ("[develop]\nline-length = 1\n[flake8]\nmax_line_length=88 # wide\n", 88),
    "tox.ini": ("[tox]\nenvlist = x\n[pycodestyle]\nmax-line-length: 100\n", 100),
    "pyproject.toml": ("[tool.black]\nline-length = 90\n[tool.ruff]\nline-length = 91\n", 91),
    "ruff.toml": ("line-length = 120\n[lint.pycodestyle]\nmax-line-length = 110\n", 110),
    "ament_flake8.ini": ("[flake8]\nignore = E1\nmax-line-length = 101\n", 101),
    ".pylintrc": ("[FORMAT]\n# usual\nmax-line-length=95\n", 95),
}


@pytest.mark.parametrize("name", SETTINGS)
def test_settings_say_the_length(name, tmp_path):
    text, length = SETTINGS[name]
    assert said_line_length(text, name) == length
    package = tmp_path / "package"
    folder = package / "scripts"
    folder.mkdir(parents=True)
    (package / "package.xml").touch()
    (tmp_path / name).write_text(text)
    assert find_line_length(folder / "node.py") == length, "in no repository"
    (package / ".git").mkdir()
    assert find_line_length(folder / "node.py") is None, "above the repository"
    (tmp_path / ".git").mkdir()
    assert find_line_length(folder / "node.py") == length
    (folder / ".flake8").write_text("[flake8]\nmax-line-length = 70\n")
    assert find_line_length(folder / "node.py") == 70


@pytest.mark.parametrize(
    ("text", "length"),
    [
        ("[tool.black]\nskip-string-normalization = true\n", 88),
        ("[tool.pylint.'FORMAT']\nmax-line-length = 100\n", 100),
        ("[tool.black]\n[tool.ruff]\nline-length = 99\n", 99),
        ("[tool.isort]\nline_length = 70\n", None),
    ],
)
def test_a_table_says_the_length(text, length):
    assert said_line_length(text, "pyproject.toml") == length


def test_settings_that_cannot_be_read_say_nothing(tmp_path):
    (tmp_path / "setup.cfg").mkdir()
    (tmp_path / "tox.ini").write_bytes(b"\xff\x00[flake8\nmax-line-length = 9\n")
    (tmp_path / "pyproject.toml").write_text("[tool.ruff]\nline-length = 'wide'\n")
    (tmp_path / ".flake8").write_text("[flake8]\nmax-line-length = 70\n" + " " * 70_000)
    assert find_line_length(tmp_path / "node.py") is None


@pytest.mark.parametrize(("long", "limit"), [(0, 99), (2, 99), (3, 120), (9, 120)])
def test_a_few_lines_do_not_tell_what_a_file_keeps_to(long, limit):
    text = "x = 1\n" * 20 + ("y = " + "1" * 110 + "\n") * long
    assert line_limit(text.encode(), "rclpy", None).length == limit


@pytest.mark.parametrize(
    "line", ["f('{}')\n", "# {}\n", '"' * 3 + "One.\n{}\n" + '"' * 3 + "\n", "x = 1  # {}\n"]
)
def test_prose_does_not_tell_what_a_file_keeps_to(line):
    text = line.format("word " * 30) * 9
    assert line_limit(text.encode(), "rclpy", None).length == 99


def call_of(function: str, length: int) -> str:
    return f"{function}({'a' * (length - 6)}, b)\n"


@pytest.mark.parametrize(
    ("before", "after", "is_broken"),
    [
        ([("f", 110)], ("f", 105), False),
        ([("f", 110)], ("f", 125), True),
        ([("g", 110)], ("f", 105), True),
        ([("f", 79)], ("f", 85), True),
        ([("f", 70)], ("f", 99), True),
    ],
)
def test_a_guess_breaks_no_line_like_others(before, after, is_broken):
    text = "".join(call_of(*each) for each in before)
    limit = line_limit(text.encode(), "rospy", None)
    new = call_of(*after)
    kept = text if len(new) > 90 else ""
    wrapped = wrap_new_lines(text.encode(), parse((kept + new).encode()), limit).decode()
    assert (wrapped != kept + new) == is_broken


def test_what_is_broken_tells_what_a_file_keeps_to():
    call = f"first_name = function_{'x' * 40}(\n    first_argument_of_it, second\n)\n"
    assert 88 < len(call.replace("\n", "")) < 99
    assert line_limit((call * 2).encode(), "rclpy", None).length == 79
    assert line_limit((call * 2 + "#\nx = " + "1" * 80).encode(), "rclpy", None).length == 88
    long = "# " + "word " * 17 + "\n"
    assert line_limit((long + call * 2).encode(), "rclpy", None).length == 79
    assert line_limit(call.encode(), "rclpy", None).length == 99


HEADS = {
    "its own manner": ("def f(\n    a, b\n):\n    pass\n", "(\n    {}, b: int\n):\n"),
    "the calls' manner": ("f(\n    1, 2)\n", "(\n        {}, b: int):\n"),
}


@pytest.mark.parametrize("case", HEADS)
def test_a_long_head_is_broken(case):
    above, expected = HEADS[case]
    after = f"{above}def give_it({'a' * 50}, b: int):\n    pass\n"
    wrapped = wrap_new_lines(above.encode(), parse(after.encode()), LineLimit(70)).decode()
    assert f"def give_it{expected.format('a' * 50)}    pass\n" in wrapped


def test_a_call_is_broken_as_those_of_the_same_name():
    above = "f(\n    1,\n    2,\n    3,\n)\n" + "g(1,\n  2, 3)\n" * 3
    after = f"{above}f({'a' * 60}, 2, 3)\n"
    wrapped = wrap_new_lines(above.encode(), parse(after.encode()), LineLimit(60)).decode()
    assert wrapped == f"{above}f(\n    {'a' * 60},\n    2,\n    3,\n)\n"


def test_a_long_line_that_a_file_has_twice_may_be_as_long_when_one_changes():
    call = "    f('" + "a" * 60 + "', {})\n"
    before, after = call.format("Bool") * 2, call.format("Bool") + call.format("Byte")
    assert wrap_new_lines(before.encode(), parse(after.encode()), LineLimit(60)) == after.encode()


def test_no_tab_stands_behind_spaces():
    above = "if a:\n\tb()\nif c:\n    "
    wrapped = wrap_new_lines(
        above.encode(), parse(f"{above}f_of_a_name('{'a' * 40}', 1)\n".encode()), LineLimit(60)
    ).decode()
    assert wrapped == f"{above}f_of_a_name(\n        '{'a' * 40}', 1\n    )\n"


def test_a_long_name_is_no_prose():
    call = "self.pub = rospy.Publisher('/" + "a" * 60 + "', String, queue_size=10)\n"
    assert line_limit((call * 3).encode(), "rospy", None).length == 120
    said = call.replace("a" * 60, "a " * 30)
    assert line_limit((said * 3).encode(), "rospy", None).length == 79


FILLED = {
    "a docstring": ('def f():\n    """Do this.\n\n    {}\n    {}\n    {}\n    """\n', 79),
    "comments": ("# {}\n# {}\n# {}\n", 79),
    "longer ones": ("# {}\n# {}\n# {}\nx = " + "1" * 90 + "\n", 99),
}


@pytest.mark.parametrize("name", FILLED)
def test_filled_prose_tells_what_a_file_keeps_to(name):
    text, limit = FILLED[name]
    words = text.format(*["afterwards " * 6 + "and"] * 2, "afterwards")
    assert line_limit(f"import rclpy\n{words}".encode(), "rclpy", None).length == limit
    # A licence, which stands above, is filled as its author did.
    assert line_limit(f"{words}import rclpy\n".encode(), "rclpy", None).length == 99
