"""Launch files in XML: what is written is read again."""

from __future__ import annotations

import pytest
from hypothesis import HealthCheck, Phase, given, settings
from hypothesis import strategies as some
from launch_files import launch_files
from machine import examples

from plastron_tui.ros.launch import Text
from plastron_tui.ros.launch_text import text
from plastron_tui.sources.launch.elements import value_of
from plastron_tui.sources.launch.xml_reader import read_launch_xml
from plastron_tui.targets.launch.xml import write_xml


@pytest.mark.parametrize("ros_version", [1, 2])
@settings(
    max_examples=examples(60),
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


@pytest.mark.parametrize(
    ("source", "value"),
    [
        (r'["\\$("]', ("$(",)),
        (r'["a", "\\$(var x)"]', ("a", "$(var x)")),
        ('["a", "$(var x)"]', None),
        ("[1, $(var x)]", None),
    ],
)
def test_texts_in_lists_are_read_one_by_one(source: str, value: tuple[str, ...] | None) -> None:
    found = value_of(text("names"), source, None, 2).value
    assert isinstance(found, Text) if value is None else found == value
