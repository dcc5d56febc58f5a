"""Reading and changing the setup.py of a package, whoever wrote it; nothing of it is run."""
