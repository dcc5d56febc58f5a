"""What commands do to the program as a whole: definition, rename, format, another editor."""

from __future__ import annotations

import os
from functools import partial
from typing import TYPE_CHECKING

from textual.app import SuspendNotSupported

from plastron_tui.diagnostics import Edit, counted
from plastron_tui.language import format_document
from plastron_tui.project.program_file import check_text
from plastron_tui.regular_files import reason

from .external_editor import EditedElsewhere, external_editor, run_editor
from .name_uses import Name, function_at, is_file_at, name_at, next_use, uses_of
from .names import Variable, variable_at, wrong_name
from .robot_parts import find_part, kept_name, part_at, wrong_part_name

if TYPE_CHECKING:
    from .widget import ProgramEditor


def _variable(editor: ProgramEditor) -> Variable | None:
    document, offset = editor.session.document, editor.cursor_offset
    variable = variable_at(document, offset)
    if variable is not None:
        return variable
    part = part_at(document, offset)
    return None if part is None else find_part(document, part)


async def go_to_definition(editor: ProgramEditor) -> None:
    """Go to where what is under the cursor is made; from a name, to what else is about it.

    A function and a file are shown in code, a type is told in a card.
    """
    document, offset = editor.session.document, editor.cursor_offset
    variable = _variable(editor)
    name = name_at(document, offset)
    is_code = function_at(document, offset) is not None or is_file_at(document, offset)
    if variable is not None and variable.definition is None:
        editor.warn(f"nothing creates or loads `{variable.name}`")
    elif variable is not None and variable.definition is not None:
        editor.go_to(variable.definition.start)
    elif name is not None:
        _go_to_next_use(editor, name)
    elif is_code:
        await editor.run_action("screen.code")
    elif not editor.hover.show_at_cursor():
        editor.warn("nothing under the cursor leads anywhere")


def _go_to_next_use(editor: ProgramEditor, name: Name) -> None:
    loaded = editor.completer.names.loaded_with(name.what, name.text)
    if name.owner:
        loaded &= {name.owner}
    uses = uses_of(editor.session.document, name, loaded)
    use = next_use(uses, editor.cursor_offset)
    if use is None:
        editor.warn(f"no other statement is about the {name.what} `{name.text}`")
    else:
        editor.go_to(use.start)


async def list_uses(editor: ProgramEditor) -> None:
    """List the lines on which what is under the cursor is used."""
    await editor.run_action("screen.uses")


async def ask_name(editor: ProgramEditor) -> None:
    """Ask for another name of what is under the cursor, everywhere."""
    variable = _variable(editor)
    document, offset = editor.session.document, editor.cursor_offset
    if name_at(document, offset) is not None or function_at(document, offset) is not None:
        # What the nodes have of the name is known to the screen.
        await editor.run_action("screen.rename")
        return
    part = None if variable_at(document, offset) is not None else part_at(document, offset)
    kept = None if part is None else kept_name(part, editor.completer.names.known_robot(part.robot))
    if kept is not None:
        editor.warn(kept)
    elif variable is None:
        editor.warn("nothing under the cursor has a name of the program's own")
    else:
        name = variable.name
        found = variable.places
        where = f" ({counted(len(found), 'place')})"
        await editor.ask(f"rename {name}{where} to", name, partial(rename, editor))


def rename(editor: ProgramEditor, name: str) -> None:
    """Give what is under the cursor another name, everywhere, as one step to undo."""
    name = name.strip()
    document, offset = editor.session.document, editor.cursor_offset
    variable = variable_at(document, offset)
    part = part_at(document, offset) if variable is None else None
    found = variable if part is None else find_part(document, part)
    if found is None or name == found.name:
        return
    if part is None:
        problem = wrong_name(document, name)
    else:
        robot = editor.completer.names.known_robot(part.robot)
        problem = wrong_part_name(document, part, name, robot)
    if problem is not None:
        editor.warn(problem)
        return
    editor.apply(Edit(span, name) for span in found.places)


def format_program(editor: ProgramEditor) -> None:
    """Lay the program out as `plastron fmt` does."""
    editor.replace_all(format_document(editor.session.document))


async def ask_line(editor: ProgramEditor) -> None:
    """Ask for a line, and for a column after a colon."""
    await editor.ask("go to line", "", partial(_go_to_line, editor))


def _go_to_line(editor: ProgramEditor, answer: str) -> None:
    line, _, column = answer.strip().partition(":")
    if not line.isdecimal() or not (column or "1").isdecimal():
        editor.warn(f"no line number: {answer}")
        return
    buffer = editor.state.buffer
    row = min(max(int(line) - 1, 0), buffer.row_count - 1)
    editor.go_to(buffer.at_cell(row, max(int(column or "1") - 1, 0)))


def edit_elsewhere(editor: ProgramEditor) -> None:
    """Edit the text in `$VISUAL` or `$EDITOR`, and take what comes back as one step."""
    command = external_editor(os.environ)
    if isinstance(command, str):
        editor.warn(command)
        return
    path = editor.session.path
    try:
        there = EditedElsewhere(editor.text, path.name if path else "program.plastron")
    except OSError as error:
        editor.warn(f"no temporary file can be written: {reason(error)}")
        return
    with there:
        try:
            with editor.app.suspend():
                line = editor.state.row + 1
                problem = run_editor(command, there.file, line, and_so="; the text is as it was")
        except SuspendNotSupported:
            editor.warn("this terminal cannot be lent to another editor")
            return
        editor.app.refresh()
        _take(editor, there, problem)


def _take(editor: ProgramEditor, there: EditedElsewhere, problem: str | None) -> None:
    """Take what another editor has left, or say why that cannot be."""
    try:
        text = there.read()
    except FileNotFoundError:
        editor.warn(problem or f"`{there.file.name}` is gone; the text is as it was")
        return
    except OSError as error:
        problem = problem or f"`{there.file.name}` cannot be read: {reason(error)}"
    else:
        checked = check_text(None, text)
        if problem is not None and text == editor.text:
            editor.warn(problem)
            return
        if problem is None and checked.text is not None:
            editor.replace_all(checked.text)
            return
        problem = problem or checked.diagnostics[0].message
    there.is_kept = True
    editor.warn(f"{problem}; what you wrote is in {there.file}")
