"""The hand-written C++ nodes of tests/nodes, each with what inspecting it must give."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from plastron_tui.model.inspection import inspect_json
from plastron_tui.model.source import EndpointKind
from plastron_tui.targets import files_of, read_source

NODES = Path(__file__).parents[2] / "nodes"
LIBRARIES = ("roscpp", "nodelet", "rclcpp", "component")
EXPECTED = sorted(path for library in LIBRARIES for path in (NODES / library).glob("*.json"))
WHERE_SAID = frozenset(
    {"parameter_type", "default_expression", "default_value", "default_guess", "description"}
    | {"range", "read_only", "expression"}
)
"""What is compared only where the JSON says it."""


def _read(path: Path) -> bytes | None:
    return path.read_bytes() if path.is_file() else None


def _inspected(path: Path) -> tuple[dict[str, Any], list[str | None]]:
    """Return what is in a file, and the class of each of its nodes."""
    result = read_source(path, files_of(path, path.read_bytes(), _read))
    assert result.source is not None, result.diagnostics
    return inspect_json(result.source), [node.class_name for node in result.source.nodes]


def _entry(kind: EndpointKind, entry: dict[str, Any], stem: str) -> tuple[Any, ...]:
    """Return what two entries of one call have in common: where the call is, and what of."""
    named = entry.get(kind.facts.named or "")
    file = entry.get("file", "").replace("{}", stem)
    return kind.value, file, entry["line"], json.dumps(named), json.dumps(entry.get("type"))


def _differences(wanted: dict[str, Any], found: dict[str, Any], stem: str) -> Iterator[str]:
    for kind in EndpointKind:
        expected = {_entry(kind, entry, stem): entry for entry in wanted.get(kind.value, [])}
        got = {_entry(kind, entry, stem): entry for entry in found[kind.value]}
        yield from (f"missing: {' '.join(map(str, key))}" for key in expected.keys() - got.keys())
        yield from (f"invented: {' '.join(map(str, key))}" for key in got.keys() - expected.keys())
        for key in expected.keys() & got.keys():
            yield from _other(expected[key], got[key], " ".join(map(str, key)))
        assert len(expected) == len(wanted.get(kind.value, [])), "two calls are the same"


def _other(wanted: dict[str, Any], found: dict[str, Any], where: str) -> Iterator[str]:
    """Yield what else is said of a call, and is something else."""
    qos, known = wanted.get("qos", {}), found.get("qos", {})
    for policy in qos:
        if qos[policy] != known.get(policy):
            yield f"{where}: {policy} {known.get(policy)}, not {qos[policy]}"
    for key in (wanted.keys() | found.keys()) - {"qos", "file"}:
        skipped = key in WHERE_SAID and key not in wanted
        if not skipped and wanted.get(key) != found.get(key):
            yield f"{where}: {key} {found.get(key)!r}, not {wanted.get(key)!r}"


def _name(expected: Path) -> str:
    return f"{expected.parent.name}/{expected.stem}"


@pytest.mark.parametrize("expected", EXPECTED, ids=_name)
def test_a_node_reads_as_its_author_says(expected: Path) -> None:
    wanted = json.loads(expected.read_text(encoding="utf-8"))
    path = expected.parent / wanted["file"]
    found, classes = _inspected(path)
    told = [found["client_library"], *(node["name"] for node in found["nodes"])]
    assert told == [wanted["client_library"], *(node["name"] for node in wanted["nodes"])]
    for node, read, class_ in zip(wanted["nodes"], found["nodes"], classes, strict=True):
        assert sorted(_differences(node, read, path.stem)) == []
        assert read.get("managed", False) is node.get("managed", False)
        if "class" in node:
            assert class_ == node["class"].rpartition("::")[2]


@pytest.mark.parametrize("library", LIBRARIES)
def test_there_are_enough_of_a_library(library: str) -> None:
    folder = NODES / library
    wanted = [json.loads(path.read_text(encoding="utf-8"))["file"] for path in EXPECTED]
    mine = {file for file, path in zip(wanted, EXPECTED, strict=True) if path.parent == folder}
    single = {path.name for path in folder.iterdir() if path.suffix not in {".json", ""}}
    packages = {path.name for path in folder.iterdir() if path.is_dir()}
    assert {file for file in mine if "/" not in file} == single
    assert {file.partition("/")[0] for file in mine if "/" in file} == packages
    assert len(mine) >= 40
    assert len(packages) >= 14
