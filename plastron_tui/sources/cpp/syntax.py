"""A C++ file as bytes, and its syntax tree over exactly these offsets."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from pathlib import Path
from typing import ClassVar, NamedTuple

import tree_sitter_cpp
from tree_sitter import Node

from plastron_tui.sources.grammars import (
    AS_LETTERS,
    BoundedParser,
    Grammar,
    ParsedFile,
    count_errors,
    is_too_deep,
    wide_errors,
)
from plastron_tui.sources.text_memo import remembered

from .macros import join_macros, mask_macros
from .nesting import is_nested_too_deep
from .preprocessing import Define, Include, blank, preprocess


class Sought(NamedTuple):
    """What was found in the code of a file."""

    has: dict[re.Pattern[bytes], bool]
    matches: dict[re.Pattern[bytes], tuple[re.Match[bytes], ...]]
    fields: list[Node]


@dataclass(frozen=True, slots=True)
class Syntax(ParsedFile):
    """A parsed C++ file; `tree` is that of `code`.

    Attributes:
        code: the text that was parsed, of the same length: without comments, directives, and the
            macros that no parser sees through.
        includes: the includes of the file.
        defines: its macros without arguments.
        conditionals: where its conditionals start and end, as in `Preprocessed`.
        overrides_qos: whether it lets parameters change a quality of service.
        sought: what was looked for in it before: many units include one header.
    """

    grammar: ClassVar[Grammar] = Grammar(
        tree_sitter_cpp.language, Path(__file__).with_name("queries")
    )

    code: bytes
    includes: tuple[Include, ...]
    defines: tuple[Define, ...]
    conditionals: tuple[tuple[int, int], ...]
    overrides_qos: bool
    sought: Sought = field(default_factory=lambda: Sought({}, {}, []), compare=False, repr=False)

    def word(self, node: Node) -> str:
        """Return the source of a node that is a name, or a type without comments in it."""
        return self.code[node.start_byte : node.end_byte].decode(self.encoding, "replace")

    def has(self, pattern: re.Pattern[bytes]) -> bool:
        """Tell whether one of the patterns that are looked for in every file is in the code."""
        found = self.sought.has.get(pattern)
        if found is None:
            found = self.sought.has[pattern] = pattern.search(self.code) is not None
        return found

    def matches(self, pattern: re.Pattern[bytes]) -> tuple[re.Match[bytes], ...]:
        """Return where one of the patterns that are looked for in every file is in the code."""
        found = self.sought.matches.get(pattern)
        if found is None:
            found = self.sought.matches[pattern] = tuple(pattern.finditer(self.code))
        return found

    @property
    def field_expressions(self) -> list[Node]:
        """The expressions that name a member of something, `a.b` and `a->b`."""
        if not self.sought.fields:
            self.sought.fields.extend(self.captures("members").get("field", []))
        return self.sought.fields


@remembered
def parse(text: bytes) -> Syntax:
    """Parse a file, whatever its encoding, without moving an offset."""
    prepared = preprocess(text)
    code = prepared.code
    mask_macros(code)
    join_macros(code, prepared.defines, text)
    encoding = "utf-8"
    try:
        text.decode()
    except UnicodeDecodeError:
        encoding = "latin-1"
    parser = BoundedParser(Syntax.grammar.language())
    for _ in range(3):
        source = bytes(code)
        if is_nested_too_deep(source):
            tree = parser.given_up()
            break
        tree = parser.parse(source if encoding == "utf-8" else source.translate(AS_LETTERS))
        if is_too_deep(source, tree.root_node):
            tree = parser.given_up()
        wide = list(wide_errors(tree.root_node))
        if not wide:
            break
        for start, end in wide:
            blank(code, start, end)
    else:
        tree = parser.parse(b"")
    errors = count_errors(tree.root_node)
    overrides = b"QosOverridingOptions" in source or b"qos_overriding_options" in source
    includes, defines = prepared.includes, prepared.defines
    found = (includes, defines, prepared.conditionals, overrides)
    return Syntax(text, encoding, tree, errors, source, *found)
