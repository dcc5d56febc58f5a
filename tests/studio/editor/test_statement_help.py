from __future__ import annotations

import pytest

from plastron_tui.studio.editor.statement_help import is_comment


@pytest.mark.parametrize(
    ("line", "is_so"),
    [(b"// why", True), (b"  /* why */", True), (b"", False), (b"a publish b // c", False)],
)
def test_no_statement_is_started_in_a_line_that_begins_with_a_comment(
    line: bytes, is_so: bool
) -> None:
    assert is_comment(line) is is_so
