"""Each kind of endpoint, added to nodes of many manners: what holds for all of them."""

from __future__ import annotations

import re
from difflib import SequenceMatcher

import pytest
from additions import each_kind
from manners import RCLCPP, ROSCPP, files
from patches import edit, read

from plastron_tui.model.kinds import kind_of
from plastron_tui.model.source import EndpointKind, FileSet, Remove

CASES = [
    pytest.param(version, name, id=f"{version} {name}")
    for version, nodes in ((1, ROSCPP), (2, RCLCPP))
    for name in nodes
]
WAYS = {
    "windows line ends": lambda text: text.replace(b"\n", b"\r\n"),
    "a byte order mark": lambda text: b"\xef\xbb\xbf" + text,
    "another encoding": lambda text: "// é\n".encode("latin-1") + text,
}
"""What is done to a text; the same is done to what it becomes."""


def found(unit) -> dict[tuple[EndpointKind, str | None], int]:
    names: dict[tuple[EndpointKind, str | None], int] = {}
    for each in unit.endpoints:
        key = each.kind, each.label or each.callback or each.expression
        names[key] = names.get(key, 0) + 1
    return names


def kept(before: bytes, after: bytes) -> bool:
    """Tell whether each line of a text is in another one, in its order; `{}` may be opened."""
    old, new = before.split(b"\n"), after.split(b"\n")
    left = [line for line in old if not line.endswith(b"{}")]
    matcher = SequenceMatcher(None, left, new, autojunk=False)
    return sum(each.size for each in matcher.get_matching_blocks()) == len(left)


@pytest.mark.long
@pytest.mark.parametrize(("version", "name"), CASES)
def test_what_is_added_is_read_and_nothing_else_has_changed(version, name):
    start = files((ROSCPP if version == 1 else RCLCPP)[name])
    before = read(start)
    for what, change in each_kind(version).items():
        changed, told = edit(start, change)
        assert changed is not None, (what, told)
        after = read(changed)
        more = {
            key: count - found(before).get(key, 0)
            for key, count in found(after).items()
            if count != found(before).get(key, 0)
        }
        endpoint = change.endpoint
        assert any(key[1] == endpoint.name for key in more), (what, more)
        for (_, old), (_, new) in zip(start.texts, changed.texts, strict=True):
            assert kept(old, new), what


@pytest.mark.long
@pytest.mark.parametrize(("version", "name"), CASES)
def test_all_kinds_go_into_one_node(version, name):
    current = files((ROSCPP if version == 1 else RCLCPP)[name])
    wanted = []
    for what, change in each_kind(version).items():
        changed, _ = edit(current, change)
        if changed is not None:
            current = changed
            wanted.append((what, change.endpoint.name))
    names = {each.label or each.name for each in read(current).endpoints}
    assert [what for what, name in wanted if name not in names] == []
    assert len(wanted) == len(each_kind(version))


@pytest.mark.long
@pytest.mark.parametrize("way", WAYS)
@pytest.mark.parametrize(("version", "name"), CASES)
def test_the_bytes_of_a_text_are_no_matter(version, name, way):
    start = files((ROSCPP if version == 1 else RCLCPP)[name])
    made = WAYS[way]
    other = FileSet(tuple((n, made(text)) for n, text in start.texts))
    kinds = each_kind(version)
    for what in ("subscription", "message once", "parameter", "goal"):
        plain, changed = edit(start, kinds[what])[0], edit(other, kinds[what])[0]
        assert plain is not None and changed is not None, what
        assert changed.texts == tuple((n, made(text)) for n, text in plain.texts), what


@pytest.mark.parametrize("version", [1, 2])
def test_windows_line_ends_stay(version):
    nodes = ROSCPP if version == 1 else RCLCPP
    start = files(nodes["class with members"])
    windows = FileSet(tuple((n, text.replace(b"\n", b"\r\n")) for n, text in start.texts))
    changed, _ = edit(windows, each_kind(version)["subscription"])
    assert changed is not None
    assert changed.main.count(b"\n") == changed.main.count(b"\r\n")


def lines(unit: FileSet) -> list[str]:
    """Return what the lines of files say, but for headers that more, or nothing, may use.

    Empty braces that were opened can stay as they are in the file's style.
    """
    texts = [re.sub(r"\s*\{\s*\}", " {}", text.decode()) for _, text in unit.texts]
    found = [line for text in texts for line in text.split("\n")]
    return [line for line in found if line.strip() and not STAYING.match(line)]


STAYING = re.compile(r"#include [<\"](?:memory|string|boost/bind/bind\.hpp)[>\"]")


@pytest.mark.long
@pytest.mark.parametrize(("version", "name"), CASES)
def test_what_was_added_is_taken_out_again(version, name):
    start = files((ROSCPP if version == 1 else RCLCPP)[name])
    for what, change in each_kind(version).items():
        changed, _ = edit(start, change)
        if changed is None:
            continue
        back, told = edit(changed, Remove(kind_of(type(change.endpoint)), change.endpoint.name))
        assert back is not None, (what, told)
        assert lines(back) == lines(start), what
