"""Which plugin descriptions load a class from a Python file of a package.

From the page "Plugin Description File" of the ROS wiki: the path of a library is from the folder
of the package. As rqt's own plugins in Python have it, it is the folder that the modules are in,
and the type of a class is `MODULE.CLASS`.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from plastron_tui.diagnostics import Diagnostic, Span, codes
from plastron_tui.model.package_source import PackageSource

from .reading import PACKAGE_XML


def plugin_refusals(
    source: PackageSource, texts: Mapping[str, bytes], file: str
) -> Iterator[Diagnostic]:
    """Yield why a file does not leave a package: each class of it that is loaded by name.

    Args:
        source: the package.
        texts: what its files hold by now.
        file: the file, by its path in the package.
    """
    from plastron_tui.sources.xml.plugins import read_plugins

    for name, text in sorted(texts.items()):
        if not name.endswith(".xml") or name == PACKAGE_XML or b"<class" not in text:
            continue
        plugins, _ = read_plugins(text, source.folder / name)
        for library in plugins.libraries if plugins is not None else ():
            for described, element in library.classes:
                if file not in _files(source, library.path, described.type):
                    continue
                message = f"line {element.line} of `{name}` loads `{described.type}` from `{file}`"
                remedy = "take the class out of the plugin description first"
                span = Span(*element.start_tag)
                yield Diagnostic(codes.EDIT_REFUSED, message, span, source.folder / name, remedy)


def _files(source: PackageSource, path: str, class_type: str) -> Iterator[str]:
    """Yield the files that may have a class, by their paths in the package."""
    module = class_type.rpartition(".")[0].replace(".", "/")
    for root in (path.removeprefix("./").strip("/"), source.python_root, "src"):
        start = f"{root}/{module}".lstrip("./") if module else root
        yield f"{start}.py"
        yield f"{start}/__init__.py"
