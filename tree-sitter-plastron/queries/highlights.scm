; No two patterns match one node: where captures overlap, editors disagree on which one wins.

[
  "create_node" "load" "create_message" "subscribe" "unsubscribe" "publish"
  "stop_publishing" "client_requests" "stop_request" "provides_service"
  "stop_service" "renames" "generate_node"
] @keyword.function

[
  "as" "using" "of" "message_type" "service_type" "and" "with" "input"
  "to" "from" "calling" "at" "hz" "node"
] @keyword

(none) @constant.builtin
(boolean) @boolean
(number) @number

(string "\"" @string)
(string_content) @string
(escape_sequence) @string.escape
(quoted) @string
(unclosed_quote) @string
(ros_name) @string.special
(path) @string.special.path

(variable) @variable
(field_name) @property
(function) @function
(module) @module
(client_library) @module
(name_kind) @type.builtin
(type package: (identifier) @module)
(type kind: (identifier) @module)
(type name: (identifier) @type)

"=" @operator
["," "." "/"] @punctuation.delimiter
["(" ")" "[" "]"] @punctuation.bracket

[(line_comment) (block_comment) (unclosed_comment)] @comment
