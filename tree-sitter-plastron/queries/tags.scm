; A node is what a program is made of, like a class; a message is a constant of its type.

(create_node_statement variable: (variable) @name) @definition.class
(load_statement variable: (variable) @name) @definition.class
(create_message_statement variable: (variable) @name) @definition.constant
(load_type_statement variable: (variable) @name) @definition.type
(create_message_type_statement type: (type name: (identifier) @name)) @definition.type
(create_service_type_statement type: (type name: (identifier) @name)) @definition.type
(create_action_type_statement type: (type name: (identifier) @name)) @definition.type
(create_package_statement variable: (variable) @name) @definition.module
(load_package_statement variable: (variable) @name) @definition.module
(create_launch_statement variable: (variable) @name) @definition.module
(load_launch_statement variable: (variable) @name) @definition.module
(create_robot_statement variable: (variable) @name) @definition.class
(load_robot_statement variable: (variable) @name) @definition.class
; The links and joints of a robot have names of their own, in quotes.
(has_link_statement link: (ros_name) @name) @definition.constant
(has_joint_statement joint: (ros_name) @name) @definition.constant

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
(has_field_statement type: (variable) @name) @reference.type
(no_longer_has_field_statement type: (variable) @name) @reference.type
(drop_type_statement type: (variable) @name) @reference.type
(generate_type_statement type: (variable) @name) @reference.type
(contains_statement package: (variable) @name) @reference.module
(contains_statement item: (variable) @name) @reference.class
(no_longer_contains_statement package: (variable) @name) @reference.module
(no_longer_contains_statement item: (variable) @name) @reference.class
(generate_package_statement package: (variable) @name) @reference.module
(has_argument_statement launch: (variable) @name) @reference.module
(no_longer_has_argument_statement launch: (variable) @name) @reference.module
(starts_statement launch: (variable) @name) @reference.module
(starts_statement started: (variable) @name) @reference.class
(no_longer_starts_statement launch: (variable) @name) @reference.module
(includes_statement launch: (variable) @name) @reference.module
(no_longer_includes_statement launch: (variable) @name) @reference.module
(generate_launch_statement launch: (variable) @name) @reference.module
(has_link_statement robot: (variable) @name) @reference.class
(no_longer_has_link_statement robot: (variable) @name) @reference.class
(has_joint_statement robot: (variable) @name) @reference.class
(no_longer_has_joint_statement robot: (variable) @name) @reference.class
(limits_joint_statement robot: (variable) @name) @reference.class
(generate_robot_statement robot: (variable) @name) @reference.class
(no_longer_has_link_statement link: (ros_name) @name) @reference.constant
(has_joint_statement parent: (ros_name) @name) @reference.constant
(has_joint_statement child: (ros_name) @name) @reference.constant
(has_joint_statement mimicked: (ros_name) @name) @reference.constant
(no_longer_has_joint_statement joint: (ros_name) @name) @reference.constant
(limits_joint_statement joint: (ros_name) @name) @reference.constant
