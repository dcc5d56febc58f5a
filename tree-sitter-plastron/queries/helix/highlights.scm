; The patterns of ../highlights.scm under the names that Helix's themes have; a test compares them.

[
  "create_node" "load" "create_message" "subscribe" "unsubscribe" "publish"
  "stop_publishing" "client_requests" "stop_request" "provides_service"
  "stop_service" "provides_action" "stop_action" "sends_goal" "stop_goal"
  "has_parameter" "no_longer_has_parameter" "repeats" "stop_repeating"
  "renames" "generate_node"
  "create_message_type" "create_service_type" "create_action_type" "load_type" "has_field"
  "no_longer_has_field" "drop_type" "generate_type"
  "create_package" "load_package" "contains" "no_longer_contains" "generate_package"
  "create_launch" "load_launch" "has_argument" "no_longer_has_argument" "starts"
  "no_longer_starts" "includes" "no_longer_includes" "generate_launch"
  "create_robot" "load_robot" "has_link" "no_longer_has_link" "has_joint" "no_longer_has_joint"
  "limits_joint" "generate_robot"
] @keyword.function

[
  "as" "using" "of" "message_type" "service_type" "action_type" "parameter_type"
  "and" "with" "input" "to" "from" "calling" "at" "hz" "node" "qos" "for_each"
  "when" "any" "all" "answering" "default" "between" "described_as" "parameter"
  "returning" "reporting" "maintained_by" "licensed_under" "in" "inside" "remapping" "setting"
  "parameters" "shaped" "weighing" "painted" "turned" "joint_type" "axis" "mimicking" "times"
  "effort" "velocity" "damping" "friction"
] @keyword
(flag) @keyword
; `received`, and after it the fields on the way.
(reference . (field_name) @keyword)
(reference "." . (field_name) @variable.other.member)

(none) @constant.builtin
(boolean) @constant.builtin.boolean
(number) @constant.numeric

(string "\"" @string)
(string_content) @string
(escape_sequence) @constant.character.escape
(quoted) @string
(unclosed_quote) @string
(ros_name) @string.special
(path) @string.special.path

(variable) @variable
(field_path (field_name) @variable.other.member)
(qos_policy policy: (identifier) @constant.builtin)
(parameter_type) @type.builtin
(function) @function
(module) @namespace
(client_library) @namespace
(name_kind) @type.builtin
(section) @type.builtin
(shape) @type.builtin
(joint_type) @type.builtin
(color) @variable.other.member
(unit) @type.builtin
(definition name: (field_name) @variable.other.member)
(type package: (identifier) @namespace)
(type kind: (identifier) @namespace)
(type name: (identifier) @type)

["=" "<=" (operator) (comparison)] @operator
["," "." "/"] @punctuation.delimiter
["(" ")" "[" "]"] @punctuation.bracket

[(line_comment) (block_comment) (unclosed_comment)] @comment
