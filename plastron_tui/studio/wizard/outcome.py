"""What is always in view: the code that a node becomes, and the graph with its new part marked."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

from plastron_tui.model.graph import Graph, Hub, graph_of
from plastron_tui.ros.interfaces import InterfaceKind
from plastron_tui.session import Session

from ..analysis import analyse
from ..panels.preview import Preview, previews_of
from ..panels.styles import Line, Lines, Piece
from .code_changes import Code, changed_rows, marked


def code_of_robot(before: Session | None, after: Session, robot: str) -> Code:
    """Return a robot's file, its changes marked; of a loaded one what changes in it.

    Args:
        before: the program without the change, None where all is new.
        after: the program with it.
        robot: its variable.
    """
    old = None
    if before is not None and robot in before.workspace.robots:
        old = previews_of(analyse(before, lambda: None), robot)[0]
    return _code(old, previews_of(analyse(after, lambda: None), robot)[0], is_loaded=True)


def look_of_robot(session: Session, robot: str, part: str, width: int, height: int) -> Lines:
    """Return how a robot looks, as large as fits; one part of it stands out."""
    from ..panels.robot_picture import picture_of, sides_of

    shown = session.workspace.robots[robot]
    return picture_of(shown, sides_of(session, shown), width, height, marked=part)


def code_of(before: Session | None, after: Session, node: str | None) -> Code:
    """Return the file that a node becomes, its changes marked; of a loaded one what changes in it.

    Args:
        before: the program without the change, None where all is new.
        after: the program with it.
        node: its variable.
    """
    new = None if node is None else _preview_of(after, node)
    if node is None or new is None:
        return Code("", ((Piece(" it comes with a node", "quiet"),),))
    old = None if before is None else _preview_of(before, node)
    return _code(old, new, is_loaded=after.workspace.nodes[node].source is not None)


def _code(old: Preview | None, new: Preview, *, is_loaded: bool) -> Code:
    if new.problems and not new.lines:
        return Code(
            new.name, tuple((Piece(f" {each.message}", "warning"),) for each in new.problems)
        )
    if new.diff and is_loaded:
        shown = () if old is None else old.diff or ()
        return Code(f"{new.name}: what changes", new.diff, changed_rows(shown, new.diff))
    # Where all is new, nothing stands out.
    before = new.lines if old is None or not old.lines else old.lines
    return Code(new.name, *marked(before, new.lines))


def _preview_of(session: Session, node: str) -> Preview | None:
    """Return the file of a node that says most, None where there is no such node."""
    found = session.workspace.nodes.get(node)
    if found is None:
        return None
    previews = previews_of(analyse(session, lambda: None), node)
    return _main(previews, is_loaded=found.source is not None)


def _main(previews: Sequence[Preview], *, is_loaded: bool) -> Preview | None:
    """Return the file of a node that says most: of a loaded one, one that changes."""
    main = next((each for each in reversed(previews) if each.is_main), None)
    if is_loaded and main is not None and main.path is not None and not main.diff:
        return next((each for each in previews if each.diff), main)
    return main


def arrows_of(before: Session, after: Session) -> Lines:
    """Return the graph as a list: who sends what to whom; what is new is marked."""
    old, new = graph_of(before.workspace), graph_of(after.workspace)
    known = set(_parts(old))
    return tuple(_marked(new, known)) or ((Piece("nothing yet", "quiet"),),)


def new_names(before: Session, after: Session) -> frozenset[str]:
    """Return the names of the nodes, topics and services that are new."""
    return frozenset(_names(graph_of(after.workspace))) - frozenset(
        _names(graph_of(before.workspace))
    )


def drawing_of(before: Session, after: Session, width: int, height: int) -> Lines:
    """Return the graph as a picture that fits; what is new is marked."""
    from ..panels.fitting import Size
    from ..panels.picture import picture_of

    names = new_names(before, after)
    return tuple(
        tuple(
            Piece(piece.text, "added")
            if piece.tone == "strong" and piece.text.strip() in names
            else piece
            for piece in line
        )
        for line in picture_of(graph_of(after.workspace)).fitted(Size(width, height)).lines
    )


def _names(graph: Graph) -> Iterator[str]:
    yield from (node.name for node in graph.nodes)
    yield from (hub.name for hub in graph.hubs)


def _ends(hub: Hub) -> tuple[list[str], list[str]]:
    """Return the nodes on both sides of a topic or a service, in the direction of the arrow."""
    return [end.node.name for end in hub.tails], [end.node.name for end in hub.heads]


def _parts(graph: Graph) -> Iterator[tuple[str, ...]]:
    """Yield everything that a list of the graph shows, each by what tells it from the rest."""
    yield from (("node", node.name) for node in graph.nodes)
    for hub in graph.hubs:
        yield ("hub", hub.name)
        tails, heads = _ends(hub)
        yield from ((hub.name, "from", name) for name in tails)
        yield from ((hub.name, "to", name) for name in heads)


def _marked(graph: Graph, known: set[tuple[str, ...]]) -> Iterator[Line]:
    met: set[str] = set()

    def piece(text: str, key: tuple[str, ...], tone: str = "") -> Piece:
        return Piece(text, tone if key in known else "added")

    for hub in graph.hubs:
        tails, heads = _ends(hub)
        met.update(tails, heads)
        is_topic = hub.interface is InterfaceKind.MESSAGE
        line = [*_listed(hub.name, "from", tails, piece), Piece(" → ", "dim")]
        line.append(piece(hub.name, ("hub", hub.name), "success" if is_topic else "warning"))
        line += [Piece(" → ", "dim"), *_listed(hub.name, "to", heads, piece)]
        yield tuple(line)
    for node in graph.nodes:
        if node.name not in met:
            yield (piece(node.name, ("node", node.name), "primary"),)


def _listed(hub: str, side: str, names: list[str], piece: Callable[..., Piece]) -> Iterator[Piece]:
    if not names:
        yield Piece("nobody", "quiet")
    for number, name in enumerate(names):
        if number:
            yield Piece(", ")
        yield piece(name, (hub, side, name), "primary")
