"""The parser in the layout that older editors know."""

from __future__ import annotations

import ctypes
import subprocess
from pathlib import Path

import pytest
import tree_sitter_plastron
from tree_sitter import Language, Parser, Query

from .statements import STATEMENTS

GRAMMAR = Path(__file__).parents[2] / "tree-sitter-plastron"
NEWER = Language(tree_sitter_plastron.language())


@pytest.fixture(scope="module")
def older(tmp_path_factory: pytest.TempPathFactory) -> Language:
    """Compile the parser as Helix does, each file by itself, and load it."""
    library = tmp_path_factory.mktemp("abi") / "plastron.so"
    sources = [GRAMMAR / "abi-14" / "src" / name for name in ("parser.c", "scanner.c")]
    flags = ["-std=c11", "-Wall", "-Wextra", "-Werror", "-O0", "-shared", "-fPIC"]
    subprocess.run(["cc", *flags, *sources, "-o", library], check=True)
    entry = ctypes.CDLL(str(library)).tree_sitter_plastron
    entry.restype = ctypes.c_void_p
    capsule = ctypes.pythonapi.PyCapsule_New
    capsule.restype = ctypes.py_object
    capsule.argtypes = [ctypes.c_void_p, ctypes.c_char_p, ctypes.c_void_p]
    return Language(capsule(entry(), b"tree_sitter.Language", None))


def test_it_reads_what_the_newer_one_reads(older: Language) -> None:
    assert older.abi_version == 14 and NEWER.abi_version == 15
    texts = ["\n".join(texts) for texts in STATEMENTS.values()]
    texts += [path.read_text() for path in (GRAMMAR.parent / "examples").glob("*.plastron")]
    assert len(texts) > 40
    for text in texts:
        trees = [Parser(each).parse(text.encode()).root_node for each in (older, NEWER)]
        assert not trees[1].has_error
        assert str(trees[0]) == str(trees[1])


def test_a_line_with_a_mistake_is_no_worse_than_a_line(older: Language) -> None:
    text = "create_node 'a' as as\ndrop_type\nsubscribe subscribe to\ngenerate_node talker\n"
    root = Parser(older).parse(text.encode()).root_node
    assert root.has_error
    assert root.children[-1].type == "generate_node_statement"
    assert not root.children[-1].has_error


def test_the_queries_are_for_it_too(older: Language) -> None:
    for path in (GRAMMAR / "queries").rglob("*.scm"):
        assert Query(older, path.read_text()).capture_count > 0
