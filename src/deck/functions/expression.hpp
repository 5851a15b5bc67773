#pragma once
// What the expressions of a deck share, whatever they depend on. Only the sources of this folder see the parser.

#include <muParser.h>

#include <string>

namespace percuss {

/// Functions and constants of an expression: only what docs/deck.md lists, so that it means the same with every version
/// of the library. Variables are defined after them.
void define_functions(mu::Parser& parser);

/// Gives the parser its expression: a pure function of one value, without assignment, text or what else is not
/// arithmetic. Throws std::invalid_argument with the reason.
void set_expression(mu::Parser& parser, const std::string& text);

}  // namespace percuss
