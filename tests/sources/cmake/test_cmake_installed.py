"""What CMake itself installs before and after a change: an edit adds its file and nothing else."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

import pytest
from hypothesis import HealthCheck, Phase, given, settings
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
        "list(LENGTH X count)\nfile(WRITE ${PROJECT_BINARY_DIR}/out/count ${count})",
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


def configured(texts: list[bytes], root: Path) -> list[dict[str, bool]]:
    """Return what CMake installs and writes for each CMakeLists.txt, and whether that may be run.

    Each is a project by itself in a folder of its own. To start CMake takes far longer than to
    configure one of them: it is started for all of them at once.
    """
    for each in ("source", "build", "prefix"):
        shutil.rmtree(root / each, ignore_errors=True)
    lines = ["cmake_minimum_required(VERSION 3.8)", "project(all NONE)"]
    script = []
    for number, text in enumerate(texts):
        folder = root / "source" / str(number)
        for name in FILES:
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            (folder / name).touch()
        (folder / "CMakeLists.txt").write_bytes(text)
        build, prefix = root / "build" / str(number), root / "prefix" / str(number)
        lines.append(f"add_subdirectory({number})")
        script += [
            f'set(CMAKE_INSTALL_PREFIX "{prefix}")',
            f'include("{build}/cmake_install.cmake")',
        ]
    (root / "source/CMakeLists.txt").write_text("\n".join(lines))
    (root / "install.cmake").write_text("\n".join(script))
    made = ["-DCMAKE_BUILD_TYPE=Release", f"-Dament_cmake_DIR={root / 'ament'}"]
    for command in (
        ["cmake", "-S", str(root / "source"), "-B", str(root / "build"), *made],
        ["cmake", "-P", str(root / "install.cmake")],
    ):
        done = subprocess.run(command, capture_output=True, text=True, timeout=60, check=False)
        assert done.returncode == 0, done.stderr
    return [_files(root, str(number)) for number in range(len(texts))]


def _files(root: Path, number: str) -> dict[str, bool]:
    prefix, build = root / "prefix" / number, root / "build" / number
    found = {f"prefix/{each.relative_to(prefix)}": each for each in prefix.rglob("*")}
    found |= {f"build/{each.relative_to(build)}": each for each in build.glob("out/**/*")}
    return {
        name: bool(each.stat().st_mode & 0o100) for name, each in found.items() if each.is_file()
    }


def edit(text: str, file: str) -> bytes | None:
    """Return a text with a file added, none where that is refused; taken out again it is gone."""
    module, name, _ = EDITS[file]
    path = Path("CMakeLists.txt")
    edited = getattr(module, f"add_{name}")(text.encode(), path, file)
    if edited.text is None:
        assert edited.diagnostics
    elif edited.text != text.encode():
        back = getattr(module, f"remove_{name}")(edited.text, path, file)
        assert back.text == text.encode()
    found: bytes | None = edited.text
    return found


TEXTS_AT_ONCE = 20
CHANGES = st.tuples(texts(), st.sampled_from(["scripts/new.py", "scripts/new.py", *EDITS]))


@pytest.mark.long(0.5)
@pytest.mark.skipif(shutil.which("cmake") is None, reason="there is no CMake")
@settings(
    max_examples=examples(10),
    deadline=None,
    # What fails names the one text that does, which is short.
    phases=[Phase.generate],
    suppress_health_check=[HealthCheck.function_scoped_fixture, HealthCheck.too_slow],
)
@given(st.lists(CHANGES, min_size=TEXTS_AT_ONCE, max_size=TEXTS_AT_ONCE))
def test_cmake_installs_what_was_added_and_nothing_else(
    tmp_path: Path, changes: list[tuple[str, str]]
) -> None:
    (tmp_path / "ament").mkdir(exist_ok=True)
    (tmp_path / "ament/ament_cmakeConfig.cmake").write_text(AMENT)
    edits = [(text, file, edit(text, file)) for text, file in changes]
    taken = [(text, file, edited) for text, file, edited in edits if edited is not None]
    both = [each for text, _, edited in taken for each in (text.encode(), edited)]
    found = configured(both, tmp_path)
    for (text, file, _), before, after in zip(taken, found[::2], found[1::2], strict=True):
        _, name, target = EDITS[file]
        is_program = name == "program"
        assert f"prefix/{target}" in after, text
        assert not is_program or after[f"prefix/{target}"], text
        folder = f"prefix/{target}".rpartition("/")[0]
        more = {each: runs for each, runs in after.items() if before.get(each) != runs}
        # The folder of a launch file is installed whole.
        beside = {f"{folder}/a.launch"} if file.startswith("launch/") else set()
        assert set(more) <= {f"prefix/{target}", *beside}, text
        assert set(before) <= set(after), text
