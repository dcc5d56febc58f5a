"""Packages of one name: which of them a file means, and which files are of one workspace.

A repository may hold several workspaces, each with a package of a name: a course, the exercises of
which build on each other. What is near in folders belongs together.
"""

from __future__ import annotations

import os
from collections import defaultdict
from collections.abc import Iterable, Mapping
from pathlib import Path

_Choices = Mapping[str, Path]
"""Of which folder a file takes each package that several folders have, as far as that is clear."""


def nearest(folders: Iterable[Path], file: Path) -> Path | None:
    """Return the folder that shares most folders with a file, None where two share as many."""
    depths = [(len(os.path.commonpath((each, file))), each) for each in folders]
    most = max((depth for depth, _ in depths), default=0)
    found = [each for depth, each in depths if depth == most]
    return found[0] if len(found) == 1 else None


class Workspaces:
    """The workspaces of a tree by numbers, as far as packages of one name tell them apart.

    What is built from two of them never runs together, for one hides the other's package.
    """

    def __init__(self, namesakes: Mapping[str, Iterable[Path]]) -> None:
        """Set up for the folders of packages, by the name that they share."""
        self._below: dict[Path, dict[str, list[Path]]] = defaultdict(lambda: defaultdict(list))
        for name, folders in namesakes.items():
            for folder in folders:
                for above in (folder, *folder.parents):
                    self._below[above][name].append(folder)
        self._by_folder: dict[Path, int] = {}
        self._numbers: dict[frozenset[tuple[str, Path]], int] = {}
        self._choices: list[_Choices] = []
        self._apart: dict[tuple[int, int], bool] = {}

    def number_of(self, file: Path) -> int:
        """Return the workspace of a file: files of one mean the same package by each name."""
        folder = file.parent
        number = self._by_folder.get(folder)
        if number is None:
            choices = self._choices_in(folder)
            number = self._numbers.setdefault(frozenset(choices.items()), len(self._choices))
            if number == len(self._choices):
                self._choices.append(choices)
            self._by_folder[folder] = number
        return number

    def _choices_in(self, folder: Path) -> _Choices:
        """Return what `nearest` says of each name, which it would ask every folder for."""
        found: dict[str, Path | None] = {}
        for above in (folder, *folder.parents):
            for name, folders in self._below.get(above, {}).items():
                found.setdefault(name, folders[0] if len(folders) == 1 else None)
        return {name: each for name, each in found.items() if each is not None}

    def are_apart(self, one: int, other: int) -> bool:
        """Tell whether two workspaces mean different packages by a name."""
        if one == other:
            return False
        key = (one, other) if one < other else (other, one)
        known = self._apart.get(key)
        if known is None:
            first, second = self._choices[one], self._choices[other]
            known = any(second.get(name, folder) != folder for name, folder in first.items())
            self._apart[key] = known
        return known

    def widest(self, numbers: Iterable[int]) -> list[int]:
        """Return the workspaces of some that are no part of another one of them."""
        sure = {number: self._choices[number].items() for number in numbers}
        return [one for one in sure if not any(sure[one] < other for other in sure.values())]
