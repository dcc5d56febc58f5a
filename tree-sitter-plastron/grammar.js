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
  'has_parameter', 'no_longer_has_parameter', 'stop_repeating', 'provides_action', 'stop_action',
  'sends_goal', 'stop_goal', 'parameter_type', 'action_type', 'for_each', 'described_as',
  'create_message_type', 'create_service_type', 'create_action_type', 'load_type', 'has_field',
  'no_longer_has_field', 'drop_type', 'generate_type',
  'create_package', 'load_package', 'no_longer_contains', 'generate_package', 'maintained_by',
  'licensed_under',
  'create_launch', 'load_launch', 'has_argument', 'no_longer_has_argument', 'no_longer_starts',
  'no_longer_includes', 'generate_launch',
  'create_robot', 'load_robot', 'has_link', 'no_longer_has_link', 'has_joint',
  'no_longer_has_joint', 'limits_joint', 'joint_type', 'generate_robot',
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

/** @param {RuleOrLiteral[]} list */
const oneOf = list => list.length > 1 ? choice(...list) : list[0];

/**
 * A statement of these parts, and after them any of these clauses, in any order. That none is there
 * twice is for lowering to say.
 * @param {GrammarSymbols<string>} $
 */
function statement($, parts, ...clauses) {
  const cut = clauses.map(clause => broken([clause])).filter(Boolean);
  const all = seq(...whole(parts), ...(clauses.length ? [repeat(oneOf(whole(clauses)))] : []));
  const beyond = cut.length ? seq(all, optional(oneOf(cut))) : all;
  const before = broken(parts);
  return choice(all, seq(before ? choice(before, beyond) : beyond, $._stop));
}

/**
 * A statement that begins with what it is about. Of that alone nobody can say which statement it
 * begins.
 * @param {GrammarSymbols<string>} $
 * @param {string} owner
 */
const ownerStatement = ($, owner, [keyword, ...rest], ...clauses) =>
  statement($, [seq(variable($, owner), keyword), ...rest], ...clauses);

const nodeStatement = ($, parts, ...clauses) => ownerStatement($, 'node', parts, ...clauses);

const variable = ($, name) => field(name, alias($.identifier, $.variable));
const quoted = ($, name) => field(name, $.ros_name);
const word = ($, name, as) => field(name, alias($.identifier, as));
/** A word that is there or not, and says all that its clause says. */
const flag = ($, name) => field(name, alias(name, $.flag));
/** A field whose rule has a form for what breaks off: `_unfinished_RULE`. */
const open = ($, name, rule, ...others) => part(
  field(name, choice(...others, $[rule])),
  field(name, alias($[`_unfinished_${rule}`], $[rule])),
);
// input = "none" | argument { "," argument }
const input = $ => open($, 'input', 'arguments', $.none);
// fields = "none" | definition { "," definition }
const fields = ($, name) => open($, name, 'definitions', $.none);
const text = ($, name) => part(
  field(name, $.string),
  field(name, alias($._unfinished_string, $.string)),
);
/** Something of the program by its variable, or something else by its name. */
const named = ($, name) => field(name, choice(alias($.identifier, $.variable), $.ros_name));

// Parts that several statements have. Each is a rule, so that a word too many after one is the
// mistake, and not the word that the part ends with.
const PHRASES = {
  as_variable: $ => ['as', variable($, 'variable')],
  using: $ => ['using', word($, 'library', $.client_library)],
  calling: $ => ['calling', word($, 'function', $.function)],
  of_message_type: $ => ['of', 'message_type', open($, 'type', 'type')],
  of_service_type: $ => ['of', 'service_type', open($, 'type', 'type')],
  of_action_type: $ => ['of', 'action_type', open($, 'type', 'type')],
  of_parameter_type: $ => ['of', 'parameter_type', word($, 'type', $.parameter_type)],
  with_input: $ => ['with', 'input', input($)],
  with_default: $ => ['with', 'default', part(field('default', $._value), field('default', $._broken_value))],
  with_qos: $ => ['with', 'qos', open($, 'qos', 'qos')],
  // rate = number | "parameter" name
  at_rate: $ => ['at', open($, 'rate', 'parameter', $.number), 'hz'],
  // "for_each" name [ "when" condition ]
  for_each: $ => ['for_each', part(
    seq(quoted($, 'trigger'), optional(seq('when', field('condition', $.condition)))),
    seq(quoted($, 'trigger'), 'when', optional(field('condition', alias($._unfinished_condition, $.condition)))),
  )],
  answering: $ => ['answering', open($, 'answer', 'arguments', $.none)],
  between: $ => ['between', field('minimum', $.number), 'and', field('maximum', $.number)],
  described_as: $ => ['described_as', text($, 'description')],
  maintained_by: $ => ['maintained_by', text($, 'maintainer')],
  licensed_under: $ => ['licensed_under', text($, 'license')],
  as_executable: $ => ['as', quoted($, 'executable')],
  as_name: $ => ['as', quoted($, 'name')],
  in_section: $ => ['in', word($, 'section', $.section)],
  in_namespace: $ => ['in', quoted($, 'namespace')],
  inside: $ => ['inside', quoted($, 'container')],
  remapping: $ => ['remapping', open($, 'remaps', 'remaps')],
  setting: $ => ['setting', open($, 'settings', 'settings')],
  with_parameters: $ => ['with', 'parameters', quoted($, 'parameters')],
  of_joint_type: $ => ['of', 'joint_type', word($, 'type', $.joint_type)],
  from_to: $ => ['from', quoted($, 'parent'), 'to', quoted($, 'child')],
  shaped: $ => ['shaped', word($, 'shape', $.shape), open($, 'size', 'arguments')],
  weighing: $ => ['weighing', field('weight', $.number)],
  painted: $ => ['painted', part(
    field('color', choice(alias($.identifier, $.color), $.string, $.none)),
    field('color', alias($._unfinished_string, $.string)),
  )],
  at_position: $ => ['at', open($, 'position', 'vector')],
  // rotation = number "," number "," number ( "deg" | "rad" )
  turned: $ => ['turned', open($, 'rotation', 'vector'), word($, 'unit', $.unit)],
  with_axis: $ => ['with', 'axis', open($, 'axis', 'vector')],
  // "mimicking" ( name [ "times" number ] | "none" )
  mimicking: $ => ['mimicking', part(
    choice(
      seq(quoted($, 'mimicked'), optional(seq('times', field('factor', $.number)))),
      field('mimicked', $.none),
    ),
    seq(quoted($, 'mimicked'), 'times'),
  )],
  between_in_unit: $ => [
    'between', field('minimum', $.number), 'and', field('maximum', $.number), word($, 'unit', $.unit),
  ],
  // "with" ( "effort" number "and" "velocity" number | "damping" number "and" "friction" number )
  with_two: $ => ['with', part(
    choice($._effort, $._damping),
    choice($._broken_effort, $._broken_damping),
  )],
  effort: $ => ['effort', field('effort', $.number), 'and', 'velocity', field('velocity', $.number)],
  damping: $ => ['damping', field('damping', $.number), 'and', 'friction', field('friction', $.number)],
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
    // `+`, `-`, `*`, `/` after what is calculated with: a `-` elsewhere is the sign of a number.
    $.operator,
    // `<`, `>`
    $.comparison,
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
      $.has_parameter_statement,
      $.no_longer_has_parameter_statement,
      $.repeats_statement,
      $.stop_repeating_statement,
      $.provides_action_statement,
      $.stop_action_statement,
      $.sends_goal_statement,
      $.stop_goal_statement,
      $.rename_statement,
      $.generate_node_statement,
      $.create_message_type_statement,
      $.create_service_type_statement,
      $.create_action_type_statement,
      $.load_type_statement,
      $.has_field_statement,
      $.no_longer_has_field_statement,
      $.drop_type_statement,
      $.generate_type_statement,
      $.create_package_statement,
      $.load_package_statement,
      $.contains_statement,
      $.no_longer_contains_statement,
      $.generate_package_statement,
      $.create_launch_statement,
      $.load_launch_statement,
      $.has_argument_statement,
      $.no_longer_has_argument_statement,
      $.starts_statement,
      $.no_longer_starts_statement,
      $.includes_statement,
      $.no_longer_includes_statement,
      $.generate_launch_statement,
      $.create_robot_statement,
      $.load_robot_statement,
      $.has_link_statement,
      $.no_longer_has_link_statement,
      $.has_joint_statement,
      $.no_longer_has_joint_statement,
      $.limits_joint_statement,
      $.generate_robot_statement,
    ),

    // "create_node" name "as" variable [ "managed" ] [ "using" client_library ]
    create_node_statement: $ => statement(
      $,
      ['create_node', quoted($, 'name'), phrase($, 'as_variable')],
      flag($, 'managed'), phrase($, 'using'),
    ),

    // "load" ( module | path ) [ "node" name ] "as" variable
    load_statement: $ => statement($, [
      'load',
      field('source', choice(alias($.identifier, $.module), alias($.ros_name, $.path))),
      part(
        seq(optional(seq('node', quoted($, 'name'))), $._as_variable),
        choice(
          seq('node', optional(quoted($, 'name'))),
          seq(optional(seq('node', quoted($, 'name'))), $._broken_as_variable),
        ),
      ),
    ]),

    // "create_message" variable "of" "message_type" type "and" "input" input
    create_message_statement: $ => statement($, [
      'create_message', variable($, 'variable'), phrase($, 'of_message_type'), 'and', 'input', input($),
    ]),

    // "subscribe" variable "to" name "of" "message_type" type [ "with" "qos" qos ] [ "calling" function ]
    subscribe_statement: $ => statement(
      $,
      ['subscribe', variable($, 'node'), 'to', quoted($, 'topic'), phrase($, 'of_message_type')],
      phrase($, 'with_qos'), phrase($, 'calling'),
    ),

    // "unsubscribe" variable "from" name
    unsubscribe_statement: $ => statement($, [
      'unsubscribe', variable($, 'node'), 'from', quoted($, 'topic'),
    ]),

    // variable "publish" variable "to" name "of" "message_type" type
    //   [ "at" rate "hz" | "once" | "for_each" name [ "when" condition ] ] [ "with" "qos" qos ]
    publish_statement: $ => nodeStatement(
      $,
      ['publish', variable($, 'message'), 'to', quoted($, 'topic'), phrase($, 'of_message_type')],
      phrase($, 'at_rate'), flag($, 'once'), phrase($, 'for_each'), phrase($, 'with_qos'),
    ),

    // variable "stop_publishing" "to" name
    stop_publishing_statement: $ => nodeStatement($, ['stop_publishing', 'to', quoted($, 'topic')]),

    // variable "client_requests" name "of" "service_type" type "with" "input" input [ "at" rate "hz" ]
    client_requests_statement: $ => nodeStatement(
      $,
      ['client_requests', quoted($, 'service'), phrase($, 'of_service_type'), phrase($, 'with_input')],
      phrase($, 'at_rate'),
    ),

    // variable "stop_request" name
    stop_request_statement: $ => nodeStatement($, ['stop_request', quoted($, 'service')]),

    // variable "provides_service" name "of" "service_type" type
    //   [ "answering" input ] [ "calling" function ]
    provides_service_statement: $ => nodeStatement(
      $,
      ['provides_service', quoted($, 'service'), phrase($, 'of_service_type')],
      phrase($, 'answering'), phrase($, 'calling'),
    ),

    // variable "stop_service" name
    stop_service_statement: $ => nodeStatement($, ['stop_service', quoted($, 'service')]),

    // variable "has_parameter" name "of" "parameter_type" parameter_type "with" "default" value
    //   [ "between" number "and" number ] [ "described_as" string ]
    has_parameter_statement: $ => nodeStatement(
      $,
      ['has_parameter', quoted($, 'parameter'), phrase($, 'of_parameter_type'), phrase($, 'with_default')],
      phrase($, 'between'), phrase($, 'described_as'),
    ),

    // variable "no_longer_has_parameter" name
    no_longer_has_parameter_statement: $ => nodeStatement($, [
      'no_longer_has_parameter', quoted($, 'parameter'),
    ]),

    // variable "repeats" function "at" rate "hz"
    repeats_statement: $ => nodeStatement($, [
      'repeats', word($, 'function', $.function), phrase($, 'at_rate'),
    ]),

    // variable "stop_repeating" function
    stop_repeating_statement: $ => nodeStatement($, [
      'stop_repeating', word($, 'function', $.function),
    ]),

    // variable "provides_action" name "of" "action_type" type [ "calling" function ]
    provides_action_statement: $ => nodeStatement(
      $,
      ['provides_action', quoted($, 'action'), phrase($, 'of_action_type')],
      phrase($, 'calling'),
    ),

    // variable "stop_action" name
    stop_action_statement: $ => nodeStatement($, ['stop_action', quoted($, 'action')]),

    // variable "sends_goal" "to" name "of" "action_type" type "with" "input" input
    sends_goal_statement: $ => nodeStatement($, [
      'sends_goal', 'to', quoted($, 'action'), phrase($, 'of_action_type'), phrase($, 'with_input'),
    ]),

    // variable "stop_goal" "to" name
    stop_goal_statement: $ => nodeStatement($, ['stop_goal', 'to', quoted($, 'action')]),

    // variable "renames" kind name "to" name
    rename_statement: $ => nodeStatement($, [
      'renames', word($, 'what', $.name_kind), quoted($, 'old'), 'to', quoted($, 'new'),
    ]),

    // "generate_node" variable [ "using" client_library ]
    generate_node_statement: $ => statement(
      $,
      ['generate_node', variable($, 'node')],
      phrase($, 'using'),
    ),

    // "create_message_type" type "with" fields
    create_message_type_statement: $ => statement($, [
      'create_message_type', open($, 'type', 'type'), 'with', fields($, 'fields'),
    ]),

    // "create_service_type" type "with" fields "returning" fields
    create_service_type_statement: $ => statement($, [
      'create_service_type', open($, 'type', 'type'), 'with', fields($, 'request'),
      'returning', fields($, 'response'),
    ]),

    // "create_action_type" type "with" fields "returning" fields "reporting" fields
    create_action_type_statement: $ => statement($, [
      'create_action_type', open($, 'type', 'type'), 'with', fields($, 'goal'),
      'returning', fields($, 'result'), 'reporting', fields($, 'feedback'),
    ]),

    // "load_type" name "as" variable
    load_type_statement: $ => statement($, [
      'load_type', quoted($, 'source'), phrase($, 'as_variable'),
    ]),

    // variable "has_field" string [ "in" section ]
    has_field_statement: $ => ownerStatement(
      $,
      'type',
      ['has_field', text($, 'definition')],
      phrase($, 'in_section'),
    ),

    // variable "no_longer_has_field" name [ "in" section ]
    no_longer_has_field_statement: $ => ownerStatement(
      $,
      'type',
      ['no_longer_has_field', quoted($, 'field')],
      phrase($, 'in_section'),
    ),

    // "drop_type" variable
    drop_type_statement: $ => statement($, ['drop_type', variable($, 'type')]),

    // "generate_type" variable
    generate_type_statement: $ => statement($, ['generate_type', variable($, 'type')]),

    // "create_package" name "as" variable
    //   [ "described_as" string ] [ "maintained_by" string ] [ "licensed_under" string ]
    create_package_statement: $ => statement(
      $,
      ['create_package', quoted($, 'name'), phrase($, 'as_variable')],
      phrase($, 'described_as'), phrase($, 'maintained_by'), phrase($, 'licensed_under'),
    ),

    // "load_package" name "as" variable
    load_package_statement: $ => statement($, [
      'load_package', quoted($, 'source'), phrase($, 'as_variable'),
    ]),

    // variable "contains" variable [ "as" name ]
    contains_statement: $ => ownerStatement(
      $,
      'package',
      ['contains', variable($, 'item')],
      phrase($, 'as_executable'),
    ),

    // variable "no_longer_contains" ( variable | name )
    no_longer_contains_statement: $ => ownerStatement($, 'package', [
      'no_longer_contains', named($, 'item'),
    ]),

    // "generate_package" variable
    generate_package_statement: $ => statement($, ['generate_package', variable($, 'package')]),

    // "create_launch" name "as" variable
    create_launch_statement: $ => statement($, [
      'create_launch', quoted($, 'name'), phrase($, 'as_variable'),
    ]),

    // "load_launch" name "as" variable
    load_launch_statement: $ => statement($, [
      'load_launch', quoted($, 'source'), phrase($, 'as_variable'),
    ]),

    // variable "has_argument" name [ "with" "default" value ]
    has_argument_statement: $ => ownerStatement(
      $,
      'launch',
      ['has_argument', quoted($, 'argument')],
      phrase($, 'with_default'),
    ),

    // variable "no_longer_has_argument" name
    no_longer_has_argument_statement: $ => ownerStatement($, 'launch', [
      'no_longer_has_argument', quoted($, 'argument'),
    ]),

    // variable "starts" ( variable | name ) [ "as" name ] [ "in" name ] [ "inside" name ]
    //   [ "remapping" remaps ] [ "setting" settings ] [ "with" "parameters" name ]
    starts_statement: $ => ownerStatement(
      $,
      'launch',
      ['starts', named($, 'started')],
      phrase($, 'as_name'), phrase($, 'in_namespace'), phrase($, 'inside'),
      phrase($, 'remapping'), phrase($, 'setting'), phrase($, 'with_parameters'),
    ),

    // variable "no_longer_starts" name
    no_longer_starts_statement: $ => ownerStatement($, 'launch', [
      'no_longer_starts', quoted($, 'name'),
    ]),

    // variable "includes" name
    includes_statement: $ => ownerStatement($, 'launch', ['includes', quoted($, 'file')]),

    // variable "no_longer_includes" name
    no_longer_includes_statement: $ => ownerStatement($, 'launch', [
      'no_longer_includes', quoted($, 'file'),
    ]),

    // "generate_launch" variable
    generate_launch_statement: $ => statement($, ['generate_launch', variable($, 'launch')]),

    // "create_robot" name "as" variable
    create_robot_statement: $ => statement($, [
      'create_robot', quoted($, 'name'), phrase($, 'as_variable'),
    ]),

    // "load_robot" name "as" variable [ "setting" settings ]
    load_robot_statement: $ => statement(
      $,
      ['load_robot', quoted($, 'source'), phrase($, 'as_variable')],
      phrase($, 'setting'),
    ),

    // variable "has_link" name [ "shaped" shape input ] [ "weighing" number ]
    //   [ "painted" ( color | string | "none" ) ] [ "at" vector ] [ "turned" vector unit ]
    has_link_statement: $ => ownerStatement(
      $,
      'robot',
      ['has_link', quoted($, 'link')],
      phrase($, 'shaped'), phrase($, 'weighing'), phrase($, 'painted'),
      phrase($, 'at_position'), phrase($, 'turned'),
    ),

    // variable "no_longer_has_link" name
    no_longer_has_link_statement: $ => ownerStatement($, 'robot', [
      'no_longer_has_link', quoted($, 'link'),
    ]),

    // variable "has_joint" name [ "of" "joint_type" joint_type ] [ "from" name "to" name ]
    //   [ "at" vector ] [ "turned" vector unit ] [ "with" "axis" vector ]
    //   [ "mimicking" ( name [ "times" number ] | "none" ) ]
    has_joint_statement: $ => ownerStatement(
      $,
      'robot',
      ['has_joint', quoted($, 'joint')],
      phrase($, 'of_joint_type'), phrase($, 'from_to'),
      phrase($, 'at_position'), phrase($, 'turned'), phrase($, 'with_axis'), phrase($, 'mimicking'),
    ),

    // variable "no_longer_has_joint" name
    no_longer_has_joint_statement: $ => ownerStatement($, 'robot', [
      'no_longer_has_joint', quoted($, 'joint'),
    ]),

    // variable "limits_joint" name [ "between" number "and" number unit ]
    //   [ "with" "effort" number "and" "velocity" number ]
    //   [ "with" "damping" number "and" "friction" number ]
    limits_joint_statement: $ => ownerStatement(
      $,
      'robot',
      ['limits_joint', quoted($, 'joint')],
      phrase($, 'between_in_unit'), phrase($, 'with_two'),
    ),

    // "generate_robot" variable
    generate_robot_statement: $ => statement($, ['generate_robot', variable($, 'robot')]),

    ...phraseRules(),

    _stop: $ => choice($.incomplete, seq($._cut, optional($.skipped))),

    skipped: $ => repeat1(choice(
      $.identifier, $.number, $.ros_name, ...KEYWORDS,
      ',', '.', '=', '<=', '(', ')', '[', ']', token.immediate('/'),
      $.quoted, $.unclosed_quote, $.unexpected, $.unclosed_comment,
    )),

    // A node, and after it no word that says what it does.
    unknown_statement: $ => seq(variable($, 'node'), choice(
      $._stop,
      // A word that might be misspelt; the parser would take it for the begin of another statement.
      seq(field('keyword', $.identifier), optional($.skipped), choice($.incomplete, $._cut)),
    )),

    // qos = policy [ number ] { "," policy [ number ] }
    qos: $ => commaSep1($.qos_policy),
    _unfinished_qos: $ => seq($.qos_policy, repeat(seq(',', $.qos_policy)), ','),
    qos_policy: $ => seq(field('policy', $.identifier), optional(field('value', $.number))),

    definitions: $ => commaSep1($.definition),
    _unfinished_definitions: $ => unfinishedCommaSep1(
      $.definition,
      alias($._unfinished_definition, $.definition),
    ),
    // definition = definition_type name [ ( "=" | "default" ) value ]
    definition: $ => seq(
      field('type', $.definition_type),
      field('name', alias($._defined_name, $.field_name)),
      optional(seq(field('operator', choice('=', 'default')), field('value', $._value))),
    ),
    _unfinished_definition: $ => choice(
      field('type', choice(
        $.definition_type,
        alias($._unfinished_definition_type, $.definition_type),
      )),
      seq(
        field('type', $.definition_type),
        field('name', alias($._defined_name, $.field_name)),
        field('operator', choice('=', 'default')),
        optional(field('value', $._broken_value)),
      ),
    ),
    _defined_name: $ => reserved('field_name', $.identifier),
    // definition_type = type [ "<=" number ] [ "[" [ [ "<=" ] number ] "]" ]
    definition_type: $ => seq($.type, optional($._string_bound), optional($._array)),
    _unfinished_definition_type: $ => choice(
      alias($._unfinished_type, $.type),
      seq($.type, '<='),
      seq($.type, optional($._string_bound), $._unfinished_array),
    ),
    _string_bound: $ => seq('<=', field('bound', $.number)),
    _array: $ => seq('[', optional(seq(optional('<='), field('length', $.number))), ']'),
    _unfinished_array: $ => seq('[', optional(choice(
      '<=',
      seq(optional('<='), field('length', $.number)),
    ))),

    // remaps = name "to" name { "," name "to" name }
    remaps: $ => commaSep1($.remap),
    _unfinished_remaps: $ => unfinishedCommaSep1($.remap, alias($._unfinished_remap, $.remap)),
    remap: $ => seq(quoted($, 'old'), 'to', quoted($, 'new')),
    _unfinished_remap: $ => seq(quoted($, 'old'), optional('to')),

    // settings = name "=" value { "," name "=" value }
    settings: $ => commaSep1($.setting),
    _unfinished_settings: $ => unfinishedCommaSep1(
      $.setting,
      alias($._unfinished_setting, $.setting),
    ),
    setting: $ => seq(quoted($, 'parameter'), '=', field('value', $._value)),
    _unfinished_setting: $ => seq(
      quoted($, 'parameter'),
      optional(seq('=', optional(field('value', $._broken_value)))),
    ),

    // vector = number "," number "," number
    vector: $ => seq($.number, ',', $.number, ',', $.number),
    _unfinished_vector: $ => seq($.number, optional(seq(',', optional(seq($.number, optional(',')))))),

    // condition = [ "any" | "all" ] received ( "<" | ">" | "=" ) value
    condition: $ => seq(
      $._condition_start,
      field('operator', choice($.comparison, '=')),
      field('value', choice($.number, $.string, $.boolean)),
    ),
    _unfinished_condition: $ => choice(
      field('quantifier', choice('any', 'all')),
      seq(
        optional(field('quantifier', choice('any', 'all'))),
        field('received', choice(
          alias($._unfinished_reference, $.reference),
          alias($._unfinished_element, $.element),
        )),
      ),
      seq(
        $._condition_start,
        optional(seq(
          field('operator', choice($.comparison, '=')),
          optional(field('value', alias($._unfinished_string, $.string))),
        )),
      ),
    ),
    _condition_start: $ => seq(
      optional(field('quantifier', choice('any', 'all'))), field('received', $._received),
    ),

    none: _ => prec(1, 'none'),
    arguments: $ => commaSep1(choice($._value, $.named_argument)),
    _unfinished_arguments: $ => unfinishedCommaSep1(
      choice($._value, $.named_argument),
      choice($._unfinished_value, alias($._unfinished_named_argument, $.named_argument)),
    ),

    // named_argument = field { "." field } "=" value
    named_argument: $ => seq(
      field('field', choice($.field_path, alias($.reference, $.field_path))),
      '=',
      field('value', $._value),
    ),
    _unfinished_named_argument: $ => choice(
      field('field', alias($._unfinished_path, $.field_path)),
      seq(
        field('field', $.field_path),
        optional(seq('=', optional(field('value', $._broken_value)))),
      ),
      seq(field('field', alias($.reference, $.field_path)), '=', optional(field('value', $._broken_value))),
    ),
    field_path: $ => choice(seq($._first_name, repeat(seq('.', $._field_name))), $._source),
    _unfinished_path: $ => choice(
      seq($._first_name, repeat(seq('.', $._field_name)), '.'),
      $._reference_up_to_dot,
    ),
    _first_name: $ => choice(
      alias(reserved('field_name', $.identifier), $.field_name),
      // Where these words begin a value or an input, they are words of the language first.
      alias(choice('none', 'True', 'False', 'parameter'), $.field_name),
    ),
    _field_name: $ => choice(
      alias(reserved('field_name', $.identifier), $.field_name),
      alias(choice('none', 'True', 'False'), $.field_name),
    ),

    _value: $ => choice(
      $.number, $.string, $.boolean, $.list, $.nested, $.parameter, $._received, $.calculation,
    ),
    _unfinished_value: $ => choice(
      alias($._unfinished_string, $.string),
      alias($._unfinished_list, $.list),
      alias($._unfinished_nested, $.nested),
      alias($._unfinished_element, $.element),
      alias($._unfinished_calculation, $.calculation),
    ),
    // Where no field may be named.
    _broken_value: $ => choice(
      $._unfinished_value,
      alias($._unfinished_parameter, $.parameter),
      alias($._unfinished_reference, $.reference),
    ),

    list: $ => seq('[', optional(commaSep1($._value)), ']'),
    _unfinished_list: $ => seq('[', optional(choice(
      commaSep1($._value),
      unfinishedCommaSep1($._value, $._broken_value),
    ))),

    // The values of a nested message, in the order of its fields or by name.
    nested: $ => seq('(', optional($.arguments), ')'),
    _unfinished_nested: $ => seq('(', optional(choice(
      $.arguments,
      alias($._unfinished_arguments, $.arguments),
    ))),

    // parameter = "parameter" name
    parameter: $ => seq('parameter', field('name', $.ros_name)),
    _unfinished_parameter: _ => 'parameter',

    // received = reference [ "[" number "]" ]
    _received: $ => choice($.reference, $.element),
    // A field of what was received, reference = "received" "." field { "." field }; before a `=` it
    // is the way to a field that is named like that.
    reference: $ => seq($._source, repeat1(seq('.', $._field_name))),
    element: $ => seq(field('list', $.reference), '[', field('index', $.number), ']'),
    _source: $ => alias('received', $.field_name),
    _reference_up_to_dot: $ => seq($._source, repeat(seq('.', $._field_name)), '.'),
    _unfinished_reference: $ => choice($._source, $._reference_up_to_dot),
    _unfinished_element: $ => seq(field('list', $.reference), '[', optional(field('index', $.number))),

    // calculation = ( parameter | received ) operator operand { operator operand }
    // operand = number | parameter | received
    calculation: $ => seq($._calculated, repeat1(seq($.operator, $._operand))),
    _unfinished_calculation: $ => seq(
      $._calculated,
      repeat(seq($.operator, $._operand)),
      $.operator,
      optional(choice(
        alias($._unfinished_parameter, $.parameter),
        alias($._unfinished_reference, $.reference),
        alias($._unfinished_element, $.element),
      )),
    ),
    _operand: $ => choice($.number, $._calculated),
    _calculated: $ => choice($.parameter, $._received),

    // type = [ package "/" [ "msg" | "srv" | "action" "/" ] ] name, with no space within
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
