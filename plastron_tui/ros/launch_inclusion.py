"""Launch files that include each other: where that would go on without end."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple


class Including(NamedTuple):
    """A file that includes another one.

    Attributes:
        path: the file, without symbolic links.
        given: the names of the arguments that it was given.
        arguments: what is known of its arguments where it includes the other one.
    """

    path: str
    given: frozenset[str]
    arguments: Mapping[str, str]

    def is_again(self, path: str, arguments: Mapping[str, str]) -> bool:
        """Tell whether including a file with these arguments is the same once more.

        A file that includes itself with other arguments may come to an end.
        """
        return self.path == path and all(
            arguments[name] == value if name in arguments else name not in self.given
            for name, value in self.arguments.items()
        )
