; A node is what a program is made of, like a class; a message is a constant of its type.

(create_node_statement variable: (variable) @name) @definition.class
(load_statement variable: (variable) @name) @definition.class
(create_message_statement variable: (variable) @name) @definition.constant

(subscribe_statement function: (function) @name) @reference.call
(provides_service_statement function: (function) @name) @reference.call
(provides_action_statement function: (function) @name) @reference.call
(repeats_statement function: (function) @name) @reference.call
(stop_repeating_statement function: (function) @name) @reference.call

(subscribe_statement node: (variable) @name) @reference.class
(unsubscribe_statement node: (variable) @name) @reference.class
(publish_statement node: (variable) @name) @reference.class
(stop_publishing_statement node: (variable) @name) @reference.class
(client_requests_statement node: (variable) @name) @reference.class
(stop_request_statement node: (variable) @name) @reference.class
(provides_service_statement node: (variable) @name) @reference.class
(stop_service_statement node: (variable) @name) @reference.class
(has_parameter_statement node: (variable) @name) @reference.class
(no_longer_has_parameter_statement node: (variable) @name) @reference.class
(repeats_statement node: (variable) @name) @reference.class
(stop_repeating_statement node: (variable) @name) @reference.class
(provides_action_statement node: (variable) @name) @reference.class
(stop_action_statement node: (variable) @name) @reference.class
(sends_goal_statement node: (variable) @name) @reference.class
(stop_goal_statement node: (variable) @name) @reference.class
(rename_statement node: (variable) @name) @reference.class
(generate_node_statement node: (variable) @name) @reference.class
(publish_statement message: (variable) @name) @reference.constant
(type name: (identifier) @name) @reference.type
