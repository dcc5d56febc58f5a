"""What builds packages: colcon in ROS 2, catkin_make in ROS 1, or genpy alone where that is not.

Sources: `colcon build --help`, the wiki page "catkin/commands/catkin_make", and CMake's
documentation of `CMAKE_PROJECT_INCLUDE` and `cmake_language(DEFER)`.
"""

from __future__ import annotations

import json
import os
import shutil
import subprocess
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

from plastron_tui.regular_files import read_regular
from plastron_tui.ros.installations import Origin

from . import installing
from .action_messages import action_messages, needed_messages
from .build_inputs import DEBIAN_SHARE, PREFIX_PATHS, definitions_in, named_packages
from .environment import Environment, missing_packages, node_environ

# The tools of a build, by the Debian package that has each; what is asked for of the extra.
_TOOLS = {"cmake": "cmake", "make": "make", "c++": "g++"}
_BUILD_PACKAGES = ("ament_package", "catkin_pkg", "rosidl_generator_py")

# Debian's ROS is built with Debian's Python: one that stands before it in PATH has no catkin.
_SYSTEM_PATH = "/usr/local/sbin:/usr/sbin:/usr/bin:/sbin:/bin"

# Debian's generator of Python modules, of the package python3-genpy, which rospy depends on.
_GENPY = Path("/usr/lib/genpy")

_MENDS = "plastron_mends.cmake"

# The wheels name folders of the machine that built them, which CMake refuses where they are not
# there: each target of that kind is given the Python and numpy of this machine, or loses them,
# after the package has found all that it needs.
_MENDS_TEXT = """\
function(plastron_mend_target target)
  get_target_property(folders ${target} INTERFACE_INCLUDE_DIRECTORIES)
  set(kept "")
  foreach(folder IN LISTS folders)
    if(folder MATCHES "[$]<" OR EXISTS "${folder}")
      list(APPEND kept "${folder}")
    endif()
  endforeach()
  if(folders)
    set_property(TARGET ${target} PROPERTY INTERFACE_INCLUDE_DIRECTORIES "${kept}")
  endif()
endfunction()
function(plastron_mend)
  get_property(targets DIRECTORY PROPERTY IMPORTED_TARGETS)
  foreach(target IN LISTS targets)
    if(target MATCHES "__rosidl_generator_py$")
      set_property(
        TARGET ${target}
        PROPERTY INTERFACE_INCLUDE_DIRECTORIES "$CACHE{PLASTRON_INCLUDES}")
    else()
      plastron_mend_target(${target})
    endif()
  endforeach()
endfunction()
cmake_language(DEFER CALL plastron_mend)
"""

# There need be no wheel of rosidl_default_generators, which does nothing but find these.
_GENERATORS = "share/rosidl_default_generators/cmake/rosidl_default_generatorsConfig.cmake"
_GENERATORS_TEXT = """\
find_package(rosidl_cmake REQUIRED)
find_package(rosidl_generator_py REQUIRED)
find_package(rosidl_typesupport_fastrtps_c REQUIRED)
"""

_ASK_PYTHON = """\
import json, numpy, sys, sysconfig
headers = sysconfig.get_paths()["include"]
base = sysconfig.get_config_var("prefix")
print(json.dumps([sys.prefix, base, headers, numpy.get_include()]))
"""


class BuildError(Exception):
    """Packages cannot be built, because of what the message says.

    Attributes:
        help: how that is mended.
    """

    def __init__(self, message: str, help_: str) -> None:
        """Set what the diagnostic that comes of it says."""
        super().__init__(message)
        self.help = help_


@dataclass(frozen=True, slots=True)
class Workspace:
    """A folder that packages are built in, kept from one build to the next."""

    root: Path

    @property
    def source(self) -> Path:
        """The folder with a folder for each package."""
        return self.root / "src"

    @property
    def install(self) -> Path:
        """Where they are installed."""
        return self.root / "install"

    @property
    def unfinished(self) -> Path:
        """The file that is there while what was built is not to be built upon."""
        return self.root / "unfinished"

    @property
    def log(self) -> Path:
        """The file with all that the last build said."""
        return self.root / "build.log"

    @property
    def made(self) -> dict[str, Path]:
        """The folders of an overlay, and where each is in the workspace."""
        python = self.install / "lib" / "python3" / "dist-packages"
        return {
            "python": python if python.is_dir() else self.install / "python",
            **{each: self.install / each for each in ("lib", "share", "include")},
        }


@dataclass(frozen=True, slots=True)
class Step:
    """A command of a build: what it does in a word, what starts it, its environment variables."""

    title: str
    argv: tuple[str, ...]
    environ: Mapping[str, str]


Builder = Callable[[Workspace], Iterator[Step]]


def find_builder(
    environment: Environment,
    packages: Mapping[str, Mapping[str, bytes]],
    environ: Mapping[str, str],
    *,
    is_compiled: bool = False,
) -> Builder:
    """Return what makes the steps of a build of packages, given as their files by path.

    Args:
        environment: what is to run the nodes.
        packages: the files of each package, by path.
        environ: the environment variables.
        is_compiled: whether nodes are built, and not only types.

    Raises:
        BuildError: a tool is missing.
    """
    own = _with_overlays(environment, node_environ(environment, environ))
    if environment.ros_version == 2:
        return _colcon(environment, own)
    if environment.origin is Origin.SOURCED:
        return _catkin(environment, own)
    # Debian's rospy depends on genpy, but not on catkin. catkin finds no package that genpy alone
    # has made, and builds none without a CMakeLists.txt.
    own["PATH"] = _SYSTEM_PATH
    needed = _needed_packages(environment, packages)
    is_for_catkin = all("CMakeLists.txt" in files for files in packages.values())
    is_known = all((DEBIAN_SHARE / each / "cmake").is_dir() for each in needed)
    if is_for_catkin and is_known and not environment.overlays and _has_catkin():
        return _catkin(environment, own)
    if is_compiled:
        missing = " ".join(("catkin", "ros-message-generation", *_TOOLS.values()))
        message = "the tools for it are not installed"
        raise BuildError(message, f"install them with `sudo apt install {missing}`")
    return _genpy(environment, packages, own)


def _needed_packages(
    environment: Environment, packages: Mapping[str, Mapping[str, bytes]]
) -> list[str]:
    """Return the other packages of which definitions have fields.

    Debian's Python modules of messages come without the definitions, which are in a package of
    their own.

    Raises:
        BuildError: the definitions of one are not installed.
    """
    there = {
        folder.parent.name
        for each in environment.overlays
        for folder in (each / "share").glob("*/msg")
    }
    named = named_packages(text for files in packages.values() for text in definitions_in(files))
    needed = sorted(named - packages.keys() - there)
    missing = [each for each in needed if not (DEBIAN_SHARE / each / "msg").is_dir()]
    commands = [installing.debian_definitions(each) for each in missing]
    known = [each for each in commands if each is not None]
    if known and len(known) == len(missing):
        names = " and ".join(f"`{each}`" for each in missing)
        raise BuildError(
            f"the definitions of {names} are not installed",
            f"install them with `sudo apt install {' '.join(known)}`",
        )
    return needed


def _with_overlays(environment: Environment, own: dict[str, str]) -> dict[str, str]:
    """Let a build find the packages of the overlays."""
    overlays = [str(each) for each in environment.overlays]
    own["LC_ALL"] = "C.UTF-8"
    # What the user has set for builds of his own: where it ends up, and what says how far it is.
    own.pop("DESTDIR", None)
    own["CMAKE_GENERATOR"] = "Unix Makefiles"
    for name in PREFIX_PATHS:
        own[name] = os.pathsep.join(filter(None, (*overlays, own.get(name, ""))))
        if not own[name]:
            del own[name]
    return own


def _colcon(environment: Environment, own: dict[str, str]) -> Builder:
    settings = {"BUILD_TESTING": "OFF", "PYTHON_INSTALL_DIR": "python"}
    is_extra = environment.origin is Origin.EXTRA
    headers = None
    if is_extra:
        prefix, base, headers, numpy = _ask_python(environment, own)
        settings |= {
            "Python3_EXECUTABLE": str(environment.python),
            "Python3_ROOT_DIR": base,
            "PLASTRON_INCLUDES": f"{headers};{numpy}",
        }
        own["PATH"] = os.pathsep.join(filter(None, (f"{prefix}/bin", own.get("PATH", os.defpath))))
        for name in PREFIX_PATHS:
            own[name] = os.pathsep.join(filter(None, (own.get(name, ""), prefix)))
    _check_tools(environment, own, headers)

    def steps(workspace: Workspace) -> Iterator[Step]:
        environ = own | {
            # What the user has set for builds of his own does not count for this one.
            "COLCON_HOME": str(workspace.root / "colcon"),
            "COLCON_DEFAULTS_FILE": os.devnull,
        }
        options = settings
        if is_extra:
            mends = workspace.root / _MENDS
            _write(mends, _MENDS_TEXT)
            _write(workspace.root / "generators" / _GENERATORS, _GENERATORS_TEXT)
            options = options | {"CMAKE_PROJECT_INCLUDE": str(mends)}
            generators = str(workspace.root / "generators")
            environ["CMAKE_PREFIX_PATH"] += os.pathsep + generators
        words = [
            *("colcon", "--log-base", "log", "build", "--base-paths", "src"),
            *("--build-base", "build", "--install-base", "install", "--merge-install"),
            *("--event-handlers", "console_direct+", "status-", "desktop_notification-"),
            *("terminal_title-", "--executor", "sequential"),
            *("--cmake-args", "--no-warn-unused-cli"),
            *(f"-D{name}={value}" for name, value in options.items()),
        ]
        yield Step("configure", tuple(words), environ)

    return steps


def _ask_python(environment: Environment, own: Mapping[str, str]) -> list[str]:
    """Return the folders of a Python: itself, its base, its headers, and those of numpy."""
    remedy = f"install it with `{installing.extra(environment.distribution)}`"
    message = "what builds them is not among the Python packages"
    if missing_packages(environment, _BUILD_PACKAGES, own):
        raise BuildError(message, remedy)
    command = [str(environment.python), "-c", _ASK_PYTHON]
    done = subprocess.run(command, env=own, capture_output=True, text=True, check=False)
    if done.returncode:
        raise BuildError(message, remedy)
    folders: list[str] = json.loads(done.stdout.splitlines()[-1])
    return folders


def _check_tools(environment: Environment, own: Mapping[str, str], headers: str | None) -> None:
    path = own.get("PATH", os.defpath)
    missing = [each for tool, each in _TOOLS.items() if shutil.which(tool, path=path) is None]
    if headers is not None and not (Path(headers) / "Python.h").is_file():
        missing.append("python3-dev")
    has_colcon = shutil.which("colcon", path=path) is not None
    if environment.origin is not Origin.EXTRA and not has_colcon:
        missing.append("python3-colcon-common-extensions")
    if missing:
        message = "the tools for it are not installed"
        raise BuildError(message, f"install them with `sudo apt install {' '.join(missing)}`")
    if not has_colcon:
        command = installing.extra(environment.distribution)
        raise BuildError("colcon is not installed", f"install it with `{command}`")


def _has_catkin() -> bool:
    tools = all(shutil.which(tool, path=_SYSTEM_PATH) for tool in ("catkin_make", *_TOOLS))
    return tools and (DEBIAN_SHARE / "message_generation" / "cmake").is_dir()


def _catkin(environment: Environment, own: Mapping[str, str]) -> Builder:
    path = own.get("PATH", os.defpath)
    if not all(shutil.which(tool, path=path) for tool in ("catkin_make", *_TOOLS)):
        message = "the tools for it are not installed"
        name = f"ros-{environment.distribution or 'noetic'}-catkin"
        raise BuildError(message, f"install them with `sudo apt install {name} cmake make g++`")

    def steps(workspace: Workspace) -> Iterator[Step]:
        words = (
            # A definition that needs another one than before is refused without it.
            *("catkin_make", "--force-cmake", f"-j{os.cpu_count() or 1}", "install"),
            f"-DCMAKE_INSTALL_PREFIX={workspace.install}",
            f"-DPYTHON_EXECUTABLE={environment.python}",
            "-DCATKIN_ENABLE_TESTING=OFF",
        )
        # It asks this variable where it is.
        yield Step("configure", words, {**own, "PWD": str(workspace.root)})

    return steps


def _genpy(
    environment: Environment,
    packages: Mapping[str, Mapping[str, bytes]],
    own: Mapping[str, str],
) -> Builder:
    """Return what generates the Python modules of definitions, which is all that rospy needs."""

    def steps(workspace: Workspace) -> Iterator[Step]:
        shutil.rmtree(workspace.install, ignore_errors=True)
        search = _write_definitions(environment, packages, workspace.install / "share")
        for package in packages:
            module = workspace.install / "python" / package
            module.mkdir(parents=True)
            (module / "__init__.py").touch()
            for kind in ("msg", "srv"):
                folder = workspace.install / "share" / package / kind
                files = sorted(map(str, folder.glob(f"*.{kind}")))
                if files:
                    output = ("-p", package, "-o", str(module / kind))
                    command = (str(environment.python), str(_GENPY / f"gen{kind}_py.py"))
                    (module / kind).mkdir()
                    yield Step("generate", (*command, *output, *search, *files), own)
                    yield Step("generate", (*command, "--initpy", *output), own)

    return steps


def _write_definitions(
    environment: Environment, packages: Mapping[str, Mapping[str, bytes]], share: Path
) -> list[str]:
    """Write what genpy reads, and return the options by which it finds it.

    An action is the messages that it is sent by; these hold messages of actionlib.
    """
    texts = {
        f"{package}/{path}": text
        for package, files in packages.items()
        for path, text in files.items()
        if path.startswith(("msg/", "srv/"))
    }
    for package, files in packages.items():
        for path, text in files.items():
            if path.startswith("action/"):
                name = Path(path).stem
                for message, made in action_messages(name, text.decode("utf-8", "replace")):
                    texts[f"{package}/msg/{message}.msg"] = made.encode()
    for path, text in texts.items():
        (share / path).parent.mkdir(parents=True, exist_ok=True)
        (share / path).write_bytes(text)
    if any(path.startswith("action/") for files in packages.values() for path in files):
        for needed_name, made in needed_messages(environment.distribution):
            folder = share.parent / "needed" / needed_name.package / "msg"
            folder.mkdir(parents=True, exist_ok=True)
            (folder / f"{needed_name.name}.msg").write_text(made, encoding="utf-8")
    shares = [share, *(each / "share" for each in environment.overlays), share.parent / "needed"]
    return [
        word
        for each in (*shares, DEBIAN_SHARE)
        for folder in sorted(each.glob("*/msg"))
        for word in ("-I", f"{folder.parent.name}:{folder}")
    ]


_LARGEST_MEND = 1_000_000
"""More than any file of the builder's own, in bytes."""


def _write(file: Path, text: str) -> None:
    """Write a file of the builder's own; one that has the text keeps its time."""
    if not file.is_file() or read_regular(file, _LARGEST_MEND) != text.encode():
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")
