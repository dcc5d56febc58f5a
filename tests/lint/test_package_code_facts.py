"""What the code and the entry points of a package say, case by case."""

from __future__ import annotations

import pytest
from packages import CMAKE, PYTHON
from read_packages import Change, facts_of

from plastron_tui.model.package_facts import BuildFacts

_PY, _CPP = "wheels/mover.py", "src/mover.cpp"
_IMPORT = "import rclpy\nfrom"
_INCLUDE = '#include "geometry_msgs'


def _used(facts: BuildFacts) -> str:
    return " ".join(f"{each.need}:{each.what}" for each in facts.used)


def _python(lines: str) -> Change:
    """Return a change that has further lines among the imports of the node in Python."""
    return {_PY: f"{_IMPORT} -> import rclpy\n{lines}\nfrom"}


def _cpp(lines: str) -> Change:
    """Return a change that has further lines among the includes of the node in C++."""
    return {_CPP: f"{_INCLUDE} -> {lines}\n{_INCLUDE}"}


_NAV = "#include <nav_msgs/msg/path.hpp>"
_NAV_USED = "build:nav_msgs/msg/path.hpp"
_INSTALL = "install(PROGRAMS\n  scripts/mover.py"
_USED = [
    # Modules: what is imported whatever happens, and is no part of Python or of the package.
    ("wheels", {}, ""),
    ("wheels", _python("import os, numpy as np, yaml.nodes"), "exec:numpy exec:yaml.nodes"),
    ("wheels", _python("from numpy import array\nfrom . import other\nfrom wheels import a"), "exec:numpy"),
    ("wheels", _python("try:\n    import numpy\nexcept ImportError:\n    pass"), ""),
    ("wheels", _python("if True:\n    import numpy"), ""),
    ("wheels", _python("def load():\n    import numpy"), "exec:numpy"),
    ("wheels", _python("TEXT = '''\nimport numpy\n'''"), ""),
    ("wheels", _python("import numpy\ndef ("), ""),
    ("wheels", {_PY: "", "helper.py": "import numpy\n"}, ""),
    ("wheels", {_PY: "", "wheels/inner/a.py": "import numpy\n"}, ""),
    ("wheels", {_PY: "", "wheels/inner.py": "import tools\n", "tools/a.py": ""}, ""),
    ("wheels", {_PY: "", "wheels/inner.py": "import numpy\n", "wheels/numpy.py": ""}, ""),
    ("wheels", {_PY: "", "wheels/a.launch.py": "import numpy\n"}, ""),
    ("wheels", {_PY: "", "wheels/test_a.py": "import numpy\n"}, ""),
    ("wheels", {"package.xml": "<exec_depend>rclpy</exec_depend> -> <build_depend>rclpy</build_depend>"},
     "exec:rclpy exec:rclpy.node"),
    ("wheels", {"package.xml": "<exec_depend>rclpy</exec_depend> -> <exec_depend condition=\"$ROS_VERSION == 1\">rclpy</exec_depend>"},
     "exec:rclpy exec:rclpy.node"),
    # Scripts: those that are installed, of ROS 1 those that may be run.
    ("rover", {"scripts/mover.py": "import numpy\n"}, "exec:numpy"),
    ("rover", {"scripts/mover.py": "import numpy\n", "CMakeLists.txt": f"{_INSTALL} -> install(PROGRAMS"}, ""),
    ("rover", {"scripts/mover.py": "import numpy\n", "CMakeLists.txt":
               "scripts/mover.py\n  DESTINATION lib -> scripts/mover.py\n  DESTINATION share"}, ""),
    ("old", {"scripts/other.py": "import numpy\n"}, ""),
    ("old", {"scripts/mover.py": "import numpy\n", "CMakeLists.txt": " scripts/mover.py ->  "}, "exec:numpy"),
    # Headers of what is built, or handed on, and of what these include.
    ("rover", _cpp(_NAV), _NAV_USED),
    ("rover", _cpp('#include "nav_msgs/msg/path.hpp"'), _NAV_USED),
    ("rover", _cpp("#include <vector>\n#include \"part.hpp\""), ""),
    ("rover", _cpp('#include "part.hpp"') | {"src/part.hpp": _NAV}, _NAV_USED),
    ("rover", _cpp('#include "in/part.hpp"') | {"src/in/part.hpp": '#include "more.hpp"', "src/in/more.hpp": _NAV}, _NAV_USED),
    ("rover", _cpp('#include "in/part.hpp"') | {"src/in/part.hpp": '#include "more.hpp"', "src/more.hpp": _NAV}, _NAV_USED),
    ("rover", _cpp('#include "part.hpp"') | {"src/part.hpp": '#include "part.hpp"'}, ""),
    ("rover", _cpp('#include "test/part.hpp"') | {"src/test/part.hpp": _NAV}, ""),
    ("rover", {"src/other.cpp": _NAV, "src/part.hpp": _NAV}, ""),
    ("rover", {"src/part.cpp": _NAV}, _NAV_USED),
    ("rover", {"include/rover/part.hpp": _NAV}, ""),
    ("rover", {"include/rover/part.hpp": _NAV, "CMakeLists.txt":
               "install(DIRECTORY launch -> install(DIRECTORY include launch"}, _NAV_USED),
    ("rover", {"include/rover/part.txt": _NAV}, ""),
    ("rover", _cpp(_NAV) | {"third/nav_msgs/msg/path.hpp": ""}, ""),
    ("rover", {"src/extra.cpp": _NAV, "CMakeLists.txt":
               "install(DIRECTORY launch -> file(GLOB all src/e*.cpp)\nadd_library(extra ${all})\ninstall(DIRECTORY launch"}, _NAV_USED),
    ("rover", {"src/extra.cpp": _NAV, "CMakeLists.txt":
               "install(DIRECTORY launch -> if(WITH)\nadd_library(extra src/extra.cpp)\nendif()\ninstall(DIRECTORY launch"}, ""),
    # What is switched off, or in a guard of the whole.
    ("rover", _cpp(f"#ifdef WITH\n{_NAV}\n#endif"), ""),
    ("rover", _cpp(f"#if 1\n#endif\n{_NAV}"), _NAV_USED),
    ("rover", _cpp(f"#endif\n{_NAV}"), _NAV_USED),
    ("rover", _cpp(f"// {_NAV}\n/* {_NAV}\n{_NAV}\n*/"), ""),
    ("rover", _cpp(f'auto a = "/*";\n{_NAV}\nauto b = "*/";'), _NAV_USED),
    ("rover", {_CPP: f"#ifndef A\n#define A\n{_NAV}\n#endif\n// end\n"}, _NAV_USED),
    ("rover", {_CPP: f"#ifndef A\n#define A\n{_NAV}\n#endif\nint a;\n"}, ""),
    ("rover", {_CPP: f"#ifdef A\n{_NAV}\n#endif\n"}, ""),
    # Types that definitions are made of.
    ("rover", {"msg/Speed.msg": "nav_msgs/Path path\nnav_msgs/Path[] more\nrover/Other other\n"}, "build:nav_msgs"),
    ("rover", {"msg/Other.msg": "nav_msgs/Path path\n"}, ""),
    ("rover", {"msg/Speed.msg": "# nav_msgs/Path path\n"}, ""),
    ("rover", {"sub/msg/Speed.msg": "nav_msgs/Path path\n"}, ""),
]  # fmt: skip


@pytest.mark.parametrize(("package", "change", "used"), _USED, ids=lambda each: str(each)[:60])
def test_what_code_needs(package: str, change: Change, used: str) -> None:
    assert _used(facts_of(package, change)) == used


def test_all_places_of_one_package_are_known() -> None:
    change = _cpp(f"{_NAV}\n{_NAV}") | {"src/part.cpp": _NAV}
    (used,) = facts_of("rover", change).used
    assert (used.place.file, [each.file for each in used.others]) == (
        "src/mover.cpp",
        ["src/part.cpp"],
    )
    text = CMAKE["rover/src/mover.cpp"].encode()
    at = text.index(_INCLUDE.encode()) + len("#include <")
    assert used.place.span.start == at


_MAIN = "import rclpy\n\n\ndef main():\n    pass\n"
_GUARD = "if __name__ == '__main__':\n    main()\n"


def _script(facts: BuildFacts, name: str) -> str:
    found = next((each for each in facts.scripts if each.file == name), None)
    if found is None:
        return ""
    words = {"program": found.is_program, "main": found.has_main, "run": found.is_executable,
             "mentioned": found.is_mentioned}  # fmt: skip
    return " ".join([found.how.name, found.shebang.name, *(x for x, y in words.items() if y)])


_SCRIPTS = [
    ("wheels", "wheels/a.py", {}, _MAIN, "NOT MISSING main"),
    ("wheels", "wheels/a.py", {}, _MAIN + _GUARD, "NOT MISSING program main"),
    ("wheels", "wheels/a.py", {}, "#!/usr/bin/env python3\n" + _GUARD, "NOT GOOD program"),
    ("wheels", "wheels/a.py", {}, "#!/usr/bin/env python3\r\n" + _GUARD, "NOT CARRIAGE_RETURN program"),
    ("wheels", "wheels/a.py", {}, "import rclpy\n", ""),
    ("wheels", "wheels/test_a.py", {}, _MAIN, ""),
    ("wheels", "wheels/a.launch.py", {}, _MAIN, ""),
    ("wheels", "extra/a.py", {}, _MAIN, "UNKNOWN MISSING main"),
    ("wheels", "scripts/a.py", {}, _MAIN, "NOT MISSING main"),
    ("wheels", "scripts/a.py", {"setup.py": "    entry_points -> scripts=['scripts/a.py'],\n    entry_points"}, _MAIN, "UNKNOWN MISSING main"),
    ("wheels", "scripts/a.py", {"setup.py": "['package.xml'] -> ['scripts/a.py']"}, _MAIN, "UNKNOWN MISSING main"),
    ("wheels", "wheels/a.py", {"setup.py": "wheels.mover:main -> wheels.a:main"}, _MAIN, "SCRIPT MISSING main"),
    ("wheels", "wheels/a.py", {"setup.py": "wheels.mover:main -> wheels.b:main"}, _MAIN, "UNKNOWN MISSING main"),
    ("wheels", "wheels/a.py", {"setup.py": "['mover -> find() + ['mover"}, _MAIN, "UNKNOWN MISSING main"),
    ("rover", "scripts/mover.py", {}, _GUARD, "PROGRAM MISSING program run"),
    ("rover", "scripts/mover.py", {}, "import rclpy\n", "PROGRAM MISSING run"),
    ("rover", "scripts/a.py", {}, "import rclpy\n", ""),
    ("old", "scripts/mover.py", {"CMakeLists.txt": "${CATKIN_PACKAGE_BIN_DESTINATION} -> share/old"}, _GUARD, "UNKNOWN MISSING program run"),
    # Another file names it: it imports it, runs it, or is a comment that has taken it out.
    ("wheels", "wheels/a.py", {"wheels/b.py": "from wheels import a\n"}, _MAIN, "NOT MISSING main mentioned"),
    ("wheels", "wheels/a.py", {"wheels/b.py": "import wheels.a as other, os\n"}, _MAIN, "NOT MISSING main mentioned"),
    ("wheels", "wheels/a.py", {"wheels/b.py": "from wheels.a import main\n"}, _MAIN, "NOT MISSING main mentioned"),
    ("wheels", "wheels/a.py", {"wheels/b.py": "from . import (b,\n    a)\n"}, _MAIN, "NOT MISSING main mentioned"),
    ("wheels", "wheels/a.py", {"wheels/b.py": "import a\n"}, _MAIN, "NOT MISSING main mentioned"),
    ("wheels", "wheels/a.py", {"wheels/b.py": "import other as a\n"}, _MAIN, "NOT MISSING main"),
    ("wheels", "wheels/wheels.py", {"wheels/b.py": "import wheels\n"}, _MAIN, "NOT MISSING main"),
    ("wheels", "wheels/a.py", {"x.sh": "run a.py\n"}, _MAIN, "NOT MISSING main mentioned"),
    ("wheels", "wheels/a.py", {"README.md": "run a.py\n"}, _MAIN, "NOT MISSING main"),
    ("wheels", "wheels/a.py", {"x.launch.py": "x = [\n    # a\n]\n"}, _MAIN, "NOT MISSING main mentioned"),
    ("wheels", "wheels/a.py", {"x.launch.py": "x = 'wheels.a'\n"}, _MAIN, "NOT MISSING main mentioned"),
    ("wheels", "wheels/a.py", {"x.sh": "x = 'wheels.a'\n"}, _MAIN, "NOT MISSING main"),
    ("wheels", "wheels/a.py", {}, f"# python3 wheels/a.py --fast\n{_MAIN}", "NOT MISSING main mentioned"),
    ("wheels", "wheels/a.py", {}, f"# a.py is called\n{_MAIN}", "NOT MISSING main"),
    ("rover", "scripts/a.py", {"CMakeLists.txt": "ament_package -> configure_file(scripts/a.py b)\nament_package"}, _GUARD, "NOT MISSING program mentioned"),
    ("rover", "scripts/a.py", {"CMakeLists.txt": "ament_package -> set(all scripts/a.py)\nament_package"}, _GUARD, "NOT MISSING program"),
]  # fmt: skip


@pytest.mark.parametrize(
    ("package", "file", "change", "text", "said"), _SCRIPTS, ids=lambda each: str(each)[:50]
)
def test_what_a_script_is(package: str, file: str, change: Change, text: str, said: str) -> None:
    assert _script(facts_of(package, {**change, file: text}), file) == said


def test_places_of_a_script() -> None:
    text = f"#!/usr/bin/env python3\n{_MAIN}{_GUARD}"
    for said in (text, text.replace("\n", "\n", 1), "def main(): pass"):
        script = next(
            each
            for each in facts_of("wheels", {"wheels/a.py": said}).scripts
            if each.file == "wheels/a.py"
        )
        first = said.partition("\n")[0]
        assert said[script.first.start : script.first.end] == first
        begins = "if __name__" if "__name__" in said else "def main"
        assert said[script.main.start :].startswith(begins)
    (script,) = facts_of("rover", {"scripts/mover.py": "import rclpy\n"}).scripts
    assert script.main == script.first


_NAMES = "wheels.mover:main"
_ENTRIES = [
    ({}, ""),
    ({"setup.py": f"{_NAMES} -> wheels.mover:mian"}, "mian|`wheels.mover` has no `mian`|main|sure"),
    ({"setup.py": f"{_NAMES} -> wheels.mover:start"}, "start|`wheels.mover` has no `start`|"),
    ({"setup.py": f"{_NAMES} -> wheels.mover:Mover.run"}, ""),
    ({"setup.py": f"{_NAMES} -> wheels.mover:main [extra]"}, ""),
    ({"setup.py": f"{_NAMES} -> wheels.movr:main"}, "wheels.movr|there is no module `wheels.movr`|wheels.mover|sure"),
    ({"setup.py": f"{_NAMES} -> wheels.gripper:main"}, "wheels.gripper|there is no module `wheels.gripper`|"),
    ({"setup.py": f"{_NAMES} -> whels.mover:main"}, "whels.mover|there is no module `whels.mover`|wheels.mover|sure"),
    ({"setup.py": f"{_NAMES} -> mover:main"}, "mover|there is no module `mover`|wheels.mover|sure"),
    ({"setup.py": f"{_NAMES} -> numpy.core:main"}, ""),
    ({"setup.py": f"{_NAMES} -> numpy:main"}, ""),
    ({"setup.py": f"{_NAMES} -> wheels.mover"}, "wheels.mover|`wheels.mover` names no function, which stands behind a colon|wheels.mover:main|sure"),
    ({"setup.py": f"{_NAMES} -> wheels.mover", _PY: "x = 1\n"}, "wheels.mover|`wheels.mover` names no function, which stands behind a colon|"),
    ({"setup.py": f"{_NAMES} -> wheels.mover:"}, "wheels.mover:|`wheels.mover:` names no function, which stands behind a colon|wheels.mover:main|sure"),
    ({"setup.py": f"{_NAMES} -> :main"}, ":main|`:main` names no function, which stands behind a colon|"),
    ({"setup.py": f"'mover = {_NAMES}' -> 'mover = {_NAMES}' 'b = wheels.b:main'"}, "?|two console scripts run together, as a comma between them is missing|"),
    ({"setup.py": "packages=['wheels'] -> packages=['tools']"}, "wheels.mover|`packages` has no `wheels`, so `wheels.mover` is not installed|"),
    ({"setup.py": f"{_NAMES} -> wheels:main", "wheels/__init__.py": "def main():\n    pass\n"}, ""),
    ({"setup.py": "packages=['wheels'] -> packages=find()"}, ""),
    ({"setup.py": "packages=['wheels'] -> packages=['wheels'], package_dir={'': 'src'}",
      "src/wheels/mover.py": "def main():\n    pass\n", "src/wheels/__init__.py": "", _PY: None}, ""),
]  # fmt: skip


@pytest.mark.parametrize(("change", "told"), _ENTRIES, ids=lambda each: str(each)[:70])
def test_console_scripts_lead_somewhere(change: Change, told: str) -> None:
    facts = facts_of("wheels", change)
    text = change.get("setup.py", "") or ""
    found = []
    for each in facts.entries:
        old, _, new = text.partition(" -> ")
        said = PYTHON["wheels/setup.py"].replace(old, new)
        part = said[each.place.span.start : each.place.span.end]
        if "together" in each.message:
            part = "?"
        sure = "|sure" if each.is_sure else ""
        found.append(f"{part}|{each.message}|{each.remedy}{sure}")
    assert "; ".join(found) == told


_CFG = "[options.entry_points]\nconsole_scripts =\n    a = wheels.a:main\n"
_NONE = "    entry_points={'console_scripts': ['mover = wheels.mover:main']}, -> "


@pytest.mark.parametrize(
    ("change", "said"),
    [
        # What `setup` is called with counts before the setup.cfg.
        ({"setup.cfg": _CFG}, ""),
        ({"setup.cfg": _CFG, "setup.py": _NONE}, "a"),
        ({"setup.cfg": "[metadata]\nname = wheels\n", "setup.py": _NONE}, ""),
        ({"setup.py": f"{_NONE}**more"}, "unknown"),
        ({"setup.py": f"{_NONE}**{{'version': '1'}}"}, ""),
        (
            {
                "setup.py": "['mover = wheels.mover:main']}, -> ['mover = wheels.mover:main']}, **more"
            },
            "",
        ),
    ],
)
def test_where_console_scripts_are_said(change: Change, said: str) -> None:
    facts = facts_of("wheels", change)
    assert ("" if facts.is_settled else "unknown") or " ".join(
        each.name for each in facts.entries
    ) == said


@pytest.mark.parametrize(
    ("module", "files", "help_"),
    [
        (
            "wheels.tool",
            {"tools/tool.py": ""},
            "`tools/tool.py` is there: the module would be `wheels/tool.py`",
        ),
        (
            "wheels.tool",
            {"test/test_tool.py": ""},
            "`test/test_tool.py` is there: the module would be `wheels/tool.py`",
        ),
        ("wheels.tool", {"a/tool.py": "", "b/tool.py": ""}, ""),
        ("wheels.tool", {"a/tools.py": ""}, ""),
    ],
)
def test_module_that_is_elsewhere(module: str, files: Change, help_: str) -> None:
    change = {"setup.py": f"{_NAMES} -> {module}:main", **files}
    assert [each.help for each in facts_of("wheels", change).entries] == [help_]


_TOP = [
    ("def main(): pass", True),
    ("async def main(): pass", True),
    ("class main: pass", True),
    ("main = other", True),
    ("a, main = 1, 2", True),
    ("if x:\n    def main(): pass", True),
    ("try:\n    from a import main\nexcept ImportError:\n    main = None", True),
    ("import main", True),
    ("from a import other as main", True),
    ("from a import main as other", True),
    ("for main in x: pass", True),
    ("with x as y:\n    main = y", True),
    ("@deco\ndef main(): pass", True),
    ("x = (main := 1)", True),
    ("from a import *", True),
    ("def __getattr__(name): pass", True),
    ("exec('x')", True),
    ("globals()['main'] = 1", False),
    ("setattr(a, 'main', 1)", True),
    ("def (", True),
    ("other = 1", False),
    ("def other():\n    main = 1", False),
    ("class A:\n    def main(self): pass", False),
    ("print(main)", False),
]


@pytest.mark.parametrize(("text", "may_have"), _TOP)
def test_names_that_a_module_has(text: str, may_have: bool) -> None:
    entries = facts_of("wheels", {_PY: f"{text}\n"}).entries
    assert [each.message for each in entries] == (
        [] if may_have else ["`wheels.mover` has no `main`"]
    )
