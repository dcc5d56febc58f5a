[
  "create_node" "load" "create_message" "subscribe" "unsubscribe" "publish"
  "stop_publishing" "client_requests" "stop_request" "provides_service"
  "stop_service" "generate_node"
] @keyword.function

[
  "as" "using" "of" "message_type" "service_type" "and" "with" "input"
  "to" "from" "calling" "at" "hz"
] @keyword

(none) @constant.builtin
(boolean) @boolean
(number) @number
(string_content) @string
["\""] @string
(escape_sequence) @string.escape
(ros_name) @string.special
(path) @string.special.path
(variable) @variable
(module) @module
(function) @function
(client_library) @module
(type name: (identifier) @type)
(type package: (identifier) @module)
(type kind: (identifier) @module)
(field_name) @property
["=" ] @operator
["," "." "/"] @punctuation.delimiter
["(" ")" "[" "]"] @punctuation.bracket
[(line_comment) (block_comment)] @comment
