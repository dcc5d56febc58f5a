"""Packages of one name in several workspaces of a repository: the nearest one is meant."""

from __future__ import annotations

from pathlib import Path

import pytest
from graph_packages import LISTENER, PACKAGE_XML, SETUP, TALKER, code_of, found_in
from hypothesis import given
from hypothesis import strategies as st

from plastron_tui.lint.namesakes import Workspaces, nearest
from plastron_tui.lint.rules.one_sided_examples import PUBLISHED

SECOND = "'listener = demo.listener:main'"
LAUNCH = '<launch>\n<node pkg="demo" exec="{}"/>\n</launch>\n'


def demo(folder: str, setup: str = SETUP, **nodes: str) -> dict[str, str | bytes]:
    """Return a package `demo` in a folder, with nodes by the names of their modules."""
    return {
        f"{folder}/demo/package.xml": PACKAGE_XML,
        f"{folder}/demo/setup.py": setup,
        f"{folder}/demo/demo/__init__.py": "",
        **{
            f"{folder}/demo/demo/{name}.py": f"{text}\ndef main():\n    rclpy.spin(Talker())\n"
            for name, text in nodes.items()
        },
    }


def beside(folder: str, executable: str) -> dict[str, str | bytes]:
    """Return a package that starts a program of `demo`."""
    return {
        f"{folder}/bringup/package.xml": PACKAGE_XML.replace("demo", "bringup"),
        f"{folder}/bringup/launch/up.launch.xml": LAUNCH.format(executable),
    }


TALKS, HEARS = code_of(TALKER), code_of(LISTENER)
WITHOUT = SETUP.replace(f", {SECOND}", "")
BOTH = demo("one/src", talker=TALKS, listener=HEARS) | demo("two/src", WITHOUT, talker=TALKS)

STARTED = {
    "that_its_own_has": (beside("one/src", "listener"), []),
    "that_another_has": (beside("two/src", "listener"), [("RK506", "up.launch.xml", 2)]),
    "of_neither_for_sure": (beside("three/src", "listener"), []),
    "that_none_has_for_sure": (beside("three/src", "speaker"), []),
}


@pytest.mark.parametrize(("files", "expected"), STARTED.values(), ids=STARTED)
def test_a_launch_file_starts_a_program(
    tmp_path: Path, files: dict[str, str | bytes], expected: list[tuple[str, str, int]]
) -> None:
    assert found_in(tmp_path, BOTH | files, "RK506") == expected


NUMBER = code_of(LISTENER, type="Int32")
MISSPELT = code_of(LISTENER, topic="chater")
STRICT = code_of(LISTENER, qos="QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)")
OTHER = {
    "another_type": (NUMBER, "RG101"),
    "another_quality_of_service": (STRICT, "RG102"),
    "a_slip": (MISSPELT, "RG104"),
}


@pytest.mark.parametrize(("listener", "rule"), OTHER.values(), ids=OTHER)
def test_nodes_of_two_workspaces_do_not_meet(tmp_path: Path, listener: str, rule: str) -> None:
    one, two = demo("one/src", talker=TALKS), demo("two/src", listener=listener)
    assert found_in(tmp_path / "apart", one | two, rule) == []
    both = demo("one/src", talker=TALKS, listener=listener)
    found = found_in(tmp_path / "together", both | two, rule)
    assert [code for code, *_ in found] == [rule]


NEAREST = {
    "the_same_folder": (["/w/a/demo", "/w/b/demo"], "/w/a/launch/x.launch", "/w/a/demo"),
    "the_package_itself": (["/w/a/demo", "/w/demo"], "/w/a/demo/x.py", "/w/a/demo"),
    "as_near": (["/w/a/demo", "/w/b/demo"], "/w/c/x.launch", None),
    "a_name_that_starts_alike": (["/w/ab/demo", "/w/b/demo"], "/w/a/x.launch", None),
    "none": ([], "/w/a/x.launch", None),
}


@pytest.mark.parametrize(("folders", "file", "expected"), NEAREST.values(), ids=NEAREST)
def test_nearest_folder(folders: list[str], file: str, expected: str | None) -> None:
    found = nearest(map(Path, folders), Path(file))
    assert found == (None if expected is None else Path(expected))


def test_launch_file_starts_the_nodes_of_its_own_workspace(tmp_path: Path) -> None:
    files = demo("one/src", talker=TALKS, listener=code_of(LISTENER, topic="news", type="Int32"))
    files |= demo("two/src", talker=TALKS, listener=HEARS)
    files["one/src/demo/launch/up.launch.xml"] = (
        '<launch>\n<node pkg="demo" exec="talker"><remap from="chatter" to="news"/></node>\n'
        '<node pkg="demo" exec="listener"/>\n</launch>\n'
    )
    found = found_in(tmp_path, files, "RG101")
    assert [name for _, name, _ in found] == ["listener.py"]


def test_launch_file_includes_one_of_its_own_workspace(tmp_path: Path) -> None:
    node = '<launch>\n<node pkg="other" exec="x" name="{}"/>\n{}</launch>\n'
    include = '<include file="$(find-pkg-share demo)/launch/in.launch.xml"/>\n'
    files = demo("one/src") | demo("two/src") | beside("one/src", "x")
    files["one/src/demo/launch/in.launch.xml"] = node.format("a", "")
    files["two/src/demo/launch/in.launch.xml"] = node.format("b", "")
    files["one/src/bringup/launch/up.launch.xml"] = node.format("a", include)
    found = found_in(tmp_path, files, "RG103")
    assert [name for _, name, _ in found] == ["in.launch.xml"]


def test_parameter_file_is_for_the_nodes_of_its_own_workspace(tmp_path: Path) -> None:
    one, two = (
        code_of(TALKER, before=f"self.declare_parameter('{name}', 1.0)")
        for name in ("rate", "speed")
    )
    files = demo("one/src", talker=one) | demo("two/src", talker=two)
    values = "talker:\n  ros__parameters:\n    speed: 1.0\n    rate: 2.0\n"
    files["two/src/demo/config/talker.yaml"] = values
    assert found_in(tmp_path, files, "RP301") == [("RP301", "talker.yaml", 4)]


def test_name_of_another_workspace_is_not_meant(tmp_path: Path) -> None:
    files = dict(PUBLISHED["bad"]) | demo("one/src") | demo("two/src")
    assert [code for code, *_ in found_in(tmp_path / "together", files, "RG")] == ["RG107"]
    moved = {f"one/src/{name}": files.pop(name) for name in ("tank.py",)}
    moved |= {f"two/src/{name}": files.pop(name) for name in ("display.py",)}
    assert found_in(tmp_path / "apart", files | moved, "RG") == []


FOLDERS = st.lists(st.sampled_from("ab"), max_size=3).map(lambda names: Path("/w", *names))
SEVERAL = st.dictionaries(st.sampled_from("xyz"), st.sets(FOLDERS, min_size=2), max_size=3)


@given(SEVERAL, FOLDERS, FOLDERS)
def test_files_are_apart_that_mean_different_packages(
    namesakes: dict[str, set[Path]], one: Path, other: Path
) -> None:
    files = one / "x.py", other / "y.py"
    meant = [{name: nearest(each, file) for name, each in namesakes.items()} for file in files]
    workspaces = Workspaces(namesakes)
    first, second = map(workspaces.number_of, files)
    assert (first == second) == (meant[0] == meant[1])
    sure = [{name: folder for name, folder in each.items() if folder} for each in meant]
    shared = sure[0].keys() & sure[1].keys()
    is_apart = any(sure[0][name] != sure[1][name] for name in shared)
    assert workspaces.are_apart(first, second) == workspaces.are_apart(second, first) == is_apart
    kept = {first, second} - ({first} if sure[0].items() < sure[1].items() else set())
    kept -= {second} if sure[1].items() < sure[0].items() else set()
    assert set(workspaces.widest({first, second})) == kept
