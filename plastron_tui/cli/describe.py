"""`plastron describe`."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import click

from .common import Report, finish, format_option, print_text

if TYPE_CHECKING:
    from plastron_tui.runtime.describe import DescribedNode


@click.command(epilog="Example: plastron describe > robot.plastron")
@click.option(
    "--ros",
    type=click.Choice(["1", "2"]),
    help="The generation of ROS; without it, that of a program here that names none.",
)
@click.option("--network", is_flag=True, help="Look for the nodes of other machines too.")
@format_option("program", "launch")
def command(ros: str | None, network: bool, format_: str) -> None:
    """Print the ROS graph that is running as a program, or as a launch file.

    Generated and run, the program shows the same nodes, topics, services and types. A launch
    file has their names and parameters; which executables they are is not in the graph.
    """
    from plastron_tui.runtime.describe import describe
    from plastron_tui.runtime.environment import find_environments
    from plastron_tui.runtime.program import to_program
    from plastron_tui.session import Session

    report = Report()
    version = Session().ros.ros_version if ros is None else int(ros)
    environment, diagnostics = find_environments().choose(version)
    report.add(diagnostics, lambda _: None)
    if environment is not None:
        described = describe(environment, network=network)
        report.add(described.diagnostics, lambda _: None)
        if described.nodes is not None and format_ == "launch":
            print_text(_launch_file(described.nodes, environment.ros_version))
        elif described.nodes is not None:
            print_text(to_program(described.nodes, environment.library, environment.ros_version))
    finish(report)


def _launch_file(nodes: Sequence[DescribedNode], ros_version: int) -> str:
    """Return the nodes as a launch file in XML, with a comment on what is not known of them."""
    from plastron_tui.runtime.launch_of_graph import launch_of, not_known, origins_of
    from plastron_tui.targets.launch.xml import write_xml

    origins = origins_of(nodes, ros_version)
    text = write_xml(launch_of(nodes, ros_version, origins), ros_version)
    comment = not_known(nodes, ros_version, origins)
    if comment is None:
        return text
    return text.replace("<launch>\n", f"<launch>\n  <!-- {comment} -->\n", 1)
