r"""Build the interface catalog, `plastron_tui/ros/catalog/<distribution>/*.yaml`.

    python scripts/build_catalog.py [DISTRIBUTION ...]

Without a name it builds every distribution. The script needs the development dependencies, `pip`
with a package index, and for noetic Debian's ROS 1 definitions:

    apt-get install --no-install-recommends libactionlib-dev ros-actionlib-msgs \
        ros-diagnostic-msgs ros-geometry-msgs ros-nav-msgs ros-rosgraph-msgs ros-sensor-msgs \
        ros-shape-msgs ros-std-msgs ros-std-srvs ros-stereo-msgs ros-tf2-msgs \
        ros-trajectory-msgs ros-visualization-msgs

What comes from where:

- noetic: the `.msg`, `.srv` and `.action` files of those Debian packages.
- jazzy, kilted: the files in the share folder of the wheels `ros-<package>` of the versions
  below; `tf2_msgs`, of which there is no wheel, from the message store of `rosbags`.
- humble, lyrical: there are no wheels. The messages are those of the `rosbags` store, with the
  comments and default values of the nearest distribution that has wheels (Jazzy, Kilted) where
  the fields are the same, and those in `NEWER_THAN_STORE`; the services are those of that
  distribution, but for the ones in `NEWER_THAN_HUMBLE`.
- the services and actions that the language knows by name and that no source above has:
  `EXAMPLES`, below.

A definition is stored as ROS writes it, stripped to its fields, its constants, and the first
sentence of each comment, so that the catalog is read by the parser for users' own files.
"""

from __future__ import annotations

import subprocess
import sys
import tempfile
import textwrap
import zipfile
from collections.abc import Iterable, Sequence
from pathlib import Path

from rosbags.interfaces import Nodetype
from rosbags.typesys import Stores, get_typestore

from plastron_tui.ros.definition import parse_definition
from plastron_tui.ros.definition_text import format_definition
from plastron_tui.ros.interfaces import (
    Constant,
    Field,
    FieldType,
    Interface,
    InterfaceKind,
    InterfaceName,
    Section,
)

CATALOG = Path(__file__).parent.parent / "plastron_tui/ros/catalog"
DEBIAN_SHARE = Path("/usr/share")

COMMON = [
    "actionlib_msgs",
    "diagnostic_msgs",
    "geometry_msgs",
    "nav_msgs",
    "sensor_msgs",
    "shape_msgs",
    "std_msgs",
    "std_srvs",
    "stereo_msgs",
    "trajectory_msgs",
    "visualization_msgs",
]
ROS1_PACKAGES = [*COMMON, "actionlib", "rosgraph_msgs", "tf2_msgs"]
DEBIAN_NAMES = {"actionlib": "libactionlib-dev"}
CORE = ["action_msgs", "builtin_interfaces", "lifecycle_msgs", "rcl_interfaces", "rosgraph_msgs"]
ROS2_PACKAGES = [*COMMON, *CORE, "service_msgs", "tf2_msgs", "unique_identifier_msgs"]

# The versions that each distribution released: common_interfaces, rcl_interfaces, and
# unique_identifier_msgs, which has a repository of its own.
VERSIONS = {"jazzy": ("5.3.6", "2.0.3", "2.5.0"), "kilted": ("5.5.1", "2.3.0", "2.7.0")}

# What stands for the fields of an empty message where a struct must not be empty.
FILLER = "structure_needs_at_least_one_member"

# Where comments, default values and services come from for a distribution without wheels. The
# changelogs of common_interfaces 5.9.3 and rcl_interfaces 2.4.5, of which Lyrical was made, name
# no service that changed since Kilted's 5.5.1 and 2.3.0.
NEIGHBOURS = {"humble": "jazzy", "lyrical": "kilted"}

NEWER_THAN_HUMBLE = {"GetLoggerLevels", "SetLoggerLevels"}

# Messages that a distribution got after its `rosbags` store was made: the release, the text.
NEWER_THAN_STORE = {
    "lyrical": {
        "geometry_msgs/VelocityWithCovarianceStamped": (
            "common_interfaces 5.9.3",
            "std_msgs/Header header\nstring body_frame_id\nstring reference_frame_id\n"
            "TwistWithCovariance velocity\n",
        ),
    },
}

ADD_TWO_INTS = "int64 a\nint64 b\n---\nint64 sum\n"
FIBONACCI = "int32 order\n---\nint32[] sequence\n---\nint32[] sequence\n"
SHARED_EXAMPLES = {
    "mavros_msgs/WaypointClear": "---\nbool success\n",
    "mavros_msgs/WaypointPull": "---\nbool success\nuint32 wp_received\n",
    "basics/WordCount": "string words\n---\nuint32 count\n",
}
EXAMPLES = {
    1: {
        InterfaceKind.SERVICE: {"beginner_tutorials/AddTwoInts": ADD_TWO_INTS, **SHARED_EXAMPLES},
        InterfaceKind.ACTION: {"actionlib_tutorials/Fibonacci": FIBONACCI},
    },
    2: {
        InterfaceKind.SERVICE: {"example_interfaces/AddTwoInts": ADD_TWO_INTS, **SHARED_EXAMPLES},
        InterfaceKind.ACTION: {"example_interfaces/Fibonacci": FIBONACCI},
    },
}

Found = dict[tuple[InterfaceKind, InterfaceName], tuple[Interface, str]]
"""Interfaces by kind and name, each with the words that say where it comes from."""


def main() -> None:
    """Build the distributions of the command line, or all."""
    wanted = sys.argv[1:] or ["noetic", *VERSIONS, *NEIGHBOURS]
    if "noetic" in wanted:
        write("noetic", 1, examples(1) | read_share(DEBIAN_SHARE, ROS1_PACKAGES, 1, debian_source))
    needed = [name for name in VERSIONS if name in {NEIGHBOURS.get(each, each) for each in wanted}]
    with tempfile.TemporaryDirectory() as folder:
        wheels = {name: download(name, Path(folder)) for name in needed}
    for distribution in wanted:
        if distribution in NEIGHBOURS:
            neighbour = wheels[NEIGHBOURS[distribution]]
            write(distribution, 2, examples(2) | without_wheels(distribution, neighbour))
        elif distribution in VERSIONS:
            write(distribution, 2, examples(2) | wheels[distribution])


def examples(ros_version: int) -> Found:
    """Return the services and actions that are written down in this script."""
    found: Found = {}
    for kind, texts in EXAMPLES[ros_version].items():
        for full_name, text in texts.items():
            name = InterfaceName(*full_name.split("/"))
            interface = parsed(text, name, kind, ros_version)
            found[kind, name] = (interface, "the package's public definition")
    return found


def parsed(text: str, name: InterfaceName, kind: InterfaceKind, ros_version: int) -> Interface:
    """Read a definition that has no mistake."""
    definition = parse_definition(text, name, kind, ros_version)
    if definition.interface is None:
        sys.exit(f"{name}: {definition.diagnostics}")
    return definition.interface


def debian_source(package: str) -> str:
    """Say which Debian package a ROS 1 package's definitions are from."""
    debian = DEBIAN_NAMES.get(package, "ros-" + package.replace("_", "-"))
    command = ["dpkg-query", "--show", "--showformat=${Version}", debian]
    version = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    return f"Debian {debian} {version}"


def read_share(share: Path, packages: Iterable[str], ros_version: int, source: object) -> Found:
    """Read the definitions of packages that are laid out as `share/<package>/msg/*.msg`."""
    found: Found = {}
    for package in packages:
        origin = source(package) if callable(source) else str(source)
        for kind in InterfaceKind:
            for file in sorted((share / package / kind.value).glob(f"*.{kind.value}")):
                name = InterfaceName(package, file.stem)
                interface = parsed(file.read_text("utf-8"), name, kind, ros_version)
                found[kind, name] = (interface, origin)
    return found


def download(distribution: str, folder: Path) -> Found:
    """Download a distribution's wheels and read their definitions, and those without a wheel."""
    common, core, unique = VERSIONS[distribution]
    versions = dict.fromkeys(COMMON, common) | dict.fromkeys([*CORE, "service_msgs"], core)
    versions["unique_identifier_msgs"] = unique
    target = folder / distribution
    requirements = [
        f"ros-{name.replace('_', '-')}=={version}" for name, version in versions.items()
    ]
    pip = [sys.executable, "-m", "pip", "download", "--quiet", "--no-deps", "--dest", str(target)]
    subprocess.run([*pip, *requirements], check=True)
    found: Found = {}
    for package, version in versions.items():
        (wheel,) = target.glob(f"ros_{package}-{version}-*.whl")
        with zipfile.ZipFile(wheel) as archive:
            archive.extractall(target)
        share = target / f"ros_{package}-{version}.data/data/share"
        origin = f"wheel ros-{package.replace('_', '-')} {version}"
        found |= read_share(share, [package], 2, origin)
    store = read_store(distribution)
    return found | {key: value for key, value in store.items() if key[1].package == "tf2_msgs"}


def without_wheels(distribution: str, neighbour: Found) -> Found:
    """Put a distribution together from its message store and another one's definitions."""
    found: Found = {}
    for key, (interface, origin) in read_store(distribution).items():
        other = neighbour.get(key)
        if other is not None and bare(other[0]) == bare(interface):
            found[key] = (other[0], f"{origin}; comments and defaults of {other[1]}")
        else:
            found[key] = (interface, origin)
    for full_name, (release, text) in NEWER_THAN_STORE.get(distribution, {}).items():
        name = InterfaceName(*full_name.split("/"))
        interface = parsed(text, name, InterfaceKind.MESSAGE, 2)
        found[InterfaceKind.MESSAGE, name] = (interface, f"the public definition in {release}")
    unknown = NEWER_THAN_HUMBLE if distribution == "humble" else set()
    for (kind, name), (interface, origin) in neighbour.items():
        is_service = kind is InterfaceKind.SERVICE and name.name not in unknown
        if is_service and name.package in ROS2_PACKAGES:
            found[kind, name] = (interface, f"services as in {origin}")
    return found


def bare(interface: Interface) -> object:
    """Return what an interface is on the wire: no comments, no defaults."""
    return [
        ([(field.name, field.type) for field in section.fields], set(section.constants))
        for section in interface.sections
    ]


def read_store(distribution: str) -> Found:
    """Read the messages of a distribution's `rosbags` store."""
    store = get_typestore(Stores(f"ros2_{distribution}"))
    found: Found = {}
    for full_name, (constants, fields) in store.fielddefs.items():
        package, _, short = full_name.split("/")
        if package not in ROS2_PACKAGES:
            continue
        section = Section(
            tuple(
                Field(name, field_type(description))
                for name, description in fields
                if name != FILLER
            ),
            tuple(Constant(name, kind, value) for name, kind, value in constants),
        )
        name = InterfaceName(package, short)
        interface = Interface(name, InterfaceKind.MESSAGE, (section,))
        found[InterfaceKind.MESSAGE, name] = (interface, f"rosbags store ros2_{distribution}")
    return found


def field_type(description: object) -> FieldType:
    """Turn a type as `rosbags` describes it into ours."""
    assert isinstance(description, tuple)
    node, value = description
    if node is Nodetype.BASE:
        name, bound = value
        # The store has IDL's names, where the definitions have their own.
        return FieldType({"octet": "byte"}.get(name, name), string_bound=bound or None)
    if node is Nodetype.NAME:
        package, _, name = value.split("/")
        return FieldType(name, package)
    element, size = value
    inner = field_type(element)._replace(is_array=True)
    if node is Nodetype.ARRAY:
        return inner._replace(length=size)
    return inner._replace(bound=size or None)


def write(distribution: str, ros_version: int, found: Found) -> None:
    """Write a file a package, and the index."""
    folder = CATALOG / distribution
    folder.mkdir(exist_ok=True)
    for old in folder.glob("*.yaml"):
        old.unlink()
    packages = sorted({name.package for _, name in found})
    for package in packages:
        ours = {key: value for key, value in found.items() if key[1].package == package}
        (folder / f"{package}.yaml").write_text(package_text(package, ros_version, ours), "utf-8")
    (folder / "index.yaml").write_text(index_text(found), "utf-8")
    print(f"{distribution}: {len(found)} interfaces in {len(packages)} packages")


def package_text(package: str, ros_version: int, found: Found) -> str:
    """Return the YAML of a package: the kinds, the names, the definitions."""
    origins = sorted({origin for _, origin in found.values()})
    lines = [f"# {package}, built by scripts/build_catalog.py from:"]
    lines += [f"# - {origin}" for origin in origins]
    for kind in InterfaceKind:
        names = sorted(name for other, name in found if other is kind)
        if names:
            lines.append(f"{kind.value}:")
        for name in names:
            text = format_definition(found[kind, name][0], ros_version)
            lines.append(f"  {name.name}: |" if text.strip() else f"  {name.name}: ''")
            lines += [f"    {line}" for line in text.split("\n") if line]
    return "\n".join(lines) + "\n"


def index_text(found: Found) -> str:
    """Return the YAML of the index: the names of each package, and which are not whole."""
    lines = ["# The names in each package, for those that are written bare."]
    tables = (table for kinds in EXAMPLES.values() for table in kinds.values())
    listed = {full_name.split("/")[0] for table in tables for full_name in table}
    partial = sorted(listed & {name.package for _, name in found})
    lines.append(f"partial: {' '.join(partial)}")
    for kind in InterfaceKind:
        keys = [name for other, name in found if other is kind]
        lines.append(f"{kind.value}:" if keys else f"{kind.value}: {{}}")
        for package in sorted({name.package for name in keys}):
            names = sorted(name.name for name in keys if name.package == package)
            lines.append(f"  {package}:")
            lines += wrapped(names)
    return "\n".join(lines) + "\n"


def wrapped(names: Sequence[str]) -> list[str]:
    """Return a plain scalar of words over several lines."""
    return textwrap.wrap(" ".join(names), 96, initial_indent="    ", subsequent_indent="    ")


if __name__ == "__main__":
    main()
