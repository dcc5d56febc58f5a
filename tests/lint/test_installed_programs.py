"""Programs that packages install otherwise than by an entry point of setup.py."""

from __future__ import annotations

from pathlib import Path

import pytest
from packages import CMAKE, PY_NODE, PYTHON, Break, told_of

from plastron_tui.lint.rules.package_examples import setup_py

_NODE = PY_NODE.replace("Mover", "Runner").replace("'mover'", "'runner'")
_NAMED = {
    "wheels/launch/more.launch.xml": '<launch>\n  <node pkg="wheels" exec="runner.py"/>\n'
    "</launch>\n"
}
_SCRIPT = _NAMED | {"wheels/scripts/runner.py": _NODE}
_CONDITION = "if int(os.environ['ROS_VERSION']) == {}:\n    "
_DATA = "data_files=[("

_CFG = {
    "rover/setup.cfg": "[options.entry_points]\nconsole_scripts =\n"
    "    runner = rover.runner:main\n",
    "rover/rover/__init__.py": "",
    "rover/rover/runner.py": _NODE,
    "rover/launch/more.launch.xml": '<launch>\n  <node pkg="rover" exec="runner"/>\n'
    '  <node pkg="rover" exec="walker"/>\n</launch>\n',
}
_LAST = "ament_package()"
_PYTHON_PACKAGE = "ament_python_install_package(${{PROJECT_NAME}}{})\nament_package()"
_ONE, _TWO = "RK506 rover/launch/more.launch.xml:2", "RK506 rover/launch/more.launch.xml:3"


def _setup(old: str, new: str, found: str, **more: str) -> Break:
    return Break("wheels/setup.py", old, new, found, more={**_SCRIPT, **more})


_FOLDERS = {
    "rover/test": False, "rover/test2": False, "rover/system_tests/launch": False,
    "rover/rostest": False, "rover/launch/Old": False, "rover/deprecated": False,
    "rover/testbed": True, "rover/launch/contest": True, "rover/launch/demo": True,
}  # fmt: skip
"""Folders of launch files, and whether what they start has to be there."""
_STARTS = '<launch>\n  <node pkg="rover" exec="nothing"/>\n</launch>\n'

_CASES = [
    # `scripts` and `data_files` of setup.py.
    Break("wheels/scripts/runner.py", "", _NODE,
          "RK506 wheels/launch/more.launch.xml:2, RK503 wheels/scripts/runner.py:18", more=_NAMED),
    _setup("setup(", "setup(\n    scripts=['scripts/runner.py'],", ""),
    _setup("setup(", "from glob import glob\nsetup(\n    scripts=glob('scripts/*'),", ""),
    _setup("setup(", "from glob import glob\nsetup(\n    scripts=glob('bin/*'),",
           "RK506 wheels/launch/more.launch.xml:2, RK503 wheels/scripts/runner.py:18"),
    _setup("setup(", "setup(\n    scripts=find(),", ""),
    _setup(_DATA, "data_files=[('lib/wheels', ['scripts/runner.py']), (", ""),
    _setup(_DATA, "data_files=[('lib/other', ['scripts/runner.py']), (",
           "RK506 wheels/launch/more.launch.xml:2"),
    _setup(_DATA, "data_files=[('lib/wheels', find()), (", ""),
    # The generation of ROS decides.
    Break("wheels/setup.py", "setup(", _CONDITION.format(2) + "setup("),
    Break("wheels/setup.py", "'mover = wheels", "'mowers = wheels", more={},
          found="RK506 wheels/launch/wheels.launch.py:7"),
    Break("wheels/setup.py", "setup(", "if is_new():\n    setup(", more=_NAMED),
    Break("wheels/setup.py", "'mover = wheels.mover:main'",
          "'{}er = wheels.{}er:main'.format(A, A)", more=_NAMED),
    Break("wheels/setup.py", "wheels.mover:main", "wheels.mver:main",
          "RK505 wheels/setup.py:8"),
    # A folder among the packages, by its path.
    Break("wheels/setup.py", "", setup_py("mover = src.wheels.mover:main", name="wheels").replace(
          "packages=['", "packages=['src/"), more={"wheels/src/wheels/mover.py": PY_NODE}),
    # A setup.cfg beside CMakeLists.txt.
    Break("rover/CMakeLists.txt", _LAST, _PYTHON_PACKAGE.format(""),
          f"{_ONE}, {_TWO}, RK503 rover/rover/runner.py:18", more=_CFG),
    Break("rover/CMakeLists.txt", _LAST,
          _PYTHON_PACKAGE.format(" SCRIPTS_DESTINATION lib/${PROJECT_NAME}"), _TWO, more=_CFG),
    Break("rover/CMakeLists.txt", _LAST, _PYTHON_PACKAGE.format(" SCRIPTS_DESTINATION bin"),
          f"{_ONE}, {_TWO}", more=_CFG),
    Break("rover/CMakeLists.txt", _LAST, _PYTHON_PACKAGE.format(
          " SETUP_CFG other.cfg SCRIPTS_DESTINATION lib/${PROJECT_NAME}"), more=_CFG),
    Break("rover/CMakeLists.txt", _LAST,
          _PYTHON_PACKAGE.format(" SCRIPTS_DESTINATION ${SOMEWHERE}"), more=_CFG),
    # What tests and what is left behind start may not be there.
    *(Break(f"{folder}/a.launch.xml", "", _STARTS,
            f"RK506 {folder}/a.launch.xml:2" if is_told else "")
      for folder, is_told in _FOLDERS.items()),
]  # fmt: skip


@pytest.mark.parametrize("case", _CASES)
def test_programs(case: Break, tmp_path: Path) -> None:
    """A program that a package may have is not told, and one that it surely has not is."""
    assert told_of(tmp_path, case.files(PYTHON | CMAKE)) == case.found


_IN_TESTS = {
    f"rover_tests{name.removeprefix('rover')}": text.replace("(rover)", "(rover_tests)")
    .replace("<name>rover<", "<name>rover_tests<")
    .replace('pkg="rover"', 'pkg="rover_tests"')
    for name, text in CMAKE.items()
}


@pytest.mark.parametrize(
    "case",
    [
        Break("rover_tests/launch/more.launch.xml", "", _STARTS.replace('"rover"', '"rover_tests"'),
              "RK506 rover_tests/launch/more.launch.xml:2"),
        Break("rover_tests/test/more.launch.xml", "", _STARTS.replace('"rover"', '"rover_tests"')),
        Break("rover_tests/scripts/runner.py", "", PY_NODE,
              "RK503 rover_tests/scripts/runner.py:18"),
        # What tests alone start need not be installed.
        Break("rover_tests/other/runner.py", "", PY_NODE),
    ],
)  # fmt: skip
def test_package_may_be_called_as_tests_are(case: Break, tmp_path: Path) -> None:
    assert told_of(tmp_path, case.files(_IN_TESTS), ()) == case.found
