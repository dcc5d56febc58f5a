; What comparing two texts of a file looks at.

(function_definition
  name: (identifier) @definition)

(identifier) @identifier

[
  (import_statement)
  (import_from_statement)
  (future_import_statement)
] @import
