"""The terminal studio: an editor that understands the program."""
