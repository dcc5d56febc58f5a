; What tells how a file breaks its calls.

(call
  arguments: (argument_list) @arguments)
