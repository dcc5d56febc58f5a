"""The console scripts of a package, and the Python packages that it installs."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from contextlib import suppress
from dataclasses import dataclass

from tree_sitter import Node

from plastron_tui.diagnostics import Span
from plastron_tui.diagnostics.suggest import nearest
from plastron_tui.model.package_facts import Entry, Place, ScriptFolder
from plastron_tui.ros.name_slips import is_slip
from plastron_tui.sources.build_files import RefusedError
from plastron_tui.sources.packages.reading import PYPROJECT, SETUP_CFG, SETUP_PY
from plastron_tui.sources.setup_py.configuration import check_project, read_scripts
from plastron_tui.sources.setup_py.reader import (
    ConsoleScript,
    SetupFile,
    computed_arguments,
    has_entry_points,
    keyword,
    read_setup,
)
from plastron_tui.sources.setup_py.syntax import parse_python, parse_setup

from .script_folder import script_folder
from .texts import PackageTexts

_LIB = re.compile(rb"['\"]/?lib\b")
_OPENING = frozenset({"exec", "eval", "globals", "setattr", "vars"})
_BLOCKS = frozenset(
    {"if_statement", "try_statement", "with_statement", "for_statement", "while_statement", "block",
     "else_clause", "elif_clause", "except_clause", "finally_clause", "decorated_definition",
     "expression_statement", "match_statement", "case_clause", "parenthesized_expression"}
)  # fmt: skip


@dataclass(frozen=True)
class PythonSetup:
    """What a setup.py installs; of a package without one, nothing.

    Attributes:
        packages: the Python packages, None where they are computed.
        root: the folder that they are in.
        entries: the console scripts.
        place: what has them.
        started: the files that they start.
        scripts: the files that are installed as they are.
        data: the files that are installed beside the code.
        is_settled: whether all of the console scripts are known.
        wrong: the console scripts that lead nowhere.
        script_folder: why nobody finds the console scripts.
    """

    packages: tuple[str, ...] | None = None
    root: str = ""
    entries: tuple[ConsoleScript, ...] = ()
    place: Place | None = None
    started: frozenset[str] = frozenset()
    scripts: frozenset[str] = frozenset()
    data: frozenset[str] = frozenset()
    is_settled: bool = False
    wrong: tuple[Entry, ...] = ()
    script_folder: ScriptFolder | None = None

    @property
    def modules(self) -> frozenset[str]:
        """The names of what is imported of it."""
        return frozenset(each.partition(".")[0] for each in self.packages or ())

    def has_module(self, name: str) -> bool:
        """Tell whether a file is a module that is surely installed."""
        folder = name.rpartition("/")[0]
        inner = folder.removeprefix(f"{self.root}/") if self.root else folder
        return self.packages is not None and inner.replace("/", ".") in self.packages


def read_python_setup(texts: PackageTexts) -> PythonSetup:
    """Return what a package's setup.py installs."""
    source = texts.source
    text = source.texts[SETUP_PY]
    setup, _ = read_setup(text, source.folder / SETUP_PY, source.ros_version)
    if setup is None:
        return PythonSetup()
    packages = setup.packages
    if packages is None and setup.finder is not None:
        packages = tuple(setup.finder.find(source.names))
    entries, file, is_known = _entries(texts, setup)
    root = source.python_root if setup.root is None else setup.root
    reader = _Modules(texts, root, packages, setup.name)
    data = {
        name
        for name in texts.python
        if any(each.covers(name) or not each.is_whole for each in setup.data_files)
    }
    return PythonSetup(
        packages=packages,
        root=root,
        entries=entries,
        place=Place(file, entries[-1].span) if entries else None,
        started=frozenset(
            found
            for each in entries
            if (found := reader.file(each.target.partition(":")[0].strip())) is not None
        ),
        scripts=frozenset(filter(setup.is_script, source.names)),
        data=frozenset(data),
        is_settled=is_known and not _has_more(text, setup),
        wrong=tuple(_wrong(entries, file, reader, texts)),
        script_folder=script_folder(texts) if entries else None,
    )


def _has_more(text: bytes, setup: SetupFile) -> bool:
    """Tell whether a setup.py may install programs that are not known."""
    computed = {name for name, _ in setup.computed}
    is_open = "data_files" in computed or not all(each.is_whole for each in setup.data_files)
    # What is beside the code is not where nodes are looked for, unless something says so.
    return bool(computed & {"entry_points", "scripts"}) or (
        is_open and _LIB.search(text) is not None
    )


def _entries(texts: PackageTexts, setup: SetupFile) -> tuple[tuple[ConsoleScript, ...], str, bool]:
    """Return the console scripts, the file that has them, and whether that is all."""
    source = texts.source
    with suppress(RefusedError):
        called = parse_setup(source.texts[SETUP_PY], source.folder / SETUP_PY)
        if keyword(called, "entry_points") is None and computed_arguments(called) is not None:
            return (), SETUP_PY, False
        if PYPROJECT in source.texts:
            check_project(source.texts[PYPROJECT], source.folder / PYPROJECT)
        path = source.folder / SETUP_PY
        if SETUP_CFG not in source.texts or has_entry_points(source.texts[SETUP_PY], path):
            return setup.console_scripts, SETUP_PY, True
        scripts = read_scripts(source.texts[SETUP_CFG], source.folder / SETUP_CFG)
        if scripts is None:
            return setup.console_scripts, SETUP_PY, True
        return scripts, SETUP_CFG, True
    return (), SETUP_PY, False


@dataclass(frozen=True)
class _Modules:
    """The modules of a package.

    Attributes:
        texts: its files.
        root: the folder that its Python packages are in.
        packages: the Python packages that are installed, None where they are computed.
        name: what its setup.py calls it.
    """

    texts: PackageTexts
    root: str
    packages: tuple[str, ...] | None
    name: str | None

    def path(self, module: str) -> str:
        """Return where a module would be, without an ending."""
        return f"{self.root}/{module.replace('.', '/')}".strip("/")

    def file(self, module: str) -> str | None:
        """Return the file of a module, None where there is none."""
        path = self.path(module)
        found = (f"{path}.py", f"{path}/__init__.py")
        return next((each for each in found if each in self.texts.source.names), None)

    def has_folder(self, package: str) -> bool:
        """Tell whether there is a folder for a package."""
        return any(each.startswith(f"{self.path(package)}/") for each in self.texts.source.names)

    @property
    def roots(self) -> frozenset[str]:
        """The first names of its modules."""
        found = {each.partition(".")[0] for each in self.packages or ()}
        return frozenset({*found, self.texts.source.name, self.name or ""})

    def is_own(self, module: str) -> bool:
        """Tell whether a module is the package's own, whether there or not."""
        first = module.partition(".")[0]
        return first in self.roots or self.has_folder(first)

    def all(self) -> Iterator[str]:
        """Yield the modules that there are."""
        prefix = f"{self.root}/" if self.root else ""
        for each in self.texts.python:
            module = each.removeprefix(prefix).removesuffix(".py").replace("/", ".")
            if (
                each.startswith(prefix)
                and not each.endswith("__init__.py")
                and module.partition(".")[0] in self.roots
            ):
                yield module


def _wrong(
    entries: Iterable[ConsoleScript], file: str, modules: _Modules, texts: PackageTexts
) -> Iterator[Entry]:
    """Yield the console scripts that lead nowhere."""
    for each in entries:
        module, sign, function = (part.strip() for part in each.target.partition(":"))
        function = function.partition("[")[0].strip()
        if "=" in each.target:
            message = "two console scripts run together, as a comma between them is missing"
            yield _entry(texts, each, file, message, "")
            continue
        if not sign or not function or not module:
            message = f"`{each.target}` names no function, which stands behind a colon"
            remedy = f"{module}:main" if module and _has_main(modules, module) else ""
            yield _entry(texts, each, file, message, each.target, remedy, bool(remedy))
            continue
        found = modules.file(module)
        if found is None:
            yield from _no_module(texts, each, file, module, modules)
            continue
        names = top_names(texts.get(found) or b"")
        name = function.partition(".")[0]
        if names is not None and name not in names:
            remedy = _nearest(name, names)
            message = f"`{module}` has no `{name}`"
            yield _entry(texts, each, file, message, name, remedy, is_slip(name, remedy), last=True)
            continue
        package = module if found.endswith("__init__.py") else module.rpartition(".")[0]
        if modules.packages is not None and package and package not in modules.packages:
            message = f"`packages` has no `{package}`, so `{module}` is not installed"
            yield _entry(texts, each, file, message, module)


def _has_main(modules: _Modules, module: str) -> bool:
    file = modules.file(module)
    names = None if file is None else top_names(modules.texts.get(file) or b"")
    return names is not None and "main" in names


def _no_module(
    texts: PackageTexts, each: ConsoleScript, file: str, module: str, modules: _Modules
) -> Iterator[Entry]:
    there = sorted(modules.all())
    remedy = _nearest(module, there)
    sure = bool(remedy)
    if not modules.is_own(module):
        first, _, last = module.partition(".")
        own = [name for name in there if name.partition(".")[2] == (last or first)]
        if len(own) != 1 or (last and nearest(first, [own[0].partition(".")[0]]) is None):
            return
        remedy, sure = own[0], not last or is_slip(first, own[0].partition(".")[0])
    message = f"there is no module `{module}`"
    help_ = "" if remedy else _elsewhere(texts, module, modules)
    yield _entry(texts, each, file, message, module, remedy, sure)._replace(help=help_)


def _elsewhere(texts: PackageTexts, module: str, modules: _Modules) -> str:
    """Return where the file of a module is instead, as far as one is called so."""
    base = f"{module.rpartition('.')[2]}.py"
    found = [each for each in texts.python if each.rpartition("/")[2] in (base, f"test_{base}")]
    if len(found) != 1:
        return ""
    return f"`{found[0]}` is there: the module would be `{modules.path(module)}.py`"


def _nearest(name: str, names: Iterable[str]) -> str:
    """Return the name that a slip of the finger tells from another one, "" for none."""
    near = nearest(name, sorted(names)) or ""
    return near if near and is_slip(name, near) else ""


def _entry(
    texts: PackageTexts,
    script: ConsoleScript,
    file: str,
    message: str,
    part: str,
    remedy: str = "",
    is_sure: bool = False,
    *,
    last: bool = False,
) -> Entry:
    """Return what is wrong with a console script, at the part of it that is wrong."""
    said = texts.source.texts[file][script.span.start : script.span.end]
    sign = said.find(b"=") + 1
    if not part:
        return Entry(script.name, script.target, message, Place(file, script.span))
    word = part.encode()
    at = said.rfind(word) if last else said.find(word, sign)
    span = script.span
    if at >= sign:
        span = Span(script.span.start + at, script.span.start + at + len(word))
    is_fixable = is_sure and bool(remedy) and at >= sign
    return Entry(script.name, script.target, message, Place(file, span), remedy, is_fixable)


def top_names(text: bytes) -> frozenset[str] | None:
    """Return the names that a module has, None where that is not sure."""
    root = parse_python(text)
    if root.has_error:
        return None
    found: set[str] = set()
    waiting = list(root.named_children)
    while waiting:
        node = waiting.pop()
        if node.type in ("function_definition", "class_definition"):
            name = node.child_by_field_name("name")
            found |= {_text(name)}
            if _text(name) == "__getattr__":
                return None
        elif node.type in ("assignment", "augmented_assignment", "named_expression"):
            left = node.child_by_field_name("left") or node.child_by_field_name("name")
            found |= {_text(each) for each in _identifiers(left)}
            right = node.child_by_field_name("right") or node.child_by_field_name("value")
            if right is not None:
                waiting.append(right)
        elif node.type in ("import_statement", "import_from_statement"):
            if any(each.type == "wildcard_import" for each in node.named_children):
                return None
            found |= {_text(each) for each in _identifiers(node)}
        elif node.type == "call":
            if _text(node.child_by_field_name("function")).rpartition(".")[2] in _OPENING:
                return None
        elif node.type in _BLOCKS:
            waiting.extend(node.named_children)
            # `for NAME in …`
            found |= {_text(each) for each in _identifiers(node.child_by_field_name("left"))}
    return frozenset(found)


def _identifiers(node: Node | None) -> Iterator[Node]:
    waiting = [] if node is None else [node]
    while waiting:
        each = waiting.pop()
        if each.type == "identifier":
            yield each
        waiting.extend(each.named_children)


def _text(node: Node | None) -> str:
    return "" if node is None or node.text is None else node.text.decode("utf-8", "replace")
