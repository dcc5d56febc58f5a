"""Which other packages the code of a package needs."""

from __future__ import annotations

import re
import sys
from collections import defaultdict, deque
from collections.abc import Iterable, Iterator
from typing import NamedTuple

from tree_sitter import Node

from plastron_tui.diagnostics import Span
from plastron_tui.model.package_facts import Declared, Place, Used
from plastron_tui.ros.launch_names import launch_language
from plastron_tui.ros.name_slips import LONGEST, is_slip, shortened
from plastron_tui.sources.setup_py.syntax import parse_python

from .cmake_lists import Lists
from .definitions import fields_of
from .entry_points import PythonSetup
from .texts import CPP, PYTHON, SCRIPT_FOLDERS, PackageTexts, is_test

_IMPORT = re.compile(rb"^[ \t]*(?:from[ \t]+([A-Za-z_]\w*)|import[ \t]+([^\n#;]+))", re.M)
_INCLUDE = re.compile(rb"^[ \t]*#[ \t]*include[ \t]*[<\"]([A-Za-z_][\w./+-]*)[>\"]", re.M)
_QUOTED = re.compile(rb"^[ \t]*#[ \t]*include[ \t]*\"([\w./+-]+)\"", re.M)
_DIRECTIVE = re.compile(rb"^[ \t]*#[ \t]*(ifndef|ifdef|if|endif)\b", re.M)
_NO_CODE = re.compile(
    rb"//[^\n]*|/\*.*?(?:\*/|\Z)|R\"(\w*)\(.*?\)\1\"|\"(?:[^\"\\\n]|\\.)*\"", re.S
)
_CODE = re.compile(rb"^[^/*\n]*[;{#]", re.M)
_FIELD = re.compile(rb"^[ \t]*([A-Za-z]\w*)/\w", re.M)
_HEADER = re.compile(rb"^[ \t]*Header[ \t]", re.M)
_WORD = rb"(?<![\w])(?:%b)(?![\w])"
_NODE = re.compile(rb"<node\b[^>]*")
_XML_COMMENT = re.compile(rb"<!--.*?(?:-->|\Z)", re.S)


class _Named(NamedTuple):
    """A place that names a module, a header or a type of another package; see `Used`."""

    what: str
    package: str
    place: Place
    is_idle: bool = False


def mentioned(texts: PackageTexts, names: Iterable[str]) -> frozenset[str]:
    """Return the names that occur as words of a file, besides those that build the package."""
    wanted = {name: re.compile(_WORD % re.escape(name.encode())) for name in names}
    found: set[str] = set()
    for file, text in texts.others():
        # Most names are found in the first files, and looking for bytes takes next to no time.
        for name in [name for name in wanted if name.encode() in text]:
            if wanted[name].search(text):
                found.add(name)
                del wanted[name]
        is_action = file.endswith(".action") and texts.source.ros_version == 1
        if is_action or (file.endswith((".msg", ".srv", ".action")) and _HEADER.search(text)):
            # What ROS 1 makes of an action has a header.
            found.add("std_msgs")
    return frozenset(found)


def near_names(texts: PackageTexts, names: Iterable[str]) -> frozenset[str]:
    """Return what code or definitions name where a package stands, one slip from one of some.

    The package's own folders and modules are left out.
    """
    wanted = [name for name in names if len(name) <= LONGEST]
    keys = {key for name in wanted for key in shortened(name)}
    known = {*wanted, texts.source.name, *_folders(texts), *header_folders(texts.names)}
    found: set[str] = set()
    for file, text in texts.others():
        if file.endswith((".msg", ".srv", ".action")):
            found.update(each.decode() for each in _FIELD.findall(text))
        elif file.endswith(CPP):
            found.update(each.partition(b"/")[0].decode() for each in _INCLUDE.findall(text))
        elif file.endswith(PYTHON) or "." not in file.rpartition("/")[2]:
            found.update(each.decode("utf-8", "replace") for each in _first_names(text))
    return frozenset(
        each
        for each in found - known
        if len(each) <= LONGEST
        and not keys.isdisjoint(shortened(each))
        and any(is_slip(each, name) for name in wanted)
    )


def find_uses(
    texts: PackageTexts, dependencies: Iterable[Declared], lists: Lists, setup: PythonSetup
) -> Iterator[Used]:
    """Yield what code needs of other packages and is not declared for that, each once.

    Only code that is surely run or built counts: modules and scripts that are installed, sources of
    targets, headers that are handed on.
    """
    version = texts.source.ros_version
    covered: dict[str, set[str]] = {"build": set(), "exec": set()}
    for each in dependencies:
        if version in each.versions:
            for need in covered:
                if need in each.covers:
                    covered[need].add(each.name)
    own = {texts.source.name, *_folders(texts)}
    modules: dict[str, list[_Named]] = defaultdict(list)
    for name in texts.python:
        if _is_run(texts, name, lists, setup):
            text = texts.get(name) or b""
            skipped = own | covered["exec"] | set(sys.stdlib_module_names)
            for module, span, is_idle in _imports(text, skipped):
                modules[module].append(_Named(module, "", Place(name, span), is_idle))
    headers: dict[str, list[_Named]] = defaultdict(list)
    for name in _built(texts, lists):
        for header, span in _includes(texts.get(name) or b"", covered["build"] | own):
            if not _has_header(texts, header):
                folder = header.partition("/")[0]
                headers[folder].append(_Named(header, "", Place(name, span)))
    for folder, found in headers.items():
        if _is_idle(texts, folder, found):
            headers[folder] = [each._replace(is_idle=True) for each in found]
    for file, field in fields_of(texts, lists):
        if field.package not in covered["build"] | {texts.source.name}:
            place = Place(file, field.span)
            headers[field.package].append(_Named(field.package, field.package, place))
    for need, names in (("exec", modules), ("build", headers)):
        for found in names.values():
            others = {each.place.file: each.place for each in reversed(found[1:])}
            others.pop(found[0].place.file, None)
            is_idle = all(each.is_idle for each in found)
            what, package, place, _ = found[0]
            yield Used(what, package, need, place, tuple(reversed(others.values())), is_idle)


def _is_idle(texts: PackageTexts, folder: str, found: Iterable[_Named]) -> bool:
    """Tell whether no code has the name of a folder of headers, but to include them."""
    if any(each.place.file.startswith("include/") for each in found):
        # Whoever includes that one may use them.
        return False
    word = folder.encode()
    return not any(
        word in _INCLUDE.sub(b"", text)
        for each in texts.names
        if each.endswith(CPP) and word in (text := texts.get(each) or b"")
    )


def header_folders(names: Iterable[str]) -> Iterator[str]:
    """Yield the folders below `include` that headers of a package are included from."""
    for name in names:
        _, sign, inner = f"/{name}".rpartition("/include/")
        if sign and "/" in inner:
            yield inner.partition("/")[0]


def _has_header(texts: PackageTexts, header: str) -> bool:
    """Tell whether a header is the package's own, whatever its folder is called."""
    return any(f"/{each}".endswith(f"/{header}") for each in texts.names)


def _folders(texts: PackageTexts) -> set[str]:
    """Return the folders and modules that Python may mean before those of other packages."""
    found = {part for each in texts.python for part in each.split("/")[:-1]}
    return found | {each.rpartition("/")[2].removesuffix(".py") for each in texts.python}


def _is_run(texts: PackageTexts, name: str, lists: Lists, setup: PythonSetup) -> bool:
    """Tell whether a file of Python is surely run where the package is used."""
    if is_test(name) or launch_language(name):
        return False
    if name in lists.programs or (setup.has_module(name) and "/" in name):
        return True
    is_script = name.split("/")[0] in SCRIPT_FOLDERS
    if texts.source.ros_version != 1 or not is_script:
        return False
    return name in texts.programs or _is_launched(texts, name)


def _is_launched(texts: PackageTexts, name: str) -> bool:
    """Tell whether a launch file of the package starts a script, whatever its mode is."""
    base = name.rpartition("/")[2]
    if any(each != name and f"/{each}".endswith(f"/{base}") for each in texts.names):
        return False
    package, type_ = f'pkg="{texts.source.name}"'.encode(), f'type="{base}"'.encode()
    return any(
        package in node and type_ in node
        for each in texts.names
        if launch_language(each) and type_ in (text := texts.get(each) or b"")
        for node in _NODE.findall(_XML_COMMENT.sub(b"", text))
    )


def _built(texts: PackageTexts, lists: Lists) -> Iterator[str]:
    """Yield the files of C++ that are surely built, or handed on, with the headers beside them."""
    names = texts.source.names
    handed_on = (x for x in texts.names if x.startswith("include/") and lists.hands_headers_on)
    waiting = deque(each for each in (*lists.built, *handed_on) if each.endswith(CPP))
    seen: set[str] = set()
    while waiting:
        name = waiting.popleft()
        if name in seen or name not in names or is_test(name):
            continue
        seen.add(name)
        yield name
        folder = name.rpartition("/")[0]
        for match in _QUOTED.finditer(texts.get(name) or b""):
            said = match[1].decode("utf-8", "replace")
            waiting += [f"{folder}/{said}".lstrip("/"), f"src/{said}"]
        if not lists.hands_headers_on:
            included = _INCLUDE.finditer(texts.get(name) or b"")
            waiting += ["include/" + x[1].decode("utf-8", "replace") for x in included]


def _imports(text: bytes, skipped: set[str]) -> Iterator[tuple[str, Span, bool]]:
    """Yield the modules that a text imports whatever happens, without those of some packages.

    With each comes its place, and whether nothing else in the text has what is imported of it.
    """
    if all(each.decode("utf-8", "replace") in skipped for each in _first_names(text)):
        return
    root = parse_python(text)
    if root.has_error:
        return
    waiting = [root]
    while waiting:
        node = waiting.pop()
        if node.type in ("import_statement", "import_from_statement"):
            yield from (
                (name, span, _is_unused(text, node))
                for name, span in _modules(node)
                if name.partition(".")[0] not in skipped
            )
        elif node.type not in ("try_statement", "if_statement"):
            waiting.extend(
                each for each in reversed(node.named_children) if each.type not in ("string",)
            )


def _first_names(text: bytes) -> Iterator[bytes]:
    """Yield the first names of the modules that lines seem to import, which takes no time."""
    for above, given in _IMPORT.findall(text):
        for each in [above] if above else given.split(b","):
            yield each.strip().partition(b".")[0].partition(b" ")[0]


def _is_unused(text: bytes, node: Node) -> bool:
    """Tell whether nothing outside of an import has one of the names that it makes."""
    rest = text[: node.start_byte] + text[node.end_byte :]
    made = [
        each.child_by_field_name("alias") or each for each in node.children_by_field_name("name")
    ]
    names = [(each.text or b"").partition(b".")[0] for each in made]
    return bool(names) and not any(re.search(_WORD % re.escape(each), rest) for each in names)


def _modules(node: Node) -> Iterator[tuple[str, Span]]:
    is_from = node.type == "import_from_statement"
    for name in node.children_by_field_name("module_name" if is_from else "name"):
        inner = name.child_by_field_name("name") if name.type == "aliased_import" else name
        if inner is not None and inner.type == "dotted_name" and inner.text is not None:
            yield inner.text.decode(), Span(inner.start_byte, inner.end_byte)


def _includes(text: bytes, skipped: set[str]) -> Iterator[tuple[str, Span]]:
    """Yield the headers that a text includes whatever is defined, without those of some folders."""
    found = [
        match
        for match in _INCLUDE.finditer(text)
        if b"/" in match[1] and match[1].partition(b"/")[0].decode() not in skipped
    ]
    if not found:
        return
    no_code = list(_no_code(text))
    branches = _branches(text)
    for match in found:
        at = match.start(1)
        if any(start <= at < end for start, end in (*no_code, *branches)):
            continue
        yield match[1].decode(), Span(at, match.end(1))


def _no_code(text: bytes) -> Iterator[tuple[int, int]]:
    """Yield the comments and the texts that may have several lines."""
    for found in _NO_CODE.finditer(text):
        if not found[0].startswith(b'"'):
            yield found.span()


def _branches(text: bytes) -> list[tuple[int, int]]:
    """Return the parts of a text that hang on what is defined, but for a guard of the whole."""
    found: list[tuple[int, int]] = []
    opened: list[tuple[int, bool]] = []
    for at, match in enumerate(_DIRECTIVE.finditer(text)):
        if match[1] != b"endif":
            opened.append((match.start(), at == 0 and match[1] == b"ifndef"))
        elif opened:
            start, is_first = opened.pop()
            behind = text[match.end() :].partition(b"\n")[2]
            if not is_first or _CODE.search(behind):
                found.append((start, match.end()))
    return found
