; What names a member of something, and the lists of values that are handed on.
(field_expression) @field
