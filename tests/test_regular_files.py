from __future__ import annotations

import errno
import os
from pathlib import Path

import pytest

from plastron_tui.regular_files import is_same_file, read_named, read_regular, reason


def test_a_regular_file_is_read_through_a_link(tmp_path: Path) -> None:
    (tmp_path / "file").write_bytes(b"text")
    (tmp_path / "link").symlink_to("file")
    assert read_regular(tmp_path / "link", 4) == b"text"


def test_two_paths_are_one_file_also_by_hard_links(tmp_path: Path) -> None:
    file, link, hard, other = (tmp_path / each for each in ("file", "link", "hard", "other"))
    for each in (file, other):
        each.write_bytes(b"text")
    link.symlink_to(file)
    hard.hardlink_to(file)
    assert [is_same_file(each, file) for each in (file, link, hard, other)] == [True] * 3 + [False]
    gone = tmp_path / "gone"
    assert is_same_file(gone, tmp_path / "." / "gone") and not is_same_file(gone, file)
    assert not is_same_file(file, None)


@pytest.mark.parametrize(
    ("make", "code"),
    [
        (lambda path: None, errno.ENOENT),
        (Path.mkdir, errno.EISDIR),
        (os.mkfifo, errno.EINVAL),
        (lambda path: path.symlink_to("/dev/zero"), errno.EINVAL),
        (lambda path: path.write_bytes(b"12345"), errno.EFBIG),
        # It says that it has no bytes.
        (lambda path: path.symlink_to("/proc/self/status"), errno.EFBIG),
    ],
)
def test_what_is_no_file_or_too_large_is_refused(tmp_path: Path, make, code: int) -> None:
    make(tmp_path / "it")
    with pytest.raises(OSError) as raised:
        read_regular(tmp_path / "it", 4)
    assert raised.value.errno == code


def test_the_reason_keeps_its_units(tmp_path: Path) -> None:
    (tmp_path / "file").write_bytes(bytes(2 * 1024**2))
    with pytest.raises(OSError) as raised:
        read_regular(tmp_path / "file", 1024**2)
    assert reason(raised.value) == "it is larger than 1 MB"
    assert reason(FileNotFoundError(2, "No such file")) == "no such file"


def test_a_pipe_is_read_where_a_shell_hands_it_over() -> None:
    read, write = os.pipe()
    os.write(write, b"text")
    os.close(write)
    try:
        assert read_named(Path(f"/dev/fd/{read}"), 4) == b"text"
    finally:
        os.close(read)
