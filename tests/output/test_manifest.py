from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from plastron_tui.diagnostics import Diagnostic, codes
from plastron_tui.output.manifest import NAME, Manifest, digest, load_manifest, manifest_text
from plastron_tui.output.plan import OutputFile
from plastron_tui.output.writer import write

BROKEN = {
    "empty": b"",
    "not JSON": b"<<<<<<< HEAD\n{}",
    "not UTF-8": b"\xff\xfe{}",
    "deep": b"[" * 100_000,
    "a list": b"[]",
    "someone else's": b'{"version": 1, "files": {}}',
    "a later version": b'{"generator": "plastron", "version": 4, "files": {}}',
    "a version before all": b'{"generator": "plastron", "version": 0, "files": {}}',
    "an entry without anything": b'{"generator": "plastron", "version": 2, "files": {"a": {}}}',
    "an odd entry": b'{"generator": "plastron", "version": 2, "files": {"a": "sha256:0"}}',
    "an odd base": b'{"generator": "plastron", "version": 2, "files": {"a": {"base": []}}}',
    "no files": b'{"generator": "plastron", "version": 1}',
    "odd files": b'{"generator": "plastron", "version": 1, "files": []}',
    "odd digest": b'{"generator": "plastron", "version": 1, "files": {"a": 5}}',
    "short digest": b'{"generator": "plastron", "version": 1, "files": {"a": "sha256:0"}}',
}


@pytest.mark.parametrize("text", BROKEN.values(), ids=BROKEN)
def test_a_broken_manifest_is_a_warning_and_empty(tmp_path: Path, plan, text: bytes) -> None:
    (tmp_path / NAME).write_bytes(text)
    manifest, diagnostics = load_manifest(tmp_path)
    assert (dict(manifest.digests), manifest.is_foreign) == ({}, True)
    assert [(d.code, d.severity.value) for d in diagnostics] == [("bad-manifest", "warning")]
    result = write(plan(tmp_path, [OutputFile("a.py", b"x")]))
    assert result.diagnostics == ()
    assert (tmp_path / f"{NAME}.bak").read_bytes() == text
    assert load_manifest(tmp_path) == (Manifest({"a.py": digest(b"x")}), ())


def test_a_missing_manifest_is_no_mistake(tmp_path: Path) -> None:
    assert load_manifest(tmp_path) == (Manifest(), ())
    assert load_manifest(tmp_path / "missing") == (Manifest(), ())


def test_a_folder_in_its_place(tmp_path: Path, plan, snapshot) -> None:
    (tmp_path / NAME).mkdir()
    _, diagnostics = load_manifest(tmp_path)
    assert [diagnostic.code for diagnostic in diagnostics] == ["bad-manifest"]
    before = snapshot(tmp_path)
    result = write(plan(tmp_path, [OutputFile("a.py", b"x")]))
    assert [diagnostic.code for diagnostic in result.diagnostics] == ["cannot-write"]
    assert snapshot(tmp_path) == before


JSON = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats(allow_nan=False) | st.text(),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.text(), inner, max_size=3),
    max_leaves=8,
)


@given(
    st.dictionaries(st.text(), st.binary()),
    st.dictionaries(st.text(), st.dictionaries(st.text(), JSON, max_size=3)),
)
def test_text_and_back(
    tmp_path_factory, texts: dict[str, bytes], bases: dict[str, dict[str, Any]]
) -> None:
    folder = tmp_path_factory.mktemp("manifest")
    manifest = Manifest({name: digest(text) for name, text in texts.items()}, bases)
    text = manifest_text(manifest)
    (folder / NAME).write_bytes(text)
    assert load_manifest(folder) == (manifest, ())
    # A file a line, so that what two branches generate merges well.
    names = {*texts, *bases}
    assert text.count(b"\n") == (5 if not names else 5 + 1 + len(names))


def test_version_1_is_read(tmp_path: Path, plan) -> None:
    files = {"a.py": digest(b"a"), "b.py": digest(b"b")}
    old = {"generator": "plastron", "version": 1, "files": files}
    (tmp_path / NAME).write_text(json.dumps(old, indent=2))
    assert load_manifest(tmp_path) == (Manifest(files), ())
    for name in files:
        (tmp_path / name).write_bytes(name[:1].encode())
        (tmp_path / name).chmod(0o755)
    assert write(plan(tmp_path, [OutputFile("a.py", b"a", base={"node": "a"})])) == ((), ())
    assert load_manifest(tmp_path) == (Manifest(files, {"a.py": {"node": "a"}}), ())


def test_base_of_a_merge_is_remembered_and_its_text_is_not(tmp_path: Path, plan) -> None:
    write(plan(tmp_path, [OutputFile("a.py", b"made", base={"node": "1"})]))
    (tmp_path / "a.py").write_bytes(b"made + mine")
    text = b"made2 + mine"
    merged = OutputFile("a.py", text, merged_from=b"made + mine", base={"node": "2"})
    write(plan(tmp_path, [merged]))
    assert load_manifest(tmp_path)[0] == Manifest(
        {"a.py": digest(b"made")}, {"a.py": {"node": "2"}}
    )
    # Nothing is left to do to the file, but the program has changed.
    merged = OutputFile("a.py", text, merged_from=text, base={"node": "3"})
    assert write(plan(tmp_path, [merged])) == ((), ())
    assert load_manifest(tmp_path)[0].bases == {"a.py": {"node": "3"}}


def test_handwork_from_another_file_is_not_remembered_as_ours(tmp_path: Path, plan) -> None:
    write(plan(tmp_path, [OutputFile("a.py", b"made", base={"node": "1"})]))
    moved = OutputFile("b.py", b"made + mine", has_handwork=True, base={"node": "2"})
    write(plan(tmp_path, [moved]))
    manifest, _ = load_manifest(tmp_path)
    assert manifest.digests == {"a.py": digest(b"made")}
    assert "b.py" in manifest
    again = write(plan(tmp_path, [OutputFile("b.py", b"made2")]))
    assert [found.code for found in again.diagnostics] == ["file-conflict"]


def test_conflict_is_not_remembered(tmp_path: Path, plan) -> None:
    (tmp_path / "a.py").write_bytes(b"mine")
    problem = Diagnostic(codes.FILE_CONFLICT, "why")
    file = OutputFile("a.py", b"made", base={"node": "1"}, problem=problem)
    assert write(plan(tmp_path, [file])) == ((), (problem,))
    assert not (tmp_path / NAME).exists()
    assert write(plan(tmp_path, [file]), force=True).diagnostics == ()
    assert (tmp_path / "a.py.bak").read_bytes() == b"mine"
    assert load_manifest(tmp_path)[0].bases == {"a.py": {"node": "1"}}


def test_entries_of_files_that_are_gone_are_dropped(tmp_path: Path, plan) -> None:
    write(plan(tmp_path, [OutputFile("a.py", b"a"), OutputFile("b.py", b"b")]))
    (tmp_path / "a.py").unlink()
    write(plan(tmp_path, [OutputFile("c.py", b"c")]))
    assert json.loads((tmp_path / NAME).read_bytes())["files"].keys() == {"b.py", "c.py"}


def test_handwork_that_was_merged_is_not_remembered_as_ours(tmp_path: Path, plan) -> None:
    made = OutputFile("a.py", b"generated")
    write(plan(tmp_path, [made]))
    (tmp_path / "a.py").write_bytes(b"generated + by hand")
    merged = OutputFile("a.py", b"generated2 + by hand", merged_from=b"generated + by hand")
    assert write(plan(tmp_path, [merged])).diagnostics == ()
    again = write(plan(tmp_path, [made]))
    assert [diagnostic.code for diagnostic in again.diagnostics] == ["file-conflict"]
    assert (tmp_path / "a.py").read_bytes() == merged.text


def test_a_file_that_already_is_right_is_adopted(tmp_path: Path, plan) -> None:
    (tmp_path / "a.py").write_bytes(b"x")
    (tmp_path / "a.py").chmod(0o755)
    assert write(plan(tmp_path, [OutputFile("a.py", b"x")])) == ((), ())
    assert load_manifest(tmp_path)[0].has("a.py", b"x")
    stamp = (tmp_path / NAME).stat().st_mtime_ns
    assert write(plan(tmp_path, [OutputFile("a.py", b"x")])) == ((), ())
    assert (tmp_path / NAME).stat().st_mtime_ns == stamp
