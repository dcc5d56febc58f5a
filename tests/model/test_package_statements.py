"""Packages, and what programs put into them."""

from __future__ import annotations

import pytest
from workspaces import TALKER, marked, run, workspace

from plastron_tui.model.workspace import Home

ROVER = f"{TALKER}create_package 'rover' as rover\n"
FULL = f"{ROVER}rover contains n as 'talk'\n"

LONG = "a" * 280
WRONG: list[tuple[str, str, str, str, str | None]] = [
    (ROVER, "create_package 'rover' as r", "package-exists", "'rover'", "choose another"),
    (ROVER, "create_package 'robot' as rover", "variable-exists", "rover", "one namespace"),
    (ROVER, "create_package 'robot' as n", "variable-exists", "n", "one namespace"),
    (ROVER, "create_node 'r' as rover", "variable-exists", "rover", "one namespace"),
    (ROVER, "rovr contains n", "unknown-package", "rovr", "did you mean `rover`?"),
    (ROVER, "n contains n", "unknown-package", "n", "`n` is a node"),
    (ROVER, "zzz contains n", "unknown-package", "zzz", "`create_package 'zzz' as zzz`"),
    (ROVER, "generate_package rovr", "unknown-package", "rovr", "did you mean `rover`?"),
    (ROVER, "generate_node rover", "unknown-node", "rover", "`rover` is a package"),
    (ROVER, "rover contains m", "unknown-item", "m", None),
    (ROVER, "rover contains rover", "unknown-item", "rover", None),
    (ROVER, "rover contains zzz", "unknown-item", "zzz", "`create_node 'zzz' as zzz`"),
    (FULL, "rover contains n", "already-contained", "n", "`rover no_longer_contains n`"),
    (
        f"{FULL}create_package 'other' as other\n",
        *("other contains n", "already-contained", "n", "`rover no_longer_contains n`"),
    ),
    (
        f"{FULL}create_node 'x' as x\n",
        *("rover contains x as 'talk'", "already-contained", "'talk'", "name it otherwise"),
    ),
    (
        f"{FULL}create_node 'talk' as x\n",
        *("rover contains x", "already-contained", "x", "name it otherwise"),
    ),
    (
        ROVER,
        "create_package 'p1' as p licensed_under \"Propritary\"",
        "unknown-license",
        '"Propritary"',
        "did you mean `Proprietary`?",
    ),
    (
        ROVER,
        "create_package 'p1' as p licensed_under \"LicenseRef-a b\"",
        "unknown-license",
        '"LicenseRef-a b"',
        "letters, digits",
    ),
    (
        ROVER,
        "create_package 'p1' as p licensed_under \"LicenseRef-\"",
        "unknown-license",
        '"LicenseRef-"',
        "letters, digits",
    ),
    (
        ROVER,
        "create_package 'p1' as p licensed_under \"ours alone\"",
        "unknown-license",
        '"ours alone"',
        'closed code is "Proprietary"',
    ),
    (TALKER, f"create_package '{LONG}' as r", "bad-package-name", LONG[160:], None),
    (ROVER, f"rover contains n as '{LONG}'", "bad-package-file", LONG[200:], None),
    (ROVER, "rover contains n as 'a b'", "bad-package-file", " ", None),
    (
        f"{ROVER}create_node '{LONG[:240]}' as x\n",
        *("rover contains x", "bad-package-file", "x", "name it otherwise"),
    ),
    (TALKER, f"create_launch '{LONG}' as r", "bad-launch-name", f"'{LONG}'", "shorter"),
    (FULL, "rover no_longer_contains m", "not-contained", "m", None),
    (FULL, "rover no_longer_contains 'n'", "not-contained", "'n'", None),
    (FULL, "rover no_longer_contains 'tlk'", "not-contained", "'tlk'", "did you mean `talk`?"),
]


@pytest.mark.parametrize(
    ("before", "line", "code", "where", "remedy"), WRONG, ids=[each[1] for each in WRONG]
)
def test_what_is_wrong(before: str, line: str, code: str, where: str, remedy: str | None) -> None:
    text = f"{before}{line}\n"
    [found] = run(text).diagnostics
    assert (found.code, marked(text, found)) == (code, where)
    assert remedy is None or remedy in (found.help or "")


def test_a_package_knows_what_it_contains() -> None:
    package = workspace(FULL).packages["rover"]
    [held] = package.contents.values()
    assert (held.item.name, held.name) == ("talker", "talk")


@pytest.mark.parametrize("what", ["n", "'talk'"])
def test_what_is_taken_out_is_in_no_package(what: str) -> None:
    found = workspace(f"{FULL}rover no_longer_contains {what}\n")
    assert found.packages["rover"].contents == {}
    assert found.nodes["n"].home is None


def test_a_package_is_written_with_its_nodes_as_they_are_then() -> None:
    text = (
        f"{FULL}create_node 'other' as other\nother repeats f at 1 hz\n"
        "generate_package rover\nrover no_longer_contains n\nrover contains other\n"
    )
    later = run(text)
    assert [each.code for each in later.diagnostics] == ["changed-after-generating"] * 2
    found = later.workspace
    [written] = found.written_packages
    [node] = found.generations
    assert list(written.package.contents) == ["n"]
    assert (node.node.name, node.node.home) == ("talker", Home("rover", "talk"))
    assert list(found.packages["rover"].contents) == ["other"]
