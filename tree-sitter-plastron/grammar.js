/**
 * @file Plastron: an English-like language for ROS nodes
 * @license MIT
 */

/// <reference types="tree-sitter-cli/dsl" />
// @ts-check

// A line is a statement, and stays one while it is half typed. Three things make sure of that:
//
// - The newline is a token, not an extra: it always ends the statement.
// - A statement may end early, after any part of it, with a stop. If the line is over, the stop is
//   the MISSING node `incomplete`: it stands in no text, the parser adds it. So a line that ends too
//   early costs the parser less than to look for the rest of it in the next one.
// - If the line goes on with a word that does not fit, the parser makes that word an ERROR, the
//   scanner hands it the empty `_cut`, and what follows on the line is `skipped`, which takes
//   anything. So there is one mistake a line, and none reaches over the end of its line.
//
// No statement lacks a part without an error in it. A statement that is whole may have the ERROR
// beside it, on the same line.

const KEYWORDS = [
  'create_node', 'load', 'create_message', 'subscribe', 'unsubscribe', 'publish',
  'stop_publishing', 'client_requests', 'stop_request', 'provides_service',
  'stop_service', 'generate_node',
  'as', 'using', 'of', 'message_type', 'service_type', 'and', 'with', 'input', 'none',
  'to', 'from', 'calling', 'at', 'hz', 'True', 'False',
];

/** @param {RuleOrLiteral} rule */
const commaSep1 = rule => seq(rule, repeat(seq(',', rule)));

/**
 * A list that breaks off after a comma, or within an item.
 * @param {RuleOrLiteral} rule
 * @param {RuleOrLiteral} unfinishedRule
 */
const unfinishedCommaSep1 = (rule, unfinishedRule) => choice(
  unfinishedRule,
  seq(rule, repeat(seq(',', rule)), ',', optional(unfinishedRule)),
);

/**
 * A part that may itself break off.
 * @param {RuleOrLiteral} whole
 * @param {RuleOrLiteral} unfinished
 */
const part = (whole, unfinished) => ({ whole, unfinished });

const whole = list => list.map(item => item.whole ?? item);

/** The parts, broken off before their end; null where nothing can be missing. */
function broken([first, ...rest]) {
  const begun = first.unfinished ? [first.unfinished] : [];
  if (rest.length) {
    const more = broken(rest);
    const start = first.whole ?? first;
    begun.push(more ? seq(start, optional(more)) : start);
  }
  if (begun.length) return begun.length > 1 ? choice(...begun) : begun[0];
  return null;
}

/**
 * A statement of these parts, and after them of those in `tail`, all or none of them.
 * @param {GrammarSymbols<string>} $
 */
function statement($, parts, tail = []) {
  const cut = tail.length ? broken(tail) : null;
  const all = seq(...whole(parts), ...(tail.length ? [optional(seq(...whole(tail)))] : []));
  const beyond = cut ? seq(all, optional(cut)) : all;
  const before = broken(parts);
  return choice(all, seq(before ? choice(before, beyond) : beyond, $._stop));
}

/**
 * A statement that begins with a node. Of the node alone nobody can say which statement it begins.
 * @param {GrammarSymbols<string>} $
 */
function nodeStatement($, parts, tail = []) {
  const node = variable($, 'node');
  const [keyword, ...rest] = parts;
  return statement($, [seq(node, keyword), ...rest], tail);
}

const variable = ($, name) => field(name, alias($.identifier, $.variable));
const type = $ => part(field('type', $.type), field('type', alias($._unfinished_type, $.type)));
// input = "none" | argument { "," argument }
const input = $ => part(
  field('input', choice($.none, $.arguments)),
  field('input', alias($._unfinished_arguments, $.arguments)),
);

// Parts that several statements have. Each is a rule, so that a word too many after one is the
// mistake, and not the word that the part ends with.
const PHRASES = {
  as_variable: $ => ['as', variable($, 'variable')],
  using: $ => ['using', field('library', alias($.identifier, $.client_library))],
  calling: $ => ['calling', field('function', alias($.identifier, $.function))],
  of_message_type: $ => ['of', 'message_type', type($)],
  of_service_type: $ => ['of', 'service_type', type($)],
  at_rate: $ => ['at', field('rate', $.number), 'hz'],
};

/** The rules of the phrases: `_NAME`, and `_broken_NAME` for one that ends early. */
function phraseRules() {
  const rules = {};
  for (const [name, parts] of Object.entries(PHRASES)) {
    rules[`_${name}`] = $ => seq(...whole(parts($)));
    rules[`_broken_${name}`] = $ => broken(parts($));
  }
  return rules;
}

const phrase = ($, name) => part($[`_${name}`], $[`_broken_${name}`]);

module.exports = grammar({
  name: 'plastron',

  word: $ => $.identifier,

  extras: $ => [/[ \t\f\r\uFEFF]/, $.line_comment, $.block_comment],

  externals: $ => [
    $._newline,
    // The end of a line that is not finished. It is empty: the newline itself is in no error.
    '\n',
    // The quote that begins a string.
    $._quote,
    $.string_content,
    $.block_comment,
    // What follows is an error wherever it stands, but taken as a whole.
    // "text" where no string may stand
    $.quoted,
    // From a quote to the end of the line.
    $.unclosed_quote,
    // Characters that begin no word.
    $.unexpected,
    // From `/*` to the end of the line, where no `*/` follows anywhere.
    $.unclosed_comment,
    // What stands in no text, see above.
    $.incomplete,
    $._cut,
    // In no rule: valid only after an error, and with them the scanner remembers that there was one.
    // The one for an early end is visible: it makes an error dearer than to add something MISSING.
    $._skipping,
    'skipping',
  ],

  supertypes: $ => [$._statement, $._value],

  // A keyword is no variable. The field of a message may have any name, `to` and `from` included.
  reserved: {
    global: _ => KEYWORDS,
    field_name: _ => [],
  },

  rules: {
    // program = { [ statement ] newline } [ statement ]
    program: $ => seq(
      // The last choice never comes true: the scanner does not end a finished line like that. But
      // the parser adds something MISSING only before a token that may come after it.
      repeat(choice($._newline, seq($._line, choice($._newline, '\n')))),
      optional($._line),
    ),
    _line: $ => choice(
      $._statement,
      $.unknown_statement,
      // What follows a first word that begins no statement.
      seq($._cut, optional($.skipped)),
    ),

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
      $.rename_statement,
      $.generate_node_statement,
    ),

    // "create_node" name "as" variable [ "using" client_library ]
    create_node_statement: $ => statement(
      $,
      ['create_node', field('name', $.ros_name), phrase($, 'as_variable')],
      [phrase($, 'using')],
    ),

    // "load" ( module | path ) [ "node" name ] "as" variable
    load_statement: $ => statement($, [
      'load',
      field('source', choice(alias($.identifier, $.module), alias($.ros_name, $.path))),
      part(
        seq(optional(seq('node', field('name', $.ros_name))), $._as_variable),
        choice(
          seq('node', optional(field('name', $.ros_name))),
          seq(optional(seq('node', field('name', $.ros_name))), $._broken_as_variable),
        ),
      ),
    ]),

    // "create_message" variable "of" "message_type" type "and" "input" input
    create_message_statement: $ => statement($, [
      'create_message', variable($, 'variable'), phrase($, 'of_message_type'), 'and', 'input', input($),
    ]),

    // "subscribe" variable "to" name "of" "message_type" type [ "calling" function ]
    subscribe_statement: $ => statement(
      $,
      ['subscribe', variable($, 'node'), 'to', field('topic', $.ros_name), phrase($, 'of_message_type')],
      [phrase($, 'calling')],
    ),

    // "unsubscribe" variable "from" name
    unsubscribe_statement: $ => statement($, [
      'unsubscribe', variable($, 'node'), 'from', field('topic', $.ros_name),
    ]),

    // variable "publish" variable "to" name "of" "message_type" type [ "at" number "hz" ]
    publish_statement: $ => nodeStatement(
      $,
      [
        'publish', variable($, 'message'),
        'to', field('topic', $.ros_name), phrase($, 'of_message_type'),
      ],
      [phrase($, 'at_rate')],
    ),

    // variable "stop_publishing" "to" name
    stop_publishing_statement: $ => nodeStatement($, [
      'stop_publishing', 'to', field('topic', $.ros_name),
    ]),

    // variable "client_requests" name "of" "service_type" type "with" "input" input
    client_requests_statement: $ => nodeStatement($, [
      'client_requests', field('service', $.ros_name),
      phrase($, 'of_service_type'), 'with', 'input', input($),
    ]),

    // variable "stop_request" name
    stop_request_statement: $ => nodeStatement($, [
      'stop_request', field('service', $.ros_name),
    ]),

    // variable "provides_service" name "of" "service_type" type [ "calling" function ]
    provides_service_statement: $ => nodeStatement(
      $,
      [
        'provides_service', field('service', $.ros_name),
        phrase($, 'of_service_type'),
      ],
      [phrase($, 'calling')],
    ),

    // variable "stop_service" name
    stop_service_statement: $ => nodeStatement($, [
      'stop_service', field('service', $.ros_name),
    ]),

    // variable "renames" kind name "to" name
    rename_statement: $ => nodeStatement($, [
      'renames', field('what', alias($.identifier, $.name_kind)),
      field('old', $.ros_name), 'to', field('new', $.ros_name),
    ]),

    // "generate_node" variable [ "using" client_library ]
    generate_node_statement: $ => statement(
      $,
      ['generate_node', variable($, 'node')],
      [phrase($, 'using')],
    ),

    ...phraseRules(),

    _stop: $ => choice($.incomplete, seq($._cut, optional($.skipped))),

    skipped: $ => repeat1(choice(
      $.identifier, $.number, $.ros_name, ...KEYWORDS,
      ',', '.', '=', '(', ')', '[', ']', token.immediate('/'),
      $.quoted, $.unclosed_quote, $.unexpected, $.unclosed_comment,
    )),

    // A node, and after it no word that says what it does.
    unknown_statement: $ => seq(variable($, 'node'), choice(
      $._stop,
      // A word that might be misspelt; the parser would take it for the begin of another statement.
      seq(field('keyword', $.identifier), optional($.skipped), choice($.incomplete, $._cut)),
    )),

    none: _ => prec(1, 'none'),
    arguments: $ => commaSep1(choice($._value, $.named_argument)),
    _unfinished_arguments: $ => unfinishedCommaSep1(
      choice($._value, $.named_argument),
      choice($._unfinished_value, alias($._unfinished_named_argument, $.named_argument)),
    ),

    // named_argument = field { "." field } "=" value
    named_argument: $ => seq(field('field', $.field_path), '=', field('value', $._value)),
    _unfinished_named_argument: $ => choice(
      field('field', alias($._unfinished_path, $.field_path)),
      seq(
        field('field', $.field_path),
        optional(seq('=', optional(field('value', $._unfinished_value)))),
      ),
    ),
    field_path: $ => seq($._field_name, repeat(seq('.', $._field_name))),
    _unfinished_path: $ => seq($._field_name, repeat(seq('.', $._field_name)), '.'),
    _field_name: $ => choice(
      alias(reserved('field_name', $.identifier), $.field_name),
      // Where these words begin a value or an input, they are words of the language first.
      alias(choice('none', 'True', 'False'), $.field_name),
    ),

    _value: $ => choice($.number, $.string, $.boolean, $.list, $.nested),
    _unfinished_value: $ => choice(
      alias($._unfinished_string, $.string),
      alias($._unfinished_list, $.list),
      alias($._unfinished_nested, $.nested),
    ),

    list: $ => seq('[', optional(commaSep1($._value)), ']'),
    _unfinished_list: $ => seq('[', optional(choice(
      commaSep1($._value),
      unfinishedCommaSep1($._value, $._unfinished_value),
    ))),

    // The values of a nested message, in the order of its fields or by name.
    nested: $ => seq('(', optional($.arguments), ')'),
    _unfinished_nested: $ => seq('(', optional(choice(
      $.arguments,
      alias($._unfinished_arguments, $.arguments),
    ))),

    // type = [ package "/" [ "msg" | "srv" "/" ] ] name, with no space within
    type: $ => choice(
      field('name', $.identifier),
      seq(
        field('package', $.identifier),
        token.immediate('/'),
        optional(seq(field('kind', $._rest_of_type), token.immediate('/'))),
        field('name', $._rest_of_type),
      ),
    ),
    _unfinished_type: $ => seq(
      field('package', $.identifier),
      token.immediate('/'),
      optional(seq(field('kind', $._rest_of_type), token.immediate('/'))),
    ),
    _rest_of_type: $ => alias(token.immediate(/[A-Za-z_][A-Za-z0-9_]*/), $.identifier),

    // Which names ROS takes is for its own rules to say; here, whatever stands between the quotes.
    ros_name: _ => /'[^'\r\n]*'/,

    string: $ => seq(
      alias($._quote, '"'),
      repeat(choice($.string_content, $.escape_sequence)),
      token.immediate('"'),
    ),
    _unfinished_string: $ => seq(alias($._quote, '"'), repeat(choice($.string_content, $.escape_sequence))),
    escape_sequence: _ => token.immediate(/\\(["\\nt]|u[0-9A-Fa-f]{4})/),

    number: _ => /[+-]?(\d+(\.\d*)?|\.\d+)([eE][+-]?\d+)?/,
    boolean: _ => prec(1, choice('True', 'False')),

    // A variable starts with a letter; a function may start with an underscore.
    identifier: _ => /[A-Za-z_][A-Za-z0-9_]*/,

    // A carriage return before the newline is no part of the comment.
    line_comment: _ => token(/\/\/([^\r\n]|\r[^\r\n])*/),
  },
});
