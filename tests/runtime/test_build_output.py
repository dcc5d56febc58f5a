"""What build tools print, read: each output is that of a tool that was given such a mistake."""

from __future__ import annotations

import io
from pathlib import Path

import pytest

from plastron_tui.diagnostics import Span
from plastron_tui.runtime.build_output import MOST_ERRORS, Progress, errors_of, progress_of
from plastron_tui.runtime.build_progress import ProgressLine

STATEMENT, LINE = Span(0, 10), Span(20, 30)


@pytest.mark.parametrize(
    ("line", "after"),
    [
        ("Starting >>> rover_msgs", Progress("rover_msgs", "configure")),
        ("[  4%] Generating Python from MSG demo/Level", Progress("demo", "build", 4)),
        ("[100%] Built target demo", Progress("demo", "build", 100)),
        ("[999%] Built target demo", Progress("demo", "build", 100)),
        ("-- Install configuration: \"\"", Progress("demo", "install", 100)),
        ("-- Installing: /w/install/share/demo/package.xml", Progress("demo", "install", 100)),
        ("-- Configuring done", Progress("demo", "configure")),
        ("x [ 42%] of what a compiler says", Progress("demo", "configure")),
        ("[ xx%] no number", Progress("demo", "configure")),
    ],
)  # fmt: skip
def test_progress(line: str, after: Progress) -> None:
    assert progress_of(line, Progress("demo", "configure")) == after


GCC = """\
{source}/demo/src/a.cpp: In function ‘int f()’:
{source}/demo/src/a.cpp:2:10: error: ‘x’ was not declared in this scope
    2 |   return x + 1;
      |          ^
/usr/include/c++/12/vector:2:10: error: of another file
make[2]: *** [CMakeFiles/a.dir/build.make:76: CMakeFiles/a.dir/a.cpp.o] Error 1
"""
INVALID = """\
  File "/usr/lib/python3/dist-packages/genmsg/msg_loader.py", line 289, in load_msg_from_file
    raise InvalidMsgSpec('%s: %s'%(file_path, e))
genmsg.base.InvalidMsgSpec: {source}/demo/msg/Level.msg: 9x is not a legal message field name
CMake Error at /usr/share/catkin/cmake/safe_execute_process.cmake:11 (message):
  execute_process(/w/build/catkin_generated/env_cached.sh
"""
NEEDS = """\
CMake Error at /w/build/demo/cmake/demo-genmsg.cmake:3 (message):
  Could not find messages which
  '{source}/demo/msg/Level.msg'
  depends on.  Did you forget to specify generate_messages(DEPENDENCIES ...)?

  Cannot locate message [Nowhere] in package [demo] with paths
  [['{source}/demo/msg']]
Call Stack (most recent call first):
"""
GENPY = """\

ERROR: Unable to generate messages for package 'demo': while processing \
'{share}/demo/msg/Level.msg': Cannot locate message [Foo]: unknown package [nopkg] on search path \
[{{'demo': ['{share}/demo/msg']}}]

"""
GENPY_NEEDED = """\
ERROR: Unable to generate messages for package 'demo': while processing \
'{share}/demo/msg/Levels.msg': Cannot generate .msg for demo/Levels: \
{share}/demo/msg/Level.msg: 9x is not a legal message field name
"""
ADAPTER = """\
CMake Error at /v/share/rosidl_adapter/cmake/rosidl_adapt_interfaces.cmake:57 (message):
  returned error code 1:

  Error processing 'int32 9x' of 'demo/Level': ''9x' is an invalid
  field name.  It should have the pattern '^[a-z]*$''

  Traceback (most recent call last):

    File "<frozen runpy>", line 198, in _run_module_as_main
"""
GENERATOR = """\
    pkg_dir = include_map[pkg]
KeyError: 'nopkg'
gmake[2]: *** [CMakeFiles/demo__rosidl_generator_type_description.dir/build.make:79: \
rosidl_generator_type_description/demo/msg/Level.json] Error 1
gmake[1]: *** [CMakeFiles/Makefile2:215: CMakeFiles/demo.dir/all] Error 2
"""
CMAKE = """\
Starting >>> demo
CMake Error at CMakeLists.txt:5 (find_package):
  By not providing "Findno_such.cmake" in CMAKE_MODULE_PATH this project has
  asked CMake to find a package configuration file provided by "no_such", but
  CMake did not find one.

"""


@pytest.mark.parametrize(
    ("output", "place", "said", "span"),
    [
        (GCC, "src/a.cpp:2", "‘x’ was not declared in this scope", None),
        (INVALID, "msg/Level.msg", "9x is not a legal message field name", STATEMENT),
        (NEEDS, "msg/Level.msg", "Cannot locate message [Nowhere] in package [demo]", STATEMENT),
        (GENPY, "msg/Level.msg", "Cannot locate message [Foo]: unknown package [nopkg]", STATEMENT),
        (GENPY_NEEDED, "msg/Level.msg", "9x is not a legal message field name", STATEMENT),
        (
            ADAPTER,
            "msg/Level.msg:2",
            "'9x' is an invalid field name.  It should have the pattern '^[a-z]*$'",
            LINE,
        ),
        (GENERATOR, "msg/Level.msg", "KeyError: 'nopkg'", STATEMENT),
        (
            CMAKE,
            "CMakeLists.txt:5",
            'By not providing "Findno_such.cmake" in CMAKE_MODULE_PATH this project has asked '
            'CMake to find a package configuration file provided by "no_such", but CMake did not '
            "find one",
            None,
        ),
    ],
)
def test_errors(output: str, place: str, said: str, span: Span | None, tmp_path: Path) -> None:
    source, share = tmp_path / "src", tmp_path / "install" / "share"
    definition = source / "demo" / "msg" / "Level.msg"
    definition.parent.mkdir(parents=True)
    definition.write_text("float64 value\nint32  9x\n")
    spans = {"demo": {"msg/Level.msg": {0: STATEMENT, 2: LINE}}}
    # colcon prints what came to the standard error twice.
    lines = output.format(source=source, share=share).splitlines() * 2
    [found] = errors_of(lines, source, spans, "read it")
    assert found.message == f"`demo/{place}` could not be built: {said}"
    assert (found.span, found.help) == (span, "read it")


GENERATED = "{build}/demo/rosidl_generator_c/demo/msg/detail/wheel_speed__struct.h:25:12: error: "
GENERATED_PYTHON = "{build}/demo/rosidl_generator_py/demo/msg/_wheel_speed_s.c:9:2: error: "
MISSING = """\
KeyError: '{package}'
gmake[2]: *** [CMakeFiles/a.dir/build.make:77: generator/demo/msg/Axle.json] Error 1
"""


@pytest.mark.parametrize(
    ("output", "said"),
    [
        (f"{GENERATED}expected ‘;’ before ‘}}’", ["msg/WheelSpeed.msg: expected ‘;’ before ‘}’"]),
        (f"{GENERATED_PYTHON}no", ["msg/WheelSpeed.msg: no"]),
        # One message a field; what names none follows from it.
        (
            f"{GENERATED}no\n{GENERATED}bad ‘class’\n{GENERATED}bad 'class' too\n"
            f"{GENERATED}bad ‘and’ token",
            ["msg/WheelSpeed.msg:2: bad ‘class’", "msg/WheelSpeed.msg:3: bad ‘and’ token"],
        ),
        # Which of two definitions it is, nothing says.
        (GENERATED.replace("wheel_speed", "level") + "no", []),
        (GENERATED.replace("/demo/", "/other/") + "no", []),
        (GENERATED.replace("{build}/", "/usr/") + "no", []),
        # make names the first of all definitions that a generator is given.
        (MISSING.replace("{package}", "nopkg"), ["msg/WheelSpeed.msg: KeyError: 'nopkg'"]),
        (MISSING.replace("{package}", "unknown"), []),
    ],
)
def test_errors_of_what_is_generated(output: str, said: list[str], tmp_path: Path) -> None:
    messages = tmp_path / "src" / "demo" / "msg"
    messages.mkdir(parents=True)
    for name in ("Axle", "Level", "LEVEL"):
        (messages / f"{name}.msg").write_text("float64 value\n")
    (messages / "WheelSpeed.msg").write_text("nopkg/Foo foo\nint8 class\nint8  and  # it\n")
    lines = output.replace("{build}", str(tmp_path / "build")).splitlines()
    found = errors_of(lines, tmp_path / "src", {"demo": {}}, "read it")
    expected = []
    for each in said:
        place, _, message = each.partition(": ")
        expected.append(f"`demo/{place}` could not be built: {message}")
    assert [each.message for each in found] == expected


@pytest.mark.parametrize(
    "output",
    [
        "all is well",
        "/elsewhere/demo/a.cpp:1:1: error: not of the package",
        "{source}/other/a.cpp:1:1: error: of a package that is not built",
        "{source}/demo/a.cpp:1:1: warning: no error",
        "{source}:1:1: error: a folder",
        "gmake[2]: *** [a: b/demo/msg/Level.json] Error 1",
        "\x00: \x1b[31m[",
    ],
)
def test_what_is_no_error_of_a_package(output: str, tmp_path: Path) -> None:
    lines = output.format(source=tmp_path / "src").splitlines()
    assert not errors_of(lines, tmp_path / "src", {"demo": {}}, "read it")


def test_there_is_an_end_to_errors(tmp_path: Path) -> None:
    lines = [f"{tmp_path}/demo/a.cpp:{number}:1: error: no" for number in range(20_000)]
    lines += ["Error processing '" + "' of '" * 5000, "  " + "x" * 100_000] * 10
    assert len(errors_of(lines, tmp_path, {"demo": {}}, "read it")) == MOST_ERRORS


class Terminal(io.StringIO):
    def isatty(self) -> bool:
        return True


STEPS = [
    Progress("demo", "configure"),
    Progress("demo", "build", 10),
    Progress("demo", "build", 20),
    Progress("demo", "build", 30),
    Progress("de\x1bmo", "install", 100),
]


def test_progress_in_lines() -> None:
    stream = io.StringIO()
    with ProgressLine(stream, "once") as line:
        assert not stream.getvalue()
        for each in STEPS:
            line.tell(each)
    assert stream.getvalue().splitlines() == [
        "once",
        "building `demo`: configure",
        "building `demo`: build, 10 %",
        "building `demo`: build, 30 %",
        "building `de\\x1bmo`: install, 100 %",
    ]


def test_progress_on_a_terminal_is_drawn_over() -> None:
    stream = Terminal()
    with ProgressLine(stream) as line:
        for each in STEPS:
            line.tell(each)
    written = stream.getvalue()
    assert "\n" not in written
    assert written.count("\r") == len(STEPS) + 2
    # Nothing of a longer line is left over.
    screen = ""
    for part in written.split("\r"):
        screen = part + screen[len(part) :]
    assert not screen.strip()
