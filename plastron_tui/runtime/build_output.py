"""What build tools print: how far they are, and what they say of a package's files."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

from plastron_tui.diagnostics import Diagnostic, Span, codes
from plastron_tui.regular_files import read_regular

Spans = Mapping[int, Span]
"""Where a program says what the lines of a file say, counted from 1; 0 stands for all of it."""

MOST_ERRORS = 20
_LONGEST_LINE = 4096
_LONGEST_FILE = 1 << 20
_KINDS = ("msg", "srv", "action")
_QUOTES = str.maketrans("‘’", "''")

_PERCENT = re.compile(r"\[ *(\d{1,3})%\] ")
_STARTED = re.compile(r"Starting >>> (\S+)")

# GCC and Clang: `FILE:LINE:COLUMN: error: MESSAGE`.
_COMPILER = re.compile(r"([^:]+):(\d{1,7}):(?:\d{1,7}:)? (?:fatal )?error: (.+)")
# genmsg, of a file that it cannot read: `…InvalidMsgSpec: FILE: MESSAGE`.
_GENMSG = re.compile(r".*InvalidMsgSpec: (/[^:]+): (.+)")
# genpy, of a file, and of another one that the file needs.
_GENPY = re.compile(r"ERROR: Unable to generate .* while processing '([^']+)': (.+)")
_GENPY_NEEDED = re.compile(r"Cannot generate \.\w+ for [^:]+: (/[^:]+): (.+)")
# genmsg's check of what a definition needs; the reason is the next paragraph.
_NEEDS = re.compile(r"Could not find messages which '([^']+)' depends on\.")
# rosidl_adapter, of a line of a definition.
_ADAPTER = re.compile(r"Error processing '(.*)' of '(\w+)/(\w+)': '(.+)'$")
# A generator of ROS 2, by the file that make wanted of it; the reason was its last line.
_TARGET = re.compile(r"g?make\[\d+\]: \*\*\* \[\S+: [^\]]*?/(\w+)/(\w+)/(\w+)\.\w+\] Error \d+")
_EXCEPTION = re.compile(r"[\w.]*(?:Error|Exception|InvalidValue|Invalid\w+): .+")
# CMake, of a call in a build file; the message is the next paragraph.
_CMAKE = re.compile(r"CMake Error at ([^:]+):(\d{1,7}) \((\w+)\):$")


class Progress(NamedTuple):
    """How far a build is.

    Attributes:
        package: the package that is being built.
        step: what is being done.
        percent: how much of the package is done, None where that is not known.
    """

    package: str
    step: str
    percent: int | None = None


def progress_of(line: str, before: Progress) -> Progress:
    """Return how far a build is after a line of its output."""
    if started := _STARTED.match(line):
        return Progress(started[1], "configure")
    if done := _PERCENT.match(line):
        return before._replace(step="build", percent=min(int(done[1]), 100))
    if line.startswith(("-- Installing: ", "-- Install configuration: ")):
        return before._replace(step="install", percent=100)
    return before


class _Said(NamedTuple):
    """What a tool said of a file of a package; line 0 for the whole file."""

    package: str
    path: str
    line: int
    message: str


def errors_of(
    lines: Sequence[str], source: Path, spans: Mapping[str, Mapping[str, Spans]], help_: str
) -> list[Diagnostic]:
    """Return what a build says of the files of packages.

    Args:
        lines: its output.
        source: the folder with a folder for each package.
        spans: for each package and file where the program says what it says.
        help_: the help line of each.
    """
    lines = [line[:_LONGEST_LINE] for line in lines]
    # A tool that refuses a file is called by CMake, which then says that it failed.
    said = [*_of_lines(lines, source, spans), *_of_paragraphs(lines, source, spans)]
    said = said or list(_of_cmake(lines, source, spans))
    found = []
    for each in list(dict.fromkeys(said))[:MOST_ERRORS]:
        known = spans.get(each.package, {}).get(each.path, {})
        span = known.get(each.line) or known.get(0)
        line = f":{each.line}" if each.line else ""
        message = f"`{each.package}/{each.path}{line}` could not be built: {each.message}"
        found.append(Diagnostic(codes.NOT_BUILT, message, span, help=help_))
    return found


def _of_lines(lines: Iterable[str], source: Path, packages: Iterable[str]) -> Iterator[_Said]:
    reason = ""
    generated: dict[tuple[str, str], dict[int, str]] = {}
    for line in lines:
        if match := _COMPILER.fullmatch(line):
            if place := _place(match[1], source, packages):
                yield _Said(*place, int(match[2]), match[3])
            elif definition := _generated_from(match[1], source, packages):
                number = _field_in(source.joinpath(*definition), match[3])
                # The rest of what is said of a field follows from the first.
                generated.setdefault(definition, {}).setdefault(number, match[3])
        elif match := _genmsg(line):
            if place := _place(match[1], source, packages):
                yield _Said(*place, 0, _without_paths(match[2]))
        elif match := _TARGET.match(line):
            package, kind, _ = match.groups()
            # A generator is called once for all definitions; make names the first.
            if reason and package in packages and kind in _KINDS:
                path = _meant(source / package, reason)
                if path is not None:
                    yield _Said(package, path, 0, reason)
            reason = ""
        elif _EXCEPTION.fullmatch(line):
            reason = line
    for definition, messages in generated.items():
        for number, message in messages.items():
            if number or len(messages) == 1:
                yield _Said(*definition, number, message)


def _genmsg(line: str) -> re.Match[str] | None:
    if match := _GENPY.match(line):
        return _GENPY_NEEDED.match(match[2]) or match
    return _GENMSG.match(line)


def _without_paths(message: str) -> str:
    """Return what genmsg says without all the folders that it has looked in."""
    return message.partition(" with paths [")[0].partition(" on search path [")[0]


def _of_paragraphs(lines: Iterable[str], source: Path, packages: Iterable[str]) -> Iterator[_Said]:
    """Yield what is said in paragraphs, which CMake wraps at blanks."""
    needing: tuple[str, str] | None = None
    for paragraph in _paragraphs(lines):
        if needing is not None:
            yield _Said(*needing, 0, _without_paths(paragraph))
            needing = None
        elif match := _NEEDS.search(paragraph):
            needing = _place(match[1], source, packages)
        elif match := _ADAPTER.search(paragraph):
            written, package, name, message = match.groups()
            if package in packages:
                path, line = _written_at(source / package, name, written)
                yield _Said(package, path, line, message)


def _of_cmake(lines: Iterable[str], source: Path, packages: Iterable[str]) -> Iterator[_Said]:
    """Yield what CMake says of the build files of packages."""
    package = next(iter(packages), "")
    at: tuple[str, str, int] | None = None
    words: list[str] = []
    for line in (*lines, ""):
        if started := _STARTED.match(line):
            package = started[1]
        elif match := _CMAKE.match(line):
            file = match[1] if "/" in match[1] else f"{package}/{match[1]}"
            place = _place(str(source / file), source, packages)
            at, words = None if place is None else (*place, int(match[2])), []
        elif at is not None and line.startswith("  "):
            words.append(line.strip())
        elif at is not None and words:
            yield _Said(*at, " ".join(words).rstrip("."))
            at = None


def _paragraphs(lines: Iterable[str]) -> Iterator[str]:
    """Yield the paragraphs of text that is indented by two blanks, each as one line."""
    words: list[str] = []
    for line in lines:
        if line.startswith("  ") and line.strip():
            words.append(line.strip())
        elif words:
            yield " ".join(words)
            words = []
    if words:
        yield " ".join(words)


def _place(file: str, source: Path, packages: Iterable[str]) -> tuple[str, str] | None:
    """Return the package and the path in it of a file that a tool names."""
    # genpy reads the definitions where they are installed.
    for folder in (source, source.parent / "install" / "share"):
        if Path(file).is_relative_to(folder):
            package, *parts = Path(file).relative_to(folder).parts or ("",)
            break
    else:
        return None
    return (package, "/".join(parts)) if package in packages and parts else None


def _generated_from(file: str, source: Path, packages: Iterable[str]) -> tuple[str, str] | None:
    """Return the package and definition that a file of C or C++ was generated from.

    rosidl calls it `build/PACKAGE/GENERATOR/PACKAGE/KIND/detail/NAME__PART`, with a name in lower
    case.
    """
    if not Path(file).is_relative_to(source.parent / "build"):
        return None
    match Path(file).relative_to(source.parent / "build").parts:
        case (package, _, _, kind, *_, name) if package in packages and kind in _KINDS:
            stem = name.partition("__")[0] if "__" in name else name.rpartition("_s.")[0]
            definitions = (source / package / kind).glob(f"*.{kind}")
            named = [each for each in definitions if each.stem.lower() == stem.replace("_", "")]
            return (package, f"{kind}/{named[0].name}") if len(named) == 1 else None
    return None


def _field_in(definition: Path, message: str) -> int:
    """Return the line of the only field that a compiler quotes, 0 where there is none."""
    quoted = message.translate(_QUOTES).split("'")[1::2]
    fields = [line.split()[1:2] for line in _lines(definition)]
    found = [number for number, field in enumerate(fields, 1) if field and field[0] in quoted]
    return found[0] if len(found) == 1 else 0


def _meant(package: Path, reason: str) -> str | None:
    """Return the only definition that a generator can mean: by a package that is not there."""
    files = [each for kind in _KINDS for each in sorted((package / kind).glob(f"*.{kind}"))]
    if len(files) > 1:
        words = reason.split("'")[1::2]
        named = tuple(f"{word}/" for word in words)
        files = [
            file for file in files if any(line.lstrip().startswith(named) for line in _lines(file))
        ]
    return str(files[0].relative_to(package)) if len(files) == 1 else None


def _lines(file: Path) -> list[str]:
    try:
        return read_regular(file, _LONGEST_FILE).decode("utf-8", "replace").splitlines()
    except OSError:
        return []


def _written_at(package: Path, name: str, written: str) -> tuple[str, int]:
    """Return the definition of a name, and the line in it that reads so, 0 for an unknown one."""
    for kind in _KINDS:
        path = f"{kind}/{name}.{kind}"
        try:
            lines = read_regular(package / path, _LONGEST_FILE).decode("utf-8", "replace")
        except OSError:
            continue
        for number, line in enumerate(lines.splitlines(), 1):
            if line.split() == written.split():
                return path, number
        return path, 0
    return f"msg/{name}.msg", 0
