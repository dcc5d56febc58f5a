"""The menu of what can be done once the statements are in the program."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from plastron_tui.diagnostics import has_errors
from plastron_tui.model.graph import NOUNS
from plastron_tui.ros.interfaces import InterfaceKind
from plastron_tui.ros.motion import is_command
from plastron_tui.session import Session

from .context import Meeting, Scene
from .menu_page import Item
from .obstacles import measures_distance

DONE = "It is in the program now. One undo (Ctrl-Z in the editor) takes it out again."

_ANOTHER = "another"
"""The key of what adds a node where one side of a topic, a service or an action is missing."""

RUN = "screen.run(True, True)"
"""What starts the nodes: who comes from the wizard types nothing, and wants to see them."""

_SENSORS = "sensor_msgs"
"""The package of the messages that a robot itself sends."""


def done_items(session: Session, heard: str, service: str = "") -> dict[str, Item]:
    """Return what can be done once the statements are in the program, by the actions.

    What most would do next stands first, and all others as they always do.

    Args:
        session: the program.
        heard: the topic to which a node listens since then, "" for none.
        service: the service whose answer is still to be written, "" for none.
    """
    items = dict(_usual(session))
    items |= _of_robots(session)
    if heard and _is_far(session, heard):
        about = f"It drives as long as `{heard}` says that nothing is near, and stops where it is."
        items = {key: replace(each, is_advised=False) for key, each in items.items()}
        items["answer"] = Item("drive until something is near", "", about, "", is_advised=True)
    elif heard:
        about = "A message that answers each of them, or those for which a condition holds."
        items["answer"] = Item(f"send something for each message of `{heard}`", "", about)
    if service:
        about = "Writes its function, and shows the line where the answer goes."
        items = {key: replace(each, is_advised=False) for key, each in items.items()}
        items[f"screen.code({service!r})"] = Item(
            f"write the answer of `{service}`", "", about, "", True
        )
    items[""] = Item("back to the text", "", "Go on in the editor.")
    first = {key: each for key, each in items.items() if each.is_advised}
    return {**first, **items}


def _usual(session: Session) -> Iterator[tuple[str, Item]]:
    """Yield what there always is, and the other side of what has but one."""
    workspace = session.workspace
    closed = ""
    if has_errors(session.diagnostics):
        closed = "a problem in the program has to be fixed first"
    elif not workspace.is_written:
        closed = "the program writes nothing to a file yet"
    idle = closed or ("" if workspace.may_run else "the program has no node to run yet")
    missing = _missing(session)
    is_robot = _is_robot(session)
    is_whole = not (closed or missing or is_robot)
    if missing:
        yield _ANOTHER, Item("add another node", "node", missing, is_advised=True)
    about = "Another node or robot, or something more for one that is there."
    is_advised = not (is_whole or missing or is_robot)
    yield "more", Item("something more", "", about, is_advised=is_advised)
    about = "Shows each file before it is written."
    is_advised = is_whole and bool(idle)
    yield "screen.generate", Item("write the files", "", about, closed, is_advised)
    about = f"Writes the files, starts the nodes and shows what they say.{_callable(session)}"
    yield RUN, Item("run the nodes", "", about, idle, is_whole and not idle)


def _callable(session: Session) -> str:
    """Say how a service is called that no node of the program calls; "" where there is none."""
    scene = Scene(session)
    found = (
        each.name
        for version in (1, 2)
        for each in scene.meetings(InterfaceKind.SERVICE, version).values()
        if each.takers and not each.senders
    )
    name = next(found, None)
    return "" if name is None else f" Enter on `{name}` in Live calls it: no node does yet."


def _is_robot(session: Session) -> bool:
    """Tell whether a program describes robots, and has no node."""
    return bool(session.workspace.robots) and not session.workspace.nodes


def _of_robots(session: Session) -> dict[str, Item]:
    """Return what can be done with the robots of a program."""
    workspace, is_robot = session.workspace, _is_robot(session)
    items = {}
    if workspace.robots:
        about = "Its links and joints as a tree, and how it looks from three sides."
        items["screen.show('robots')"] = Item("look at the robot", "", about, "", is_robot)
        about = "A link, with its shape, its weight, and where it is."
        items["part"] = Item("give the robot another part", "", about)
    held = {name for each in workspace.packages.values() for name in each.contents}
    if is_robot and not held.issuperset(workspace.robots):
        about = "With a launch file that starts it: then it can be run."
        items["package"] = Item("make the robot a package", "package", about)
    return items


def _is_far(session: Session, heard: str) -> bool:
    """Tell whether a topic that a node listens to says how far away things are."""
    return any(
        name == heard and measures_distance(type_)
        for node in session.workspace.nodes
        for name, type_ in Scene(session).heard(node).items()
    )


def _missing(session: Session) -> str:
    """Say which side of a topic, a service or an action is missing, "" where none is."""
    scene = Scene(session)
    for kind in InterfaceKind:
        for version in (1, 2):
            for each in scene.meetings(kind, version).values():
                if each.is_lonely and not _is_used_elsewhere(session, kind, each):
                    return _said(kind, each)
    return ""


def _is_used_elsewhere(session: Session, kind: InterfaceKind, meeting: Meeting) -> bool:
    """Tell whether the other side need not be in the program.

    A robot sends and takes itself, a service can be called by hand, and a node that exists already
    has its partners.
    """
    if kind is not InterfaceKind.MESSAGE and meeting.takers:
        return True
    nodes = session.workspace.nodes
    if any(nodes[name].source is not None for name in (*meeting.senders, *meeting.takers)):
        return True
    return _is_of_robot(meeting)


def _is_of_robot(meeting: Meeting) -> bool:
    type_ = meeting.type
    if type_ is None:
        return False
    return type_.package == _SENSORS if meeting.takers else is_command(str(type_))


def _said(kind: InterfaceKind, meeting: Meeting) -> str:
    takes = {InterfaceKind.SERVICE: "answers", InterfaceKind.ACTION: "does"}
    does = "sends" if meeting.takers else takes.get(kind, "listens to")
    return f"Nobody {does} the {NOUNS[kind]} `{meeting.name}` yet: make a node that does."
