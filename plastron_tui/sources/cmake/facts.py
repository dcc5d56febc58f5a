"""What a package's CMakeLists.txt says that matters to its nodes.

The commands are those of the catkin documentation (catkin_package, installing), of the ament_cmake
user documentation, and of rosidl's CMake functions.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from fnmatch import fnmatch
from typing import NamedTuple

from plastron_tui.sources.build_files import matches

from .reader import Call, CMakeLists, in_package
from .variables import Item

CATKIN, AMENT = "catkin", "ament"
FIND_WORDS = frozenset(
    {
        "COMPONENTS",
        "OPTIONAL_COMPONENTS",
        "REQUIRED",
        "QUIET",
        "EXACT",
        "MODULE",
        "CONFIG",
        "NO_MODULE",
    }
)
INSTALL_WORDS = frozenset(
    {
        "TARGETS",
        "PROGRAMS",
        "FILES",
        "DIRECTORY",
        "EXPORT",
        "DESTINATION",
        "PERMISSIONS",
        "FILE_PERMISSIONS",
        "DIRECTORY_PERMISSIONS",
        "USE_SOURCE_PERMISSIONS",
        "CONFIGURATIONS",
        "COMPONENT",
        "RENAME",
        "OPTIONAL",
        "ARCHIVE",
        "LIBRARY",
        "RUNTIME",
        "INCLUDES",
        "FILES_MATCHING",
        "PATTERN",
        "REGEX",
        "EXCLUDE",
        "EXCLUDE_FROM_ALL",
        "MESSAGE_NEVER",
        "TYPE",
    }
)
INTERFACE_WORDS = frozenset(
    {"DEPENDENCIES", "LIBRARY_NAME", "SKIP_INSTALL", "SKIP_GROUP_MEMBERSHIP_CHECK"}
    | {"ADD_LINTER_TESTS"}
)
MESSAGE_WORDS = frozenset({"FILES", "DIRECTORY", "NOINSTALL", "BASE_DIR"})
_COMPONENT_WORDS = frozenset({"PLUGIN", "EXECUTABLE", "EXECUTOR", "RESOURCE_INDEX"})
_TARGET_WORDS = frozenset(
    {"EXCLUDE_FROM_ALL", "INTERFACE", "MACOSX_BUNDLE", "MODULE", "OBJECT", "SHARED", "STATIC"}
    | {"WIN32"}
)
CATKIN_INTERFACES = {"msg": "add_message_files", "srv": "add_service_files"}
CATKIN_INTERFACES["action"] = "add_action_files"
PROGRAM_CALLS = ("install", "catkin_install_python")

_DESTINATIONS = {
    "${CATKIN_PACKAGE_BIN_DESTINATION}": "lib/{}",
    "${CATKIN_PACKAGE_SHARE_DESTINATION}": "share/{}",
    "${CATKIN_PACKAGE_LIB_DESTINATION}": "lib",
    "${CATKIN_GLOBAL_SHARE_DESTINATION}": "share",
    "${CATKIN_GLOBAL_LIBEXEC_DESTINATION}": "lib",
    "${CATKIN_GLOBAL_BIN_DESTINATION}": "bin",
    "${CMAKE_INSTALL_LIBDIR}": "lib",
    "${CMAKE_INSTALL_DATADIR}": "share",
    "${CMAKE_INSTALL_BINDIR}": "bin",
}


class Entry(NamedTuple):
    """A thing that a call names.

    Attributes:
        what: the thing: a package, a file, a folder.
        item: the value that says it.
        call: the call.
        destination: where it is installed, from the install prefix; "" for what is not.
    """

    what: str
    item: Item
    call: Call
    destination: str = ""

    def has(self, file: str) -> bool:
        """Tell whether it is a file, or a pattern that has it."""
        return matches(file, self.what) if self.item.is_pattern else self.what == file

    @property
    def is_plain(self) -> bool:
        """Whether it holds whatever is true when the package is built."""
        return not self.call.conditions


def build_type(lists: CMakeLists) -> str | None:
    """Return whether the package is built by catkin or ament_cmake; None where nothing says."""
    for call in lists.named("find_package"):
        name = call.items[0].value if call.items else ""
        if name == "catkin" or name.startswith("catkin_simple"):
            return CATKIN
        if name.startswith("ament_cmake"):
            return AMENT
    return AMENT if lists.named("ament_package", "ament_auto_package") else None


def dependencies(lists: CMakeLists) -> Iterator[Entry]:
    """Return the packages that are found, catkin's components among them."""
    for call in lists.named("find_package"):
        if not call.items:
            continue
        yield Entry(call.items[0].value, call.items[0], call)
        if call.items[0].value == "catkin":
            yield from components(call)


def components(call: Call) -> Iterator[Entry]:
    """Return the components that catkin is asked for.

    They may follow `REQUIRED` without a word of their own ("find_package" of CMake's manual).
    """
    for word in ("REQUIRED", "COMPONENTS"):
        for item in call.section(word, FIND_WORDS):
            yield Entry(item.value, item, call)


def destination_of(lists: CMakeLists, call: Call) -> str:
    """Return where a call of `install` puts what it names, from the install prefix."""
    given = call.section("DESTINATION", INSTALL_WORDS)
    path = given[0].value if given else ""
    path = path.removeprefix("${CMAKE_INSTALL_PREFIX}/").rstrip("/")
    for variable, folder in _DESTINATIONS.items():
        if (path + "/").startswith(variable + "/"):
            path = folder.format(lists.name) + path[len(variable) :]
    return path


def words_of(call: Call) -> frozenset[str]:
    """Return the keywords that a call of `install` has."""
    said = {each.value for each in call.items if not each.argument.is_quoted}
    return INSTALL_WORDS & said


def installs_always(call: Call) -> bool:
    """Whether a call installs what it names however a package is built (`install` of CMake)."""
    return not call.conditions and not words_of(call) & {"CONFIGURATIONS", "EXCLUDE_FROM_ALL"}


def programs(lists: CMakeLists) -> Iterator[Entry]:
    """Return the scripts that are installed, and where."""
    for call in lists.named(*PROGRAM_CALLS):
        for item in call.section("PROGRAMS", INSTALL_WORDS):
            yield Entry(in_package(item.value), item, call, destination_of(lists, call))


def shared(lists: CMakeLists) -> Iterator[Entry]:
    """Return the files and folders that are installed, and where; `x/` is what is in a folder."""
    for call in lists.named("install"):
        for kind in ("FILES", "DIRECTORY"):
            for item in call.section(kind, INSTALL_WORDS):
                yield Entry(in_package(item.value), item, call, destination_of(lists, call))
    for call in lists.named("ament_auto_package"):
        for item in call.section("INSTALL_TO_SHARE", {"INSTALL_TO_SHARE", "INSTALL_TO_PATH"}):
            yield Entry(in_package(item.value), item, call, f"share/{lists.name}")


def covers(entry: Entry, file: str, destination: str) -> bool:
    """Whether what is installed has a file, so that it lies in the folder of the destination."""
    folder, _, name = file.rpartition("/")
    where = f"{entry.destination}/{entry.what.rpartition('/')[2]}".rstrip("/")
    if entry.item.is_pattern:
        return entry.destination == destination and matches(file, entry.what)
    if entry.what == file:
        return entry.destination == destination
    inner = entry.what.rstrip("/")
    is_within = (file + "/").startswith(inner + "/") or inner in (".", "")
    if not is_within or (entry.call.command.name == "install" and _leaves_out(entry.call, name)):
        return False
    below = folder[len(inner) :] if inner != "." else "/" + folder
    where = where if not entry.what.endswith("/") else entry.destination
    return (where + below).rstrip("/") == destination


def _leaves_out(call: Call, name: str) -> bool:
    """Whether patterns of `install(DIRECTORY …)` leave a file out."""
    values = [each.value for each in call.items]
    if "REGEX" in values:
        return True
    is_out = "FILES_MATCHING" in values
    for at, word in enumerate(values):
        if word == "PATTERN" and at + 1 < len(values) and fnmatch(name, values[at + 1]):
            return at + 2 < len(values) and values[at + 2] == "EXCLUDE"
    return is_out


def interfaces(lists: CMakeLists) -> Iterator[Entry]:
    """Return the definition files that types are made of, by paths from the package's folder."""
    for call in lists.named("rosidl_generate_interfaces"):
        for item in call.section("", INTERFACE_WORDS)[1:]:
            yield Entry(in_package(item.value), item, call)
    for folder, name in CATKIN_INTERFACES.items():
        for call in lists.named(name):
            given = call.section("DIRECTORY", MESSAGE_WORDS)
            inside = given[0].value if given else folder
            for item in call.section("FILES", MESSAGE_WORDS):
                yield Entry(f"{inside}/{item.value}", item, call)


def interface_dependencies(lists: CMakeLists) -> Iterator[Entry]:
    """Return the packages whose types the package's own are made of."""
    for call in lists.named("rosidl_generate_interfaces", "generate_messages"):
        for item in call.section("DEPENDENCIES", INTERFACE_WORDS):
            yield Entry(item.value, item, call)


def exported(lists: CMakeLists) -> Iterator[Entry]:
    """Return the packages that whoever uses this one needs, as `catkin_package` says."""
    words = {"INCLUDE_DIRS", "LIBRARIES", "CATKIN_DEPENDS", "DEPENDS", "CFG_EXTRAS"}
    for call in lists.named("catkin_package"):
        for item in call.section("CATKIN_DEPENDS", words | {"EXPORTED_TARGETS"}):
            yield Entry(item.value, item, call)


def targets(lists: CMakeLists) -> Iterator[Entry]:
    """Return the executables and libraries that are built."""
    for call in lists.named("add_executable", "add_library", "ament_auto_add_executable"):
        if call.items:
            yield Entry(call.items[0].value, call.items[0], call)


def sources_of(target: Entry) -> list[str]:
    """Return the sources of a target, by their paths from the package's folder."""
    return [in_package(x.value) for x in target.call.items[1:] if x.value not in _TARGET_WORDS]


def executable_of(lists: CMakeLists, target: Entry) -> str:
    """Return the name of the program that a target is, which a property may give it."""
    for call in lists.named("set_target_properties"):
        values = [each.value for each in call.items]
        if target.what in values and "OUTPUT_NAME" in values[:-1]:
            return values[values.index("OUTPUT_NAME") + 1]
    return target.what


def registered_components(lists: CMakeLists) -> Iterator[Entry]:
    """Return the programs that are made of components (documentation of rclcpp_components)."""
    for call in lists.named("rclcpp_components_register_node"):
        for item in call.section("EXECUTABLE", _COMPONENT_WORDS):
            yield Entry(item.value, item, call)


def component_class(component: Entry) -> str:
    """Return the class of a component, "" where the call has none."""
    return next((x.value for x in component.call.section("PLUGIN", _COMPONENT_WORDS)), "")


def component_sources(lists: CMakeLists, component: Entry) -> list[str]:
    """Return the sources of the library that a component is in."""
    library = component.call.items[0].value
    found = (sources_of(each) for each in targets(lists) if each.what == library)
    return next(found, [])


TOPICS = {
    "dependency": dependencies,
    "program": programs,
    "shared": shared,
    "interface": interfaces,
    "interface dependency": interface_dependencies,
    "exported": exported,
    "target": targets,
}
"""What is compared before and after a change."""


def facts(lists: CMakeLists) -> Counter[tuple[object, ...]]:
    """Return all that is known of a package, to compare it with what it is after a change."""
    found: Counter[tuple[object, ...]] = Counter()
    for topic, read in TOPICS.items():
        for each in read(lists):
            found[topic, each.what, each.destination, each.call.conditions] += 1
    return found
