"""Statements whose blocks hold nothing any more once others are gone."""

from __future__ import annotations

from collections.abc import Sequence

from tree_sitter import Node

from .analysis import Analysis
from .purity import doing_part, is_pure
from .references import identifiers, is_member, statement_of
from .syntax import nodes_in, parts_of

_CLAUSES = frozenset({"else_clause", "elif_clause", "finally_clause", "except_clause"})

# What a block of a loop may be in.
_BRANCHES = frozenset({"if_statement", "elif_clause", "else_clause", "block"})
_LEAVING = frozenset({"break_statement", "continue_statement", "pass_statement"})


def emptied_blocks(
    analysis: Analysis, gone: Sequence[Node], ranges: Sequence[tuple[int, int]] = ()
) -> list[Node]:
    """Return the statements, or their last clauses, that do nothing once others are gone.

    What may do something in deciding, as a call in a condition does, stays.

    Args:
        analysis: the file.
        gone: the statements that go.
        ranges: what else goes, from a start to an end.
    """
    found = _Emptied(analysis, gone, ranges)
    # Each block is asked once, however many of its statements go.
    pending = list({each.parent.id: each.parent for each in gone if each.parent}.values())
    while pending:
        block = pending.pop()
        owner = block.parent
        more = found.with_block(owner) if owner is not None and found.is_empty(block) else None
        more = more or found.idle_loop(block)
        if more is not None and not found.is_gone(more):
            found.add(more)
            if more.parent is not None:
                pending.append(more.parent)
    return found.statements


def leaves_pass(
    analysis: Analysis, statements: Sequence[Node], ranges: Sequence[tuple[int, int]]
) -> bool:
    """Whether a block that somebody wrote would hold a `pass` alone if statements went too."""
    found = _Emptied(analysis, statements, ranges)
    for each in emptied_blocks(analysis, statements, ranges):
        found.add(each)
    blocks = [each.parent for each in statements if each.parent is not None]
    return any(
        block.parent is not None
        and block.parent.type != "function_definition"
        and found.is_empty(block)
        and not found.is_gone(block.parent)
        for block in blocks
    )


def bare_conditions(analysis: Analysis, gone: Sequence[Node]) -> list[tuple[Node, Node]]:
    """Return the conditions whose one call has to be made, though nothing depends on it any more.

    Each is a statement, and the call in it.
    """
    found = _Emptied(analysis, gone, ())
    parents = {each.parent.id: each.parent for each in gone if each.parent is not None}
    listed = []
    for block in parents.values():
        statement = block.parent
        if statement is None or statement.type != "if_statement" or found.is_gone(statement):
            continue
        is_alone = not any(each.type in _CLAUSES for each in statement.named_children)
        condition = statement.child_by_field_name("condition")
        part = doing_part(analysis, condition) if condition is not None else None
        if is_alone and part is not None and found.is_empty(block):
            listed.append((statement, part))
    return listed


def _names_in(target: Node | None) -> list[Node]:
    ranges = [(target.start_byte, target.end_byte)] if target is not None else []
    root = target.parent if target is not None else None
    return [each for each in nodes_in(root, ranges) if each.type == "identifier"] if root else []


class _Emptied:
    """What is gone, and what goes with it."""

    def __init__(
        self, analysis: Analysis, gone: Sequence[Node], ranges: Sequence[tuple[int, int]]
    ) -> None:
        self._analysis = analysis
        self._ranges = [*ranges, *((each.start_byte, each.end_byte) for each in gone)]
        self.statements: list[Node] = []

    def add(self, statement: Node) -> None:
        """Let a statement go too."""
        self._ranges.append((statement.start_byte, statement.end_byte))
        self.statements.append(statement)

    def is_gone(self, node: Node) -> bool:
        """Whether a statement or a clause goes."""
        return any(start <= node.start_byte and node.end_byte <= end for start, end in self._ranges)

    def is_empty(self, block: Node | None) -> bool:
        """Whether all statements of a block are gone, or do nothing."""
        return block is not None and all(
            each.type == "pass_statement" or self.is_gone(each) for each in parts_of(block)
        )

    def with_block(self, owner: Node) -> Node | None:
        """Return what goes with an empty block of a statement, None where that keeps a `pass`."""
        statement = owner.parent if owner.type in _CLAUSES else owner
        if statement is None:
            return None
        clauses = [part for part in statement.named_children if part.type in _CLAUSES]
        match statement.type:
            case "if_statement":
                return self._of_condition(statement, clauses, owner)
            case "with_statement":
                items = parts_of(next(iter(parts_of(statement)), None))
                values = [item.child_by_field_name("value") for item in items]
                return statement if self._are_pure(values) else None
            case "for_statement":
                return statement if self._may_go(statement) else None
            case "try_statement":
                return self._of_try(statement, clauses, owner)
        return None

    def idle_loop(self, block: Node) -> Node | None:
        """Return the loop that does nothing but leave its turns, of which a block is a part."""
        while block.parent is not None and block.parent.type in _BRANCHES:
            block = block.parent
        loop = block.parent
        if loop is None or loop.type != "for_statement" or not self._may_go(loop):
            return None
        return loop if all(map(self._only_leaves, parts_of(block))) else None

    def _only_leaves(self, statement: Node) -> bool:
        """Whether a statement of a loop does nothing but end the turn, or the loop."""
        if self.is_gone(statement) or statement.type in _LEAVING:
            return True
        if statement.type != "if_statement":
            return False
        clauses = [part for part in statement.named_children if part.type in _CLAUSES]
        conditions = [each.child_by_field_name("condition") for each in (statement, *clauses)]
        blocks = [part for each in (statement, *clauses) for part in each.named_children]
        return self._are_pure([each for each in conditions if each is not None]) and all(
            self._only_leaves(each)
            for block in blocks
            if block.type == "block"
            for each in parts_of(block)
        )

    def _may_go(self, loop: Node) -> bool:
        """Whether a loop has no `else`, goes over what is there, and leaves its variable unused."""
        if any(part.type in _CLAUSES for part in loop.named_children):
            return False
        target, over = (loop.child_by_field_name(each) for each in ("left", "right"))
        return self._are_pure([over]) and not any(map(self._is_used_after, _names_in(target)))

    def _is_used_after(self, variable: Node) -> bool:
        """Whether the variable of a loop is used behind it as the loop has left it."""
        analysis, loop = self._analysis, statement_of(variable)
        name = analysis.syntax.slice(variable)
        holder = analysis.scopes.at(variable.start_byte).lookup(name)
        bound = [each.node for each in holder[1]] if holder is not None else []
        bound = [each for each in bound if each.start_byte >= loop.end_byte]
        for node in identifiers(name, analysis):
            if node.start_byte < loop.end_byte or is_member(node) or self.is_gone(node):
                continue
            if analysis.scopes.at(node.start_byte).lookup(name) != holder:
                continue
            if not any(each.start_byte <= node.start_byte for each in bound):
                return True
        return False

    def _of_condition(self, statement: Node, clauses: list[Node], owner: Node) -> Node | None:
        left = [each for each in clauses if not self.is_gone(each)]
        if all(map(self._decides_nothing, [statement, *left])):
            return statement
        # What the last branch does is no matter of the others.
        is_last = bool(left) and left[-1].id == owner.id
        return owner if is_last and self._decides_nothing(owner) else None

    def _of_try(self, statement: Node, clauses: list[Node], owner: Node) -> Node | None:
        kinds = [each.type for each in clauses]
        if owner.id == statement.id:
            others = [each for each in clauses if each.type != "except_clause"]
            return statement if all(map(self._decides_nothing, others)) else None
        is_last = owner.type == "finally_clause" and "except_clause" in kinds
        return owner if is_last or owner.type == "else_clause" else None

    def _decides_nothing(self, branch: Node) -> bool:
        condition = branch.child_by_field_name("condition")
        block = branch.child_by_field_name("consequence") or branch.child_by_field_name("body")
        block = block or next(iter(parts_of(branch)), None)
        return self.is_empty(block) and (condition is None or self._are_pure([condition]))

    def _are_pure(self, expressions: Sequence[Node | None]) -> bool:
        return all(each is not None and is_pure(self._analysis, each) for each in expressions)
