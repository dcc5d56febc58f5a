/*
 * The parser for programs that know the parsers of tree-sitter up to version 14 of their interface,
 * such as Neovim 0.10 and Helix 25.01: the tables of ../../src/parser.c, of version 15, in the layout
 * of version 14. That lacks what came later, of which one thing is used: that a line's first word
 * cannot be a variable if it is a keyword. So a wrong line may have its error elsewhere.
 */

#define tree_sitter_plastron newer_tree_sitter_plastron
#include "../../src/parser.c"
#undef tree_sitter_plastron

/* As the generator writes it for version 14: without the set of reserved words. */
static TSLexMode lex_modes[STATE_COUNT];
static TSLanguage language;

/* When the library is loaded, so that no thread sees it half done. */
__attribute__((constructor)) static void lay_out(void) {
  language = *newer_tree_sitter_plastron();
  for (unsigned state = 0; state < STATE_COUNT; state++) {
    lex_modes[state].lex_state = ts_lex_modes[state].lex_state;
    lex_modes[state].external_lex_state = ts_lex_modes[state].external_lex_state;
  }
  language.abi_version = 14;
  language.lex_modes = (const TSLexerMode *)lex_modes;
}

TS_PUBLIC const TSLanguage *tree_sitter_plastron(void);

TS_PUBLIC const TSLanguage *tree_sitter_plastron(void) {
  return &language;
}
