"""The texts of a package's files, and what their names say."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from functools import cached_property

from plastron_tui.model.package_source import PackageSource
from plastron_tui.ros.launch_names import launch_language
from plastron_tui.sources.packages.reading import CMAKE_LISTS, PACKAGE_XML

PYTHON = ".py"
CPP = (".cpp", ".cc", ".cxx", ".c", ".hpp", ".hh", ".hxx", ".h")
_DOCUMENTS = (".md", ".rst", ".dox", ".pdf", ".html")
NO_TEXT = (
    ".png", ".jpg", ".jpeg", ".gif", ".bmp", ".svg", ".ico", ".pgm", ".ppm", ".tif", ".tiff",
    ".stl", ".dae", ".obj", ".mtl", ".ply", ".pcd", ".glb", ".bag", ".db3", ".mcap", ".so", ".a",
    ".o", ".zip", ".gz", ".tar", ".bz2", ".xz", ".7z", ".pyc", ".mp4", ".avi", ".wav", ".mp3",
    ".onnx", ".pt", ".pth", ".pb", ".h5", ".weights", ".npy", ".npz", ".csv", ".ttf", ".jar",
)  # fmt: skip
"""How the names of files end that nobody reads as a text."""
_STATEMENT = re.compile(rb"^[ \t]*[^\s#]", re.M)
"""A line that is neither blank nor a comment of Python; a directive of C++ is never alone."""
_TEST = ("test", "unittest", "unit_test")
SCRIPT_FOLDERS = ("scripts", "nodes", "script", "bin", "src")
"""Where packages usually have what people start."""
LARGEST = 1_000_000


class PackageTexts:
    """Reads the files of a package, each once.

    Attributes:
        source: the package.
        programs: the files that somebody may run, as their mode says.
    """

    def __init__(
        self,
        source: PackageSource,
        read: Callable[[str], bytes | None],
        programs: frozenset[str] = frozenset(),
    ) -> None:
        """Set the package, and what reads a file of it."""
        self.source = source
        self.programs = programs
        self._read = read
        self._texts: dict[str, bytes | None] = {}

    def get(self, name: str) -> bytes | None:
        """Return what a file holds, None where it cannot be read or is no text."""
        if name in self.source.texts:
            return self.source.texts[name]
        if name not in self._texts:
            text = None if name.lower().endswith(NO_TEXT) else self._read(name)
            self._texts[name] = None if text is None or len(text) > LARGEST else text
        return self._texts[name]

    @cached_property
    def names(self) -> tuple[str, ...]:
        """The files, in the order of their names."""
        return tuple(sorted(self.source.names))

    @cached_property
    def python(self) -> tuple[str, ...]:
        """The files of Python, without what the build itself runs."""
        return tuple(each for each in self.names if each.endswith(PYTHON) and each != "setup.py")

    @cached_property
    def has_code(self) -> bool:
        """Whether there is code at all, besides tests and launch files."""
        return any(
            each.endswith((PYTHON, *CPP))
            and each != "setup.py"
            and not is_test(each)
            and not launch_language(each)
            and _STATEMENT.search(self.get(each) or b"") is not None
            for each in self.names
        )

    @cached_property
    def bases(self) -> frozenset[str]:
        """The names of the files without their folders."""
        return frozenset(each.rpartition("/")[2] for each in self.names)

    def others(self) -> Iterator[tuple[str, bytes]]:
        """Yield the files that may use something, and what they hold: no document for people."""
        for name in self.names:
            base = name.rpartition("/")[2]
            if name in (PACKAGE_XML, CMAKE_LISTS) or name.lower().endswith(_DOCUMENTS):
                continue
            if base.upper().startswith(("LICENSE", "CHANGELOG", "README")):
                continue
            text = self.get(name)
            if text is not None:
                yield name, text


def is_test(name: str) -> bool:
    """Tell whether a file is a test, or serves one."""
    *folders, base = name.split("/")
    is_below = any(each.startswith(_TEST) for each in folders)
    is_named = base.startswith("test_") or base.endswith("_test.py") or base == "conftest.py"
    return is_below or is_named
