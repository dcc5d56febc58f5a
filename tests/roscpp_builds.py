"""Generated nodes of ROS 1 in C++, and the headers of the types that Debian has not."""

from __future__ import annotations

import fcntl
import subprocess
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path

from machine import skip_or_fail
from processes import plastron

from plastron_tui.ros.catalog import Catalog

INCLUDE = Path("/usr/include")
SHARE = Path("/usr/share")
GENERATOR = Path("/usr/lib/gencpp/gen_cpp.py")
ACTION_GENERATOR = Path("/usr/lib/actionlib_msgs/genaction.py")
PYTHON = Path("/usr/bin/python3")
PACKAGES = ("actionlib_tutorials", "beginner_tutorials")
INSTALL = (
    "ROS 1 for C++ is missing: apt-get install --no-install-recommends libroscpp-dev "
    "libactionlib-dev libnodeletlib-dev libstd-srvs-dev libsensor-msgs-dev python3-gencpp g++"
)


@contextmanager
def locked(folder: Path) -> Iterator[None]:
    """Let one worker at a time make what is in a folder."""
    folder.mkdir(parents=True, exist_ok=True)
    with (folder / "lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        yield


def _generated(folder: Path, package: str, definitions: Mapping[str, Mapping[str, str]]) -> None:
    """Write the headers of a package that Debian has not."""
    sources: list[Path] = []
    for kind, texts in definitions.items():
        for name, text in texts.items():
            file = folder / "definitions" / package / kind / f"{name}.{kind}"
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text)
            sources.append(file)
            if kind == "action":
                messages = folder / "definitions" / package / "msg"
                _run(PYTHON, ACTION_GENERATOR, file, "-o", messages)
    messages = folder / "definitions" / package / "msg"
    sources = [each for each in sources if each.suffix != ".action"]
    sources += messages.glob("*.msg") if messages.is_dir() else ()
    known = [f"-I{name}:{SHARE / name / 'msg'}" for name in ("std_msgs", "actionlib_msgs")]
    for source in dict.fromkeys(sources):
        arguments = ("-p", package, "-o", folder / package, "-e", SHARE / "gencpp")
        _run(PYTHON, GENERATOR, source, f"-I{package}:{messages}", *known, *arguments)


def headers(cache: Path) -> Path:
    """Return where `include` has the headers of types that Debian has not, of those tested."""
    if not all(map(Path.is_file, (GENERATOR, ACTION_GENERATOR, INCLUDE / "nodelet/nodelet.h"))):
        skip_or_fail(INSTALL)
    folder = cache / "include"
    with locked(folder):
        if not (folder / "made").exists():
            for package in PACKAGES:
                definitions = Catalog("noetic").table_package(package)
                assert definitions is not None
                _generated(folder, package, definitions)
            (folder / "made").touch()
    return folder.parent


def _run(*command: str | Path) -> None:
    done = subprocess.run(
        list(map(str, command)), capture_output=True, text=True, timeout=300, check=False
    )
    assert done.returncode == 0, done.stdout + done.stderr


def generate_cpp(program: str, folder: Path, layout: str) -> Path:
    """Generate a program that has one node in C++, in a layout, and return its main file."""
    folder.mkdir(parents=True, exist_ok=True)
    file = folder / "program.plastron"
    file.write_text(program)
    (folder / "plastron.yaml").write_text(f"cpp: {layout}\n")
    done = plastron("generate", file, "-o", folder / "output")
    assert done.returncode == 0, done.stdout + done.stderr
    [made] = folder.glob("output/**/*.cpp")
    return made
