"""What settings of clang-format say, and what an edit makes of them."""

from __future__ import annotations

import pytest
from additions import provide
from patches import CATALOGS

from plastron_tui.model.source import FileSet
from plastron_tui.sources import find_language
from plastron_tui.sources.cpp.editing import edit_cpp
from plastron_tui.sources.cpp.editing.clang_format import (
    ClangFormat,
    clang_format_of,
    parse_clang_format,
)


@pytest.mark.parametrize(
    ("text", "wanted"),
    [
        ("", ClangFormat()),
        ("BasedOnStyle: Google\n", ClangFormat(80, "  ", False, "& ", "    ", True)),
        (
            "---\nBasedOnStyle: Google\nColumnLimit: 100\nBreakBeforeBraces: Allman\n...\n",
            ClangFormat(100, "  ", True, "& ", "    ", True),
        ),
        ("ColumnLimit: 0\nUseTab: Always\nIndentWidth: 4\n", ClangFormat(120, "\t", None, None)),
        ("Language: Java\nColumnLimit: 60\n---\nIndentWidth: '4'\n", ClangFormat(None, "    ")),
        ("PointerAlignment: Middle\n", ClangFormat(reference=" & ")),
    ],
)
def test_settings_are_read(text, wanted):
    assert parse_clang_format(text.encode()) == wanted


def test_the_nearest_settings_count(tmp_path):
    (tmp_path / "a" / "src").mkdir(parents=True)
    (tmp_path / ".clang-format").write_text("IndentWidth: 3\n")
    assert clang_format_of(tmp_path / "a/src/x.cpp").indent == "   "
    (tmp_path / "a/.clang-format").write_text("IndentWidth: 5\n")
    assert clang_format_of(tmp_path / "a/src/x.cpp").indent == "     "


def test_a_file_without_a_layout_of_its_own_gets_that_of_the_settings(tmp_path):
    (tmp_path / ".clang-format").write_text(
        "IndentWidth: 3\nBreakBeforeBraces: Allman\nColumnLimit: 60\nPointerAlignment: Right\n"
    )
    text = b'#include <ros/ros.h>\nint main(int c, char** v) { ros::init(c, v, "a");'
    text += b" ros::NodeHandle nh; ros::spin(); }\n"
    source = find_language("cpp").read(tmp_path / "x.cpp", FileSet.single(".cpp", text)).source
    files = edit_cpp(source, [provide("go")], CATALOGS[1]).files
    lines = [x for x in files.main.decode().splitlines() if x.encode() not in text]
    assert max(map(len, lines)) <= 60
    assert files.main.startswith(b"#include <ros/ros.h>\n#include <std_srvs/SetBool.h>\n")
    assert b"\n{\n" in files.main
    assert "\n   std_srvs::SetBool::Request &req,\n" in files.main.decode()
