"""What is read of a setup.py whose generation of ROS decides, and of what it computes."""

from __future__ import annotations

from pathlib import Path

import pytest

from plastron_tui.sources.setup_py.reader import read_setup

_VERSION = "import os\nV = int(os.environ['ROS_VERSION'])\n"
_FIRST = """\
    from distutils.core import setup
    from catkin_pkg.python_setup import generate_distutils_setup
    NAME = 'first'
    d = generate_distutils_setup(packages=[NAME], package_dir={'': 'src'})
    setup(**d)
"""
_SECOND = """\
    from setuptools import setup
    NAME = 'second'
    setup(name=NAME, packages=[NAME], entry_points={'console_scripts': ['a = %s.a:main' % NAME]})
"""
_BOTH = {
    "elif": f"{_VERSION}if V == 1:\n{_FIRST}elif V == 2:\n{_SECOND}",
    "else": f"{_VERSION}if V == 1:\n{_FIRST}else:\n{_SECOND}",
    "the other way round": f"{_VERSION}if V != 1:\n{_SECOND}else:\n{_FIRST}",
    "two statements": f"{_VERSION}if V == 1:\n{_FIRST}if V == 2:\n{_SECOND}",
    "asked within": "import os\nif os.getenv('ROS_VERSION', '2') == '1':\n"
    f"{_FIRST}else:\n{_SECOND}",
}


@pytest.mark.parametrize("text", _BOTH.values(), ids=_BOTH)
def test_version_of_ros_chooses_the_call(text: str) -> None:
    """Each generation gets the call of its branch, with the names that are bound there."""
    first, second = (read_setup(text.encode(), Path("setup.py"), each).setup for each in (1, 2))
    assert first is not None and second is not None
    assert (first.is_catkin, first.packages, first.console_scripts) == (True, ("first",), ())
    assert (second.is_catkin, second.packages, second.computed) == (False, ("second",), ())
    assert [each.target for each in second.console_scripts] == ["second.a:main"]


_SCRIPTS = "setup(name='demo', entry_points={'console_scripts': [%s]})\n"
_PLAIN = _SCRIPTS % "'a = b:main'"
_FORMATTED = "'a = {}:main'.format(%s)"
_OPEN = {
    "a condition of something else": f"if is_new():\n    {_PLAIN}",
    "a version that is bound twice": f"{_VERSION}V = 3\nif V == 2:\n    {_PLAIN}",
    "behind a condition": f"if is_new():\n    pass\nelif True:\n    {_PLAIN}",
    "a name of a branch": f"if is_new():\n    N = 'b'\n{_SCRIPTS % (_FORMATTED % 'N')}",
    "a format of a number": _SCRIPTS % "'a = b{:04}:main'.format('1')",
    "too few": _SCRIPTS % "'a = {}{}:main'.format('b')",
}


@pytest.mark.parametrize("text", _OPEN.values(), ids=_OPEN)
def test_what_is_not_sure_is_computed(text: str) -> None:
    """Where the console scripts hang on something, they are said to be not all known."""
    setup = read_setup(text.encode(), Path("setup.py")).setup
    assert setup is not None
    assert "entry_points" in [name for name, _ in setup.computed]


@pytest.mark.parametrize(
    "entry",
    ["'{}_x = {}.x:main'.format(N, N)", "'{0}_x = {0}.x:main'.format(N)", "f'{N}_x = {N}.x:main'",
     "'{n}_x = {n}.x:main'.format(n=N)", "N + '_x = {}.x:main'.format(N)"],
)  # fmt: skip
def test_entries_of_constants_are_known(entry: str) -> None:
    """What formats make of constants is read."""
    setup = read_setup(f"N = 'demo'\n{_SCRIPTS % entry}".encode(), Path("setup.py")).setup
    assert setup is not None and not setup.computed
    assert [each[:2] for each in setup.console_scripts] == [("demo_x", "demo.x:main")]


def test_a_branch_that_does_not_run_changes_nothing() -> None:
    """A name that the other generation changes is constant for this one."""
    text = (
        f"{_VERSION}E = ['a = b:main']\nif V == 1:\n    E.append('c = d:main')\n{_SCRIPTS % '*E'}"
    )
    text = text.replace("[*E]", "E")
    first, second = (read_setup(text.encode(), Path("setup.py"), each).setup for each in (1, 2))
    assert first is not None and second is not None
    assert [name for name, _ in first.computed] == ["entry_points"]
    assert not second.computed


def test_large_formats_are_not_followed() -> None:
    """A format that makes a long text of a short one is left alone."""
    long = repr("{0}" * 500)
    text = f"A = 'x'\nB = {long}.format(A)\nC = {long}.format(B)\n{_SCRIPTS % (_FORMATTED % 'C')}"
    setup = read_setup(text.encode(), Path("setup.py")).setup
    assert setup is not None and not setup.console_scripts


@pytest.mark.parametrize("end", ["\n", "\r\n", "\r", "\n\f\n", "\n\f"])
def test_lines_end_where_python_ends_them(end: str) -> None:
    text = f"from setuptools import setup{end}# of{end}setup(name='demo'){end}"
    read = read_setup(text.encode(), Path("setup.py"))
    assert read.diagnostics == ()
    assert read.setup is not None and read.setup.name == "demo"


_SYNTAX_ERRORS = {
    "a = 1\nb = 2\fsetup(name='demo')\n": 2,
    "a = 1\nb = 2\vsetup(name='demo')\n": 2,
    "a = 1\n\x1c\nsetup(name='demo')\n": 2,
    "a = 1\nb = (2\nsetup(name='demo')\n": 2,
    "if a:\n    b = 2\n    c = 3 4\nsetup(name='demo')\n": 3,
}


@pytest.mark.parametrize("text", _SYNTAX_ERRORS, ids=ascii)
def test_syntax_error_is_told_with_its_line(text: str) -> None:
    (told,) = read_setup(text.encode(), Path("setup.py")).diagnostics
    assert told.message == f"line {_SYNTAX_ERRORS[text]} of `setup.py` has a syntax error"
