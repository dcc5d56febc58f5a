; What has names of its own.
(namespace_definition) @scope
; Those without a body are left out by who reads this: a query of nodes alone is made faster.
(class_specifier) @scope
(struct_specifier) @scope
(function_definition) @scope
(lambda_expression) @scope
(compound_statement) @scope
(for_statement) @scope
(for_range_loop) @scope
(while_statement) @scope
(do_statement) @scope
(if_statement) @scope
(template_declaration) @scope

; What binds names.
(declaration) @declaration
(field_declaration) @declaration
(for_range_loop) @loop
(alias_declaration) @alias
(type_definition) @alias
(namespace_alias_definition) @alias
(using_declaration) @using
(enumerator) @enumerator

; What is done with them.
(assignment_expression) @assignment
(field_initializer) @initializer
(call_expression) @call
(new_expression) @new
