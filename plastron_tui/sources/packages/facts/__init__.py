"""What the files of a package say of each other, each kind of fact in a file of its own."""

from __future__ import annotations

from collections.abc import Callable

from plastron_tui.model.package_facts import BuildFacts
from plastron_tui.model.package_source import PackageSource
from plastron_tui.sources.packages.reading import CMAKE_LISTS, PACKAGE_XML, SETUP_PY
from plastron_tui.sources.xml.package_xml import read_package

from .cmake_lists import (
    Lists,
    cmake_words,
    finds_declared,
    found_packages,
    linked_packages,
    read_lists,
)
from .components import component_classes, registered_again
from .declared import declared
from .definitions import definition_mistakes
from .entry_points import PythonSetup, read_python_setup
from .scripts import find_scripts
from .texts import PackageTexts
from .uses import find_uses, header_folders, mentioned, near_names


def build_facts(
    source: PackageSource,
    read: Callable[[str], bytes | None],
    programs: frozenset[str],
    *,
    is_whole: bool = True,
) -> BuildFacts | None:
    """Return what the files of a package say of each other, None where its package.xml says none.

    Args:
        source: the package.
        read: returns what a file of it holds, None where it cannot be read.
        programs: the files that somebody may run, as their mode says.
        is_whole: whether the executables of the package are all that Python's setup installs.
    """
    package, _ = read_package(source.texts[PACKAGE_XML], source.folder / PACKAGE_XML)
    if package is None:
        return None
    texts = PackageTexts(source, read, programs)
    dependencies = declared(package)
    names = {each.name for each in dependencies}
    lists = Lists()
    setup = PythonSetup()
    if source.build_type != "ament_python" and CMAKE_LISTS in source.texts:
        lists = read_lists(texts)
    if SETUP_PY in source.texts:
        setup = read_python_setup(texts)
    name = package.document.root.named("name")[0]
    is_python = source.build_type == "ament_python"
    is_open = is_python or not is_whole
    return BuildFacts(
        build_type=source.build_type,
        name_span=name.value_span(package.document.text),
        format=package.format,
        dependencies=dependencies,
        has_groups=any(each.tag == "group_depend" for each in package.groups),
        used=tuple(find_uses(texts, dependencies, lists, setup)),
        mentioned=mentioned(texts, names),
        near=near_names(texts, names),
        found=found_packages(lists),
        finds_declared=finds_declared(lists),
        linked=linked_packages(lists, names),
        exported=lists.exported,
        has_code=texts.has_code,
        modules=setup.modules | {each.rpartition("/")[2] for each in lists.python_folders},
        has_headers=any(f"include/{source.name}/" in each for each in source.names),
        folders=frozenset(header_folders(source.names)),
        scripts=tuple(find_scripts(texts, lists, setup)),
        targets=lists.targets,
        is_settled=is_whole and (setup.is_settled if is_python else lists.is_settled),
        words=None if is_open or lists.words is None else lists.words | cmake_words(texts, lists),
        files=texts.bases | {each.rpartition("/")[2] for each in programs},
        components=None if lists.lists is None or lists.is_open else component_classes(lists.lists),
        registered_again=() if lists.lists is None else tuple(registered_again(lists.lists)),
        placed=lists.placed,
        installs_nodes=bool(lists.installs_nodes or setup.scripts),
        entries=setup.wrong if is_python else (),
        script_folder=setup.script_folder if is_python else None,
        definitions=tuple(definition_mistakes(texts, package, lists)),
    )
