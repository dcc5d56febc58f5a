"""Where a setup.cfg has console scripts installed to (`ros2 run` looks in `lib/PACKAGE`).

From setuptools, `_parse_config_files` of its `dist.py`: a section has the options of the command of
its name, in which `-` stands for `_`. `colcon build` calls `install`, with `--symlink-install` it
calls `develop` (`colcon_core/task/python/build.py`).
"""

from __future__ import annotations

import re
from typing import NamedTuple

from plastron_tui.diagnostics import Span
from plastron_tui.model.package_facts import Place, ScriptFolder
from plastron_tui.sources.packages.reading import PYPROJECT, SETUP_CFG, SETUP_PY

from .texts import PackageTexts

_LINE = re.compile(
    rb"^(?:\[(?P<section>[^\]\n]*)\]|[ \t]*(?P<key>[\w-]+)[ \t]*[=:][ \t]*(?P<value>[^\r\n]*))",
    re.M,
)
_OPTIONS = {"install": "install_scripts", "develop": "script_dir"}
_KEYS = (b"install_scripts", b"install-scripts", b"script_dir", b"script-dir")


class _Option(NamedTuple):
    """An option of a setup.cfg: the section that it is in, where that begins, and its value."""

    section: str
    header: Span
    key: str
    value: str
    span: Span


def script_folder(texts: PackageTexts) -> ScriptFolder | None:
    """Return why `ros2 run` finds no console script, None where nothing speaks against it."""
    sources = texts.source.texts
    if any(each in sources[SETUP_PY] for each in _KEYS) or b"distutils" in sources.get(
        PYPROJECT, b""
    ):
        return None
    options = _options(sources.get(SETUP_CFG, b""))
    found = (_fault(texts, options, command, key) for command, key in _OPTIONS.items())
    return next((each for each in found if each is not None), None)


def _fault(
    texts: PackageTexts, options: list[_Option], command: str, key: str
) -> ScriptFolder | None:
    name = texts.source.name
    own = [each for each in options if each.key == key and each.section == command]
    where, when = f"`lib/{name}`", ""
    if command == "develop":
        when = " of a build with `--symlink-install`"
    # What is missing for both builds is told once, and so with both remedies.
    missing = [
        each
        for each in _OPTIONS.items()
        if each == (command, key) or all(option.key != each[1] for option in options)
    ]
    help_ = "write " + " and ".join(
        f"`{key}=$base/lib/{name}` below `[{command}]`" for command, key in missing
    )
    looks = f"`ros2 run` looks for programs{when} in {where}"
    for each in own:
        folder = each.value.rstrip(" \t/")
        if not re.search(r"[%\s]", folder) and folder not in (f"$base/lib/{name}", f"lib/{name}"):
            message = f"{looks}, and they are installed to `{folder}`"
            return ScriptFolder(message, Place(SETUP_CFG, each.span), help_)
    if own:
        return None
    astray = next((each for each in options if each.key == key), None)
    if astray is not None:
        message = f"{looks}, and `{key}` counts below `[{command}]` alone"
        return ScriptFolder(message, Place(SETUP_CFG, astray.header), help_)
    if options:
        message = f"{looks}, and `setup.cfg` does not say that below `[{command}]`"
        return ScriptFolder(message, Place(SETUP_CFG, options[0].header), help_)
    at = texts.source.texts[SETUP_PY].find(b"console_scripts")
    if at < 0:
        return None
    message = f"{looks}, and no `setup.cfg` says that"
    return ScriptFolder(message, Place(SETUP_PY, Span(at, at + len(b"console_scripts"))), help_)


def _options(text: bytes) -> list[_Option]:
    """Return the options that say where programs are installed, whichever section they are in."""
    found: list[_Option] = []
    section, header = "", Span(0, 0)
    for match in _LINE.finditer(text):
        if match["section"] is not None:
            section, header = match["section"].decode("utf-8", "replace"), Span(*match.span())
            continue
        key = match["key"].decode("utf-8", "replace").replace("-", "_")
        if key in _OPTIONS.values():
            value = match["value"].decode("utf-8", "replace").rstrip()
            span = Span(match.start("value"), match.start("value") + len(match["value"].rstrip()))
            found.append(_Option(section, header, key, value, span))
    return found
