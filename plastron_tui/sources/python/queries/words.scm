; What comparing two texts of a file looks at.

(function_definition
  name: (identifier) @definition)

(identifier) @identifier
