"""Of any file that is put together of common parts: what is added is there, and goes again."""

from __future__ import annotations

from pathlib import Path

from hypothesis import given, settings
from hypothesis import strategies as st
from machine import examples

from plastron_tui.sources.cmake import dependencies, interfaces, programs, shares
from plastron_tui.sources.cmake.facts import facts
from plastron_tui.sources.cmake.reader import read_cmake

PATH = Path("CMakeLists.txt")
PAIRS = [
    (programs.add_program, programs.remove_program, "scripts/new.py"),
    (dependencies.add_dependency, dependencies.remove_dependency, "new_msgs"),
    (dependencies.add_exported, dependencies.remove_exported, "new_msgs"),
    (shares.add_shared, shares.remove_shared, "launch/new.launch.xml"),
    (interfaces.add_interface, interfaces.remove_interface, "msg/New.msg"),
    (
        interfaces.add_interface_dependency,
        interfaces.remove_interface_dependency,
        "new_msgs",
    ),
]
SPACES = st.sampled_from([" ", "\n  ", "\n\t", "\n    ", " # why\n  ", "\n  # what\n  "])
ENDS = st.sampled_from(["", "\n", " ", " # end\n"])
WORDS = st.sampled_from(
    [
        "scripts/a.py",
        '"scripts/b.py"',
        "zed",
        "a;b",
        "${X}",
        "${Y}",
        "$<IF:1,a,b>",
        "[[c]]",
        "m.msg",
    ]
)
OPENINGS = [
    "install(PROGRAMS",
    "install(DIRECTORY",
    "INSTALL(TARGETS x DESTINATION",
    "catkin_install_python(PROGRAMS",
    "set(X",
    "list(APPEND X",
    "find_package(zed",
    "find_package(catkin REQUIRED COMPONENTS",
    "catkin_package(CATKIN_DEPENDS",
    "catkin_package(",
    "rosidl_generate_interfaces(${PROJECT_NAME}",
    "add_message_files(FILES",
    "generate_messages(DEPENDENCIES",
    "message(",
]
TAILS = [
    *("", "DESTINATION lib/${PROJECT_NAME}", "DESTINATION share/rover", "DEPENDENCIES std_msgs"),
    "DESTINATION lib/rover CONFIGURATIONS Debug",
    "DESTINATION lib/rover PERMISSIONS OWNER_READ",
    "DESTINATION lib/rover RENAME other",
    "DESTINATION share/rover EXCLUDE_FROM_ALL",
]


@st.composite
def calls(draw: st.DrawFn) -> str:
    text = draw(st.sampled_from(OPENINGS))
    words = [*draw(st.lists(WORDS, max_size=4)), *draw(st.sampled_from(TAILS)).split()]
    for word in words:
        text += draw(SPACES) + word
    return text + draw(ENDS) + ")"


BLOCKS = st.one_of(
    calls(),
    calls().map(lambda call: f"if(BUILD_TESTING)\n{call}\nendif()"),
    calls().map(lambda call: f"foreach(Y a b)\n{call}\nendforeach()"),
    calls().map(lambda call: f"foreach(Y IN LISTS X)\n{call}\nendforeach()"),
    calls().map(lambda call: f"function(f X)\n{call}\nendfunction()\nf(a)"),
    st.sampled_from(
        ["# note", "#########\n## Install ##\n#########", "#########", "ament_package()"]
    ),
)


@st.composite
def files(draw: st.DrawFn) -> bytes:
    kind = draw(st.sampled_from(["ament_cmake", "catkin"]))
    text = f"project(rover)\nfind_package({kind} REQUIRED)"
    for block in draw(st.lists(BLOCKS, max_size=7)):
        text += draw(st.sampled_from(["\n", "\n\n", "\n\n\n"])) + block
    text += draw(st.sampled_from(["", "\n", "\n\n"]))
    return text.replace("\n", draw(st.sampled_from(["\n", "\n", "\r\n"]))).encode()


@settings(max_examples=examples(150), deadline=None)
@given(files(), st.sampled_from(PAIRS))
def test_what_is_added_goes_again(text, pair) -> None:  # type: ignore[no-untyped-def]
    add, remove, value = pair
    before = read_cmake(text, PATH).lists
    edited = add(text, PATH, value)
    if edited.text is None:
        assert edited.diagnostics
        return
    after = read_cmake(edited.text, PATH).lists
    assert before is not None
    assert after is not None
    assert (facts(after) - facts(before)).total() == (edited.text != text)
    assert not facts(before) - facts(after)
    if edited.text != text:
        assert remove(edited.text, PATH, value) == (text, ())


@settings(max_examples=examples(100), deadline=None)
@given(st.binary(max_size=60) | st.text('()[]"#${}\\\n ifendset', max_size=60).map(str.encode))
def test_any_bytes_are_read_or_refused(text: bytes) -> None:
    for add, remove, value in PAIRS:
        for edit in (add, remove):
            edited = edit(text, PATH, value)
            assert (edited.text is None) == bool(edited.diagnostics)
