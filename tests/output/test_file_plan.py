from __future__ import annotations

import os
from pathlib import Path

import pytest

from plastron_tui.diagnostics import codes
from plastron_tui.output.manifest import Manifest, digest
from plastron_tui.output.plan import FileState, OutputFile, make_plan

OURS = Manifest({"a.py": digest(b"ours")})
NONE = Manifest()

# before, mode before, manifest, wanted, merged_from, executable → state, remembered, code
STATES = {
    "missing": (None, 0, NONE, b"new", None, True, "create", True, None),
    "missing though remembered": (None, 0, OURS, b"new", None, True, "create", True, None),
    "same": (b"new", 0o755, NONE, b"new", None, True, "identical", True, None),
    "same without the bit": (b"#!", 0o644, NONE, b"#!", None, True, "changed", True, None),
    "same that none can run": (b"new", 0o644, NONE, b"new", None, True, "identical", True, None),
    "read-only and without the bit": (
        *(b"#!", 0o444, NONE, b"#!", None, True, "identical", True, None),
    ),
    "same and no bit wanted": (b"new", 0o644, NONE, b"new", None, False, "identical", True, None),
    "ours": (b"ours", 0o755, OURS, b"new", None, True, "changed", True, None),
    "by hand": (b"hand", 0o755, OURS, b"new", None, True, "conflict", True, "file-conflict"),
    "unknown": (b"hand", 0o755, NONE, b"new", None, True, "conflict", True, "file-conflict"),
    "merged handwork": (b"hand", 0o755, OURS, b"new", b"hand", True, "changed", False, None),
    "merged unknown": (b"hand", 0o755, NONE, b"new", b"hand", True, "changed", False, None),
    "merged ours": (b"ours", 0o755, OURS, b"new", b"ours", True, "changed", True, None),
    "merged to the same": (b"hand", 0o755, NONE, b"hand", b"hand", True, "identical", False, None),
    "stale merge": (b"x", 0o755, OURS, b"new", b"hand", True, "conflict", False, "changed-on-disk"),
    "stale merge of ours": (
        *(b"ours", 0o755, OURS, b"new", b"hand", True, "conflict", False, "changed-on-disk"),
    ),
    "merge of a file that is gone": (
        *(None, 0, OURS, b"new", b"hand", True, "conflict", False, "changed-on-disk"),
    ),
    "not UTF-8": (b"\xff\r\n\0", 0o755, NONE, b"\xff\r\n\0", None, True, "identical", True, None),
    "other line ends": (
        b"a\r\n",
        0o755,
        NONE,
        b"a\n",
        None,
        True,
        "conflict",
        True,
        "file-conflict",
    ),
}


@pytest.mark.parametrize("case", STATES.values(), ids=STATES)
def test_state(tmp_path: Path, case) -> None:
    before, mode, manifest, wanted, merged_from, is_executable, state, is_remembered, code = case
    if before is not None:
        (tmp_path / "a.py").write_bytes(before)
        (tmp_path / "a.py").chmod(mode)
    plan, diagnostics = make_plan(
        tmp_path, [OutputFile("a.py", wanted, is_executable, merged_from)], manifest
    )
    assert diagnostics == ()
    (file,) = plan.files
    assert (file.state, file.before, file.text) == (FileState(state), before, wanted)
    assert file.entry == ("a.py" if is_remembered else None)
    assert [conflict.code for conflict in plan.conflicts] == ([code] if code else [])


def test_a_plan_changes_nothing(tmp_path: Path) -> None:
    folder = tmp_path / "deep" / "output"
    make_plan(folder, [OutputFile("a.py", b"x")], NONE)
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    "name",
    [
        *("", ".", "..", "../x.py", "/etc/x.py", "a/../b.py", "a\\b.py", "a\0b.py", "a\nb.py"),
        *("\ud800.py", "\u202egpj.py", ".plastron.json", ".plastron-0.new", "\x1b[2J.py"),
    ],
)
def test_a_name_that_leads_elsewhere(tmp_path: Path, name: str) -> None:
    plan, diagnostics = make_plan(tmp_path, [OutputFile(name, b"x")], NONE)
    assert plan.files == ()
    assert [diagnostic.code for diagnostic in diagnostics] == ["outside-output"]
    diagnostics[0].message.encode()  # can be printed


def test_links(tmp_path: Path) -> None:
    folder = tmp_path / "output"
    (folder / "sub").mkdir(parents=True)
    (tmp_path / "victim.py").write_bytes(b"mine")
    (tmp_path / "output2").mkdir()  # shares a prefix with the folder, and is outside
    inside, outside = folder / "real.py", tmp_path / "victim.py"
    inside.write_bytes(b"x")
    links = {
        "out.py": (outside, "outside-output"),
        "relative.py": (Path("../victim.py"), "outside-output"),
        "sibling.py": (tmp_path / "output2" / "x.py", "outside-output"),
        "dangling.py": (tmp_path / "nothing.py", "outside-output"),
        "loop.py": (Path("loop.py"), "cannot-write"),
        "folder.py": (Path("sub"), "cannot-write"),
    }
    for name, (target, code) in links.items():
        (folder / name).symlink_to(target)
        plan, diagnostics = make_plan(folder, [OutputFile(name, b"x")], NONE)
        assert ([d.code for d in diagnostics], plan.files) == ([code], ()), name
    (folder / "in.py").symlink_to("real.py")
    plan, diagnostics = make_plan(folder, [OutputFile("in.py", b"x", False)], NONE)
    assert diagnostics == ()
    assert (plan.files[0].path, plan.files[0].state) == (inside, FileState.IDENTICAL)


def test_what_is_no_file_is_not_read(tmp_path: Path) -> None:
    (tmp_path / "folder.py").mkdir()
    os.mkfifo(tmp_path / "pipe.py")  # reading it would wait for ever
    files = [OutputFile("folder.py", b""), OutputFile("pipe.py", b"")]
    plan, diagnostics = make_plan(tmp_path, files, NONE)
    assert plan.files == ()
    assert [diagnostic.code for diagnostic in diagnostics] == ["cannot-write"] * 2


def test_a_linked_output_folder(tmp_path: Path) -> None:
    program, elsewhere = tmp_path / "program", tmp_path / "elsewhere"
    program.mkdir()
    elsewhere.mkdir()
    (program / "output").symlink_to(elsewhere)
    files = [OutputFile("a.py", b"")]
    _, refused = make_plan(program / "output", files, NONE, within=program)
    assert [diagnostic.code for diagnostic in refused] == ["outside-output"]
    plan, diagnostics = make_plan(program / "output", files, NONE)
    assert diagnostics == ()
    assert plan.files[0].path == elsewhere / "a.py"


@pytest.mark.parametrize("folder", ["file", "file/below", "with\0nul", "\ud800"])
def test_a_folder_that_is_none(tmp_path: Path, folder: str) -> None:
    (tmp_path / "file").write_bytes(b"")
    plan, diagnostics = make_plan(tmp_path / folder, [OutputFile("a.py", b"")], NONE)
    assert plan.files == ()
    assert [diagnostic.code for diagnostic in diagnostics] == ["cannot-write"]


def test_one_file_asked_for_twice(tmp_path: Path) -> None:
    same = [OutputFile("a.py", b"x"), OutputFile("a.py", b"x")]
    plan, diagnostics = make_plan(tmp_path, same, NONE)
    assert (len(plan.files), diagnostics) == (1, ())
    other = [OutputFile("a.py", b"x"), OutputFile("a.py", b"y")]
    _, diagnostics = make_plan(tmp_path, other, NONE)
    assert [diagnostic.code for diagnostic in diagnostics] == ["same-file"]


@pytest.mark.parametrize(
    ("name", "what", "is_loaded"),
    [
        ("a.py", "texts", False),
        ("x.launch", "launch files", True),
        ("x.launch.xml", "launch files", True),
        ("x.launch.py", "launch files", True),
        ("demo/msg/A.msg", "message types", True),
        ("A.srv", "service types", True),
        ("A.action", "action types", True),
    ],
)
def test_what_one_file_was_asked_for_by_is_named(
    name: str, what: str, is_loaded: bool, tmp_path: Path
) -> None:
    _, [found] = make_plan(tmp_path, [OutputFile(name, b"x"), OutputFile(name, b"y")], NONE)
    assert found.message == f"two {what} would be written to `{name}`"
    assert ("--in-place" in (found.help or "")) == is_loaded


def test_in_place(tmp_path: Path) -> None:
    source = tmp_path / "src" / "hand.py"
    source.parent.mkdir()
    source.write_bytes(b"old")
    (tmp_path / "link.py").symlink_to(source)
    wanted = OutputFile("link.py", b"new", False, b"old", tmp_path / "link.py")
    plan, diagnostics = make_plan(tmp_path / "output", [wanted], NONE)
    assert diagnostics == ()
    (file,) = plan.files
    assert (file.path, file.state, file.entry) == (source, FileState.CHANGED, None)


def test_every_code_is_declared() -> None:
    assert {
        *("cannot-write", "outside-output", "file-conflict"),
        *("changed-on-disk", "same-file", "bad-manifest"),
    } <= codes.CODES.keys()


IN_THE_WAY = {
    "a file": ("file", "rover", "cannot-write"),
    "a file further down": ("file", "rover/test", "cannot-write"),
    "a link to a file": ("link to a file", "rover", "cannot-write"),
    "a circle of links": ("link to itself", "rover", "cannot-write"),
    "a link that leads out": ("link out", "rover", "outside-output"),
}


@pytest.mark.parametrize(("what", "where", "code"), IN_THE_WAY.values(), ids=list(IN_THE_WAY))
def test_what_is_in_the_way_of_a_folder_is_told_once(
    tmp_path: Path, what: str, where: str, code: str
) -> None:
    output, path = tmp_path / "output", tmp_path / "output" / where
    path.parent.mkdir(parents=True)
    (tmp_path / "elsewhere").mkdir()
    if what == "file":
        path.write_bytes(b"")
    elif what == "link to a file":
        (output / "file").write_bytes(b"")
        path.symlink_to("file")
    else:
        path.symlink_to(path.name if what == "link to itself" else tmp_path / "elsewhere")
    names = ("rover/test/a.py", "rover/test/b.py", "rover/test/deep/c.py", "other/d.py")
    files = [OutputFile(name, b"") for name in names]
    plan, diagnostics = make_plan(output, files, NONE)
    assert [(each.code, each.file) for each in diagnostics] == [(code, path)]
    assert [each.name for each in plan.files] == ["other/d.py"]
