#pragma once
// What the expressions of a deck share, whatever they depend on. Only the sources of this folder see the parser.

#include <muParser.h>

#include <stdexcept>
#include <string>
#include <string_view>

namespace percuss {

/// Functions and constants of an expression: only what docs/deck.md lists, so that it means the same with every version
/// of the library. Variables are defined after them.
void define_functions(mu::Parser& parser);

/// An expression is a pure function: no assignment, no text, nothing that is not arithmetic. Throws
/// std::invalid_argument with the reason.
void check_expression(std::string_view text);

/// The parser's own message, without ends of lines.
std::invalid_argument make_parser_error(const mu::Parser::exception_type& error);

}  // namespace percuss
