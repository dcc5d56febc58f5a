; What the reader asks of a Python file: names that are bound, calls, and the scopes around them.
; Which of the calls create an endpoint is data of the client library (calls.py).

(class_definition) @class
(function_definition) @function
(decorated_definition) @decorated
(lambda) @lambda
[
  (list_comprehension)
  (set_comprehension)
  (dictionary_comprehension)
  (generator_expression)
] @comprehension

(call) @call

(import_statement) @import
(import_from_statement) @import_from

(assignment) @assignment
(augmented_assignment) @augmented
(named_expression) @walrus
(for_statement) @loop
(while_statement) @while
(for_in_clause) @loop
(as_pattern) @as
(case_pattern) @case
(global_statement) @global
(nonlocal_statement) @global

(ERROR) @error
