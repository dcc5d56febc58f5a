; What tells how a file breaks its calls, and the heads of its functions.

(call
  arguments: (argument_list) @arguments)

(function_definition
  parameters: (parameters) @parameters)
