"""A file is read again only where it may hold something else than it did."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from plastron_tui.project.linting import fingerprints
from plastron_tui.project.linting.fingerprints import Fingerprints, Reads, Status, noted


def _look(file: Path, known: dict[str, fingerprints.Seen]) -> tuple[bytes | None, int]:
    files = Fingerprints(known)
    return files.digest_of(str(file)), files.read_anew


def test_file_with_the_status_that_it_was_read_with_is_not_read(tmp_path: Path) -> None:
    file = tmp_path / "a.py"
    file.write_text("x = 1")
    known = {str(file): (Status.of(file.stat()), b"what it held")}
    assert _look(file, known) == (b"what it held", 0)


@pytest.mark.parametrize("is_kept", [True, False])
def test_file_of_another_status_is_read(tmp_path: Path, *, is_kept: bool) -> None:
    file = tmp_path / "a.py"
    file.write_text("x = 1")
    before = file.stat()
    known = {str(file): (Status.of(before), b"what it held")}
    file.write_text("x = 2")
    if is_kept:
        # As `cp -p`, `git stash` or an archive may do: the time of the change of status tells.
        os.utime(file, ns=(before.st_atime_ns, before.st_mtime_ns))
    other = tmp_path / "other"
    other.write_text("x = 2")
    while file.stat().st_ctime_ns == before.st_ctime_ns:
        file.chmod(0o600)
    assert _look(file, known)[0] == _look(other, {})[0]


def test_status_is_trusted_only_where_the_clock_has_ticked_since(tmp_path: Path) -> None:
    file = tmp_path / "a.py"
    file.write_text("x = 1")
    for slack, is_sure in ((fingerprints.SLACK, False), (-fingerprints.SLACK, True)):
        reads = Reads({}, {})
        with noted(reads, slack):
            fingerprints.read_regular(file, 100)
        assert (str(file) in reads.seen) == is_sure
        assert reads.digests[str(file)] is not None


def test_file_that_changes_between_two_looks_is_never_taken_for_known(tmp_path: Path) -> None:
    file = tmp_path / "a.py"
    file.write_text("x = 1")
    reads = Reads({}, {})
    with noted(reads, -fingerprints.SLACK):
        fingerprints.read_regular(file, 100)
        file.write_text("x = 2")
        fingerprints.read_regular(file, 100)
    assert reads.digests[str(file)] not in {_look(file, {})[0], None}
    assert not reads.seen


def test_file_that_somebody_finds_too_large_is_told_by_what_it_holds(tmp_path: Path) -> None:
    file = tmp_path / "a.py"
    file.write_text("x = 1")
    reads = Reads({}, {})
    with noted(reads), pytest.raises(OSError, match="larger"):
        fingerprints.read_regular(file, 2)
    assert reads.digests[str(file)] == _look(file, {})[0]
