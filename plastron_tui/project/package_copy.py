"""The rest of a package that exists, for the output folder: what no program changes in it.

A package of which the output folder had only the changed files would build nowhere. So it gets the
others too, byte by byte, with their executable bits.
"""

from __future__ import annotations

import os
import stat
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from plastron_tui.diagnostics import Diagnostic, Span, codes
from plastron_tui.output.manifest import NAME as MANIFEST
from plastron_tui.output.own_files import PREFIX
from plastron_tui.output.plan import OutputFile
from plastron_tui.regular_files import read_regular, reason
from plastron_tui.ros.packages import BUILT_FOLDERS, CACHES
from plastron_tui.sources.packages.files import DEEPEST
from plastron_tui.sources.packages.reading import PACKAGE_XML

if TYPE_CHECKING:
    from plastron_tui.boundary import Boundary
    from plastron_tui.generating.package_parts import Copied
    from plastron_tui.model.package_source import PackageSource
    from plastron_tui.model.packages import Package
    from plastron_tui.output.manifest import Manifest

    from .configuration import Configuration

MOST_FILES = 2_000
MOST_BYTES = 32_000_000
_MOST_NAMES = 20_000
"""How many names of files and folders are looked at."""
_MOST_TOLD = 3


class Copy(NamedTuple):
    """What a program writes of a package.

    Attributes:
        files: the files, those that the program changes among them.
        diagnostics: what of the package is not there.
    """

    files: tuple[OutputFile, ...]
    diagnostics: tuple[Diagnostic, ...] = ()


class CopySetting(NamedTuple):
    """Where a package is copied to.

    Attributes:
        output: the output folder.
        manifest: what is remembered of its files.
        boundary: the project, which no link leaves unless it is trusted.
        program: the name of the program's file.
        force: whether files are written anew, whatever was changed by hand.
    """

    output: Path
    manifest: Manifest
    boundary: Boundary
    program: str
    force: bool = False


def copy_setting(configuration: Configuration, manifest: Manifest, program: str) -> CopySetting:
    """Return where packages are copied to by a program of a name."""
    options, boundary = configuration.options, configuration.boundary
    return CopySetting(configuration.output, manifest, boundary, program, options.force)


class _TooMuchError(Exception):
    """A package is larger than what is copied."""


def with_copies(
    package: Package,
    changed: Sequence[OutputFile],
    known: Mapping[str, bytes],
    setting: CopySetting,
) -> Copy:
    """Add the files of a package to those that a program changes, in the package or elsewhere.

    Hidden folders, what builds leave and packages inside are no part of it. A link within the
    project becomes what it leads to.

    Args:
        package: the package, which was loaded; one in the output folder is not copied.
        changed: the files that the program changes or makes.
        known: what becomes of files that the program loads by themselves, by their real paths.
        setting: where they go.
    """
    source, span = package.source, package.span
    assert source is not None, "the package was loaded"
    if os.path.realpath(setting.output / source.name) == os.path.realpath(source.folder):
        return Copy(tuple(changed))
    walk = _Walk(source.folder, setting, _MOST_NAMES)
    own = {each.name for each in changed if each.path is None}
    copies: list[OutputFile] = []
    left = MOST_BYTES
    try:
        for name, path in walk.files():
            in_output = f"{source.name}/{name}"
            status = path.stat()
            left -= status.st_size
            if len(copies) >= MOST_FILES or left < 0:
                raise _TooMuchError
            is_executable = bool(status.st_mode & stat.S_IXUSR)
            if in_output in own:
                walk.executable[in_output] = is_executable
                continue
            text = known.get(os.path.realpath(path), source.texts.get(name))
            try:
                text = read_regular(path, MOST_BYTES) if text is None else text
            except OSError:
                walk.left_out.append(name)
                continue
            copies.append(_copy(in_output, text, is_executable, setting))
    except _TooMuchError:
        message = f"`{source.name}` is too large to be copied: output has what is changed of it"
        help_ = "write over the package with `--in-place`; it is built where it is"
        return Copy(tuple(changed), (Diagnostic(codes.NOT_COPIED, message, span, help=help_),))
    kept = [
        replace(each, is_executable=walk.executable.get(each.name, each.is_executable))
        for each in changed
    ]
    return Copy((*kept, *copies), tuple(_told(source, walk.left_out, span)))


def copied_files(copies: Mapping[str, Copied], setting: CopySetting) -> Copy:
    """Return files that packages get as they are.

    Args:
        copies: where they come from, by their paths in the output folder.
        setting: where they go.
    """
    files: list[OutputFile] = []
    found: list[Diagnostic] = []
    left = MOST_BYTES
    for name, (file, span) in copies.items():
        try:
            text = read_regular(file, left)
        except OSError as error:
            message = f"not copied: `{name}`, as `{file.name}` cannot be read: {reason(error)}"
            help_ = f"a program copies at most {MOST_BYTES // 1_000_000} MB; put it there by hand"
            found.append(Diagnostic(codes.NOT_COPIED, message, span, help=help_))
            continue
        left -= len(text)
        files.append(_copy(name, text, False, setting))
    return Copy(tuple(files), tuple(found[:_MOST_TOLD]))


def _is_part(hidden: Path) -> bool:
    """Tell whether a hidden file may be one of those that a package installs."""
    is_own = hidden.name == MANIFEST or hidden.name.startswith((PREFIX, ".git"))
    return not is_own and hidden.is_file() and not hidden.is_symlink()


def _told(source: PackageSource, left_out: Sequence[str], span: Span) -> Iterator[Diagnostic]:
    if not left_out:
        return
    names = ", ".join(f"`{each}`" for each in left_out[:_MOST_TOLD])
    more = len(left_out) - _MOST_TOLD
    message = f"not copied of `{source.name}`: {names}" + (f" and {more} more" if more > 0 else "")
    help_ = "what cannot be read stays behind, as do links that lead out of the project, or nowhere"
    yield Diagnostic(codes.NOT_COPIED, message, span, help=help_)


def _copy(name: str, text: bytes, is_executable: bool, setting: CopySetting) -> OutputFile:
    """Return a file as it is copied, or as it was changed by hand where the package has it still.

    It was copied as the package has it, so that the change by hand is the only one.
    """
    manifest = setting.manifest
    base = {"program": setting.program}
    new = OutputFile(name, text, is_executable, base=base)
    if setting.force or not manifest.has(name, text):
        return new
    try:
        present = read_regular(setting.output / name, MOST_BYTES)
    except OSError:
        return new
    if present == text:
        return new
    return replace(new, text=present, merged_from=present, has_handwork=True)


@dataclass
class _Walk:
    folder: Path
    setting: CopySetting
    left: int
    left_out: list[str] = field(default_factory=list)
    executable: dict[str, bool] = field(default_factory=dict)

    def files(self) -> Iterator[tuple[str, Path]]:
        """Yield the files by their paths in the package, in a steady order, and where they are."""
        real = Path(os.path.realpath(self.folder))
        return self._within("", tuple(map(str, (real, *real.parents))))

    def _within(self, inner: str, above: tuple[str, ...]) -> Iterator[tuple[str, Path]]:
        """Yield the files of a folder; `above` are the real paths of it and those around it."""
        folder = self.folder / inner
        try:
            names = sorted(each.name for each in folder.iterdir())
        except OSError:
            self.left_out.append(inner)
            return
        self.left -= len(names)
        if self.left < 0:
            raise _TooMuchError
        if inner and PACKAGE_XML in names:
            return
        for name in names:
            path, here = folder / name, f"{inner}{name}"
            if name.startswith(".") and not _is_part(path):
                continue
            if not name.isprintable() or "\\" in name:
                self.left_out.append(here.encode("unicode_escape", "replace").decode())
            elif path.is_dir():
                real = os.path.realpath(path)
                is_built = name in CACHES or (not inner and name in BUILT_FOLDERS)
                if is_built or real == os.path.realpath(self.setting.output):
                    continue
                is_astray = path.is_symlink() and (real in above or not self._allows(path))
                if is_astray or inner.count("/") >= DEEPEST:
                    self.left_out.append(here)
                    continue
                yield from self._within(f"{here}/", (*above, real))
            elif path.is_file() and (not path.is_symlink() or self._allows(path)):
                yield here, path
            else:
                self.left_out.append(here)

    def _allows(self, path: Path) -> bool:
        return self.setting.boundary.allows(path)
