"""Calls a function of a module, in any Python, with no module from the current folder.

    python start.py MODULE:FUNCTION [ARGUMENT ...]

It is run as a file: for `-m` and `-c` the current folder comes first, and from Python 3.13 on
`-c` imports `linecache` before anything of the program's own has run.
"""

import sys


def main() -> None:
    """Call the function with the rest of the arguments as those of the program."""
    # Neither the folder of this file, which is no place for modules, nor an empty entry.
    here = __file__.rpartition("/")[0]
    sys.path[:] = [entry for entry in sys.path if entry not in ("", here)]
    module, function = sys.argv[1].split(":")
    # The same list: a module may have it as a default.
    sys.argv[:] = [module, *sys.argv[2:]]
    getattr(__import__(module, fromlist=[function]), function)()


if __name__ == "__main__":
    main()
