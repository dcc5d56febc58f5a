"""Packages whose folders, entry points or plugins are not where they usually are."""

from __future__ import annotations

from pathlib import Path

import pytest
from loaded_packages import AMENT_PYTHON, IN, KINDS, OUT, lay, run, texts

SETUP = AMENT_PYTHON["setup.py"]
IMPORT = "from setuptools import setup\n"
FOUND = SETUP.replace(IMPORT, "from setuptools import find_packages, setup\n").replace(
    "            'listener = demo.listener:main',  # hears it\n", ""
)


def files(setup: str, *modules: str) -> dict[str, str]:
    return {
        "package.xml": AMENT_PYTHON["package.xml"],
        "setup.cfg": AMENT_PYTHON["setup.cfg"],
        "setup.py": setup,
        **dict.fromkeys(modules, ""),
    }


def packages(setup: str, value: str) -> str:
    return setup.replace("packages=[package_name]", f"packages={value}")


LAYOUTS = {
    "another name": (
        packages(FOUND, "find_packages(exclude=['test'])"),
        ("bringup/__init__.py", "test/__init__.py"),
        ("bringup/talker.py", "bringup.talker:main"),
    ),
    "what is left out": (
        packages(FOUND, "find_packages(exclude=('alpha', 'alpha.*'))"),
        ("alpha/__init__.py", "alpha/inner/__init__.py", "beta/__init__.py"),
        ("beta/talker.py", "beta.talker:main"),
    ),
    "a folder without a package": (
        packages(FOUND, "find_packages()"),
        ("alpha/inner/__init__.py", "beta/__init__.py"),
        ("beta/talker.py", "beta.talker:main"),
    ),
    "below src": (
        packages(FOUND, "find_packages('src'),\n    package_dir={'': 'src'}"),
        ("src/bringup/__init__.py", "other/__init__.py"),
        ("src/bringup/talker.py", "bringup.talker:main"),
    ),
    "below a folder of any name": (
        packages(FOUND, "['demo'],\n    package_dir={'': 'python'}"),
        ("python/demo/__init__.py",),
        ("python/demo/talker.py", "demo.talker:main"),
    ),
}


@pytest.mark.parametrize("name", LAYOUTS)
def test_a_node_goes_where_the_modules_are(name: str, tmp_path: Path) -> None:
    setup, modules, (file, target) = LAYOUTS[name]
    package = lay(tmp_path, files(setup, *modules))
    before = texts(package)
    assert run(IN, tmp_path, "rclpy", in_place=True) == ()
    after = texts(package)
    assert set(after) == {*before, file}
    assert f"talker = {target}" in after["setup.py"].decode()
    run(OUT, tmp_path, "rclpy", in_place=True)
    assert {each: texts(package)[each] for each in before} == before


@pytest.mark.parametrize(
    "value", ["find_packages(exclude=hidden())", "find_packages(*where)", "found()"]
)
def test_packages_that_are_computed_are_not_guessed(value: str, tmp_path: Path) -> None:
    package = lay(tmp_path, files(packages(FOUND, value), "bringup/__init__.py"))
    before = texts(package)
    [told] = run(IN, tmp_path, "rclpy", in_place=True)
    assert told.code == "edit-refused"
    assert texts(package) == before


BARE = SETUP.partition("    entry_points")[0] + ")\n"
HEAD = "[install]\ninstall_scripts=$base/lib/demo\n"
POINTS = f"{HEAD}[options.entry_points]\n"
CONFIGURATIONS = {
    "in its place": (
        f"{POINTS}console_scripts =\n    a = demo.a:main\n    z = demo.a:main\n\n[x]\n",
        "    talker = demo.talker:main",
    ),
    "at the end, in their style": (
        f"{POINTS}console_scripts =\n  z=demo.a:main\n  # more\n  a=demo.a:main\n",
        "  talker=demo.talker:main",
    ),
    "behind one in the line of the key": (
        f"{POINTS}console_scripts = z = demo.a:main\n",
        "    talker = demo.talker:main",
    ),
    "the first": (
        f"{POINTS}console_scripts =\n",
        "console_scripts = talker = demo.talker:main",
    ),
    "the first of its kind": (f"{POINTS}rqt =\n    x = y:z\n", "    talker = demo.talker:main"),
    "without a last line's end": (
        f"{POINTS}console_scripts =\n    a = demo.a:main",
        "    talker = demo.talker:main",
    ),
    "with other lines' ends": (
        f"{POINTS}console_scripts =\n    a = demo.a:main\n".replace("\n", "\r\n"),
        "    talker = demo.talker:main",
    ),
    "with a byte order mark": (
        f"\ufeff{POINTS}console_scripts =\n    a = demo.a:main\n",
        "    talker = demo.talker:main",
    ),
}


@pytest.mark.parametrize("name", CONFIGURATIONS)
def test_a_script_goes_where_the_scripts_are(name: str, tmp_path: Path) -> None:
    text, line = CONFIGURATIONS[name]
    package = lay(tmp_path, {**AMENT_PYTHON, "setup.py": BARE, "demo/a.py": "", "setup.cfg": text})
    before = texts(package)
    assert run(IN, tmp_path, "rclpy", in_place=True) == ()
    after = texts(package)
    assert after["setup.py"] == before["setup.py"]
    assert line in after["setup.cfg"].decode().splitlines()
    assert run(IN, tmp_path, "rclpy", in_place=True) == ()
    assert texts(package) == after
    run(OUT, tmp_path, "rclpy", in_place=True)
    assert {each: texts(package)[each] for each in before} == before


def test_the_scripts_of_setup_py_count_before_those_of_setup_cfg(tmp_path: Path) -> None:
    package = lay(tmp_path, {**AMENT_PYTHON, "setup.cfg": f"{POINTS}console_scripts =\n"})
    before = texts(package)
    assert run(IN, tmp_path, "rclpy", in_place=True) == ()
    assert texts(package)["setup.cfg"] == before["setup.cfg"]
    assert b"demo.talker:main" in texts(package)["setup.py"]


def test_scripts_that_pyproject_leaves_to_setup_py_are_its(tmp_path: Path) -> None:
    project = '[project]\nname = "demo"\ndynamic = ["scripts"]\n[tool.x]\n'
    lay(tmp_path, {**AMENT_PYTHON, "pyproject.toml": project})
    assert run(IN, tmp_path, "rclpy", in_place=True) == ()


PLUGINS = """\
<library path="{path}">
  <class name="other" type="demo.other.Other" base_class_type="rqt_gui_py::Plugin"/>
  <class name="it" type="{type}" base_class_type="rqt_gui_py::Plugin">
  </class>
</library>
"""


@pytest.mark.parametrize(
    ("kind", "path", "type_", "is_refused"),
    [
        ("ament_python", ".", "demo.talker.Talker", True),
        ("ament_python", "src", "demo.talker.Talker", True),
        ("ament_python", "src", "demo.talker_view.Talker", False),
        ("ament_python", "src", "", False),
        ("catkin", "scripts", "talker.Talker", True),
        ("catkin", "src", "talker.Talker", False),
    ],
)
def test_an_executable_stays_whose_file_a_plugin_is_loaded_from(
    kind: str, path: str, type_: str, is_refused: bool, tmp_path: Path
) -> None:
    library, base = KINDS[kind]
    described = PLUGINS.format(path=path, type=type_)
    package = lay(tmp_path, {**base, "plugin.xml": described, "broken.xml": "<class"})
    assert run(IN, tmp_path, library, in_place=True) == ()
    before = texts(package)
    told = run(OUT, tmp_path, library, in_place=True)
    if not is_refused:
        assert [each.code for each in told] == ["file-stays"]
        return
    [refused] = told
    assert refused.code == "edit-refused"
    assert f"line 3 of `plugin.xml` loads `{type_}`" in refused.message
    assert texts(package) == before


@pytest.mark.parametrize("text", ["", "[develop]\nscript_dir=$base/lib/demo\n"])
def test_a_script_that_is_installed_where_it_is_not_found_is_told(
    text: str, tmp_path: Path
) -> None:
    package = lay(tmp_path, {**AMENT_PYTHON, "setup.cfg": text})
    [told] = run(IN, tmp_path, "rclpy", in_place=True)
    assert (told.code, told.span is not None) == ("script-elsewhere", True)
    assert b"talker" in texts(package)["setup.py"]


OPEN = [
    '[project]\nname = "demo"\ndynamic = ["scripts"]\n',
    "[project]\ndynamic = ['version', 'scripts']\n",
    '[ project ]\ndynamic = [\n  "scripts",  # ours\n]\n',
    'project.dynamic = ["scripts"]\n',
    '[tool.x]\nproject = "demo"\n[x.project]\n',
    'x = """\n[project]\n"""\n',
]
CLOSED = {
    '[project]\nkeywords = ["scripts"]\n': 1,
    '[project]\n# dynamic = ["scripts"]\n': 1,
    "[project]\ndescription = 'dynamic = [\"scripts\"]'\n": 1,
    "[tool.x]\n[ project ]\n": 2,
    "[tool.x]\nproject = 1\n[project]\n": 3,
    '# it\nproject.name = "demo"\n': 2,
    'project = {name = "demo"}\n': 1,
    '["project"]\n': 1,
    "[project.scripts]\n": 1,
    '[project]\ndynamic = "scripts"\n': 1,
}
BROKEN = ["[project\n", "[project]\n[project]\n", "x = " + "[" * 50_000, "\ufeff[tool]\n"]


@pytest.mark.parametrize("text", [*OPEN, *CLOSED, *BROKEN])
def test_a_pyproject_is_read_as_toml(text: str, tmp_path: Path) -> None:
    package = lay(tmp_path, {**AMENT_PYTHON, "pyproject.toml": text})
    before = texts(package)
    told = run(IN, tmp_path, "rclpy", in_place=True)
    if text in OPEN:
        assert told == ()
        return
    wanted = f"line {CLOSED[text]} of" if text in CLOSED else "has a syntax error"
    assert len(told) == 1
    assert wanted in told[0].message
    assert texts(package) == before
