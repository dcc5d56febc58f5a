"""Interface packages that nothing installs: made from their definitions, once, and kept."""

from __future__ import annotations

import hashlib
import json
import os
import shlex
import shutil
import subprocess
import tempfile
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace
from pathlib import Path

from plastron_tui.diagnostics import Diagnostic, codes
from plastron_tui.regular_files import read_regular, reason
from plastron_tui.ros.definition import MAX_DEFINITION_BYTES
from plastron_tui.ros.installations import Origin
from plastron_tui.ros.interfaces import InterfaceName
from plastron_tui.user_folders import cache_folder

from . import installing
from .action_messages import NEEDED, action_messages, needed_messages
from .environment import (
    Environment,
    missing_package,
    missing_packages,
    node_environ,
)

Definitions = Mapping[str, Mapping[str, str]]
"""The definitions of a package: by kind (`msg`, `srv`, `action`), then by name."""

# Debian's generator of Python modules, of the package python3-genpy, which rospy depends on.
_GENPY = Path("/usr/lib/genpy")

# What builds with CMake, by the Debian package that has it; and what of the extra is asked for.
_TOOLS = {"cmake": "cmake", "make": "make", "c++": "g++"}
_BUILD_PACKAGES = ("ament_package", "catkin_pkg", "rosidl_generator_py")

# The wheels name the Python and numpy folders of the machine that built them, which CMake
# refuses where they are not there; the packages are found here first, and are mended.
_CMAKE = """\
cmake_minimum_required(VERSION 3.20)
project({package} C CXX)
find_package(ament_cmake REQUIRED)
find_package(rosidl_cmake REQUIRED)
find_package(rosidl_generator_py REQUIRED)
find_package(rosidl_typesupport_fastrtps_c REQUIRED)
foreach(package builtin_interfaces service_msgs unique_identifier_msgs action_msgs)
  find_package(${{package}} REQUIRED)
  set_target_properties(
    ${{package}}::${{package}}__rosidl_generator_py
    PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "{includes}")
endforeach()
rosidl_generate_interfaces(${{PROJECT_NAME}} {files})
ament_package()
"""

_MANIFEST = """\
<?xml version="1.0"?>
<package format="3">
  <name>{package}</name>
  <version>0.0.0</version>
  <description>Types that Plastron knows by name</description>
  <maintainer email="nobody@example.com">nobody</maintainer>
  <license>Apache-2.0</license>
  <buildtool_depend>ament_cmake</buildtool_depend>
  <depend>action_msgs</depend>
  <exec_depend>rosidl_default_runtime</exec_depend>
  <member_of_group>rosidl_interface_packages</member_of_group>
</package>
"""

_ASK_PYTHON = """\
import json, numpy, sys, sysconfig
headers = sysconfig.get_paths()["include"]
base = sysconfig.get_config_var("prefix")
print(json.dumps([sys.prefix, base, headers, numpy.get_include()]))
"""


class BuildError(Exception):
    """A package cannot be made; `help` says what is missing, or where to look."""

    def __init__(self, message: str, help_: str) -> None:
        """Set both lines of the diagnostic that comes of it."""
        super().__init__(message)
        self.help = help_


def complete(
    environment: Environment,
    types: Iterable[InterfaceName],
    definitions: Callable[[str], Definitions | None],
    tell: Callable[[str], object],
    environ: Mapping[str, str] = os.environ,
) -> tuple[Environment, list[Diagnostic]]:
    """Return an environment with the packages of the types that nodes use, and what it lacks.

    A package that is not installed is made where its definitions are known: in ROS 2's Python
    packages and in Debian's ROS 1. A sourced ROS installs it.

    Args:
        environment: what is to run the nodes.
        types: the types that the nodes use.
        definitions: returns those of a package that may be made here, None for others.
        tell: is told what is made before that begins, for it takes seconds.
        environ: the environment variables.
    """
    used: dict[str, set[str]] = {}
    for type_ in types:
        used.setdefault(type_.package, set()).add(type_.name)
    diagnostics = []
    overlays = []
    for package in missing_packages(environment, sorted(used), environ):
        known = definitions(package) if environment.origin in _MAKERS else None
        if known is None or not used[package] <= {name for each in known.values() for name in each}:
            diagnostics.append(missing_package(environment, package))
            continue
        try:
            overlays.append(kept_package(environment, package, known, tell, environ))
        except BuildError as error:
            diagnostics.append(Diagnostic(codes.NOT_BUILT, str(error), help=error.help))
        except OSError as error:
            message = f"`{package}` could not be kept in {cache_folder(environ)}: {reason(error)}"
            diagnostics.append(Diagnostic(codes.NOT_BUILT, message))
    return replace(environment, overlays=(*environment.overlays, *overlays)), diagnostics


def kept_package(
    environment: Environment,
    package: str,
    definitions: Definitions,
    tell: Callable[[str], object],
    environ: Mapping[str, str] = os.environ,
) -> Path:
    """Return the folder of a package among `Environment.overlays`; it is made where it is not.

    Raises:
        BuildError: the package cannot be made.
        OSError: the user's cache cannot be written.
    """
    folder = cache_folder(environ) / "interfaces"
    kept = folder / f"{package}-{_key(environment, definitions)}"
    if kept.is_dir():
        return kept
    tell(f"building `{package}` for {environment.words}, once")
    folder.mkdir(mode=0o700, parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=folder, prefix=".") as temporary:
        workspace = Path(temporary)
        files = _write_definitions(workspace / "src", definitions)
        made = workspace / "made"
        made.mkdir()
        try:
            _MAKERS[environment.origin](environment, package, files, made, environ)
        except subprocess.CalledProcessError as error:
            log = folder / f"{package}.log"
            log.write_text(f"{shlex.join(error.cmd)}\n{error.stdout}", encoding="utf-8")
            message = f"`{package}` could not be built: `{error.cmd[0]}` failed"
            raise BuildError(message, f"read what it said in {log}") from error
        try:
            made.rename(kept)
        except OSError:
            # Another run may have been faster.
            if not kept.is_dir():
                raise
    return kept


def _key(environment: Environment, definitions: Definitions) -> str:
    """Return what changes with all that a package is made of."""
    python = environment.python.resolve()
    facts = [environment.words, str(environment.python), str(python), python.stat().st_mtime_ns]
    return hashlib.sha256(json.dumps([facts, definitions]).encode()).hexdigest()[:16]


def _write_definitions(folder: Path, definitions: Definitions) -> list[Path]:
    files = []
    for kind, texts in definitions.items():
        (folder / kind).mkdir(parents=True)
        for name, text in texts.items():
            files.append(folder / kind / f"{name}.{kind}")
            files[-1].write_text(text, encoding="utf-8")
    return files


def _make_with_genpy(
    environment: Environment,
    package: str,
    files: Sequence[Path],
    made: Path,
    environ: Mapping[str, str],
) -> None:
    """Generate the Python modules of a ROS 1 package; its fields hold nothing of other packages."""
    module = made / "python" / package
    module.mkdir(parents=True)
    (module / "__init__.py").touch()
    own = node_environ(environment, environ)
    files = [*files, *_write_action_messages(files)]
    search = _write_needed_messages(environment.distribution, made.parent / "needed")
    search += ["-I", f"{package}:{files[0].parents[1] / 'msg'}"]
    for kind in sorted({file.parent.name for file in files} - {"action"}):
        command = [str(environment.python), str(_GENPY / f"gen{kind}_py.py")]
        of_kind = [str(file) for file in files if file.parent.name == kind]
        output = ["-p", package, "-o", str(module / kind)]
        (module / kind).mkdir()
        for arguments in ([*output, *search, *of_kind], ["--initpy", *output]):
            _run([*command, *arguments], own)


def _write_action_messages(files: Sequence[Path]) -> list[Path]:
    """Write the messages of the actions among the definitions, and return their files."""
    made = []
    for file in files:
        if file.parent.name == "action":
            folder = file.parents[1] / "msg"
            folder.mkdir(exist_ok=True)
            for name, text in action_messages(
                file.stem, read_regular(file, MAX_DEFINITION_BYTES).decode()
            ):
                made.append(folder / f"{name}.msg")
                made[-1].write_text(text, encoding="utf-8")
    return made


def _write_needed_messages(distribution: str, folder: Path) -> list[str]:
    """Write the messages that actions hold, and return the options by which genpy finds them."""
    for name, text in needed_messages(distribution):
        file = folder / name.package / f"{name.name}.msg"
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")
    return [each for package in NEEDED for each in ("-I", f"{package}:{folder / package}")]


def _make_with_cmake(
    environment: Environment,
    package: str,
    files: Sequence[Path],
    made: Path,
    environ: Mapping[str, str],
) -> None:
    """Build a ROS 2 package with the tools of the environment's own prefix."""
    if missing_packages(environment, _BUILD_PACKAGES, environ):
        raise BuildError(
            f"`{package}` has to be built, and what builds it is not among the Python packages",
            f"install it with `{installing.extra(environment.distribution)}`",
        )
    own = node_environ(environment, environ)
    answer = _run([str(environment.python), "-c", _ASK_PYTHON], own)
    prefix, base, *includes = json.loads(answer.splitlines()[-1])
    _check_tools(package, Path(includes[0]), own)
    own |= {
        "PATH": os.pathsep.join(filter(None, (f"{prefix}/bin", own.get("PATH", os.defpath)))),
        "AMENT_PREFIX_PATH": prefix,
        "CMAKE_PREFIX_PATH": prefix,
    }
    source, build, install = files[0].parents[1], made.parent / "build", made.parent / "install"
    names = " ".join(str(file.relative_to(source)) for file in files)
    text = _CMAKE.format(package=package, includes=";".join(includes), files=names)
    (source / "CMakeLists.txt").write_text(text, encoding="utf-8")
    (source / "package.xml").write_text(_MANIFEST.format(package=package), encoding="utf-8")
    settings = {
        "CMAKE_INSTALL_PREFIX": install,
        "PYTHON_INSTALL_DIR": "python",
        "Python3_EXECUTABLE": environment.python,
        "Python3_ROOT_DIR": base,
        "BUILD_TESTING": "OFF",
    }
    options = [f"-D{name}={value}" for name, value in settings.items()]
    paths = ["-S", str(source), "-B", str(build)]
    _run(["cmake", *paths, "-G", "Unix Makefiles", *options], own)
    jobs = str(os.cpu_count() or 1)
    _run(["cmake", "--build", str(build), "-j", jobs, "--target", "install"], own)
    # The rest is for packages that depend on this one, and the definitions would be found.
    for part in ("lib", "python"):
        (install / part).rename(made / part)


def _check_tools(package: str, headers: Path, environ: Mapping[str, str]) -> None:
    path = environ.get("PATH", os.defpath)
    missing = [each for tool, each in _TOOLS.items() if shutil.which(tool, path=path) is None]
    if not (headers / "Python.h").is_file():
        missing.append("python3-dev")
    if missing:
        message = f"`{package}` has to be built, and the tools for it are not installed"
        raise BuildError(message, f"install them with `sudo apt install {' '.join(missing)}`")


def _run(command: Sequence[str], environ: Mapping[str, str]) -> str:
    """Run a step of a build and return what it prints.

    Raises:
        CalledProcessError: the step fails; it has what was printed.
    """
    done = subprocess.run(
        command,
        env=environ,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        encoding="utf-8",
        errors="replace",
        check=True,
    )
    return done.stdout


_MAKERS = {Origin.EXTRA: _make_with_cmake, Origin.DEBIAN: _make_with_genpy}
