"""A definition that a link leads to is read inside the project alone."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from plastron_tui.session import Session
from plastron_tui.trust import TrustStore

SECRET = "password of mine\n"
PROGRAM = b"""\
create_node 'a' as a
subscribe a to 'x' of message_type %s
"""

# The links in the repository, each with where it leads from the folder above.
LINKS = {
    "a definition": {"msg/Leak.msg": "secret/creds"},
    "its folder": {"msg": "secret/msg"},
    "its package": {"pkg": "secret"},
    "a folder above its package": {"src": ""},
    "a definition, to git": {"msg/Leak.msg": "repo/.git/config"},
    "a definition, absolute": {"msg/Leak.msg": "{folder}/secret/creds"},
    "a link to a link": {"msg/Leak.msg": "repo/other", "other": "secret/creds"},
}  # fmt: skip


@pytest.fixture
def repository(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("HOME", str(tmp_path / "home"))
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    for name in ("secret/creds", "secret/msg/Leak.msg", "repo/.git/config"):
        path = tmp_path / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(SECRET)
    return tmp_path / "repo"


def link(repository: Path, links: dict[str, str]) -> None:
    for name, target in links.items():
        path = repository / name
        path.parent.mkdir(parents=True, exist_ok=True)
        if "{folder}" in target:
            path.symlink_to(target.format(folder=repository.parent))
        else:
            path.symlink_to(os.path.relpath(repository.parent / target, path.parent))


def found(repository: Path, type_: str = "Leak", **environ: str) -> list[tuple[str, str]]:
    path = repository / "a.plastron"
    session = Session(PROGRAM % type_.encode(), path, environ=environ)
    return [(each.code, each.message) for each in session.diagnostics]


@pytest.mark.parametrize("project", ["", "types: .\n"], ids=["no types named", "types: ."])
@pytest.mark.parametrize("links", LINKS.values(), ids=LINKS)
def test_nothing_outside_is_read(repository: Path, links: dict[str, str], project: str) -> None:
    link(repository, links)
    if project:
        (repository / "plastron.yaml").write_text(project)
    codes = [code for code, _ in found(repository)]
    assert sorted(codes) == ["outside-project", "unknown-type"]
    TrustStore().add(repository)
    assert "bad-definition" in [code for code, _ in found(repository)]


def test_a_link_within_the_project_is_followed(repository: Path) -> None:
    (repository / "shared").mkdir()
    (repository / "shared" / "A.msg").write_text("int8 x\n")
    link(repository, {"msg/A.msg": "repo/shared/A.msg"})
    assert found(repository, "A") == []


def test_a_definition_that_is_not_read_hides_no_installed_one(
    repository: Path, tmp_path: Path
) -> None:
    link(repository, {"pkg": "secret"})
    installed = tmp_path / "ros" / "share" / "pkg" / "msg"
    installed.mkdir(parents=True)
    (installed / "Leak.msg").write_text("int8 x\n")
    environ = {"ROS_VERSION": "2", "AMENT_PREFIX_PATH": str(tmp_path / "ros")}
    assert found(repository, "pkg/Leak", **environ) == []


def test_an_installed_ros_may_have_links(repository: Path, tmp_path: Path) -> None:
    real = tmp_path / "ws" / "pkg" / "msg"
    real.mkdir(parents=True)
    (real / "A.msg").write_text("int8 x\n")
    (tmp_path / "ros" / "share").mkdir(parents=True)
    (tmp_path / "ros" / "share" / "pkg").symlink_to(tmp_path / "ws" / "pkg")
    environ = {"ROS_VERSION": "2", "AMENT_PREFIX_PATH": str(tmp_path / "ros")}
    assert found(repository, "pkg/A", **environ) == []


def test_in_the_home_folder_what_is_no_link_is_read(tmp_path: Path, repository: Path) -> None:
    home = tmp_path / "home"
    (home / "pkg" / "msg").mkdir(parents=True)
    (home / "pkg" / "msg" / "A.msg").write_text("int8 x\n")
    assert found(home, "A") == []
