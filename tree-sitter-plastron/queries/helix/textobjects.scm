; A class is what is said of a thing, from where it is made or loaded to its last statement; an entry
; is a statement, a parameter is what is given to a message.

(
  [
    (create_node_statement) (load_statement)
  ] @class.around
  .
  (
    [(line_comment) (block_comment)]* .
    [
      (create_message_statement) (subscribe_statement) (unsubscribe_statement)
      (publish_statement) (stop_publishing_statement) (client_requests_statement)
      (stop_request_statement) (provides_service_statement) (stop_service_statement)
      (has_parameter_statement) (no_longer_has_parameter_statement) (repeats_statement)
      (stop_repeating_statement) (provides_action_statement) (stop_action_statement)
      (sends_goal_statement) (stop_goal_statement) (rename_statement)
      (generate_node_statement)
    ] @class.inside @class.around
  )+
)

(
  [
    (create_message_type_statement) (create_service_type_statement)
    (create_action_type_statement) (load_type_statement)
  ] @class.around
  .
  (
    [(line_comment) (block_comment)]* .
    [
      (has_field_statement) (no_longer_has_field_statement) (drop_type_statement)
      (generate_type_statement)
    ] @class.inside @class.around
  )+
)

(
  [
    (create_package_statement) (load_package_statement)
  ] @class.around
  .
  (
    [(line_comment) (block_comment)]* .
    [
      (contains_statement) (no_longer_contains_statement) (generate_package_statement)
    ] @class.inside @class.around
  )+
)

(
  [
    (create_launch_statement) (load_launch_statement)
  ] @class.around
  .
  (
    [(line_comment) (block_comment)]* .
    [
      (has_argument_statement) (no_longer_has_argument_statement) (starts_statement)
      (no_longer_starts_statement) (includes_statement) (no_longer_includes_statement)
      (generate_launch_statement)
    ] @class.inside @class.around
  )+
)

(
  [
    (create_robot_statement) (load_robot_statement)
  ] @class.around
  .
  (
    [(line_comment) (block_comment)]* .
    [
      (has_link_statement) (no_longer_has_link_statement) (has_joint_statement)
      (no_longer_has_joint_statement) (limits_joint_statement)
      (generate_robot_statement)
    ] @class.inside @class.around
  )+
)

(program (_) @entry.around)

(arguments (_) @parameter.inside)

(line_comment)+ @comment.around
(line_comment) @comment.inside
(block_comment) @comment.around
(block_comment) @comment.inside
