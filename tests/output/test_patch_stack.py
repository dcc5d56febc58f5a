from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from file_sets import one
from hypothesis import given
from hypothesis import strategies as st

from plastron_tui.model.source import FileSet
from plastron_tui.output.manifest import Manifest, load_manifest
from plastron_tui.output.patch_stack import (
    LARGEST_TEXTS,
    MOST_LAYERS,
    Author,
    Layer,
    digest,
    layer_json,
    live_layers,
    read_layer,
)
from plastron_tui.output.plan import OutputFile
from plastron_tui.output.writer import write

LAYER = Layer(
    "a.plastron", one(b"one\ntwo\n"), one(b"one\nthree\n"), {"node": "n"}, "../a.py", "seen", True
)


def no(layer: Layer, files: FileSet) -> bool:
    return False


NAMES = st.lists(st.sampled_from(["{}.py", "{}", "include/{}.hpp", "é"]), min_size=1, unique=True)
SETS = NAMES.flatmap(
    lambda names: st.tuples(*(st.tuples(st.just(name), st.binary()) for name in names))
).map(FileSet)


@given(
    st.builds(
        Layer,
        st.text(),
        SETS,
        SETS,
        st.dictionaries(st.text(), st.text()),
        st.none() | st.text(),
        st.none() | st.text(),
        st.booleans(),
        st.text(),
        st.text(),
    )
)
def test_json_and_back(layer: Layer) -> None:
    assert read_layer(layer_json(layer, "a.py"), "a.py") == layer


@pytest.mark.parametrize(
    ("key", "value"),
    [
        ("texts", "AAAA"), ("texts", "%"), ("texts", 5), ("texts", None), ("size", -1),
        ("size", 1000), ("size", "1"), ("size", None), ("base", []),
        ("program", None), ("origin", 5), ("seen", []),
    ],
)  # fmt: skip
def test_broken_layer(key: str, value: Any) -> None:
    assert read_layer({**layer_json(LAYER, "a.py"), key: value}, "a.py") is None
    assert read_layer([layer_json(LAYER, "a.py")], "a.py") is None


OF_TWO = replace(LAYER, original=FileSet((("{}.py", b"a"), ("{}.yaml", b"b"))))


@pytest.mark.parametrize(
    "sizes",
    [
        [], [[]], [[], []], [[["{}.py", 1]]], [[["{}.py", 2]], [["{}.py", 9], ["x", 2]]],
        [[["{}.py", -1]], [["{}.py", 12]]], [[[5, 2]], [["{}.py", 10]]], [5, 6], "ab",
        [[["../../../../../a.py", 2]], [["{}.py", 10]]], [[["a/../../b.py", 2]], [["{}.py", 10]]],
        [[["..", 2]], [["{}.py", 10]]], [[["/a.py", 2]], [["{}.py", 10]]],
        [[["{}.py", 1, 1]], []], [[["{}.py", 1]], [["{}.py", 1]], [["{}.py", 10]]],
    ],
)  # fmt: skip
def test_broken_layer_of_sets(sizes: Any) -> None:
    data = layer_json(OF_TWO, "a.py")
    assert read_layer(data, "a.py") == OF_TWO
    assert read_layer({**data, "sizes": sizes}, "a.py") is None


def test_what_is_remembered_of_other_files_counts_for_nothing() -> None:
    """A manifest may be anybody's, and name any file: the main file's own words lead to others."""
    foreign = replace(OF_TWO, written=FileSet((("{}.py", b"a"), ("../../secret", b"b"))))
    present = FileSet((("{}.py", b"a"), ("{}.yaml", b"b")))
    assert live_layers((OF_TWO,), present, lambda *_: True) == (OF_TWO,)
    assert live_layers((foreign,), present, lambda *_: True) == ()


def test_texts_that_unpack_to_too_much_are_broken() -> None:
    bomb = Layer("a", one(b"a" * LARGEST_TEXTS), one(b"a"))
    assert read_layer(layer_json(bomb, "a.py"), "a.py") is None


ONE = Layer("one", one(b"a\n"), one(b"a\nb\n"))
TWO = Layer("two", one(b"a\nb\n"), one(b"a\nb\nc\n"))
FROM = Layer("from", one(b"a\n"), one(b"a\nb\n"), origin="../a.py")


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
        ((Layer("cut", one(b"a\nb\n"), one(b"a\n")),), b"a\nmine\n", 1),
        ((Layer("cut", one(b"a\nb\n"), one(b"a\n")),), b"a\nb\nmine\n", 0),
        ((Layer("left", one(b"a\n"), one(b"a\nb\n"), left=digest(b"a\nc\n")),), b"a\nc\n", 1),
    ],
)
def test_layers_that_a_file_shows(layers: tuple[Layer, ...], text: bytes | None, live: int) -> None:
    assert live_layers(layers, None if text is None else one(text), no) == layers[:live]


def test_layer_whose_endpoints_a_file_shows_is_live() -> None:
    assert live_layers((ONE, TWO), one(b"else\n"), lambda layer, _: layer is ONE) == (ONE,)


def test_program_is_known_by_its_name_and_else_by_its_text(tmp_path: Path) -> None:
    layers = (Layer("a", one(b""), one(b""), text="x"), Layer("b", one(b""), one(b""), text="y"))
    assert Author("b", "other", tmp_path).place(layers) == 1
    assert Author("c", "y", tmp_path).place(layers) == 1
    assert Author("c", "z", tmp_path).place(layers) is None
    assert Author("", "y", tmp_path).place(layers) is None
    (tmp_path / "b").touch()
    assert Author("c", "y", tmp_path).place(layers) is None


def test_layers_of_a_file_outside_go_into_a_manifest_beside_it(tmp_path: Path, plan) -> None:
    (tmp_path / "nodes").mkdir()
    file = tmp_path / "nodes" / "a.py"
    file.write_bytes(LAYER.original.main)
    before, after = LAYER.original.main, LAYER.written.main
    wanted = OutputFile("a.py", after, merged_from=before, path=file, layers=(LAYER,))
    assert write(plan(tmp_path / "output", [wanted])).diagnostics == ()
    assert load_manifest(file.parent)[0] == Manifest(layers={"a.py": (LAYER,)})
    assert not (tmp_path / "output").exists()
    forget = OutputFile("a.py", before, merged_from=after, path=file, layers=())
    assert write(plan(tmp_path / "output", [forget])).diagnostics == ()
    assert load_manifest(file.parent)[0] == Manifest()


def test_only_so_many_layers_are_remembered(tmp_path: Path, plan) -> None:
    layers = tuple(Layer(str(i), one(b""), one(b"x")) for i in range(MOST_LAYERS + 2))
    file = OutputFile("a.py", b"x", layers=layers)
    assert write(plan(tmp_path, [file])).diagnostics == ()
    assert load_manifest(tmp_path)[0].layers == {"a.py": layers[2:]}
    assert write(plan(tmp_path, [file])) == ((), ())
