"""Names that have the name of a node in them, which is not always known."""

from __future__ import annotations

from pathlib import Path

import pytest
from graph_packages import LISTENER, TALKER, code_of, found_in, package_of

TALKS = code_of(TALKER, topic="~/text")
HEARS = code_of(LISTENER, topic="~/text", type="Int32").replace("class Listener", "class Talker")
UNKNOWN = "super().__init__(NAME)"


def _named(text: str, made: str) -> str:
    return text.replace("super().__init__('talker')", made).replace(
        "super().__init__('listener')", made
    )


@pytest.mark.parametrize(
    ("made", "count"), [("super().__init__('one')", 1), (UNKNOWN, 0)], ids=["known", "unknown"]
)
def test_private_name_of_a_node_without_a_name_is_not_known(
    tmp_path: Path, made: str, count: int
) -> None:
    files = package_of(_named(TALKS, made), _named(HEARS, made))
    assert len(found_in(tmp_path, files, "RG101")) == count


def test_other_names_are_known_without_that_of_the_node(tmp_path: Path) -> None:
    talks, hears = (each.replace("~/text", "text") for each in (TALKS, HEARS))
    files = package_of(_named(talks, UNKNOWN), _named(hears, UNKNOWN))
    assert len(found_in(tmp_path, files, "RG101")) == 1
