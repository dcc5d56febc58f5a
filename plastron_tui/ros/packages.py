"""What the build tools take as the name, the version, the maintainer of a package.

Sources: REP 144 ("ROS Package Naming"); REP 149 ("Package Manifest Format Three"), with what
catkin_pkg makes of it in `Package.validate` and `Person.validate`, which catkin, colcon and rosdep
read a `package.xml` by.
"""

from __future__ import annotations

import keyword
import re
import sys
from string import ascii_letters, ascii_lowercase, digits
from typing import NamedTuple

from .names import NameProblem

BUILT_FOLDERS = frozenset({"build", "install", "devel", "log"})
"""What builds leave beside packages, and beside the files of one."""

CACHES = frozenset({"node_modules", "__pycache__"})
"""Folders that tools fill, wherever they are."""

IGNORE_MARKERS = frozenset({"CATKIN_IGNORE", "COLCON_IGNORE", "AMENT_IGNORE"})
"""Files that tell the build tools to leave out the folder that they are in."""

LEFT_BEHIND = frozenset(
    {"archive", "attic", "backup", "deprecated", "depricated", "legacy", "old", "sandbox",
     "templates", "tmp", "unused"}
)  # fmt: skip
"""Folders of a package for what nobody starts any more, or not as it is."""

_TESTS = re.compile(r"(?:tests?_?\d*|(?:g|ros|unit_?)tests?)", re.IGNORECASE)
_SOME_TESTS = re.compile(r".+_tests", re.IGNORECASE)

LONGEST_PACKAGE_NAME = 160
"""The longest name of a package, in characters.

Files are called by it, of which file systems take names of 255 bytes. For a package of types, with
`_interfaces` behind the name, rosidl_generator_py builds
`NAME_s__rosidl_typesupport_introspection_c.cpython-312-x86_64-linux-gnu.so`.
"""

LONGEST_FILE_NAME = 200
"""The longest name of a file of a package, and of an executable, in characters.

A test of it is called `test_NAME.py`, which pytest compiles to a file with some 30 letters more.
"""

MAINTAINER_MISSING = ("Maintainer", "maintainer@example.com")
"""Who maintains a package of which the program does not say it: RFC 2606 keeps the domain free."""

DEFAULT_VERSION = "0.0.0"
"""The version of a new package, as `ros2 pkg create` writes it."""

_LOCAL = frozenset(f"{ascii_letters}{digits}-_%+")
_DOMAIN = frozenset(f"{ascii_letters}{digits}-%")
_NAME = frozenset(f"{ascii_lowercase}{digits}_")
_FILE = frozenset(f"{ascii_letters}{digits}_.-")

# REP 144: "generic" names say nothing of what is in the package, and are meant for others. What
# Python, CMake or the build tools have of that name would be hidden, or hide the package.
_TAKEN = {
    "test": "CMake has a target of this name, and Python a package",
    "tests": "CMake has a target of this name, and Python packages of tests",
    "all": "CMake has a target of this name",
    "clean": "CMake has a target of this name",
    "help": "CMake has a target of this name",
    "install": "CMake has a target of this name",
    "package": "CMake has a target of this name",
    "uninstall": "CMake has a target of this name",
    "build": "colcon and catkin keep what they build in a folder of this name",
    "devel": "catkin keeps what it builds in a folder of this name",
    "log": "colcon keeps what it logs in a folder of this name",
    "src": "workspaces keep their packages in a folder of this name",
    "launch": "ROS 2 has a Python module of this name",
    "setup": "the build tools have a file `setup.py` of their own",
}


class Maintainer(NamedTuple):
    """Who looks after a package."""

    name: str
    mail: str


def is_test_folder(name: str, *, is_package: bool = False) -> bool:
    """Tell whether a folder is for tests, as its name says, and for what these need.

    Args:
        name: its name, without those of the folders around it.
        is_package: whether it is that of a package. One called `arm_system_tests` has nodes of its
            own that people start, and these are as those of any other package.
    """
    if not is_package and _SOME_TESTS.fullmatch(name) is not None:
        return True
    return _TESTS.fullmatch(name) is not None


def check_package_name(name: str) -> NameProblem | None:
    """Return what is wrong with the name of a new package, None when nothing is.

    REP 144: lower case letters, digits and underscores, a letter first, at least two characters.
    REP 149 allows dashes for system dependencies; no module of Python nor C++ can have one.
    """
    if not name:
        return NameProblem("a package needs a name", 0, 0)
    if len(name) > LONGEST_PACKAGE_NAME:
        message = (
            f"the name of a package has at most {LONGEST_PACKAGE_NAME} characters, and this one "
            f"{len(name)}"
        )
        return NameProblem(message, LONGEST_PACKAGE_NAME, len(name) - LONGEST_PACKAGE_NAME)
    mended = mended_package_name(name)
    bad = _first_run(name, _NAME)
    if bad is not None:
        start, end = bad
        if name[start].isascii() and name[start].isupper():
            message = "the name of a package has no capital letters"
        else:
            message = f"the name of a package has no {_shown(name[start])}"
        return NameProblem(message, start, end - start, mended)
    if name[0] not in ascii_lowercase:
        end = next((at for at, char in enumerate(name) if char in ascii_lowercase), len(name))
        return NameProblem("the name of a package starts with a letter", 0, end, mended)
    if len(name) < 2:
        message = "the name of a package has at least two characters"
        return NameProblem(message, 0, len(name))
    if "__" in name:
        return NameProblem("the name of a package has no `__`", name.index("__"), 2, mended)
    return None


def taken_package_name(name: str) -> str | None:
    """Return why a name that can be a package's is better another's, None where it is free."""
    if name in _TAKEN:
        return _TAKEN[name]
    if keyword.iskeyword(name):
        return "it is a word of Python, and no program can import it"
    # A sourced workspace comes before Python's own modules.
    if name in sys.stdlib_module_names:
        return "Python has a module of this name, which the package would hide"
    return None


def mended_package_name(name: str) -> str | None:
    """Return a valid name for a package that is like this one, None when too little is left."""
    spread = "".join(
        f"_{char}" if char.isupper() and at and name[at - 1].islower() else char
        for at, char in enumerate(name[:LONGEST_PACKAGE_NAME])
    )
    kept = "".join(char if char in _NAME else "_" for char in spread.lower())
    mended = "_".join(part for part in kept.split("_") if part)
    if mended and mended[0] in digits:
        mended = f"package_{mended}"
    return mended if len(mended) > 1 and mended != name else None


def is_version(version: str) -> bool:
    """Tell whether a text is a version (REP 149): three numbers with dots between."""
    parts = version.split(".")
    return len(parts) == 3 and all(part and not set(part) - set(digits) for part in parts)


def check_version(version: str) -> NameProblem | None:
    """Return what is wrong with the version of a package, None when nothing is.

    REP 149: three numbers with dots between; catkin_pkg warns of leading zeros.
    """
    parts = version.split(".")
    if not is_version(version):
        return NameProblem("a version is three numbers, such as `0.1.0`", 0, len(version))
    start = 0
    for part in parts:
        if len(part) > 1 and part[0] == "0":
            mended = ".".join(str(int(each)) for each in parts) if len(version) < 100 else None
            return NameProblem("a number of a version has no leading zero", start, 1, mended)
        start += len(part) + 1
    return None


def check_mail(mail: str) -> NameProblem | None:
    """Return what catkin_pkg does not take as an address, None when it takes it."""
    local, at, domain = mail.rpartition("@")
    if not at:
        return NameProblem("an address has an `@`", 0, len(mail))
    for start, text, allowed in (0, local, _LOCAL), (len(local) + 1, domain, _DOMAIN):
        place = start
        for part in text.split("."):
            bad = _first_run(part, allowed)
            if bad is not None:
                message = f"an address has no {_shown(part[bad[0]])} here"
                return NameProblem(message, place + bad[0], bad[1] - bad[0])
            if not part:
                message = "an address has no empty part"
                return NameProblem(message, start, len(text))
            place += len(part) + 1
    last = domain.rpartition(".")[2]
    if "." not in domain or len(last) < 2 or set(last) - set(ascii_letters):
        message = "an address ends in a domain, such as `example.com`"
        return NameProblem(message, len(local) + 1, len(domain))
    return None


def parse_maintainer(text: str) -> tuple[Maintainer | None, NameProblem | None]:
    """Read `NAME <MAIL>`, or say what is wrong with it; one of the two is None."""
    opening = text.find("<")
    if opening < 0 or not text.rstrip().endswith(">"):
        remedy = "a maintainer is a name and an address, as in `Ada <ada@example.com>`"
        return None, NameProblem(remedy, 0, len(text))
    closing = text.rstrip().rindex(">")
    mail = text[opening + 1 : closing]
    problem = check_mail(mail.strip())
    if problem is not None:
        moved = opening + 1 + (len(mail) - len(mail.lstrip()))
        return None, problem._replace(offset=problem.offset + moved)
    name = text[:opening].strip()
    if not name:
        return None, NameProblem("a maintainer has a name before the address", 0, len(text))
    problem = check_text(name, "the name of a maintainer")
    if problem is not None:
        start = text.index(name)
        return None, problem._replace(offset=problem.offset + start)
    return Maintainer(name, mail.strip()), None


def check_text(text: str, what: str) -> NameProblem | None:
    """Return what is wrong with a text that XML, CMake and Python files are to hold in a line."""
    if not text.strip():
        return NameProblem(f"{what} is empty", 0, len(text))
    for at, char in enumerate(text):
        if not char.isprintable():
            return NameProblem(f"{what} has no {_shown(char)}", at, 1)
    return None


def check_file_name(name: str, what: str) -> NameProblem | None:
    """Return what is wrong with the name of a file of a package, or of an executable."""
    if not name:
        return NameProblem(f"{what} needs a name", 0, 0)
    bad = _first_run(name, _FILE)
    if bad is not None:
        message = f"the name of {what} has no {_shown(name[bad[0]])}"
        return NameProblem(message, bad[0], bad[1] - bad[0])
    if name[0] in ".-":
        return NameProblem(f"the name of {what} starts with a letter", 0, 1)
    if len(name) > LONGEST_FILE_NAME:
        message = f"the name of {what} has at most {LONGEST_FILE_NAME} characters"
        return NameProblem(message, LONGEST_FILE_NAME, len(name) - LONGEST_FILE_NAME)
    return None


def _first_run(text: str, allowed: frozenset[str]) -> tuple[int, int] | None:
    """Return the first run of characters that are not allowed, all capital or none of them."""
    start = next((at for at, char in enumerate(text) if char not in allowed), None)
    if start is None:
        return None
    end = start + 1
    while (
        end < len(text)
        and text[end] not in allowed
        and text[end].isupper() == text[start].isupper()
    ):
        end += 1
    return start, end


def _shown(char: str) -> str:
    if char.isspace():
        return "white space"
    return f"`{char}`" if char.isprintable() else f"character U+{ord(char):04X}"
