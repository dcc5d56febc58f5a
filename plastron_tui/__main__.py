"""`python -m plastron_tui` is `plastron`."""

from plastron_tui.cli import main

if __name__ == "__main__":
    main()
