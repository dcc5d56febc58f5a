from __future__ import annotations

from pathlib import Path

import pytest

from plastron_tui.boundary import PROJECT_FILE as FILE_NAME
from plastron_tui.boundary import Boundary, find_boundary
from plastron_tui.project.settings import (
    LARGEST_PROJECT,
    Project,
    find_project,
    read_project,
)
from plastron_tui.targets import LIBRARIES as ALL

LIBRARIES = {name: ALL[name] for name in ("rospy", "rclpy")}


def read(folder: Path, text: str | bytes) -> tuple[Project, list[tuple[str, str, str | None]]]:
    """Return a project, and of each mistake its message, its place in the text, and the help."""
    file = folder / FILE_NAME
    source = text.encode() if isinstance(text, str) else text
    file.write_bytes(source)
    trusted = Boundary(folder, file, trusts=lambda _: True)
    project, diagnostics = read_project(file, LIBRARIES, trusted)
    assert {(found.code, found.file) for found in diagnostics} <= {("bad-project", file)}
    return project, [
        (
            found.message,
            "" if found.span is None else source[found.span.start : found.span.end].decode(),
            found.help,
        )
        for found in diagnostics
    ]


def test_everything_is_read(tmp_path: Path) -> None:
    for name in ("templates", "msgs", "more"):
        (tmp_path / name).mkdir()
    text = (
        "# my project\ntarget: rclpy\ndistribution: humble\noutput: ../nodes\n"
        "file_names: plain\ntemplates: templates\ntypes: [msgs, ./more]\n"
    )
    project, mistakes = read(tmp_path, text)
    assert mistakes == []
    assert project == Project(
        tmp_path / FILE_NAME,
        "rclpy",
        "humble",
        tmp_path / ".." / "nodes",
        "plain",
        tmp_path / "templates",
        (tmp_path / "msgs", tmp_path / "more"),
    )


@pytest.mark.parametrize(
    "text", ["", "# nothing\n", "---\n", "{}", "target:\noutput: ~\ntypes: []\n", "types: null"]
)
def test_nothing_is_said(tmp_path: Path, text: str) -> None:
    assert read(tmp_path, text) == (Project(tmp_path / FILE_NAME), [])


KEYS = "the keys are target, distribution, output, file_names, templates, types, launch, cpp, lint"
FOLDER = "is to be the path of a folder"


@pytest.mark.parametrize(
    ("text", "message", "place", "remedy"),
    [
        ("targt: rospy", "`targt` is no key of a project file", "targt", "did you mean `target`?"),
        ("zzz: 1", "`zzz` is no key of a project file", "zzz", KEYS),
        ("{ä: 1, zzz: 2, target: rospy}", "`ä` is no key of a project file", "ä", KEYS),
        ("? [a, b]\n: 1", "this is no key of a project file", "[a, b]", KEYS),
        ("target: rosy", "`target` cannot be `rosy`", "rosy", "did you mean `rospy`?"),
        ("target: 5", "`target` cannot be `5`", "5", "`target` is one of rospy, rclpy"),
        ("target: [rospy]", "`target` cannot be a sequence", "[rospy]", None),
        ("target: {a: b}", "`target` cannot be a mapping", "{a: b}", None),
        ("distribution: nötic", "`distribution` cannot be `nötic`", "nötic",
         "did you mean `noetic`?"),
        ("output: 5", f"`output` {FOLDER}", "5", None),
        ("output: 2020-13-45", f"`output` {FOLDER}", "2020-13-45", None),
        ("output: [a]", f"`output` {FOLDER}", "[a]", None),
        ('output: ""', f"`output` {FOLDER}", '""', None),
        ('output: "a\\0b"', f"`output` {FOLDER}", '"a\\0b"', None),
        ("templates: nowhere", "there is no folder `nowhere`", "nowhere", None),
        ("types: nowhere", "there is no folder `nowhere`", "nowhere", None),
        ("types: [., nowhere]", "there is no folder `nowhere`", "nowhere", None),
        ("types: [[.]]", f"`types` {FOLDER}", "[.]", None),
        ("templates: ~nobody-at-all/x", "there is no folder `~nobody-at-all/x`",
         "~nobody-at-all/x", None),
        ("target: rospy\ntarget: rclpy", "`target` is set twice", "target", None),
        ("target: rospy\ndistribution: jazzy",
         "`jazzy` is no distribution of ROS 1, which `rospy` is for", "jazzy",
         "for `rospy` there is noetic"),
        ("- a\n- b", "a project file is a list of `key: value` lines", "- a\n- b", None),
        ("just text", "a project file is a list of `key: value` lines", "just text", None),
    ],
)  # fmt: skip
def test_mistake_has_a_place(
    tmp_path: Path, text: str, message: str, place: str, remedy: str | None
) -> None:
    _, mistakes = read(tmp_path, text)
    assert mistakes[0][:2] == (message, place)
    if remedy is not None:
        assert mistakes[0][2] == remedy


def test_what_is_right_counts_beside_what_is_wrong(tmp_path: Path) -> None:
    project, mistakes = read(tmp_path, "target: rclpy\noutput: 7\nfoo: bar\n")
    assert (project.target, project.output, len(mistakes)) == ("rclpy", None, 2)


BOMB = "a: &a [x,x,x,x,x,x,x,x,x]\n" + "".join(
    f"{b}: &{b} [{','.join([f'*{a}'] * 9)}]\n"
    for a, b in zip("abcdefghijk", "bcdefghijkl", strict=True)
)


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("target: [", "(line 1)"),
        ("target: rospy\n\tx: y", "(line 2)"),
        ("a: *nowhere", "undefined alias"),
        ("--- a\n--- b", "(line 2)"),
        ("%YAML 9\n---", "(line 1)"),
        ("a: \x07", "special characters are not allowed"),
        (b"target: \xff", "it is not UTF-8"),
        ("[" * 5_000, "it is nested too deeply"),
        ("#" * (LARGEST_PROJECT + 1), "it is larger than 64 kB"),
    ],
)
def test_file_that_is_no_yaml(tmp_path: Path, text: str | bytes, reason: str) -> None:
    project, ((message, _, _),) = read(tmp_path, text)
    assert project == Project(tmp_path / FILE_NAME)
    assert message.startswith("the project file cannot be read")
    assert reason in message
    assert "\n" not in message


def test_aliases_do_not_blow_up(tmp_path: Path) -> None:
    _, mistakes = read(tmp_path, BOMB + "target: *l\noutput: *l\ntypes: *l\n")
    assert "`target` cannot be a sequence" in [message for message, _, _ in mistakes]
    assert all(len(message) < 200 for message, _, _ in mistakes)


def test_nothing_is_constructed(tmp_path: Path) -> None:
    text = "target: !!python/object/apply:os.system [touch pwned]"
    assert read(tmp_path, text)[1][0][0] == "`target` cannot be a sequence"
    assert not Path("pwned").exists()


def test_nearest_folder_counts(tmp_path: Path) -> None:
    deep = tmp_path / "a" / "b"
    deep.mkdir(parents=True)
    (tmp_path / FILE_NAME).write_text("target: rospy")
    assert find_project(find_boundary(deep), LIBRARIES)[0].target == "rospy"
    (tmp_path / "a" / FILE_NAME).write_text("target: rclpy")
    assert find_project(find_boundary(deep), LIBRARIES)[0].target == "rclpy"
    (deep / FILE_NAME).mkdir()
    assert find_project(find_boundary(deep), LIBRARIES)[0].file == tmp_path / "a" / FILE_NAME
