"""Packages, and what they contain."""

from __future__ import annotations

from plastron_tui.diagnostics.code import Code

from .programs import TALKING

_ROVER = f"{TALKING}create_package 'rover' as rover\n"
_FULL = f"{_ROVER}rover contains talker\n"

PACKAGE_EXISTS = Code(
    "package-exists",
    "Two packages of a program have one name: a workspace takes only one of them.",
    bad="create_package 'rover' as first\ncreate_package 'rover' as second\n",
    good="create_package 'rover' as first\ncreate_package 'rover_tools' as second\n",
)

UNKNOWN_PACKAGE = Code(
    "unknown-package",
    "No package has this variable: it is misspelt, or the package is made further down.",
    bad=f"{_ROVER}rovr contains talker\n",
    good=_FULL,
)

UNKNOWN_ITEM = Code(
    "unknown-item",
    "A package contains nodes and launch files, by their variables.",
    bad=f"{_ROVER}rover contains greeting\n",
    good=_FULL,
)

ALREADY_CONTAINED = Code(
    "already-contained",
    "A node or a launch file is in a package already, or the package has another one of its "
    "name: what a package contains is started by its name.",
    bad=f"{_FULL}rover contains talker\n",
    good=_FULL,
)

NOT_CONTAINED = Code(
    "not-contained",
    "A package does not contain what is to be taken out of it.",
    bad=f"{_ROVER}rover no_longer_contains talker\n",
    good=f"{_FULL}rover no_longer_contains talker\n",
)
