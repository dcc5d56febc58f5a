# ruff: noqa: E501 - a case is a line
"""Each edit of a setup.py: what it makes of a file, and that its inverse takes it back."""

from __future__ import annotations

import ast
from pathlib import Path
from typing import Any

import pytest

from plastron_tui.diagnostics import codes
from plastron_tui.sources.setup_py.data_files import add_data_file, remove_data_file
from plastron_tui.sources.setup_py.reader import read_setup
from plastron_tui.sources.setup_py.scripts import add_console_script, remove_console_script

PATH = Path("setup.py")
SCRIPT = ("talker", "rover.talker:main")
FILE = ("launch", "launch/all.launch.xml")


def whole(arguments: str, before: str = "") -> str:
    return f"import os\nfrom glob import glob\nfrom setuptools import setup\n\nN = 'rover'\n{before}\nsetup({arguments})\n"


# `<` and `>` stand around what is new; where nothing stands so, there is nothing to do.
SCRIPTS = {
    "empty": whole("\n    name=N,\n    entry_points={\n        'console_scripts': [\n<            'talker = rover.talker:main',\n>        ],\n    },\n"),
    "empty with a comment": whole("\n    name=N,\n    entry_points={\n        'console_scripts': [\n            # none\n<            'talker = rover.talker:main',\n>        ],\n    },\n"),
    "empty in a line": whole("\n    name=N,\n    entry_points={\n        'console_scripts': [<\n            'talker = rover.talker:main'\n        >],\n    },\n"),
    "last": whole("\n    name=N,\n    entry_points={\n        'console_scripts': [\n            'z = a:b',\n            'a = b:c',  # first\n<            'talker = rover.talker:main',\n>        ],\n    },\n"),
    "sorted": whole("\n    name=N,\n    entry_points={\n        'console_scripts': [\n            'a = b:c',\n<            'talker = rover.talker:main',\n>            'z = a:b',\n        ],\n    },\n"),
    "no comma": whole('\n    name=N,\n    entry_points={"console_scripts": [\n        "z = b:c"<,\n        "talker = rover.talker:main">\n    ]},\n'),
    "no comma, comment": whole('\n    name=N,\n    entry_points={"console_scripts": [\n        "z = b:c"<,>  # why\n<        "talker = rover.talker:main"\n>    ]},\n'),
    "one line": whole("name=N, entry_points={'console_scripts': ['z = b:c'<, 'talker = rover.talker:main'>]}"),
    "no key": whole("\n    name=N,\n    entry_points={\n        'gui_scripts': ['x = y:z'],\n<        'console_scripts': ['talker = rover.talker:main'],\n>    },\n"),
    "no argument": whole("\n    name=N,\n<    entry_points={'console_scripts': [\n        'talker = rover.talker:main',\n    ]},\n>"),
    "no argument, no comma": whole("name=N,\n      version='1'<,\n      entry_points={'console_scripts': [\n          'talker = rover.talker:main',\n      ]}>"),
    "no argument in a line": whole("name=N<, entry_points={'console_scripts': ['talker = rover.talker:main']}>"),
    "names": whole("name=N, entry_points=E", "S = ['z = b:c'<, 'talker = rover.talker:main'>]\nE = {'console_scripts': S}\n"),
    "sum": whole("name=N, entry_points={'console_scripts': ['z = b:c'<, 'talker = rover.talker:main'>] + OTHERS}", "OTHERS = get()\n"),
    "comprehension": whole("name=N, entry_points={'console_scripts': [f'{n} = {N}.{n}:main' for n in NODES]}", "NODES = [\n    'z',\n    'a',\n<    'talker',\n>]\n"),
    "there already": whole("name=N, entry_points={'console_scripts': ['talker=%s.talker:main' % N]}"),
    "there by a loop": whole("name=N, entry_points={'console_scripts': [n + ' = rover.' + n + ':main' for n in ('talker',)]}"),
    "main guard": "import setuptools\nif __name__ == '__main__':\n    setuptools.setup(\n        name='rover',\n        entry_points={'console_scripts': [<'talker = rover.talker:main'>]},\n    )\n".replace("[<'talker = rover.talker:main'>]", "['a = b:c'<, 'talker = rover.talker:main'>]"),
    "given by name": whole("**K", "K = dict(\n    name=N,\n    entry_points={'console_scripts': ['z = b:c'<, 'talker = rover.talker:main'>]},\n)\n"),
}  # fmt: skip
DATA = {
    "beside": whole("\n    name=N,\n    data_files=[\n        ('share/' + N, ['package.xml']),\n<        ('share/' + N + '/launch', ['launch/all.launch.xml']),\n>    ],\n"),
    "joined": whole("\n    name=N,\n    data_files=[\n        (os.path.join('share', N), ['package.xml']),\n<        (os.path.join('share', N, 'launch'), ['launch/all.launch.xml']),\n>    ],\n"),
    "formatted": whole("\n    name=N,\n    data_files=[\n        (f'share/{N}', ['package.xml']),\n<        (f'share/{N}/launch', ['launch/all.launch.xml']),\n>    ],\n"),
    "into a list": whole("name=N, data_files=[('share/rover/launch', ['launch/a.xml'<, 'launch/all.launch.xml'>])]"),
    "covered": whole("name=N, data_files=[(os.path.join('share', N, 'launch'), glob('launch/*.xml'))]"),
    "covered with others": whole("name=N, data_files=[('share/rover/launch', ['launch/a.py'] + glob('launch/*.xml'))]"),
    "another pattern": whole("name=N, data_files=[('share/rover/launch', glob('launch/*.py'))<,\n                          ('share/rover/launch', ['launch/all.launch.xml'])>]"),
    "none": whole("\n    name=N,\n<    data_files=[\n        ('share/rover/launch', ['launch/all.launch.xml']),\n    ],\n>"),
}  # fmt: skip


def texts_of(marked: str, ending: str) -> tuple[bytes, bytes]:
    marked = marked.replace("\n", ending)
    before = "".join(part.split(">")[-1] for part in marked.split("<"))
    return before.encode(), marked.replace("<", "").replace(">", "").encode()


@pytest.mark.parametrize("ending", ["\n", "\r\n"], ids=["lf", "crlf"])
@pytest.mark.parametrize("name", SCRIPTS)
def test_a_console_script_and_its_inverse(name: str, ending: str) -> None:
    before, after = texts_of(SCRIPTS[name], ending)
    edited = add_console_script(before, PATH, *SCRIPT)
    assert edited.diagnostics == ()
    assert (edited.text or b"").decode() == after.decode()
    ast.parse(after)
    if before != after:
        assert remove_console_script(after, PATH, SCRIPT[0]) == (before, ())


@pytest.mark.parametrize("ending", ["\n", "\r\n"], ids=["lf", "crlf"])
@pytest.mark.parametrize("name", DATA)
def test_a_data_file_and_its_inverse(name: str, ending: str) -> None:
    before, after = texts_of(DATA[name], ending)
    edited = add_data_file(before, PATH, *FILE)
    assert edited.diagnostics == ()
    assert (edited.text or b"").decode() == after.decode()
    if before != after:
        assert remove_data_file(after, PATH, *FILE) == (before, ())


REFUSED = {
    "setup(name='x',\n": (codes.BROKEN_BUILD_FILE, "line 1 of `setup.py` has a syntax error"),
    "x = 1\n": (
        codes.BROKEN_BUILD_FILE,
        "line 1 of `setup.py` has no call of `setup` in the file that begins there",
    ),
    "setup()\nsetup()\n": (
        codes.COMPUTED_BUILD_FILE,
        "line 2 of `setup.py` calls `setup` a second time",
    ),
    "\nsetup(entry_points=get())\n": (
        codes.COMPUTED_BUILD_FILE,
        "line 2 of `setup.py` computes `entry_points`, or writes it as one text",
    ),
    "\nsetup(entry_points={'console_scripts': [n for n in os.listdir('x')]})\n": (
        codes.COMPUTED_BUILD_FILE,
        "line 2 of `setup.py` computes the console scripts",
    ),
    "S = []\nfor x in y:\n    S.append(x)\nsetup(entry_points={'console_scripts': S})\n": (
        codes.COMPUTED_BUILD_FILE,
        "line 3 of `setup.py` computes the console scripts",
    ),
    "setup(**get())\n": (
        codes.COMPUTED_BUILD_FILE,
        "line 1 of `setup.py` computes what `setup` is called with",
    ),
    "setup(entry_points={'console_scripts': [\n    'talker = other:main']})\n": (
        codes.EDIT_REFUSED,
        "line 2 of `setup.py` makes `talker` start `other:main` already",
    ),
    "d = generate_distutils_setup(packages=['x'])\nsetup(**d)\n": (
        codes.EDIT_REFUSED,
        "line 1 of `setup.py` is catkin's, which takes no console scripts",
    ),
    "# coding: latin-1\nsetup()\n": (codes.UNREADABLE_FILE, "line 1 of `setup.py` is not UTF-8"),
}


@pytest.mark.parametrize("text", REFUSED)
def test_what_is_not_sure_is_refused_with_its_line(text: str) -> None:
    edited = add_console_script(text.encode(), PATH, *SCRIPT)
    assert edited.text is None
    assert [(each.code, each.message) for each in edited.diagnostics] == [REFUSED[text]]


HOSTILE: dict[str, bytes] = {
    "not UTF-8": b"setup(name='\xff')\n",
    "NUL": b"setup(name='\0')\n",
    "huge": b"x = 1\n" * 100_000,
    "brackets": b"setup(" + b"[" * 100_000,
    "deep": b"setup(name=" + b"(" * 20_000 + b"'x'" + b")" * 20_000 + b")\n",
    "sum": b"setup(name=" + b"'x' + " * 20_000 + b"'x')\n",
    "circle": b"a = b\nb = a\nsetup(name=a, entry_points=b)\n",
    "itself": b"a = [a]\nsetup(name=a, entry_points={'console_scripts': a})\n",
    "splat": b"k = {**k}\nsetup(**k)\n",
    "names in a row": b"".join(b"a%d = a%d\n" % (x + 1, x) for x in range(3_000))
    + b"a0 = []\nsetup(data_files=["
    + b"a0, " * 6_000
    + b"])\n",
    "sum with itself": b"a = a + ['x = y:z']\nsetup(entry_points={'console_scripts': a})\n",
    "sums in a circle": b"a = b + ['x = y:z']\nb = a + []\nsetup(entry_points={'console_scripts': a}, data_files=b)\n",
    "given in a circle": b"a = b\nb = a\nfor a in b: b = a\nsetup(entry_points={'console_scripts': a})\n",
    "calls in calls": b"x = " + b"f(a, " * 190 + b"1" + b")" * 190 + b"\nsetup(data_files=x)\n",
}


@pytest.mark.parametrize("name", HOSTILE)
def test_hostile_files_do_no_harm(name: str) -> None:
    edited = add_console_script(HOSTILE[name], PATH, *SCRIPT)
    if edited.text is None:
        assert edited.diagnostics
    else:
        assert remove_console_script(edited.text, PATH, SCRIPT[0]).text == HOSTILE[name]


@pytest.mark.parametrize("name", [each for each in SCRIPTS if each not in ("main guard", "sum")])
def test_python_and_the_reader_agree(name: str) -> None:
    _, after = texts_of(SCRIPTS[name], "\n")
    given: dict[str, Any] = {}
    code = after.decode().replace("from setuptools import setup\n", "")
    exec(compile(code, "setup.py", "exec"), {"setup": lambda **all_: given.update(all_)})
    read = read_setup(after, PATH).setup
    assert read is not None
    scripts = [f"{each.name}={each.target}" for each in read.console_scripts]
    assert scripts == [
        "=".join(part.strip() for part in each.split("="))
        for each in given["entry_points"]["console_scripts"]
    ]
    assert read.name == given["name"]


LIST = "S = ['listener = rover.listener:main']\nE = {'console_scripts': S}\n"
CHANGES = [
    "S.append('x = y:z')",
    "S += ['x = y:z']",
    "S[0] = 'x = y:z'",
    "S[:] = []",
    "del S[0]",
    "S.__iadd__(['x = y:z'])",
    "fill(S)",
    "fill(scripts=S)",
    "fill([S])",
    "E['console_scripts'].append('x = y:z')",
    "E['console_scripts'] += ['x = y:z']",
    "E.update(console_scripts=[])",
    "E.setdefault('console_scripts', []).append('x = y:z')",
    "E.get('console_scripts').append('x = y:z')",
    "fill(E)",
    "T = S; T += ['x = y:z']",
    "T = E['console_scripts']; T.append('x = y:z')",
    "T = {'a': S}; T['a'].append('x = y:z')",
    "T = {}; T['a'] = S; T['a'].clear()",
    "add = S.append; add('x = y:z')",
    "[each.append('x = y:z') for each in E.values()]",
    "K['entry_points']['console_scripts'] += ['x = y:z']",
    "K['entry_points'] = {}",
    "K.update(entry_points={})",
    "def get(): return S",
    "(T := S).append('x = y:z')",
]


@pytest.mark.parametrize("change", CHANGES)
@pytest.mark.parametrize("is_splat", [True, False])
def test_what_may_be_changed_is_refused_with_its_line(change: str, is_splat: bool) -> None:
    call = "**K" if is_splat else "entry_points=E"
    if change.startswith("K") and not is_splat:
        return
    text = f"{LIST}K = dict(name='rover', entry_points=E)\n{change}\nsetup({call})\n".encode()
    for edited in (
        add_console_script(text, PATH, "new", "rover.new:main"),
        remove_console_script(text, PATH, "listener"),
    ):
        assert edited.text is None
        assert edited.diagnostics[0].message.startswith("line 4 of `setup.py` computes ")


READINGS = [
    "print(S, len(S), sorted(S))",
    "for each in S: print(each.split('='))",
    "for each in S: fill(each)",
    "if S: pass",
    "T = ', '.join(S)",
    "other.append(1)",
    "os.environ['X'] = 'y'",
]


@pytest.mark.parametrize("reading", READINGS)
def test_what_only_reads_a_list_is_in_nobodys_way(reading: str) -> None:
    text = f"{LIST}{reading}\nsetup(name='rover', entry_points=E)\n".encode()
    edited = add_console_script(text, PATH, "new", "rover.new:main")
    assert edited.text == text.replace(b"main']", b"main', 'new = rover.new:main']")
    assert remove_console_script(edited.text or b"", PATH, "new") == (text, ())


DATA_CHANGES = ["D.append(x)", "D[0][1].append('b')", "F.append('b')", "fill(F)", "D += more"]


@pytest.mark.parametrize("change", DATA_CHANGES)
def test_data_files_that_may_be_changed_are_refused(change: str) -> None:
    text = "F = ['launch/a']\nD = [('share/rover/launch', F)]\n"
    text += f"{change}\nsetup(name='rover', data_files=D)\n"
    for edited in (
        add_data_file(text.encode(), PATH, "launch", "launch/b"),
        remove_data_file(text.encode(), PATH, "launch", "launch/a"),
    ):
        assert edited.text is None
        assert "computes" in edited.diagnostics[0].message


def test_a_list_that_is_used_twice_is_not_changed_for_one() -> None:
    text = "N = ['a']\nsetup(entry_points={'console_scripts': [f'{n} = r.{n}:main' for n in N]}, "
    edited = add_console_script(f"{text}scripts=N)\n".encode(), PATH, "b", "r.b:main")
    assert [each.message for each in edited.diagnostics] == [
        "line 2 of `setup.py` computes the console scripts"
    ]
    edited = add_console_script(f"{text})\n".encode(), PATH, "b", "r.b:main")
    assert edited.text == f"{text})\n".replace("['a']", "['a', 'b']").encode()
