; A statement is a line and begins at its start; in a comment of several lines a new line begins
; where the one before it does.

(program (_) @indent.zero)
(block_comment) @indent.auto
