"""A graph that runs as a launch file: names and parameters, and no guess at the rest."""

from __future__ import annotations

from pathlib import Path

import pytest

from plastron_tui.model.endpoint_details import ParameterDetails
from plastron_tui.ros.launch_resolution import resolve
from plastron_tui.ros.launch_text import Scope
from plastron_tui.runtime.describe import DescribedNode
from plastron_tui.runtime.launch_of_graph import Origin, launch_of, not_known, origin_of
from plastron_tui.sources.launch.xml_reader import read_launch_xml
from plastron_tui.targets.launch.xml import write_xml


@pytest.mark.parametrize("ros_version", [1, 2])
def test_what_it_starts_has_the_names_of_the_graph(ros_version: int) -> None:
    mark = "~" if ros_version == 1 else ""
    values = {"speed": 0.5, "word": "1", "is_on": True, "rates": (1, 2)}
    details = {f"{mark}{name}": ParameterDetails(default=x) for name, x in values.items()}
    nodes = (
        DescribedNode("/arm/left/driver", parameters=details),
        DescribedNode("/talker", parameters={f"{mark}none": ParameterDetails()}),
    )
    origins = {"/talker": Origin("demo", "talker.py")}
    written = write_xml(launch_of(nodes, ros_version, origins), ros_version)
    launch = read_launch_xml(written.encode(), ros_version=ros_version).launch
    assert launch is not None
    driver, talker = resolve(launch, ros_version, Scope()).started
    assert [driver.full_name, talker.full_name] == ["/arm/left/driver", "/talker"]
    if ros_version == 2:
        assert dict(driver.parameters) == values
    assert (talker.package, talker.executable, talker.parameters) == ("demo", "talker.py", ())
    assert driver.package == "PACKAGE"
    assert not_known(nodes, ros_version, origins) is not None
    assert not_known(nodes[1:], ros_version, origins) is None


@pytest.mark.parametrize(
    ("words", "origin"),
    [
        (["{}/src/demo/scripts/talker"], Origin("demo", "talker")),
        (["/usr/bin/env", "{}/src/demo/scripts/talker"], Origin("demo", "talker")),
        (["{}/lib/built/driver"], Origin("built", "driver")),
        # An argument is no executable, and a relative path depends on a folder.
        (["/usr/bin/env", "-x", "{}/src/demo/scripts/talker"], None),
        (["src/demo/scripts/talker"], None),
        (["{}/loose"], None),
        ([""], None),
    ],
)
def test_an_executable_is_known_by_its_package(
    tmp_path: Path, words: list[str], origin: Origin | None
) -> None:
    for file in ("src/demo/scripts/talker", "lib/built/driver", "loose"):
        (tmp_path / file).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / file).write_text("")
    for folder, name in (("src/demo", "demo"), ("share/built", "built")):
        (tmp_path / folder).mkdir(parents=True, exist_ok=True)
        text = f"<package><name>{name}</name></package>"
        (tmp_path / folder / "package.xml").write_text(text)
    process = tmp_path / "process"
    process.mkdir()
    line = "\0".join([*words, ""]).format(*[tmp_path] * len(words))
    (process / "cmdline").write_bytes(line.encode())
    assert origin_of(process) == origin
    assert origin_of(tmp_path / "gone") is None
