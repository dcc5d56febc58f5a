/* Helix compiles the scanner that is beside the parser. */

#include "../../src/scanner.c"
