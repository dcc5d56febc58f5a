"""Manifests and project files that something grows from."""

from __future__ import annotations

import base64
import json
import zlib
from collections.abc import Callable
from pathlib import Path

import pytest
from limited import Attacker, make_project
from machine import mostly_long


def _layers(count: int) -> bytes:
    packed = base64.b64encode(zlib.compress(bytes(16 * 1024**2 - 1), 9)).decode()
    layer = {"program": "p", "base": {}, "size": 0, "texts": packed}
    files = {f"f{number}.py": {"layers": [layer] * 8} for number in range(count)}
    return json.dumps({"generator": "plastron", "version": 3, "files": files}).encode()


_MANIFEST = '{{"generator": "plastron", "version": 3, "files": {}}}'
# Made by the test that writes one: each process that collects tests would make all.
MANIFESTS: dict[str, Callable[[], str | bytes]] = {
    "packed": lambda: _layers(16),
    "lists": lambda: _MANIFEST.format("[" + "[]," * 10_000_000 + "[]]"),
    "objects": lambda: _MANIFEST.format("[" + '{"a":0},' * 4_000_000 + "{}]"),
    "texts": lambda: _MANIFEST.format(
        '["' + '","'.join(f"{n:05d}" for n in range(100_000)) * 30 + '"]'
    ),
    "depth": lambda: "[" * 1_000_000,
    "digits": lambda: _MANIFEST.format("9" * 1_000_000),
    "files": lambda: _MANIFEST.format(
        "{" + ",".join(f'"f{n}":{{"base":{{}}}}' for n in range(900_000)) + "}"
    ),
    "base": lambda: _MANIFEST.format(
        '{"talker_pub.py":{"base":' + '{"a":' * 900 + "1" + "}" * 901 + "}"
    ),
}

_QUICK = {"packed", "depth"}


@pytest.mark.parametrize("name", mostly_long(MANIFESTS, _QUICK))
def test_a_manifest_ends_with_a_diagnostic(attacker: Attacker, tmp_path: Path, name: str) -> None:
    folder = tmp_path / "project"
    make_project(folder)
    attacker.run(folder, "generate", "p.plastron").check(0)
    text = MANIFESTS[name]()
    data = text.encode() if isinstance(text, str) else text
    (folder / "output/.plastron.json").write_bytes(data)
    for command in ("check p.plastron", "generate p.plastron"):
        attacker.run(folder, *command.split()).check()


YAML: dict[str, str] = {
    "laughs": "a: &a [x, x]\n"
    + "".join(
        f"{chr(98 + n)}: &{chr(98 + n)} [*{chr(97 + n)}, *{chr(97 + n)}]\n" for n in range(24)
    ),
    "types": "types: [" + "., " * 20_000 + "]\n",
    "laughing types": "types: &a\n- .\n- .\n",
    "depth": "[" * 60_000,
    "keys": "".join(f"k{n}: 1\n" for n in range(7_000)),
    "long key": f"{'k' * 900}: 1\n",
    "long value": f"target: {'k' * 60_000}\n",
    "long folder": f"output: {'k' * 60_000}\n",
    "long types": f"types: {'k' * 60_000}\n",
    "home": f"output: ~{'k' * 60_000}\n",
    "merge": "<<: &a {<<: *a}\n",
    "tag": f"!!{'k' * 60_000} x\n",
    "anchors": f"&{'k' * 60_000} x: *y\n",
    "unknown alias": f"x: *{'y' * 60_000}\n",
    "bad": f"x: {{{'y' * 60_000}\n",
    "root of all": "types: /\n",
}

_QUICK_YAML = {"unknown alias"}


@pytest.mark.parametrize("name", mostly_long(YAML, _QUICK_YAML))
def test_a_project_file_ends_with_a_diagnostic(
    attacker: Attacker, tmp_path: Path, name: str
) -> None:
    folder = tmp_path / "project"
    make_project(folder)
    (folder / "plastron.yaml").write_text(YAML[name])
    for command in ("check p.plastron", "generate --dry-run p.plastron"):
        attacker.run(folder, *command.split()).check()
