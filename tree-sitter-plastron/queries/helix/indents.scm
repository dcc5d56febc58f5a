; A statement is a line and begins at its start; in a comment of several lines the text does not.

(block_comment) @indent
