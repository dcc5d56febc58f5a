"""Which codes the package emits, read from its source."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

PACKAGE = Path(__file__).parents[2] / "plastron_tui"

# What carries a code as its first argument, named `code`.
_CARRIERS = {"Diagnostic": 0, "TypeProblem": 0}


@dataclass(frozen=True)
class Emitted:
    """A code, or the expression that makes one, and where it stands."""

    code: str | None
    expression: str
    where: str


_Carrier = tuple[Path | None, str]
"""A function or `self.method` by its name; a function that is private with its module."""


def emitted_codes() -> list[Emitted]:
    """Return every code that is handed to a diagnostic, through helper functions as well.

    A function that hands one of its parameters on as a code is a carrier itself, so that the
    codes are what its callers give it; and so is a class that is made with a `code`.
    """
    trees = {
        path: ast.parse(path.read_text(encoding="utf-8"))
        for path in sorted(PACKAGE.rglob("*.py"))
        if path.parent.name != "diagnostics"
    }
    carriers: dict[_Carrier, int] = {(None, name): at for name, at in _CARRIERS.items()}
    for path, tree in trees.items():
        for class_, at in _made_with_a_code(tree):
            carriers[_carrier(path, class_)] = at
    while True:
        found: list[Emitted] = []
        before = len(carriers)
        for path, tree in trees.items():
            found += _in_module(tree, path, carriers)
        if len(carriers) == before:
            return found


def _carrier(path: Path, name: str) -> _Carrier:
    return (path if name.startswith("_") else None), name


def _made_with_a_code(tree: ast.Module) -> Iterator[tuple[str, int]]:
    for node in ast.walk(tree):
        if isinstance(node, ast.ClassDef):
            for child in node.body:
                if isinstance(child, ast.FunctionDef) and child.name == "__init__":
                    names = [argument.arg for argument in child.args.args]
                    if "code" in names:
                        yield node.name, names.index("code") - 1


def _in_module(tree: ast.Module, path: Path, carriers: dict[_Carrier, int]) -> Iterator[Emitted]:
    for function, call in _calls(tree):
        carrier = _carrier(path, _name(call.func))
        if carrier not in carriers:
            continue
        value = _argument(call, carriers[carrier])
        if value is None:
            continue
        where = f"{path.relative_to(PACKAGE)}:{call.lineno}"
        if isinstance(value, ast.Constant) and isinstance(value.value, str):
            yield Emitted(value.value, ast.unparse(value), where)
            continue
        carried = _parameter(function, value)
        if carried is not None:
            carriers.setdefault(_carrier(path, carried[0]), carried[1])
        elif not (isinstance(value, ast.Attribute) and value.attr in ("code", "_code")):
            yield Emitted(None, ast.unparse(value), where)


def _calls(tree: ast.Module) -> Iterator[tuple[list[ast.AST], ast.Call]]:
    """Yield every call with the functions and classes around it."""

    def walk(node: ast.AST, around: list[ast.AST]) -> Iterator[tuple[list[ast.AST], ast.Call]]:
        for child in ast.iter_child_nodes(node):
            if isinstance(child, ast.Call):
                yield around, child
            inner = isinstance(child, (ast.FunctionDef, ast.ClassDef))
            yield from walk(child, [*around, child] if inner else around)

    return walk(tree, [])


def _name(function: ast.expr) -> str:
    if isinstance(function, ast.Attribute):
        of_self = isinstance(function.value, ast.Name) and function.value.id == "self"
        return f"self.{function.attr}" if of_self else function.attr
    return getattr(function, "id", "")


def _argument(call: ast.Call, index: int) -> ast.expr | None:
    for keyword in call.keywords:
        if keyword.arg == "code":
            return keyword.value
    return call.args[index] if index < len(call.args) else None


def _parameter(around: list[ast.AST], value: ast.expr) -> tuple[str, int] | None:
    """Return the function that has a value as its parameter, and which one it is."""
    if not isinstance(value, ast.Name):
        return None
    for function in reversed(around):
        if isinstance(function, ast.FunctionDef):
            names = [argument.arg for argument in function.args.args]
            if value.id in names:
                is_method = names[0] == "self"
                name = f"self.{function.name}" if is_method else function.name
                return name, names.index(value.id) - is_method
    return None
