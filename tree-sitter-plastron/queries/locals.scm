; One scope and one namespace for nodes and messages. A `load` or a `create_` defines, all else refers.

(program) @local.scope

(create_node_statement variable: (variable) @local.definition)
(load_statement variable: (variable) @local.definition)
(create_message_statement variable: (variable) @local.definition)

(subscribe_statement node: (variable) @local.reference)
(unsubscribe_statement node: (variable) @local.reference)
(publish_statement node: (variable) @local.reference)
(publish_statement message: (variable) @local.reference)
(stop_publishing_statement node: (variable) @local.reference)
(client_requests_statement node: (variable) @local.reference)
(stop_request_statement node: (variable) @local.reference)
(provides_service_statement node: (variable) @local.reference)
(stop_service_statement node: (variable) @local.reference)
(has_parameter_statement node: (variable) @local.reference)
(no_longer_has_parameter_statement node: (variable) @local.reference)
(repeats_statement node: (variable) @local.reference)
(stop_repeating_statement node: (variable) @local.reference)
(provides_action_statement node: (variable) @local.reference)
(stop_action_statement node: (variable) @local.reference)
(sends_goal_statement node: (variable) @local.reference)
(stop_goal_statement node: (variable) @local.reference)
(rename_statement node: (variable) @local.reference)
(generate_node_statement node: (variable) @local.reference)
