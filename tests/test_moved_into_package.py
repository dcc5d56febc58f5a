"""What stays of a node that was written alone, once it is in a package."""

from __future__ import annotations

from pathlib import Path

from plastron_tui.output.writer import write
from plastron_tui.session import Options, Session

NODE = """\
create_node 'talker' as talker
create_message greeting of message_type String and input "hello"
talker publish greeting to 'chatter' of message_type String at 2 hz
"""
OTHER = "create_node 'other' as other\nsubscribe other to 'chatter' of message_type String\n"
PACKAGE = """\
create_package 'demo' as demo maintained_by "Ada <ada@example.com>" licensed_under "MIT"
demo contains talker
generate_package demo
"""


def generate(folder: Path, text: str) -> list[str]:
    path = folder / "demo.plastron"
    path.write_text(text)
    program = Session(text.encode(), path, Options(target="rclpy"), environ={})
    plan, found = program.plan()
    return [each.code for each in (*program.diagnostics, *found, *write(plan).diagnostics)]


def test_the_file_of_a_node_that_is_in_a_package_now_is_told(tmp_path: Path) -> None:
    alone = f"{NODE}{OTHER}generate_node talker\ngenerate_node other\n"
    generate(tmp_path, alone)
    [file] = (tmp_path / "output").glob("talker*.py")
    packaged = f"{NODE}{OTHER}generate_node other\n{PACKAGE}"
    assert generate(tmp_path, packaged) == ["file-stays"]
    file.unlink()
    assert generate(tmp_path, packaged) == []
