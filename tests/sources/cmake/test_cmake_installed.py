"""What CMake itself installs before and after a change: an edit adds its file and nothing else."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from machine import examples

from plastron_tui.sources.cmake import programs, shares

SCRIPTS = ["scripts/a.py", "scripts/b.py", "scripts/c.py"]
FILES = [*SCRIPTS, "scripts/new.py", "launch/a.launch", "launch/new.launch", "new.launch", "x.txt"]
FILES += ["config/a.yaml"]
# Stands in for ament, which installs nothing of these by itself.
AMENT = "macro(ament_package)\nendmacro()\n"
TAILS = [
    *("", "", "COMPONENT nodes", "CONFIGURATIONS Debug", "EXCLUDE_FROM_ALL", "OPTIONAL"),
    *("PERMISSIONS OWNER_READ", "PERMISSIONS OWNER_READ OWNER_EXECUTE"),
]
PROGRAMS = st.lists(st.sampled_from(SCRIPTS), min_size=1, max_size=3, unique=True).map(" ".join)
LISTED = st.sampled_from(["${X}", "scripts/a.py scripts/b.py", "scripts/new.py"])
INSTALLED = st.builds(
    "install(PROGRAMS {} DESTINATION lib/{} {})".format,
    LISTED,
    st.sampled_from(["${PROJECT_NAME}", "rover", "rover", "other"]),
    st.sampled_from(TAILS),
)
OTHERS = st.sampled_from(
    [
        "install(PROGRAMS scripts/a.py DESTINATION lib/rover RENAME a)",
        "list(APPEND X scripts/c.py)",
        "foreach(each IN LISTS X)\n  configure_file(${each} out/${each} COPYONLY)\nendforeach()",
        "foreach(each IN LISTS X)\n  configure_file(${each} out/${each} COPYONLY)\nendforeach()\n"
        "install(PROGRAMS ${X} DESTINATION lib/rover)",
        "foreach(each ${X})\n  install(PROGRAMS ${each} DESTINATION lib/rover)\nendforeach()",
        "list(LENGTH X count)\nfile(WRITE ${CMAKE_BINARY_DIR}/out/count ${count})",
        "if(X)\n  install(PROGRAMS scripts/b.py DESTINATION lib/rover)\nendif()",
        "if(GONE)\n  install(PROGRAMS scripts/new.py DESTINATION lib/rover)\nendif()",
        "function(more)\n  install(PROGRAMS ${X} DESTINATION share/more)\nendfunction()\nmore()",
        "install(DIRECTORY config DESTINATION share/rover)",
        "install(DIRECTORY config DESTINATION share/rover CONFIGURATIONS Debug)",
        "install(DIRECTORY launch DESTINATION share/rover CONFIGURATIONS Debug)",
        "install(DIRECTORY config DESTINATION share/rover EXCLUDE_FROM_ALL)",
        'install(DIRECTORY config DESTINATION share/rover PATTERN "*.launch" EXCLUDE)',
        "install(FILES x.txt DESTINATION share/rover)",
        "install(FILES x.txt DESTINATION share/rover RENAME y.txt)",
        "install(FILES x.txt DESTINATION share/rover CONFIGURATIONS Debug)",
    ]
)
EDITS = {
    "scripts/new.py": (programs, "program", "lib/rover/new.py"),
    "launch/new.launch": (shares, "shared", "share/rover/launch/new.launch"),
    "new.launch": (shares, "shared", "share/rover/new.launch"),
}


@st.composite
def texts(draw: st.DrawFn) -> str:
    first = draw(PROGRAMS.map("set(X {})".format))
    blocks = draw(st.lists(INSTALLED | OTHERS, max_size=4))
    lines = ["cmake_minimum_required(VERSION 3.8)", "project(rover NONE)"]
    return "\n".join(
        [*lines, "find_package(ament_cmake REQUIRED)", first, *blocks, "ament_package()"]
    )


def installed(text: bytes, root: Path) -> dict[str, bool]:
    """Return what CMake installs and writes for a CMakeLists.txt, and whether that may be run."""
    (root / "source/CMakeLists.txt").write_bytes(text)
    for each in ("build", "prefix"):
        shutil.rmtree(root / each, ignore_errors=True)
    build, prefix = str(root / "build"), str(root / "prefix")
    made = f"-DCMAKE_BUILD_TYPE=Release|-Dament_cmake_DIR={root / 'ament'}".split("|")
    for command in (
        ["cmake", "-S", str(root / "source"), "-B", build, *made],
        ["cmake", "--install", build, "--prefix", prefix],
    ):
        done = subprocess.run(command, capture_output=True, text=True, timeout=60, check=False)
        assert done.returncode == 0, done.stderr
    return {
        str(each.relative_to(root)): bool(each.stat().st_mode & 0o100)
        for each in (*root.glob("prefix/**/*"), *root.glob("build/out/**/*"))
        if each.is_file()
    }


@pytest.mark.long(2)
@pytest.mark.skipif(shutil.which("cmake") is None, reason="there is no CMake")
@settings(
    max_examples=examples(200),
    deadline=None,
    suppress_health_check=[HealthCheck.function_scoped_fixture],
)
@given(texts(), st.sampled_from(["scripts/new.py", "scripts/new.py", *EDITS]))
def test_cmake_installs_what_was_added_and_nothing_else(
    tmp_path: Path, text: str, file: str
) -> None:
    for each in FILES:
        path = tmp_path / "source" / each
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text("")
    (tmp_path / "ament").mkdir(exist_ok=True)
    (tmp_path / "ament/ament_cmakeConfig.cmake").write_text(AMENT)
    module, name, target = EDITS[file]
    path = Path("CMakeLists.txt")
    edited = getattr(module, f"add_{name}")(text.encode(), path, file)
    if edited.text is None:
        assert edited.diagnostics
        return
    before, after = installed(text.encode(), tmp_path), installed(edited.text, tmp_path)
    is_program = name == "program"
    assert f"prefix/{target}" in after
    assert not is_program or after[f"prefix/{target}"]
    folder = f"prefix/{target}".rpartition("/")[0]
    more = {each: runs for each, runs in after.items() if before.get(each) != runs}
    # The folder of a launch file is installed whole.
    beside = {f"{folder}/a.launch"} if file.startswith("launch/") else set()
    assert set(more) <= {f"prefix/{target}", *beside}
    assert set(before) <= set(after)
    if edited.text != text.encode():
        back = getattr(module, f"remove_{name}")(edited.text, path, file)
        assert back.text == text.encode()
