"""Types that changed since a revision of git, and what of that is told."""

from __future__ import annotations

import subprocess
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

import pytest
from linted import write_tree
from packages import CMAKE, PY_NODE

from plastron_tui.diagnostics import Diagnostic
from plastron_tui.lint import lint
from plastron_tui.lint.rules import RULES
from plastron_tui.lint.tree import Earlier, SourceTree
from plastron_tui.project.linting import read_tree
from plastron_tui.project.linting.cache import FactCache
from plastron_tui.project.linting.earlier import interfaces_of, read_earlier
from plastron_tui.ros.definition import member_spans

_SPEED = "float64 value\nstring unit\nint32[] history\nuint8 FAST=1\n"
_USER = PY_NODE.replace("geometry_msgs.msg import Twist", "rover.msg import Speed").replace(
    "Twist, 'cmd_vel', 10)",
    "Speed, 'speed', 10)\n        self.pub.publish(Speed(value=1.0, unit='m'))",
)
_BEFORE = {**CMAKE, "rover/msg/Speed.msg": _SPEED, "user.py": _USER}
_LINE = 11


def _tree(folder: Path, files: Mapping[str, str]) -> SourceTree:
    root = write_tree(folder, files)
    return read_tree([root], FactCache(root, folder / "cache"), workers=1)


def _told(tree: SourceTree, earlier: Earlier) -> list[str]:
    found = []
    for each in lint(replace(tree, earlier=earlier), [RULES["RK508"]]):
        file, span = each.diagnostic.file, each.diagnostic.span
        assert file is not None and span is not None
        line = file.read_bytes()[: span.start].count(b"\n") + 1
        found.append(f"{file.name}:{line} {each.diagnostic.message}")
    return found


@pytest.mark.parametrize(
    ("now", "is_unchanged", "told"),
    [
        (_SPEED, True, []),
        (_SPEED + "bool more\n", True, []),
        (_SPEED.replace("float64", "float32").replace("int32[]", "int64[]"), True, []),
        (
            _SPEED.replace("value", "speed"),
            False,
            [f"user.py:{_LINE} `value` of `rover/Speed` is gone since `main`"],
        ),
        (
            _SPEED.replace("string unit", "int32 unit"),
            True,
            [
                f"user.py:{_LINE} `unit` of `rover/Speed` was `string`, and is `int32` since "
                "`main`",
            ],
        ),
        (
            _SPEED.replace("string unit", "int32 unit"),
            False,
            [
                "Speed.msg:1 `unit` of `rover/Speed` was `string`, and is `int32` since `main`, "
                "which breaks whoever uses it",
            ],
        ),
        (
            _SPEED.replace("int32[] history\n", ""),
            True,
            ["Speed.msg:1 `history` of `rover/Speed` is gone since `main`, "
             "which breaks whoever uses it"],
        ),
        (
            _SPEED.replace("uint8 FAST=1\n", ""),
            True,
            ["Speed.msg:1 `FAST` of `rover/Speed` is gone since `main`, "
             "which breaks whoever uses it"],
        ),
        (None, True, ["user.py:10 `rover/Speed` is gone since `main`"]),
    ],
)  # fmt: skip
def test_change_is_told_of_who_breaks(
    tmp_path: Path, now: str | None, is_unchanged: bool, told: list[str]
) -> None:
    files = dict(_BEFORE)
    del files["rover/msg/Speed.msg"]
    if now is not None:
        files["rover/msg/Speed.msg"] = now
    tree = _tree(tmp_path, files)
    unchanged = frozenset({tree.root / "user.py"} if is_unchanged else ())
    earlier = Earlier("main", interfaces_of(_BEFORE, tree.packages), unchanged)
    assert _told(tree, earlier) == told


_READER = """\
#include <rclcpp/rclcpp.hpp>
#include <rover/msg/speed.hpp>
class Reader : public rclcpp::Node {
public:
  Reader() : Node("reader") {
    sub_ = create_subscription<rover::msg::Speed>("speed", 1, [](const rover::msg::Speed &msg) {
      use(msg.value);
    });
  }
  rclcpp::Subscription<rover::msg::Speed>::SharedPtr sub_;
};
"""


@pytest.mark.parametrize(
    ("lists", "told"),
    [
        ("add_executable(reader src/reader.cpp)\n", ["reader.cpp:7 "]),
        ("# add_executable(reader src/reader.cpp)\n", ["Speed.msg:1 "]),
    ],
)
def test_source_that_no_build_takes_does_not_break(
    tmp_path: Path, lists: str, told: list[str]
) -> None:
    before = {**CMAKE, "rover/msg/Speed.msg": _SPEED, "rover/src/reader.cpp": _READER}
    before["rover/CMakeLists.txt"] += lists
    tree = _tree(tmp_path, {**before, "rover/msg/Speed.msg": _SPEED.replace("value", "speed")})
    earlier = Earlier("main", interfaces_of(before, tree.packages), frozenset())
    found = _told(tree, earlier)
    assert [each.partition("`")[0] for each in found] == told


def _git(folder: Path, *words: str) -> None:
    command = ["git", "-c", "user.name=Ada", "-c", "user.email=ada@example.com", *words]
    subprocess.run(command, cwd=folder, check=True, capture_output=True)


def test_revision_is_read_and_nothing_of_the_repository_is_run(tmp_path: Path) -> None:
    root = write_tree(tmp_path, {f"inner/{name}": text for name, text in _BEFORE.items()})
    _git(root, "init", "-q")
    _git(root, "add", "-A")
    _git(root, "commit", "-q", "-m", "before")
    hook = root / ".git/hooks/post-checkout"
    hook.parent.mkdir(exist_ok=True)
    hook.write_text(f"#!/bin/sh\ntouch {tmp_path}/was-run\n")
    hook.chmod(0o755)
    for name in ("core.fsmonitor", "core.pager", "core.sshCommand", "filter.x.smudge"):
        _git(root, "config", name, f"touch {tmp_path}/was-run")
    (root / "inner/rover/msg/Speed.msg").write_text("float64 speed\n")
    (root / "inner/user.py").write_text(_USER + "# more\n")
    tree = read_tree([root / "inner"], FactCache(root, tmp_path / "cache"), workers=1)
    earlier = read_earlier(tree, "HEAD")
    assert isinstance(earlier, Earlier)
    assert {str(name) for _, name in earlier.interfaces} == {"rover/Speed", "rover/Reset"}
    changed = {each.path.name for each in tree.units if each.path not in earlier.unchanged}
    assert changed == {"user.py"}
    assert not (tmp_path / "was-run").exists()
    for revision in ("nothing", "--help", "HEAD:inner", ""):
        assert isinstance(read_earlier(tree, revision), Diagnostic)


def _committed(folder: Path) -> Path:
    """Write a repository with a commit, and return its folder."""
    root = write_tree(folder, _BEFORE)
    _git(root, "init", "-q")
    _git(root, "add", "-A")
    _git(root, "commit", "-q", "-m", "before")
    return root


_MEMBERS = "\ufeff# A speed.\n\nfloat64 value  # m/s\nstring unit\nuint8 FAST=1\n"


@pytest.mark.parametrize(
    ("now", "place"),
    [
        (_MEMBERS.replace("string", "int32"), "int32 unit"),
        (_MEMBERS.replace("float64 value", "bool[]  value"), "bool[]  value"),
        (_MEMBERS.replace("string unit", "string name"), "string name"),
        (_MEMBERS.replace("string unit\n", ""), ""),
    ],
)
def test_place_of_a_change(tmp_path: Path, now: str, place: str) -> None:
    """What became of a field is told where it stands, where no node uses it."""
    files = {**CMAKE, "rover/msg/Speed.msg": _MEMBERS}
    root = write_tree(tmp_path, files)
    _git(root, "init", "-q")
    _git(root, "add", "-A")
    _git(root, "commit", "-q", "-m", "before")
    (root / "rover/msg/Speed.msg").write_text(now)
    tree = read_tree([root], FactCache(root, tmp_path / "cache"), workers=1)
    earlier = read_earlier(tree, "HEAD")
    assert isinstance(earlier, Earlier)
    (found,) = lint(replace(tree, earlier=earlier), [RULES["RK508"]])
    span = found.diagnostic.span
    assert span is not None
    assert now.encode()[span.start : span.end] == place.encode()


def test_places_of_members() -> None:
    text = "int32 a\n---\n bool  b # b\nint32 a = 1\n---\nint32[<=3] c\n"
    found = {key: text[span.start : span.end] for key, span in member_spans(text, 2).items()}
    assert found == {(0, "a"): "int32 a", (1, "b"): "bool  b", (1, "a"): "int32 a"} | {
        (2, "c"): "int32[<=3] c"
    }


def _lose(root: Path, name: str) -> None:
    """Take away what git has of a file in the last commit."""
    words = ["git", "rev-parse", f"HEAD:{name}"]
    known = subprocess.run(words, cwd=root, check=True, capture_output=True, text=True).stdout
    (root / ".git/objects" / known[:2] / known[2:].strip()).unlink()


@pytest.mark.parametrize(
    ("lost", "why"),
    [
        ((), ""),
        (("user.py",), ""),
        (("rover/msg/Speed.msg",), "the repository lacks `rover/msg/Speed.msg`, as"),
        (("rover/package.xml", "rover/msg/Speed.msg"), "the repository lacks `rover/msg/Speed.msg` "
         "and 1 more, as"),
    ],
)  # fmt: skip
def test_revision_of_which_files_are_missing(
    tmp_path: Path, lost: tuple[str, ...], why: str
) -> None:
    root = _committed(tmp_path)
    for name in lost:
        _lose(root, name)
    tree = read_tree([root], FactCache(root, tmp_path / "cache"), workers=1)
    earlier = read_earlier(tree, "HEAD")
    if why:
        assert isinstance(earlier, Diagnostic)
        assert why in earlier.message
    else:
        assert isinstance(earlier, Earlier)
        assert root / "user.py" in earlier.unchanged


@pytest.mark.parametrize(
    "settings",
    [
        {"remote.origin.url": "ext::{runs}", "protocol.ext.allow": "always"},
        {"remote.origin.url": "there:x", "core.sshCommand": "{runs}",
         "protocol.ssh.allow": "always"},
        {"remote.origin.url": "git://localhost/x", "core.gitProxy": "{runs}",
         "protocol.git.allow": "always"},
        {"remote.origin.url": ".", "remote.origin.uploadpack": "{runs};",
         "protocol.file.allow": "always"},
        {"remote.origin.url": "x", "remote.origin.vcs": "ext", "protocol.ext.allow": "always"},
        {"remote.origin.url": "https://localhost:9/x", "credential.helper": "!{runs}",
         "core.askPass": "{runs}", "protocol.https.allow": "always"},
        {"alias.ls-tree": "!{runs}", "alias.cat-file": "!{runs}", "core.pager": "{runs}",
         "pager.ls-tree": "true", "diff.external": "{runs}", "core.editor": "{runs}"},
    ],
)  # fmt: skip
def test_nothing_is_fetched_with_programs_of_the_repository(
    tmp_path: Path, settings: Mapping[str, str]
) -> None:
    root = _committed(tmp_path)
    program = tmp_path / "runs"
    program.write_text(f"#!/bin/sh\ntouch {tmp_path}/was-run\n")
    program.chmod(0o755)
    partial = {"core.repositoryFormatVersion": "1", "extensions.partialClone": "origin",
               "remote.origin.promisor": "true"}  # fmt: skip
    for name, value in {**partial, **settings}.items():
        _git(root, "config", name, value.format(runs=program))
    for name in ("user.py", "rover/msg/Speed.msg"):
        _lose(root, name)
    tree = read_tree([root], FactCache(root, tmp_path / "cache"), workers=1)
    assert isinstance(read_earlier(tree, "HEAD"), Diagnostic)
    assert not (tmp_path / "was-run").exists()


def _write_submodule(folder: Path) -> Path:
    """Write a repository that has another one as its submodule, and return its folder."""
    inner = write_tree(folder / "inner", _BEFORE)
    root = write_tree(folder, {"README": ""})
    for each in (inner, root):
        _git(each, "init", "-q")
    _git(inner, "add", "-A")
    _git(inner, "commit", "-q", "-m", "before")
    _git(root, "-c", "protocol.file.allow=always", "submodule", "add", "-q", str(inner), "mine")
    _git(root, "commit", "-q", "-m", "with a submodule")
    _git(root, "tag", "-a", "-m", "one", "v1")
    return root


@pytest.fixture(scope="module")
def with_submodule(tmp_path_factory: pytest.TempPathFactory) -> SourceTree:
    folder = tmp_path_factory.mktemp("submodule")
    root = _write_submodule(folder)
    return read_tree([root], FactCache(root, folder / "cache"), workers=1)


@pytest.mark.parametrize(
    ("revision", "why"),
    [
        ("HEAD", ""),
        (":/with", ""),
        ("v1", ""),
        ("HEAD^{tree}", "it is no commit"),
        ("HEAD:.gitmodules", "it is no commit"),
        (":/no such text", "there is none"),
        ("HEAD..HEAD", "there is none"),
        ("HEAD\nHEAD", "it is no name of a revision"),
    ],
)
def test_words_for_a_revision_and_its_submodule(
    with_submodule: SourceTree, revision: str, why: str
) -> None:
    tree = with_submodule
    earlier = read_earlier(tree, revision)
    if isinstance(earlier, Diagnostic):
        assert why
        assert earlier.message.endswith(f"cannot be read: {why}")
    else:
        assert not why
        assert {str(name) for _, name in earlier.interfaces} == {"rover/Speed", "rover/Reset"}
        assert tree.root / "mine/user.py" in earlier.unchanged


def test_submodule_that_lacks_what_it_was(tmp_path: Path) -> None:
    root = _write_submodule(tmp_path)
    (root / ".git/modules/mine/HEAD").unlink()
    tree = read_tree([root], FactCache(root, tmp_path / "cache"), workers=1)
    found = read_earlier(tree, "HEAD")
    assert isinstance(found, Diagnostic)
    assert "the submodule `mine` has not what it was then" in found.message
