from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from plastron_tui.output.layers import (
    LARGEST_TEXTS,
    MOST_LAYERS,
    Author,
    Layer,
    digest,
    layer_json,
    live_layers,
    read_layer,
)
from plastron_tui.output.manifest import Manifest, load_manifest
from plastron_tui.output.plan import OutputFile
from plastron_tui.output.writer import write

LAYER = Layer("a.plastron", b"one\ntwo\n", b"one\nthree\n", {"node": "n"}, "../a.py", "seen", True)


def no(layer: Layer, text: bytes) -> bool:
    return False


@given(
    st.builds(
        Layer,
        st.text(),
        st.binary(),
        st.binary(),
        st.dictionaries(st.text(), st.text()),
        st.none() | st.text(),
        st.none() | st.text(),
        st.booleans(),
        st.text(),
        st.text(),
    )
)
def test_json_and_back(layer: Layer) -> None:
    assert read_layer(layer_json(layer)) == layer


@pytest.mark.parametrize(
    ("key", "value"),
    [
        ("texts", "AAAA"), ("texts", "%"), ("texts", 5), ("texts", None), ("size", -1),
        ("size", 1000), ("size", "1"), ("base", []), ("program", None), ("origin", 5), ("seen", []),
    ],
)  # fmt: skip
def test_broken_layer(key: str, value: Any) -> None:
    assert read_layer({**layer_json(LAYER), key: value}) is None
    assert read_layer([layer_json(LAYER)]) is None


def test_texts_that_unpack_to_too_much_are_broken() -> None:
    bomb = Layer("a", b"a" * LARGEST_TEXTS, b"a")
    assert read_layer(layer_json(bomb)) is None


ONE = Layer("one", b"a\n", b"a\nb\n")
TWO = Layer("two", b"a\nb\n", b"a\nb\nc\n")
FROM = Layer("from", b"a\n", b"a\nb\n", origin="../a.py")


@pytest.mark.parametrize(
    ("layers", "text", "live"),
    [
        ((ONE, TWO), b"a\nb\nc\n", 2),
        ((ONE, TWO), b"a\nb\nc\nmine\n", 2),
        ((ONE, TWO), b"a\nb\nmine\n", 1),
        ((ONE, TWO), b"a\n", 0),
        ((ONE, TWO), b"a\nmine\n", 0),
        ((ONE, TWO), None, 0),
        ((FROM,), b"mine\n", 1),
        ((FROM,), b"a\n", 0),
        ((Layer("cut", b"a\nb\n", b"a\n"),), b"a\nmine\n", 1),
        ((Layer("cut", b"a\nb\n", b"a\n"),), b"a\nb\nmine\n", 0),
        ((Layer("left", b"a\n", b"a\nb\n", left=digest(b"a\nc\n")),), b"a\nc\n", 1),
    ],
)
def test_layers_that_a_file_shows(layers: tuple[Layer, ...], text: bytes, live: int) -> None:
    assert live_layers(layers, text, no) == layers[:live]


def test_layer_whose_endpoints_a_file_shows_is_live() -> None:
    assert live_layers((ONE, TWO), b"else\n", lambda layer, _: layer is ONE) == (ONE,)


def test_program_is_known_by_its_name_and_else_by_its_text(tmp_path: Path) -> None:
    layers = (Layer("a", b"", b"", text="x"), Layer("b", b"", b"", text="y"))
    assert Author("b", "other", tmp_path).place(layers) == 1
    assert Author("c", "y", tmp_path).place(layers) == 1
    assert Author("c", "z", tmp_path).place(layers) is None
    assert Author("", "y", tmp_path).place(layers) is None
    (tmp_path / "b").touch()
    assert Author("c", "y", tmp_path).place(layers) is None


def test_layers_of_a_file_outside_go_into_a_manifest_beside_it(tmp_path: Path, plan) -> None:
    (tmp_path / "nodes").mkdir()
    file = tmp_path / "nodes" / "a.py"
    file.write_bytes(LAYER.original)
    wanted = OutputFile(
        "a.py", LAYER.written, merged_from=LAYER.original, path=file, layers=(LAYER,)
    )
    assert write(plan(tmp_path / "output", [wanted])).diagnostics == ()
    assert load_manifest(file.parent)[0] == Manifest(layers={"a.py": (LAYER,)})
    assert not (tmp_path / "output").exists()
    forget = OutputFile("a.py", LAYER.original, merged_from=LAYER.written, path=file, layers=())
    assert write(plan(tmp_path / "output", [forget])).diagnostics == ()
    assert load_manifest(file.parent)[0] == Manifest()


def test_only_so_many_layers_are_remembered(tmp_path: Path, plan) -> None:
    layers = tuple(Layer(str(i), b"", b"x") for i in range(MOST_LAYERS + 2))
    file = OutputFile("a.py", b"x", layers=layers)
    assert write(plan(tmp_path, [file])).diagnostics == ()
    assert load_manifest(tmp_path)[0].layers == {"a.py": layers[2:]}
    assert write(plan(tmp_path, [file])) == ((), ())
