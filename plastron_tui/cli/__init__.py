"""The command line."""

import sys

__all__ = ["main"]


def main() -> None:
    """Run the command line, with no module from the current folder, and exit with its status."""
    try:
        from plastron_tui.import_path import leave_out_current_folder

        leave_out_current_folder()
        from plastron_tui import collector

        collector.look_seldom()
        from .entry import run
    except KeyboardInterrupt:
        # Before anything was begun, there is nothing to say either.
        sys.exit(130)
    run()
