"""All panels, in the order of their tabs.

What one shows, and what makes that, is named by its module: to import all of them takes longer than
to show the first text, and one is in sight then.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from .panel import Panel

if TYPE_CHECKING:
    from ..analysis import Analysis
    from .panel import Request

NODES = Panel(
    name="nodes",
    title="Nodes",
    dock="outline",
    keys="alt+1",
    summary="The nodes, each with what it speaks and hears, its timers and its parameters.",
    about=(
        "Each node with its publishers ↑, subscriptions ↓, services ◆ and clients ◇, actions that "
        "it does ★ and wants done ☆, timers ↻ and parameters =. Enter goes to the statement; "
        "Delete writes the one that ends it."
    ),
    widget="program_panel:ProgramPanel",
    maker="nodes",
    is_counted=True,
)
TOPICS = Panel(
    name="topics",
    title="Topics",
    dock="outline",
    keys="alt+2",
    summary="The topics, each with who publishes and who listens.",
    about="Each topic with who publishes ↑ and who listens ↓. A ⚠ says which side is missing.",
    widget="program_panel:ProgramPanel",
    maker="topics",
    is_counted=True,
)
SERVICES = Panel(
    name="services",
    title="Services",
    short="Srv",
    dock="outline",
    keys="alt+3",
    summary="The services and actions, each with who provides it and who calls.",
    about=(
        "Each service with who provides it ◆ and who calls it ◇, and each action with who does the "
        "task ★ and who wants it done ☆. A ⚠ says which side is missing."
    ),
    widget="program_panel:ProgramPanel",
    maker="services",
    is_counted=True,
)
MESSAGES = Panel(
    name="messages",
    title="Messages",
    short="Msg",
    dock="outline",
    keys="alt+4",
    summary="The messages, each with its values.",
    about="Each message with the values of its fields.",
    widget="program_panel:ProgramPanel",
    maker="messages",
    is_counted=True,
)
PREVIEW = Panel(
    name="preview",
    title="Preview",
    short="Code",
    dock="result",
    keys="alt+5",
    summary="The files that the node, or the package, at the cursor becomes.",
    about=(
        "The files that the node, package, launch file, robot or type at the cursor becomes; "
        "▸ marks the line of a node's statement. For a file that is there already: what changes "
        "in it; D shows the whole file. "
        "Many files are a tree: Enter goes to the text of one, T back to the tree."
    ),
    widget="preview_panel:PreviewPanel",
    maker="preview_panel",
    is_slow=True,
)
GRAPH = Panel(
    name="graph",
    title="Graph",
    dock="result",
    keys="alt+6",
    summary="Nodes, topics, services and actions as boxes and arrows.",
    about=(
        "Nodes are boxes with corners, topics, services and actions have round ones. The arrows go "
        "from who speaks to who listens; a line that is broken at another one passes below it. "
        "Arrow keys go from box to box, Ctrl-T enlarges."
    ),
    widget="graph_panel:GraphPanel",
    maker="graph_panel",
    is_slow=True,
)
PACKAGES = Panel(
    name="packages",
    title="Packages",
    short="Pkg",
    dock="result",
    keys="alt+9",
    summary="The packages, the launch files, and the types of the program's own.",
    about=(
        "Each package ▣ with what it contains, each launch file ▶ with what it starts, and the "
        "types ◫ of the program's own. Enter goes to the statement; Delete writes the one that "
        "takes something out again; G the one that writes it to its files."
    ),
    widget="program_panel:ProgramPanel",
    maker="packages",
    is_counted=True,
)
ROBOTS = Panel(
    name="robots",
    title="Robot",
    dock="result",
    keys="alt+l",
    summary="The robots: their links and joints as a tree, and how one looks.",
    about=(
        "Each robot ◈ with its links ■, in their colours, each below the joint that holds it: "
        "fixed ─, revolute ◠, continuous ○, prismatic ⇄, planar ▱, floating ∗. Enter goes to the "
        "statement; Delete writes the one that takes a part away; G the one that writes it all."
    ),
    widget="robot_panel:RobotPanel",
    maker="robot_panel",
    is_counted=True,
    is_slow=True,
)
LIVE = Panel(
    name="live",
    title="Live",
    dock="result",
    keys="alt+v",
    summary="What travels between the nodes that run.",
    about=(
        "Each topic ≈ of the nodes that run, with how often a message comes and what is in the "
        "last one; Enter unfolds its fields, P sends a message to it, once or at a rate. Enter on "
        "a service ◆ calls it, on an action ★ sends it a goal; X ends what is sent, or a goal. "
        "Enter on a node ● shows its parameters, and on a parameter sets it. What is not in "
        "sight is not listened to. / shows only what has certain words in its name or type."
    ),
    widget="live_panel:LivePanel",
)
PROBLEMS = Panel(
    name="problems",
    title="Problems",
    dock="bottom",
    keys="alt+7",
    summary="What is wrong, and how to fix it.",
    about="Everything that is wrong. Enter goes there; F fixes it where there is a ⚑.",
    widget="wrapped_list:WrappedList",
    maker="problems",
    is_counted=True,
    is_alarm=True,
)
OUTPUT = Panel(
    name="output",
    title="Output",
    dock="bottom",
    keys="alt+8",
    summary="What the nodes print while they run.",
    about=(
        "What the nodes print that F5 started, each in its colour. A line that comes again is "
        "counted: ×37. Of a long line the first rows are shown, and all with Enter. T shows "
        "when each came; / shows only the lines with certain words, Esc in "
        "that field shows all. Scroll up to read: the lines stay where they are until you go to "
        "the end."
    ),
    widget="output:OutputPanel",
    is_kept=False,
)

PANELS = (
    NODES, TOPICS, SERVICES, MESSAGES, PREVIEW, GRAPH, PACKAGES, ROBOTS, LIVE, PROBLEMS, OUTPUT,
)  # fmt: skip

BY_NAME = {panel.name: panel for panel in PANELS}


def counts(analysis: Analysis) -> dict[str, int]:
    """Count what is in each panel."""
    return {panel.name: panel.count(analysis) for panel in PANELS if panel.is_counted}


def make(analysis: Analysis, request: Request) -> None:
    """Make what a panel asked for, once."""
    analysis.once(request, lambda: BY_NAME[request.panel].make(analysis, request.what))
