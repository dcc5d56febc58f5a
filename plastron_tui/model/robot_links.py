"""The statements about links of robots."""

from __future__ import annotations

from plastron_tui.diagnostics import Code, Diagnostic, Edit, Fix, Label, Span, codes, guess
from plastron_tui.language import statements as st
from plastron_tui.ros.robots.changes import LinkValues, Note, changed_link, new_link
from plastron_tui.ros.robots.description import Link, Mesh

from .mistake import Mistake
from .robot_computed import check_not_computed
from .robot_lookups import (
    check_makable,
    check_name,
    check_new,
    find_own_link,
    find_robot,
)
from .robot_parts import material_of, position_of, rotation_of, weight_of
from .robot_shapes import shape_of
from .robot_slips import link_slips
from .robots import Places, Robot
from .run import Run

_SLOTS = {
    "shape": "shape",
    "mass": "weight",
    "material": "color",
    "position": "position",
    "rotation": "rotation",
}
"""The slots that the values of a link stand in."""

_DONE = {
    "mass": "weighs something",
    "material": "is painted",
    "position": "is placed",
    "rotation": "is turned",
}
"""What is said of a link that has a shape for it."""


def has_link(run: Run, statement: st.HasLink) -> None:
    """Give a robot a link, or change one that a loaded robot has."""
    robot = find_robot(run, statement)
    check_link_named(run, statement)
    values = LinkValues(
        shape_of(statement),
        weight_of(statement),
        material_of(statement, robot),
        position_of(statement),
        rotation_of(statement),
    )
    name = statement.link
    check_not_computed(robot, statement)
    there = robot.description.links.get(name)
    if there is None:
        link, notes = new_link(name, values, run.setting.mesh_bounds)
    else:
        link, notes = changed_link(there, values, run.setting.mesh_bounds)
    told = [_told(run, statement, there or link, note, field) for note, field in notes]
    if any(note.is_refusal for note, _ in notes):
        misspelt = None if there is not None else _misspelt(robot, statement)
        raise Mistake(*(told if misspelt is None else (misspelt,)))
    for each in (*told, *link_slips(statement)):
        run.report(statement, each)
    robot.put_link(link)
    places = robot.links.get(name, Places())
    is_new = there is None
    robot.links[name] = (
        places._replace(made=statement.span) if is_new else places._replace(changed=statement.span)
    )


def _misspelt(robot: Robot, statement: st.HasLink) -> Diagnostic | None:
    """Say which link a new one may have been meant to be, that lacks a shape."""
    if statement.shape is not None:
        return None
    where = statement.span_of("link")
    near, fix = guess(statement.link, robot.description.links, where, is_quoted=True)
    if near is None:
        return None
    message = f"`{robot.variable}` has no link `{statement.link}`, and a new one lacks its shape"
    return Diagnostic(codes.BAD_SHAPE, message, where, help=near, fix=fix)


def check_link_named(run: Run, statement: st.HasLink) -> None:
    """Check that a link may have its name, and is made and changed once."""
    robot = run.workspace.robots.get(statement.robot)
    name, where = statement.link, statement.span_of("link")
    if robot is None:
        check_name("link", name, where)
        return
    check_new(robot.links, name, "link", where)
    check_makable(robot, "link", name, where)
    if name not in robot.description.links:
        check_name("link", name, where)
    elif all(getattr(statement, slot) is None for slot in _SLOTS.values()):
        message = f"`{robot.variable}` has a link `{name}`, and nothing is said of it"
        help_text = "say what changes, or choose another name"
        raise Mistake(Diagnostic(codes.PART_EXISTS, message, where, help=help_text))


def _told(run: Run, statement: st.HasLink, link: Link, note: Note, field: str) -> Diagnostic:
    """Return what is said of a note on what a statement says of a link."""
    slot = _SLOTS[field]
    if getattr(statement, slot) is None:
        slot = "shape" if statement.shape is not None else "link"
    code, message, help_text = _words(run, statement, link, note, field)
    if note is Note.UNKNOWN_SIZE:
        why, help_text = _unmeasured(run, statement, link)
        message = f"{why}, so the inertia of `{link.name}` {message}"
    return Diagnostic(code, message, statement.span_of(slot), help=help_text)


def _words(
    run: Run, statement: st.HasLink, link: Link, note: Note, field: str
) -> tuple[Code, str, str | None]:
    name, again = link.name, f"{statement.robot} has_link '{link.name}'"
    match note:
        case Note.NO_SHAPE:
            return codes.BAD_SHAPE, f"what {_DONE[field]} has a shape", "say `shaped …`"
        case Note.NOT_SEEN:
            message = f"nothing of `{name}` is seen that could be painted"
            return codes.BAD_SHAPE, message, "give it a shape as well: `shaped …`"
        case Note.SEVERAL_SHAPES:
            counts = ((len(link.visuals), "visual"), (len(link.collisions), "collision"))
            parts = " and ".join(f"{count} {each}{'s' * (count != 1)}" for count, each in counts)
            message = f"`{name}` has {parts}: which one is meant cannot be said"
            return codes.SEVERAL_SHAPES, message, _instead_of_one(run, statement, field)
        case Note.BOX_INERTIA:
            message = f"the inertia of `{name}` is that of the box around its mesh"
            return codes.MESH_INERTIA, message, None
        case Note.UNKNOWN_SIZE:
            kept = "stays as it was" if link.inertial is not None else "is left out"
            return codes.MESH_INERTIA, kept, None
        case Note.INERTIA_STAYS:
            help_text = f"say what it weighs as well, as in `{again} shaped … weighing …`"
            message = f"the inertia of `{name}` did not follow from its shape, and stays as it is"
            return codes.INERTIA_STAYS, message, help_text
        case Note.OTHER_COLLISION:
            message = f"what is seen of `{name}` and what collides had two shapes, and have one now"
            return codes.LINK_APART, message, "change one of the two in its file"
        case Note.OTHERS_STAY:
            message = (
                f"only the {statement.shape} of `{name}` changes: what else is seen or collides "
                "has another shape, and stays"
            )
            return codes.LINK_APART, message, "change that in its file"
        case Note.APART:
            message = f"not all of `{name}` is in one place: what was elsewhere stays where it is"
            return codes.LINK_APART, message, "collisions and centers of mass may be elsewhere"


def _instead_of_one(run: Run, statement: st.HasLink, field: str) -> str:
    """Say what somebody does who means one of several shapes, or the link as a whole."""
    robot = run.workspace.robots[statement.robot]
    joints = robot.description.joints.values()
    joint = next((each for each in joints if each.child == statement.link), None)
    span = None if robot.source is None else robot.source.spans.get(("link", statement.link))
    where = "in its file"
    if robot.source is not None and span is not None:
        line = robot.source.text.count(b"\n", 0, span.start) + 1
        where = f"in line {line} of its file"
    if field in ("position", "rotation") and joint is not None:
        way = "at" if field == "position" else "turned"
        whole = f"{robot.variable} has_joint '{joint.name}' {way} …"
        return f"`{whole}` is about all of it; one alone is changed {where}"
    return f"change it {where}, or take the link away and make it anew"


def _unmeasured(run: Run, statement: st.HasLink, link: Link) -> tuple[str, str | None]:
    """Say why nobody knows how large the mesh of a link is, and what to do."""
    shapes = (each.shape for each in (*link.collisions, *link.visuals))
    said = shape_of(statement)
    meshes = [each for each in (said, *shapes) if isinstance(each, Mesh)]
    for mesh in meshes:
        why, remedy = run.setting.mesh_problem(mesh.uri)
        if why:
            return f"how large `{mesh.uri}` is cannot be told ({why})", remedy
    return "how large the mesh is cannot be told", None


def no_longer_has_link(run: Run, statement: st.NoLongerHasLink) -> None:
    """Take a link away from a robot."""
    robot = find_robot(run, statement)
    name, where = statement.link, statement.span_of("link")
    find_own_link(run, robot, name, where)
    check_not_computed(robot, statement)
    holding = next(robot.holding(name), None)
    if holding is not None:
        raise _held(run, robot, statement, holding.name)
    robot.take_link(name, where)


def _held(run: Run, robot: Robot, statement: st.NoLongerHasLink, joint: str) -> Mistake:
    if run.consequences.has_part(joint) or run.consequences.mentions(joint):
        return Mistake()
    message = f"the joint `{joint}` still holds `{statement.link}`"
    made = robot.joints.get(joint, Places()).made
    labels = () if made is None else (Label(made, "here"),)
    first = f"{robot.variable} no_longer_has_joint '{joint}'"
    start = statement.span.start
    fix = Fix(f"write `{first}` first", (Edit(Span(start, start), f"{first}\n"),))
    return Mistake(
        Diagnostic(
            codes.PART_IN_USE,
            message,
            statement.span_of("link"),
            help=f"take it away first: `{first}`",
            fix=fix,
            labels=labels,
        )
    )
