"""`plastron describe`."""

from __future__ import annotations

import click

from .common import Report, finish, print_text


@click.command(epilog="Example: plastron describe > robot.plastron")
@click.option(
    "--ros",
    type=click.Choice(["1", "2"]),
    help="The generation of ROS; without it, that of a program here that names none.",
)
@click.option("--network", is_flag=True, help="Look for the nodes of other machines too.")
def command(ros: str | None, network: bool) -> None:
    """Print the ROS graph that is running as a program.

    Generated and run, the program shows the same nodes, topics, services and types.
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
        if described.nodes is not None:
            print_text(to_program(described.nodes, environment.library, environment.ros_version))
    finish(report)
