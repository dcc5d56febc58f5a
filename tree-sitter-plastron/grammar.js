/**
 * @file Plastron: an English-like language for ROS nodes
 * @license MIT
 */

/// <reference types="tree-sitter-cli/dsl" />
// @ts-check

// A newline is a token, not an extra: it always ends a statement, so that what is
// half typed on one line never swallows the next.

/** @param {RuleOrLiteral} rule */
const commaSep1 = rule => seq(rule, repeat(seq(',', rule)));

const KEYWORDS = [
  'create_node', 'load', 'create_message', 'subscribe', 'unsubscribe', 'publish',
  'stop_publishing', 'client_requests', 'stop_request', 'provides_service',
  'stop_service', 'generate_node',
  'as', 'using', 'of', 'message_type', 'service_type', 'and', 'with', 'input', 'none',
  'to', 'from', 'calling', 'at', 'hz', 'True', 'False',
];

module.exports = grammar({
  name: 'plastron',

  word: $ => $.identifier,

  extras: $ => [/[ \t\f\r\uFEFF]/, $.line_comment, $.block_comment],

  supertypes: $ => [$._statement, $._value],

  // A keyword is no variable. The field of a message may have any name, `to` and `from` included.
  reserved: {
    global: _ => KEYWORDS,
    field_name: _ => [],
  },

  rules: {
    // program = { [ statement ] newline } [ statement ]
    program: $ => seq(
      repeat(choice(seq($._statement, $._newline), $._newline)),
      optional($._statement),
    ),

    _newline: _ => /\r?\n/,

    _statement: $ => choice(
      $.create_node_statement,
      $.load_statement,
      $.create_message_statement,
      $.subscribe_statement,
      $.unsubscribe_statement,
      $.publish_statement,
      $.stop_publishing_statement,
      $.client_requests_statement,
      $.stop_request_statement,
      $.provides_service_statement,
      $.stop_service_statement,
      $.generate_node_statement,
    ),

    // "create_node" name "as" variable [ "using" client_library ]
    create_node_statement: $ => seq(
      'create_node', field('name', $.ros_name),
      'as', field('variable', $._variable),
      optional($._using),
    ),

    // "load" ( module | path ) "as" variable
    load_statement: $ => seq(
      'load', field('source', choice($._module, alias($.ros_name, $.path))),
      'as', field('variable', $._variable),
    ),

    // "create_message" variable "of" "message_type" type "and" "input" input
    create_message_statement: $ => seq(
      'create_message', field('variable', $._variable),
      $._of_message_type,
      'and', 'input', field('input', $._input),
    ),

    // "subscribe" variable "to" name "of" "message_type" type [ "calling" function ]
    subscribe_statement: $ => seq(
      'subscribe', field('node', $._variable),
      'to', field('topic', $.ros_name),
      $._of_message_type,
      optional($._calling),
    ),

    // "unsubscribe" variable "from" name
    unsubscribe_statement: $ => seq(
      'unsubscribe', field('node', $._variable),
      'from', field('topic', $.ros_name),
    ),

    // variable "publish" variable "to" name "of" "message_type" type [ "at" number "hz" ]
    publish_statement: $ => seq(
      field('node', $._variable),
      'publish', field('message', $._variable),
      'to', field('topic', $.ros_name),
      $._of_message_type,
      optional(seq('at', field('rate', $.number), 'hz')),
    ),

    // variable "stop_publishing" "to" name
    stop_publishing_statement: $ => seq(
      field('node', $._variable),
      'stop_publishing', 'to', field('topic', $.ros_name),
    ),

    // variable "client_requests" name "of" "service_type" type "with" "input" input
    client_requests_statement: $ => seq(
      field('node', $._variable),
      'client_requests', field('service', $.ros_name),
      $._of_service_type,
      'with', 'input', field('input', $._input),
    ),

    // variable "stop_request" name
    stop_request_statement: $ => seq(
      field('node', $._variable),
      'stop_request', field('service', $.ros_name),
    ),

    // variable "provides_service" name "of" "service_type" type [ "calling" function ]
    provides_service_statement: $ => seq(
      field('node', $._variable),
      'provides_service', field('service', $.ros_name),
      $._of_service_type,
      optional($._calling),
    ),

    // variable "stop_service" name
    stop_service_statement: $ => seq(
      field('node', $._variable),
      'stop_service', field('service', $.ros_name),
    ),

    // "generate_node" variable [ "using" client_library ]
    generate_node_statement: $ => seq(
      'generate_node', field('node', $._variable),
      optional($._using),
    ),

    _using: $ => seq('using', field('library', $._client_library)),
    _calling: $ => seq('calling', field('function', $._function)),
    _of_message_type: $ => seq('of', 'message_type', field('type', $.type)),
    _of_service_type: $ => seq('of', 'service_type', field('type', $.type)),

    // input = "none" | argument { "," argument }
    _input: $ => choice($.none, $.arguments),
    none: _ => 'none',
    arguments: $ => commaSep1(choice($._value, $.named_argument)),

    // named_argument = field { "." field } "=" value
    named_argument: $ => seq(field('field', $.field_path), '=', field('value', $._value)),
    field_path: $ => seq($._field_name, repeat(seq('.', $._field_name))),
    _field_name: $ => alias(reserved('field_name', $.identifier), $.field_name),

    _value: $ => choice($.number, $.string, $.boolean, $.list, $.nested),
    list: $ => seq('[', optional(commaSep1($._value)), ']'),
    // The values of a nested message, in the order of its fields or by name.
    nested: $ => seq('(', optional($.arguments), ')'),

    // type = [ package "/" [ "msg" | "srv" "/" ] ] name, with no space within
    type: $ => choice(
      field('name', $.identifier),
      seq(
        field('package', $.identifier),
        token.immediate('/'),
        optional(seq(field('kind', $.identifier), token.immediate('/'))),
        field('name', $.identifier),
      ),
    ),

    _variable: $ => alias($.identifier, $.variable),
    _module: $ => alias($.identifier, $.module),
    _function: $ => alias($.identifier, $.function),
    _client_library: $ => alias($.identifier, $.client_library),

    // Which names ROS takes is for its own rules to say; here, whatever stands between the quotes.
    ros_name: _ => /'[^'\r\n]*'/,

    string: $ => seq(
      '"',
      repeat(choice(alias($._string_content, $.string_content), $.escape_sequence)),
      token.immediate('"'),
    ),
    _string_content: _ => token.immediate(prec(1, /[^"\\\r\n]+/)),
    escape_sequence: _ => token.immediate(prec(1, /\\(["\\nt]|u[0-9A-Fa-f]{4})/)),

    number: _ => /[+-]?(\d+(\.\d*)?|\.\d+)([eE][+-]?\d+)?/,
    boolean: _ => choice('True', 'False'),

    // A variable starts with a letter; a function may start with an underscore.
    identifier: _ => /[A-Za-z_][A-Za-z0-9_]*/,

    line_comment: _ => token(/\/\/[^\n]*/),
    block_comment: _ => token(seq('/*', /[^*]*\*+([^/*][^*]*\*+)*/, '/')),
  },
});
