"""Launch files in XML: what is written is read again."""

from __future__ import annotations

import pytest
from hypothesis import HealthCheck, Phase, given, settings
from hypothesis import strategies as some
from launch_files import launch_files

from plastron_tui.sources.launch.xml_reader import read_launch_xml
from plastron_tui.targets.launch.xml import write_xml


@pytest.mark.parametrize("ros_version", [1, 2])
@settings(
    max_examples=60,
    deadline=None,
    suppress_health_check=list(HealthCheck),
    # What is drawn is large, and shrinks for minutes.
    phases=(Phase.explicit, Phase.reuse, Phase.generate),
)
@given(data=some.data())
def test_what_is_written_is_read_again(ros_version: int, data: some.DataObject) -> None:
    launch = data.draw(launch_files(ros_version))
    written = write_xml(launch, ros_version)
    read = read_launch_xml(written.encode(), ros_version=ros_version)
    assert read.diagnostics == ()
    assert read.launch is not None
    assert read.launch == launch, written
