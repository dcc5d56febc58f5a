"""Packages that are built before nodes run: in the user's cache, by the tools of their ROS.

What was built is kept by its content, so that a run with nothing changed starts no build. The
workspace that it was built in is kept too: where a file changes, its tools build only what that
file is for.
"""

from __future__ import annotations

import errno
import fcntl
import hashlib
import json
import os
import shutil
import signal
import tempfile
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import IO

from plastron_tui.diagnostics import Diagnostic, codes
from plastron_tui.regular_files import read_regular, reason
from plastron_tui.user_folders import cache_folder

from .build_inputs import built_upon, tools
from .build_output import Progress, Spans, errors_of, progress_of
from .build_tools import BuildError, Step, Workspace, find_builder
from .child import Process
from .environment import Environment
from .supervisor import Supervisor

MOST_OVERLAYS = 32
MOST_WORKSPACES = 8
"""How many of either are kept; those that were used last stay."""

_FULL = os.strerror(errno.ENOSPC)

_LONGEST_LOG = 4 << 20
_MOST_LINES = 20_000
"""What is kept of a build's output, and how many of its lines are looked at for errors."""


@dataclass(frozen=True, slots=True)
class BuiltPackage:
    """A package that is to be built.

    Attributes:
        name: its name.
        files: what its files hold, by their paths below its folder.
        executables: the paths of the files that can be started.
        spans: where the program says what a line of a file says; line 0 stands for all of it.
        is_compiled: whether nodes are built in it, and not only types.
    """

    name: str
    files: Mapping[str, bytes]
    executables: frozenset[str] = frozenset()
    spans: Mapping[str, Spans] = field(default_factory=dict)
    is_compiled: bool = False


def overlay(
    environment: Environment,
    packages: Sequence[BuiltPackage],
    tell: Callable[[Progress], object],
    environ: Mapping[str, str] = os.environ,
) -> tuple[Environment, list[Diagnostic]]:
    """Return an environment with packages that were built for it, and what kept them from it.

    Args:
        environment: what is to run the nodes; its own overlays are built upon.
        packages: what is to be built, a package after those that it needs.
        tell: is told how far a build is; nothing where none is started.
        environ: the environment variables.
    """
    if not packages:
        return environment, []
    names = " and ".join(f"`{each.name}`" for each in packages)
    try:
        made = _built(environment, packages, tell, environ)
    except _FailedError as failed:
        return environment, failed.diagnostics
    except BuildError as error:
        verb = "has" if len(packages) == 1 else "have"
        message = f"{names} {verb} to be built, and {error}"
        return environment, [Diagnostic(codes.NOT_BUILT, message, help=error.help)]
    except OSError as error:
        message = f"{names} could not be built in {cache_folder(environ)}: {reason(error)}"
        help_ = _SPACE if error.errno in (errno.ENOSPC, errno.EDQUOT) else _ELSEWHERE
        return environment, [Diagnostic(codes.NOT_BUILT, message, help=help_)]
    return replace(environment, overlays=(*environment.overlays, made)), []


_SPACE = "free some space there, or let XDG_CACHE_HOME name another folder"
_ELSEWHERE = "let XDG_CACHE_HOME name a folder that you may write to"


class _FailedError(Exception):
    """A build has failed, with what there is to say about it."""

    def __init__(self, diagnostics: list[Diagnostic]) -> None:
        super().__init__(diagnostics)
        self.diagnostics = diagnostics


def _built(
    environment: Environment,
    packages: Sequence[BuiltPackage],
    tell: Callable[[Progress], object],
    environ: Mapping[str, str],
) -> Path:
    """Return the folder of packages among `Environment.overlays`; they are built where need be."""
    folder = cache_folder(environ) / "builds"
    tools_key = _tools_key(environment, packages, environ)
    name = _short("-".join(each.name for each in packages))
    kept = folder / "overlays" / f"{name}-{_content_key(tools_key, packages)}"
    if _use(kept):
        return kept
    builder = find_builder(
        environment,
        {each.name: each.files for each in packages},
        environ,
        is_compiled=any(each.is_compiled for each in packages),
    )
    for each in (folder, folder / "overlays", folder / "workspaces"):
        each.mkdir(mode=0o700, parents=True, exist_ok=True)
    # The definitions here are nobody's own, wherever the cache is.
    (folder / "CATKIN_IGNORE").touch()
    workspace = Workspace(folder / "workspaces" / f"{name}-{_digest(tools_key)}")
    with _locked(workspace.root, lambda: tell(Progress(name, "waiting for another run"))):
        # The one that was waited for may have built the same.
        if _use(kept):
            return kept
        _write_sources(workspace, packages)
        with _unfinished(workspace), _log(workspace) as log:
            for step in builder(workspace):
                _run(step, workspace, packages, tell, log)
        _keep(workspace.made, kept)
        os.utime(workspace.root)
    _forget_oldest(folder / "overlays", MOST_OVERLAYS, kept)
    _forget_oldest(folder / "workspaces", MOST_WORKSPACES, workspace.root)
    return kept


def _use(kept: Path) -> bool:
    """Tell whether something is kept, and note that it is used now."""
    with suppress(OSError):
        os.utime(kept)
    return kept.is_dir()


def _tools_key(
    environment: Environment, packages: Sequence[BuiltPackage], environ: Mapping[str, str]
) -> str:
    """Return what changes with what packages are built with, and with what they are built upon."""
    found = built_upon(environment, [each.files for each in packages], environ)
    return json.dumps([tools(environment, environ), found])


def _content_key(tools_key: str, packages: Sequence[BuiltPackage]) -> str:
    contents = [
        [each.name, sorted(each.executables), *((path, _digest(text)) for path, text in files)]
        for each in packages
        for files in [sorted(each.files.items())]
    ]
    return _digest(json.dumps([tools_key, contents]))


def _digest(text: str | bytes) -> str:
    data = text.encode("utf-8", "surrogateescape") if isinstance(text, str) else text
    return hashlib.sha256(data).hexdigest()[:24]


def _short(name: str) -> str:
    """Return what a folder can be called by; two that begin alike differ in what follows."""
    return name if len(name) <= 80 else f"{name[:60]}-{_digest(name)[:12]}"


@contextmanager
def _locked(folder: Path, waits: Callable[[], object]) -> Iterator[None]:
    """Keep other runs out of a workspace; the lock ends with the process, however that ends."""
    while True:
        folder.mkdir(mode=0o700, exist_ok=True)
        try:
            file = (folder / "lock").open("w")
        except FileNotFoundError:  # another run has removed the folder just now
            continue
        with file:
            try:
                fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
            except BlockingIOError:
                waits()
                fcntl.flock(file, fcntl.LOCK_EX)
            # Who has waited for a run that removes the folder holds a lock of no folder.
            if _is_open(file, folder / "lock"):
                yield
                return


def _is_open(file: IO[str], path: Path) -> bool:
    with suppress(FileNotFoundError):
        return os.path.samestat(os.fstat(file.fileno()), path.stat())
    return False


@contextmanager
def _unfinished(workspace: Workspace) -> Iterator[None]:
    """Mark a workspace while it is built in: a killed compiler may have left half a file.

    Nothing is built upon either where the workspace was moved: CMake refuses it.
    """
    mark, place = workspace.unfinished, workspace.root / "place"
    if mark.exists() or not place.is_file() or place.read_bytes() != os.fsencode(workspace.root):
        for folder in ("build", "devel", "install"):
            shutil.rmtree(workspace.root / folder, ignore_errors=True)
    mark.touch()
    place.write_bytes(os.fsencode(workspace.root))
    try:
        yield
    except _FailedError:
        mark.unlink()
        raise
    mark.unlink()


def _write_sources(workspace: Workspace, packages: Sequence[BuiltPackage]) -> None:
    """Write packages; a file that holds what it is to hold keeps its time, by which tools go.

    No tool takes out of its folders what it once made of a file that is gone: then nothing there
    is built upon.
    """
    folder = workspace.source
    wanted = {
        folder / each.name / path: (text, path in each.executables)
        for each in packages
        for path, text in each.files.items()
    }
    # What stands beside them belongs to catkin_make.
    folder.mkdir(exist_ok=True)
    for path in sorted(folder.glob("*/**/*"), reverse=True):
        if path.is_dir() and not path.is_symlink():
            with suppress(OSError):  # it is not empty
                path.rmdir()
        elif path not in wanted:
            workspace.unfinished.touch()
            path.unlink()
    for path, (text, is_executable) in wanted.items():
        path.parent.mkdir(parents=True, exist_ok=True)
        if not path.is_file() or read_regular(path, _LARGEST_FILE) != text:
            path.write_bytes(text)
        path.chmod(0o755 if is_executable else 0o644)


_LARGEST_FILE = 64 * 1024 * 1024
"""More than any file of a package that is built, in bytes."""


def _run(
    step: Step,
    workspace: Workspace,
    packages: Sequence[BuiltPackage],
    tell: Callable[[Progress], object],
    log: Callable[[str], None],
) -> None:
    """Run a step of a build.

    Raises:
        _FailedError: it fails.
        KeyboardInterrupt: the user interrupts it.
    """
    lines: list[str] = []
    now = Progress(packages[0].name, step.title)
    tell(now)

    def on_line(_: Process, line: str) -> None:
        nonlocal now
        log(line)
        if len(lines) < _MOST_LINES:
            lines.append(line)
        after = progress_of(line, now)
        if after != now:
            now = after
            tell(now)

    process = Process(step.argv[0], step.argv, step.environ, cwd=workspace.root)
    with Supervisor(on_line) as supervisor:
        supervisor.start(process)
        supervisor.wait()
    if supervisor.stop_signal is not None:
        # What it would have done to this process, had nothing been built.
        signal.raise_signal(supervisor.stop_signal)
        # That did nothing, as where a shell has started this process in the background.
        raise KeyboardInterrupt
    [end] = supervisor.exits
    if end.status != 0:
        # Whatever a tool makes of it.
        if any(_FULL in line for line in lines) or not shutil.disk_usage(workspace.root).free:
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
        spans = {each.name: each.spans for each in packages}
        help_ = f"read what the build said in {workspace.log}"
        found = errors_of(lines, workspace.source, spans, help_)
        tool = Path(step.argv[0]).name
        message = f"`{now.package}` could not be built: `{tool}` {end.words}"
        raise _FailedError(found or [Diagnostic(codes.NOT_BUILT, message, help=help_)])


@contextmanager
def _log(workspace: Workspace) -> Iterator[Callable[[str], None]]:
    with workspace.log.open("w", encoding="utf-8", errors="replace") as file:
        written = 0

        def write(line: str) -> None:
            nonlocal written
            written += len(line) + 1
            if written <= _LONGEST_LOG:
                file.write(f"{line}\n")
                file.flush()

        yield write


def _keep(made: Mapping[str, Path], kept: Path) -> None:
    """Copy what nodes need of a workspace: the next build in it does not touch the copy."""
    with tempfile.TemporaryDirectory(dir=kept.parent, prefix=".") as temporary:
        whole = Path(temporary) / "overlay"
        whole.mkdir(mode=0o700)
        for name, folder in made.items():
            if folder.is_dir():
                shutil.copytree(folder, whole / name, symlinks=True)
        # catkin takes no folder without it for one that packages are installed in.
        (whole / ".catkin").touch()
        try:
            whole.rename(kept)
        except OSError:
            if not kept.is_dir():
                raise


def _forget_oldest(folder: Path, most: int, used: Path) -> None:
    """Remove what was not used for longest, but nothing that another run builds in."""
    ages = []
    for each in folder.iterdir():
        with suppress(OSError):
            ages.append((each.stat().st_mtime_ns, each))
    for _, each in sorted(ages, reverse=True)[most:]:
        if each != used:
            _forget(each)


def _forget(folder: Path) -> None:
    """Remove a folder, unless another run has locked it; none does meanwhile."""
    try:
        lock = (folder / "lock").open()
    except OSError:  # what was built has none
        shutil.rmtree(folder, ignore_errors=True)
        return
    with lock, suppress(BlockingIOError):
        fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        shutil.rmtree(folder, ignore_errors=True)
