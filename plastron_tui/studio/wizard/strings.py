"""What the wizard's frame says."""

from __future__ import annotations

from plastron_tui.diagnostics import Severity, listed
from plastron_tui.language import SlotKind
from plastron_tui.language import statements as st
from plastron_tui.session import Session

from .driving_lines import explained
from .followers import STOP
from .form import Form
from .goals import DRIVE, GROUPS, Aim, told
from .obstacles import is_standing
from .pages import Look, Page, PageKind
from .sent_already import sent_already


def unanswered(look: Look) -> str:
    """Return the service whose answer nobody has said, of what is written; "" for none."""
    last = look.filled[-1] if look.filled else None
    if last is None or last.form.declaration.type is not st.ProvidesService:
        return ""
    cells = {slot.kind: last.cells[slot.name].text for slot in last.form.declaration.slots}
    return "" if cells.get(SlotKind.ANSWER) else cells.get(SlotKind.SERVICE, "")


def title(page: Page, is_done: bool, group: Aim | None = None) -> str:
    """Return the title of a page; `group` is the menu that was taken, None for that of nodes.

    Of what somebody wants it has what stands before the first comma: the menu has said the rest.
    """
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
    if _is_heard_for(page.form):
        return "For this it has to hear something · subscriber"
    words = declaration.purpose.partition(",")[0]
    words = words[:1].upper() + words[1:]
    return f"{words} · {declaration.ros_term}" if declaration.ros_term else words


def _is_heard_for(form: Form) -> bool:
    """Tell whether a form lets a node listen to what another form makes it answer."""
    return form.parent is not None and form.declaration.type is st.Subscribe


def about(form: Form) -> str:
    """Return the sentence above a form."""
    if form.drives:
        return DRIVE[2]
    if _is_heard_for(form):
        return "What it answers, or drives by, arrives on a topic: from a laser, mostly on `scan`."
    return told(form.declaration)


def question(page: Page, look: Look, group: Aim | None = None) -> str:
    """Return the line above a menu."""
    if page.kind is PageKind.START:
        return "The wizard writes statements that you could type: you see what they become."
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
    if any(each.key == STOP for each in look.extras):
        words += " It does not notice when the laser falls silent."
    if _is_standing(look):
        words += " With this it never drives: all that it is sent is 0."
    words += "".join(f" {sent}." for each in look.filled if (sent := sent_already(each)))
    numbers = () if outcome is None else outcome.replaced
    if outcome is not None and not look.problems:
        words += _mistake_before(outcome.session)
    if look.driving:
        return f"{words} {explained(look.driving, is_kept=not numbers)}"
    if not numbers:
        return words
    those = "lines" if len(numbers) > 1 else "line"
    return f"{words} That takes the place of {those} {listed([str(each) for each in numbers])}."


def _is_standing(look: Look) -> bool:
    """Tell whether what is written sends to a robot, and nothing by which it moves."""
    last = look.filled[-1] if look.filled else None
    if last is None or look.outcome is None or last.form.declaration.type is not st.Publish:
        return False
    node = look.outcome.session.workspace.nodes.get(last.cells["node"].text)
    return is_standing(node, last.cells["topic"].text)


def _mistake_before(session: Session) -> str:
    """Say what keeps the program from being run, and was wrong before already; "" for nothing."""
    errors = (each for each in session.diagnostics if each.severity is Severity.ERROR)
    first = next(errors, None)
    if first is None:
        return ""
    return f" The program has a mistake already, and cannot be run before it goes: {first.message}."


def place(program: str, at: int) -> str:
    """Return what stands beside the title: the program that is written to, and the page.

    Args:
        program: the name of its file, "" for one that has none yet.
        at: the number of the page, 0 where they are not counted.
    """
    return f"{program or 'a new program'}{f', step {at}' if at else ''}"


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
        return "Enter finish  Tab Space tick  F1 help  Esc back"
    return "Enter next  Tab field  ↑↓ choice  F1 help  Esc back"


_KEYS = """\
Enter           the next page
Tab, Shift-Tab  the next field, the one before
Up, Down        the choices of a field
Space           tick a box, or take the tick away
a letter        in a menu, the next entry that begins with it
Esc, F2         the page before; nothing is lost
F3              code and graph, in a narrow window
Esc at first    leave; what was not finished leaves no trace"""


def explanation(page: Page, is_done: bool) -> tuple[str, str]:
    """Return the title and the text of the help for a page."""
    text = ""
    if page.form is not None and not is_done:
        declaration = page.form.declaration
        slots = "\n".join(f"{slot.name}: {slot.help}" for slot in declaration.slots)
        told = about(page.form) if page.form.drives else declaration.about
        says = f"{told}\n\n{declaration.usage}\n{slots}"
        text = f"{says}\nFor example: {declaration.example}\n\n"
    return title(page, is_done), text + _KEYS
