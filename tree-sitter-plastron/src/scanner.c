// What regular expressions cannot decide: how a line with a mistake ends (see the top of grammar.js),
// what is text within a string and what a comment, and which quotes and comments are not closed.

#include "tree_sitter/alloc.h"
#include "tree_sitter/parser.h"

// In the order of `externals` in grammar.js.
enum TokenType {
    NEWLINE,
    EARLY_END,
    QUOTE,
    STRING_CONTENT,
    BLOCK_COMMENT,
    QUOTED,
    UNCLOSED_QUOTE,
    UNEXPECTED,
    UNCLOSED_COMMENT,
    INCOMPLETE,
    CUT,
    SKIPPING,
    SKIPPING_END,
    OPERATOR,
    COMPARISON,
};

typedef struct {
    // This line ended before its statement did.
    bool ended_early;
    // The parser has skipped a word of this line.
    bool has_skipped;
    // The cut of this line is handed out.
    bool has_cut;
    // No `*/` follows: known from the first comment that lacks it, so that the rest of the text is
    // searched once, however many more there are.
    bool no_comment_end;
} Scanner;

void *tree_sitter_plastron_external_scanner_create(void) { return ts_calloc(1, sizeof(Scanner)); }

void tree_sitter_plastron_external_scanner_destroy(void *payload) { ts_free(payload); }

unsigned tree_sitter_plastron_external_scanner_serialize(void *payload, char *buffer) {
    const Scanner *scanner = payload;
    buffer[0] = (char)(scanner->has_skipped | scanner->has_cut << 1 |
                       scanner->no_comment_end << 2 | scanner->ended_early << 3);
    return 1;
}

void tree_sitter_plastron_external_scanner_deserialize(void *payload, const char *buffer, unsigned length) {
    Scanner *scanner = payload;
    const char state = length > 0 ? buffer[0] : 0;
    scanner->has_skipped = state & 1;
    scanner->has_cut = state >> 1 & 1;
    scanner->no_comment_end = state >> 2 & 1;
    scanner->ended_early = state >> 3 & 1;
}

static bool is_space(int32_t c) {
    return c == ' ' || c == '\t' || c == '\f' || c == '\r' || c == 0xFEFF;
}

static bool is_digit(int32_t c) { return c >= '0' && c <= '9'; }

static bool is_hexadecimal(int32_t c) {
    return is_digit(c) || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F');
}

static bool is_word(int32_t c) {
    return is_digit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

// Whether some token begins with the character, whatever may follow it.
static bool is_known(int32_t c) {
    switch (c) {
        case '\n': case '"': case '\'': case '/': case '+': case '-':
        case ',': case '.': case '=': case '(': case ')': case '[': case ']': case '<':
            return true;
        default:
            return is_space(c) || is_word(c);
    }
}

static bool at_line_end(const TSLexer *lexer) {
    return lexer->lookahead == '\n' || lexer->lookahead == '\r' || lexer->eof(lexer);
}

static bool finish(TSLexer *lexer, enum TokenType type) {
    lexer->mark_end(lexer);
    lexer->result_symbol = type;
    return true;
}

static bool scan_line_end(Scanner *scanner, TSLexer *lexer, const bool *valid) {
    if (!valid[NEWLINE] && valid[CUT]) {
        scanner->ended_early = true;
        return finish(lexer, EARLY_END);
    }
    if (lexer->eof(lexer)) return false;
    scanner->ended_early = false;
    scanner->has_skipped = false;
    scanner->has_cut = false;
    lexer->advance(lexer, false);
    return finish(lexer, NEWLINE);
}

// Stands before the `*` of a comment.
static bool scan_block_comment(Scanner *scanner, TSLexer *lexer) {
    bool first_line = true;
    lexer->advance(lexer, false);
    while (!lexer->eof(lexer)) {
        if (first_line && at_line_end(lexer)) {
            // How far the comment reaches if its end is missing.
            lexer->mark_end(lexer);
            first_line = false;
            if (scanner->no_comment_end) break;
        }
        const bool star = lexer->lookahead == '*';
        lexer->advance(lexer, false);
        if (star && lexer->lookahead == '/' && !scanner->no_comment_end) {
            lexer->advance(lexer, false);
            return finish(lexer, BLOCK_COMMENT);
        }
    }
    if (first_line) lexer->mark_end(lexer);
    scanner->no_comment_end = true;
    lexer->result_symbol = UNCLOSED_COMMENT;
    return true;
}

static bool scan_slash(Scanner *scanner, TSLexer *lexer, bool after_space, bool is_operator) {
    lexer->advance(lexer, false);
    if (lexer->lookahead == '*') return scan_block_comment(scanner, lexer);
    if (lexer->lookahead == '/') return false;
    if (is_operator) return finish(lexer, OPERATOR);
    // The slash of a type has no space before it.
    return after_space && finish(lexer, UNEXPECTED);
}

// The name of something in ROS is for the grammar, unless it is not closed, or has a NUL in it,
// which regular expressions do not match.
static bool scan_single_quote(TSLexer *lexer) {
    bool has_nul = false;
    do {
        lexer->advance(lexer, false);
        has_nul |= lexer->lookahead == 0 && !lexer->eof(lexer);
    } while (lexer->lookahead != '\'' && !at_line_end(lexer));
    if (at_line_end(lexer)) return finish(lexer, UNCLOSED_QUOTE);
    lexer->advance(lexer, false);
    return has_nul && finish(lexer, UNEXPECTED);
}

// Goes behind the next double quote of the line, if there is one.
static bool close_double_quote(TSLexer *lexer) {
    while (lexer->lookahead != '"' && !at_line_end(lexer)) {
        const bool escape = lexer->lookahead == '\\';
        lexer->advance(lexer, false);
        if (escape && !at_line_end(lexer)) lexer->advance(lexer, false);
    }
    if (at_line_end(lexer)) return false;
    lexer->advance(lexer, false);
    return true;
}

static bool scan_double_quote(TSLexer *lexer, const bool *valid) {
    lexer->advance(lexer, false);
    if (valid[QUOTE] && !valid[SKIPPING]) return finish(lexer, QUOTE);
    return finish(lexer, close_double_quote(lexer) ? QUOTED : UNCLOSED_QUOTE);
}

// Within a string: its text. A sound escape is for the grammar; from one that is not, the rest of
// the string is one mistake.
static bool scan_string(TSLexer *lexer) {
    bool any = false;
    while (lexer->lookahead != '"' && lexer->lookahead != '\\' && !at_line_end(lexer)) {
        lexer->advance(lexer, false);
        any = true;
    }
    if (any) return finish(lexer, STRING_CONTENT);
    if (lexer->lookahead != '\\') return false;
    lexer->advance(lexer, false);
    switch (lexer->lookahead) {
        case '"': case '\\': case 'n': case 't':
            return false;
        case 'u': {
            unsigned digits = 0;
            do lexer->advance(lexer, false);
            while (is_hexadecimal(lexer->lookahead) && ++digits < 4);
            if (digits == 4) return false;
        }
    }
    close_double_quote(lexer);
    return finish(lexer, UNEXPECTED);
}

static bool scan_unexpected(TSLexer *lexer) {
    if (lexer->lookahead == '+' || lexer->lookahead == '-') {
        // The sign of a number?
        lexer->advance(lexer, false);
        lexer->mark_end(lexer);
        if (is_digit(lexer->lookahead)) return false;
        if (lexer->lookahead == '.') {
            lexer->advance(lexer, false);
            if (is_digit(lexer->lookahead)) return false;
        }
        lexer->result_symbol = UNEXPECTED;
        return true;
    }
    if (lexer->lookahead == '<') {
        // The bound of a field?
        lexer->advance(lexer, false);
        lexer->mark_end(lexer);
        if (lexer->lookahead == '=') return false;
        lexer->result_symbol = UNEXPECTED;
        return true;
    }
    if (is_known(lexer->lookahead)) return false;
    while (!is_known(lexer->lookahead) && !lexer->eof(lexer)) lexer->advance(lexer, false);
    return finish(lexer, UNEXPECTED);
}

// A mark of one character where the grammar asks for it; elsewhere it may begin a number, or nothing.
static bool scan_mark(TSLexer *lexer, enum TokenType type, const bool *valid) {
    if (!valid[type] || valid[SKIPPING]) return scan_unexpected(lexer);
    lexer->advance(lexer, false);
    return finish(lexer, type);
}

bool tree_sitter_plastron_external_scanner_scan(void *payload, TSLexer *lexer, const bool *valid) {
    Scanner *scanner = payload;
    const bool recovering = valid[SKIPPING];
    if (!scanner->has_cut && (recovering || scanner->has_skipped)) {
        // First a token that fits nowhere: the parser skips it too, and remembers that it skips.
        // Then the cut, which fits everywhere: the parser goes back to the statement that it was in,
        // where it asks again, and takes it.
        const bool has_skipped = scanner->has_skipped;
        scanner->has_skipped = true;
        scanner->has_cut = has_skipped;
        if (has_skipped) return finish(lexer, CUT);
        return finish(lexer, scanner->ended_early ? SKIPPING_END : SKIPPING);
    }
    if (valid[STRING_CONTENT] && !recovering) {
        if (!at_line_end(lexer)) return scan_string(lexer);
    }
    bool after_space = false;
    for (; is_space(lexer->lookahead); after_space = true) lexer->advance(lexer, true);
    if (lexer->lookahead == '\n' || lexer->eof(lexer)) return scan_line_end(scanner, lexer, valid);
    switch (lexer->lookahead) {
        case '+': case '-': case '*':
            return scan_mark(lexer, OPERATOR, valid);
        case '<': case '>':
            return scan_mark(lexer, COMPARISON, valid);
        case '/':
            return scan_slash(scanner, lexer, after_space, valid[OPERATOR] && !recovering);
        case '\'':
            return scan_single_quote(lexer);
        case '"':
            return scan_double_quote(lexer, valid);
        default:
            return scan_unexpected(lexer);
    }
}
