"""The line above everything, and the one about the statement at the cursor."""

from __future__ import annotations

from ..open_program import Open
from ..panels.bars import Bar, help_pieces


class TitleBar(Bar):
    """The program's name, and what is the case with it."""

    def show_program(self, open_: Open, stop_key: str | None) -> None:
        """Show a program, whether it is saved, and where nodes run the key that stops them."""
        sign = "●" if open_.is_changed else " "
        left = (("plastron ", "quiet"), (open_.name, "strong"), (f" {sign} ", "here"))
        folder = "" if open_.path is None else f"{open_.path.absolute().parent.name}/  "
        setting = (f"{folder}{open_.session.library}", "quiet")
        running = () if stop_key is None else ((f"running: {stop_key} stops  ", "here"),)
        self.show(left, (*running, setting))


class StatusBar(Bar):
    """The sentence of the statement at the cursor, and where the cursor is."""

    def show_statement(self, sentence: str, text: bytes, offset: int) -> None:
        """Show the sentence of the statement at an offset of a text."""
        line_start = text.rfind(b"\n", 0, offset) + 1
        row = text.count(b"\n", 0, offset) + 1
        column = len(text[line_start:offset].decode("utf-8", "replace")) + 1
        self.show(help_pieces(sentence), ((f"{row}:{column}", "quiet"),))
