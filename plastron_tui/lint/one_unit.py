"""The rules that the files of one node can break, whatever else a workspace has.

The linter and those who have loaded a file, `check` and the studio, ask the same rules.
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from plastron_tui.diagnostics import Diagnostic, LineIndex
from plastron_tui.model.code_facts import CodeFacts
from plastron_tui.model.source import SourceUnit, place_of
from plastron_tui.ros.catalog import Catalog

from .engine import lint
from .rule import Group
from .selection import Selection
from .suppression import FileComments
from .tree import SourceTree, UnitFacts

_GROUPS = (Group.MESSAGES, Group.PARAMETERS, Group.CODE)


def facts_of(source: SourceUnit, ros_version: int, code: CodeFacts) -> UnitFacts:
    """Return what the rules look at of the files of a node.

    Args:
        source: the files.
        ros_version: the generation of ROS that they are for.
        code: what their language says of their code.
    """
    return UnitFacts(source.path, source.library, ros_version, source.nodes, code)


def lint_unit(
    source: SourceUnit,
    facts: UnitFacts,
    catalogs: Mapping[int, Catalog],
    selection: Selection | None = None,
    root: Path | None = None,
) -> tuple[Diagnostic, ...]:
    """Return what breaks rules in the files of a node, without what comments say is meant.

    Args:
        source: the files.
        facts: what they say.
        catalogs: the interface types, by generation of ROS.
        selection: which rules are followed, by default those that are by themselves.
        root: the folder that the selection's patterns of paths are from.
    """
    import plastron_tui.lint.rules  # noqa: F401 - declares them

    chosen = Selection() if selection is None else selection
    rules = [each for each in chosen.rules() if each.group in _GROUPS]
    tree = SourceTree(source.path.parent, units=(facts,), catalogs=catalogs)
    paths = ((place_of(source.path, name), text) for name, text in source.files.texts)
    comments = {path: FileComments(path, text, LineIndex(text)) for path, text in paths}
    return tuple(
        each.diagnostic
        for each in lint(tree, rules)
        if (file := each.diagnostic.file) is not None
        and not chosen.is_ignored(each.rule, file, root or tree.root)
        and not (file in comments and comments[file].mean(each.rule, each.diagnostic.span))
    )
