"""What the names of a C++ file are bound to: namespaces, classes, functions, blocks, variables."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from tree_sitter import Node

from .syntax import Syntax

if TYPE_CHECKING:
    from .arguments import Call

_KINDS = {
    "translation_unit": "file",
    "namespace_definition": "namespace",
    "class_specifier": "class",
    "struct_specifier": "class",
    "function_definition": "function",
    "lambda_expression": "lambda",
    "template_declaration": "template",
}
_CV = re.compile(
    r"\b(?:const|volatile|typename|struct|class|static|constexpr|inline|mutable|extern)\b|\.\.\."
)
_FUNCTION_LIKE = ("function", "lambda")


def type_text(text: str) -> str:
    """Return a type without blanks, `const`, references and pointers: `a::B<c::D>`."""
    words = text.split()
    if len(words) != 1 or "..." in text:
        words = _CV.sub(" ", text).split()
    text = "".join(words)
    return text.rstrip("&*").removeprefix("::")


@dataclass(slots=True, eq=False)
class Variable:
    """A variable, member or parameter.

    Attributes:
        name: its name.
        kind: `local`, `parameter`, `member` or `global`.
        type_node: what is written as its type, None for what has none.
        node: its declaration.
        scope: the scope that it is declared in.
        start: from which offset on it can be named.
        value: what it is initialized with.
        arguments: what its constructor gets, None where it is not written like that.
        declarator: its name's node.
        is_pointer: whether its declarator makes it a pointer.
        is_reference: whether its declarator makes it a reference.
    """

    name: str
    kind: str
    type_node: Node | None
    node: Node
    scope: Scope
    start: int
    value: Node | None = None
    arguments: list[Node] | None = None
    declarator: Node | None = None
    is_pointer: bool = False
    is_reference: bool = False
    _end: int | None = None

    def is_visible(self, at: int) -> bool:
        """Tell whether it can be named at an offset: one of a block ends with that."""
        if self.start > at:
            return False
        if self.kind not in ("local", "loop"):
            return True
        if self._end is None:
            self._end = _end_of_block(self.node, len(self.file.syntax.code))
        return at <= self._end

    @property
    def is_array(self) -> bool:
        """Whether it is an array, which `char name[]` is as well."""
        syntax = self.file.syntax
        end = self.declarator.end_byte if self.declarator is not None else self.start
        return syntax.code[end : end + 1] == b"["

    @property
    def is_list(self) -> bool:
        """Whether it has several values."""
        type_ = self.type
        return "vector<" in type_ or "array<" in type_ or "list<" in type_ or self.is_array

    @property
    def file(self) -> CppFile:
        """The file that declares it."""
        return self.scope.file

    @property
    def is_const(self) -> bool:
        """Whether it keeps its first value."""
        if self.node.type == "enumerator":
            return True
        syntax = self.file.syntax
        end = self.type_node.end_byte if self.type_node is not None else self.node.start_byte
        head = syntax.code[self.node.start_byte : end]
        return b"const" in head

    @property
    def type(self) -> str:
        """Its type as it is written, see `type_text`; "" for none."""
        node = self.type_node
        if node is not None and node.type in ("class_specifier", "struct_specifier"):
            node = node.child_by_field_name("name")
        return "" if node is None else type_text(self.file.syntax.word(node))


_BLOCKS = frozenset(
    {"catch_clause", "compound_statement", "for_range_loop", "for_statement", "if_statement",
     "switch_statement", "while_statement"}
)  # fmt: skip
"""What a variable that is declared in it ends with."""


def _end_of_block(node: Node, end: int) -> int:
    """Return where the block around a declaration ends; the end of the text for a broken one."""
    above = node.parent
    while above is not None and above.type not in _BLOCKS:
        above = None if above.type in _KINDS or above.type == "ERROR" else above.parent
    return end if above is None or above.has_error else above.end_byte


def body_of(definition: Node) -> Node | None:
    """Return the block of a function, or of the `try` that it is, None where it has none."""
    body = definition.child_by_field_name("body")
    if body is None and definition.type == "function_definition":
        parts = [each for each in definition.children if each.type == "try_statement"]
        body = parts[0].child_by_field_name("body") if parts else None
    return body


def statements_in(block: Node | None) -> list[Node]:
    """Return what a block has but for comments; nothing of None."""
    return (
        [] if block is None else [each for each in block.named_children if each.type != "comment"]
    )


@dataclass(slots=True, eq=False)
class Function:
    """A function or method that is declared or defined.

    Attributes:
        name: its name.
        qualifier: what stands before its name: `A` of `A::f`.
        node: its declaration or definition.
        declarator: its name with its parameters.
        scope: the scope of its body, None for a declaration.
        place: the scope that it is written in.
    """

    name: str
    qualifier: str
    node: Node
    declarator: Node
    scope: Scope | None
    place: Scope
    _parameters: list[Variable] | None = None

    @property
    def file(self) -> CppFile:
        """The file that it is in."""
        return self.place.file

    @property
    def parameters(self) -> list[Variable]:
        """Its parameters, also those without a name."""
        if self._parameters is None:
            listed = self.declarator.child_by_field_name("parameters")
            scope = self.scope or self.place
            self._parameters = list(_parameters(listed, scope)) if listed is not None else []
        return self._parameters

    @property
    def body(self) -> Node | None:
        """Its block, which may be that of a `try` that is the function's, None for none."""
        return body_of(self.node)

    @property
    def statements(self) -> list[Node]:
        """The statements of its block, none of a declaration; comments are no statements."""
        return statements_in(self.body)

    @property
    def returned(self) -> Node | None:
        """What it returns where it does nothing else."""
        body = self.body
        statements = body.named_children if body is not None else []
        if len(statements) != 1 or statements[0].type != "return_statement":
            return None
        inner = statements[0].named_children
        return inner[0] if inner else None

    @property
    def class_name(self) -> str:
        """The name of the class that it is a method of, "" for none."""
        if self.qualifier:
            return re.sub(r"<.*", "", self.qualifier).rpartition("::")[2]
        owner = self.place.enclosing("class")
        return owner.name if owner is not None and self.place.kind != "block" else ""

    @property
    def return_type(self) -> str:
        """What it returns, see `type_text`."""
        found = self.node.child_by_field_name("type")
        return "" if found is None else type_text(self.file.syntax.word(found))


@dataclass(slots=True, eq=False)
class Scope:
    """A part of a file that has names of its own.

    Attributes:
        file: the file.
        kind: `file`, `namespace`, `class`, `function`, `lambda`, `template` or `block`.
        name: the name of a namespace, class or function.
        node: its node.
        parent: the scope around it, None for a file.
        variables: its variables by name.
        aliases: what its names for types stand for.
        functions: the functions that are declared or defined in it.
        usings: the namespaces, and single names, that it takes the names of.
        bases: what a class derives from, see `type_text`.
        function: the function of the scope's body.
        template_names: the type parameters of a template.
    """

    file: CppFile
    kind: str
    name: str
    node: Node
    parent: Scope | None
    start: int
    end: int
    variables: dict[str, list[Variable]] = field(default_factory=dict)
    aliases: dict[str, str] = field(default_factory=dict)
    functions: dict[str, list[Function]] = field(default_factory=dict)
    usings: list[str] = field(default_factory=list)
    bases: tuple[str, ...] = ()
    function: Function | None = None
    template_names: tuple[str, ...] = ()

    def enclosing(self, *kinds: str) -> Scope | None:
        """Return the innermost scope of some kinds that this one is in, or is."""
        scope: Scope | None = self
        while scope is not None and scope.kind not in kinds:
            scope = scope.parent
        return scope

    @property
    def around(self) -> Function | None:
        """The function that it is in, which is that around a lambda, None for none."""
        scope = self.enclosing("function")
        return None if scope is None else scope.function

    @property
    def chain(self) -> Iterator[Scope]:
        """The scope and those around it, the innermost first."""
        scope: Scope | None = self
        while scope is not None:
            yield scope
            scope = scope.parent

    @property
    def qualified(self) -> str:
        """The full name of a namespace or class, such as `a::B`."""
        names = [each.name for each in self.chain if each.kind in ("namespace", "class")]
        return "::".join(name for name in reversed(names) if name)


@dataclass(slots=True, eq=False)
class CppFile:
    """A file of a unit, with its scopes.

    Attributes:
        name: its name in the set, "" for the main file.
        syntax: its text and tree.
        root: the scope of the whole file.
        scopes: all scopes, in the order of the text.
        calls: its calls, in the order of the text.
        assignments: what assigns, each with its scope.
        initializers: the initializers of constructors, each with its scope.
        news: the `new` expressions, each with its scope.
        is_beside: whether it is no part of the set, and only looked into.
    """

    name: str
    syntax: Syntax
    root: Scope = field(init=False)
    scopes: list[Scope] = field(default_factory=list)
    calls: list[Call] = field(default_factory=list)
    assignments: list[tuple[Node, Scope]] = field(default_factory=list)
    initializers: list[tuple[Node, Scope]] = field(default_factory=list)
    news: list[tuple[Node, Scope]] = field(default_factory=list)
    is_beside: bool = False

    def place_of(self, line: int) -> str:
        """Return how a message names a line, with the name of a file that is not the main one."""
        return f"{line} of `{self.name.rpartition('/')[2]}`" if self.name else f"{line}"


def scope_at(file: CppFile, offset: int) -> Scope:
    """Return the innermost scope that an offset is in."""
    found = file.root
    for scope in file.scopes:
        if scope.start > offset:
            break
        if offset < scope.end:
            found = scope
    return found


def _parameters(listed: Node, scope: Scope) -> Iterator[Variable]:
    for each in listed.named_children:
        if not each.type.endswith("parameter_declaration"):
            continue
        declarator = each.child_by_field_name("declarator")
        name, inner, _, pointer, reference = declared(declarator, scope.file.syntax)
        yield Variable(
            name,
            "parameter",
            each.child_by_field_name("type"),
            each,
            scope,
            each.start_byte,
            each.child_by_field_name("default_value"),
            None,
            inner,
            pointer,
            reference,
        )


def declared(
    declarator: Node | None, syntax: Syntax
) -> tuple[str, Node | None, Node | None, bool, bool]:
    """Return what a declarator declares.

    Returns its name, the node of that, the declarator of a function if it is one, whether it is a
    pointer, and whether it is a reference.
    """
    function = None
    pointer = reference = False
    for _ in range(16):
        if declarator is None:
            break
        kind = declarator.type
        if kind in ("identifier", "field_identifier", "type_identifier"):
            return syntax.word(declarator), declarator, function, pointer, reference
        if kind in (
            "qualified_identifier",
            "destructor_name",
            "operator_name",
            "template_function",
        ):
            return syntax.word(declarator), declarator, function, pointer, reference
        pointer = pointer or kind == "pointer_declarator"
        reference = reference or kind == "reference_declarator"
        if kind == "function_declarator":
            function = function or declarator
        inner = declarator.child_by_field_name("declarator")
        if inner is None:
            named = declarator.named_children
            inner = named[-1] if named and kind.endswith("declarator") else None
        declarator = inner
    return "", None, function, pointer, reference


def last_name(node: Node, scope: Scope) -> str:
    """Return the last name of `a`, `this->a`, `b.a`, "" for what is none."""
    if node.type == "field_expression":
        inner = node.child_by_field_name("field")
        node = inner if inner is not None else node
    if node.type in ("identifier", "field_identifier"):
        return scope.file.syntax.word(node)
    return ""
