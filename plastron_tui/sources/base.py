"""What a language is: how its files are told apart, read, compared, checked and started.

Nothing outside of a language's folder, and of the targets that are written in it, knows its
suffixes, keywords or lexer: they ask the language. What a language cannot do is a diagnostic,
never an exception.
"""

from __future__ import annotations

from collections.abc import Callable, Container
from pathlib import Path
from typing import ClassVar, NamedTuple, TypeVar

from plastron_tui.diagnostics import Diagnostic, codes
from plastron_tui.model.code_facts import CodeFacts
from plastron_tui.model.source import FileSet, SourceUnit

_Method = TypeVar("_Method", bound=Callable[..., object])


def if_it_fails(answer: object) -> Callable[[_Method], _Method]:
    """Declare what a method answers where another distribution's code fails to."""

    def declare(method: _Method) -> _Method:
        method.if_it_fails = answer  # type: ignore[attr-defined]
        return method

    return declare


class Rendered(NamedTuple):
    """The files of a node, or why there are none (`files` is then None)."""

    files: FileSet | None
    diagnostics: tuple[Diagnostic, ...] = ()


class ReadResult(NamedTuple):
    """What a file holds.

    Attributes:
        source: the nodes of the file, None when the language cannot read the file at all.
        diagnostics: why, or what is doubtful.
        beside: the other files that had a part in it, which are read only.
    """

    source: SourceUnit | None
    diagnostics: tuple[Diagnostic, ...] = ()
    beside: tuple[Path, ...] = ()


class Language:
    """The base of a language. What is not overridden is reported as not supported.

    Attributes:
        name: the folder of `sources` that it is in, and what Pygments calls its lexer.
        title: what people call it.
        suffixes: the suffixes of its files; a created node's file gets the first one.
        is_executable: whether a node's file is a program that the system can start.
        is_script: whether the Python of a ROS environment runs its files.
        is_built: whether a package has to build its nodes before they can be started.
    """

    name: ClassVar[str]
    title: ClassVar[str]
    suffixes: ClassVar[tuple[str, ...]]
    is_executable: ClassVar[bool] = False
    is_script: ClassVar[bool] = False
    is_built: ClassVar[bool] = False

    @property
    def suffix(self) -> str:
        """The suffix of a created node's file."""
        return self.suffixes[0]

    def is_keyword(self, word: str) -> bool:
        """Tell whether a word is reserved: no function can be called so."""
        del word
        return False

    def mentioned_library(self, text: bytes) -> str | None:
        """Return the client library that a file mentions first, without reading the file."""
        del text
        return None

    def others(self, path: Path, text: bytes) -> tuple[str, ...]:
        """Return the names of the files that are read and changed together with a file.

        They need not be there. See `FileSet` for how they are written.
        """
        del path, text
        return ()

    def read(self, path: Path, files: FileSet, library: str | None = None) -> ReadResult:
        """Read the nodes and endpoints of files.

        Args:
            path: the main file.
            files: what they hold.
            library: the client library that they are of; None for the one that they say.
        """
        del files, library
        message = f"plastron cannot read {self.title} files yet, such as `{path.name}`"
        return ReadResult(None, (Diagnostic(codes.UNSUPPORTED_TARGET, message),))

    @if_it_fails(CodeFacts())
    def code_facts(self, source: SourceUnit) -> CodeFacts:
        """Return what the code of files does besides creating endpoints, as far as it is sure."""
        del source
        return CodeFacts()

    def runs_by_itself(self, name: str, packages: Container[str], *, is_own: bool) -> str | None:
        """Tell what runs a file of a name unasked, None where nothing of the language does.

        Args:
            name: the file's name, in small letters.
            packages: the packages whose types the node imports.
            is_own: whether Plastron makes the whole text.
        """
        del name, packages, is_own
        return None

    def command(self, file: Path, interpreter: Path) -> tuple[str, ...] | None:
        """Return the command that starts a node's file, None where it cannot be started yet.

        Args:
            file: the node's file.
            interpreter: the Python that can import what belongs to the node's ROS.
        """
        return (str(interpreter), str(file)) if self.is_script else None

    # What cannot be judged is not trusted.
    @if_it_fails(True)
    def is_worse(self, text: bytes, *others: bytes) -> bool:
        """Tell whether a text breaks the rules of its language, which none of the others does.

        A language that cannot tell leaves it to whether the text can be read.
        """
        del text, others
        return False

    @if_it_fails(None)
    def refusal(self, path: Path, text: bytes, ros_version: int = 2) -> Diagnostic | None:
        """Return why whoever runs a file refuses it for sure, None where that is not sure.

        Args:
            path: the file.
            text: what it holds.
            ros_version: the generation of ROS that it is for.
        """
        del path, text, ros_version
        return None

    def definitions(self, text: bytes, name: str) -> int:
        """Count the functions of a name that a text defines; 0 as well where that is not known."""
        del text, name
        return 0

    def mentions(self, text: bytes, name: str) -> bool:
        """Tell whether the code of a text has a name; by default any mention counts."""
        return name.encode() in text

    @if_it_fails(frozenset())
    def imports(self, text: bytes) -> frozenset[str]:
        """Return the modules that a text needs of others, none that the language brings itself.

        A module is named as the language names it; what it is part of follows from the name
        (`ros/package_keys.py`).
        """
        del text
        return frozenset()
