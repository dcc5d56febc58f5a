"""What the wizard's frame says."""

from __future__ import annotations

from dataclasses import replace

from plastron_tui.diagnostics import has_errors, listed
from plastron_tui.language import SlotKind
from plastron_tui.language import statements as st
from plastron_tui.session import Session

from .context import Scene
from .driving_lines import explained
from .goals import DRIVE, GROUPS, Aim
from .menu_page import Item
from .obstacles import measures_distance
from .pages import Look, Page, PageKind

DONE = "It is in the program now. One undo (Ctrl-Z in the editor) takes it out again."


def unanswered(look: Look) -> str:
    """Return the service whose answer nobody has said, of what is written; "" for none."""
    last = look.filled[-1] if look.filled else None
    if last is None or last.form.declaration.type is not st.ProvidesService:
        return ""
    cells = {slot.kind: last.cells[slot.name].text for slot in last.form.declaration.slots}
    return "" if cells.get(SlotKind.ANSWER) else cells.get(SlotKind.SERVICE, "")


def done_items(session: Session, heard: str, service: str = "") -> dict[str, Item]:
    """Return what can be done once the statements are in the program, by the actions.

    Args:
        session: the program.
        heard: the topic to which a node listens since then, "" for none.
        service: the service whose answer is still to be written, "" for none.
    """
    workspace = session.workspace
    closed = ""
    if has_errors(session.diagnostics):
        closed = "a problem in the program has to be fixed first"
    elif not workspace.is_written:
        closed = "the program writes nothing to a file yet"
    idle = closed or ("" if workspace.may_run else "the program has no node to run yet")
    is_whole = not closed and Scene(session).lonely == 0
    is_far = any(
        name == heard and measures_distance(type_)
        for node in workspace.nodes
        for name, type_ in Scene(session).heard(node).items()
    )
    is_robot = bool(workspace.robots) and not workspace.nodes
    held = {name for each in workspace.packages.values() for name in each.contents}
    items: dict[str, Item] = {
        "more": Item("something more", "",
                     "Another node or robot, or something more for one that is there.",
                     is_advised=not (is_whole or is_robot or is_far)),
        "screen.generate": Item("write the files", "", "Shows each file before it is written.",
                                closed, is_whole and bool(idle) and not is_robot),
        "screen.run(True)": Item("run the nodes", "",
                           "Writes the files, starts the nodes and shows what they say.", idle,
                           is_whole and not idle and not is_robot),
    }  # fmt: skip
    if workspace.robots:
        about = "Its links and joints as a tree, and how it looks from three sides."
        items["screen.show('robots')"] = Item("look at the robot", "", about, "", is_robot)
        about = "A link, with its shape, its weight, and where it is."
        items["part"] = Item("give the robot another part", "", about)
    if is_robot and not held.issuperset(workspace.robots):
        about = "With a launch file that starts it: then it can be run."
        items["package"] = Item("make the robot a package", "package", about)
    if is_far:
        about = f"It drives as long as `{heard}` says that nothing is near, and stops where it is."
        items = {key: replace(each, is_advised=False) for key, each in items.items()}
        items["answer"] = Item("drive until something is near", "", about, "", is_advised=True)
    elif heard:
        about = "A message that answers each of them, or those for which a condition holds."
        items["answer"] = Item(f"send something for each message of `{heard}`", "", about)
    if service:
        about = f"The answer of `{service}` is empty: its function is where you fill it in."
        items["screen.code"] = Item(f"write the answer of `{service}`", "", about)
    items[""] = Item("back to the text", "", "Go on in the editor.")
    # What most would do next stands first, and all others as they always do.
    first = {key: each for key, each in items.items() if each.is_advised}
    return {**first, **items}


def title(page: Page, is_done: bool, group: Aim | None = None) -> str:
    """Return the title of a page; `group` is the menu that was taken, None for that of nodes."""
    if is_done:
        return "Done. And now?"
    if page.kind is PageKind.START:
        return "What do you want?"
    if page.kind is PageKind.PURPOSE:
        return GROUPS[group or Aim.MORE].question
    if page.kind is PageKind.AWAY:
        return "What shall go?"
    if page.kind is PageKind.RECIPES:
        return "Start from a program that works"
    if page.form is None:
        return "This is what will be written"
    declaration = page.form.declaration
    if page.form.drives:
        return DRIVE[0][:1].upper() + DRIVE[0][1:]
    words = declaration.purpose[:1].upper() + declaration.purpose[1:]
    return f"{words} · {declaration.ros_term}" if declaration.ros_term else words


def question(page: Page, look: Look, group: Aim | None = None) -> str:
    """Return the line above a menu."""
    if page.kind is PageKind.START:
        return (
            "The wizard writes statements, the same that you could type: "
            "you see them grow, and the code that they become."
        )
    if page.kind is PageKind.RECIPES:
        return "Each is a whole program: take one, run it, then change it."
    if page.kind is PageKind.AWAY:
        return "Choose what is to be there no longer."
    if group not in (None, Aim.MORE):
        return GROUPS[group].about
    return f"Choose what `{look.node}` shall do." if look.node else "Choose what shall be done."


def review(look: Look) -> str:
    """Return what is said on the last page."""
    outcome = look.outcome
    count = 0 if outcome is None else len(outcome.lines)
    what, it = ("statement goes", "it") if count == 1 else ("statements go", "them")
    words = (
        f"{count} {what} into the program as one step. Finish writes {it} there; Back changes {it}."
    )
    numbers = () if outcome is None else outcome.replaced
    if look.driving:
        return f"{words} {explained(look.driving, is_kept=not numbers)}"
    if not numbers:
        return words
    those = "lines" if len(numbers) > 1 else "line"
    return f"{words} That takes the place of {those} {listed([str(each) for each in numbers])}."


def leaving(look: Look) -> str:
    """Return what is asked of who leaves what was filled in."""
    count = 0 if look.outcome is None else len(look.outcome.lines)
    what = "what was entered"
    if count:
        what = "1 statement" if count == 1 else f"{count} statements"
    return f"Leave the wizard and forget {what}?"


def keys(page: Page, is_done: bool, *, is_turn: bool = False) -> str:
    """Return the keys that matter on a page; `is_turn` where the button of the code has them."""
    if is_done:
        return "↑↓ Enter choose  Esc leave"
    if is_turn:
        return "Enter code and graph  Esc back"
    if page.kind is PageKind.START:
        return "↑↓ Enter choose  Esc leave"
    if page.kind in (PageKind.PURPOSE, PageKind.AWAY, PageKind.RECIPES):
        return "↑↓ Enter choose  Esc back"
    if page.kind is PageKind.REVIEW:
        return "Enter finish  Esc back"
    return "Enter next  Tab field  ↑↓ choice  Esc back"


_KEYS = """\
Enter           the next page
Tab, Shift-Tab  the next field, the one before
Up, Down        the choices of a field
Esc, F2         the page before; nothing is lost
F3              code and graph, in a narrow window
Esc at first    leave; what was not finished leaves no trace"""


def explanation(page: Page, is_done: bool) -> tuple[str, str]:
    """Return the title and the text of the help for a page."""
    text = ""
    if page.form is not None and not is_done:
        declaration = page.form.declaration
        slots = "\n".join(f"{slot.name}: {slot.help}" for slot in declaration.slots)
        about = f"{declaration.about}\n\n{declaration.usage}\n{slots}"
        text = f"{about}\nFor example: {declaration.example}\n\n"
    return title(page, is_done), text + _KEYS
