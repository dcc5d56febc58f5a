"""The rules, a file for what a group of them is about. Importing this declares them."""

from __future__ import annotations

from plastron_tui.lint.rule import RULES

from . import (
    callbacks,
    code,
    graph,
    handles,
    headers,
    launch_names,
    messages,
    names,
    one_sided,
    packages,
    packages_changes,
    packages_installed,
    packages_started,
    packages_types,
    parameters_declared,
    parameters_types,
    parameters_used,
)

__all__ = [
    "RULES",
    "callbacks",
    "code",
    "graph",
    "handles",
    "headers",
    "launch_names",
    "messages",
    "names",
    "one_sided",
    "packages",
    "packages_changes",
    "packages_installed",
    "packages_started",
    "packages_types",
    "parameters_declared",
    "parameters_types",
    "parameters_used",
]
