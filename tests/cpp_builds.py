"""C++ nodes, compiled and run without a build tool: with roscpp, and with rclcpp or its stand-in.

No package registry has rclcpp. Where the environment that the tests are started in has one, found
through AMENT_PREFIX_PATH, it is used; else `rclcpp_stand_in/` is built, on the rcl of the ROS 2
wheels. The first lines of a run say which it is.
"""

from __future__ import annotations

import fcntl
import os
import re
import shutil
import subprocess
import sys
import sysconfig
from collections.abc import Callable, Iterable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from pathlib import Path

import pytest
from machine import skip_or_fail

STAND_IN = Path(__file__).with_name("rclcpp_stand_in")
WARNINGS = ("-Wall", "-Wextra", "-Wpedantic", "-Werror")
FLAGS = ("-std=c++17", "-O0", "-fPIC", "-pthread")
_START = dict(os.environ)
_BEGIN = "begin.hpp"

# What calls of rclcpp's templates are linked with, beside the packages of messages. Of each what
# is there, and nothing that is not called.
_RCLCPP_LIBRARIES = (
    *("rclcpp", "rclcpp_action", "rclcpp_lifecycle", "component_manager", "class_loader"),
    *("rcl", "rcl_action", "rcl_lifecycle", "rcl_logging_interface", "rcutils", "rmw"),
    *("rcpputils", "tracetools", "libstatistics_collector"),
)

# Debian's libraries, of packages that the tests install.
_ROSCPP_LIBRARIES = (
    *("roscpp", "rosconsole", "roscpp_serialization", "rostime", "cpp_common", "boost_system"),
    *("boost_thread", "actionlib", "message_filters", "nodeletlib", "class_loader", "roslib"),
    *("dynamic_reconfigure_config_init_mutex", "image_transport", "tf", "tf2", "tf2_ros"),
    *("diagnostic_updater", "xmlrpcpp"),
)
_DEBIAN = Path("/usr")


@dataclass(frozen=True)
class CppLibrary:
    """What nodes of a client library are compiled and run with.

    Attributes:
        name: the client library, `roscpp` or `rclcpp`.
        words: which one it is, for a person.
        is_real: whether it is that library; else it is the stand-in of rclcpp.
        prefixes: where it and what it needs is installed; none for the system's.
        compiling: what a compiler is told of it.
        linking: what a linker is told of it, behind the sources.
        environ: the variables that a node needs beside those of its graph.
    """

    name: str
    words: str
    is_real: bool
    prefixes: tuple[Path, ...]
    compiling: tuple[str, ...]
    linking: tuple[str, ...]
    environ: Mapping[str, str]

    def compile(
        self,
        program: Path,
        *sources: Path,
        headers: Sequence[Path] = (),
        is_shared: bool = False,
    ) -> Path:
        """Make a program of sources, of which no warning is accepted, and return it.

        Args:
            program: where it is put.
            sources: its files.
            headers: folders of headers of its own.
            is_shared: whether it is a library that something else loads.
        """
        own = [f"-I{each}" for each in headers]
        command = ["g++", *FLAGS, *WARNINGS, *own, *self.compiling, *map(str, sources)]
        _run([*command, *["-shared"] * is_shared, "-o", str(program), *self.linking])
        return program

    def check(self, sources: Iterable[Path], *, headers: Sequence[Path] = ()) -> None:
        """Compile files each by itself, of which no warning is accepted, and make nothing."""
        own = [f"-I{each}" for each in headers]
        command = ["g++", "-fsyntax-only", *FLAGS, *WARNINGS, *own, *self.compiling]
        with ThreadPoolExecutor(os.cpu_count()) as pool:
            for _ in pool.map(lambda source: _run([*command, str(source)]), sources):
                pass

    def beside(self, *overlays: Path) -> CppLibrary:
        """Return it with the interface packages of overlays, each with `include` and `lib`."""
        if self.name == "roscpp":
            folders = [f"-isystem{each / 'include'}" for each in overlays]
            return replace(self, compiling=(*self.compiling, *folders))
        types = [name for each in overlays for name in _type_supports(each)]
        paths = [*(str(each / "lib") for each in overlays), self.environ["LD_LIBRARY_PATH"]]
        return replace(
            self,
            prefixes=(*overlays, *self.prefixes),
            compiling=(*self.compiling, *_header_folders(overlays)),
            linking=(*self.linking, *types),
            environ={**self.environ, "LD_LIBRARY_PATH": os.pathsep.join(paths)},
        )

    def with_types(self, environ: Mapping[str, str], cache: Path) -> CppLibrary:
        """Return it with the interface packages that nodes of an environment find in a cache."""
        libraries = environ["LD_LIBRARY_PATH"].split(os.pathsep)
        return self.beside(
            *(Path(each).parent for each in libraries if each.startswith(str(cache)))
        )

    @property
    def beginning(self) -> tuple[str, ...]:
        """What begins a source with the client library's header, which is compiled already."""
        place = self.compiling.index("-include")
        return self.compiling[place - 1 : place + 2]

    def building(self, environ: Mapping[str, str]) -> dict[str, str]:
        """Return the environment of a build by whose tools it is found."""
        own = {**environ, **self.environ}
        for name in ("AMENT_PREFIX_PATH", "CMAKE_PREFIX_PATH"):
            there = own.get(name, "").split(os.pathsep)
            parts = [*map(str, self.prefixes), *filter(None, there)]
            own[name] = os.pathsep.join(dict.fromkeys(parts))
        return own


def find_roscpp(factory: pytest.TempPathFactory) -> CppLibrary:
    """Return Debian's roscpp; its headers are compiled once for all workers."""
    if shutil.which("g++") is None or not (_DEBIAN / "include/ros/ros.h").is_file():
        skip_or_fail("C++ of ROS 1 is missing: apt-get install g++ libroscpp-dev")
    folder = _made_once(factory, "roscpp", lambda made: _precompile(made, "ros/ros.h", ()))
    multiarch = sysconfig.get_config_var("MULTIARCH") or "x86_64-linux-gnu"
    libraries = _present(_ROSCPP_LIBRARIES, _DEBIAN / "lib" / multiarch)
    linking = ("-Wl,--as-needed", *libraries)
    # Some packages, which ROS 2 has too, have their headers a folder deeper there.
    found = sorted((_DEBIAN / "include").glob("*/*"))
    deeper = [each.parent for each in found if each.name == each.parent.name and each.is_dir()]
    compiling = [*_beginning(folder), *(f"-isystem{each}" for each in deeper)]
    words = "Debian's roscpp"
    return CppLibrary("roscpp", words, True, (), tuple(compiling), linking, {})


def describe_rclcpp() -> str:
    """Tell in a word which rclcpp the nodes of this run are compiled with."""
    prefix = real_prefix()
    if prefix is None:
        return "a stand-in of rclcpp"
    text = (prefix / "share/rclcpp/package.xml").read_text(encoding="utf-8")
    version = re.search(r"<version>(.*?)</version>", text)
    return f"rclcpp {version[1] if version else ''}".rstrip()


def find_rclcpp(factory: pytest.TempPathFactory) -> CppLibrary:
    """Return the environment's rclcpp, or the stand-in, which is built once for all workers."""
    if shutil.which("g++") is None:
        skip_or_fail("there is no C++ compiler: apt-get install g++")
    real = real_prefix()
    if real is not None:
        prefixes = _ament_prefixes()
        headers = _header_folders(prefixes)
        folder = _made_once(
            factory, "rclcpp", lambda made: _precompile(made, "rclcpp/rclcpp.hpp", headers)
        )
        paths = _START.get("LD_LIBRARY_PATH", "")
    else:
        wheels = Path(sys.prefix)
        if not (wheels / "lib/librcl.so").is_file():
            skip_or_fail("rcl is missing: install the extra `ros2`")
        folder = _made_once(factory, "rclcpp_stand_in", lambda made: _build_stand_in(made, wheels))
        prefixes = (folder / "install", wheels)
        headers = _header_folders(prefixes)
        paths = os.pathsep.join(map(str, (folder / "install/lib", *_library_folders(wheels))))
    linking = [f"-L{prefix / 'lib'}" for prefix in prefixes]
    types = [each for prefix in prefixes for each in _type_supports(prefix)]
    named = [name for prefix in prefixes for name in _present(_RCLCPP_LIBRARIES, prefix / "lib")]
    linking += ["-Wl,--as-needed,--allow-shlib-undefined", *dict.fromkeys(named), *types]
    return CppLibrary(
        "rclcpp",
        describe_rclcpp(),
        real is not None,
        prefixes,
        (*_beginning(folder), *headers),
        tuple(linking),
        {"LD_LIBRARY_PATH": paths},
    )


def _ament_prefixes() -> tuple[Path, ...]:
    parts = _START.get("AMENT_PREFIX_PATH", "").split(os.pathsep)
    return tuple(Path(each) for each in parts if each)


def real_prefix() -> Path | None:
    """Return where the environment has an rclcpp that is not a stand-in."""
    for prefix in _ament_prefixes():
        share = prefix / "share/rclcpp"
        if (share / "package.xml").is_file() and not (share / "stand_in").exists():
            return prefix
    return None


def _header_folders(prefixes: Iterable[Path]) -> tuple[str, ...]:
    """Return the compiler's arguments for all headers; a package has a folder for its own."""
    folders = [each for prefix in prefixes for each in sorted((prefix / "include").glob("*"))]
    return tuple(word for each in folders if each.is_dir() for word in ("-isystem", str(each)))


def _type_supports(prefix: Path) -> list[str]:
    return sorted(map(str, (prefix / "lib").glob("lib*__rosidl_typesupport_cpp.so")))


def _library_folders(wheels: Path) -> list[Path]:
    """Return where the libraries of wheels find each other, and Python's, which some need."""
    packages = Path(sysconfig.get_paths()["platlib"])
    python = Path(sysconfig.get_config_var("LIBDIR"))
    return [wheels / "lib", *sorted(packages.glob("ros_*.libs")), python]


def _present(names: Iterable[str], folder: Path) -> list[str]:
    return [f"-l{name}" for name in names if (folder / f"lib{name}.so").exists()]


def _made_once(factory: pytest.TempPathFactory, name: str, make: Callable[[Path], None]) -> Path:
    """Return a folder that the first worker who needs it fills."""
    base = factory.getbasetemp()
    shared = base.parent if "PYTEST_XDIST_WORKER" in os.environ else base
    folder = shared / name
    with (shared / f"{name}.lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        if not (folder / "made").exists():
            folder.mkdir(exist_ok=True)
            make(folder)
            (folder / "made").touch()
    return folder


def _precompile(folder: Path, header: str, headers: Sequence[str]) -> None:
    """Compile a client library's header, which takes most of the time that a node takes."""
    begin = folder / _BEGIN
    begin.write_text(f"#include <{header}>\n")
    _run(["g++", *FLAGS, *WARNINGS, *headers, "-x", "c++-header", str(begin)])


def _beginning(folder: Path) -> tuple[str, ...]:
    """Return the arguments by which a source begins with the header that is compiled already."""
    return ("-Winvalid-pch", "-include", str(folder / _BEGIN))


def _build_stand_in(folder: Path, wheels: Path) -> None:
    """Build and install the stand-in as a package of ROS, which CMake finds as well."""
    install = folder / "install"
    shutil.copytree(STAND_IN / "include/rclcpp", install / "include/rclcpp/rclcpp")
    share = install / "share/rclcpp"
    (share / "cmake").mkdir(parents=True)
    shutil.copy(STAND_IN / "package.xml", share)
    (share / "stand_in").touch()
    index = install / "share/ament_index/resource_index/packages"
    index.mkdir(parents=True)
    (index / "rclcpp").touch()
    headers = _header_folders((install, wheels))
    _precompile(folder, "rclcpp/rclcpp.hpp", headers)
    # One unit takes half as long as the files of it.
    unit = folder / "unit.cpp"
    sources = sorted((STAND_IN / "src").glob("*.cpp"))
    unit.write_text("".join(f'#include "{each}"\n' for each in sources))
    (install / "lib").mkdir()
    library = install / "lib/librclcpp.so"
    names = (
        "rcl",
        "rcl_interfaces__rosidl_typesupport_cpp",
        "rcl_yaml_param_parser",
        "rcutils",
        "rmw",
    )
    python = f"-lpython{sysconfig.get_config_var('LDVERSION')}"
    command = ["g++", "-shared", *FLAGS, *WARNINGS, *_beginning(folder), *headers, str(unit)]
    command += ["-o", str(library), *(f"-L{each}" for each in _library_folders(wheels))]
    command += [*(f"-l{name}" for name in names), "-Wl,--no-as-needed", python]
    _run(command)
    template = (STAND_IN / "rclcppConfig.cmake.in").read_text(encoding="utf-8")
    folders = ";".join(word for word in headers if word != "-isystem")
    text = template.replace("@HEADERS@", folders).replace("@WHEELS@", str(wheels))
    (share / "cmake/rclcppConfig.cmake").write_text(text, encoding="utf-8")


def _run(command: Sequence[str]) -> None:
    """Run a compiler; what it has to say fails the test."""
    done = subprocess.run(
        command,
        env={**_START, "LC_ALL": "C.UTF-8"},
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        timeout=600,
        check=False,
    )
    assert done.returncode == 0, done.stdout
