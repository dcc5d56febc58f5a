"""What the tests of the command line share."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

PLASTRON = [sys.executable, "-c", "from plastron_tui.cli import main; main()"]

Run = Callable[..., subprocess.CompletedProcess[bytes]]

TALKER = """\
create_node 'talker' as talker
create_message greeting of message_type String and input "hello"
talker publish greeting to 'chatter' of message_type String
generate_node talker
"""

LISTENER = """\
create_node 'listener' as listener
subscribe listener to 'chatter' of message_type String
generate_node listener
"""

BROKEN = """\
create_node 'a' as node1
subscribe node1 to 'chatter' of message_type String
subscribe nod1 to 'other' of message_type String
generate_node node1
"""


def snapshot(folder: Path) -> dict[str, bytes | str | None]:
    """Return everything that is in a folder."""
    found: dict[str, bytes | str | None] = {}
    for path in sorted(folder.rglob("*")):
        name = str(path.relative_to(folder))
        if path.is_symlink():
            found[name] = str(path.readlink())
        else:
            found[name] = path.read_bytes() if path.is_file() else None
    return found
