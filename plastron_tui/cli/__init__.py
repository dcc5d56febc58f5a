"""The command line."""

from plastron_tui.import_path import leave_out_current_folder

leave_out_current_folder()

from .main import main  # noqa: E402

__all__ = ["main"]
